#!/usr/bin/env bash
# Tests the real window on a virtual display with xdotool: pick, drag, type, save, reopen; and no frames while nothing happens.
# The log of frames and the session that the window saves tell what happened.
# Usage: window_smoke.sh MOMENTSCOPE
set -euo pipefail
momentscope=$(realpath "$1")
folder=$(mktemp -d)
cleanup() {
    kill "${window:-}" "${server:-}" 2>/dev/null || true
    rm -r "$folder"
}
trap cleanup EXIT
cd "$folder"   # the window's file dialog starts here
mkfifo display
Xvfb -displayfd 3 -screen 0 1280x800x24 3>display 2>/dev/null &
server=$!
read -r number <display
export DISPLAY=:$number

fail() {
    echo "$1"
    [ ! -s errors ] || cat errors
    tail -n 5 log || true
    exit 1
}
frames() { wc -l <log; }
open_window() {
    : >log
    "$momentscope" "$@" --log "$folder/log" 2>errors &
    window=$!
    for _ in $(seq 240); do
        sleep 0.25
        kill -0 "$window" 2>/dev/null || fail "The window closed."
        if grep -q plot log; then
            settle
            return 0
        fi
    done
    fail "The window drew no picture within a minute."
}
# Waits until no frame was drawn for half a second and none is being drawn.
settle() {
    local before=-1
    for _ in $(seq 120); do
        [ "$before" != "$(frames)" ] || [ "$(tail -n 1 log)" = "drawing…" ] || return 0
        before=$(frames)
        sleep 0.5
    done
    fail "The window never came to rest."
}
# Prints what the frames since line $1 computed.
since() { tail -n +"$(($1 + 1))" log; }

open_window --scene planes --technique trig2-32
before=$(frames)
sleep 5
[ "$(frames)" = "$before" ] || fail "The window drew frames though nothing happened."

xdotool mousemove 250 300 sleep 0.2 mousedown 1 sleep 0.2 mouseup 1
settle
since "$before" | grep -q "capture, plot" || fail "A click picked no pixel."

before=$(frames)
xdotool mousemove 300 500 sleep 0.2 mousedown 3 sleep 0.2 mousemove 380 520 sleep 0.2 mouseup 3
settle
since "$before" | grep -q "opaque, first pass" || fail "A drag did not orbit."

before=$(frames)
xdotool key l
settle
xdotool key ctrl+g
settle
xdotool type --delay 60 "100, 90"
xdotool key Return
settle
since "$before" | grep -q "capture, plot" || fail "A pixel was typed but not picked."

xdotool key ctrl+s
settle
xdotool key Return
settle
[ -s momentscope.json ] || fail "The session was not saved."
grep -q '"lens": true' momentscope.json || fail "The session does not know the lens."
xdotool mousemove 640 795 sleep 0.2 key Escape
settle
import -window root first.png
kill "$window"
wait "$window" 2>/dev/null || true

open_window --session momentscope.json
xdotool mousemove 640 795
settle
import -window root second.png
# Leave out the status line at the bottom, because its milliseconds differ.
differing=$(compare -metric AE -extract 1280x770+0+0 first.png second.png null: 2>&1 || true)
[ "$differing" = 0 ] || fail "The reopened session differs in $differing pixels."

# Resize and close a window in the middle of a drag.
xdotool mousemove 300 500 mousedown 3 sleep 0.1 mousemove 350 520
xdotool search --name Momentscope windowsize 700 420
sleep 0.5
xdotool mousemove 320 300 mouseup 3
settle
kill -0 "$window" || fail "Resizing closed the window."
xdotool mousemove 200 300 mousedown 1
xdotool search --name Momentscope windowclose || true
for _ in $(seq 40); do
    kill -0 "$window" 2>/dev/null || break
    sleep 0.25
done
echo "The window idled, picked, orbited, typed, saved, reopened the same, was resized and closed."
