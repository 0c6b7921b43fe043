#!/usr/bin/env bash
# The command line as a person and a script meet it. Usage: cli_test.sh SHADESIM
# shellcheck source=tests/cli/checks.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/checks.sh" "$1"

# Every bad input has a name and a remedy.
refuse 'name a command: render'
refuse 'unknown command .render_nothing.' render_nothing
refuse 'see shadesim verify --help$' verify builtin:sphere --lanes 3
refuse 'see shadesim --help$' --no-such-option
refuse 'SCENE' verify
refuse 'SCENE' render -o a.png
refuse 'output' render builtin:sphere
refuse 'unknown method .rainbow.' verify builtin:sphere --method rainbow
refuse 'size' render builtin:sphere -o a.png --size 640
refuse 'size' render builtin:sphere -o a.png --size 0x480
refuse 'size' render builtin:sphere -o a.png --size 5000x10
refuse 'rotate' render builtin:sphere -o a.png --rotate 30
refuse 'light' render builtin:sphere -o a.png --light 1,2
refuse 'light' render builtin:sphere -o a.png --light 0,0,0
refuse 'light' render builtin:sphere -o a.png --light nan,0,1
refuse 'camera' render builtin:sphere -o a.png --camera fisheye
refuse 'engine' render builtin:sphere -o a.png --engine 7
refuse 'lighting' render builtin:sphere -o a.png --lighting 5
refuse 'cull' verify builtin:sphere --cull 9
refuse 'fst' verify builtin:sphere --trace wave.gtkw
refuse 'backpressure' verify builtin:sphere --backpressure .
refuse 'lanes' verify builtin:sphere --lanes 3
refuse 'fraction-bits' render builtin:sphere -o a.png --method slerp-paper --fraction-bits 16
refuse 'fraction-bits' render builtin:sphere -o a.png --engine model --fraction-bits 39
refuse 'slerp-paper' render builtin:sphere -o a.png --engine model --fraction-bits 16
refuse 'error-map' render builtin:sphere -o a.png --method all --error-map b.png
refuse 'own name' render builtin:sphere -o a.png --error-map a.png
refuse 'no-such-folder' render builtin:triangle -o a.png --error-map no-such-folder/b.png
rm -f a.png
refuse 'backpressure' verify builtin:sphere --backpressure 000
refuse 'backpressure' verify builtin:sphere --backpressure sometimes
refuse 'teapot' verify builtin:teapot
refuse 'sphere' verify builtin:sphere:9999
refuse 'own name' render builtin:sphere -o a.png --json a.png
refuse 'own name' verify t.jsonl --triangles-out t.jsonl
refuse 'missing.obj' verify missing.obj
mkdir folder folder.jsonl
refuse 'folder: is a folder' verify folder
refuse 'folder.jsonl: is a folder' verify folder.jsonl
refuse 'picture: no extension; use one of: png' render builtin:triangle -o picture
refuse 'backpressure is empty' verify builtin:sphere --backpressure ''
for seed in -1 1.5 4294967296 many; do refuse "seed: takes .* not '$seed'" verify builtin:sphere --seed $seed; done
refuse 'own size, camera' verify --random 10 --size 40x30
refuse 'ideal has no cycles' render builtin:sphere -o a.png --engine ideal --backpressure random
refuse 'ideal has no cycles' render builtin:sphere -o a.png --engine ideal --lanes 4
refuse 'unknown method .rainbow.' verify builtin:sphere --method quad,rainbow

# What cannot be written is refused before the work, which would print.
refuse 'no-such-folder' cycles builtin:sphere:3 --csv no-such-folder/a.csv
refuse 'no-such-folder' cycles builtin:sphere:3 --json no-such-folder/a.json
refuse 'no-such-folder' render builtin:sphere:3 -o no-such-folder/a.png
refuse 'no-such-folder' list --json no-such-folder/a.json
refuse 'folder: is a folder' verify builtin:sphere:3 --json folder
touch file
refuse 'not a folder' stress --quick --out file

