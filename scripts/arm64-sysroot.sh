#!/usr/bin/env bash
# Prints a folder with Debian's arm64 packages (Mesa's llvmpipe and the libraries of this program, 90 MB) for the emulator QEMU and
# the cross-compiler, both of which it installs by apt where they are missing. Makes the folder first where there is none.
#
#   qemu-aarch64-static -L "$(scripts/arm64-sysroot.sh)" PROGRAM
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

root="$PWD/build/arm64" sysroot="$PWD/build/arm64/sysroot"
packages=(libc6-dev libegl1 libegl-mesa0 libgl1-mesa-dri libegl-dev libgles-dev libopenexr-dev zlib1g-dev libtinygltf-dev
    libstb-dev libimgui-dev libglm-dev libcli11-dev nlohmann-json3-dev libgtest-dev libdraco-dev libmeshoptimizer-dev
    libwebp-dev)

say() { echo "arm64: $*" >&2; }
fail() {
    say "error: $*"
    exit 1
}
# Installs the compiler and the emulator.
install_tools() {
    local as_root=(env)
    [[ "$(id -u)" -eq 0 ]] || as_root=(sudo -n env)
    "${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get -qq --yes --no-install-recommends \
        -o DPkg::Lock::Timeout=300 install g++-aarch64-linux-gnu qemu-user-static </dev/null >/dev/null 2>&1
}
command -v apt-get >/dev/null || fail "it needs packages of Debian or Ubuntu"
if ! command -v aarch64-linux-gnu-g++ >/dev/null || ! command -v qemu-aarch64-static >/dev/null; then
    say "installing by apt: g++-aarch64-linux-gnu qemu-user-static"
    install_tools || fail "apt cannot install g++-aarch64-linux-gnu and qemu-user-static"
fi

# Installing arm64 packages on this machine would remove some of its own (libopenexr-dev cannot be there twice). So an apt that
# knows of no other architecture, and has nothing installed, downloads them, and they are unpacked into a folder.
if ! [[ -f $sysroot/packages.txt && "$(cat "$sysroot/packages.txt")" == "${packages[*]}" ]]; then
    say "fetching Debian's arm64 packages (90 MB) into $sysroot"
    rm -rf "$root"
    mkdir -p "$root"/apt/{state/lists/partial,cache/archives/partial} "$sysroot"
    : >"$root/apt/status"
    apt=(apt-get -qq -o APT::Architecture=arm64 -o APT::Architectures=arm64 -o Dir::State="$root/apt/state"
        -o Dir::State::status="$root/apt/status" -o Dir::Cache="$root/apt/cache" -o Debug::NoLocking=1
        -o APT::Sandbox::User="$(id -un)")
    { "${apt[@]}" update && "${apt[@]}" --yes --download-only --no-install-recommends install "${packages[@]}"; } \
        </dev/null >"$root/apt/log" 2>&1 || fail "no arm64 packages: $(tail -n 1 "$root/apt/log")"
    for package in "$root"/apt/cache/archives/*.deb; do
        dpkg-deb --extract "$package" "$sysroot"
    done
    rm -rf "$root/apt"
    # The compiler expects its own headers below the sysroot.
    mkdir -p "$sysroot/usr/aarch64-linux-gnu"
    ln -s /usr/aarch64-linux-gnu/include "$sysroot/usr/aarch64-linux-gnu/include"
    echo "${packages[*]}" >"$sysroot/packages.txt"
fi
echo "$sysroot"
