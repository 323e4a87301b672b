// The plots: what Chart.js is told. Knows the data, not the page.
"use strict";

const plots = new Map(); // canvas -> Chart

function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
}

// Three digits: 0.0123, 1.23, 123.
function short(value) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 100) return value.toFixed(0);
  if (size >= 0.001) return String(Number(value.toPrecision(3)));
  return value.toExponential(1);
}

function withUnit(value, unit) {
  return value === null || !unit ? short(value) : short(value) + " " + (unit === "deg" ? "°" : unit);
}

function draw(canvas, config) {
  plots.get(canvas)?.destroy();
  config.options = { animation: false, maintainAspectRatio: false, responsive: true, ...config.options };
  Chart.defaults.color = colour("soft");
  Chart.defaults.borderColor = colour("line");
  Chart.defaults.font.family = getComputedStyle(document.body).fontFamily;
  plots.set(canvas, new Chart(canvas, config));
}

function axis(title, extra) {
  return { title: { display: Boolean(title), text: title }, ticks: { callback: short, maxTicksLimit: 7 }, ...extra };
}

// Names beside the marked points, where they cover neither each other nor another mark.
const nameTags = {
  id: "nameTags",
  afterDatasetsDraw(chart) {
    const { ctx, chartArea } = chart;
    const taken = [];
    ctx.save();
    ctx.font = "600 13px " + Chart.defaults.font.family;
    ctx.textBaseline = "middle";
    chart.data.datasets.forEach((set, index) => {
      if (!set.tags || !chart.isDatasetVisible(index)) return;
      for (const { x, y } of chart.getDatasetMeta(index).data) taken.push({ left: x - 8, right: x + 8, y });
      chart.getDatasetMeta(index).data.forEach((element, i) => {
        const text = set.data[i].tag;
        const width = ctx.measureText(text).width;
        const places = [[10, 0], [-width - 10, 0], [-width / 2, -16], [-width / 2, 17], [10, -15], [10, 16], [10, 32]];
        const fits = ([dx, dy]) => {
          const box = { left: element.x + dx, right: element.x + dx + width, y: element.y + dy };
          return box.left > chartArea.left && box.right < chartArea.right && box.y > chartArea.top + 8 &&
            box.y < chartArea.bottom - 8 &&
            !taken.some(t => t.left < box.right && box.left < t.right && Math.abs(t.y - box.y) < 15);
        };
        const [dx, dy] = places.find(fits) ?? places[0];
        taken.push({ left: element.x + dx, right: element.x + dx + width, y: element.y + dy });
        ctx.lineWidth = 4;
        ctx.strokeStyle = colour("card");
        ctx.strokeText(text, element.x + dx, element.y + dy);
        ctx.fillStyle = colour("ink");
        ctx.fillText(text, element.x + dx, element.y + dy);
      });
    });
    ctx.restore();
  },
};

// marked: [{tag, point}], front: points; each point: {x, y, title, lines}
function drawOverall(canvas, { points, front, marked, xTitle, yTitle, logarithmic }) {
  const type = logarithmic ? "logarithmic" : "linear";
  draw(canvas, {
    type: "scatter",
    plugins: [nameTags],
    data: {
      datasets: [
        { label: "presets, thesis and base", data: marked, tags: true, pointStyle: "rectRot", pointRadius: 8,
          pointHoverRadius: 10, backgroundColor: colour("mark"), borderColor: colour("card"), borderWidth: 1.5 },
        { label: "Pareto front", data: front, showLine: true, borderColor: colour("front"), borderWidth: 2,
          backgroundColor: colour("front"), pointRadius: 4, pointHoverRadius: 7, tension: 0 },
        { label: "other settings", data: points, backgroundColor: colour("dot"), pointRadius: 3.5, pointHoverRadius: 6 },
      ],
    },
    options: {
      interaction: { mode: "nearest", intersect: true },
      scales: { x: axis(xTitle, { type }), y: axis(yTitle, { type }) },
      plugins: {
        legend: { position: "bottom", labels: { usePointStyle: true, boxHeight: 7 } },
        tooltip: {
          filter: (item, at, items) => items.findIndex(o => o.raw.id === item.raw.id) === at,
          callbacks: { title: items => items[0]?.raw.title, label: item => item.raw.lines },
        },
      },
    },
  });
}

// At least a fifth of the largest value, so that chance does not look like an effect. Of what is added to it, `below`
// goes under the values: two flat lines in one plot do not cover each other.
function range(values, below) {
  const known = values.filter(value => value !== null);
  if (known.length === 0) return {};
  const low = Math.min(...known), high = Math.max(...known);
  const least = 0.2 * Math.max(Math.abs(low), Math.abs(high)) || 1;
  const added = Math.max(0.16 * (high - low), least - (high - low));
  const min = low - below * added;
  return { min: low >= 0 ? Math.max(0, min) : min, max: high + (1 - below) * added };
}

function drawSweep(canvas, { labels, errors, costs, base, errorTitle, unit }) {
  const isNumeric = labels.every(label => label !== "" && !Number.isNaN(Number(label)));
  const ring = size => labels.map((_, i) => (i === base ? size + 3 : size));
  const line = (data, name, axisId, style) => ({
    data, label: name, yAxisID: axisId, borderColor: colour(style), backgroundColor: colour(style), borderWidth: 2,
    pointRadius: ring(3), pointHoverRadius: 7, pointBackgroundColor: labels.map((_, i) => colour(i === base ? "card" : style)),
    pointBorderWidth: 2,
    pointStyle: style === "cost" ? "rect" : "circle", borderDash: style === "cost" ? [5, 4] : [], spanGaps: true, showLine: isNumeric,
  });
  draw(canvas, {
    type: "line",
    data: { labels, datasets: [line(errors, errorTitle, "error", "error"), line(costs, "ms a frame", "cost", "cost")] },
    options: {
      interaction: { mode: "index", intersect: false },
      layout: { padding: { top: 8 } },
      scales: {
        x: { grid: { display: false }, offset: !isNumeric },
        error: axis("", { position: "left", ...range(errors, 0.6), ticks: { includeBounds: false, callback: short, maxTicksLimit: 5, color: colour("error") } }),
        cost: axis("", { position: "right", ...range(costs, 0.4), grid: { drawOnChartArea: false },
          ticks: { includeBounds: false, callback: value => short(value) + " ms", maxTicksLimit: 5, color: colour("cost") } }),
      },
      plugins: {
        legend: { display: false },
        tooltip: { callbacks: { label: item => item.dataset.yAxisID === "cost" ? short(item.raw) + " ms a frame"
          : errorTitle + ": " + withUnit(item.raw, unit) } },
      },
    },
  });
}

const passColours = ["#0b6e79", "#e0913a", "#7a5ea8", "#5b9a4a", "#c2504f", "#3f7fc1", "#b7a33c", "#8c6d56", "#5fb3a3", "#98a2a6"];

function drawPasses(canvas, { labels, passes }) {
  draw(canvas, {
    type: "bar",
    data: {
      labels,
      datasets: passes.map((pass, i) => ({ label: pass.name, data: pass.data, backgroundColor: passColours[i % passColours.length],
        maxBarThickness: 34 })),
    },
    options: {
      indexAxis: "y",
      scales: { x: axis("ms", { stacked: true }), y: { stacked: true, grid: { display: false } } },
      plugins: {
        legend: { position: "bottom", labels: { boxWidth: 12, boxHeight: 12 } },
        tooltip: { callbacks: { label: item => item.dataset.label + ": " + short(item.raw) + " ms" } },
      },
    },
  });
}
