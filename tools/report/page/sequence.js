// Moments of an animation, each with its indirect light below: what moves takes its colour along.
function drawSequence() {
  const sequence = DATA.sequence;
  if (!sequence) {
    $("animation-body").append(make("p", {class: "note"}, "Not given to this report: tools/report.py --sequence."));
    return;
  }
  const picture = (name, what, frame) => name && make("img", {src: DATA.album[name], loading: "lazy",
    alt: `${what} at ${frame.time_s.toFixed(2)} s`});
  const worst = Math.max(...sequence.frames.map(frame => frame.largest_difference));
  $("animation-body").append(make("p", {}, `${sequence.scene}, preset ${sequence.preset}, mode ${sequence.mode}, and below each
    picture its indirect light of one bounce. The pictures are of one run, frame after frame; a fresh run of each moment alone
    ${worst === 0 ? "gives the same to the last bit" : `differs by ${number(worst)} of the brightest at most`}.`),
  make("div", {class: "sequence"}, sequence.frames.map(frame => make("figure", {},
    picture(frame.picture, "The picture", frame), picture(frame.indirect_light, "The indirect light", frame),
    make("figcaption", {}, `${frame.time_s.toFixed(2)} s`)))));
}
