// The header's facts, the summary, the failed points and the method.
function drawFacts() {
  $("facts").append(...DATA.facts.flatMap(([name, value]) => [make("div", {}, make("dt", {}, name), make("dd", {}, value))]));
}

const SUMMARY = [["indirect", ["relmse", "bias", "flip"]], ["gi-full", ["relmse", "bias", "flip"]],
  ["soft-full", ["relmse", "bias"]], ["shadow", ["rmse"]], ["ao", ["rmse"]]];
const SHORT = {indirect: "indirect alone / one bounce", "gi-full": "gi / full light", "soft-full": "soft / wide sun, full light",
  shadow: "shadow", ao: "AO"};

function summaryRow(scene, preset, span, modes, groups) {
  const point = done.find(one => one.scene === scene && one.settings.preset === preset && isUsual(one));
  const heads = [span && make("th", {scope: "rowgroup", rowspan: span}, scene), make("th", {scope: "row"}, preset)];
  if (!point) return make("tr", {}, heads, make("td", {colspan: 20, class: "text soft"}, "not measured at these settings"));
  return make("tr", {}, heads, modes.map(mode => make("td", {}, point.modes[mode] ? number(point.modes[mode].total[0]) : "–")),
    groups.flatMap(([name, metrics]) => metrics.map(metric => metricCell(errorOf(point, name), metric))));
}

function drawSummary() {
  const groups = SUMMARY.filter(([name]) => done.some(point => errorOf(point, name)));
  const modes = DATA.modes;
  const head = [
    make("tr", {}, make("th", {rowspan: 2, scope: "col"}, "Scene"), make("th", {rowspan: 2, scope: "col"}, "Preset"),
      make("th", {colspan: modes.length, class: "group", scope: "colgroup"}, "time, ms"),
      groups.map(([name, metrics]) => make("th", {colspan: metrics.length, class: "group", scope: "colgroup"}, SHORT[name]))),
    make("tr", {}, modes.map(mode => make("th", {scope: "col"}, mode)),
      groups.flatMap(([, metrics]) => metrics.map(metric => make("th", {scope: "col"}, metricOf(metric).label))))];
  const presets = Object.keys(DATA.usual);
  const rows = sceneNames.flatMap(scene => presets.map((preset, i) =>
    summaryRow(scene, preset, i === 0 && presets.length, modes, groups)));
  const usual = Object.values(DATA.usual).map(settings => Object.entries(settings)
    .map(([name, value]) => settingText(name, value))
    .join(", ")).join("; ");
  $("summary-body").append(make("p", {}, `At ${usual}. Times are medians; errors are of linear light. “At the floor”: the
    error cannot be told from the reference's own noise, so its number says nothing.`), table(head, rows));
  const failed = DATA.points.filter(point => point.status === "failed");
  if (failed.length) $("summary-body").append(make("div", {class: "failed", id: "failed-points"},
    make("strong", {}, `${failed.length} point${failed.length > 1 ? "s" : ""} failed`),
    failed.map(point => make("div", {}, `${point.scene}: ` + Object.entries(point.settings)
      .map(([name, value]) => settingText(name, value)).join(", "), make("pre", {}, point.message)))));
}

function drawMethod() {
  $("method-body").append(...DATA.method.map(text => make("p", {}, text)));
  $("method-body").append(make("h3", {}, "Errors"), table(make("tr", {}, make("th", {scope: "col"}, "Name"), make("th", {scope: "col", class: "text"}, "What it is")),
    DATA.metrics.map(metric => make("tr", {}, make("th", {scope: "row"}, metric.label),
      make("td", {class: "text"}, metric.what)))));
  const kinds = [...new Set(sceneNames.flatMap(scene => Object.keys(DATA.scenes[scene].noise)))];
  if (kinds.length) $("method-body").append(make("h3", {}, "Noise of the references, as relMSE"),
    table(headRow(["Scene", ...kinds]), sceneNames.map(scene => make("tr", {}, make("th", {scope: "row"}, scene),
      kinds.map(kind => make("td", {}, number(DATA.scenes[scene].noise[kind])))))));
}
