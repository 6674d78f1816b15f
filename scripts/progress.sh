# For other scripts to source: progress of commands that print nothing, and commands that end with the script.

# with_progress TEXT COMMAND...: runs a command, and prints the text with the seconds so far every 8 s.
with_progress() {
    local text="$1" start=$SECONDS status=0 done
    shift
    # The reporter ends when its pipe is closed, even if a signal ends this script. A status above 128 means that the time is over.
    exec {done}> >(until read -r -t 8 || (($? <= 128)); do echo "$text: $((SECONDS - start)) s so far"; done)
    "$@" {done}>&- || status=$?
    exec {done}>&-
    return "$status"
}

# stoppable COMMAND...: runs a command without a terminal. A signal that ends the script ends it and all that it started, too.
stoppable() {
    local status=0
    setsid "$@" </dev/null &
    stoppable_child=$!
    trap 'kill -TERM -- "-$stoppable_child" 2>/dev/null; wait "$stoppable_child"; exit 143' INT TERM HUP
    wait "$stoppable_child" || status=$?
    trap - INT TERM HUP
    return "$status"
}
