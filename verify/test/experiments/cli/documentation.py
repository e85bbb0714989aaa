#!/usr/bin/python3
"""Commands that the documentation shows, against program and build: subcommands with their options, experiments, targets, and files of ours."""

import json
import os
import re
import shlex
import subprocess
import sys
import unittest

sys.dont_write_bytecode = True
SOURCE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "..")
PROGRAM = os.environ.get("TETRACONE_PROGRAM", "")
if not PROGRAM:
    print("skipped: no program")
    sys.exit(77)
BUILD = os.path.dirname(PROGRAM)
PAGES = ("README.md", "CONTRIBUTING.md", "kernel/README.md", "covering/README.md", "tetratree/README.md", "tetratree/glossary.md", "tetratree/python/README.md", "verify/README.md",
         "experiments/README.md", "experiments/artifact/README.md", "experiments/results/README.md", "experiments/speed/README.md", "experiments/subjects/README.md",
         "experiments/cluster/README.md", "verify/corpus/README.md", "tetratree/door/mainpage.md")
# Words for what the reader chooses.
NEW = {"NAME"}
# The longest that a page may be, in words, and in lines.
MOST_WORDS = {"README.md": 1200, "CONTRIBUTING.md": 1500}
MOST_LINES = {f"{folder}/README.md": 80 for folder in ("kernel", "covering", "tetratree", "verify", "experiments")}


def code_of(page):
    """The lines of blocks, continued ones joined, and the spans of code, each with where it stands. Paragraphs of a list are indented too."""
    with open(os.path.join(SOURCE, page), encoding="utf-8") as file:
        lines = re.sub(r" *\\\n\s*", " ", file.read()).split("\n")
    fenced = in_list = False
    for number, line in enumerate(lines, 1):
        at = f"{page}:{number}"
        if re.match(r"\s*(```|~~~)", line):
            fenced = not fenced
            continue
        in_list = bool(re.match(r"(\d+\.|-) ", line)) or (in_list and line[:1] in ("", " "))
        if fenced or line.startswith("       " if in_list else "    "):
            yield at, line.strip()
        else:
            for span in re.findall(r"`([^`]+)`", line):
                yield at, span


def commands():
    """Where, and the words of each command, without comments; a line may have several."""
    for page in PAGES:
        for at, code in code_of(page):
            for command in re.split(r"\s*(?:&&|\|\||[;|()])\s*", re.sub(r"\s#.*", "", code)):
                try:
                    words = shlex.split(re.sub(r"   +.*", "", command))  # columns of a table of commands
                except ValueError:
                    continue
                while words and re.fullmatch(r"\w+=\S*|time|taskset|-c|\d|\$?\w+=\$", words[0]):
                    words = words[1:]
                if words:
                    yield at, words, command


def read(page):
    with open(os.path.join(SOURCE, page), encoding="utf-8") as file:
        return file.read()


def rows_of(text):
    """The cells of each row of the tables of a page, heads left out."""
    lines = text.split("\n")
    return [[cell.strip().replace("\\|", "|") for cell in re.split(r"(?<!\\)\|", line)[1:-1]] for line, below in zip(lines, lines[1:] + [""])
            if line.startswith("|") and not line.startswith("|---") and not below.startswith("|---")]


def said(*words):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, check=True).stdout


