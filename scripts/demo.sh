#!/usr/bin/env bash
# From a clean clone to pictures: renders the Cornell box in the five modes, with every debug view of the pipeline
# and the time of each step, into out/demo/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/setup.sh
scripts/build.sh desktop vct
# Pictures of an older program beside new ones would mislead.
rm -rf out/demo
mkdir -p out/demo
echo "rendering assets/cornell.glb in the five modes, 400x400, 256^3 voxels (about half a minute on two cores)"
build/desktop/vct render assets/cornell.glb --out out/demo --mode all --size 400x400 --grid 256 \
    --debug-views --contact-sheet --revoxelize --timings out/demo/timings.json
cp docs/demo.md out/demo/README.md
echo "Look at out/demo/contact_sheet.png first; out/demo/README.md explains every picture."
