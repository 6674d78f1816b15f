// One configuration's picture, its reference and its error picture: under a slider, in turns, or side by side.
const NAMES = {picture: "vct", reference: "reference", error: "error"};
const view = {way: "slider", a: "picture", b: "reference", share: 50, second: false, timer: null};

function withPictures(scene, measure) {
  return done.filter(point => point.scene === scene && DATA.pictures[point.key] && DATA.pictures[point.key][measure]);
}
function measuresOf(scene) {
  return DATA.measures.filter(measure => withPictures(scene, measure.name).length);
}
function image(kind, names, attributes = {}) {
  return make("img", {src: DATA.album[names[kind]], alt: NAMES[kind], draggable: "false", ...attributes});
}

function sliderStage(names) {
  const over = image(view.a, names, {class: "over", id: "stage-over"});
  const divider = make("div", {class: "divider", id: "stage-divider"});
  const stage = make("div", {class: "stage"}, image(view.b, names), over, divider,
    make("span", {class: "tag left"}, NAMES[view.a]), make("span", {class: "tag right"}, NAMES[view.b]));
  const slider = make("input", {type: "range", id: "slider", min: 0, max: 100, step: 0.5, value: view.share,
    "aria-label": `How much of the ${NAMES[view.a]} shows over the ${NAMES[view.b]}`});
  const place = () => {
    over.style.clipPath = `inset(0 ${100 - view.share}% 0 0)`;
    divider.style.left = `${view.share}%`;
  };
  slider.addEventListener("input", () => { view.share = Number(slider.value); place(); });
  const drag = event => {
    if (event.type === "pointermove" && event.buttons === 0) return;
    const box = stage.getBoundingClientRect();
    view.share = Math.max(0, Math.min(100, (event.clientX - box.left) / box.width * 100));
    slider.value = view.share;
    place();
  };
  stage.addEventListener("pointerdown", drag);
  stage.addEventListener("pointermove", drag);
  place();
  return [stage, slider];
}

function flipStage(names) {
  const tag = make("span", {class: "tag left", id: "stage-tag"});
  const over = image(view.b, names, {class: "over", id: "stage-over"});
  const stage = make("div", {class: "stage"}, image(view.a, names), over, tag);
  const show = () => {
    over.style.visibility = view.second ? "visible" : "hidden";
    tag.textContent = NAMES[view.second ? view.b : view.a];
  };
  const flip = () => { view.second = !view.second; show(); };
  const turns = make("button", {type: "button", id: "flip-turns", "aria-pressed": "false", onclick: () => {
    stopTurns(turns, view.timer === null ? setInterval(flip, 700) : null);
  }}, "Take turns");
  stage.addEventListener("click", flip);
  show();
  return [stage, make("div", {class: "controls"},
    make("button", {type: "button", id: "flip", onclick: flip}, "Flip (or press F)"), turns)];
}
function stopTurns(button, timer) {
  if (view.timer !== null) clearInterval(view.timer);
  view.timer = timer;
  if (button) button.setAttribute("aria-pressed", String(timer !== null));
}

function sideStage(names) {
  return [make("div", {class: "side"}, ["picture", "reference", "error"].map(kind =>
    make("figure", {}, image(kind, names), make("figcaption", {class: "note"}, NAMES[kind]))))];
}

