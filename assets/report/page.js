// The page: puts the data into it, and draws again when what is shown changes. Text goes in as text, never as HTML.
"use strict";

const data = JSON.parse(document.getElementById("data").textContent);
const byId = new Map(data.points.map(point => [point.id, point]));
const shown = { quantity: "flip", view: 0, logarithmic: false, pictured: 0 }; // view 0 is the mean
const $ = id => document.getElementById(id);

function make(tag, text, ...children) {
  const element = document.createElement(tag);
  if (text !== undefined && text !== null) element.textContent = text;
  element.append(...children);
  return element;
}

const quantityOf = name => data.quantities.find(quantity => quantity.name === name);
const measured = (point, view = shown.view) => (view === 0 ? point.mean : point.views[view - 1]);
const errorOf = (point, name = shown.quantity, view = shown.view) => measured(point, view).errors[name];
const msOf = (point, view = shown.view) => measured(point, view).cost.median_ms;
const frontPoints = (name = shown.quantity, view = shown.view) => data.fronts[name][view].map(id => byId.get(id));
const changesOf = point => Object.entries(point.changes).map(([key, value]) => key + " = " + value);

// Presets by name, each once, with the base first where it is none of them.
const presetNames = new Map();
for (const preset of data.presets)
  presetNames.set(preset.point, [...(presetNames.get(preset.point) ?? []), preset.name]);
const marked = [...presetNames].map(([id, names]) => ({ point: byId.get(id), name: names.join(", ") }));
if (!presetNames.has(data.points[0].id)) marked.unshift({ point: data.points[0], name: "base" });

function fact(list, name, value) {
  if (value) list.append(make("div", null, make("dt", name), make("dd", value)));
}

function fillHead() {
  $("title").textContent = data.title;
  const plural = (count, word) => count + " " + word + (count === 1 ? "" : "s");
  fact($("facts"), "Machine", data.machines.join("; "));
  fact($("facts"), "Date", data.date);
  fact($("facts"), "Picture", data.about.size);
  fact($("facts"), "Measured", plural(data.points.length, "setting") + " in " + plural(data.views.length, "view") +
    (data.times.length > 1 ? " at " + plural(data.times.length, "moment") : ""));
  const provenance = $("provenance");
  fact(provenance, "Command", data.command);
  fact(provenance, "Machine", data.machines.join("; "));
  fact(provenance, "Views", data.views.join(", "));
  fact(provenance, "Times", data.times.map(time => time + " s").join(", "));
  for (const [name, value] of Object.entries(data.about))
    if (name !== "base") fact(provenance, name[0].toUpperCase() + name.slice(1), value);
  $("base").textContent = Object.entries(data.base).map(([key, value]) => key + " = " + value).join("\n");
}

// The one sentence to take home.
function fillGist() {
  const front = frontPoints("flip", 0);
  if (front.length === 0) return $("gist").remove();
  const cheap = front[0], best = front[front.length - 1];
  let text = "From " + short(msOf(cheap, 0)) + " ms a frame with mean FLIP " + short(errorOf(cheap, "flip", 0)) + " to " +
    short(msOf(best, 0)) + " ms with " + short(errorOf(best, "flip", 0)) + ": that is the choice on this machine.";
  const thesis = marked.find(mark => mark.name.split(", ").includes("thesis"))?.point;
  const better = thesis && front.filter(point => errorOf(point, "flip", 0) <= errorOf(thesis, "flip", 0))[0];
  if (better && better !== thesis)
    text += " The published settings cost " + short(msOf(thesis, 0)) + " ms with " + short(errorOf(thesis, "flip", 0)) +
      "; the same accuracy is to be had for " + short(msOf(better, 0)) + " ms.";
  $("gist").textContent = text;
}

