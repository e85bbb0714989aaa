#!/bin/bash
# experiments/support/format.sh [-i]: whether every C++ source has the form of .clang-format; with -i, gives it to them. Exit status 77 without clang-format 14.

. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

command -v clang-format > /dev/null || { echo "skipped: no clang-format; expected the package clang-format"; exit 77; }
# Versions break lines differently: the sources have the form of one.
[[ $(clang-format --version) == *"version 14."* ]] || { echo "skipped: $(clang-format --version); expected version 14, whose form the sources have"; exit 77; }
cd "$root"
mapfile -t sources < <(find kernel covering tetratree verify experiments -name '*.h' -o -name '*.cpp' -o -name '*.inl')
if [[ ${1-} == -i ]]; then clang-format -i "${sources[@]}"; else clang-format --dry-run -Werror --ferror-limit=3 "${sources[@]}"; fi
