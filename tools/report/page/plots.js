// Time against error, one plot per scene, both axes logarithmic.
const COLOURS = ["#56b4e9", "#009e73", "#e69f00", "#d55e00", "#cc79a7", "#8a7fd1", "#7f7f7f"];
const SHAPES = [r => `M${-r},0A${r},${r} 0 1 0 ${r},0A${r},${r} 0 1 0 ${-r},0Z`, r => `M${-r},${-r}H${r}V${r}H${-r}Z`,
  r => `M0,${-1.2 * r}L${1.15 * r},${r}H${-1.15 * r}Z`, r => `M0,${-1.35 * r}L${1.35 * r},0L0,${1.35 * r}L${-1.35 * r},0Z`,
  r => `M0,${1.2 * r}L${1.15 * r},${-r}H${-1.15 * r}Z`, r => `M${-r},${-r / 3}H${-r / 3}V${-r}H${r / 3}V${-r / 3}H${r}V${r / 3}H${r / 3}V${r}H${-r / 3}V${r / 3}H${-r}Z`];
const TIMES = [["light", "voxels, irradiance and cones", "time of voxels, irradiance and cones"], ["total", "whole frame", "time of a frame"],
  ["trace", "cones alone", "time of the cones"]];
const BOX = {width: 400, height: 290, left: 58, right: 14, top: 10, bottom: 42};

function ticks(low, high) {
  const found = [];
  for (let power = Math.floor(Math.log10(low)); power <= Math.ceil(Math.log10(high)); power++)
    for (const digit of high / low > 50 ? [1] : high / low > 8 ? [1, 3] : [1, 2, 3, 5, 7])
      if (digit * 10 ** power >= low * 0.999 && digit * 10 ** power <= high * 1.001) found.push(digit * 10 ** power);
  return found;
}
const tickText = value => value >= 0.001 && value < 100000 ? String(Number(value.toPrecision(2))) : number(value).replace("1.0·", "").replace(".0·", "·");

function range(values) {
  const positive = values.filter(value => value > 0);
  if (!positive.length) return [1e-3, 1];
  let [low, high] = [Math.min(...positive) / 1.35, Math.max(...positive) * 1.35];
  if (high / low < 4) { const middle = Math.sqrt(low * high); low = middle / 2; high = middle * 2; }
  return [low, high];
}

function plotPoints(scene, choice) {
  const mode = measureOf(choice.measure).mode;
  return done.filter(point => point.scene === scene && point.modes[mode] && errorOf(point, choice.measure)
    && typeof errorOf(point, choice.measure)[choice.metric] === "number").map(point => ({point, mode,
      time: point.modes[mode][choice.time][0], error: Math.abs(errorOf(point, choice.measure)[choice.metric])}));
}
// Of each, whether nothing else is as fast and as near, and better in one of the two.
function paretoFront(dots) {
  return dots.filter(a => !dots.some(b => b !== a && b.time <= a.time && b.error <= a.error
    && (b.time < a.time || b.error < a.error))).sort((a, b) => a.time - b.time);
}
const rank = (name, value) => Math.max(0, settingOf(name).values.indexOf(value));

function drawPlot(scene, choice) {
  const dots = plotPoints(scene, choice);
  const figure = make("figure", {class: "plot", "data-scene": scene}, make("figcaption", {}, scene));
  if (!dots.length) { figure.append(make("p", {class: "note"}, "Nothing measured.")); return figure; }
  const floor = choice.metric === "relmse" ? errorOf(dots[0].point, choice.measure).noise_relmse : null;
  const [x0, x1] = range(dots.map(dot => dot.time));
  const lowest = Math.min(...dots.map(dot => dot.error));
  // Far below every point it would only flatten the plot: then it is said, not drawn.
  const near = floor && floor > lowest / 12;
  const [y0, y1] = range([...dots.map(dot => dot.error), ...(near ? [floor] : [])]);
  const x = value => BOX.left + Math.log(value / x0) / Math.log(x1 / x0) * (BOX.width - BOX.left - BOX.right);
  const y = value => BOX.height - BOX.bottom - (value > 0 ? Math.log(value / y0) / Math.log(y1 / y0) : 0)
    * (BOX.height - BOX.top - BOX.bottom);
  const svg = make("svg", {viewBox: `0 0 ${BOX.width} ${BOX.height}`, role: "group",
    "aria-label": `${scene}: time against ${metricOf(choice.metric).label}, ${dots.length} points`});
  for (const value of ticks(x0, x1)) svg.append(make("line", {class: "grid", x1: x(value), x2: x(value), y1: BOX.top,
    y2: BOX.height - BOX.bottom}), make("text", {x: x(value), y: BOX.height - BOX.bottom + 15, "text-anchor": "middle"}, tickText(value)));
  for (const value of ticks(y0, y1)) svg.append(make("line", {class: "grid", x1: BOX.left, x2: BOX.width - BOX.right, y1: y(value),
    y2: y(value)}), make("text", {x: BOX.left - 6, y: y(value) + 4, "text-anchor": "end"}, tickText(value)));
  const middle = (BOX.height - BOX.bottom + BOX.top) / 2;
  svg.append(make("text", {class: "axis-name", x: (BOX.width + BOX.left) / 2, y: BOX.height - 6, "text-anchor": "middle"},
    `${TIMES.find(([name]) => name === choice.time)[2]}, ms`),
    make("text", {class: "axis-name", x: 12, y: middle, "text-anchor": "middle", transform: `rotate(-90 12 ${middle})`},
      metricOf(choice.metric).axis));
  if (floor && !near) svg.append(make("text", {class: "floor-name", x: BOX.width - BOX.right - 3, y: BOX.height - BOX.bottom - 5,
    "text-anchor": "end"}, `the reference's noise: ${number(floor)}, below`));
  if (near) svg.append(make("line", {class: "floor-line", x1: BOX.left, x2: BOX.width - BOX.right, y1: y(floor), y2: y(floor)}),
    make("text", {class: "floor-name", x: BOX.width - BOX.right - 3, y: y(floor) - 4, "text-anchor": "end"}, "the reference's noise"));
  const front = paretoFront(dots);
  svg.append(make("path", {class: "front", d: front.map((dot, i) => i === 0 ? `M${x(dot.time)},${y(dot.error)}`
    : `H${x(dot.time)}V${y(dot.error)}`).join("")}));
  const shapes = settingsFor(measureOf(choice.measure).mode).some(setting => setting.name === choice.shape);
  for (const dot of dots) {
    const at = `translate(${x(dot.time)} ${y(dot.error)})`;
    const {settings, key} = dot.point;
    const tip = tipText(dot, choice, front.includes(dot));
    svg.append(make("path", {class: "dot", d: SHAPES[shapes ? rank(choice.shape, settings[choice.shape]) % SHAPES.length : 0](5.5), transform: at,
      fill: COLOURS[rank(choice.colour, settings[choice.colour]) % COLOURS.length], tabindex: 0, role: "button", "aria-label": tip,
      "data-key": key, onmouseenter: event => showTip(event.target, tip), onfocus: event => showTip(event.target, tip),
      onmouseleave: hideTip, onblur: hideTip, onclick: () => openPoint(dot.point, choice.measure),
      onkeydown: event => { if (event.key === "Enter" || event.key === " ") { event.preventDefault(); openPoint(dot.point, choice.measure); } }}));
    if (front.includes(dot)) svg.append(make("circle", {class: "ring", r: 9.5, transform: at}));
    if (key === state.key) svg.append(make("circle", {class: "chosen", r: 13, transform: at}));
  }
  figure.append(svg);
  return figure;
}

