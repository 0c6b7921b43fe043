#!/usr/bin/env bash
# Builds the program, renders a picture on the RTL and compares RTL and model on the same scene.
set -euo pipefail
CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")"

scripts/setup.sh shadesim

shadesim=build/release/bin/shadesim
picture=out/demo.png
mkdir -p "$(dirname "$picture")"

echo "Rendering a scene with the quad method on the RTL"
"$shadesim" render builtin:mixed --method quad --engine rtl -o "$picture" --size 960x720

echo "Comparing RTL and model on every method, with random back-pressure"
"$shadesim" verify builtin:mixed --method all --backpressure random

echo "The picture is $PWD/$picture"
