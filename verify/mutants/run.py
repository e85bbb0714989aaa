#!/usr/bin/env python3
"""Plants each error of mutants.json in a copy of the headers and asks the test of verify/test that the list names whether it is noticed.

usage: run.py BUILD [--out FOLDER] [--only WORD] [--left] [--jobs N] [--csv FILE]

BUILD is a built tree with the libraries `tetracone_library`, `tetracone_repair` and `truths`. A mutant is killed when its test fails, or does
not end. A mutant with the field `harmless` survives, for the reason that the field gives.
Exit status 1 when another one survives, when a harmless one is killed, or when one does not compile: an error of the list.
The field `units` names sources that are compiled with the test: the mutated source and what calls it, from the mutated copy. Those of verify
are compiled as they are, with the mutated headers. All other sources are as the libraries have compiled them, without the error.

Each result is kept in FOLDER (default BUILD/mutants) as soon as it is known. The digests of all files that its judge has compiled, and of the
library's objects that it was linked with, are kept too. The result counts as long as these are the same, so that a stopped run goes on. After a
change, those mutants are judged again whose judge has compiled or linked what has changed. N mutants (default: the number of cores) are tried
at a time.

FILE gets a row a mutant, in the list's order: when it was judged, from which version and commit, by what, and what was found. Rows of mutants
that are not asked about stay. --left asks about those that FILE has no row of by the judge that the
list names, or that survived there. On two cores the list takes about an
hour.
"""
import argparse
import collections
import concurrent.futures
import csv
import datetime
import hashlib
import io
import json
import os
import pathlib
import re
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
TEST = ["-Wno-psabi", "-DCGAL_NO_CDT_2_WARNING", "-DBOOST_TEST_DYN_LINK", "-DBOOST_TEST_MODULE=mutant"]
LINK_TEST = ["-lboost_unit_test_framework", "-ltbb"]
SECONDS = 600  # a test of right headers takes 60 at most
# What no mutant changes, and is half of a compilation: precompiled once.
OUTSIDE = ("CGAL/Exact_predicates_exact_constructions_kernel.h", "CGAL/Exact_predicates_inexact_constructions_kernel.h", "CGAL/Interval_nt.h",
           "CGAL/Mpzf.h", "CGAL/Simple_cartesian.h", "CGAL/gmpxx.h", "Eigen/Eigenvalues", "Eigen/Geometry", "algorithm", "functional",
           "iostream", "map", "optional", "string", "vector")

def digest_of(data):
    return hashlib.sha256(data).hexdigest()[:16]

def planted(text, mutant):
    if text.count(mutant["old"]) != 1:
        sys.exit(f"{mutant['file']}: the old text of '{mutant['name']}' occurs {text.count(mutant['old'])} times; expected once")
    return text.replace(mutant["old"], mutant["new"])

def copy_tree(folder):
    shutil.rmtree(folder, ignore_errors=True)
    for name in HEADERS:
        shutil.copytree(SOURCE / name, folder / "tetracone" / name)

def judge_of(mutant):
    return f"verify/test/{mutant['test']}.cpp"

def compiler():
    return os.environ.get("CXX", "c++")

def precompiled(out, eigen):
    """The options that include OUTSIDE, precompiled in the folder `out`; none where the compiler is not GCC, which alone looks for NAME.gch."""
    version = subprocess.run([compiler(), "--version"], capture_output=True, text=True).stdout
    if "Free Software Foundation" not in version:
        return []
    text = "".join(f"#include <{name}>\n" for name in OUTSIDE)
    header = out / f"outside_{digest_of(repr((version, COMPILE, text)).encode())}.h"
    if not header.with_suffix(".h.gch").exists():
        header.write_text(text)
        subprocess.run([compiler(), *COMPILE, f"-I{eigen}", str(header), "-o", f"{header}.new"], check=True)
        pathlib.Path(f"{header}.new").rename(f"{header}.gch")
    return ["-include", str(header)]

