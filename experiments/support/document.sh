#!/bin/bash
# experiments/support/document.sh: installs Doxygen where it is missing and writes the reference of the package, out/doc/html/index.html.
# Fails on a warning: on a comment that is wrong anywhere in the package, and on anything undocumented in the headers of the library's own interface.
# In the templates, members whose name and type say all have no comment.

. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

# The headers of the library's interface, and those of the package that they include.
doors="tetratree/door/tetracone.h tetratree/door/repair.h tetratree/scene/scene.h"
interface=$(cd "$root" && { printf '%s\n' $doors; sed -n 's|^#include "tetracone/\(.*\)"|\1|p' $doors; } | sort -u | tr '\n' ' ')

# document SETTING...: one run with these settings after the Doxyfile's.
document()
{
  (cat experiments/support/Doxyfile; printf '%s\n' "$@") | doxygen -
}

install_packages doxygen
cd "$root"
mkdir -p out/doc
# What is undocumented is told by a run of its own, whose output nobody needs.
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
document "INPUT = $interface" "USE_MDFILE_AS_MAINPAGE =" "WARN_IF_UNDOCUMENTED = YES" "OUTPUT_DIRECTORY = $scratch"
document "PROJECT_NUMBER = $(sed -n 's/^project(tetracone VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)" "OUTPUT_DIRECTORY = out/doc"
echo "reference: $root/out/doc/html/index.html"
