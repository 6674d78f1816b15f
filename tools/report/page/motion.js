// What the light does over frames: the tables of tools/motion.py.
function drawMotion() {
  if (!DATA.motion) {
    $("motion-body").append(make("p", {class: "note"}, "Not given to this report: tools/report.py --motion."));
    return;
  }
  for (const part of DATA.motion) $("motion-body").append(make("h3", {}, part.name), make("p", {}, part.what),
    table(headRow(part.head), part.rows.map(([first, ...cells]) => make("tr", {}, make("th", {scope: "row"}, first),
      cells.map(cell => make("td", {}, cell))))));
}
