#!/usr/bin/env bash
# Prints the folder of a build of ANGLE for Linux, the OpenGL ES driver of most new Android phones, and fetches it first where it is
# missing (68 MB, into .cache/). It is part of the npm package @sparticuz/chromium, and runs over Vulkan:
#
#   LD_LIBRARY_PATH="$(scripts/angle.sh)" ANGLE_DEFAULT_PLATFORM=swiftshader build/desktop/vct info   # no geometry shaders
#   LD_LIBRARY_PATH="$(scripts/angle.sh)" ANGLE_DEFAULT_PLATFORM=vulkan build/desktop/vct info        # the machine's driver
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

version=147.0.0
sha256=18fe5404ce845594cd7d592fc07f37a19514079ba4d9c27192ad8b908743f16b
folder="$PWD/.cache/angle-$version"

fail() {
    echo "angle: error: $*" >&2
    exit 1
}
# The link is the last thing that is made.
if [[ -e $folder/libEGL.so.1 ]]; then
    echo "$folder"
    exit 0
fi
[[ "$(uname -sm)" == "Linux x86_64" ]] || fail "the package has ANGLE for x86-64 Linux alone, and this is $(uname -sm)"
for tool in curl brotli sha256sum; do
    command -v "$tool" >/dev/null || fail "$tool is not installed: apt install curl brotli"
done

registry=https://registry.npmjs.org/
if command -v npm >/dev/null; then registry="$(npm config get registry)"; fi
url="${registry%/}/@sparticuz/chromium/-/chromium-$version.tgz"
mkdir -p .cache
work="$(mktemp -d .cache/angle.XXXXXX)"
trap 'rm -rf "$work"' EXIT
curl --fail --silent --show-error --location --connect-timeout 20 --max-time 300 --output "$work/package.tgz" "$url" 2>"$work/log" ||
    fail "$url cannot be fetched: $(cat "$work/log")"
echo "$sha256  $work/package.tgz" | sha256sum --check --status || fail "$url is not the file that this script expects (SHA-256)"
mkdir "$work/angle"
tar --extract --gzip --file "$work/package.tgz" --to-stdout package/bin/swiftshader.tar.br | brotli --decompress |
    tar --extract --no-same-owner --directory "$work/angle"
ln -s libEGL.so "$work/angle/libEGL.so.1"
rm -rf "$folder"
mv "$work/angle" "$folder"
echo "$folder"
