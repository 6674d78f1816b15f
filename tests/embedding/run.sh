#!/usr/bin/env bash
# run.sh BUILD: installs the library that BUILD made, builds examples/embed and examples/engine against it and nothing else, by
# CMake and by pkg-config, and runs them without a window. ctest runs this.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cmake --install "$1" --prefix "$folder/installed" >"$folder/log"
for example in embed engine; do
    cmake -S "examples/$example" -B "$folder/$example" -DCMAKE_PREFIX_PATH="$folder/installed" -DCMAKE_BUILD_TYPE=None >"$folder/log"
    cmake --build "$folder/$example" >"$folder/log" 2>&1 || {
        cat "$folder/log"
        exit 1
    }
done
"$folder/embed/embed" --headless 1 --out "$folder/first.ppm"
"$folder/embed/embed" --headless 16 --out "$folder/later.ppm"
"$folder/embed/triangle" "$folder/triangle.ppm"
# first frame A ms, median B ms, longest C ms; memory D MB at half time, E MB at the end
"$folder/embed/stream" | tee "$folder/stream" | awk '{ grown = $17 - $12 } END { exit grown > 20 }' || {
    echo "streaming takes more and more memory: $(cat "$folder/stream")" >&2
    exit 1
}

# The same by pkg-config. The header, pkg-config and CMake's package tell the same version.
pc="$(dirname "$(find "$folder/installed" -name vct.pc)")"
vct() { PKG_CONFIG_PATH="$pc" pkg-config "$@" vct; }
# shellcheck disable=SC2046
"${CXX:-c++}" -std=c++20 -O1 examples/embed/triangle.cpp examples/embed/shapes.cpp examples/embed/window.cpp \
    $(vct --cflags --libs) -lGLESv2 -lEGL -o "$folder/by_pkg_config"
"$folder/by_pkg_config" "$folder/by_pkg_config.ppm"
# The order of additions on the GPU differs from run to run, and may change the last bit of a few bytes.
differing="$(cmp -l "$folder/triangle.ppm" "$folder/by_pkg_config.ppm" | wc -l || true)"
[[ "$differing" -le 100 ]] || { echo "by pkg-config, $differing bytes of the picture differ" >&2; exit 1; }
# shellcheck disable=SC2046
header="$(printf '#include <vct/version.h>\nVCT_VERSION_MAJOR VCT_VERSION_MINOR VCT_VERSION_PATCH VCT_VERSION' |
    "${CXX:-c++}" -E -P -x c++ $(vct --cflags) - | tail -n 1)"
package="$(sed -n 's/^set(PACKAGE_VERSION "\(.*\)")$/\1/p' "$(find "$folder/installed" -name vctConfigVersion.cmake)")"
for version in "$(vct --modversion)" "$package"; do
    [[ "$header" == "${version//./ } \"$version\"" ]] || {
        echo "vct/version.h says $header, and vct.pc or vctConfigVersion.cmake says $version" >&2
        exit 1
    }
done
# The engine shows the same as the program, as far as both show it.
engine() { "$folder/engine/engine" assets/studio.glb --headless 1 --time 0.2 "$@"; }
engine --out "$folder/pane.png"
engine --no-lamp --out "$folder/dark.png"
engine --no-pane --out "$folder/no_pane.png"
"$1/vct" render assets/studio.glb --time 0.2 --size 320x240 --samples 1 --mode gi-cone-shadow --tone-map none --exposure 1 --sky 0,0,0 \
    --out "$folder/tool" >"$folder/log" 2>&1
tool="$folder/tool/gi-cone-shadow.png"
"$1/vct" compare "$folder/no_pane.png" "$tool" --max-difference 2/255 --max-fraction 0.002
python=python3
[[ ! -x .venv/bin/python ]] || python=.venv/bin/python
"$python" tests/embedding/check_engine.py "$folder"/{pane,dark,no_pane}.png "$tool"

exec python3 tests/embedding/check.py "$folder/first.ppm" "$folder/later.ppm" "$folder/triangle.ppm" docs/embedding.md \
    examples/embed/triangle.cpp examples/embed/main.cpp examples/embed/stream.cpp examples/engine/shaders.cpp examples/engine/main.cpp