class Sources:
    """Digests of the files of the project and of the objects of its libraries, as they are now."""

    def __init__(self, build):
        self.build, self.files, self.members = build, {}, None
        self.lock = threading.Lock()

    def file(self, name):
        with self.lock:
            if name not in self.files:
                path = SOURCE / name
                self.files[name] = digest_of(path.read_bytes()) if path.is_file() else None
            return self.files[name]

    def object(self, name):
        """The digest of a member of an archive, as of "libtetracone.a(body.cpp.o)". None where it cannot be read."""
        with self.lock:
            if name not in self.files:
                archive, member = re.fullmatch(r"(.*)\((.*)\)", name).groups()
                read = subprocess.run(["ar", "p", str(self.build / archive), member], capture_output=True)
                self.files[name] = digest_of(read.stdout) if read.returncode == 0 else None
            return self.files[name]

    def are_as(self, used):
        return all((self.object(name) if name.endswith(")") else self.file(name)) == digest for name, digest in used.items())

    def used(self, folder, dependencies, trace):
        """The project's files that a compilation from `folder` has read, and the objects that it was linked with, with their digests."""
        found = {}
        for path in dependencies:
            path = pathlib.Path(os.path.normpath(path))
            if path.is_relative_to(folder / "tetracone"):
                name = str(path.relative_to(folder / "tetracone"))
            elif path.is_relative_to(folder):
                name = str(path.relative_to(folder))
            elif path.is_relative_to(SOURCE):
                name = str(path.relative_to(SOURCE))
            else:
                continue
            if self.file(name) is not None:
                found[name] = self.file(name)
        for line in trace.splitlines():
            match = re.match(r"\(?(.*/)?(lib(?:truths|tetracone\w*)\.a)[(:)]*([^():]+\.o)\)?$", line.strip())
            if match:
                name = f"{match[2]}({match[3]})"
                found[name] = self.object(name)
        return found

def build_judge(folder, options, mutant, build):
    """Compiles and links what judges the headers in `folder`. Returns the error or None, the files that were read, and the linker's trace."""
    units = mutant.get("units", ())
    libraries = [str(build / name) for name in ("libtruths.a", "libtetracone_repair.a", "libtetracone.a")]
    sources = [SOURCE / judge_of(mutant), *(SOURCE / unit if unit.startswith("verify/") else folder / "tetracone" / unit for unit in units)]
    more = [f"-I{SOURCE}", f'-DTETRACONE_SOURCE_DIR="{SOURCE}"', f'-DTETRACONE_PYTHON="{sys.executable}"', *TEST]
    objects, read = [], []
    for number, source in enumerate(sources):
        made = folder / f"unit_{number}.o"
        built = subprocess.run([compiler(), *COMPILE, *options, f"-I{folder}", *more, "-MD", "-c", str(source), "-o", str(made)],
                               capture_output=True, text=True)
        if built.returncode != 0:
            return next((line for line in built.stderr.splitlines() if "error" in line), "?"), [], ""
        objects.append(str(made))
        read += made.with_suffix(".d").read_text().replace("\\\n", " ").split()[1:]
    # All sources but the units are the built ones. The units' objects come before the libraries, and the first definition counts.
    linked = subprocess.run([compiler(), *objects, "-Wl,--trace", *(["-Wl,--allow-multiple-definition"] if units else []), *libraries,
                             *LINK_TEST, *LINK, "-o", str(folder / "judge")], capture_output=True, text=True)
    if linked.returncode != 0:
        return next((line for line in linked.stderr.splitlines() if "undefined" in line or "error" in line), "?"), [], ""
    return None, read, linked.stdout

def asked(folder):
    """What the judge says: "killed" and by what, or "survived"."""
    try:
        run = subprocess.run([str(folder / "judge")], capture_output=True, text=True, errors="replace", timeout=SECONDS,
                             env={**os.environ, "BOOST_TEST_COLOR_OUTPUT": "0"})
    except subprocess.TimeoutExpired:
        return "killed", "does not end"
    if run.returncode == 0:
        return "survived", ""
    said = (run.stdout + run.stderr).replace(f"{folder}/", "")
    lines = [line.strip() for line in said.splitlines() if line.strip()]
    case = next((match[1] for line in lines if (match := re.search(r'error: in "([^"]+)"', line))), None)
    return "killed", case or (lines[-1] if lines else f"ends with {run.returncode}")

def eigen_folder():
    flags = subprocess.run(["pkg-config", "--cflags-only-I", "eigen3"], capture_output=True, text=True).stdout.split()
    return flags[0][2:] if flags else "/usr/include/eigen3"

def write(path, text):
    new = path.with_name(path.name + ".new")
    new.write_text(text)
    new.rename(path)

