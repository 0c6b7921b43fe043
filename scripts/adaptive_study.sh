#!/usr/bin/env bash
# Prints two tables of docs/adaptive.md, both counted by the RTL: cycles against phong, and pixels
# whose normal is not normalised.
# Usage: scripts/adaptive_study.sh SHADESIM SCENE...
set -euo pipefail
(($# >= 2)) || { sed -n 's/^# Usage: /Usage: /p' "$0" >&2; exit 2; }
shadesim=$1
shift

# run SCENE METHOD TOLERANCE BACKPRESSURE: triangles, spans, pixels, cycles, normalised, skipped.
run() {
  "$shadesim" cycles "$1" --method "$2" --tolerance "$3" --backpressure "$4" --size 1024x768 |
    awk '/ triangles, .* cycles/ {
           for (i = 1; i < NF; i++) {
             if ($(i+1) ~ /^triangles/) t = $i; if ($(i+1) ~ /^spans/) s = $i
             if ($(i+1) ~ /^pixels/) p = $i; if ($(i+1) ~ /^cycles/) c = $i
           }
         }
         / normalisations, / { n = $1; k = $3 }
         END { print t, s, p, c, n + 0, k + 0 }'
}

# A port that takes a pixel every N cycles makes phong as slow as a normaliser that is busy N cycles.
every() { printf '1%0*d' "$(($1 - 1))" 0; }

printf '| scene | triangles | pixels | pixels a span | phong | iterative, 4 | 8 | 14 | 24'
printf ' | adaptive | -paper | -chord |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n'
for scene; do
  read -r triangles spans pixels phong _ <<<"$(run "$scene" phong 0.5 none)"
  printf '| %s | %d | %d | %s | %s' "${scene##*/models/}" "$triangles" "$pixels" \
    "$(awk "BEGIN { printf \"%.1f\", $pixels / $spans }")" "$phong"
  for busy in 4 8 14 24; do
    read -r _ _ _ cycles _ <<<"$(run "$scene" phong 0.5 "$(every "$busy")")"
    printf ' | %d' "$cycles"
  done
  for method in adaptive adaptive-paper adaptive-chord; do
    read -r _ _ _ cycles _ <<<"$(run "$scene" "$method" 0.5 none)"
    printf ' | %d' "$cycles"
  done
  printf ' |\n'
done

printf '\n| scene | method | tolerance 0.5 | 1 | 2.55 | 10.2 |\n|---|---|--:|--:|--:|--:|\n'
for scene; do
  for method in adaptive adaptive-paper adaptive-chord; do
    printf '| %s | %s' "${scene##*/models/}" "$method"
    for tolerance in 0.5 1 2.55 10.2; do
      read -r _ _ pixels _ done skipped <<<"$(run "$scene" "$method" "$tolerance" none)"
      printf ' | %.1f %% (%d)' "$(awk "BEGIN { print 100 * $skipped / $pixels }")" "$done"
    done
    printf ' |\n'
  done
done
