#!/usr/bin/env bash
# build.sh PRESET [TARGET]: configures and builds a preset of CMakePresets.json. Prints errors and warnings, and how far a long
# build is every five seconds.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/progress.sh

preset="$1"
target="${2:-all}"
start=$SECONDS
echo "$preset: configuring and building (minutes the first time)"
log="$(mktemp)"
trap 'rm -f "$log"' EXIT
configure() { cmake --preset "$preset" --log-level=WARNING >"$log" 2>&1; }
with_progress "$preset: configuring" configure || {
    cat "$log" >&2
    exit 1
}
# Ninja's default is two jobs more than there are processors, and builds with sanitizers need much memory. The build has a process
# group of its own, because cmake does not hand signals on.
exec 3< <(NINJA_STATUS="[%f/%t] " exec setsid cmake --build --preset "$preset" --target "$target" --parallel "$(nproc)")
build=$!
trap 'kill -TERM -- "-$build"; exit 143' INT TERM HUP

place="building" printed=$SECONDS line=""
while true; do
    result=0
    IFS= read -r -t 1 -u 3 part || result=$?
    line+="$part"
    if ((result == 0)); then
        if [[ "$line" =~ ^\[([0-9]+)/([0-9]+)\]\  ]]; then
            place="${BASH_REMATCH[1]} of ${BASH_REMATCH[2]} steps"
        elif [[ "$line" != "ninja: no work to do"* ]]; then
            echo "$line"
        fi
        line=""
    elif ((result == 1)); then # the end
        [[ -z "$line" ]] || echo "$line"
        break
    fi
    if ((SECONDS - printed >= 5)); then
        echo "$preset: $place, $((SECONDS - start)) s so far"
        printed=$SECONDS
    fi
done
wait "$build"
echo "$preset: built in $((SECONDS - start)) s"
