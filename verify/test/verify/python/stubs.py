#!/usr/bin/python3
"""The stubs of `tetracone` and `tetracone.verify` against the modules: names, members, parameters with their defaults, and words that can be given."""

import ast
import inspect
import os
import subprocess
import sys
import tempfile
import unittest

TESTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tetratree", "python")
sys.path.insert(0, TESTS)
from support import SKIPPED

import tetracone
from tetracone import verify


def stub_of(name):
    with open(os.path.join(os.path.dirname(tetracone.__file__), name)) as file:
        return ast.parse(file.read()).body


def parameters(function):
    """Names and defaults of a definition; a name that is a keyword alone has a star."""
    a = function.args
    names = [p.arg for p in a.posonlyargs + a.args] + ["*" + p.arg for p in a.kwonlyargs]
    defaults = [None] * (len(a.posonlyargs + a.args) - len(a.defaults)) + [d and ast.literal_eval(d) for d in a.defaults + a.kw_defaults]
    return list(zip(names, defaults))


def real_parameters(function):
    """Names and defaults of a module's function, as `parameters` returns them. One in C++ says them in its documentation's first line."""
    try:
        given = inspect.signature(function).parameters.values()
    except ValueError:
        line = function.__doc__.splitlines()[0]
        return parameters(ast.parse(f"def {line}: ...").body[0])
    return [("*" * (p.kind is p.KEYWORD_ONLY) + p.name, None if p.default is p.empty else p.default) for p in given]


def names_of(body):
    """What a stub says that there is: not its imports, nor the names of types that it makes for itself."""
    for node in body:
        if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            yield node.name, node
        elif isinstance(node, ast.AnnAssign):
            yield node.target.id, node


class Stubs(unittest.TestCase):
    def compare_class(self, real, stub):
        members = dict(names_of(stub.body))
        if hasattr(real, "_fields"):
            self.assertEqual(list(members), list(real._fields), real)
            return
        for node in stub.body:
            if isinstance(node, ast.Assign):  # another name of a method
                members[node.targets[0].id] = members[node.value.id]
        there = {name for name in vars(real) if (name == "__len__" or not name.startswith("_")) and vars(real)[name] is not None}
        self.assertEqual({name for name, node in members.items() if isinstance(node, ast.FunctionDef) and name != "__init__"}, there, real)
        for name, node in members.items():
            if not isinstance(node, ast.FunctionDef):
                continue
            is_property = [d.id for d in node.decorator_list] == ["property"]
            self.assertEqual(isinstance(vars(real)[name], property), is_property, (real, name))
            if not is_property:
                self.assertEqual(parameters(node), real_parameters(getattr(real, name)), (real, name))

    def compare(self, module, there, stub):
        said = dict(names_of(stub))
        self.assertEqual(set(said), there)
        for name, node in said.items():
            real = getattr(module, name)
            if isinstance(node, ast.ClassDef):
                self.compare_class(real, node)
            elif isinstance(node, ast.FunctionDef):
                self.assertEqual(parameters(node), real_parameters(real), name)
            else:
                self.assertFalse(callable(real), name)

    def test_of_the_package(self):
        self.compare(tetracone, {*tetracone.__all__, "__version__"}, stub_of("__init__.pyi"))

    def test_of_the_harness(self):
        self.compare(verify, {name for name in vars(verify) if not name.startswith("_")}, stub_of("verify.pyi"))

    def test_words_are_those_that_there_are(self):
        (query,) = (node for name, node in names_of(stub_of("__init__.pyi")) if name == "Query")
        (made,) = (node for name, node in names_of(query.body) if name == "__init__")
        (method,) = (p.annotation for p in made.args.args if p.arg == "method")
        self.assertEqual(ast.literal_eval(method.slice), tetracone.methods)

    def test_every_file_s_name_may_be_bytes(self):
        paths = 0
        for stub in map(stub_of, ("__init__.pyi", "verify.pyi")):
            (path,) = (ast.unparse(n.value) for n in stub if isinstance(n, ast.Assign) and n.targets[0].id == "Path")
            self.assertEqual(path, "Union[str, bytes, PathLike[str], PathLike[bytes]]")
            for node in stub:
                for p in node.args.args if isinstance(node, ast.FunctionDef) else []:
                    if p.arg == "path":
                        self.assertEqual(ast.unparse(p.annotation), "Path")
                        paths += 1
        self.assertEqual(paths, 3)


class Missing(unittest.TestCase):
    def test_these_tests_fail_without_the_package_and_are_skipped_without_numpy(self):
        with tempfile.TemporaryDirectory() as folder:
            def status(path):
                return subprocess.run([sys.executable, "-B", "-S", "-c", "import support"], cwd=TESTS, capture_output=True,
                                      env=dict(os.environ, PYTHONPATH=path)).returncode

            self.assertEqual(status(folder), SKIPPED)
            os.mkdir(os.path.join(folder, "numpy"))
            open(os.path.join(folder, "numpy", "__init__.py"), "w").close()
            self.assertEqual(status(folder), 1)


if __name__ == "__main__":
    unittest.main()
