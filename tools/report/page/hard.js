// The hard cases, as cards; then everything starts.
const STATUS = {pass: "pass", fail: "fail", "known-failure": "known failure"};

function hardCard(hard) {
  const measured = hard.measured === null || hard.measured === undefined ? null
    : make("p", {class: "size"}, `${typeof hard.measured === "number" ? number(hard.measured) : hard.measured} ${hard.unit || ""}`,
      hard.bar === null || hard.bar === undefined ? "" : make("small", {}, ` bar: ${typeof hard.bar === "number" ? number(hard.bar) : hard.bar}`));
  return make("article", {class: "card", "data-status": hard.status}, make("h3", {}, hard.name,
    make("span", {class: `badge ${hard.status}`}, STATUS[hard.status] || hard.status)),
    make("p", {}, hard.what), make("p", {}, make("span", {class: "soft"}, "Right: "), hard.right_answer), measured,
    hard.preset && make("p", {class: "soft"}, `preset ${hard.preset}`), hard.note && make("p", {class: "note"}, hard.note),
    hard.image && make("img", {src: DATA.album[hard.image], alt: hard.name, loading: "lazy"}));
}

function drawHard() {
  if (!DATA.hard) {
    $("hard-body").append(make("p", {class: "note"}, "Not given to this report: tools/report.py --hard-cases."));
    return;
  }
  const cards = make("div", {class: "cards"}, DATA.hard.map(hardCard));
  const filter = (text, status, pressed) => make("button", {type: "button", "data-filter": status, "aria-pressed": String(pressed),
    onclick: event => {
      for (const button of event.target.parentNode.children) button.setAttribute("aria-pressed", String(button === event.target));
      for (const card of cards.children) card.hidden = status !== "all" && card.dataset.status !== status;
    }}, text);
  const count = status => DATA.hard.filter(hard => hard.status === status).length;
  $("hard-body").append(make("p", {}, "A case that fails stays in the list. A known failure is one of the published algorithm itself, "
    + "with its size, to be cured by later presets."),
    make("div", {class: "controls", role: "group", "aria-label": "Which cases are shown"}, filter(`all ${DATA.hard.length}`, "all", true),
      Object.keys(STATUS).filter(count).map(status => filter(`${STATUS[status]} ${count(status)}`, status, false))), cards);
}

function start() {
  const usual = DATA.measures.find(measure => done.some(point => DATA.pictures[point.key]?.[measure.name]) && measure.name === "indirect")
    || DATA.measures.find(measure => done.some(point => errorOf(point, measure.name)));
  state.measure = usual ? usual.name : null;
  if (sceneNames.includes("cornell")) state.scene = "cornell";
  fillSelect($("scene"), sceneNames.map(scene => [scene, scene]), state.scene);
  $("scene").addEventListener("change", event => choose({scene: event.target.value, key: null}));
  listeners.push(change => { if (change.scene) $("scene").value = change.scene; });
  listeners.push(change => { if (change.measure) drawTables(); });
  for (const draw of [drawTables, drawVoxels]) {
    listeners.push(change => { if (change.scene) draw(); });
    draw();
  }
  drawFacts();
  drawSummary();
  drawMethod();
  drawMotion();
  drawHard();
  startViewer();
  startPlots();
}
start();
