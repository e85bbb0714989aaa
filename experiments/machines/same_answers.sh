#!/bin/bash
# same_answers.sh [--all | --skip] [--cases N] [--out DIR]: asks the library the cases of every family, compiled by this machine's g++ and
# for aarch64 (which qemu runs here), with each set of vector instructions: the answers must be the same, bit for bit, and none wrong.
# --skip: status 77 at once where the compiler for aarch64, its libgmp-dev or qemu is not installed. --all: also by clang, for C++20 and C++23, and with products and sums contracted and no check of that, which must show.
# Writes DIR/machines.csv. Status 1 where answers differ that must not, or don't that must. What is not installed is left out, and said.

. "$(dirname "${BASH_SOURCE[0]}")/../support/setup.sh"

all=0 cases=20 out=$root/out
while (($#)); do
  case $1 in
    --all) all=1 ;;
    --skip)
      for tool in aarch64-linux-gnu-g++ qemu-aarch64-static; do
        command -v $tool > /dev/null || { echo "skipped: no $tool"; exit 77; }
      done
      aarch64-linux-gnu-g++ -E -x c++ - <<< '#include <gmpxx.h>' > /dev/null 2>&1 || { echo "skipped: no libgmp-dev of arm64"; exit 77; }
      ;;
    --cases) cases=$2; shift ;;
    --out) out=$2; shift ;;
    *) echo "same_answers.sh: '$1'; expected --all, --skip, --cases N or --out DIR" >&2; exit 2 ;;
  esac
  shift
done
program=${TETRACONE_PROGRAM:-$root/build/tetracone}
[[ -x $program ]] || fail "$program: no such program; expected it built before (./reproduce, or TETRACONE_PROGRAM)"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$out"
out=$(cd "$out" && pwd)
"$program" experiment dataset --cases "$cases" --out "$work" > /dev/null
# The library as one unit.
for source in "$root"/tetratree/{door,scene,solver}/*.cpp "$root"/tetratree/solver/solvers.inl "$root/covering/io/read.cpp"; do
  [[ $source == */repair.cpp ]] || printf '#include "%s"\n' "$source"
done > "$work/library.cpp"
echo "TETRACONE_FOR_EACH_KERNEL(TETRACONE_INSTANTIATE_SOLVERS)" >> "$work/library.cpp"

table=$work/machines.csv
echo "architecture,compiler,standard,instructions,contraction,answers,wrong,sha256,seconds" > "$table"
status=0 expected=

# ask NAME RUNNER ARCHITECTURE COMPILER STANDARD CONTRACTION INSTRUCTIONS...
ask()
{
  local name=$1 runner=$2 row=$3,$4,$5 contraction=$6 instructions hash start
  shift 6
  for instructions; do
    start=$SECONDS
    if ! $runner "$work/$name" "$work/dataset" "$instructions" > "$work/answers" 2> "$work/count"; then
      echo "$row,$instructions: $(tail -n 1 "$work/count")" >&2
      status=1
      continue
    fi
    hash=$(sha256sum < "$work/answers") hash=${hash%% *}
    read -r wrong _ answers < "$work/count"
    echo "$row,$instructions,$contraction,$answers,$wrong,$hash,$((SECONDS - start))" | tee -a "$table"
    : "${expected:=$hash}"
    if [[ $contraction == off ]]; then
      ((wrong == 0)) && [[ $hash == "$expected" ]] || status=1
    else
      [[ $hash != "$expected" ]] || status=1
    fi
  done
}

# compile NAME COMPILER FLAG...: library and program; status 1 where the compiler is not there. The threads of scenes, which are not asked, are the tests'
# stand-in: no oneTBB of another machine need be had.
compile()
{
  local name=$1 compiler=$2
  shift 2
  command -v "$compiler" > /dev/null || { echo "$compiler: not installed, left out" >&2; return 1; }
  "$compiler" -O2 -w -Wno-psabi -frounding-math -DCGAL_USE_GMPXX=1 "$@" -I "$root/include" -I "$root" -I "$root/verify/test/threads" -pthread -isystem /usr/include/eigen3 \
    "$root/experiments/machines/answers.cpp" "$work/library.cpp" -lhwy -lgmp -lmpfr -o "$work/$name" ||
    fail "$compiler $*: did not compile"
}

processor=$(uname -m)
sets=(best)
if [[ $processor == x86_64 ]]; then sets=(best avx2 ssse3 none); fi
if compile plain g++ -std=c++20 -ffp-contract=off; then
  ask plain "" "$processor" "g++ $(g++ -dumpfullversion)" c++20 off "${sets[@]}"
fi
if [[ $processor != aarch64 ]] && command -v qemu-aarch64-static > /dev/null &&
  compile foreign aarch64-linux-gnu-g++ -std=c++20 -ffp-contract=off; then
  ask foreign qemu-aarch64-static aarch64 "g++ $(aarch64-linux-gnu-g++ -dumpfullversion)" c++20 off best
fi
if ((all)); then
  for compiler in g++ clang++-14 clang++-16 clang++-19; do
    for standard in c++20 c++2b; do
      [[ "$compiler $standard" == "g++ c++20" ]] && continue
      compile other "$compiler" "-std=$standard" -ffp-contract=off || continue
      ask other "" "$processor" "${compiler%%-*} $("$compiler" -dumpversion)" "${standard/2b/23}" off best
    done
  done
  # Contracted, the library refuses to answer (the test kernel_flags): what it would answer is asked with that check taken out.
  checks=kernel/number/floating_point.h
  mkdir -p "$work/unchecked/tetracone/${checks%/*}"
  sed 's/if (!arithmetic_is_as_written())/if (false)/' "$root/$checks" > "$work/unchecked/tetracone/$checks"
  ! cmp -s "$root/$checks" "$work/unchecked/tetracone/$checks" || fail "$checks: no check of the arithmetic; expected one to take out"
  if [[ $processor == x86_64 ]] && grep -qw fma /proc/cpuinfo &&
    compile contracted g++ -std=c++20 -march=haswell -ffp-contract=fast -I "$work/unchecked"; then
    ask contracted "" "$processor" "g++ $(g++ -dumpfullversion)" c++20 on best
  fi
fi
mv "$table" "$out/machines.csv"
((status == 0)) && echo "the same answers everywhere, in $SECONDS s" || echo "answers differ: see $out/machines.csv" >&2
exit $status
