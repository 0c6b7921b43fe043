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

summary 10
