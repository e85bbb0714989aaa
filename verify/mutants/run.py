#!/usr/bin/env python3
"""Plants each error of mutants.json in a copy of the headers and asks probe.cpp whether it is noticed; or, where the list names one, a test
of verify/test: of headers whose errors are hidden from all answers by what stands behind them.

usage: run.py BUILD [--out FOLDER] [--only WORD] [--jobs N]

BUILD is a built tree with the target `mutant_cases`, which writes the cases and their truths. A mutant is killed when the probe finds a
wrong answer, or the test fails, or either does not end. Exit status 1 when one survives, or when one does not compile: an error of the
list. Of a mutant that names `units`, these sources of the library, the mutated one and what calls it, are compiled
with the test from the mutated copy, and those of verify by the mutated headers; else what the library has compiled is right.
The results are kept in FOLDER (default BUILD/mutants) and not computed again: what was stopped goes on; remove the folder to begin anew.
N mutants (default: the number of cores) are tried at a time.
"""
import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import threading
import time

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parent.parent
HEADERS = ("kernel", "covering", "tetratree")
COMPILE = ["-std=c++20", "-O1", "-frounding-math", "-ffp-contract=off", "-DCGAL_USE_GMPXX=1"]
LINK = ["-lhwy", "-lgmpxx", "-lgmp", "-lmpfr"]
TEST = ["-Wno-psabi", "-DCGAL_NO_CDT_2_WARNING", "-DBOOST_TEST_DYN_LINK", "-DBOOST_TEST_MODULE=mutant", "-lboost_unit_test_framework", "-ltbb"]
SECONDS = 600  # a probe of right headers takes some 60
# What no mutant changes, and is half of a compilation: precompiled once.
OUTSIDE = ("CGAL/Exact_predicates_exact_constructions_kernel.h", "CGAL/Exact_predicates_inexact_constructions_kernel.h", "CGAL/Interval_nt.h",
           "CGAL/Mpzf.h", "CGAL/Simple_cartesian.h", "CGAL/gmpxx.h", "Eigen/Eigenvalues", "Eigen/Geometry", "algorithm", "functional",
           "iostream", "map", "optional", "string", "vector")


def planted(text, mutant):
    if text.count(mutant["old"]) != 1:
        sys.exit(f"{mutant['file']}: the old text of '{mutant['name']}' occurs {text.count(mutant['old'])} times; expected once")
    return text.replace(mutant["old"], mutant["new"])


def copy_tree(folder):
    shutil.rmtree(folder, ignore_errors=True)
    for name in HEADERS:
        shutil.copytree(SOURCE / name, folder / "tetracone" / name)
    (folder / "verify" / "cases").mkdir(parents=True)
    for name in ("case.h", "random.h"):
        shutil.copy(SOURCE / "verify" / "cases" / name, folder / "verify" / "cases" / name)


def test_source(mutant):
    return SOURCE / "verify" / "test" / f"{mutant['test']}.cpp" if "test" in mutant else None


def compiler():
    return os.environ.get("CXX", "c++")


def precompiled(out, eigen):
    """The options that include OUTSIDE, precompiled in the folder `out`; none where the compiler is not GCC, which alone looks for NAME.gch."""
    if "Free Software Foundation" not in subprocess.run([compiler(), "--version"], capture_output=True, text=True).stdout:
        return []
    header = out / "outside.h"
    header.write_text("".join(f"#include <{name}>\n" for name in OUTSIDE))
    subprocess.run([compiler(), *COMPILE, f"-I{eigen}", str(header), "-o", f"{header}.gch"], check=True)
    return ["-include", str(header)]


