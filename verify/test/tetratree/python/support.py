"""What the tests of the Python package share."""

import doctest
import inspect
import os
import sys

sys.dont_write_bytecode = True
SKIPPED = 77


def skip(why):
    print(f"skipped: {why}")
    sys.exit(SKIPPED)


try:
    import numpy  # noqa: F401
except ModuleNotFoundError as missing:
    skip(f"no {missing.name}")
import tetracone  # noqa: E402, F401: it ought to be there: that it is not is a failure

PROGRAM = os.environ.get("TETRACONE_PROGRAM", "")

CUBE = ([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)],
        [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])


def documented(module):
    """What a module says of itself, by name: its own text, its functions, its classes and their members."""
    yield module.__name__, module.__doc__
    for name in getattr(module, "__all__", [n for n in vars(module) if not n.startswith("_")]):
        thing = getattr(module, name)
        if inspect.isclass(thing):
            yield name, thing.__doc__
            for member, value in vars(thing).items():
                if not member.startswith("_") and value.__doc__:
                    yield f"{name}.{member}", value.__doc__
        elif callable(thing):
            yield name, thing.__doc__


def examples_failed(module):
    """How many of the examples in the module's docstrings, which must be some, don't print what they say."""
    runner, parser = doctest.DocTestRunner(), doctest.DocTestParser()
    for name, text in documented(module):
        runner.run(parser.get_doctest(text, {}, name, module.__name__, 0))
    failed, attempted = runner.summarize()
    return failed if attempted else 1


def text_of(poses):
    """The file of poses that the program reads."""
    return "".join(" ".join(str(x) for x in pose.ravel()) + "\n" for pose in poses)


def off_of(body):
    """The body as an OFF file. Requires faces without holes."""
    lines = ["OFF", f"{len(body.vertices)} {len(body.faces)} 0"]
    lines += [" ".join(repr(float(x)) for x in v) for v in body.vertices]
    lines += [" ".join(map(str, (len(loop), *loop))) for (loop,) in body.faces]
    return "\n".join(lines) + "\n"
