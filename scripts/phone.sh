#!/usr/bin/env bash
# Controls the app on a phone that is connected by adb. docs/phone.md explains how to connect it.
#
#   scripts/phone.sh install               installs the APK
#   scripts/phone.sh push SCENE.glb...     copies scenes to the phone, for the app's list of scenes
#   scripts/phone.sh bench [KEY=VALUE...]  installs, measures, copies the results to out/phone/ and prints the tables;
#                                          default: scene=cornell.glb preset=thesis size=400x400
#
# Options before the command: --apk FILE (default: the newest build), --timeout SECONDS for bench (default: 1800), --out DIR, and
# --beside NAME=FILE with a bench.json or timings.json of another machine. ANDROID_SERIAL chooses one of several phones.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"

package=vct.app
activity=$package/android.app.NativeActivity
files=/sdcard/Android/data/$package/files
poll_s="${VCT_PHONE_POLL_S:-2}"

say() { echo "phone: $*"; }
fail() {
    echo "phone: error: $*" >&2
    exit 1
}
usage() {
    sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}" >&2
    exit 2
}

apk='' timeout_s=1800 out='' beside=()
while [[ "${1:-}" == --* ]]; do
    [[ $# -ge 2 ]] || usage
    case "$1" in
        --apk) apk="$2" ;;
        --timeout) timeout_s="$2" ;;
        --out) out="$2" ;;
        --beside) beside+=("$2") ;;
        *) usage ;;
    esac
    shift 2
done
[[ "$timeout_s" =~ ^[1-9][0-9]*$ ]] || fail "--timeout is '$timeout_s', not a number of seconds"
command="${1:-}"
[[ -n "$command" ]] || usage
shift

# Without </dev/null, adb shell would read this script's stdin.
adb() { command adb "$@" </dev/null; }
on_phone() { adb shell "$@" | tr -d '\r'; }

require_phone() {
    type -P adb >/dev/null || fail "adb is not installed: on Debian or Ubuntu, apt install adb; or Android's platform tools"
    local list state
    list="$(command adb devices </dev/null 2>&1)" || fail "adb devices: $list"
    list="$(tr -d '\r' <<<"$list" | sed -n 's/^\([^ *][^\t]*\)\t\(.*\)$/\1 \2/p')"
    [[ -z "${ANDROID_SERIAL:-}" ]] || list="$(grep -F -- "$ANDROID_SERIAL " <<<"$list" || true)"
    [[ -n "$list" ]] || fail "adb finds no phone${ANDROID_SERIAL:+ $ANDROID_SERIAL}: connect it by USB and turn USB debugging on in its developer options"
    [[ "$(wc -l <<<"$list")" -eq 1 ]] || fail "adb finds several phones; choose one by ANDROID_SERIAL:"$'\n'"$list"
    state="${list#* }"
    case "$state" in
        device*) ;;
        unauthorized*) fail "the phone does not trust this computer yet: answer the question on its screen, then run this again" ;;
        *) fail "the phone is '$state': unlock it, or take the cable out and in again" ;;
    esac
}

