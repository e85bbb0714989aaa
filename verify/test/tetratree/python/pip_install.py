#!/usr/bin/python3
"""`pip install .` without a network: the package answers, its version is CMake's, and numpy is all that it asks for."""

import glob
import os
import re
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
SOURCE = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", ".."))
for module in ("pip", "scikit_build_core"):
    if subprocess.run([sys.executable, "-c", f"import {module}"], cwd="/", capture_output=True).returncode:
        print(f"skipped: no {module}; expected the packages python3-pip and python3-scikit-build-core (Debian 12: of its backports)")
        sys.exit(77)


class Pip(unittest.TestCase):
    def test_pip_installs_a_package_that_answers(self):
        with tempfile.TemporaryDirectory() as target:
            # The door alone: the harness would take as long again. numpy is asked for below.
            done = subprocess.run([sys.executable, "-m", "pip", "install", "--no-build-isolation", "--no-index", "--no-deps", "--target", target,
                                   "--config-settings=build.targets=_tetracone", "--config-settings=cmake.build-type=Asserts", SOURCE], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            for name in ("__init__.py", "__init__.pyi", "py.typed"):
                self.assertTrue(os.path.exists(os.path.join(target, "tetracone", name)), name)
            self.assertFalse(os.path.exists(os.path.join(target, "tetracone", "verify.py")))  # what it needs was not built
            with open(os.path.join(SOURCE, "CMakeLists.txt")) as file:
                version = re.search(r"project\(tetracone VERSION (\S+)", file.read())[1]
            (metadata,) = glob.glob(os.path.join(target, "tetracone-*.dist-info", "METADATA"))
            with open(metadata) as file:
                text = file.read()
            self.assertEqual(re.findall(r"^Version: (.*)$", text, re.M), [version])
            self.assertEqual([re.sub(r"[^a-z].*", "", name) for name in re.findall(r"^Requires-Dist: (.*)$", text, re.M)], ["numpy"])
            said = subprocess.run([sys.executable, "-c", "import doctest, tetracone as t; print(doctest.testmod(t), t.__version__, t.__file__)"], cwd="/",
                                  capture_output=True, text=True, env=dict(os.environ, PYTHONPATH=target))
            self.assertRegex(said.stdout, rf"failed=0, attempted=[1-9].* {version} {target}/", said.stderr)


if __name__ == "__main__":
    unittest.main()
