#!/bin/bash
# experiments/support/tidy.sh [FILE...]: clang-tidy, by the checks of .clang-tidy, on all headers of the package as one unit, and on these sources or, without
# any, on those that the working tree changes, as many as two minutes allow. Exit status 1 where it finds something, 77 without clang-tidy 14.

. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

need_version_14 clang-tidy
cd "$root"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
find kernel covering tetratree -name '*.h' -not -path 'tetratree/python/*' | LC_ALL=C sort | sed 's|.*|#include "tetracone/&"|' > "$scratch/headers.cpp"

# tidy FILE: silent where nothing is found.
tidy()
{
  with_fast_malloc clang-tidy --config-file=.clang-tidy --quiet "$1" -- -std=c++20 -frounding-math -I"$root/include" -I"$root" \
    $(for library in eigen3 bullet; do pkg-config --cflags $library 2> /dev/null | sed 's/-I/-isystem /g'; done) -DHWY_COMPILE_ONLY_STATIC -DCGAL_USE_GMPXX=1 -DCGAL_DO_NOT_USE_BOOST_MP -DCGAL_NO_CDT_2_WARNING -DBOOST_TEST_DYN_LINK \
    $(for path in TETRACONE_SOURCE_DIR TETRACONE_PROGRAM TETRACONE_PYTHON CGAL_INCLUDE; do echo "-D$path=\"$path\""; done) 2> "$scratch/errors" || { grep -v 'warnings generated' "$scratch/errors"; return 1; }
}

if (($#)); then
  sources=("$@")
else
  mapfile -t sources < <(git diff --name-only --diff-filter=d HEAD -- '*.cpp' 2> /dev/null)
fi
status=0
tidy "$scratch/headers.cpp" || status=1
checked=0
for source in "${sources[@]}"; do
  ((SECONDS < 120 || $#)) || break
  tidy "$source" || status=1
  checked=$((checked + 1))
done
echo "clang-tidy: the headers of the package, and $checked of ${#sources[@]} sources"
exit $status
