#!/bin/bash
# build.sh FOLDER: compiles the proofs, extracts the checks, and leaves the checker as FOLDER/check, and what the theorems assume as
# FOLDER/assumptions. Needs Debian's coq, ocaml-nox, ocaml-findlib and libzarith-ocaml-dev; status 77 and a line without them.

set -e
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=${1:?expected a folder for what is built}
for tool in coqc ocamlfind ocamlopt; do
  command -v $tool > /dev/null || { echo "skipped: no $tool; expected the packages coq, ocaml-nox, ocaml-findlib, libzarith-ocaml-dev"; exit 77; }
done
ocamlfind query zarith > /dev/null 2>&1 || { echo "skipped: no zarith; expected the package libzarith-ocaml-dev"; exit 77; }

mkdir -p "$folder"
cp "$here"/*.v "$here"/*.ml "$folder"
cd "$folder"
for file in Space Exact Faces Cuts Covers Claims Placed Rays Forms Motions Signs Unique; do
  coqc -q -Q . Certificates $file.v
done
coqc -q -Q . Certificates Assumptions.v > assumptions
coqc -q -Q . Certificates Extract.v
ocamlfind ocamlopt -package zarith -linkpkg -w -a sha256.ml core.mli core.ml main.ml -o check
