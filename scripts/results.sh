#!/usr/bin/env bash
# Measures everything that docs/results.md says and writes that page; see usage() below.
set -euo pipefail

usage() {
  cat <<'EOF'
Usage: scripts/results.sh [OPTION...]

Runs shadesim verify, cycles, render, bench and stress and shading_unit_bench, then fills
docs/results.in.md with what they wrote: docs/results.md, which says how long each command took.
A run that was stopped goes on where it was, as long as the programs are the same.

  --quick       fewer triangles, smaller pictures, shorter searches; the page says so
  --smoke       four methods and the least of everything, to see that it works; with --page
  --fresh       measure anew what an earlier run left
  --list        print the commands, run nothing
  --out DIR     what the commands write (build/results)
  --page FILE   the page (docs/results.md)
  --bin DIR     built programs; without it build/release/bin, built first
  --jobs N      threads (all processors)
  --help

Tables of synthesis come from build/synth.json when that is of this RTL. It takes an hour:
  scripts/synth.sh --json build/synth.json
EOF
}

fail() { printf 'results.sh: %s\n' "$1" >&2; exit 2; }

level=full fresh='' list='' out=build/results page='' bin='' jobs=$(nproc)
while (($#)); do
  case $1 in
    --quick | --smoke) level=${1#--}; shift ;;
    --fresh) fresh=1; shift ;;
    --list) list=1; shift ;;
    --out | --page | --bin | --jobs)
      [[ -n ${2:-} ]] || fail "$1 takes a value; see --help"
      printf -v "${1#--}" %s "$2"
      shift 2 ;;
    --help) usage; exit 0 ;;
    *) fail "unknown option '$1'; see --help" ;;
  esac
done
[[ $level != smoke || -n $page || -n $list ]] || fail '--smoke is no result: name another --page'
[[ $jobs =~ ^[1-9][0-9]*$ ]] || fail "--jobs takes a number, not '$jobs'"
# Names relative to where the caller is; the commands run in the project's folder.
[[ -z $page ]] || page=$(realpath -m -- "$page")
[[ -z $bin ]] || bin=$(realpath -m -- "$bin")
[[ $out == build/results ]] || out=$(realpath -m -- "$out")
CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."
page=${page:-docs/results.md}

methods=all demo=(builtin:mixed --size 960x720) random=20000 seconds=0.3 filter=.
scenes=(builtin:triangle builtin:sphere:24 builtin:torus:16 builtin:saddle builtin:mixed)
bench=() stress=() stress_status=0 meshes=()
models=/usr/share/assimp/models  # assimp-testmodels
if [[ -d $models ]]; then
  meshes=("$models/STL/Wuson.stl" "$models/PLY/Wuson.ply" "$models/OBJ/spider.obj")
  bench=(builtin:mixed builtin:sphere:24 builtin:torus:16 "${meshes[0]}" "${meshes[2]}")
  bench+=(--size 320x240)
