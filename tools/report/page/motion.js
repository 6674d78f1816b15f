// What the light does over frames: swimming, lag, convergence (tools/motion.py).
const share = value => `${(100 * value).toFixed(1)} %`;

function motionCell(entry, text) {
  if (!entry) return make("td", {class: "soft"}, "–");
  return entry.failed ? make("td", {title: entry.failed}, "failed") : make("td", {}, text(entry));
}

// One row for each scene, one column for each preset.
function motionTable(part, text, last) {
  const presets = [...new Set(Object.values(part).flatMap(ofScene => Object.keys(ofScene)))];
  return table(headRow(["scene", ...presets, ...(last ? [last.name] : [])]), Object.entries(part).map(([scene, ofScene]) =>
    make("tr", {}, make("th", {scope: "row"}, scene), presets.map(preset => motionCell(ofScene[preset], text)),
      last && make("td", {class: "soft"}, last.text(Object.values(ofScene).find(entry => !entry.failed))))));
}

function convergenceTable(part) {
  const rows = Object.entries(part).flatMap(([scene, ofScene]) => Object.entries(ofScene).flatMap(([preset, cases]) =>
    Object.entries(cases).filter(([name]) => name !== "failed").map(([name, found]) => ({scene, preset, name, gi: found.gi}))));
  if (!rows.length) return null;
  const until = gi => !("frames_until" in gi) ? "–" : gi.frames_until === null ? "more" : String(gi.frames_until);
  return table(headRow(["scene", "preset", "from", ...rows[0].gi.steps.map(step => `${step.frames}`), "frames until"]),
    rows.map(row => make("tr", {}, make("th", {scope: "row"}, row.scene), make("td", {}, row.preset), make("td", {}, row.name),
      row.gi.steps.map(step => make("td", {title: `relMSE ${number(step.to_converged.relmse)}`}, number(step.to_converged.flip))),
      make("td", {}, until(row.gi)))));
}

function drawMotion() {
  const motion = DATA.motion, body = $("motion-body");
  if (!motion) {
    body.append(make("p", {class: "note"}, "Not given to this report: tools/report.py --motion."));
    return;
  }
  const both = value => `${share(value.rms)} / ${share(value.p99)}`;
  if (motion.swim) {
    body.append(make("h3", {}, "Swimming"), make("p", {}, `A slow camera, 1.3 pixels a frame at ${motion.size.join("×")}: how much
      the light that a surface point receives changes from frame to frame, RMS / 99th percentile. Diffuse light does not depend on
      the view: it should not change at all. The floor is what the measure finds of a field that is known not to change.`),
    motionTable(motion.swim, both, {name: "floor", text: entry => entry ? both(entry.floor) : "–"}));
  }
  if (motion.lag) {
    body.append(make("h3", {}, "Lag and noise"), make("p", {}, `A sun that goes once around in 10 s, and moving objects, at 30
      frames a second: each frame after the first 16 against the still picture of its moment. Mean relMSE / mean FLIP (largest
      FLIP).`),
    motionTable(motion.lag, entry => `${number(entry.mean.relmse)} / ${number(entry.mean.flip)} (${number(entry.worst.flip)})`));
  }
  const converging = motion.convergence && convergenceTable(motion.convergence);
  if (converging) {
    body.append(make("h3", {}, "Convergence"), make("p", {}, `Mode gi after so many frames, from nothing or after the sun has
      jumped by 30°: FLIP against the converged still picture. Frames until: from when on the relMSE of that
      is less than a tenth of the converged one's own against path tracing, and the mean within 3 %.`), converging);
  }
}