# Nothing compared is no success.
"$shadesim" verify builtin:sphere:3 --size 40x30 --triangles-out sphere.jsonl --quiet
head -n 1 sphere.jsonl >nothing.jsonl
"$shadesim" verify nothing.jsonl >stdout 2>stderr
check 'nothing compared exits with 1' test $? -eq 1
check 'nothing compared is said' grep -q 'nothing.jsonl.*nothing was compared' stderr
check 'nothing compared is no PASS' test "$(grep -c PASS stdout)" -eq 0
"$shadesim" verify sphere.jsonl nothing.jsonl --quiet 2>stderr
check 'nor beside a scene that was' test $? -eq 1
refuse 'missing.jsonl' verify missing.jsonl
refuse 'not both' verify builtin:sphere --random 10
refuse 'random' verify --random 0
refuse 'trace' verify builtin:sphere --method all --trace a.fst
refuse 'extension|format' render builtin:triangle -o picture.xyz
refuse 'no-such-folder' render builtin:triangle -o no-such-folder/a.png
refuse 'no-such-folder' verify builtin:triangle --json no-such-folder/a.json
refuse 'no-such-folder' verify builtin:triangle --trace no-such-folder/a.fst
echo 'this is no mesh' >broken.obj
refuse 'broken.obj' verify broken.obj
echo '{"format":"shadesim-triangles","version":7}' >old.jsonl
refuse 'old.jsonl:1' verify old.jsonl
check 'nothing half written' test "$(find . -name '*.png' -o -name '*.tmp' | wc -l)" -eq 0

# A scene without a pixel is no success, nor is output that is lost.
printf 'v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n' >point.obj
for command in 'render -o point.png' 'render -o point.png --engine ideal' cycles verify; do
  # shellcheck disable=SC2086
  "$shadesim" $command point.obj >/dev/null 2>stderr
  check "'$command' of no pixel exits with 1" test $? -eq 1
  check "'$command' says so in a line" grep -q 'covers no pixel' stderr
done
rm -f point.png
"$shadesim" cycles builtin:triangle --size 40x30 >/dev/full 2>stderr
check 'lost output exits with 2' test $? -eq 2
check 'lost output is named' grep -q 'could not be written' stderr

# What README.md shows of the demo.
"$shadesim" render builtin:mixed --method quad --size 960x720 -o demo.png >stdout
check 'README.md has the line of the demo' \
  grep -qF -- "$(head -n 1 stdout)" "$(dirname -- "${BASH_SOURCE[0]}")/../../README.md"
rm -f demo.png

# The main job, on every engine; RTL and model write the same picture.
for engine in rtl model ideal; do
  accept render builtin:torus:8 --engine $engine --size 80x60 -o $engine.png --json $engine.json
  has_keys $engine.json method engine width height triangles spans pixels max_error_lsb \
    rms_error_lsb psnr_db sim_seconds pixels_per_second
done
check 'RTL and model draw the same picture' cmp rtl.png model.png
accept render builtin:torus:8 builtin:saddle:4 --method all --size 80x60 -o many.png
check 'one picture per scene and method' test "$(find . -name 'many-*.png' | wc -l)" -eq 56
accept render builtin:sphere:6 --size 40x30 -o a.exr --camera persp --lighting phong --cull none
accept verify builtin:sphere:6 --size 64x48 --method all --backpressure random --json v.json
has_keys v.json method cycles cycles_per_pixel setup_cycles stall_cycles skipped pixels_compared \
  pixel_mismatches spans_compared cycle_mismatches
accept verify builtin:sphere:6 --size 64x48 --backpressure 0010111 --rotate 30,20 --light 1,1,1
accept verify --random 600 --method all --seed 9
"$shadesim" verify builtin:sphere:3 --size 64x48 --method quad,slerp,quad >two.txt
check 'a list of methods' test "$(grep -c 'rtl:' two.txt)" -eq 2
accept verify --random 600 --method all --seed 9 --lanes 4 --backpressure random --json four.json
check 'four lanes are told' grep -q '"lanes": 4' four.json
accept verify builtin:sphere:6 --size 64x48 --method slerp-intensity --lighting phong --lanes 4
refuse 'tolerance' verify builtin:sphere --method quad-segment --tolerance 16
refuse 'tolerance nan' verify builtin:sphere --method quad-segment --tolerance nan
accept verify builtin:sphere:3 --size 64x48 --method quad-segment --tolerance 2 --lanes 4
accept cycles builtin:sphere:3 --size 64x48 --method quad --tolerance 1 --subdivide report --json report.json
accept cycles builtin:sphere:3 --size 64x48 --method quad --tolerance 1 --subdivide split --json split.json
check 'subdivision is reported' grep -q '"over_limit_triangles": [1-9]' report.json
check 'nothing is split when only reported' grep -q '"pieces": 0' report.json
check 'subdivision is counted' grep -q '"pieces": [1-9]' split.json
for tolerance in 0 0.5 10.2; do
  accept verify builtin:sphere:3 --size 64x48 --method adaptive --tolerance $tolerance --lanes 4 \
    --lighting phong --json adaptive-$tolerance.json
