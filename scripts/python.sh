#!/usr/bin/env bash
# Makes .venv from tools/requirements.txt, and installs the packages that it needs on a bare Debian 12 or Ubuntu 24.04: Python's
# venv module, and LLVM 19 for Mitsuba. Does nothing, silently, where nothing is missing.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/progress.sh

say() { echo "python: $*"; }
fail() {
    echo "python: error: $*" >&2
    exit 1
}

apt_install() {
    local as_root=(env) log
    command -v apt-get >/dev/null || fail "this is not Debian or Ubuntu: install the equivalents of the packages $*"
    if [[ "$(id -u)" -ne 0 ]]; then
        command -v sudo >/dev/null || fail "installing packages needs root or sudo: run as root '$0'"
        as_root=(sudo env)
    fi
    say "installing by apt: $*"
    log="$(mktemp)"
    # Old package lists may suffice; if not, the installation reports the error.
    "${as_root[@]}" apt-get -qq -o DPkg::Lock::Timeout=300 update </dev/null >"$log" 2>&1 || true
    if ! "${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get --yes --no-install-recommends \
        -o DPkg::Lock::Timeout=300 install "$@" </dev/null >>"$log" 2>&1; then
        tail -n 30 "$log" >&2
        rm -f "$log"
        fail "apt-get could not install $*"
    fi
    rm -f "$log"
}

# These are the places where tools/truth/engine.py looks.
has_llvm() { compgen -G '/usr/lib/*/libLLVM.so.19*' >/dev/null || compgen -G '/usr/lib/llvm-19/lib/libLLVM.so*' >/dev/null; }

packages=()
[[ -n "${DRJIT_LIBLLVM_PATH:-}" ]] || has_llvm || packages+=(libllvm19)

stamp=.venv/requirements.txt
if ! cmp -s tools/requirements.txt "$stamp" || ! .venv/bin/python -c '' 2>/dev/null; then
    command -v python3 >/dev/null && python3 -c 'import venv, ensurepip' 2>/dev/null || packages+=(python3 python3-venv)
fi
[[ ${#packages[@]} -eq 0 ]] || apt_install "${packages[@]}"

if ! cmp -s tools/requirements.txt "$stamp" || ! .venv/bin/python -c '' 2>/dev/null; then
    python3 -c 'import sys; sys.exit(sys.version_info < (3, 11))' ||
        fail "$(python3 --version) is too old: tools/requirements.txt needs Python 3.11 or newer"
    say "making .venv from tools/requirements.txt (about 350 MB)"
    python3 -m venv --clear .venv
    with_progress "python: installing tools/requirements.txt" .venv/bin/python -m pip install --quiet --disable-pip-version-check \
        --only-binary :all: --requirement tools/requirements.txt || fail "pip could not install tools/requirements.txt"
    cp tools/requirements.txt "$stamp.tmp"
    mv "$stamp.tmp" "$stamp"
fi
