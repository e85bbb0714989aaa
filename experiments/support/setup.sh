# What ./test and ./reproduce share: the Debian packages, and how to build. Sourced by bash, not run.

set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

# The comment over a script is its help.
if [[ ${1-} == -h || ${1-} == --help ]]; then
  sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0"
  exit
fi

# To build the program and its tests.
build_packages=(g++ cmake ninja-build libcgal-dev libgmp-dev libmpfr-dev libeigen3-dev libhwy-dev libboost-dev libboost-test-dev
  libcli11-dev nlohmann-json3-dev libsqlite3-dev libtbb-dev
  libjs-three)
# For the fuzz targets, and what clang is faster by; its runtime is a package of its own: clang_runtime.
fuzz_packages=(clang libjemalloc2)
# For the tests of the sources' form, of error bounds, of the checker proved in Coq, of the report, of the page in 3D, of the examples of subjects,
# of the Python package, its notebooks and the Debian packages, which skip without them.
test_packages=(clang-format clang-tidy gappa coq ocaml-nox ocaml-findlib libzarith-ocaml-dev
  python3 python3-matplotlib python3-pil python3-selenium chromium chromium-driver libembree-dev
  python3-pip jupyter-nbconvert python3-ipykernel dpkg-dev file)
# For the Python package.
python_packages=(pybind11-dev python3-dev python3-numpy)
# What builds it for pip; Debian 12 has it among its backports alone.
pip_packages=(python3-scikit-build-core)
# For the study: the peers that it compares with, and the figures of its report.
study_packages=(libfcl-dev libbullet-dev libode-dev libccd-dev python3 python3-matplotlib)
# The engines of Debian that ./reproduce field asks.
field_packages=(libgts-dev libsimbody-dev libsfcgal-dev python3-vtk9 pkg-config)

fail()
{
  printf '%s\n' "$@" >&2
  exit 1
}

# install_packages PACKAGE...: those that are not there, by apt, as root or with sudo; says nothing when all are there.
install_packages()
{
  local package missing=() sudo=()
  if ! command -v dpkg-query > /dev/null || ! command -v apt-get > /dev/null; then
    echo "not a Debian machine: these are taken to be there: $*"
    return
  fi
  for package; do
    dpkg-query -W -f '${db:Status-Status}\n' "$package" 2> /dev/null | grep -qx installed || missing+=("$package")
  done
  ((${#missing[@]})) || return 0

  if ((EUID != 0)); then
    command -v sudo > /dev/null || fail "not root and no sudo; install first: apt-get install ${missing[*]}"
    sudo=(sudo)
  fi
  echo "installing: ${missing[*]}"
  local log
  log=$(mktemp)
  # What update can't reach, install may not need: its own status decides.
  "${sudo[@]}" apt-get -q update > "$log" 2>&1 < /dev/null || true
  if ! "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=300 \
    install --no-install-recommends "${missing[@]}" >> "$log" 2>&1 < /dev/null; then
    tail -n 20 "$log" >&2
    rm -f "$log"
    fail "could not install: ${missing[*]}"
  fi
  rm -f "$log"
}

# The package of the sanitizers' runtime for the clang that is there: its name has clang's version, which differs between releases of Debian.
clang_runtime() { echo "libclang-rt-$(clang -dumpversion | cut -d . -f 1)-dev"; }

# known_packages PACKAGE...: those that this release of Debian has. Apt knows them once it has installed something.
known_packages() { local package; for package; do if apt-cache show "$package" > /dev/null 2>&1; then echo "$package"; fi; done; }

# need_version_14 TOOL: ends with status 77, which skips a test, where clang's tool is not there, or of another version: each finds other things, and the
# sources agree with one.
need_version_14()
{
  command -v "$1" > /dev/null || { echo "skipped: no $1; expected the package $1"; exit 77; }
  [[ $("$1" --version) == *"version 14."* ]] || { echo "skipped: $1 is not of version 14, with which the sources agree"; exit 77; }
}

# Whole gigabytes of memory that programs may still take.
gigabytes_free() { awk '/^MemAvailable:/ { print int($2 / 1000000) }' /proc/meminfo; }

# How many compilations at once: a processor and 3 GB of memory each.
jobs_at_once()
{
  local jobs=$(($(gigabytes_free) / 3))
  ((jobs > $(nproc))) && jobs=$(nproc)
  ((jobs > 1)) || jobs=1
  echo "$jobs"
}

# Copies its input; behind a line that counts, "[12/80] ..." of a build or " 3/90 Test ..." of tests, how long the rest will take at this pace.
with_time_left()
{
  local line left finished all
  SECONDS=0
  while IFS= read -r line || [[ -n $line ]]; do
    left=
    if [[ $line =~ ^\[([0-9]+)/([0-9]+)\] || $line =~ ^\ *([0-9]+)/([0-9]+)\ Test ]]; then
      finished=${BASH_REMATCH[1]} all=${BASH_REMATCH[2]}
      if ((finished > 0)); then
        left=$((SECONDS * (all - finished) / finished))
        left=$(printf '   (%d min %02d s left)' $((left / 60)) $((left % 60)))
      fi
    fi
    printf '%s%s\n' "$line" "$left"
  done
}

# with_fast_malloc COMMAND...: by jemalloc in huge pages where it is there, as it is elsewhere.
with_fast_malloc()
{
  local libraries=libjemalloc.so.2${LD_PRELOAD:+:$LD_PRELOAD}
  # The loader says on stderr which it does not find.
  if [[ -z $(LD_PRELOAD=$libraries cat 2>&1 < /dev/null) ]]; then
    LD_PRELOAD=$libraries MALLOC_CONF=thp:always "$@"
  else
    "$@"
  fi
}

# build PRESET [-D...] [--target TARGET...]: configures quietly and builds.
build()
{
  local log preset=$1 options=() targets=()
  shift
  while (($#)); do
    if [[ $1 == --target ]]; then targets+=(--target "$2"); shift 2; else options+=("$1"); shift; fi
  done
  log=$(mktemp)
  echo "building: $preset"
  if ! (cd "$root" && cmake --preset "$preset" "${options[@]}") > "$log" 2>&1; then
    cat "$log" >&2
    rm -f "$log"
    fail "could not configure: cmake --preset $preset"
  fi
  rm -f "$log"
  (cd "$root" && with_fast_malloc cmake --build --preset "$preset" --parallel "$(jobs_at_once)" "${targets[@]}") | with_time_left
}
