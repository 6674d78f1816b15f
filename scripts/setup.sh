#!/usr/bin/env bash
# Installs the packages that building and testing need on a bare Debian 12 or Ubuntu 24.04. Does nothing, silently, where nothing
# is missing, and needs root or sudo only where something is.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/progress.sh"

# Compiler and build; the libraries of cmake/dependencies.cmake; software drivers (Mesa's llvmpipe behind EGL, and lavapipe for
# zink); GLFW for the window of `vct view` and the examples; for the tests GoogleTest, glslang, and Python, which runs
# tools/make_assets.py.
required=(
    g++ cmake ninja-build
    libglm-dev libtinygltf-dev libopenexr-dev zlib1g-dev libstb-dev nlohmann-json3-dev libcli11-dev libimgui-dev
    libdraco-dev libmeshoptimizer-dev libwebp-dev
    libegl-dev libgles-dev libglfw3-dev
    libegl1 libegl-mesa0 libgl1-mesa-dri libvulkan1 mesa-vulkan-drivers
    libgtest-dev glslang-tools pkg-config python3
)
# Tests that need these are skipped without them, with a message. Newer systems have no OSMesa, which Mesa 25.1 dropped; the
# program loads it only at run time. The next two are the display and the input of the tests of `vct view`, and the last three
# fetch the driver ANGLE (scripts/angle.sh).
optional=(libosmesa6 xvfb xdotool curl ca-certificates brotli)

say() { echo "setup: $*"; }
fail() {
    echo "setup: error: $*" >&2
    exit 1
}

installed() {
    [[ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" == installed ]]
}

apt_get() {
    local as_root=(env)
    if [[ "$(id -u)" -ne 0 ]]; then
        command -v sudo >/dev/null || fail "installing packages needs root or sudo: run as root '$0'"
        as_root=(sudo env)
    fi
    # Another apt may be running, such as the system's own at start-up: wait for it instead of failing.
    "${as_root[@]}" DEBIAN_FRONTEND=noninteractive \
        apt-get --yes --no-install-recommends -o DPkg::Lock::Timeout=300 "$@" </dev/null
}

# Asks the package lists whether the packages can be installed, and changes nothing.
installable() { apt-get --simulate --no-install-recommends install "$@" </dev/null >/dev/null 2>&1; }

install_packages() {
    say "installing $# packages: $*"
    local log
    log="$(mktemp)"
    install_quietly() { apt_get install "$@" >"$log" 2>&1; }
    if ! with_progress "setup: installing" install_quietly "$@"; then
        tail -n 30 "$log" >&2
        rm -f "$log"
        fail "apt-get could not install the packages above"
    fi
    rm -f "$log"
}

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    fail "this is not Debian or Ubuntu: install the equivalents of ${required[*]}, then use the CMake presets directly"
fi

missing=()
for package in "${required[@]}"; do
    installed "$package" || missing+=("$package")
done

if [[ ${#missing[@]} -gt 0 ]]; then
    say "reading the package lists"
    # Old lists may suffice; if not, the installation reports the error.
    update_quietly() { apt_get -qq update >/dev/null; }
    with_progress "setup: reading the package lists" update_quietly || say "the package lists could not be updated; trying with the old ones"
elif [[ "$(id -u)" -ne 0 ]] && ! command -v sudo >/dev/null; then
    exit 0  # only optional packages can be missing
fi
# Together with the required ones, because the drivers must have the same version.
add_optional() {
    local package wanted=()
    for package in "${optional[@]}"; do
        installed "$package" || wanted+=("$package")
    done
    [[ ${#wanted[@]} -gt 0 ]] || return 0
    # One by one takes seconds for each package.
    if installable "${missing[@]}" "${wanted[@]}"; then
        missing+=("${wanted[@]}")
        return 0
    fi
    for package in "${wanted[@]}"; do
        if installable "${missing[@]}" "$package"; then
            missing+=("$package")
        elif [[ ${#missing[@]} -gt 0 ]]; then
            say "$package is not available here: the tests that need it will be skipped"
        fi
    done
}
with_progress "setup: choosing packages" add_optional
[[ ${#missing[@]} -eq 0 ]] || install_packages "${missing[@]}"
