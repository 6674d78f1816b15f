#!/usr/bin/env bash
# Builds the Android app, build/android/vct.apk, and checks it (tools/apk/check.py). With --or-skip, which scripts/test.sh
# uses, a missing NDK or packaging tool is reported and is no error. docs/phone.md has the details.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

or_skip=0
case "${1:-}" in
    '') ;;
    --or-skip) or_skip=1 ;;
    *)
        echo "usage: scripts/apk.sh [--or-skip]" >&2
        exit 2
        ;;
esac

fail() {
    echo "apk: error: $1" >&2
    exit 1
}
missing() {
    if [[ $or_skip -eq 1 ]]; then
        echo "apk: skipped: $1"
        exit 0
    fi
    fail "$1"
}

sdk="${ANDROID_HOME:-${ANDROID_SDK_ROOT:-}}"
newest() { find "$1" -mindepth 1 -maxdepth 1 -type d 2>/dev/null | sort --version-sort | tail -n 1; }

if [[ -z "${ANDROID_NDK_HOME:-}" ]]; then
    ANDROID_NDK_HOME="${ANDROID_NDK_ROOT:-}"
    [[ -n "$ANDROID_NDK_HOME" || -z "$sdk" ]] || ANDROID_NDK_HOME="$(newest "$sdk/ndk")"
fi
[[ -n "$ANDROID_NDK_HOME" ]] ||
    missing "no Android NDK: set ANDROID_NDK_HOME to the folder of one, r27 or newer"
[[ -f "$ANDROID_NDK_HOME/build/cmake/android.toolchain.cmake" ]] ||
    fail "ANDROID_NDK_HOME is '$ANDROID_NDK_HOME', which is not an Android NDK"
export ANDROID_NDK_HOME
if [[ -n "$sdk" ]]; then
    export ANDROID_HOME="$sdk"
    PATH="$(newest "$sdk/build-tools"):$PATH"
fi
for tool in aapt2 zipalign apksigner keytool python3 git; do
    command -v "$tool" >/dev/null ||
        missing "$tool is not installed: set ANDROID_HOME to Android's SDK, or on Debian: apt install aapt zipalign \
apksigner android-framework-res default-jdk-headless python3 git"
done
python3 -c 'import elftools' 2>/dev/null || missing "pyelftools is not installed: on Debian, apt install python3-pyelftools"
[[ -f /usr/share/android-framework-res/framework-res.apk ]] || compgen -G "$sdk/platforms/android-*/android.jar" >/dev/null ||
    missing "no framework to link the manifest against: on Debian, apt install android-framework-res; or install a platform of the SDK"

# This is the last of the libraries that cmake/packings_android.cmake fetches.
[[ -d build/android/_deps/webp-src ]] ||
    GIT_TERMINAL_PROMPT=0 timeout 60 git ls-remote --quiet https://github.com/ocornut/imgui.git HEAD >/dev/null 2>&1 ||
    missing "the app's libraries must be fetched once from github.com, which cannot be reached"

echo "apk: NDK $(sed -n 's/^Pkg.Revision = //p' "$ANDROID_NDK_HOME/source.properties")"
scripts/build.sh android apk
python3 tools/apk/check.py build/android/vct.apk --ndk "$ANDROID_NDK_HOME"
