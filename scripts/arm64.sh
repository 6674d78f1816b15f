#!/usr/bin/env bash
# Tests the phone's processor without a phone: builds for 64-bit ARM Linux, runs the result under QEMU's user-mode emulation
# with Mesa's arm64 llvmpipe, and compares with this machine. It runs the tests that need no GPU, compares voxels and lists
# bit for bit, and compares pictures of all presets, of which one pixel in a thousand may differ by more than 5/255.
#
#   scripts/arm64.sh            everything (ten minutes on two cores the first time)
#   scripts/arm64.sh --short    tests without a GPU, and the Cornell box's voxels; skipped with a reason where it cannot run
#
# It cannot show errors of weak memory order, of Android's C library and EGL, or of a phone's driver.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

short=false
case "${1:-}" in
    --short) short=true ;;
    "") ;;
    *)
        sed -n '2,10s/^# \{0,1\}//p' "$0"
        [[ "$1" == --help ]] && exit 0 || exit 2
        ;;
esac

say() { echo "arm64: $*"; }
# A machine that lacks something is no fault of the code, so the short run is then skipped.
unavailable() {
    if $short; then
        say "skipped: $*"
        exit 0
    fi
    echo "arm64: error: $*" >&2
    exit 1
}

[[ "$(uname -m)" == x86_64 ]] || unavailable "it compares with x86-64, and this machine is $(uname -m)"
sysroot="$(scripts/arm64-sysroot.sh)" || unavailable "see the message above"

scripts/build.sh desktop vct_tests
scripts/build.sh arm64 vct_tests

# One thread, because most of the time goes into the driver's compiler, which uses only one. On ARM, llvmpipe filters 8-bit textures
# with 8 bits unless no_aos_sampling is set. Neither a phone nor llvmpipe on x86 with AVX does so, and weak light in voxels would be
# lost. A reserved address space (-R) keeps mappings together: the driver's code reaches constants within 4 GiB only, and without
# it QEMU may place them further away, where the code reads a wrong address (llvm/llvm-project#71963).
emulate=(qemu-aarch64-static -R 512G -L "$sysroot" -E LP_NUM_THREADS=1 -E GALLIVM_PERF=no_aos_sampling)
out="$PWD/build/arm64/out"
rm -rf "$out"
mkdir -p "$out"

# The suites of tests/core, scene and image, without those that run the program in a process of its own, and without those
# that measure time and memory, which differ under emulation.
filter="$(grep -LE 'ProgramRun|CommandLine|std::clock' tests/{core,scene,image}/*_test.cpp |
    xargs sed -nE 's/^TEST(_[FP])?\((\w+),.*/\2.*:*\/\2.*/p' | sort -u | paste -sd:)"
say "tests without a GPU, emulated"
"${emulate[@]}" build/arm64/build/tests/vct_tests --gtest_brief=1 --gtest_filter="$filter" | tail -n 12

say "voxels and lists"
$short && scenes='*cornell_mobile' || scenes='*'
# Prints one line for each scene and preset as soon as it is there.
hashes() {
    "$@" --gtest_filter="Scenes/VoxelHash.$scenes" | tee "$out/log" | grep --line-buffered '^voxels ' || {
        cat "$out/log" >&2
        exit 1
    }
}
hashes build/desktop/tests/vct_tests >"$out/here.txt"
hashes "${emulate[@]}" build/arm64/build/tests/vct_tests | tee "$out/arm64.txt"
diff "$out/here.txt" "$out/arm64.txt" || {
    echo "arm64: error: voxels differ (above: here <, arm64 >)" >&2
    exit 1
}
if $short; then
    say "voxels are equal on both; scripts/arm64.sh compares more scenes, and pictures"
    exit 0
fi

scripts/build.sh desktop vct
scripts/build.sh arm64 vct
failed=0
for scene in cornell moving courtyard; do
    for preset in thesis mobile quality; do
        picture=("assets/$scene.glb" --preset "$preset" --mode gi-cone-shadow --size 96x96 --grid 64 --light-frames 4)
        say "picture of $scene, $preset"
        build/desktop/vct render "${picture[@]}" --out "$out/here/$scene-$preset" >/dev/null 2>&1
        "${emulate[@]}" build/arm64/build/vct render "${picture[@]}" --out "$out/arm64/$scene-$preset" >/dev/null 2>"$out/log" || {
            cat "$out/log" >&2
            exit 1
        }
        build/desktop/vct compare "$out"/{here,arm64}/"$scene-$preset"/gi-cone-shadow.png --max-difference 5/255 \
            --max-fraction 0.001 || failed=1
    done
done
[[ $failed == 0 ]] || { echo "arm64: error: pictures differ by more than the tolerance" >&2; exit 1; }
say "voxels are equal, and pictures within the tolerance"
