#!/usr/bin/python3
"""Runs every notebook of verify/python/notebooks/: each must run to its end. Skipped where Jupyter is not there."""

import os
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "tetratree", "python"))
from support import skip

try:
    import ipykernel  # noqa: F401
    import nbconvert  # noqa: F401
except ModuleNotFoundError as missing:
    skip(f"no {missing.name}")

NOTEBOOKS = os.path.join(HERE, "..", "..", "..", "python", "notebooks")


class Notebooks(unittest.TestCase):
    def test_each_runs_to_its_end(self):
        names = sorted(os.listdir(NOTEBOOKS))
        self.assertEqual(names, ["chart_your_own_method.ipynb", "first_exact_query.ipynb"])
        with tempfile.TemporaryDirectory() as folder:
            # A kernel of the Python that runs this, whatever else is installed; nothing is written elsewhere.
            kernel = os.path.join(folder, "data", "kernels", "python3")
            os.makedirs(kernel)
            with open(os.path.join(kernel, "kernel.json"), "w") as file:
                file.write('{"argv": ["%s", "-B", "-m", "ipykernel_launcher", "-f", "{connection_file}"], "display_name": "Python 3", '
                           '"language": "python"}' % sys.executable)
            environment = dict(os.environ, JUPYTER_DATA_DIR=os.path.join(folder, "data"), JUPYTER_RUNTIME_DIR=folder, IPYTHONDIR=folder,
                               JUPYTER_CONFIG_DIR=folder, MPLCONFIGDIR=folder)
            for name in names:
                with self.subTest(name):
                    said = subprocess.run([sys.executable, "-B", "-m", "nbconvert", "--to", "notebook", "--execute", "--output-dir", folder,
                                           os.path.join(NOTEBOOKS, name)], env=environment, capture_output=True, text=True)
                    self.assertEqual(said.returncode, 0, said.stderr)


if __name__ == "__main__":
    unittest.main()