fi
case $level in
  quick)
    scenes=(builtin:sphere:12 builtin:torus:12 builtin:saddle:8 --size 160x120)
    demo=(builtin:mixed --size 320x240) random=2000 seconds=0.05 bench=(--quick) stress=(--quick)
    ((${#meshes[@]} == 0)) || meshes+=(--size 96x72) ;;
  smoke)
    methods=flat,phong,slerp-paper,footprint
    scenes=(builtin:sphere:3 --size 40x30) demo=("${scenes[@]}") meshes=()
    random=20 seconds=0.001 filter='/flat$'
    bench=("${scenes[@]}" --quick --methods "$methods")
    stress=(--quick --narrow reciprocal_sqrt) stress_status=1 ;;
esac

if [[ -z $list ]]; then
  if [[ -z $bin ]]; then
    scripts/setup.sh shadesim results_page shading_unit_bench
    bin=build/release/bin
  fi
  for program in shadesim results_page shading_unit_bench; do
    [[ -x $bin/$program ]] || fail "$bin/$program: no such program; build the target $program"
  done
  mkdir -p -- "$out" || fail "$out: cannot be made a folder"
  # What is kept is kept for these programs only.
  [[ -z $fresh ]] || rm -f -- "$out"/{bench/bench-cells,stress/stress-parts}.jsonl
  programs=$(sha256sum -- "$bin/shadesim" "$bin/shading_unit_bench" | cut -d' ' -f1 | tr '\n' ' ')
fi

steps=()
# step FILE STATUS PROGRAM ARGS...: PROGRAM writes FILE and ends with STATUS.
step() {
  local file=$1 expected=$2 program=$3
  shift 3
  local command="$program $*" stamp=$out/${file//\//-}.step status=0 start=$SECONDS old_key=
  if [[ -n $list ]]; then
    printf '%s\n' "$command"
    return
  fi
  if [[ -z $fresh && -s $out/$file && -s $stamp ]]; then read -r old_key <"$stamp"; fi
  if [[ $old_key == "$programs$command" ]]; then
    printf 'kept   %s\n' "$command"
  else
    printf 'runs   %s\n' "$command"
    rm -f -- "$stamp"
    # Progress goes to the terminal; the benchmark has none, and its stderr is on the page, too.
    if [[ $program == shading_unit_bench ]]; then
      "$bin/$program" "$@" >"$out/log" 2>&1 || status=$?
    else
      "$bin/$program" "$@" >"$out/log" || status=$?
    fi
    if ((status != expected)); then
      tail -n 20 -- "$out/log" >&2
      fail "'$command' ended with $status, not $expected; the page is not written"
    fi
    printf '%s\n%s\n' "$programs$command" "$((SECONDS - start))" >"$stamp"
  fi
  steps+=("{\"file\": \"$file\", \"command\": \"$command\", \"seconds\": $(tail -n 1 -- "$stamp")}")
}

# verify NAME ARGS...: with one lane and four.
verify() {
  local name=$1 lanes
  shift
  for lanes in 1 4; do
    step "verify-$name-$lanes.json" 0 shadesim verify "$@" --method "$methods" --lanes $lanes \
      --backpressure random --json "$out/verify-$name-$lanes.json" --jobs "$jobs"
  done
}

for lighting in blinn phong; do
  verify "scenes-$lighting" "${scenes[@]}" --lighting $lighting
  ((${#meshes[@]} == 0)) || verify "meshes-$lighting" "${meshes[@]}" --lighting $lighting
done
verify random --random "$random"
for lanes in 1 4; do
  step cycles-$lanes.json 0 shadesim cycles "${demo[@]}" --method "$methods" --lanes $lanes \
    --json "$out/cycles-$lanes.json" --jobs "$jobs"
done
step errors.json 0 shadesim render "${demo[@]}" --method "$methods" -o "$out/demo.png" \
  --json "$out/errors.json" --jobs "$jobs"
step bench/bench.json 0 shadesim bench "${bench[@]}" --out "$out/bench" --jobs "$jobs"
step stress/stress.json $stress_status shadesim stress "${stress[@]}" --out "$out/stress" \
  --jobs "$jobs"
# Every bound must break with a bit less: status 1.
narrow=(--quick --narrow all)
[[ $level != smoke ]] || narrow=("${stress[@]}")
step narrow/stress.json 1 shadesim stress "${narrow[@]}" --out "$out/narrow" --jobs "$jobs"
step speed.json 0 shading_unit_bench --benchmark_min_time=$seconds "--benchmark_filter=$filter" \
  "--benchmark_out=$out/speed.json"
[[ -z $list ]] || exit 0

# The RTL that scripts/synth_record.mjs has the hash of.
rtl_hash() {
  local file
  find rtl -name '*.sv' -printf '%f %p\n' | LC_ALL=C sort | while read -r name file; do
    printf '%s\0' "$name"
    sed 's#//.*$##' -- "$file"  # comments do not count
    printf '\0'
  done | sha256sum | cut -d' ' -f1
}

synthesis=build/synth.json note=''
if [[ ! -s $synthesis ]]; then
  synthesis='' note='Not synthesised for this page: scripts/synth.sh --json build/synth.json does it.'
elif [[ $(grep -o '"rtl": "[0-9a-f]*"' "$synthesis" | cut -d'"' -f4) != "$(rtl_hash)" ]]; then
  synthesis='' note='Not synthesised for this page: build/synth.json is of another RTL.'
fi

revision=$(git rev-parse --short=12 HEAD 2>/dev/null || echo unknown)
# Pages may differ: this one is about to.
changes=$(git status --porcelain -- . ':!docs' 2>/dev/null || true)
[[ -z $changes ]] || revision+=' with changes'
quick=$([[ $level == full ]] && echo false || echo true)
{
  printf '{"format": "shadesim-results", "version": 1, "revision": "%s", "quick": %s,\n' \
    "$revision" "$quick"
  printf ' "synthesis": "%s", "synthesis_note": "%s",\n "steps": [\n' "$synthesis" "$note"
  (IFS=$'\n'; sed '$!s/$/,/' <<<"${steps[*]}")
  printf ']}\n'
} >"$out/run.json"

"$bin/results_page" docs/results.in.md "$out" "$page"
echo "$page"
