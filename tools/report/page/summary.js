// The header's facts, the summary, the failed points and the method.
function drawFacts() {
  $("facts").append(...DATA.facts.flatMap(([name, value]) => [make("div", {}, make("dt", {}, name), make("dd", {}, value))]));
}

const SUMMARY = [["gi-one-bounce", ["relmse", "bias", "flip"]], ["gi-full", ["relmse", "bias", "flip"]],
  ["indirect", ["relmse", "bias"]], ["soft", ["relmse", "bias"]], ["ao", ["rmse", "bias"]]];
const SHORT = {"gi-one-bounce": "gi / one bounce", "gi-full": "gi / full light", indirect: "indirect alone",
  soft: "soft / wide sun", ao: "AO"};

function usualPoint(scene) {
  return done.find(point => point.scene === scene && isUsual(point));
}

function drawSummary() {
  const groups = SUMMARY.filter(([name]) => done.some(point => errorOf(point, name)));
  const modes = DATA.modes;
  const head = [
    make("tr", {}, make("th", {rowspan: 2, scope: "col"}, "Scene"),
      make("th", {colspan: modes.length, class: "group", scope: "colgroup"}, "time, ms"),
      groups.map(([name, metrics]) => make("th", {colspan: metrics.length, class: "group", scope: "colgroup"}, SHORT[name]))),
    make("tr", {}, modes.map(mode => make("th", {scope: "col"}, mode)),
      groups.flatMap(([, metrics]) => metrics.map(metric => make("th", {scope: "col"}, metricOf(metric).label))))];
  const rows = sceneNames.map(scene => {
    const point = usualPoint(scene);
    if (!point) return make("tr", {}, make("th", {scope: "row"}, scene), make("td", {colspan: 20, class: "text soft"},
      "not measured at these settings"));
    return make("tr", {}, make("th", {scope: "row"}, scene),
      modes.map(mode => make("td", {}, point.modes[mode] ? number(point.modes[mode].total[0]) : "–")),
      groups.flatMap(([name, metrics]) => metrics.map(metric => metricCell(errorOf(point, name), metric))));
  });
  const usual = Object.entries(DATA.usual).filter(([name, value]) => !(name === "experiment" && value === "none"))
    .map(([name, value]) => settingText(name, value)).join(", ");
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
