#!/usr/bin/env bash
# Runs four shards of a chart and of a stress run in separate processes and merges them. Everything that does not depend on the
# clock must equal the run in one piece, byte for byte. Then a chart is killed half-way and continues.
# Usage: shards.sh MOMENTSCOPE
set -euo pipefail
momentscope=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cd "$folder"

fail() {
    echo "$1"
    exit 1
}
# Runs its arguments four times, two at a time, and replaces {} by 1 to 4.
in_parallel() {
    if command -v parallel >/dev/null; then
        parallel --will-cite -j2 "$@" ::: 1 2 3 4
    else
        printf '%s\n' 1 2 3 4 | xargs -P2 -I{} "$@"
    fi
}
# The columns of a chart after the times, and all its settings.
without_times() { sed 's/^\("[^"]*","[^"]*"\)\(,[^,]*\)\{10\}/\1/' "$1"; }

chart=("$momentscope" chart --scene "planes,ties" --size 48x27 --repeat 1 --technique "unsorted,at,power4-32")
in_parallel "${chart[@]}" --shard {}/4 -o chart-{}.csv >/dev/null
"$momentscope" merge chart-3.csv chart-1.csv chart-4.csv chart-2.csv -o merged.csv >/dev/null
"${chart[@]}" -o whole.csv >/dev/null
diff <(without_times merged.csv) <(without_times whole.csv) || fail "Merged shards of the chart differ from the whole."
[ "$(grep -c '^"' merged.csv)" -gt 8 ] || fail "The chart has too few rows."

stress=("$momentscope" stress --technique "power4-32,trig3-16" --condition "two,nodes,ties" --rays 20)
in_parallel "${stress[@]}" --shard {}/4 -o stress-{}.csv >/dev/null
"$momentscope" merge stress-*.csv -o stress.csv >/dev/null
"${stress[@]}" -o stress-whole.csv >/dev/null
diff stress.csv stress-whole.csv || fail "Merged shards of the stress run differ from the whole."

refused() {
    local part=$1
    shift
    if "$@" >/dev/null 2>errors; then fail "Not refused: $*"; fi
    grep -q "$part" errors || fail "Another refusal than '$part': $(cat errors)"
}
refused "Shard 4/4 is missing" "$momentscope" merge chart-1.csv chart-2.csv chart-3.csv -o x.csv
refused "are both shard 1/4" "$momentscope" merge chart-1.csv chart-1.csv chart-2.csv chart-3.csv -o x.csv
refused "belongs to another run" "$momentscope" merge chart-1.csv stress-2.csv -o x.csv
refused "not of chart" "$momentscope" merge stress-whole.csv -o x.html
for kind in md svg html png; do
    "$momentscope" merge merged.csv -o "merged.$kind" >/dev/null
    [ -s "merged.$kind" ] || fail "No $kind came of the merged chart."
done

# Kill it as soon as some rows are kept, without a chance to stop cleanly.
"${chart[@]}" -o killed.csv >/dev/null &
running=$!
for _ in $(seq 600); do
    [ ! -s killed.csv.partial ] || break
    sleep 0.02
done
kill -KILL "$running" 2>/dev/null || true
wait "$running" 2>/dev/null || true
[ -s killed.csv.partial ] || [ -s killed.csv ] || fail "The killed chart kept nothing."
cp killed.csv.partial before 2>/dev/null || : >before
"${chart[@]}" -o killed.csv >/dev/null
[ ! -e killed.csv.partial ] || fail "The unfinished chart was left behind."
while IFS= read -r row; do grep -qxF -- "$row" killed.csv || fail "A kept row was lost: $row"; done <before
diff <(without_times killed.csv) <(without_times whole.csv) || fail "The chart that went on differs from the whole."
echo "Shards make the whole, wrong ones are refused, and a killed chart went on from $(grep -c '^"' before || true) rows."
