#!/usr/bin/env bash
# Brings the triangle meshes of the time study: fetch_models.sh [FOLDER], so that FOLDER/meshes/*.off are there.
# Default: .cache/models in the project. They are Debian's package libcgal-demo's, which is unpacked, not installed
# (slim machines drop /usr/share/doc at an install). Run again it does nothing, and needs no network.

set -euo pipefail

fail()
{
  echo "fetch_models: $1" >&2
  exit 1
}

folder=${1:-$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)/.cache/models}
wanted=(bunny00 dino)

complete()
{
  local name
  for name in "${wanted[@]}"; do
    [[ -s $1/meshes/$name.off ]] || return 1
  done
}

complete "$folder" && exit 0
[[ ! -e $folder/meshes ]] || fail "$folder/meshes is there without ${wanted[*]}; remove it and run this again"
command -v apt-get > /dev/null && command -v dpkg > /dev/null ||
  fail "needs apt-get and dpkg; or put ${wanted[*]} (.off, of CGAL's demo data) into $folder/meshes"

mkdir -p "$folder" 2> /dev/null || fail "cannot make $folder"
folder=$(cd "$folder" && pwd)
# Beside the place where it goes: the last step is a rename.
work=$(mktemp -d "$folder/fetch.XXXXXX")
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT
trap 'exit 143' TERM
mkdir "$work/package"

# As root, apt warns that its user _apt cannot write here, and downloads all the same.
download() { (cd "$work/package" && apt-get -q download libcgal-demo); }
if ! download > "$work/log" 2>&1; then
  # A machine that never updated its lists knows no package; without root, this fails and so does the next.
  apt-get -q update >> "$work/log" 2>&1 < /dev/null || true
  download >> "$work/log" 2>&1 ||
    fail "cannot download libcgal-demo: $(grep -m 1 '^E:' "$work/log" || tail -n 1 "$work/log")"
fi

dpkg -x "$work"/package/libcgal-demo_*.deb "$work/files" 2>> "$work/log" || fail "cannot unpack libcgal-demo"
archive=$(find "$work/files/usr/share/doc" -name data.tar.gz -print -quit 2> /dev/null || true)
[[ -n $archive ]] || fail "no data.tar.gz in libcgal-demo"
tar -xzf "$archive" -C "$work" data/meshes 2>> "$work/log" || fail "cannot unpack data/meshes of libcgal-demo"
complete "$work/data" || fail "libcgal-demo has not all of ${wanted[*]}"
# Another run may have been faster.
mv -T "$work/data/meshes" "$folder/meshes" 2>> "$work/log" || complete "$folder" || fail "cannot write $folder/meshes"
echo "models: $folder/meshes"