function fillSelectors() {
  const hasValues = name => data.points.some(point => errorOf(point, name, 0) !== null);
  for (const quantity of data.quantities) {
    if (!hasValues(quantity.name)) continue;
    const option = make("option", quantity.doc);
    option.value = quantity.name;
    $("quantity").append(option);
  }
  const first = hasValues("flip") ? "flip" : $("quantity").options[0]?.value ?? "flip";
  $("quantity").value = shown.quantity = first;
  ["mean of all views", ...data.views].forEach((name, i) => $("view").append(new Option(name, i)));
  for (const [i, entry] of data.pictures.points.entries()) {
    const mark = marked.find(other => other.point.id === entry.point);
    $("pictured").append(new Option(mark?.name ?? byId.get(entry.point).label, i));
  }
  const listen = (id, change) => $(id).addEventListener("change", event => { change(event.target); redraw(); });
  listen("quantity", target => { shown.quantity = target.value; });
  listen("view", target => { shown.view = Number(target.value); });
  listen("logarithmic", target => { shown.logarithmic = target.checked; });
  $("pictured").addEventListener("change", event => { shown.pictured = Number(event.target.value); fillPictures(); });
}

function plotPoint(point, name) {
  const quantity = quantityOf(shown.quantity);
  const figures = ["flip", "flip.water", "refraction.median", "caustics.rmse"].filter(other => other !== shown.quantity);
  const changes = changesOf(point);
  const hidden = changes.length - 12;
  return {
    id: point.id, x: msOf(point), y: errorOf(point), tag: name, title: name ?? point.label,
    lines: [short(msOf(point)) + " ms a frame", quantity.name + ": " + withUnit(errorOf(point), quantity.unit),
      ...figures.filter(other => errorOf(point, other) !== null)
        .map(other => other + ": " + withUnit(errorOf(point, other), quantityOf(other).unit)),
      ...changes.slice(0, 12), ...(hidden > 0 ? ["and " + hidden + " more"] : [])],
  };
}

function redrawOverall() {
  const quantity = quantityOf(shown.quantity);
  const front = frontPoints();
  const isMeasured = point => msOf(point) !== null && errorOf(point) !== null;
  $("quantity-doc").textContent = quantity.doc + (quantity.name === "caustics.energy" ? "; 1 is right."
    : quantity.smaller_is_better ? "; less is better." : "; more is better.");
  drawOverall($("overall"), {
    points: data.points.filter(point => isMeasured(point) && !front.includes(point)).map(point => plotPoint(point)),
    front: front.map(point => plotPoint(point)),
    marked: marked.filter(mark => isMeasured(mark.point)).map(mark => plotPoint(mark.point, mark.name)),
    xTitle: "ms a frame (median)",
    yTitle: quantity.name + (quantity.unit ? ", " + quantity.unit : ""),
    logarithmic: shown.logarithmic,
  });
  const head = make("tr", null, make("th", "Settings"), make("th", "ms"), make("th", quantity.name), make("th", "Changes from the base"));
  head.lastChild.className = "text";
  const rows = front.map(point => {
    const changes = make("td", changesOf(point).join(", ") || "none");
    changes.className = "text";
    const name = marked.find(mark => mark.point === point)?.name ?? (point.origin === "sweep" ? "one option" : point.label);
    return make("tr", null, make("td", name), make("td", short(msOf(point))), make("td", short(errorOf(point))), changes);
  });
  $("front").replaceChildren(make("thead", null, head), make("tbody", null, ...rows));
}

function redrawSweeps() {
  const quantity = quantityOf(shown.quantity);
  for (const sweep of data.sweeps) {
    const points = sweep.points.map(id => byId.get(id));
    drawSweep($("sweep " + sweep.key), {
      labels: sweep.values, errors: points.map(point => errorOf(point)), costs: points.map(point => msOf(point)),
      base: sweep.points.indexOf(data.points[0].id), errorTitle: quantity.name, unit: quantity.unit,
    });
  }
}

function makeSweeps() {
  if (data.sweeps.length === 0) return $("sweep-section").remove();
  for (const sweep of data.sweeps) {
    const canvas = make("canvas");
    canvas.id = "sweep " + sweep.key;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", "Error and cost over " + sweep.key);
    const frame = make("div", null, canvas);
    frame.className = "canvas";
    $("sweeps").append(make("figure", null, make("figcaption", sweep.key), frame));
  }
}

