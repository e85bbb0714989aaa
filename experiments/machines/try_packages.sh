#!/bin/bash
# try_packages.sh [BUILD]: builds what is missing of a build folder (default: build), makes its Debian packages, installs them by apt in a bare Debian 12 of
# their own, and runs there what README.md shows: the program, the Python example, and the C++ examples against the installed library.
# As root, with mmdebstrap (Debian: mmdebstrap) and apt's own mirrors; a few minutes, most of them apt's. Leaves nothing.

. "$(dirname "${BASH_SOURCE[0]}")/../support/setup.sh"

build=${1:-$root/build}
(($# <= 1)) && [[ -f $build/CPackConfig.cmake ]] || { echo "try_packages.sh: '$*'; expected a build folder" >&2; exit 2; }
((EUID == 0)) || fail "not root; a Debian of its own is made as root"
for tool in mmdebstrap cpack dpkg-shlibdeps; do command -v $tool > /dev/null || fail "no $tool; expected the packages mmdebstrap, cmake and dpkg-dev"; done

work=$(mktemp -d /tmp/tetracone_packages.XXXXXX)
trap 'rm -rf --one-file-system "$work"' EXIT
chmod 755 "$work"
shopt -s nullglob
sources=(/etc/apt/sources.list /etc/apt/sources.list.d/debian.sources)
echo "packing, and making a bare Debian 12"
cmake --build "$build" --target all python > "$work/log" 2>&1 || { tail -n 20 "$work/log" >&2; exit 1; }
cpack --config "$build/CPackConfig.cmake" -B "$work/packed" > "$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
mmdebstrap --quiet --variant=minbase bookworm "$work/debian" $(for file in "${sources[@]}"; do [[ ! -s $file ]] || echo "$file"; done)
mkdir -p "$work/debian/tetracone/"{verify/test,tetratree/{door,python}}
cp "$work"/packed/*.deb "$root/README.md" "$work/debian/tetracone/"
cp -r "$root/tetratree/door/"{mainpage.md,examples} "$work/debian/tetracone/tetratree/door/"
cp "$root/tetratree/python/README.md" "$work/debian/tetracone/tetratree/python/"
cp -r "$root/verify/test/install" "$work/debian/tetracone/verify/test/"

cat > "$work/debian/tetracone/try" << 'END'
set -euo pipefail
cd /tetracone
export DEBIAN_FRONTEND=noninteractive
packages() { apt-get -q -y install "$@" > log 2>&1 || { tail -n 20 log >&2; exit 1; }; echo "installed after $SECONDS s: $*"; }
says() { local expected=$1 said; shift; said=$("$@") && [[ $said == "$expected" ]] || { echo "$*: $said; expected $expected" >&2; exit 1; }; }
apt-get -q update > log 2>&1 || { tail -n 20 log >&2; exit 1; }

packages ./tetracone_*.deb
models=(verify/test/install/cube.off verify/test/install/tetrahedron.off)
printf '0.5 0.5 0.5\n1 1 1\n2 2 2\n' > points.txt
tetracone check "${models[@]}" > /dev/null
says 1 tetracone collide "${models[@]}"
says $'1\n0\n-1' tetracone inside "${models[0]}" points.txt
tetracone view "${models[@]}" --out x.html
tetracone verify --db a.db --family nested --cases 1 --frames 0 > /dev/null
tetracone verify --db b.db --family nested --cases 1 --frames 0 --seed 1 > /dev/null
tetracone merge all.db a.db b.db
tetracone report --progress a.db > /dev/null
tetracone report all.db --table errors > /dev/null
[[ -s x.html ]]
echo "the program answers after $SECONDS s"

packages ./python3-tetracone_*.deb
python3 -m doctest tetratree/python/README.md
echo "the Python example of tetratree/python/README.md prints what it says after $SECONDS s"

packages python3-matplotlib
tetracone report a.db --out out > /dev/null
[[ -s out/report.html ]]
echo "the program draws the report after $SECONDS s"

packages ./libtetracone-dev_*.deb g++ cmake make
cmake -D SOURCE=/tetracone -D PREFIX=/usr -D WORK=/tetracone/work -D COMPILER=g++ -D "GENERATOR=Unix Makefiles" -D PYTHON=python3 \
  -P verify/test/install/package_example.cmake
END
unshare --mount --pid --fork bash -c 'mount -t proc proc "$1/proc" && exec chroot "$1" bash /tetracone/try' try "$work/debian"
echo "the packages install and do what README.md says, in $SECONDS s"
