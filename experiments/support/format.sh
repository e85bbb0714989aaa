#!/bin/bash
# experiments/support/format.sh [-i]: whether every C++ source has the form of .clang-format; with -i, gives it to them. Exit status 77 without clang-format 14.

. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

need_version_14 clang-format
cd "$root"
mapfile -t sources < <(find kernel covering tetratree verify experiments -name '*.h' -o -name '*.cpp' -o -name '*.inl')
if [[ ${1-} == -i ]]; then clang-format -i "${sources[@]}"; else clang-format --dry-run -Werror --ferror-limit=3 "${sources[@]}"; fi
