#!/usr/bin/env bash
# Seeds one fault after another and shows by what it is caught; exit 1 if one is not caught.
#
#   tests/faults/run.sh [PATTERN [METHODS]]
#
# PATTERN   only faults whose name or file matches, a regular expression; none that does is an error
# METHODS   what shadesim verify runs, with commas: all
#
# Faults in rtl/ must be stopped by lint, make an assertion of the RTL fail or make `shadesim verify`
# exit with 1, without or with back-pressure, with one lane or four. Faults in model/ change RTL and
# model alike, so the unit tests of the front end must catch them. Works on a copy in build/faults, a
# debug build: one to three minutes a fault.
set -uo pipefail
CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." || exit 2
readonly copy=build/faults/source tree=build/faults/build log=build/faults/log
readonly pattern=${1:-.} methods=${2:-all} faults=tests/faults/faults.txt

# chosen NAME FILE: whether the fault is to be seeded.
chosen() { [[ $1 != \#* && ($1 =~ $pattern || $2 =~ $pattern) ]]; }
count=0
while IFS=';' read -r name file _; do chosen "$name" "$file" && ((++count)); done <"$faults"
if ((count == 0)); then
  echo "no fault in $faults matches '$pattern'" >&2
  exit 2
fi

rm -rf -- "$copy"  # an interrupted run may have left a fault in it
mkdir -p "$copy"
git ls-files -z --cached --others --exclude-standard | xargs -0 cp --parents -t "$copy" || exit 2
build() { cmake --build "$tree" --target "$@" >"$log" 2>&1 </dev/null; }

# verify FLOW LANES: the exit status of shadesim verify, 124 when it does not end.
verify() {
  (cd build/faults && timeout 300 build/bin/shadesim verify --random 400 --method "$methods" \
    --backpressure "$1" --lanes "$2" --json verdict.json >verify.log 2>&1 </dev/null)
}

# The sound design must build and pass, or nothing below would mean anything.
cmake -S "$copy" -B "$tree" -G Ninja -DCMAKE_BUILD_TYPE=Debug >"$log" 2>&1 &&
  build shadesim span_walker_test triangle_setup_test && verify none 1 && verify random 1 &&
  verify none 4 && verify random 4 || {
  echo "The design without a fault does not build or pass; see $log" >&2
  exit 2
}

# Print how the fault is caught, or nothing.
catch_in_rtl() {
  if ! build shadesim; then
    # Only Verilator's own verdict counts; any other broken build is an error of the fault.
    grep -m1 -oE '%Warning-[A-Z]+' "$log" | sed 's/%Warning-/lint: /'
    return
  fi
  local flow lanes
  for lanes in 1 4; do
    for flow in none random; do
      verify $flow $lanes
      case $? in
        1) echo "verify, back-pressure $flow, lanes $lanes: $(summary)"; return ;;
        134) assertion && return ;;
      esac
    done
  done
}

assertion() {
  grep -m1 -oE 'Assertion failed.*' build/faults/verify.log | sed 's/.*: /assertion: /' | grep .
}

summary() {
  local pixels cycles
  pixels=$(grep -m1 '"pixel_mismatches"' build/faults/verdict.json | tr -dc 0-9)
  cycles=$(grep -m1 '"cycle_mismatches"' build/faults/verdict.json | tr -dc 0-9)
  if grep -q 'nothing moved until' build/faults/verify.log; then
    echo "deadline (nothing moved)"
  elif ((pixels + cycles > 0)); then
    echo "$pixels pixels, $cycles spans in other cycles"
  else
    echo "performance counters"
  fi
}

catch_in_model() {
  build span_walker_test triangle_setup_test || return
  local test
  for test in span_walker triangle_setup; do
    "$tree/bin/${test}_test" >"$log" 2>&1 </dev/null && continue
    grep -m1 -oE 'FAILED  \] [^ ,]*' "$log" | cut -c 11- | sed 's/^ *//'
    return
  done
}

missed=0 seeded=0
printf '| fault | file | caught by |\n|---|---|---|\n'
while IFS=';' read -r -u 3 name file command; do
  chosen "$name" "$file" || continue
  ((++seeded))
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
done 3<"$faults"
echo "$seeded of $(grep -vc '^#' "$faults") faults seeded" >&2
exit "$missed"