function redrawPasses() {
  const names = [];
  for (const mark of marked)
    for (const pass of measured(mark.point).cost.passes) if (!names.includes(pass.name)) names.push(pass.name);
  if (names.length === 0) return;
  const time = (mark, name) => measured(mark.point).cost.passes.find(pass => pass.name === name)?.median_ms ?? 0;
  $("passes-plot").style.height = 130 + 44 * marked.length + "px";
  drawPasses($("passes"), {
    labels: marked.map(mark => mark.name),
    passes: names.map(name => ({ name, data: marked.map(mark => time(mark, name)) })),
  });
}

const presetColumns = ["flip", "flip.water", "refraction.median", "refraction.p95", "refraction.wrong_5cm",
  "reflection.median", "fresnel.mean", "path.median", "caustics.rmse", "psnr"];

function redrawPresets() {
  const columns = [
    { name: "ms", unit: "median", value: point => msOf(point), smaller: true },
    { name: "ms", unit: "95 %", value: point => measured(point).cost.p95_ms, smaller: true },
    { name: "cpu ms", unit: "all threads", value: point => measured(point).cost.cpu_ms, smaller: true },
    ...presetColumns.map(quantityOf).filter(quantity => marked.some(mark => errorOf(mark.point, quantity.name) !== null))
      .map(quantity => ({ name: quantity.name.replaceAll(".", " ").replaceAll("_", " "), unit: quantity.unit === "deg" ? "°" : quantity.unit, doc: quantity.doc,
        value: point => errorOf(point, quantity.name), smaller: quantity.smaller_is_better })),
  ];
  const head = make("tr", null, make("th", "Preset"));
  for (const column of columns) {
    const unit = make("span", column.unit || "\u00a0");
    unit.className = "unit";
    const cell = make("th", column.name, unit);
    if (column.doc) cell.title = column.doc;
    const values = marked.map(mark => column.value(mark.point)).filter(value => value !== null);
    column.best = column.smaller ? Math.min(...values) : Math.max(...values);
    head.append(cell);
  }
  const rows = marked.map(mark => {
    const row = make("tr", null, make("td", mark.name));
    if (mark.name.split(", ").includes("thesis")) row.className = "thesis";
    for (const column of columns) {
      const value = column.value(mark.point);
      const cell = make("td", short(value));
      if (value !== null && value === column.best) cell.className = "best";
      row.append(cell);
    }
    return row;
  });
  $("presets").replaceChildren(make("thead", null, head), make("tbody", null, ...rows));
}

function image(url, text, style) {
  const element = make("img");
  Object.assign(element, { src: url, alt: text, className: style, draggable: false });
  return element;
}

function tag(text, side) {
  const element = make("span", text);
  element.className = "tag " + side;
  return element;
}

function comparison(realTime, reference, view) {
  const box = make("div", null, image(reference, view + ", reference", "under"), image(realTime, view + ", real time", "over"));
  box.className = "compare";
  const handle = make("div");
  handle.className = "handle";
  const slider = make("input");
  Object.assign(slider, { type: "range", min: 0, max: 100, step: 0.1, value: 50 });
  slider.setAttribute("aria-label", view + ": how much of the real-time picture is shown");
  const move = at => { slider.value = at; box.style.setProperty("--at", slider.value + "%"); };
  slider.addEventListener("input", () => move(slider.value));
  // A range's thumb does not quite follow the pointer at its ends.
  const follow = event => {
    const { left, width } = box.getBoundingClientRect();
    if (event.buttons & 1) move(100 * (event.clientX - left) / width);
  };
  box.addEventListener("pointerdown", follow);
  box.addEventListener("pointermove", follow);
  box.append(handle, tag("real time", "left"), tag("reference", "right"), slider);
  return box;
}

