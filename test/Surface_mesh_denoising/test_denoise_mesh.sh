#!/usr/bin/env bash
# test_denoise_mesh.sh PROGRAM MESH: tests the program denoise_mesh on a triangle mesh without degenerate faces.
set -uo pipefail
program=$1
mesh=$(realpath "$2")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1

failures=0
fail() { echo "FAILED: $*"; failures=$((failures + 1)); }

# run ARGUMENT...: sets status, out and err
run() {
  "$program" "$@" >out.txt 2>err.txt
  status=$?
  out=$(cat out.txt)
  err=$(cat err.txt)
}

# refuses PATTERN ARGUMENT...: one line that matches, exit status 2, no output file
refuses() {
  local pattern=$1
  shift
  run "$@"
  [[ $status -eq 2 ]] || fail "$*: exit status $status"
  [[ $(wc -l <err.txt) -eq 1 && $err =~ $pattern ]] || fail "$*: said '$err', not '$pattern'"
  [[ ! -e refused.off ]] || fail "$*: left an output file"
}

sizes() { sed -n 's/.*: \([0-9]* vertices, [0-9]* faces\).*/\1/p' <<<"$out"; }

# ----- help
run --help
[[ $status -eq 0 && -z $err ]] || fail "--help: status $status, '$err'"
for option in angle-threshold iterations normal-iterations neighborhood-size normal-weight convergence-threshold \
              relaxation parallel help; do
  grep -q -- "--$option" <<<"$out" || fail "--help does not mention --$option"
done

# ----- denoising
run "$mesh" denoised.off
[[ $status -eq 0 && -z $err && -s denoised.off ]] || fail "default run: status $status, '$err'"
[[ $out =~ [0-9]+' iterations, converged' ]] || fail "default run did not report convergence: $out"
[[ $out =~ 'vertices moved by '[0-9.e-]+' on average, by '[0-9.e-]+' at most' ]] || fail "no displacements: $out"
expected_sizes=$(sizes)
[[ -n $expected_sizes ]] || fail "no sizes: $out"

run --parallel "$mesh" parallel.off
cmp -s denoised.off parallel.off || fail "--parallel gives another mesh"

run --iterations=2 --angle-threshold 0.4 --normal-iterations=3 --neighborhood-size=30 --normal-weight=100 \
  --convergence-threshold=1e-9 --relaxation=0.7 -- "$mesh" two.off
[[ $status -eq 0 && $out == *"2 iterations, not converged"* ]] || fail "two iterations: status $status, $out $err"
cmp -s denoised.off two.off && fail "the options change nothing"

# ----- formats: no iteration, so that each file holds the same mesh
run --iterations=0 "$mesh" start.off
last=start.off
for next in a.obj b.ply c.ts d.STL e.off; do
  run --iterations=0 "$last" "$next"
  [[ $status -eq 0 && $(sizes) == "$expected_sizes" ]] || fail "$last to $next: status $status, $out $err"
  if [[ $last == *.STL ]]; then
    [[ $out == *repaired* ]] || fail "$last: the repair was not reported"
  fi
  last=$next
done

printf 'OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n' >quads.off
run quads.off triangles.off
[[ $status -eq 0 && $out == *"8 vertices, 12 faces, triangulated"* ]] || fail "quads: status $status, $out $err"

# three triangles at one edge, one of them turned around
printf 'OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n3 1 0 4\n' >nonmanifold.off
run nonmanifold.off manifold.off
[[ $status -eq 0 && $out == *"3 faces, made from a repaired polygon soup"* ]] || fail "soup: status $status, $out $err"

# ----- bad paths
: >empty.off
head -c 2000 "$mesh" >cut_off.off
printf 'OFF\n0 0 0\n' >no_faces.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n' >bad_index.off
printf 'solid\n' >broken.stl
refuses 'missing.off: cannot be read' missing.off refused.off
refuses 'empty.off: cannot be read' empty.off refused.off
refuses 'no_faces.off: holds no mesh' no_faces.off refused.off
refuses 'cut_off.off: holds no mesh' cut_off.off refused.off
refuses 'bad_index.off: holds no mesh' bad_index.off refused.off
refuses 'broken.stl: holds no mesh' broken.stl refused.off
refuses 'must end in one of' "$mesh" refused.docx
refuses 'must end in one of' missing.docx refused.off
refuses 'must end in one of' . refused.off
refuses 'cannot be written' "$mesh" missing/refused.off

# ----- bad options
refuses 'two files' "$mesh"
refuses 'two files'
refuses 'two files' "$mesh" refused.off third.off
refuses "unknown option '--nonsense'" --nonsense "$mesh" refused.off
refuses "unknown option '-x'" -x "$mesh" refused.off
refuses "'abc' is not an integer" --iterations=abc "$mesh" refused.off
refuses "'1.5' is not an integer" --iterations=1.5 "$mesh" refused.off
refuses "'' is not an integer" --iterations= "$mesh" refused.off
refuses "'99999999999999' is not an integer" --iterations=99999999999999 "$mesh" refused.off
refuses "'0.5x' is not a number" --relaxation=0.5x "$mesh" refused.off
refuses 'value is missing' --iterations
refuses 'number_of_iterations is -1' --iterations=-1 "$mesh" refused.off
refuses 'angle_threshold is 1.* \(0, 1\)' --angle-threshold=1 "$mesh" refused.off
refuses 'relaxation_factor is 0.* \(0, 1\]' --relaxation=0 "$mesh" refused.off
refuses 'neighborhood_size is 0' --neighborhood-size=0 "$mesh" refused.off
refuses 'normal_weight is -1' --normal-weight=-1 "$mesh" refused.off
refuses 'convergence_threshold is 0' --convergence-threshold=0 "$mesh" refused.off

# ----- a progress bar, on a terminal only
if command -v script >/dev/null; then
  script -qec "'$program' '$mesh' bar.off" typescript >/dev/null </dev/null
  grep -q '\[#*.*\] iteration 1, moved by up to' typescript || fail "no progress bar on a terminal"
fi

[[ $failures -eq 0 ]] && echo "all passed"
exit $((failures > 0))
