// Tables of the chosen scene, of the thesis, of voxels and memory.
const STEP_NAMES = {shadow_map: "CS shadow map", render_data: "RT G-buffer", voxelize: "V voxelize", mipmap: "M mipmap",
  irradiance: "I irradiance", trace: "Tr cones", total: "Tot frame"};
const ofScene = () => done.filter(point => point.scene === state.scene);

function configCells(point) {
  return DATA.settings.filter(setting => setting.values.length > 1 || setting.name === "grid")
    .map(setting => make("td", {}, settingText(setting.name, point.settings[setting.name])));
}
const configHeads = () => DATA.settings.filter(setting => setting.values.length > 1 || setting.name === "grid")
  .map(setting => setting.label);
const rowClass = point => ({class: isUsual(point) ? "usual" : null});

function stepTable() {
  const rows = ofScene().flatMap(point => Object.entries(point.modes).map(([mode, steps]) => make("tr", rowClass(point),
    make("td", {}, mode), configCells(point), Object.keys(STEP_NAMES).map(step => make("td",
      {title: `${number(steps[step][1])} to ${number(steps[step][2])}`}, number(steps[step][0]))),
    make("td", {class: "soft"}, `${number(steps.total[1])} to ${number(steps.total[2])}`))));
  return table(headRow(["Mode", ...configHeads(), ...Object.values(STEP_NAMES), "frame, min to max"]), rows);
}
function errorTables() {
  return DATA.measures.map(measure => [measure, ofScene().filter(point => point.errors && point.errors[measure.name])])
    .filter(([, points]) => points.length).map(([measure, points]) => make("details", {open: measure.name === state.measure ? "" : null},
      make("summary", {}, `${measure.name}: ${measure.what}`),
      table(headRow([...configHeads(), ...DATA.metrics.map(metric => metric.label)]), points.map(point => make("tr", rowClass(point),
        configCells(point), errorOf(point, measure.name)
          ? DATA.metrics.map(metric => metricCell(errorOf(point, measure.name), metric.name))
          : make("td", {colspan: DATA.metrics.length, class: "text soft"}, point.errors[measure.name].missing))))));
}
function drawTables() {
  $("tables-body").replaceChildren(
    make("h3", {}, `Steps, ${state.scene}, milliseconds`), stepTable(),
    make("h3", {}, `Errors, ${state.scene}`), ...errorTables(), ...presetTables(), ...benchTables());
}
function presetTables() {
  if (!DATA.presets) return [];
  const steps = {shadow_map: "shadow map", render_data: "G-buffer", voxelize_mipmap: "voxelize + mipmap", irradiance: "irradiance",
    trace: "trace", total: "frame"};
  const row = (name, values, memory) => make("tr", {}, make("th", {scope: "row"}, name),
    [...values, memory].map(value => make("td", {}, number(value))));
  const tableOf = mode => table(headRow(["Preset", ...Object.values(steps), "GL memory, MB"]), [
    ...DATA.presets.presets.map(one => row(`${one.preset}, ${one.settings.grid}³`,
      Object.keys(steps).map(step => one.modes[mode][step].median), one.bytes / 1e6)),
    ...DATA.presets.ratios.map(one => row(`${one.of} / ${one.over}`, Object.keys(steps).map(step => one.modes[mode][step]),
      one.bytes))]);
  return [make("h3", {}, `Presets side by side, ${DATA.presets.scene}`), make("p", {class: "note"}, DATA.presets.note),
    ...["ao", "gi", "gi-cone-shadow"].filter(mode => DATA.presets.presets[0].modes[mode]).map(mode =>
      make("details", {open: ""}, make("summary", {}, mode), tableOf(mode)))];
}
function benchTables() {
  if (!DATA.bench) return [];
  return [make("h3", {}, `The thesis's tables, ${DATA.bench.scene}`), make("p", {class: "note"}, DATA.bench.note),
    ...Object.entries(DATA.bench.tables).map(([name, bench]) => make("details", {open: ""},
      make("summary", {}, `${name}: ${bench.title}`), table(headRow(["Platform", ...bench.columns]),
        bench.rows.map(row => make("tr", {class: row.source === "measured" ? "usual" : null}, make("th", {scope: "row"}, row.platform),
          row.values.map(value => make("td", {}, number(value))))))))];
}

function drawVoxels() {
  const seen = new Set();
  const points = ofScene().filter(point => {
    const id = JSON.stringify([point.settings.grid, point.settings.preset, point.settings.size]);
    return point.active_voxels && point.active_voxels.length && !seen.has(id) && seen.add(id);
  });
  const levels = Math.max(0, ...points.map(point => point.active_voxels.length));
  const name = point => configText(point, "gi");
  const resources = [...new Set(points.flatMap(point => point.resources.map(resource => resource.name)))];
  const size = (point, resource) => point.resources.filter(one => one.name === resource).reduce((sum, one) => sum + one.bytes, 0);
  const scene = DATA.scenes[state.scene];
  $("voxels-body").replaceChildren(
    make("p", {}, `${state.scene}: ${whole(scene.triangles)} triangles. Active voxels are those with something in them.`),
    make("h3", {}, "Active voxels per level, finest first"),
    table(headRow(["Grid", "share of level 0", ...Array.from({length: levels}, (_, level) => `level ${level}`)]),
      points.map(point => make("tr", rowClass(point), make("th", {scope: "row"}, name(point)),
        make("td", {}, `${(point.active_voxels[0] / (point.grid ?? point.settings.grid) ** 3 * 100).toFixed(2)} %`),
        Array.from({length: levels}, (_, level) => make("td", {}, point.active_voxels[level] === undefined ? "" : whole(point.active_voxels[level])))))),
    make("h3", {}, "Bytes on the GPU"),
    table(headRow(["Resource", ...points.map(name)]),
      [...resources.map(resource => make("tr", {}, make("th", {scope: "row"}, resource),
        points.map(point => make("td", {}, bytes(size(point, resource)))))),
      make("tr", {class: "usual"}, make("th", {scope: "row"}, "together"),
        points.map(point => make("td", {}, bytes(point.resources.reduce((sum, one) => sum + one.bytes, 0)))))]));
}
