#!/usr/bin/env bash
# shadesim bench as a person and a script meet it. Usage: bench_cli_test.sh SHADESIM
# shellcheck source=tests/cli/checks.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/checks.sh" "$1"

# Every bad input has a name and a remedy, and leaves nothing behind.
refuse 'out' bench
refuse 'out' bench builtin:sphere
refuse 'unknown method .rainbow.' bench --out o --methods quad,rainbow
refuse 'teapot' bench builtin:teapot --out o
refuse 'missing.obj' bench missing.obj --out o
refuse 'size' bench --out o --size 0x4
refuse 'jobs' bench --out o --jobs 0
refuse 'own name' bench mesh.obj --out o --markdown mesh.obj
echo '{"format":"something else"}' >other.json
refuse 'other.json.*synth.sh --json' bench builtin:sphere:3 --out o --synthesis other.json
echo '{"a":' >cut.json
refuse 'cut.json: not JSON at byte' bench builtin:sphere:3 --out o --synthesis cut.json
refuse 'absent.json: no such file.*synth.sh' bench builtin:sphere:3 --out o --synthesis absent.json
refuse 'no-such-folder' bench builtin:sphere:3 --out o --markdown no-such-folder/a.md
refuse 'not a folder|no folder' bench builtin:sphere:3 --out other.json
"$shadesim" verify builtin:sphere:3 --size 40x30 --triangles-out sphere.jsonl --quiet
head -n 1 sphere.jsonl >nothing.jsonl
refuse 'nothing.jsonl.*covers no pixel' bench nothing.jsonl --out o1 --methods flat --quick
check 'nothing half written' test ! -e o -a ! -e o1/report.html
check 'no temporary file' test "$(find . -name '*.tmp' | wc -l)" -eq 0

# A quick run on a tiny scene, all methods.
tiny=(bench builtin:sphere:3 --size 40x30 --quick --out out --jobs 2)
check 'a quick run succeeds' "$shadesim" "${tiny[@]}" --markdown tables.md --quiet
for file in report.html bench.json bench.csv bench-cells.jsonl; do check "$file" test -s out/$file; done
check 'the report is one whole page' grep -q '</html>' out/report.html
check 'the report loads nothing' test "$(grep -cE '(src|href)="(http|/|\.)' out/report.html)" -eq 0
check 'tables for the pages' grep -q '^## Run time against error' tables.md
lines=$(wc -l <out/bench.csv)
methods=$("$shadesim" list | sed -n '/^Methods/,/^$/p' | grep -c '^  ')
check "a line for every method, n and lane: $lines for $methods methods" \
  test "$lines" -gt $((methods * 4 * 2))
while read -r name _; do
  check "$name was measured" grep -q ",$name," out/bench.csv
done < <("$shadesim" list | sed -n '/^Methods/,/^$/p' | grep '^  ')
check 'cycles are the sum of their kinds' \
  awk -F, 'NR > 1 && $9 != $10 + $11 + $12 + $13 { exit 1 } END { exit NR < 100 }' out/bench.csv

# Stopped after some of the work, a run goes on and comes to the same counts and errors.
counts() { cut -d, -f1-16,20- "$1"; }
counts out/bench.csv >first.txt
kept=50
head -n $((kept + 1)) out/bench-cells.jsonl >cut.jsonl
head -c 100 <(tail -n 1 out/bench-cells.jsonl) >>cut.jsonl
mv cut.jsonl out/bench-cells.jsonl
rm out/report.html
"$shadesim" "${tiny[@]}" >again.txt
check 'the run goes on' grep -q "kept $kept of" again.txt
"$shadesim" "${tiny[@]}" --methods flat >few.txt
check 'only what this run needs is kept' grep -q '^kept 8 of 8 measurements and 2 of 2 curves' few.txt
check 'curves are no measurements' grep -q '^8 measurements, 2 curves' few.txt
rm out/report.html
"$shadesim" "${tiny[@]}" --quiet
check 'the report is there again' test -s out/report.html
counts out/bench.csv >second.txt
check 'the same counts and errors' cmp first.txt second.txt
"$shadesim" "${tiny[@]}" --fresh >fresh.txt
check '--fresh measures anew' test "$(grep -c kept fresh.txt)" -eq 0

# Some methods, and packets instead of a scene.
"$shadesim" verify builtin:saddle:2 --size 40x30 --triangles-out saddle.jsonl --quiet
check 'packets and a list of methods' "$shadesim" bench saddle.jsonl --quick --methods slerp,flat --out p --quiet
check 'only these' test "$(cut -d, -f2 p/bench.csv | sort -u | tr '\n' ' ')" = 'flat method slerp '

# A disk that is full.
if [[ -c /dev/full ]]; then
  mkdir full && ln -s /dev/full full/bench-cells.jsonl
  refuse 'free some space|could not be written' bench builtin:sphere:3 --size 40x30 --quick --methods flat --out full
  check 'no report on a full disk' test ! -e full/report.html
fi

summary 40
