// The data of the page, and small helpers that the other parts share.
const DATA = JSON.parse(document.getElementById("data").textContent);
const SVG = "http://www.w3.org/2000/svg";
const $ = id => document.getElementById(id);

function make(tag, attributes = {}, ...children) {
  const svg = ["svg", "g", "path", "line", "text", "circle", "title"].includes(tag);
  const node = svg ? document.createElementNS(SVG, tag) : document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) node.addEventListener(name.slice(2), value);
    else if (value !== null && value !== undefined && value !== false) node.setAttribute(name, value);
  }
  node.append(...children.flat().filter(child => child !== null && child !== undefined && child !== false));
  return node;
}

const done = DATA.points.filter(point => point.status === "done");
const sceneNames = Object.keys(DATA.scenes);
const measureOf = name => DATA.measures.find(measure => measure.name === name);
const metricOf = name => DATA.metrics.find(metric => metric.name === name);
const settingOf = name => DATA.settings.find(setting => setting.name === name);
const errorOf = (point, measure) => {
  const error = point.errors && point.errors[measure];
  return error && !error.missing ? error : null;
};
const isUsual = point => Object.entries(DATA.usual[point.settings.preset]).every(([name, value]) => point.settings[name] === value);

// 0.00123 -> 1.23e-3, 12.3 -> 12.3: three digits, no more zeros than help.
function number(value) {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  const size = Math.abs(value);
  if (size === 0) return "0";
  if (size < 0.001 || size >= 100000) {
    const [digits, power] = value.toExponential(1).split("e");
    return `${digits}·10${superscript(Number(power))}`;
  }
  return size >= 100 ? value.toFixed(0) : size >= 10 ? value.toFixed(1) : size >= 1 ? value.toFixed(2)
    : value.toFixed(size >= 0.1 ? 3 : 4);
}
const superscript = power => String(power).replace(/./g, digit => "⁰¹²³⁴⁵⁶⁷⁸⁹⁻"["0123456789-".indexOf(digit)]);
const percent = value => typeof value !== "number" ? "–" : (value >= 0 ? "+" : "−") + (Math.abs(value) * 100).toFixed(Math.abs(value) < 0.1 ? 1 : 0) + " %";
const bytes = count => count >= 2 ** 20 ? `${(count / 2 ** 20).toFixed(1)} MiB`
  : count >= 1024 ? `${(count / 1024).toFixed(1)} KiB` : `${count} B`;
const sentence = text => `${text[0].toUpperCase()}${text.slice(1)}.`;
const whole = count => count.toLocaleString("en").replaceAll(",", " ");

// An error in words: its number, or that it is no larger than the reference's own noise.
function metricText(error, metric) {
  if (metric === "relmse" && error.at_noise_floor) return "at the floor";
  return metric === "bias" ? percent(error.bias) : number(error[metric]);
}
function metricCell(error, metric) {
  if (!error || typeof error[metric] !== "number") return make("td", {class: "soft"}, "–");
  const floor = metric === "relmse" && error.at_noise_floor;
  return make("td", floor ? {class: "floor", title: `measured ${number(error.relmse)}; the reference's own noise is `
    + number(error.noise_relmse)} : {}, metricText(error, metric));
}

function settingText(name, value) {
  if (name === "grid" && value !== "auto") return `${value}³`;
  if (name === "cone_angle_deg") return `${value}°`;
  return String(value).replace("x", "×");
}
// The settings in which the sweep's points differ and which the mode feels.
function settingsFor(mode) {
  return DATA.settings.filter(setting => setting.values.length > 1 && (!setting.changes || setting.changes.includes(mode)));
}
function configText(point, mode) {
  const names = settingsFor(mode);
  return (names.length ? names : DATA.settings.filter(setting => setting.name === "grid"))
    .map(setting => settingText(setting.name, point.settings[setting.name])).join(" · ");
}

function table(head, rows) {
  return make("div", {class: "table", tabindex: "0", role: "region", "aria-label": "table"},
    make("table", {}, make("thead", {}, head), make("tbody", {}, rows)));
}
const headRow = names => make("tr", {}, names.map(name => make("th", {scope: "col"}, name)));

function fillSelect(select, options, chosen) {
  select.replaceChildren(...options.map(([value, text]) => make("option", {value, selected: value === chosen}, text)));
  if (chosen !== undefined) select.value = chosen;
}

// What is chosen on the page; parts redraw when it changes.
const state = {scene: sceneNames[0], measure: null, key: null};
const listeners = [];
function choose(change) {
  Object.assign(state, change);
  for (const listener of listeners) listener(change);
}