function tipText(dot, choice, onFront) {
  const error = errorOf(dot.point, choice.measure);
  const [median, low, high] = dot.point.modes[dot.mode][choice.time];
  return `${dot.point.scene}, ${configText(dot.point, dot.mode)}\n${number(median)} ms (${number(low)} to ${number(high)})\n`
    + `${metricOf(choice.metric).label} ${metricText(error, choice.metric)}` + (choice.metric !== "bias" ? `, bias ${percent(error.bias)}` : "")
    + (onFront ? "\non the Pareto front" : "");
}
function showTip(target, text) {
  const tip = $("tip"), box = target.getBoundingClientRect();
  tip.textContent = text;
  tip.hidden = false;
  const left = Math.min(box.left + 14, document.documentElement.clientWidth - tip.offsetWidth - 8);
  tip.style.left = `${Math.max(8, left) + window.scrollX}px`;
  tip.style.top = `${box.top + window.scrollY - tip.offsetHeight - 8}px`;
}
function hideTip() { $("tip").hidden = true; }
function openPoint(point, measure) {
  hideTip();
  choose({scene: point.scene, measure, key: point.key});
  $("pictures").scrollIntoView();
}

function plotChoice() {
  return {measure: $("plot-measure").value, metric: $("plot-metric").value, time: $("plot-time").value,
    colour: $("plot-colour").value, shape: $("plot-shape").value};
}
function legendOf(choice) {
  const entries = (name, draw) => settingOf(name).values.map((value, i) => make("span", {},
    make("svg", {width: 16, height: 16, viewBox: "-8 -8 16 16", "aria-hidden": "true"}, draw(i)), settingText(name, value)));
  const grey = i => make("path", {d: SHAPES[i % SHAPES.length](5.5), fill: "#888"});
  const colour = i => make("path", {d: SHAPES[0](5.5), fill: COLOURS[i % COLOURS.length]});
  const felt = settingOf(choice.shape).values.length > 1 && settingsFor(measureOf(choice.measure).mode).includes(settingOf(choice.shape));
  return [make("strong", {}, settingOf(choice.colour).label), ...entries(choice.colour, colour),
    ...(felt ? [make("strong", {}, settingOf(choice.shape).label), ...entries(choice.shape, grey)] : [])];
}
function drawPlots() {
  if (!state.measure) return;
  const choice = plotChoice();
  $("plot-what").textContent = `${sentence(measureOf(choice.measure).what)} `
    + metricOf(choice.metric).what;
  $("plot-legend").replaceChildren(...legendOf(choice));
  $("plot-grid").replaceChildren(...sceneNames.map(scene => drawPlot(scene, choice)));
}
function startPlots() {
  const varied = DATA.settings.filter(setting => setting.values.length > 1);
  const names = (varied.length ? varied : [settingOf("grid")]).map(setting => [setting.name, setting.label]);
  const measures = DATA.measures.filter(measure => done.some(point => errorOf(point, measure.name)));
  fillSelect($("plot-measure"), measures.map(measure => [measure.name, measure.name]), state.measure);
  fillSelect($("plot-metric"), DATA.metrics.map(metric => [metric.name, metric.label]), "relmse");
  fillSelect($("plot-time"), TIMES, TIMES[0][0]);
  const first = wanted => (wanted.map(name => names.find(([varies]) => varies === name)).find(Boolean) || names[0])[0];
  fillSelect($("plot-colour"), names, first(["preset", "grid"]));
  fillSelect($("plot-shape"), names, first($("plot-colour").value === "preset" ? ["grid"] : ["cone_angle_deg"]));
  for (const id of ["measure", "metric", "time", "colour", "shape"]) $(`plot-${id}`).addEventListener("change", drawPlots);
  if (!measures.length) $("plot-what").textContent = "Nothing was measured against a reference.";
  listeners.push(() => drawPlots());
  drawPlots();
}
