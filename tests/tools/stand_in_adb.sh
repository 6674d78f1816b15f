#!/usr/bin/env bash
# Stands in for adb and a phone in test_phone.py. $PHONE is a folder with sdcard/ and the behaviour of the phone: devices (the output
# of `adb devices`), install (the output of installing), app (a shell script that stands in for the app and finds the command that
# it was started with in $VCT_COMMAND), log (the output of logcat), running (exists while the app runs), unplugged (exists while the
# cable is out), settings/ (a file for each).
set -u
echo "$*" >>"$PHONE/calls"

# These commands are the phone's own; scripts/phone.sh runs only commands of any shell besides.
getprop() { echo 'Test Phone'; }
input() { :; }
wm() { echo "Physical size: 1080x2400"; }
cmd() { :; }
dumpsys() { echo "dumpsys of $*"; }
pm() { [[ ! -f "$PHONE/installed" ]] || echo 'package:/data/app/vct.app/base.apk'; }
pidof() { [[ -f "$PHONE/running" ]] && echo 4711; }
settings() {
    mkdir -p "$PHONE/settings"
    case "$1" in
        get) cat "$PHONE/settings/$3" 2>/dev/null || echo null ;;
        put) echo "$4" >"$PHONE/settings/$3" ;;
    esac
}
screencap() { printf '\x89PNG\r\n\x1a\n a picture'; }
am() {
    case "$1" in
        start)
            [[ -f "$PHONE/installed" ]] || { echo 'Error: Activity class {vct.app/android.app.NativeActivity} does not exist.'; return; }
            echo 'Starting: Intent { cmp=vct.app/android.app.NativeActivity (has extras) }'
            touch "$PHONE/running"
            export VCT_COMMAND="${*: -1}"
            (cd "$PHONE" && exec bash ./app >/dev/null 2>&1 &)
            ;;
        force-stop) rm -f "$PHONE/running" ;;
    esac
}

if [[ -f "$PHONE/unplugged" && "$1" != devices ]]; then
    echo "error: no devices/emulators found" >&2
    exit 1
fi
case "$1" in
    devices)
        printf 'List of devices attached\n'
        cat "$PHONE/devices"
        printf '\n'
        ;;
    get-state) echo device ;;
    install)
        cat "$PHONE/install"
        grep -q Success "$PHONE/install" && touch "$PHONE/installed"
        # As adb before 2018, it ends with 0 whatever happened.
        true
        ;;
    shell)
        shift
        command="$*"
        [[ "$command" != logcat* ]] || { cat "$PHONE/log"; exit; }
        eval "${command//\/sdcard/$PHONE/sdcard}" | sed 's/$/\r/'
        exit "${PIPESTATUS[0]}"
        ;;
    exec-out) eval "$2" ;;
    push) cp "$2" "${3/\/sdcard/$PHONE/sdcard}" ;;
    pull) cp -r "${2/\/sdcard/$PHONE/sdcard}" "$3" ;;
    *)
        echo "the stand-in does not know: $*" >&2
        exit 1
        ;;
esac
