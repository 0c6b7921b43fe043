#!/usr/bin/env bash
# Draws docs/images/methods.png, a sphere by five methods and their errors, and prints the errors as the
# table of docs/accuracy.md. An extra: it needs oiiotool (apt-get install openimageio-tools), as nothing
# else of the project does. Usage: scripts/methods_picture.sh [SHADESIM]
set -euo pipefail
CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

shadesim=${1:-build/release/bin/shadesim}
if ! command -v oiiotool >/dev/null; then
  echo "Skipped: the picture needs oiiotool (apt-get install openimageio-tools)."
  exit 0
fi
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT

draw() {  # draw METHOD [OPTION...]: the picture, its error map and its errors
  local method=$1
  shift
  "$shadesim" render builtin:sphere:5 --rotate 25,35 --size 256x256 --engine model --method "$method" \
    -o "$work/$method.png" --error-map "$work/$method-error.png" --json "$work/$method.json" --quiet "$@"
}

value() {  # value METHOD KEY FORMAT: of the whole run
  # shellcheck disable=SC2059  # the format is the point
  printf "$3" "$(sed -n "0,/^  \"$2\": /s/^  \"$2\": \([0-9.e+-]*\).*/\1/p" "$work/$1.json")"
}

row() {  # row LABEL METHOD
  printf '| %s | %s | %s | %s |\n' "$1" "$(value "$2" max_error_lsb %.2f)" \
    "$(value "$2" rms_error_lsb %.2f)" "$(value "$2" closed_form_max_error_lsb %.2f)"
}

for method in phong slerp slerp-intensity phong-taylor gouraud; do draw $method; done
draw slerp-paper --fraction-bits 16

files=()
for suffix in '' -error; do
  for method in phong slerp slerp-paper phong-taylor gouraud; do
    files+=("$work/$method$suffix.png")
  done
done
oiiotool "${files[@]}" --mosaic:pad=8 5x2 \
  --pattern constant:color=0.25,0.25,0.25,1 1312x520 4 --over --ch R,G,B -o docs/images/methods.png

echo '| method | max | RMS | against its closed form: max |'
echo '|---|--:|--:|--:|'
row phong phong
row slerp slerp
row slerp-intensity slerp-intensity
row 'slerp-paper, 16 bits' slerp-paper
row phong-taylor phong-taylor
row gouraud gouraud