done
has_keys adaptive-0.json normalised normalisations_skipped
normalised() { grep -m1 '"normalised"' "adaptive-$1.json" | tr -dc 0-9; }
check 'a larger tolerance normalises less' test "$(normalised 0)" -gt "$(normalised 0.5)" -a \
  "$(normalised 0.5)" -gt "$(normalised 10.2)"
for method in phong slerp-intensity adaptive; do
  for engine in rtl model; do
    accept render builtin:torus:8 --method $method --lanes 4 --engine $engine --size 80x60 \
      -o $method-$engine.png
  done
  check "RTL and model draw the same $method" cmp $method-rtl.png $method-model.png
done
accept render builtin:sphere:6 --size 64x48 --method slerp-paper --engine model --fraction-bits 12 \
  -o coarse.png --error-map coarse-error.png
check 'an error map was written' test -s coarse-error.png
"$shadesim" render builtin:sphere:3 --size 64x48 -o all.png --error-map all-error.png --json all.json \
  --triangles-out all.jsonl --trace all.fst >rendered.txt
for file in all.png all-error.png all.json all.jsonl all.fst all.gtkw; do
  check "render names $file" grep -q ": $file$" rendered.txt
  check "render wrote $file" test -s $file
done
echo '0 1 1 0 0 0 1' >pattern.txt
accept verify builtin:saddle:3 --size 64x48 --backpressure pattern.txt
accept verify builtin:saddle:3 --size 64x48 --trace wave.fst
check 'a waveform was written' test -s wave.fst

accept cycles builtin:saddle:3 --size 64x48 --method all --csv spans.csv --json cycles.json
check 'header of the CSV' test "$(head -n 1 spans.csv)" = \
  triangle,y,x,length,method,cycles_rtl,cycles_model,setup,stall,normalised,skipped
check 'the cycles of the CSV add up to those of the frames' test \
  "$(awk -F, 'NR > 1 { sum += $6 } END { print sum }' spans.csv)" = \
  "$(grep -m1 '^  "cycles":' cycles.json | tr -dc 0-9)"
check 'RTL and model agree in the CSV' \
  awk -F, 'NR > 1 && $6 != $7 { exit 1 } END { exit NR < 100 }' spans.csv

check 'the normalisations of the CSV add up to those of the frames' test \
  "$(awk -F, 'NR > 1 { sum += $10 } END { print sum }' spans.csv)" = \
  "$(grep -m1 '^  "normalised":' cycles.json | tr -dc 0-9)"

# Packets written and read back are the same frame.
accept verify builtin:mixed:6 --size 90x70 --triangles-out mixed.jsonl --json direct.json
accept verify mixed.jsonl --triangles-out again.jsonl --json packets.json
check 'packets survive the file' cmp mixed.jsonl again.jsonl
for key in triangles spans pixels cycles setup_cycles; do
  check "the packets give the same $key" test "$(grep -m1 "^  \"$key\"" direct.json)" = \
    "$(grep -m1 "^  \"$key\"" packets.json)"
done
refuse 'own size' render mixed.jsonl -o a.png --size 10x10

"$shadesim" list >list.txt
check 'list succeeds' test $? -eq 0
for word in flat gouraud quad phong-duff slerp-paper span_setup quad_surface saddle; do
  check "list names $word" grep -q "$word" list.txt
done
check 'bounds in codes are in codes' grep -q 'error <= 0.009 codes, beyond the tolerance' list.txt
check 'and not in both' test "$(grep -c 'ulp.*in codes' list.txt)" -eq 0
for command in '' render verify cycles bench list; do
  # Unquoted on purpose: no command is no argument.
  "$shadesim" $command --help >help.txt
  check "help of '$command' fits on a screen" test "$(wc -l <help.txt)" -le 50
done

summary 100
