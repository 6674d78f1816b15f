#!/usr/bin/env bash
# Installs, by apt, the browser that tests the report: Debian's chromium and chromium-driver. Says and does nothing
# where both are here. Only the report's tests need it; without it they are skipped and say so.
set -euo pipefail

fail() {
    echo "browser: $*" >&2
    exit 1
}

if command -v chromium >/dev/null && command -v chromedriver >/dev/null; then exit 0; fi
command -v apt-get >/dev/null || fail "no apt-get here: install chromium and chromedriver"
as_root=(env)
if [[ "$(id -u)" -ne 0 ]]; then
    sudo --non-interactive true 2>/dev/null || fail "chromium is missing; installing it needs root or sudo: run '$0' as root"
    as_root=(sudo env)
fi
apt_get() {
    "${as_root[@]}" DEBIAN_FRONTEND=noninteractive \
        apt-get --yes --no-install-recommends -o DPkg::Lock::Timeout=300 "$@" </dev/null
}

# Ubuntu's package of this name only installs a snap, which does not work everywhere.
if [[ "$(. /etc/os-release && echo "${ID:-}")" != debian ]]; then
    fail "chromium is a package on Debian only; install it and chromedriver by hand to run the report's tests"
fi
log="$(mktemp)"
trap 'rm -f "$log"' EXIT
echo "browser: installing chromium and chromium-driver (about 350 MB)"
apt_get -qq update >"$log" 2>&1 || true
apt_get install chromium chromium-driver >>"$log" 2>&1 || {
    tail -n 10 "$log" >&2
    fail "apt-get could not install chromium"
}