def version():
    return re.search(r"project\(tetracone VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text())[1]

def commit():
    """The commit of the sources, with a + where they differ from it; empty where there is no repository."""
    def git(*words):
        return subprocess.run(["git", "-C", str(SOURCE), *words], capture_output=True, text=True).stdout.strip()
    at = git("rev-parse", "--short=10", "HEAD")
    return at + ("+" if at and git("status", "--porcelain", "--untracked-files=no") else "")


COLUMNS = ("date", "version", "commit", "file", "name", "judge", "outcome", "by")


def rows_of(path):
    """The rows of a table, by names of mutants; none where there is no table."""
    if not (path and path.exists()):
        return {}
    with path.open(newline="") as file:
        return {row["name"]: row for row in csv.DictReader(file)}


def row_of(mutant, result):
    harmless = "harmless" in mutant and result["outcome"] == "survived"
    return dict(zip(COLUMNS, (result["date"], result["version"], result["commit"], mutant["file"], mutant["name"], judge_of(mutant),
                              "harmless" if harmless else result["outcome"], mutant["harmless"] if harmless else result["by"])))


def table(rows):
    text = io.StringIO()
    writer = csv.DictWriter(text, COLUMNS, lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return text.getvalue()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--only", default="", help="mutants whose name has this word")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--csv", type=pathlib.Path, help="the table of all results; rows of what is not asked about stay")
    parser.add_argument("--left", action="store_true", help="mutants that the table has no row of, or that survived")
    args = parser.parse_args()
    if args.left and not args.csv:
        parser.error("--left: no table; expected --csv FILE")
    rows = rows_of(args.csv)
    out = (args.out or args.build / "mutants").resolve()
    out.mkdir(parents=True, exist_ok=True)

    all_mutants = json.loads((HERE / "mutants.json").read_text())
    settled = {(name, row["judge"]) for name, row in rows.items() if args.left and row["outcome"] in ("killed", "harmless")}
    mutants = [m for m in all_mutants if args.only in m["name"] and (m["name"], judge_of(m)) not in settled]
    for mutant in mutants:
        planted((SOURCE / mutant["file"]).read_text(), mutant)
        for unit in mutant.get("units", ()):
            if not (unit.endswith(".cpp") and (SOURCE / unit).is_file()):
                sys.exit(f"{unit}: no unit of '{mutant['name']}'; expected a source that is there")

    results_file, sources, this = out / "results.json", Sources(args.build), {"version": version(), "commit": commit()}
    results = json.loads(results_file.read_text()) if results_file.exists() else {}
    options = [f"-I{eigen_folder()}", *precompiled(out, eigen_folder())]
    judges = list(dict.fromkeys((m["test"], tuple(m.get("units", ()))) for m in mutants))
    unplanted = [{"name": f"none, by {test}", "file": None, "test": test, **({"units": units} if units else {})} for test, units in judges]
    unwritten = threading.Lock()

    def result(mutant):
        what = {name: mutant.get(name) for name in ("file", "old", "new", "test", "units")}
        key = digest_of(json.dumps(what, sort_keys=True).encode())
        if key in results and sources.are_as(results[key].get("used", {"": ""})):
            return results[key]
        start, folder = time.monotonic(), out / f"tree-{key}"
        copy_tree(folder)
        if mutant["file"]:
            path = folder / "tetracone" / mutant["file"]
            path.write_text(planted(path.read_text(), mutant))
        error, read, trace = build_judge(folder, options, mutant, args.build)
        outcome, by = ("does not compile", error) if error else asked(folder)
        found = {"outcome": outcome, "by": by, "date": datetime.date.today().isoformat(), **this, "seconds": round(time.monotonic() - start),
                 "name": mutant["name"], "used": sources.used(folder, read, trace)}
        shutil.rmtree(folder)
        if not error:
            with unwritten:
                results[key] = found
                write(results_file, json.dumps(results, indent=1) + "\n")
        return found

    def is_expected(mutant, outcome):
        return outcome == ("killed" if mutant["file"] and "harmless" not in mutant else "survived")

    bad, found, start = 0, [], time.monotonic()
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for mutant, of in zip(unplanted + mutants, pool.map(result, unplanted + mutants)):
            found.append(of)
            is_right = is_expected(mutant, of["outcome"])
            bad += not is_right
            said = f"harmless: {mutant['harmless']}" if is_right and "harmless" in mutant else f"{of['outcome']}{': ' if of['by'] else ''}{of['by']}"
            print(f"{mutant['name']:70}  {said}{'' if is_right else '  <- expected otherwise'}", flush=True)
    found = found[len(unplanted):]
    count = collections.Counter("harmless" if "harmless" in m and r["outcome"] == "survived" else r["outcome"] for m, r in zip(mutants, found))
    seconds = sum(r["seconds"] for r in found)
    print(f"{len(mutants)} mutants: {', '.join(f'{n} {what}' for what, n in sorted(count.items()))}; {bad} not as expected, judges without an "
          f"error included; {time.monotonic() - start:.0f} s, {seconds / max(1, len(found)):.0f} s a mutant when it was judged")
    if args.csv and count["does not compile"] == 0:
        rows |= {mutant["name"]: row_of(mutant, result) for mutant, result in zip(mutants, found)}
        write(args.csv, table(rows[m["name"]] for m in all_mutants if m["name"] in rows))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
