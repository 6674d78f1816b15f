#!/usr/bin/env bash
# From a clean clone to pictures in out/demo/: a courtyard and the Cornell box by the preset mobile, the box by the thesis's
# algorithm, each with every stage of the pipeline; then, if the Python packages can be had, the presets beside path tracing, with
# times and errors.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/progress.sh

scripts/setup.sh
# Downloading Python packages runs beside compiling and rendering, which do not need them.
python_log="$(mktemp)"
scripts/python.sh >"$python_log" 2>&1 &
python=$!
trap 'kill "$python" 2>/dev/null || true; rm -f "$python_log"' EXIT
stoppable scripts/build.sh desktop vct
# Pictures of an older build beside new ones would mislead.
rm -rf out/demo
mkdir -p out/demo
cp docs/demo.md out/demo/README.md

render() { stoppable build/desktop/vct render "$@"; }
echo "demo: a courtyard by the preset mobile (half a minute on two cores)"
render assets/courtyard.glb --out out/demo/courtyard.png --size 796x498 --samples 8 --environment assets/patio.hdr \
    --camera eye=2.03,1.5,2.95,target=0.42,1.2,-2.5,fov=62 --light direction=-0.7,-0.6,0.25,color=1,0.85,0.65,intensity=6
echo "demo: the Cornell box by the preset mobile, mode by mode and stage by stage (half a minute)"
box=(assets/cornell.glb --mode all --size 400x400 --samples 4 --sky 0,0,0 --debug-views --contact-sheet)
render "${box[@]}" --out out/demo/mobile --preset mobile
echo "demo: the same by the preset thesis, with the time of each step (half a minute)"
render "${box[@]}" --out out/demo/thesis --preset thesis --revoxelize --timings out/demo/thesis/timings.json
echo "demo: look at out/demo/courtyard.png and out/demo/mobile/contact_sheet.png; out/demo/README.md explains every picture"

wait_for_python() { wait "$python"; }
if ! with_progress "demo: waiting for the Python packages" wait_for_python; then
    cat "$python_log" >&2
    echo "demo: done, but for presets.png, which needs the Python packages of tools/requirements.txt: $(tail -n 1 "$python_log")"
    exit 0
fi
# The preset quality takes longer than all else, so it comes last.
for presets in thesis,mobile thesis,mobile,quality; do
    echo "demo: $presets beside path tracing (minutes)"
    stoppable .venv/bin/python tools/eval.py render cornell courtyard --presets "$presets" --measures gi --out out/demo \
        --sheet out/demo/presets.png || {
        echo "demo: done, but for a part of presets.png, because a measurement failed; out/demo/README.md explains the others"
        exit 1
    }
done
echo "demo: done; out/demo/presets.png has the presets beside path tracing, and out/demo/README.md explains every picture"
