#!/bin/bash
# release_notes.sh SOURCE VERSION: experiments/support/release_notes.sh prints each section of CHANGELOG.md as it is, the version's own among them, and nothing else.

set -u
notes=$1/experiments/support/release_notes.sh changelog=$1/CHANGELOG.md version=$2
fail() { echo "FAILED: $*"; exit 1; }
lines() { grep -v '^$' "$@"; }

mapfile -t versions < <(grep -oP '^## \[\K[^]]*' "$changelog")
[[ " ${versions[*]} " == *" $version "* ]] || fail "CHANGELOG.md has no section of version $version"
# All sections, one after the other, are the file from its first heading on.
diff <(for v in "${versions[@]}"; do "$notes" "$v" || exit 1; done | lines) <(sed '1,/^## \[/d' "$changelog" | grep -v '^## \[' | lines) ||
  fail "the sections are not those of the file"
[[ $("$notes" "$version") == "### "* ]] || fail "the section of $version does not begin with its first heading"
[[ $("$notes") == "$("$notes" Unreleased)" ]] || fail "without a version it does not print what is not released"
for wrong in 9.9.9 "${version%.*}" "" "$version "; do
  said=$("$notes" "$wrong" 2>&1)
  (($? == 2)) && [[ $said == "CHANGELOG.md: no section '$wrong'; expected one of "*" $version"* ]] || fail "'$wrong': $said"
done
echo "${#versions[@]} sections"
