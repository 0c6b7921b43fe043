#!/usr/bin/env bash
# Meshes of other people, by every method: RTL = model. Usage: models_test.sh SHADESIM; exit 77 skips.
set -euo pipefail
shadesim=$1
models=/usr/share/assimp/models
if [[ ! -d $models ]]; then
  echo "Skipped: $models is missing (apt-get install assimp-testmodels)."
  exit 77
fi
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
cd -- "$work"
for model in STL/Wuson.stl PLY/Wuson.ply OBJ/spider.obj; do
  "$shadesim" verify "$models/$model" --method all --size 96x72 --quiet --json verdict.json
  pixels=$(grep -m1 '"pixels_compared"' verdict.json | tr -dc 0-9)
  echo "$model: $pixels pixels compared"
  ((pixels > 10000))
done
