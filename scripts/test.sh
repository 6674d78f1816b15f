#!/usr/bin/env bash
# Builds and tests all that the project promises: the Android app where there is an NDK, every test on the desktop, and under the
# sanitizers the tests of what parses files and of the engine's core.
#
#   scripts/test.sh          what continuous integration runs (ten to fifteen minutes on two cores)
#   scripts/test.sh --all    the sanitizers over more, ANGLE, the phone's processor and Android's system libraries too
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

all=false
case "${1:-}" in
    --all) all=true ;;
    "") ;;
    *)
        sed -n '2,6s/^# \{0,1\}//p' "$0"
        [[ "$1" == --help ]] && exit 0 || exit 2
        ;;
esac

# A few at a time: each test of a context brings its own driver threads and up to a few hundred MB of voxels.
jobs="$(nproc)"
export CTEST_PARALLEL_LEVEL="${CTEST_PARALLEL_LEVEL:-$((jobs < 4 ? jobs : 4))}"

build_and_test() {
    scripts/build.sh "$1"
    echo "$1: testing"
    ctest --preset "$1" --output-on-failure
}

scripts/setup.sh
scripts/apk.sh --or-skip
if ! $all; then
    build_and_test desktop
    build_and_test asan
    echo "test: left out, scripts/test.sh --all runs them: more tests under the sanitizers, ANGLE, 64-bit ARM, Android's libraries"
    exit 0
fi

export VCT_TEST_ALL=1
# The tests of ANGLE skip themselves for the same reason (tests/tools/test_angle.py).
angle="$(scripts/angle.sh 2>&1)" || echo "angle: skipped: no test runs on the driver of most new phones: ${angle#angle: error: }"
build_and_test desktop
build_and_test asan-wide
scripts/android-userland.sh 5
# All of it: scripts/arm64.sh.
scripts/arm64.sh --short