function pictureFacts(point, measure, names) {
  const error = errorOf(point, measure.name);
  const time = point.modes[measure.mode];
  return make("div", {}, make("h3", {}, `${point.scene}, ${configText(point, measure.mode)}`), make("p", {}, sentence(measure.what)),
    make("table", {}, make("tbody", {},
      time && make("tr", {}, make("th", {scope: "row"}, "frame, ms"),
        make("td", {}, `${number(time.total[0])} (${number(time.total[1])} to ${number(time.total[2])})`)),
      DATA.metrics.map(metric => make("tr", {title: metric.what}, make("th", {scope: "row"}, metric.label),
        metricCell(error, metric.name))),
      make("tr", {}, make("th", {scope: "row"}, "reference's noise, relMSE"), make("td", {}, number(error.noise_relmse))))),
    make("p", {class: "note"}, `Picture and reference are sRGB of light × ${names.exposure.toPrecision(3)}, the same for all configurations.`),
    make("p", {class: "note"}, "Error: the difference over √(reference² + 0.01), whose mean square is relMSE; red too bright, blue too dark."),
    make("div", {class: "scale", style: `background:linear-gradient(90deg,${DATA.error_colours.join(",")})`, role: "img",
      "aria-label": "Colours of the error: blue too dark, black right, red to yellow too bright"}),
    make("div", {class: "scale-names"}, make("span", {}, "100 % too dark"), make("span", {}, "0"), make("span", {}, "100 % too bright")));
}

function drawDebugView() {
  stopTurns(null, null);
  const measure = measureOf($("view-measure").value), point = done.find(one => one.key === $("view-config").value);
  if (!measure || !point) return;
  const names = DATA.pictures[point.key][measure.name];
  const stage = {slider: sliderStage, flip: flipStage, side: sideStage}[view.way](names);
  const facts = pictureFacts(point, measure, names);
  $("view-body").className = view.way === "side" ? "viewer wide" : "viewer";
  $("view-body").replaceChildren(make("div", {}, ...stage), facts);
}

function fillViewer() {
  const measures = measuresOf(state.scene);
  $("viewer-none").hidden = measures.length > 0;
  $("view-body").hidden = measures.length === 0;
  if (!measures.length) return;
  const measure = measures.find(one => one.name === state.measure) || measures[0];
  fillSelect($("view-measure"), measures.map(one => [one.name, one.name]), measure.name);
  const points = withPictures(state.scene, measure.name);
  const asked = DATA.points.find(point => point.key === state.key && point.scene === state.scene);
  const chosen = points.find(point => point.key === state.key) || points.find(isUsual) || points[0];
  $("viewer-kept").hidden = !asked || asked === chosen;
  fillSelect($("view-config"), points.map(point => [point.key, configText(point, measure.mode)]), chosen.key);
  drawDebugView();
}

function startViewer() {
  const kinds = Object.entries(NAMES);
  const ways = [["slider", "Slider"], ["flip", "Flip"], ["side", "Side by side"]].map(([way, text]) =>
    make("button", {type: "button", "data-way": way, "aria-pressed": String(way === view.way), onclick: event => {
      view.way = way;
      for (const button of event.target.parentNode.children) button.setAttribute("aria-pressed", String(button === event.target));
      drawDebugView();
    }}, text));
  const pick = (id, name) => make("select", {id, onchange: event => { view[name] = event.target.value; drawDebugView(); }});
  $("viewer").append(
    make("div", {class: "controls"}, make("label", {}, "Judged", make("select", {id: "view-measure",
      onchange: event => choose({measure: event.target.value})})),
      make("label", {}, "Configuration", make("select", {id: "view-config", onchange: event => choose({key: event.target.value})})),
      make("label", {}, "First", pick("view-a", "a")), make("label", {}, "Second", pick("view-b", "b")),
      make("div", {role: "group", "aria-label": "How they are shown"}, ways)),
    make("p", {class: "note", id: "viewer-kept", hidden: ""}, "The pictures of the chosen point are not kept in this page, to keep "
      + "it small; these are the nearest. They lie in the sweep's folder."),
    make("p", {class: "note", id: "viewer-none", hidden: ""}, "No pictures with a reference for this scene."),
    make("div", {id: "view-body", class: "viewer"}));
  fillSelect($("view-a"), kinds, view.a);
  fillSelect($("view-b"), kinds, view.b);
  document.addEventListener("keydown", event => {
    if (event.key.toLowerCase() === "f" && !event.ctrlKey && !event.metaKey && !event.altKey
      && !["INPUT", "SELECT"].includes(event.target.tagName)) $("flip")?.click();
  });
  listeners.push(fillViewer);
  fillViewer();
}
