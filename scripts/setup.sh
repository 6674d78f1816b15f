#!/usr/bin/env bash
# Installs, by apt, what building and testing need on a bare Debian 12 or Ubuntu 24.04. Says and does nothing where
# nothing is missing. Needs root or sudo only where something is.
set -euo pipefail

# Compiler and build; the libraries of cmake/dependencies.cmake; the drivers that draw (Mesa's llvmpipe behind EGL,
# and lavapipe for zink); GLFW for the window of `vct view` and examples/embed; what the tests call: GoogleTest, glslang,
# and Python for tools/make_assets.py.
required=(
    g++ cmake ninja-build
    libglm-dev libtinygltf-dev libopenexr-dev zlib1g-dev libstb-dev nlohmann-json3-dev libcli11-dev libimgui-dev
    libdraco-dev libmeshoptimizer-dev libwebp-dev
    libegl-dev libgles-dev libglfw3-dev
    libegl1 libegl-mesa0 libgl1-mesa-dri libvulkan1 mesa-vulkan-drivers
    libgtest-dev glslang-tools python3
)
# Without these the tests that want them are skipped, and say so. Mesa 25.1 dropped OSMesa: newer systems have no such
# package, and the program loads it at run time only. The other two are a display and fingers for the tests of `vct view`.
optional=(libosmesa6 xvfb xdotool)

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
    # Another apt may be at work, such as the system's own at start-up: wait for it instead of failing.
    "${as_root[@]}" DEBIAN_FRONTEND=noninteractive \
        apt-get --yes --no-install-recommends -o DPkg::Lock::Timeout=300 "$@" </dev/null
}

# Would it install here? Asks the package lists, changes nothing.
installable() { apt-get --simulate --no-install-recommends install "$@" </dev/null >/dev/null 2>&1; }

install_packages() {
    say "installing $# packages: $*"
    local log
    log="$(mktemp)"
    if ! apt_get install "$@" >"$log" 2>&1; then
        tail -n 30 "$log" >&2
        rm -f "$log"
        fail "apt-get could not install the packages above"
    fi
    rm -f "$log"
}

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    fail "this is not Debian or Ubuntu: install what provides ${required[*]}, then use the CMake presets directly"
fi

missing=()
for package in "${required[@]}"; do
    installed "$package" || missing+=("$package")
done

if [[ ${#missing[@]} -gt 0 ]]; then
    say "reading the package lists"
    # Old lists may still do; if not, the installation says what is wrong.
    apt_get -qq update >/dev/null || say "the package lists could not be updated; trying with those that are here"
elif [[ "$(id -u)" -ne 0 ]] && ! command -v sudo >/dev/null; then
    exit 0  # what is missing at most are the optional ones
fi
for package in "${optional[@]}"; do
    installed "$package" && continue
    # Together, because drivers must be of the same version.
    if installable "${missing[@]}" "$package"; then
        missing+=("$package")
    elif [[ ${#missing[@]} -gt 0 ]]; then
        say "$package is not available here: the tests that need it will be skipped"
    fi
done
[[ ${#missing[@]} -eq 0 ]] || install_packages "${missing[@]}"
