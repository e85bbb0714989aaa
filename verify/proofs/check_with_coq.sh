#!/bin/bash
# Has a sample of the proofs checked by Coq: scripts that the recorder writes, which Gappa proves and writes down as a proof that Coq reads.
# usage: check_with_coq.sh SCRIPTS...
# SCRIPTS are Gappa's, as TETRACONE_KEEP_PROOFS=FOLDER makes the tests keep them:
#     TETRACONE_KEEP_PROOFS=out/proofs build-asserts/verify/test_verify_proofs --run_test=test_all_proofs
#     verify/proofs/check_with_coq.sh out/proofs/*.g
# Needs the Debian packages gappa, coq, libcoq-flocq and libcoq-gappa. Exit status 2 when one is missing, 1 when a proof fails.
set -euo pipefail
(($#)) || { sed -n '2,8s/^# //p' "$0" >&2; exit 2; }
for program in gappa coqc; do
  command -v "$program" > /dev/null || { echo "$program: not found; expected: apt-get install gappa coq libcoq-flocq libcoq-gappa" >&2; exit 2; }
done

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0
for script; do
  gappa -Eprecision=200 -Bcoq "$script" > "$folder/proof.v" 2> "$folder/log" || { cat "$folder/log" >&2; exit 1; }
  if (cd "$folder" && coqc proof.v > log 2>&1); then
    echo "$script: $(grep -c '^Lemma' "$folder/proof.v") lemmas checked by Coq"
  else
    cat "$folder/log" >&2
    echo "$script: Coq refuses the proof" >&2
    failed=1
  fi
done
exit $failed
