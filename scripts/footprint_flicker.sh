#!/usr/bin/env bash
# Turns a panel and a cylinder, both seen at a slant, by 60 small steps, and prints how much a covered pixel
# changes from frame to frame, centre-only (phong) and as the mean over its footprint, as the table of
# docs/footprint.md; draws docs/images/footprint.png. An extra: it needs oiiotool (apt-get install
# openimageio-tools). Usage: scripts/footprint_flicker.sh [SHADESIM]
set -euo pipefail
CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

shadesim=${1:-build/release/bin/shadesim}
readonly steps=60 step=0.05 size=96  # step in degrees
if ! command -v oiiotool >/dev/null; then
  echo "Skipped: the pictures need oiiotool (apt-get install openimageio-tools)."
  exit 0
fi
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT

scene_options() {  # of the scene: what is drawn, how it is seen, from where it is lit
  case $1 in
    panel) echo "builtin:panel:8 --light 0.045,0.123,-0.991" ;;
    cylinder) echo "builtin:cylinder:16 --light 0.133,-0.048,-0.99" ;;
  esac
}
pitch() { case $1 in panel) echo -86 ;; cylinder) echo 78 ;; esac; }

draw() {  # draw SCENE METHOD ENGINE FRAME FILE
  local yaw
  yaw=$(awk "BEGIN { print 20 + $4 * $step }")
  # shellcheck disable=SC2046  # the options are words
  "$shadesim" render $(scene_options "$1") --size ${size}x$size --rotate "$yaw,$(pitch "$1")" \
    --method "$2" --engine "$3" -o "$5" --json "${5%.png}.json" --quiet
}

# Mean of |a - b| over the channels, codes of all pixels of the picture.
difference() {
  oiiotool "$1" --ch R,G,B "$2" --ch R,G,B --absdiff --printstats |
    awk '/Stats Avg/ { print 255 * ($3 + $4 + $5) / 3 }'
}
covered() { sed -n '0,/^  "pixels": /s/^  "pixels": \([0-9]*\).*/\1/p' "$1"; }

# flicker SCENE METHOD ENGINE: mean and largest change a frame, codes of a covered pixel.
flicker() {
  local k last=$work/a.png next=$work/b.png
  draw "$1" "$2" "$3" 0 "$last"
  for ((k = 1; k <= steps; k++)); do
    draw "$1" "$2" "$3" $k "$next"
    echo "$(difference "$last" "$next") $(covered "${next%.png}.json")"
    mv -- "$next" "$last"
  done | awk -v all=$((size * size)) '{ v = $1 * all / $2; sum += v; if (v > most) most = v }
              END { printf "%.3f, %.3f", sum / NR, most }'
}

echo '| scene | centre only | footprint | exact mean over the footprint |'
echo '|---|--:|--:|--:|'
for scene in panel cylinder; do
  echo "| $scene | $(flicker $scene phong model) | $(flicker $scene footprint model) | $(
    flicker $scene footprint ideal) |"
done

files=()
for scene in panel cylinder; do
  for method in phong footprint; do
    draw $scene $method model 30 "$work/$scene-$method.png"
    files+=("$work/$scene-$method.png")
  done
done
oiiotool "${files[@]}" --mosaic:pad=4 4x1 --resize:filter=box 1188x288 \
  --pattern constant:color=0.25,0.25,0.25,1 1188x288 4 --over --ch R,G,B -o docs/images/footprint.png
