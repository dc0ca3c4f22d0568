#!/usr/bin/env bash
# The real window on a virtual display: it opens, a click picks another pixel, the slider of beta moves, and it lives on.
# Usage: window_smoke.sh MOMENTSCOPE
set -euo pipefail
momentscope=$1
folder=$(mktemp -d)
cleanup() {
    kill "${window:-}" "${server:-}" 2>/dev/null || true
    rm -r "$folder"
}
trap cleanup EXIT
mkfifo "$folder/display"
Xvfb -displayfd 3 -screen 0 1280x800x24 3>"$folder/display" 2>/dev/null &
server=$!
read -r number <"$folder/display"
export DISPLAY=:$number
"$momentscope" --scene planes --technique trig2-32 2>"$folder/errors" &
window=$!

# Waits until the picture has at least $1 colours and, if given, differs from file $2. The picture goes to $folder/now.png.
wait_for_picture() {
    for _ in $(seq 120); do
        sleep 0.5
        kill -0 "$window" 2>/dev/null || { echo "The window closed: $(cat "$folder/errors")"; exit 1; }
        import -window root "$folder/now.png" 2>/dev/null || continue
        [ "$(identify -format %k "$folder/now.png")" -ge "$1" ] || continue
        [ -z "${2:-}" ] || ! compare -metric AE "$folder/now.png" "$2" null: >/dev/null 2>&1 || continue
        return 0
    done
    echo "The window did not show what was expected."
    exit 1
}

wait_for_picture 100
cp "$folder/now.png" "$folder/first.png"
xdotool mousemove 250 300 sleep 0.3 mousedown 1 sleep 0.3 mouseup 1
wait_for_picture 100 "$folder/first.png"
cp "$folder/now.png" "$folder/second.png"
xdotool mousemove 300 500 sleep 0.3 mousedown 3 sleep 0.3 mousemove 380 520 sleep 0.3 mouseup 3
wait_for_picture 100 "$folder/second.png"
kill -0 "$window"
echo "The window opened, picked and orbited."
