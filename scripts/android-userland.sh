#!/usr/bin/env bash
# Runs the app's own library, from its APK, on the linker and C library of an Android system, without a phone or an emulator of one:
# the self-test, frames, rotation, touch, lost windows, low memory, save and restore, errors, and random lives of the activity. Code for
# 64-bit ARM runs in QEMU's user-mode emulation, code for x86-64 as it is. docs/phone.md says what that shows.
#
#   ANDROID_USERLAND=FOLDER ANDROID_NDK_HOME=FOLDER scripts/android-userland.sh [LIVES]     20 random lives, if LIVES is not given
#
# ANDROID_USERLAND is a folder with bin/linker64 and lib64/ of an Android system: /system of a phone (adb pull) or of its image.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

lives="${1:-20}"
say() { echo "android-userland: $*"; }
fail() {
    say "error: $*" >&2
    exit 1
}
[[ $lives =~ ^[0-9]+$ && $# -le 1 ]] || {
    echo "usage: scripts/android-userland.sh [LIVES]" >&2
    exit 2
}
if [[ -z "${ANDROID_USERLAND:-}" ]]; then
    say "skipped: ANDROID_USERLAND is not set; it names a folder with bin/linker64 and lib64/ of an Android system"
    exit 0
fi
[[ -f "${ANDROID_NDK_HOME:-}/build/cmake/android.toolchain.cmake" ]] ||
    fail "ANDROID_NDK_HOME is '${ANDROID_NDK_HOME:-}', which is not an Android NDK"
[[ "$(uname -sm)" == "Linux x86_64" ]] || fail "it runs on x86-64 Linux alone, and this is $(uname -sm)"

# From Android 10 on, these files belong to a module, and the system has copies for its start.
linker="$ANDROID_USERLAND/bin/bootstrap/linker64"
[[ -f $linker ]] || linker="$ANDROID_USERLAND/bin/linker64"
[[ -f $linker && -f $ANDROID_USERLAND/lib64/libc.so ]] ||
    fail "ANDROID_USERLAND is '$ANDROID_USERLAND', which has no bin/linker64 or no lib64/libc.so"
case "$(od -An -tu2 -j18 -N2 "$linker" | tr -d ' ')" in
    183) abi=arm64-v8a preset=android ;;
    62) abi=x86_64 preset=android-x86_64 ;;
    *) fail "$linker is neither for 64-bit ARM nor for x86-64" ;;
esac

scripts/build.sh "$preset" apk
scripts/build.sh "$preset" stand_ins
build="$PWD/build/$preset" stand_ins="$PWD/build/$preset/stand_ins"
host=("$stand_ins/host") options=()
if [[ $abi == arm64-v8a ]]; then
    sysroot="$(scripts/arm64-sysroot.sh)" || fail "see the message above"
    compile=(aarch64-linux-gnu-g++)
    # See scripts/arm64.sh.
    export LP_NUM_THREADS=1 GALLIVM_PERF=no_aos_sampling
    host=(qemu-aarch64-static -R 512G -L "$sysroot" "${host[@]}") options=(--emulated)
else
    grep -q '\bfsgsbase\b' /proc/cpuinfo || fail "this processor has no instructions for the thread pointer (fsgsbase)"
    compile=(g++ -mfsgsbase)
fi
"${compile[@]}" -std=c++20 -O1 -Wall -Wextra -Werror -o "$stand_ins/host" tools/android/host.cpp -ldl -pthread

files="$(mktemp -d)"
trap 'rm -rf "$files"' EXIT
export EGL_PLATFORM=surfaceless
# The system's own libandroid.so, liblog.so and libEGL.so need processes of the system, so stand-ins come first.
export ANDROID_ENV_LD_LIBRARY_PATH="$stand_ins:$ANDROID_USERLAND/lib64/bootstrap:$ANDROID_USERLAND/lib64"
say "the APK's library for $abi on $linker"
python3 tools/android/lives.py --random "$lives" "${options[@]}" "$build/lives/$(basename "$ANDROID_USERLAND")" \
    "${host[@]}" "$linker" "$stand_ins/activity" "$build/vct.apk" "$abi" "$files"
