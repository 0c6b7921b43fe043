#!/usr/bin/env bash
# Seeds one fault after another and shows by what it is caught; exit 1 if one is not caught.
# Usage: tests/faults/run.sh [PATTERN]      only faults whose name matches
#
# Faults in rtl/ must be caught by `shadesim verify` alone. Faults in model/ change RTL and model
# alike, so the unit tests of the front end must catch them. Works on a copy in build/faults, a
# debug build: about 20 s a fault.
set -uo pipefail
CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." || exit 2
readonly copy=build/faults/source tree=build/faults/build log=build/faults/log
pattern=${1:-.}

mkdir -p "$copy"
git ls-files -z --cached --others --exclude-standard | xargs -0 cp --parents -u -t "$copy" || exit 2
build() { cmake --build "$tree" --target "$@" >"$log" 2>&1; }
cmake -S "$copy" -B "$tree" -G Ninja -DCMAKE_BUILD_TYPE=Debug >"$log" 2>&1 || {
  cat "$log"
  exit 2
}

# Prints how the faulty build is caught, or nothing.
catch_in_rtl() {
  build shadesim || { echo "lint or build: $(grep -m1 -oE '%(Error|Warning)[^:]*|error:.*' "$log")"; return; }
  local flow
  for flow in none random; do
    (cd build/faults && timeout 120 build/bin/shadesim verify --random 1500 --method all \
      --backpressure $flow --json verdict.json >verify.log 2>&1)
    local status=$?
    ((status == 0)) && continue
    ((status == 1)) || { echo "verify, back-pressure $flow: exit status $status"; return; }
    echo "verify, back-pressure $flow: $(summary build/faults/verdict.json build/faults/verify.log)"
    return
  done
}

summary() {
  local pixels cycles
  pixels=$(grep -m1 '"pixel_mismatches"' "$1" | tr -dc 0-9)
  cycles=$(grep -m1 '"cycle_mismatches"' "$1" | tr -dc 0-9)
  if grep -q 'nothing moved until' "$2"; then
    echo "deadline (nothing moved)"
  elif ((pixels + cycles > 0)); then
    echo "$pixels pixels, $cycles spans in other cycles"
  else
    echo "performance counters"
  fi
}

catch_in_model() {
  build span_walker_test triangle_setup_test || { echo "build"; return; }
  local test
  for test in span_walker triangle_setup; do
    "$tree/bin/${test}_test" >"$log" 2>&1 && continue
    echo "$(grep -m1 -oE 'FAILED  \] [^ ,]*' "$log" | cut -c 12-)"
    return
  done
}

missed=0
printf '| fault | file | caught by |\n|---|---|---|\n'
while IFS=';' read -r -u 3 name file command; do
  [[ $name != \#* && $name =~ $pattern ]] || continue
  file=${file# }
  sed -i -- "${command# }" "$copy/$file"
  if [[ $(diff "$file" "$copy/$file" | grep -c '^>') -ne 1 ]]; then
    echo "fault '$name' does not change one line of $file" >&2
    missed=1
    cp -- "$file" "$copy/$file"
    continue
  fi
  if [[ $file == rtl/* ]]; then caught=$(catch_in_rtl); else caught=$(catch_in_model); fi
  printf '| %s | %s | %s |\n' "$name" "$file" "${caught:-**not caught**}"
  [[ -n $caught ]] || missed=1
  cp -- "$file" "$copy/$file"
done 3<tests/faults/faults.txt
exit "$missed"
