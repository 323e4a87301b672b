// The page of tools/growth: a table of exponents, and a plot of each axis. plots.js draws.
"use strict";

const data = JSON.parse(document.getElementById("data").textContent);
const hues = ["error", "cost", "dot", "soft"];

function element(name, text, parent) {
  const made = document.createElement(name);
  if (text !== null) made.textContent = text;
  parent.append(made);
  return made;
}

function showFacts() {
  for (const [name, value] of Object.entries(data.machine)) {
    if (name === "scene" || name === "camera" || name === "size") continue;
    const fact = element("div", null, document.getElementById("facts"));
    element("dt", name, fact);
    element("dd", value, fact);
  }
}

function showExponents() {
  const table = document.getElementById("exponents");
  const head = element("tr", null, element("thead", null, table));
  for (const name of ["What grows", "Camera", "Setting", "From", "To", "ms", "ms", "Factor", "Exponent", "Of the last step", "Of memory"])
    element("th", name, head);
  const body = element("tbody", null, table);
  for (const curve of data.curves) {
    if (curve.factor === undefined) continue;
    const row = element("tr", null, body);
    for (const value of [curve.things, curve.camera, curve.setting, curve.values[0], curve.values.at(-1)]) element("td", value, row);
    for (const value of [curve.wall_ms[0], curve.wall_ms.at(-1), curve.factor, curve.exponent, curve.last_exponent, curve.memory_exponent])
      element("td", short(value), row);
  }
}

// Times growth in proportion, through the first point.
function proportional(curve, values) {
  return curve.sizes.map((size) => ({ x: size, y: (values[0] * size) / curve.sizes[0] }));
}

function plotAxis(axis, quantity, unit, parent) {
  const curves = data.curves.filter((curve) => curve.axis === axis && curve[quantity].length > 1);
  if (curves.length === 0) return;
  const scale = unit === "MiB" ? 2 ** -20 : 1;
  const values = (curve) => curve[quantity].map((value) => value * scale);
  const figure = element("figure", null, parent);
  element("figcaption", curves[0].things, figure);
  const frame = element("div", null, figure);
  frame.className = "canvas";
  const datasets = curves.map((curve, i) => ({
    label: curve.camera + (curve.setting === "own" ? "" : ", " + curve.setting),
    data: values(curve).map((value, k) => ({ x: curve.sizes[k], y: value })),
    borderColor: colour(hues[i % hues.length]),
    backgroundColor: colour(hues[i % hues.length]),
    borderWidth: 2,
    pointRadius: 3,
  }));
  const most = Math.max(...curves.flatMap(values)), least = Math.min(...curves.flatMap(values));
  const line = proportional(curves[0], values(curves[0]));
  datasets.push({ label: "exponent 1", data: line, borderColor: colour("faint"), borderWidth: 1, pointRadius: 0 });
  draw(element("canvas", null, frame), {
    type: "line",
    data: { datasets },
    options: {
      scales: {
        x: axisOf("", "logarithmic"),
        y: { ...axisOf(unit, "logarithmic"), min: 0.7 * least, max: 1.4 * most },
      },
      plugins: { legend: { labels: { boxWidth: 10, boxHeight: 2, font: { size: 11 } } } },
    },
  });
}

function axisOf(title, type) {
  return axis(title, { type });
}

function showPage() {
  showFacts();
  showExponents();
  for (const name of new Set(data.curves.map((curve) => curve.axis))) {
    plotAxis(name, "wall_ms", "ms", document.getElementById("times"));
    plotAxis(name, "peak_bytes", "MiB", document.getElementById("memory"));
  }
  document.body.dataset.plots = String(plots.size);
}

try {
  showPage();
} catch (error) {
  const failure = document.getElementById("failure");
  failure.hidden = false;
  failure.textContent = error.message;
  document.body.dataset.error = error.message;
}
