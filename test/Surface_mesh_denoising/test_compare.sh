#!/usr/bin/env bash
# test_compare.sh PROGRAM: tests the program compare on a small generated mesh.
set -uo pipefail
program=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1

failures=0
fail() { echo "FAILED: $*"; failures=$((failures + 1)); }

# refuses PATTERN ARGUMENT...: one line that matches, exit status 2, no output
refuses() {
  local pattern=$1 status
  shift
  "$program" "$@" >out.txt 2>err.txt
  status=$?
  [[ $status -eq 2 ]] || fail "$*: exit status $status"
  [[ $(wc -l <err.txt) -eq 1 && $(cat err.txt) =~ $pattern ]] || fail "$*: said '$(cat err.txt)', not '$pattern'"
  [[ ! -s out.txt ]] || fail "$*: printed something"
}

# field FILE METHOD SEARCH COLUMN: an entry of the CSV table whose rows have no comma between quotes
field() {
  awk -F, -v method="$2" -v search="$3" -v column="$4" '
    NR == 1 { for(i=1; i<=NF; ++i) if($i == column) c = i }
    NR > 1 && $2 == method && $3 == search { print $c }' "$1"
}
is_less() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a != "" && b != "" && a + 0 < b + 0) }'; }

small=(--models=cube --sizes=300 --noise-levels=0.2)
pair=cube_300_irregular_gaussian0.2

# ----- the tables
"$program" "${small[@]}" --methods=thresholded_normals,taubin --output=out >out.md 2>err.txt ||
  fail "default run: status $?, $(cat err.txt)"
cmp -s out.md out/comparison.md || fail "the printed table is not the one in the folder"
[[ $(grep -c '^| [a-z]' out.md) -eq 4 ]] || fail "not a header and three rows: $(cat out.md)"
[[ $(wc -l <out/comparison.csv) -eq 4 ]] || fail "CSV: not a header and three rows"
[[ $(awk -F, '{ print NF }' out/comparison.csv | sort -u) == 15 ]] || fail "CSV: the rows differ in length"

noisy=$(field out/comparison.csv noisy default mean_angular_error)
for method in thresholded_normals taubin; do
  error=$(field out/comparison.csv $method default mean_angular_error)
  is_less "$error" "$noisy" || fail "$method: the error is $error, that of the noisy mesh $noisy"
  is_less 0 "$(field out/comparison.csv $method default seconds)" || fail "$method: no time"
  is_less 0 "$(field out/comparison.csv $method default megabytes)" || fail "$method: no memory"
  grep -q "^| $method .*$(printf ' %.2f ' "$error")" out.md || fail "$method: the tables differ"
  awk -F, -v method=$method '$2 == method { sum += $5 } END { exit !(sum > 0.999 && sum < 1.001) }' out/histograms.csv ||
    fail "$method: the shares of the histogram do not add up to one"
done
# cubes have sharp edges
is_less "$(field out/comparison.csv thresholded_normals default mean_angular_error)" \
        "$(field out/comparison.csv taubin default mean_angular_error)" || fail "the smoother is better on a cube"

for mesh in noise_free noisy thresholded_normals taubin; do
  [[ -s out/meshes/$pair/$mesh.ply ]] || fail "no mesh $mesh"
done

# ----- files in the place of a generated model
"$program" --pair files "out/meshes/$pair/noise_free.ply" "out/meshes/$pair/noisy.ply" --methods taubin \
  --output files >files.md 2>err.txt || fail "pair of files: status $?, $(cat err.txt)"
[[ $(field files/comparison.csv taubin default mean_angular_error) \
   == "$(field out/comparison.csv taubin default mean_angular_error)" ]] || fail "files: another error"

# ----- the best of a grid
"$program" "${small[@]}" --methods=laplacian --best --output=best >/dev/null 2>err.txt ||
  fail "--best: status $?, $(cat err.txt)"
is_less "$(field best/comparison.csv laplacian best mean_angular_error)" \
        "$(field best/comparison.csv laplacian default mean_angular_error)" || fail "the best is not better"
grep -q 'laplacian,best,"number_of_iterations [0-9]*"' best/comparison.csv || fail "the best has no parameters"

# ----- no run lasts so short: each is a row nevertheless
"$program" "${small[@]}" --methods=laplacian,taubin --time-out=1e-9 --output=stopped >/dev/null 2>err.txt ||
  fail "--time-out: status $?, $(cat err.txt)"
for method in laplacian taubin; do
  [[ $(field stopped/comparison.csv $method default failure) == *time-out* ]] || fail "$method was not stopped"
done

# ----- help
"$program" --help >out.txt 2>err.txt || fail "--help: status $?"
for option in methods pair models sizes triangles noise-kinds noise-levels seed best time-out output list help; do
  grep -q -- "--$option" out.txt || fail "--help does not mention --$option"
done
"$program" --list >out.txt 2>err.txt || fail "--list: status $?"
for name in anisotropic_fitting guided_normals smooth_shape organic_shape impulsive; do
  grep -q "$name" out.txt || fail "--list does not mention $name"
done

# ----- bad options
: >empty.off
"$program" --models=sphere --sizes=300 --methods=taubin --output=other >/dev/null 2>&1
refuses "unknown option '--nonsense'" --nonsense
refuses "no 'nonsense'" --methods=nonsense
refuses "taubin twice" --methods=taubin,taubin
refuses 'is empty' --methods=taubin,
refuses "no 'nonsense'" --models=nonsense
refuses "no 'nonsense'" --noise-kinds=nonsense
refuses 'neither regular nor irregular' --triangles=nonsense
refuses "'abc' is not" --sizes=abc
refuses "'-300' is not" --sizes=-300
refuses 'the range is' --sizes=3
refuses 'the range is' --noise-levels=-1
refuses 'must be positive' --time-out=0
refuses 'value is missing' --seed
refuses 'two files are expected' --pair files "out/meshes/$pair/noise_free.ply"
refuses "the name 'a/b'" --pair a/b "out/meshes/$pair/noise_free.ply" "out/meshes/$pair/noisy.ply"
refuses 'cannot be read' --pair files missing.off "out/meshes/$pair/noisy.ply"
refuses 'cannot be read' --pair files empty.off "out/meshes/$pair/noisy.ply"
refuses 'two pairs of the name' --models=cube --sizes=300,300
refuses 'cannot be written' --output="$PWD/empty.off/folder"
"$program" --pair files out/meshes/$pair/noise_free.ply other/meshes/sphere_300_irregular_gaussian0.3/noisy.ply \
  >out.txt 2>err.txt
[[ $? -eq 2 && $(cat err.txt) == *'do not have the same faces'* ]] || fail "pair of other meshes: $(cat err.txt)"

[[ $failures -eq 0 ]] && echo "all passed"
exit $((failures > 0))
