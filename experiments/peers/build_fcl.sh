#!/usr/bin/env bash
# Builds FCL from Debian's sources with this project's flags: build_fcl.sh FOLDER [CMAKE_OPTION ...]. Then race against it, into a folder of its own,
# since rows that a folder has are not raced for again:
#   cmake --preset release -B build-fcl -Dfcl_DIR=FOLDER/lib/cmake/fcl && cmake --build build-fcl && build-fcl/tetracone experiment peers --out out/fcl
# Options of CMake come last and win: -DFCL_USE_HOST_NATIVE_ARCH=ON is for this machine alone. Installs the packages that are missing; apt's own
# lists of sources stay as they are. Some 5 minutes on two cores.

. "$(dirname "${BASH_SOURCE[0]}")/../support/setup.sh"

[[ $# -ge 1 && ${1:0:1} != - ]] || { echo "build_fcl: expected a folder to install to: build_fcl.sh FOLDER [CMAKE_OPTION ...]" >&2; exit 2; }
mkdir -p "$1" 2> /dev/null || fail "build_fcl: cannot make $1"
folder=$(cd "$1" && pwd)
shift
command -v apt-get > /dev/null || fail "build_fcl: needs apt-get"
install_packages "${build_packages[@]}" "${study_packages[@]}" dpkg-dev

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
{ apt update && (cd "$work/source" && apt source fcl); } > "$work/log" 2>&1 || fail "build_fcl: cannot get the sources of fcl: $(grep -m 1 '^E:' "$work/log" || tail -n 1 "$work/log")"
source=$(find "$work/source" -mindepth 1 -maxdepth 1 -type d -name 'fcl-*')
[[ -n $source ]] || fail "build_fcl: no folder fcl-* in the sources of fcl"

{
  cmake -S "$source" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS=-ffp-contract=off -DBUILD_TESTING=OFF \
    -DFCL_USE_X64_SSE=OFF -DCMAKE_INSTALL_PREFIX="$folder" -DCMAKE_INSTALL_LIBDIR=lib "$@" &&
    cmake --build "$work/build" --parallel "$(jobs_at_once)" && cmake --install "$work/build"
} > "$work/log" 2>&1 || fail "build_fcl: $(grep -m 1 -i 'error' "$work/log" || tail -n 1 "$work/log")"
config=$(find "$folder/lib" -name fcl-config.cmake -print -quit)
[[ -n $config ]] || fail "build_fcl: no fcl-config.cmake below $folder/lib"
echo "fcl_DIR: $(dirname "$config")"
