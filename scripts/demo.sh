#!/usr/bin/env bash
# From a clean clone to pictures in out/demo/: the presets beside path tracing, with times and errors, in the Cornell box and a
# courtyard; then the thesis's five modes, with every stage of the pipeline and the time of each step.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/setup.sh
# Downloading Python packages and compiling run in parallel.
scripts/python.sh &
python=$!
scripts/build.sh desktop vct
wait "$python"
# Pictures of an older build beside new ones would mislead.
rm -rf out/demo
mkdir -p out/demo
echo "rendering the Cornell box and the courtyard by each preset (about four minutes on two cores, most of them for the preset quality)"
.venv/bin/python tools/eval.py render cornell courtyard --measures gi --out out/demo --sheet out/demo/presets.png
echo "rendering the five modes of the preset thesis, and the stages of the pipeline (half a minute)"
build/desktop/vct render assets/cornell.glb --out out/demo --preset thesis --mode all --size 400x400 \
    --sky 0,0,0 --debug-views --contact-sheet --revoxelize --timings out/demo/timings.json
cp docs/demo.md out/demo/README.md
echo "Look at out/demo/presets.png first; out/demo/README.md explains every picture."
