#!/usr/bin/env bash
# Stands in for adb and the phone behind it in test_phone.py: no phone, no Android. $PHONE is a folder that holds
# sdcard/ and what the phone is to do: devices (what `adb devices` lists), install (what installing prints), app (what
# the app does once it is started: a shell script), log (what logcat prints), running (there while the app runs).
set -u
echo "$*" >>"$PHONE/calls"

# The phone's own commands; the rest of what scripts/phone.sh runs there is any shell's.
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
        # As adb before 2018: ends well whatever came of it.
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