install_apk() {
    if [[ -z "$apk" ]]; then
        local built=() candidate
        for candidate in "$root/build/android/vct.apk" "$root/app/build/outputs/apk/debug/app-debug.apk"; do
            [[ -f "$candidate" ]] && built+=("$candidate")
        done
        [[ ${#built[@]} -gt 0 ]] || fail "there is no APK yet: scripts/apk.sh or ./gradlew assembleDebug builds one"
        apk="${built[0]}"
        [[ ${#built[@]} -eq 1 || ! "${built[1]}" -nt "$apk" ]] || apk="${built[1]}"
    fi
    [[ -f "$apk" ]] || fail "there is no APK '$apk'"
    say "installing $apk"
    local text
    # Old versions of adb end with 0 even where the installation fails.
    if ! text="$(adb install -r "$apk" 2>&1)" || ! grep -q '^Success' <<<"$text"; then
        case "$text" in
            *UPDATE_INCOMPATIBLE*) fail "the phone has the app with another signature: adb uninstall $package (its results and scenes go with it), then run this again" ;;
            *NO_MATCHING_ABIS*) fail "the APK has no library for this phone's processor ($(on_phone getprop ro.product.cpu.abilist)): it is built for 64-bit ARM" ;;
            *) fail "installing failed: $text" ;;
        esac
    fi
}

push_scenes() {
    [[ $# -gt 0 ]] || fail "push needs at least one scene, .glb or .gltf"
    local scene text
    for scene in "$@"; do
        [[ -f "$scene" ]] || fail "there is no file '$scene'"
        [[ "$scene" == *.glb || "$scene" == *.gltf ]] || fail "'$scene' is neither .glb nor .gltf"
    done
    require_phone
    on_phone pm path "$package" | grep -q . || fail "the app is not installed: scripts/phone.sh install"
    on_phone mkdir -p "$files"
    for scene in "$@"; do
        text="$(adb push "$scene" "$files/" 2>&1)" || fail "cannot push '$scene': $text"
        say "pushed $(basename "$scene"); the app's list of scenes shows it when opened next"
    done
}

# Prints "done" or "failed", or nothing while it measures.
state_of_bench() { on_phone "cd $files/results 2>/dev/null && ls done failed 2>/dev/null" | head -n 1 || true; }
log_of_app() { adb logcat -d -s vct 2>/dev/null | tr -d '\r' || true; }

bench() {
    local arguments="bench" default argument
    for default in scene=cornell.glb preset=thesis size=400x400; do
        for argument in "$@"; do
            [[ "${argument%%=*}" != "${default%%=*}" ]] || continue 2
        done
        arguments+=" $default"
    done
    for argument in "$@"; do
        # The argument passes through two shells.
        [[ "$argument" =~ ^[a-z-]+=[A-Za-z0-9._,:=+-][A-Za-z0-9._,:=+\ -]*$ ]] ||
            fail "'$argument' is not KEY=VALUE of letters, digits, spaces and . _ , : = + -"
        arguments+=" $argument"
    done
    for argument in "${beside[@]}"; do
        [[ "$argument" == *=* && -f "${argument#*=}" ]] || fail "--beside '$argument' is not NAME=FILE with a file that is there"
    done
    require_phone
    install_apk
    local model
    model="$(on_phone getprop ro.product.model)"
    [[ -n "$out" ]] || out="$root/out/phone/${model//[^A-Za-z0-9._-]/_}"

    on_phone rm -rf "$files/results"
    adb logcat -c 2>/dev/null || true
    on_phone input keyevent KEYCODE_WAKEUP || true
    say "$model: $arguments (unlock the phone and leave it alone; at most $timeout_s s)"
    local text
    # -S, because a running app would not receive the new command.
    text="$(on_phone "am start -S -n $activity --es vct '$arguments'" 2>&1)" || fail "the app does not start: $text"
    [[ "$text" != *Error* && "$text" != *Exception* ]] || fail "the app does not start: $text"

    local start=$SECONDS state='' last='' line
    while true; do
        state="$(state_of_bench)"
        [[ -z "$state" ]] || break
        line="$(log_of_app | tail -n 1)"
        [[ "$line" == "$last" || "$line" == ---* ]] || say "$line"
        last="$line"
        adb get-state >/dev/null 2>&1 || fail "the connection to the phone was lost; the app goes on without it: run this again"
        if [[ -z "$(on_phone pidof "$package")" && -z "$(state_of_bench)" ]]; then
            log_of_app | tail -n 20 >&2
            adb logcat -d -b crash -t 40 >&2 || true
            fail "the app ended without a result; its last messages are above"
        fi
        if ((SECONDS - start >= timeout_s)); then
            on_phone am force-stop "$package"
            log_of_app | tail -n 20 >&2
            fail "no result after $timeout_s s; the app's last messages are above (--timeout gives it more time)"
        fi
        sleep "$poll_s"
    done

    # The results replace the old ones only when all have arrived.
    local partial="$out.partial"
    rm -rf "$partial"
    mkdir -p "$partial"
    text="$(adb pull "$files/results/." "$partial" 2>&1)" || fail "cannot fetch the results: $text"
    log_of_app >"$partial/log.txt"
    rm -rf "$out"
    mv "$partial" "$out"
    [[ "$state" != failed ]] || fail "the app could not measure: $(cat "$out/failed") ($out/log.txt has its log)"
    say "results of $((SECONDS - start)) s in $out"
    local measured=()
    for argument in bench.json timings.json; do
        [[ ! -f "$out/$argument" ]] || measured+=("$model=$out/$argument")
    done
    [[ ${#measured[@]} -gt 0 ]] || fail "the app reported success, but there is neither bench.json nor timings.json in $out"
    python3 "$root/tools/phone_tables.py" "${measured[@]}" "${beside[@]}"
}

case "$command" in
    install)
        [[ $# -eq 0 ]] || usage
        require_phone
        install_apk
        ;;
    push) push_scenes "$@" ;;
    bench) bench "$@" ;;
    *) usage ;;
esac