function fillPictures() {
  const entry = data.pictures.points[shown.pictured];
  const isThere = view => entry?.real_time[view] && data.pictures.references[view];
  if (!data.views.some((_, view) => isThere(view))) return $("picture-section").remove();
  $("pictures").replaceChildren(...data.views.map((name, view) => {
    if (!isThere(view)) return "";
    const point = byId.get(entry.point);
    const caption = make("figcaption", name, make("span", "FLIP " + short(errorOf(point, "flip", view + 1)) + " · " +
      short(msOf(point, view + 1)) + " ms"));
    const heat = make("div", null, image(entry.flip[view], name + ", FLIP", ""), tag("FLIP", "left"));
    heat.className = "heat";
    const figure = make("figure", null, caption, comparison(entry.real_time[view], data.pictures.references[view], name), heat);
    figure.className = "triple";
    return figure;
  }));
}

// The chosen view's budget, or the mean of all that there are.
function budgetShown() {
  const budgets = (shown.view === 0 ? data.budgets : [data.budgets[shown.view - 1]]).filter(Boolean);
  if (budgets.length === 0) return null;
  const mean = all => { // null where there is nothing to measure
    const values = all.filter(value => typeof value === "number");
    return values.length === 0 ? null : values.reduce((sum, value) => sum + value, 0) / values.length;
  };
  const whole = what => mean(budgets.map(budget => budget[what]));
  const parts = [...new Set(budgets.flatMap(budget => budget.rows.map(row => row.part)))];
  const of = (part, what) => mean(budgets.map(budget => budget.rows.find(row => row.part === part)?.[what]));
  return {
    quantity: budgets[0].quantity,
    total: whole("total"), together: whole("together"), remaining: whole("remaining"), noise: whole("noise"),
    unmodelled: whole("unmodelled"),
    rows: parts.map(part => ({
      part, alone: of(part, "alone"), removed: of(part, "removed"),
      exact: budgets.flatMap(budget => budget.rows).find(row => row.part === part)?.exact,
    })),
  };
}

function redrawBudget() {
  if (!data.budgets.some(Boolean)) return $("budget-section")?.remove();
  const budget = budgetShown();
  if (!budget) return $("budget").replaceChildren(make("tbody", null, make("tr", null, make("td", "Not measured in this view."))));
  budget.rows.sort((a, b) => b.removed - a.removed);
  const largest = Math.max(...budget.rows.map(row => Math.max(row.removed, row.alone)), budget.total, 1e-12);
  const line = (part, alone, removed, style, exact) => {
    const bar = make("td", null, make("span"));
    bar.className = "bar";
    bar.firstChild.style.width = Math.max(0, 100 * removed / largest) + "%";
    const row = make("tr", null, make("td", part), make("td", short(alone)), make("td", short(removed)), bar);
    row.className = style;
    if (exact) row.title = "exact: " + exact;
    return row;
  };
  const sum = what => budget.rows.reduce((total, row) => total + (row[what] ?? 0), 0);
  const fall = budget.remaining === null ? null : budget.total - budget.remaining;
  const head = make("tr", null, make("th", "Part"), make("th", "alone"), make("th", "taken out"), make("th", budget.quantity));
  $("budget").replaceChildren(make("thead", null, head), make("tbody", null,
    ...budget.rows.map(row => line(row.part, row.alone, row.removed, "", row.exact)),
    line("Sum of the parts", sum("alone"), sum("removed"), "sum"),
    line("All at once", budget.together, fall, ""),
    line("Error of the frame", null, budget.total, ""),
    line("Unexplained: all of them taken out", null, budget.remaining, ""),
    ...(budget.noise === null ? [] : [line("Noise of the reference", null, budget.noise, "")]),
    ...(budget.unmodelled === null ? [] : [line("Light between surfaces, in neither picture", budget.unmodelled, null, "")])));
}

function redraw() {
  redrawOverall();
  redrawSweeps();
  redrawPasses();
  redrawPresets();
  redrawBudget();
}

try {
  fillHead();
  fillSelectors();
  fillGist();
  makeSweeps();
  redraw();
  fillPictures();
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
  document.documentElement.dataset.plots = plots.size;
  document.documentElement.dataset.overflow = Math.max(0, document.documentElement.scrollWidth - innerWidth);
} catch (error) {
  document.documentElement.dataset.error = error.message;
  $("failure").hidden = false;
  $("failure").textContent = "This page could not be drawn: " + error.message;
}
