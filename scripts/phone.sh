#!/usr/bin/env bash
# Controls the app on a phone that is connected by adb: tools/phone.py, whose usage it prints without a command.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
type -P python3 >/dev/null || {
    echo "phone: error: python3 is not installed: on Debian or Ubuntu, apt install python3" >&2
    exit 1
}
exec python3 -B "$root/tools/phone.py" "$@"
