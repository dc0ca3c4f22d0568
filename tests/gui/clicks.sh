#!/usr/bin/env bash
# Checks that every click counts in the real window. xdotool clicks on lists, buttons and cards, every second time 80 ms after
# the mouse moved there and otherwise after 20 to 98 ms, so that clicks come in every part of a frame. The window must answer
# each click in time, without a further movement. While it draws a picture and says so, time does not count. Afterwards nothing
# may be drawn while nothing happens, and when the display is killed, a sentence and the session must be left.
# The log of frames tells what happened. A headless window of the same size tells where the controls are.
# Usage: clicks.sh MOMENTSCOPE [CLICKS [MILLISECONDS]], by default 100 clicks within 200 ms each. On a busy machine allow more
# time: a lost click is never answered at all.
set -euo pipefail
momentscope=$(realpath "$1")
clicks=${2:-100}
most=${3:-200}
settings=(--scene planes --technique trig2-32 --size 1280x800)
folder=$(mktemp -d)
cleanup() {
    kill "${window:-}" "${server:-}" 2>/dev/null || true
    rm -r "$folder"
}
trap cleanup EXIT
cd "$folder"

fail() {
    echo "$1"
    [ ! -s errors ] || cat errors
    tail -n 8 log 2>/dev/null || true
    exit 1
}

# Each control, and the log entry that answers its click; @again clicks at the same place once more. A round ends in the state
# in which it began.
steps=("@controls.technique:a popup opened" "@again:a popup closed" "@tab.3:changed /panel" "@scene.lens:changed /lens"
    "@scene.views:a popup opened" "@again:a popup closed" "@scene.lens:changed /lens" "@tab.1:changed /panel"
    "@controls.scene:a popup opened" "@again:a popup closed" "@card.order:changed .*/card" "@card.answer:changed /answer"
    "@card.answer:changed /answer" "@card.close:changed /card" "@scene.wipe:changed /compare" "@scene.wipe:changed /compare"
    "@menu.view:a popup opened" "@again:a popup closed")

# A card leaves other settings behind, so the second round represents all following ones.
rounds=$((clicks > ${#steps[@]} ? 2 : 1))
for ((round = 0; round < rounds; ++round)); do
    for step in "${steps[@]}"; do
        control=${step%%:*}
        if [ "$control" = @again ]; then echo "key Escape"; else printf 'where %s\nclick %s\nwait 1\n' "$control" "$control"; fi
    done
done >events
"$momentscope" --headless "${settings[@]}" --events events --log places 2>errors || fail "The headless window could not be clicked."
mapfile -t found < <(sed -n 's/^@.* is at //p' places)
places=()
for ((i = 0, next = 0; i < rounds * ${#steps[@]}; ++i)); do
    case ${steps[i % ${#steps[@]}]} in
        @again:*) places+=("${places[-1]}") ;;
        *) places+=("${found[next++]}") ;;
    esac
done

mkfifo display
Xvfb -displayfd 3 -screen 0 1280x800x24 3>display 2>/dev/null &
server=$!
disown "$server"   # so that the shell does not report its end
read -r number <display
export DISPLAY=:$number
export XDG_STATE_HOME=$folder/state
: >log
"$momentscope" "${settings[@]}" --log log 2>errors &
window=$!

now() { echo "${EPOCHREALTIME/[.,]/}"; }   # in microseconds
lines() { wc -l <log; }
settle() {
    local before=-1
    for _ in $(seq 300); do
        [ "$before" != "$(lines)" ] || return 0
        before=$(lines)
        sleep 0.2
    done
    fail "The window never came to rest."
}
for _ in $(seq 300); do
    kill -0 "$window" 2>/dev/null || fail "The window closed."
    ! grep -q plot log || break
    sleep 0.1
done
settle

# Does the log contain an answer like $2 after line $1?
answers() { tail -n +$(($1 + 1)) log | grep -q "$2"; }
# A long picture is announced, and its frame appears in the log when it is finished.
draws() { [ "$(tail -n 1 log)" = "drawing…" ]; }

answered=0
slowest=0
for ((i = 0; i < clicks; ++i)); do
    step=${steps[i % ${#steps[@]}]}
    at=${places[i < ${#places[@]} ? i : ${#steps[@]} + i % ${#steps[@]}]}
    before=$(lines)
    pause=$(printf '0.%03d' $((i % 2 == 0 ? 80 : 20 + 7 * i % 79)))
    # shellcheck disable=SC2086 # two numbers
    xdotool mousemove $at sleep "$pause" click 1
    from=$(now)
    taken=0
    until answers "$before" "${step#*:}" || [ "$taken" -gt $((most + 5000)) ]; do
        sleep 0.01
        ! draws || from=$(now)
        taken=$((($(now) - from) / 1000))
    done
    [ "$taken" -le "$slowest" ] || slowest=$taken
    if [ "$taken" -le "$most" ]; then
        answered=$((answered + 1))
    else
        echo "Click $((i + 1)), on ${step%%:*} at $at, had no answer within $most ms, but this after $taken ms:"
        tail -n +$((before + 1)) log
    fi
done
echo "$answered of $clicks clicks were answered within $most ms, the slowest after $slowest ms."
[ "$answered" = "$clicks" ] || fail "Clicks were late or lost."

settle
before=$(lines)
sleep 1
[ "$(lines)" = "$before" ] || fail "The window drew frames though nothing happened."

kill -9 "$server"
code=0
wait "$window" || code=$?
[ "$code" = 1 ] || fail "A killed display ended the window with code $code instead of 1."
saved=$(sed -n "s/.*--session '\(.*\)'.*/\1/p" errors)
[ -s "$saved" ] || fail "A killed display left no session."
"$momentscope" --headless --session "$saved" --screenshot again.png >/dev/null || fail "The session that was saved does not open."
echo "A killed display left a sentence and a session that opens."
