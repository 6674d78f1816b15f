#!/usr/bin/env bash
# Stands in for adb and a phone in test_phone.py. $PHONE is a folder with sdcard/ and the behaviour of the phone: devices (the output
# of `adb devices`), install (the output of installing), app (a shell script that stands in for the app), log (the output of
# logcat), running (exists while the app runs).
set -u
echo "$*" >>"$PHONE/calls"

# These commands are the phone's own; scripts/phone.sh runs only commands of any shell besides.
getprop() { echo 'Test Phone'; }
input() { :; }
pm() { [[ ! -f "$PHONE/installed" ]] || echo 'package:/data/app/vct.app/base.apk'; }
pidof() { [[ -f "$PHONE/running" ]] && echo 4711; }
am() {
    case "$1" in
        start)
            [[ -f "$PHONE/installed" ]] || { echo 'Error: Activity class {vct.app/android.app.NativeActivity} does not exist.'; return; }
            echo 'Starting: Intent { cmp=vct.app/android.app.NativeActivity (has extras) }'
            touch "$PHONE/running"
            (cd "$PHONE" && exec bash ./app >/dev/null 2>&1 &)
            ;;
        force-stop) rm -f "$PHONE/running" ;;
    esac
}

case "$1" in
    devices)
        printf 'List of devices attached\n'
        cat "$PHONE/devices"
        printf '\n'
        ;;
    get-state) [[ ! -f "$PHONE/unplugged" ]] && echo device ;;
    install)
        cat "$PHONE/install"
        grep -q Success "$PHONE/install" && touch "$PHONE/installed"
        # As adb before 2018, it ends with 0 whatever happened.
        true
        ;;
    shell)
        shift
        command="$*"
        eval "${command//\/sdcard/$PHONE/sdcard}" | sed 's/$/\r/'
        exit "${PIPESTATUS[0]}"
        ;;
    logcat) [[ "$*" == *-c* ]] || cat "$PHONE/log" 2>/dev/null ;;
    push) cp "$2" "${3/\/sdcard/$PHONE/sdcard}" ;;
    pull) cp -r "${2/\/sdcard/$PHONE/sdcard}" "$3" ;;
    *)
        echo "the stand-in does not know: $*" >&2
        exit 1
        ;;
esac
