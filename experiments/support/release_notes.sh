#!/bin/bash
# release_notes.sh [VERSION]: prints what CHANGELOG.md says of a version; without one, of what is not yet released.

set -euo pipefail
changelog=$(dirname "${BASH_SOURCE[0]}")/../../CHANGELOG.md
version=${1-Unreleased}
known=$(sed -n 's/^## \[\([^]]*\)\].*/\1/p' "$changelog" | paste -sd ' ')
if (($# > 1)) || ! grep -qF "## [$version]" "$changelog"; then
  echo "CHANGELOG.md: no section '$*'; expected one of $known" >&2
  exit 2
fi
awk -v heading="## [$version]" '/^## \[/ { within = index($0, heading) == 1; next } within && (NF || begun) { begun = 1; print }' "$changelog"
