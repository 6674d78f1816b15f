// Moments of an animation, each with its indirect light below: what moves takes its colour along.
function drawSequence() {
  const sequence = DATA.sequence;
  if (!sequence) {
    $("animation-body").append(make("p", {class: "note"}, "Not given to this report: tools/report.py --sequence."));
    return;
  }
  const picture = (name, what, frame) => name && make("img", {src: DATA.album[name], loading: "lazy",
    alt: `${what} at ${frame.time_s.toFixed(2)} s`});
  $("animation-body").append(make("p", {}, `${sequence.scene}, preset ${sequence.preset}, mode ${sequence.mode}, at ${sequence.fps}
    frames a second as an app shows them, and below each picture the indirect light of one bounce of a still picture of that
    moment. Light is remembered over frames: the mean FLIP against the still picture is below each.`),
  make("div", {class: "sequence"}, sequence.frames.map(frame => make("figure", {},
    picture(frame.picture, "The picture", frame), picture(frame.indirect_light, "The indirect light", frame),
    make("figcaption", {}, `${frame.time_s.toFixed(2)} s, FLIP ${number(frame.flip)}`)))));
}
