#!/usr/bin/env bash
# shadesim stress as a person and a script meet it. Usage: stress_cli_test.sh SHADESIM
# shellcheck source=tests/cli/checks.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/checks.sh" "$1"

refuse 'out' stress
refuse 'no unit of that name' stress --out o --narrow teapot
refuse 'cannot be read' stress --replay missing.jsonl
refuse 'jobs' stress --out o --jobs 0
echo '{"format":"something else"}' >other.json
refuse 'not a case' stress --replay other.json
refuse 'not a folder' stress --out other.json

status=0
"$shadesim" stress --quick --narrow reciprocal_sqrt --out narrow --quiet >narrow.txt || status=$?
check 'a bit less exits with 1' test "$status" -eq 1
check 'and names the unit' grep -q 'reciprocal_sqrt.*BROKEN' narrow.txt
status=0
"$shadesim" stress --replay narrow/reciprocal_sqrt.worst.jsonl >again.txt || status=$?
check 'its case breaks the bound again' test "$status" -eq 1
check 'the page is whole' grep -q '</html>' narrow/report.html
check 'the numbers are there' grep -q '"broken": true' narrow/stress.json

status=0
"$shadesim" stress --quick --narrow surface_fit --out shape --quiet >/dev/null || status=$?
check 'one bit less of surface_fit' test "$status" -eq 1
check 'its triangle can be drawn' "$shadesim" render shape/surface_fit.worst.triangles.jsonl \
  --method quad -o t.png --quiet

# Parts that an earlier run finished are taken from the folder.
value='{"error":123.5,"genes":[0.5,0.5],"evaluations":7}'
line="{\"id\":\"unit reciprocal_sqrt narrow=1\",\"value\":$value}"
mkdir kept
"$shadesim" stress --narrow reciprocal_sqrt --out kept --quiet >/dev/null &
full=$!
for _ in $(seq 100); do
  if test -s kept/stress-parts.jsonl; then break; fi
  sleep 0.1
done
kill "$full"
wait "$full" 2>/dev/null
check 'a run that is stopped leaves its parts' grep -q fingerprint kept/stress-parts.jsonl
echo "$line" >>kept/stress-parts.jsonl
"$shadesim" stress --narrow reciprocal_sqrt --out kept >kept.txt
check 'what was finished is kept' grep -q 'kept 1 of 1 parts' kept.txt
check 'and shown' grep -q '123.5' kept.txt

summary 15