def probe(folder, cases, options, test, build, units=()):
    """What the probe, or the test if it is not None, says of the headers in `folder`: "killed: ...", "survived" or "does not compile: ..."."""
    program = folder / "probe"
    # What is no header is the built one, but for the units: what is defined first counts.
    libraries = [str(build / name) for name in ("libtruths.a", "libtetracone_repair.a", "libtetracone.a")]
    sources = [str(SOURCE / unit if unit.startswith("verify/") else folder / "tetracone" / unit) for unit in units] + (["-Wl,--allow-multiple-definition"] if units else [])
    source, more = (test, [f"-I{SOURCE}", f'-DTETRACONE_SOURCE_DIR="{SOURCE}"', *sources, *libraries, *TEST]) if test else (HERE / "probe.cpp", [])
    built = subprocess.run([compiler(), *COMPILE, *options, f"-I{folder}", str(source), *more, *LINK, "-o", str(program)],
                           capture_output=True, text=True)
    if built.returncode != 0:
        return "does not compile: " + next((line for line in built.stderr.splitlines() if "error" in line), "?")
    try:
        run = subprocess.run([str(program)] if test else [str(program), str(cases)], capture_output=True, text=True, timeout=SECONDS,
                             env={**os.environ, "BOOST_TEST_COLOR_OUTPUT": "0"})
    except subprocess.TimeoutExpired:
        return "killed: does not end"
    if run.returncode == 0:
        return "survived"
    lines = (run.stdout + run.stderr).strip().splitlines()
    return "killed: " + (lines[-1] if lines else f"ends with {run.returncode}")


def eigen_folder():
    flags = subprocess.run(["pkg-config", "--cflags-only-I", "eigen3"], capture_output=True, text=True).stdout.split()
    return flags[0][2:] if flags else "/usr/include/eigen3"


def write(path, results):
    path.with_suffix(".new").write_text(json.dumps(results, indent=2) + "\n")
    path.with_suffix(".new").rename(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--only", default="", help="mutants whose name has this word")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    args = parser.parse_args()
    out = args.out or args.build / "mutants"
    out.mkdir(parents=True, exist_ok=True)

    cases, program = out / "cases.txt", args.build / "verify" / "mutant_cases"
    if not cases.exists():
        if not program.exists():
            sys.exit(f"{program}: not there; expected a build folder with the target mutant_cases built")
        with open(cases.with_suffix(".new"), "w") as file:
            if subprocess.run([str(program)], stdout=file).returncode != 0:
                sys.exit(f"{program}: failed; expected the cases that it writes")
        cases.with_suffix(".new").rename(cases)

    # A result counts for the headers, the proofs of their constants, the cases and the probe that it was found with.
    digest = hashlib.sha256(cases.read_bytes() + (HERE / "probe.cpp").read_bytes())
    for name in (*HEADERS, "verify/proofs"):
        for header in sorted((SOURCE / name).rglob("*.[chi]*")):
            digest.update(header.read_bytes())
    results_file = out / "results.json"
    results = json.loads(results_file.read_text()) if results_file.exists() else {}

    options = [f"-I{eigen_folder()}", *precompiled(out, eigen_folder())]
    mutants = [m for m in json.loads((HERE / "mutants.json").read_text()) if args.only in m["name"]]
    for mutant in mutants:
        planted((SOURCE / mutant["file"]).read_text(), mutant)
    judges = list(dict.fromkeys((m.get("test"), tuple(m.get("units", ()))) for m in mutants))  # None is the probe
    unplanted = [{"name": f"none, by {test or 'the probe'}", "file": None, **({"test": test} if test else {}), **({"units": units} if units else {})}
                 for test, units in judges]
    unwritten = threading.Lock()

    def result(mutant):
        test = test_source(mutant)
        key = hashlib.sha256((digest.hexdigest() + json.dumps(mutant, sort_keys=True)).encode() + (test.read_bytes() if test else b"")).hexdigest()
        if key not in results:
            folder = out / f"tree-{key[:16]}"
            copy_tree(folder)
            if mutant["file"]:
                path = folder / "tetracone" / mutant["file"]
                path.write_text(planted(path.read_text(), mutant))
            found = probe(folder, cases, options, test, args.build, mutant.get("units", ()))
            shutil.rmtree(folder)
            with unwritten:
                results[key] = found
                write(results_file, results)
        return results[key]

    bad, start = 0, time.monotonic()
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for mutant, found in zip(unplanted + mutants, pool.map(result, unplanted + mutants)):
            print(f"{mutant['name']:70}  {found}", flush=True)
            bad += not found.startswith("killed" if mutant["file"] else "survived")
    print(f"{len(mutants)} mutants, {bad} not killed or judged by what fails without them; {time.monotonic() - start:.0f} s")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