class Documentation(unittest.TestCase):
    def test_each_command_of_the_program_is_one_and_takes_the_options_shown(self):
        known, helps, seen = set(re.findall(r"^  (\w+) ", said("--help").split("Subcommands:")[1], re.M)), {}, set()
        experiments = set(re.findall(r"^(\S+) ", said("experiment", "--list"), re.M)) | NEW
        for at, words, command in commands():
            if not re.fullmatch(r"((build|build-asserts)/)?tetracone", words[0]) or len(words) < 2 or not words[1].isalpha():
                continue
            with self.subTest(at=at, command=command):
                self.assertIn(words[1], known)
                seen.add(words[1])
                help_ = helps.setdefault(words[1], said(words[1], "--help"))
                for option in (word for word in words if word.startswith("--")):
                    self.assertRegex(help_, rf"(?<![\w-]){option.rstrip(',')}(?![\w-])")
                if words[1] == "experiment" and len(words) > 2 and not words[2].startswith("-"):
                    self.assertIn(words[2], experiments)
        self.assertEqual(seen, known)

    def test_each_target_is_one(self):
        with open(os.path.join(BUILD, "build.ninja")) as file:
            targets = set(re.findall(r"^build (\S+):", file.read(), re.M))
        seen = 0
        for at, words, command in commands():
            if words[:2] == ["cmake", "--build"] and "--target" in words:
                for target in words[words.index("--target") + 1:]:
                    if target not in NEW:
                        with self.subTest(at=at, command=command):
                            self.assertIn(target, targets)
                            seen += 1
        self.assertGreater(seen, 10)

    def test_each_file_of_ours_is_there(self):
        seen = 0
        for page in PAGES:
            folder = os.path.join(SOURCE, os.path.dirname(page))
            for at, code in code_of(page):
                # A folder's own page names its files from there.
                first = r"[a-z_]+" if page.count("/") == 1 and page != "experiments/README.md" else "(?:kernel|covering|tetratree|verify|experiments)"
                for name in re.findall(rf"(?<![\w/.-]){first}/[\w./-]*\.(?:sh|py|h|inl|cpp|cmake|sbatch|md|csv|txt)\b", code):
                    if name in NEW or name.startswith("tetracone/") or re.search(r"FOLDER|ROOM|NAME|/X\.", name):
                        continue
                    with self.subTest(at=at, file=name):
                        self.assertTrue(any(os.path.exists(os.path.join(of, name)) for of in (SOURCE, folder)))
                        seen += 1
        self.assertGreater(seen, 40)

    def test_pages_are_short(self):
        for page, most in MOST_WORDS.items():
            with open(os.path.join(SOURCE, page), encoding="utf-8") as file:
                self.assertLessEqual(len(file.read().split()), most, page)
        for page, most in MOST_LINES.items():
            with open(os.path.join(SOURCE, page), encoding="utf-8") as file:
                self.assertLessEqual(len(file.readlines()), most, page)

    def test_tables_of_rooms_name_the_rooms_that_there_are(self):
        for folder in ("kernel", "tetratree", "verify", "experiments"):
            with open(os.path.join(SOURCE, folder, "README.md"), encoding="utf-8") as file:
                named = {room for row in re.findall(r"^\| (`[a-z_/`, ]+`) \|", file.read(), re.M) for room in re.findall(r"`([a-z_]+)/`", row)}
            there = {entry.name for entry in os.scandir(os.path.join(SOURCE, folder)) if entry.is_dir() and not entry.name.startswith("_")}
            self.assertEqual(named, there, folder)

    def test_the_packages_to_install_are_those_that_are_built_with(self):
        with open(os.path.join(SOURCE, "experiments", "support", "setup.sh")) as file:
            built_with = set(re.search(r"^build_packages=\((.*?)\)", file.read(), re.M | re.S)[1].split())
        for page in ("README.md", "tetratree/door/mainpage.md"):
            (shown,) = (words[2:] for at, words, command in commands() if at.startswith(page) and words[:2] == ["apt-get", "install"] and "g++" in words)
            # Not the tests', and not the viewer's.
            self.assertEqual(set(shown), built_with - {"libboost-test-dev", "libjs-three"}, page)

    def test_the_version_is_the_same_everywhere(self):
        """It is written in CMakeLists.txt: what cannot read it there agrees with it."""
        version = re.search(r"project\(tetracone VERSION (\d+\.\d+\.\d+) ", read("CMakeLists.txt"))[1]
        citation = read("CITATION.cff")
        date = re.search(r"^date-released: (\d{4}-\d\d-\d\d)$", citation, re.M)[1]
        self.assertEqual(re.findall(r"^version: (.*)$", citation, re.M), [version])
        self.assertEqual(json.loads(read(".zenodo.json"))["version"], version)
        self.assertIn(f"\n## [{version}] - {date}\n", read("CHANGELOG.md"))
        how = re.search(r"^regex = '(.*)'$", read("pyproject.toml"), re.M)[1]
        self.assertEqual(re.search(how, read("CMakeLists.txt"))["value"], version)
        for page in ("README.md", "tetratree/door/mainpage.md"):
            self.assertEqual(re.findall(r"find_package\(tetracone (\S+) REQUIRED\)", read(page)), [version.rpartition(".")[0]], page)

    def test_the_metadata_of_the_archive_are_those_of_the_citation(self):
        of_program, references = read("CITATION.cff").split("\nreferences:\n")
        value = dict(re.findall(r'^([a-z-]+): "?(.*?)"?$', of_program, re.M))
        listed = {key: re.findall(r'^  - (?:name: )?"?(.*?)"?$', text, re.M) for key, text in re.findall(r"^([a-z]+):\n((?:  .*\n?)+)", of_program, re.M)}
        archive = json.loads(read(".zenodo.json"))
        self.assertEqual((archive["title"], archive["description"], archive["license"], archive["upload_type"]),
                         (value["title"], value["abstract"], value["license"], value["type"]))
        self.assertEqual([creator["name"] for creator in archive["creators"]], listed["authors"])
        self.assertEqual(archive["keywords"], listed["keywords"])
        self.assertEqual([entry["identifier"] for entry in archive["related_identifiers"]], re.findall(r"^    doi: (.*)$", references, re.M))
        python = read("pyproject.toml")
        self.assertIn(f'license = {{ text = "{value["license"]}" }}', python)
        self.assertEqual(json.loads(re.search(r"^keywords = (.*)$", python, re.M)[1]), archive["keywords"])

    def test_each_number_of_the_readme_has_a_row_for_reviewers(self):
        rows = [row for row in rows_of(read("experiments/artifact/README.md")) if len(row) == 5]
        claims = [row[0] for row in rows]
        for name, *_ in rows_of(read("README.md").split("## How fast")[1].split("\n## ")[0]):
            self.assertIn(name, claims)
        # What writes the results, and says so.
        written = said("report", "--help") + "".join(map(read, ("experiments/README.md", "reproduce", "experiments/artifact/figure", "experiments/machines/same_answers.sh")))
        tests = 0
        for claim, command, minutes, file, tolerance in rows:
            with self.subTest(claim=claim):
                words = shlex.split(command.strip("`"))
                if command != "as above" and not words[0].startswith("build/"):
                    self.assertTrue(os.access(os.path.join(SOURCE, words[0]), os.X_OK), words[0])
                if words[:2] == ["./test", "-R"]:
                    listed = subprocess.run(["ctest", "--test-dir", BUILD, "-N", "-R", words[2]], capture_output=True, text=True, check=True).stdout
                    self.assertNotIn("Total Tests: 0", listed)
                    tests += 1
                for name in re.findall(r"`out/(?:\w+/)*(?:verify_)?(\w+)\.\w+`", file):
                    self.assertRegex(written, rf"\b{name}\b")
                self.assertTrue("`out/" in file or file == "its status", file)
                self.assertGreater(int(minutes), 0)
                self.assertTrue(tolerance)
        self.assertGreater(tests, 1)


if __name__ == "__main__":
    unittest.main()
