#!/usr/bin/env bash
# From a fresh clone to a page of times and errors, out/report/index.html: sets up, builds, measures every scene at every preset,
# and light over frames. --quick measures a small part, into out/report-quick/, in a few minutes. The
# same command continues a run that was stopped. Ends with 1 where a measurement failed; the page is written all the same.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

out=out/report
pictures=() motion=()
case "${1:-}" in
    '') ;;
    --quick)
        out=out/report-quick
        pictures=(cornell --size 64x64)
        motion=(dynamic --presets mobile --frames 4 --repeat 1)
        ;;
    *)
        echo "usage: scripts/report.sh [--quick]" >&2
        exit 2
        ;;
esac

scripts/setup.sh
scripts/python.sh
source scripts/progress.sh
stoppable scripts/build.sh desktop vct

failed=0
# A failed measurement is shown on the page, so only a stopped run ends here.
measure() {
    local status=0
    echo "report: $1"
    stoppable .venv/bin/python tools/eval.py "$@" --out "$out" || status=$?
    [[ $status -lt 2 ]] || exit "$status"
    [[ $status -eq 0 ]] || failed=1
}
measure render "${pictures[@]}" --measures all
measure motion "${motion[@]}"
.venv/bin/python tools/eval.py report --out "$out" >/dev/null
[[ $failed -eq 0 ]] || echo "report: some measurements failed; the page shows them"
echo "Open $out/index.html in a browser."
exit "$failed"
