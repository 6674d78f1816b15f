#!/usr/bin/env bash
# Builds and checks the Android app where there is an NDK; then builds and runs every test, plain and under the
# sanitizers; then some of them as the phone's processor runs them, where that can be had and half an hour allows it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# A few at a time: each test of a context brings its own driver threads and up to a few hundred MB of voxels.
jobs="$(nproc)"
export CTEST_PARALLEL_LEVEL="${CTEST_PARALLEL_LEVEL:-$((jobs < 4 ? jobs : 4))}"

scripts/setup.sh
scripts/apk.sh --or-skip
# The tests of ANGLE skip themselves for the same reason (tests/tools/test_angle.py).
angle="$(scripts/angle.sh 2>&1)" || echo "angle: skipped: no test runs on the driver of most new phones: ${angle#angle: error: }"
for preset in desktop asan; do
    scripts/build.sh "$preset"
    echo "$preset: testing"
    [[ $preset != asan ]] ||
        echo "asan: left out: accuracy, pictures and other drivers, which are the same C++ (tests/CMakeLists.txt)"
    ctest --preset "$preset" --output-on-failure
done
scripts/android-userland.sh 5
# All of it: scripts/arm64.sh.
if ((SECONDS < 1100)); then
    scripts/arm64.sh --short
else
    echo "arm64: skipped: $SECONDS s are used, and it may take five minutes more"
fi
