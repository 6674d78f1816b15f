#!/usr/bin/env bash
# From a fresh clone to the page of speed against error: sets up, builds, sweeps, runs the hard cases and writes
# out/report/index.html. `--quick` does a small part of it, in a few minutes. Ctrl-C stops it; the same command
# continues. Ends with 1 where the page shows a failed point or hard case: it is written all the same.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

quick=()
case "${1:-}" in
    '') ;;
    --quick) quick=(--quick) ;;
    *)
        echo "usage: scripts/report.sh [--quick]" >&2
        exit 2
        ;;
esac

scripts/setup.sh
scripts/python.sh
scripts/build.sh desktop vct

python=.venv/bin/python
out=out/report${quick:+-quick}
failed=0

# A failed point or case belongs on the page; only a stopped run ends here.
step() {
    local status=0
    echo "report: $1"
    shift
    "$@" || status=$?
    [[ $status -lt 2 ]] || exit "$status"
    [[ $status -eq 0 ]] || failed=1
}
# Those of an older program beside a new sweep would mislead; the sweep sorts its own out.
rm -rf "$out/hard_cases" "$out/bench.json" "$out/presets.json" "$out/motion"
step "sweep of grids and cone angles" "$python" tools/sweep.py "${quick[@]}" --out "$out/sweep"
if [[ ${#quick[@]} -eq 0 ]]; then
    step "the thesis's tables" build/desktop/vct bench assets/cornell.glb --repeat 1 --json "$out/bench.json"
    step "the presets side by side" build/desktop/vct bench assets/cornell.glb --preset thesis,mobile,quality \
        --json "$out/presets.json"
fi
light=()
[[ ${#quick[@]} -eq 0 ]] || light=(--parts swim --scenes cornell --presets mobile --frames 2)
step "light over frames" "$python" tools/motion.py "${light[@]}" --out "$out/motion"
step "hard cases" "$python" tools/hard_cases.py "${quick[@]}" --out "$out/hard_cases"

page=("$python" tools/report.py --sweep "$out/sweep/sweep.json" --out "$out/index.html")
[[ ! -e "$out/hard_cases/hard_cases.json" ]] || page+=(--hard-cases "$out/hard_cases/hard_cases.json")
[[ ! -e "$out/motion/motion.json" ]] || page+=(--motion "$out/motion/motion.json")
[[ ! -e "$out/bench.json" ]] || page+=(--bench "$out/bench.json")
[[ ! -e "$out/presets.json" ]] || page+=(--presets "$out/presets.json")
"${page[@]}" >/dev/null
"$python" tools/pareto.py --sweep "$out/sweep/sweep.json" --out "$out/pareto.png" >/dev/null
[[ $failed -eq 0 ]] || echo "report: some points or cases failed; the page shows them"
echo "Open $out/index.html in a browser."
exit "$failed"
