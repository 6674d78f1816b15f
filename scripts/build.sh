#!/usr/bin/env bash
# build.sh PRESET [TARGET]: configures and builds a preset of CMakePresets.json. Prints errors, warnings and every tenth of a
# long build.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

preset="$1"
target="${2:-all}"
start=$SECONDS
echo "$preset: configuring and building (minutes the first time)"
log="$(mktemp)"
trap 'rm -f "$log"' EXIT
cmake --preset "$preset" --log-level=WARNING >"$log" 2>&1 || {
    cat "$log" >&2
    exit 1
}
# Ninja's default is two jobs more than there are processors, and builds with sanitizers need much memory.
NINJA_STATUS="[%f/%t] " cmake --build --preset "$preset" --target "$target" --parallel "$(nproc)" |
    awk -v preset="$preset" '
        /^\[[0-9]+\/[0-9]+\] / {
            split(substr($1, 2), steps, /[\/\]]/)
            tenth = int(10 * steps[1] / steps[2])
            if (tenth > printed && steps[2] >= 50) {
                print preset ": " steps[1] " of " steps[2] " steps"
                fflush()
                printed = tenth
            }
            next
        }
        !/^ninja: no work to do/ { print; fflush() }'
echo "$preset: built in $((SECONDS - start)) s"
