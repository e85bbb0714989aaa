#!/usr/bin/env bash
# Builds FCL from Debian's sources with this project's flags: build_fcl.sh FOLDER [CMAKE_OPTION ...]. Then race against it by
#   cmake --preset release -B build-fcl -Dfcl_DIR=FOLDER/lib/cmake/fcl && cmake --build build-fcl && build-fcl/tetracone experiment peers
# Options of CMake come last and win: -DFCL_USE_HOST_NATIVE_ARCH=ON is for this machine alone. Needs apt-get, dpkg-dev and FCL's own libraries
# (experiments/setup.sh's study packages); no root, and no change to apt's lists. Some 5 minutes on two cores.

set -euo pipefail

fail()
{
  echo "build_fcl: $1" >&2
  exit "${2:-1}"
}

[[ $# -ge 1 && ${1:0:1} != - ]] || fail "expected a folder to install to: build_fcl.sh FOLDER [CMAKE_OPTION ...]" 2
mkdir -p "$1" 2> /dev/null || fail "cannot make $1"
folder=$(cd "$1" && pwd)
shift
command -v apt-get > /dev/null && command -v dpkg-source > /dev/null || fail "needs apt-get and dpkg-source (Debian's dpkg-dev)"

work=$(mktemp -d "$folder/build.XXXXXX")
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

# The places that this machine's packages come from, asked for sources.
mkdir -p "$work/apt/parts" "$work/apt/lists" "$work/apt/cache" "$work/source"
for list in /etc/apt/sources.list.d/*.sources; do
  [[ ! -e $list ]] || sed 's/^Types:.*/Types: deb-src/' "$list" > "$work/apt/parts/${list##*/}"
done
for list in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
  [[ ! -e $list ]] || sed -n 's/^deb /deb-src /p' "$list" > "$work/apt/parts/$(basename "$list" .list).list"
done
apt()
{
  apt-get -q -o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$work/apt/parts" -o Dir::State::Lists="$work/apt/lists" -o Dir::Cache="$work/apt/cache" "$@"
}
{ apt update && (cd "$work/source" && apt source fcl); } > "$work/log" 2>&1 || fail "cannot get the sources of fcl: $(grep -m 1 '^E:' "$work/log" || tail -n 1 "$work/log")"
source=$(find "$work/source" -mindepth 1 -maxdepth 1 -type d -name 'fcl-*')
[[ -n $source ]] || fail "no folder fcl-* in the sources of fcl"

{
  cmake -S "$source" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS=-ffp-contract=off -DBUILD_TESTING=OFF \
    -DFCL_USE_X64_SSE=OFF -DCMAKE_INSTALL_PREFIX="$folder" -DCMAKE_INSTALL_LIBDIR=lib "$@" &&
    cmake --build "$work/build" && cmake --install "$work/build"
} > "$work/log" 2>&1 || fail "$(grep -m 1 -i 'error' "$work/log" || tail -n 1 "$work/log")"
config=$(find "$folder/lib" -name fcl-config.cmake -print -quit)
[[ -n $config ]] || fail "no fcl-config.cmake below $folder/lib"
echo "fcl_DIR: $(dirname "$config")"
