#!/bin/bash
# try_debian.sh RELEASE [--keep FOLDER] [COMMAND...]: makes a bare root of Debian 12 or 13, clones this repository into it, and runs there ./reproduce and ./test, or
# the commands given, each one word: try_debian.sh 13 './test quick'. Prints minutes and status of each, and the hash of the answers of every family. Needs root and
# mmdebstrap; it takes the mirror from apt's own lists. The root is removed, or kept in FOLDER and used again.

. "$(dirname "${BASH_SOURCE[0]}")/../support/setup.sh"

usage() { echo "try_debian.sh: '$*'; expected 12 or 13, then --keep FOLDER and commands where they are wanted" >&2; exit 2; }
case ${1-} in
  12) suite=bookworm ;;
  13) suite=trixie ;;
  *) usage "$@" ;;
esac
release=$1
shift
keep=
if [[ ${1-} == --keep ]]; then
  [[ -n ${2-} ]] || usage "$@"
  keep=$2
  shift 2
fi
commands=("$@")
(($#)) || commands=(./reproduce ./test)
((EUID == 0)) || fail "not root; a Debian of its own is made as root"
command -v mmdebstrap > /dev/null || fail "no mmdebstrap; expected the package mmdebstrap"

# Apt keeps its lists in one of two files; sed fails where one is not there.
mirror=$(sed -n 's/^URIs: *//p; s/^deb \(\[[^]]*\] \)\?\([^ ]*\) .*/\2/p' /etc/apt/sources.list /etc/apt/sources.list.d/debian.sources 2> /dev/null | grep -v security | head -n 1 || true)
[[ -n $mirror ]] || fail "no mirror of Debian in apt's lists; expected one in /etc/apt/sources.list or /etc/apt/sources.list.d/debian.sources"
folder=${keep:-$(mktemp -d "${TMPDIR:-/tmp}/tetracone_debian.XXXXXX")}
[[ -n $keep ]] || trap 'rm -rf --one-file-system "$folder"' EXIT

if [[ ! -x $folder/usr/bin/apt-get ]]; then
  echo "making a bare Debian $release"
  mkdir -p "$folder"
  chmod 755 "$folder"
  mmdebstrap --quiet --variant=minbase --include=ca-certificates,git "$suite" "$folder" "deb $mirror $suite main"
fi
rm -rf "$folder/tetracone"
git clone --quiet "$root" "$folder/tetracone"
cp --remove-destination -L /etc/resolv.conf "$folder/etc/resolv.conf"
printf '127.0.0.1 localhost\n::1 localhost\n' > "$folder/etc/hosts"  # an installer writes it; selenium of Debian 12 needs it

# in_root COMMAND: with the processes and devices that the tests need.
in_root()
{
  unshare --mount --pid --fork bash -c 'mount -t proc proc "$1/proc"; mount --rbind /dev "$1/dev"; mount -t tmpfs tmp "$1/tmp"
    exec chroot "$1" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 bash -c "cd /tetracone && $2"' in_root "$folder" "$1"
}

failed=0
for line in "${commands[@]}"; do
  began=$SECONDS status=0
  in_root "$line" > "$folder/log" 2>&1 || status=$?
  took=$((SECONDS - began))
  printf 'Debian %s: %s: status %d in %d min %02d s; %s\n' "$release" "$line" $status $((took / 60)) $((took % 60)) \
    "$(grep -E 'tests passed|^report: ' "$folder/log" | tail -n 1)"
  ((status == 0)) || { tail -n 40 "$folder/log"; failed=1; }
done
if [[ -x $folder/tetracone/build/tetracone ]]; then
  in_root 'experiments/machines/same_answers.sh --out out > /dev/null && tail -n +2 out/machines.csv | cut -d, -f8 | sort | uniq -c' || failed=1
fi
exit $failed
