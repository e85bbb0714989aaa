#!/usr/bin/python3
"""House rule: no sentence of a comment in the C++ or Python sources, of a docstring, or of a document has more than 25 words.

Docstrings are those of Python, and in C++ the texts R"( ... )" of a folder python/. No sentence of a docstring or of Python's comments begins without a
subject; house.cpp holds comments of C++ to that. Each flaw is told with its file and line.
"""

import ast
import io
import pathlib
import re
import tokenize
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[3]
FOLDERS = ("kernel", "covering", "tetratree", "verify", "experiments")
MOST_WORDS = 25

# A sentence ends at . ! ? and, before what begins another, at ; and :. The dot of a product has a blank before it.
END = re.compile(r"(?<=[^\s(])[.!?][)\"']*\s+|(?<=\S)[;:]\s+(?=[A-Z`(0-9])")
ABBREVIATION = re.compile(r"\b(e\.g|i\.e|cf|vs|Fig|Sec|No)\.$")
OPERATOR = re.compile(r"[-+*/=<>^|&.~]+")
ITEM = re.compile(r"(-|\*|\d+[.)]) +")
DOCSTRING = re.compile(r'R"\((.*?)\)"', re.DOTALL)
HEADLESS = re.compile(r"(Of|The same|So many|What is) ")
PRAGMA = re.compile(r"#!|# *(noqa|type:|SPDX-|Copyright)")


def comments(text):
    """Comments of // as lists of (line, indentation of the words, words); what follows one another in one column is one comment."""
    found, column, last = [], None, 0
    for number, line in enumerate(text.split("\n"), 1):
        literals = re.sub(r'"(\\.|[^"\\])*"', lambda literal: "x" * len(literal[0]), line)
        at = literals.find("//")
        if at < 0:
            continue
        words = re.match(r"//[/!]?<?", line[at:])
        rest = line[at + words.end():]
        alone = not line[:at].strip()
        if not (alone and found and last + 1 == number and at == column):
            found.append([])
        found[-1].append((number, len(rest) - len(rest.lstrip()), rest.strip()))
        column, last = at, number
    return found


def paragraphs(comment):
    """Its paragraphs and the items of its lists as lists of (line, words), without code: \\code blocks, and lines that are indented more."""
    found, inside, in_code = [], None, False
    for number, indentation, words in comment:
        item = ITEM.match(words)
        if re.match(r"[\\@](end)?(code|verbatim)\b", words):
            in_code, inside = not re.match(r"[\\@]end", words), None
        elif in_code or not words:
            inside = None
        elif item:
            inside = indentation + item.end()
            found.append([(number, words[item.end():])])
        elif inside is not None and abs(indentation - inside) <= 1:
            found[-1].append((number, words))
        elif indentation < (4 if inside is None else inside):
            inside = indentation
            found.append([(number, words)])
    return found


def sentences(paragraph):
    """Its sentences, each with the line on which it begins."""
    text = " ".join(words for _, words in paragraph)
    starts, at = [], 0
    for number, words in paragraph:
        starts.append((at, number))
        at += len(words) + 1
    begin = 0
    for end in [m for m in END.finditer(text) if not ABBREVIATION.search(text[:m.start() + 1])] + [None]:
        stop = end.end() if end else len(text)
        yield max(number for at, number in starts if at <= begin), text[begin:stop].strip()
        begin = stop


def words_of(sentence):
    """The number of its words: tokens with a letter. What stands in backticks is one, and so is a formula, the tokens between which operators stand."""
    tokens = re.sub(r"`[^`]*`", "`code`", sentence).split()
    count, joined = 0, False
    for token in tokens:
        if OPERATOR.fullmatch(token):
            joined = True
            continue
        count += bool(re.search(r"[A-Za-z]", token)) and not joined
        joined = False
    return count


def long_sentences(path, text):
    return [f"{path}:{line}: a sentence of {words_of(sentence)} words; expected at most {MOST_WORDS}: {sentence}"
            for comment in comments(text) for paragraph in paragraphs(comment) for line, sentence in sentences(paragraph)
            if words_of(sentence) > MOST_WORDS]


def long_sentences_of_document(path, text):
    """Its paragraphs, items and cells of tables, without blocks of code, are judged as comments are."""
    in_code, lines = False, []
    for line in text.split("\n"):
        in_code ^= line.startswith("```")
        is_code = in_code or re.match(r"```|    |\||#|!", line)
        lines.append("///" if is_code else "/// " + re.sub(r"\]\([^)]*\)", "]", line.replace("**", "")))
    found = long_sentences(path, "\n".join(lines))
    for number, line in enumerate(text.split("\n"), 1):
        for cell in line.split("|") if line.startswith("|") else []:
            found += [f"{path}:{number}: {flaw.split(': ', 1)[1]}" for flaw in long_sentences(path, "/// " + cell.strip())]
    return found


def flaws(path, judged):
    """Long sentences, and those without a subject."""
    return long_sentences(path, judged) + [
        f"{path}:{line}: begins without a subject: {sentence}"
        for comment in comments(judged) for paragraph in paragraphs(comment) for line, sentence in sentences(paragraph)
        if HEADLESS.match(sentence)]


def as_comment(docstring):
    """Its lines as comments. An example, from >>> up to an empty line, is code."""
    in_code = False
    for line in docstring.split("\n"):
        in_code = line.startswith(">>>") or (in_code and bool(line))
        yield "///" if in_code else "/// " + line


def flaws_of_docstrings(path, text):
    """Their paragraphs are judged as comments are."""
    lines = [""] * (text.count("\n") + 1)
    for docstring in DOCSTRING.finditer(text):
        for number, line in enumerate(as_comment(docstring[1]), text.count("\n", 0, docstring.start())):
            lines[number] = line
    return flaws(path, "\n".join(lines))


def flaws_of_python(path, text):
    """Docstrings, and comments of # that are no pragmas, are judged as comments of C++ are."""
    written = text.split("\n")
    lines = [""] * len(written)
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)) and ast.get_docstring(node) is not None:
            indentation = " " * node.body[0].col_offset
            docstring = ast.get_docstring(node, clean=False).replace("\n" + indentation, "\n")
            for number, line in enumerate(as_comment(docstring), node.body[0].lineno - 1):
                lines[number] = indentation + line
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT and not PRAGMA.match(token.string):
            number, column = token.start
            lines[number - 1] = re.sub(r"\S", "x", written[number - 1][:column]) + "//" + re.sub("^#+:?", "", token.string)
    return flaws(path, "\n".join(lines))


def sources(folder):
    return sorted(path for path in (SOURCE / folder).rglob("*") if path.suffix in (".h", ".inl", ".cpp", ".py", ".pyi"))


class Sentences(unittest.TestCase):
    def test_no_sentence_is_long(self):
        wrong = []
        for folder in FOLDERS:
            found = sources(folder)
            self.assertTrue(found, folder)
            for path in found:
                text = path.read_text(encoding="utf-8")
                if path.suffix.startswith(".py"):
                    wrong += flaws_of_python(path.relative_to(SOURCE), text)
                    continue
                wrong += long_sentences(path.relative_to(SOURCE), text)
                if path.parent.name == "python":
                    wrong += flaws_of_docstrings(path.relative_to(SOURCE), text)
        for path in [SOURCE / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md")] + [
                path for folder in FOLDERS for path in sorted((SOURCE / folder).rglob("*.md"))]:
            text = path.read_text(encoding="utf-8")
            if path.name == "CHANGELOG.md":  # what is released stays as it is
                text = text[:text.index("## [0.")]
            wrong += long_sentences_of_document(path.relative_to(SOURCE), text)
        self.assertFalse(wrong, "\n".join([""] + wrong))

    def count(self, text):
        return len(long_sentences("kernel/x.h", text))

    def test_a_long_one_is_noticed_with_its_line(self):
        few, many = "word " * 12, "word " * 25
        self.assertEqual(self.count(f"/// {many}."), 0)
        self.assertEqual(self.count(f"/// {many}more."), 1)
        self.assertTrue(long_sentences("kernel/x.h", f"\n/// Short.\n/// Here {few}\n/// {few}more.")[0].startswith("kernel/x.h:3: "))
        for wrong in (f"  // {few}\n  // {few}, and more.", f"int x;  ///< {few}\n        ///< {few}, and more", f"/// {few}; {few}and more.",
                      f"/// {few}: {few}and more.", f"/// - {few}\n///   {few}, and more;\n/// - {few}", f"/// {few}e.g. {few}and more.",
                      f'f("//", "x");  // {few} {few}and more.'):
            self.assertEqual(self.count(wrong), 1, wrong)

    def test_docstrings_are_judged_without_their_examples(self):
        few = " ".join(["word"] * 20)
        for right in (f'f(R"(f()\n\n{few}.\n\n>>> {few} {few}\n{few} {few}\n)");', f'f("{few} {few}");', f'R"({few}.)"\nR"({few}.)"'):
            self.assertEqual(flaws_of_docstrings("x.cpp", right), [], right)
        for wrong in (f'f(R"(f()\n\n{few}\n{few}.)");', f'f(R"(f()\n\n>>> x\n\n{few}\n{few}.)");', 'f(R"(f()\n\nOne.\nOf one, a word.)");'):
            self.assertEqual(len(flaws_of_docstrings("x.cpp", wrong)), 1, wrong)
        self.assertTrue(flaws_of_docstrings("x.cpp", f'\nf(R"(f()\n\n{few}\n{few}.)");')[0].startswith("x.cpp:4: "))

    def test_docstrings_and_comments_of_python_are_judged(self):
        few = " ".join(["word"] * 20)
        for right in (f'"""{few}.\n\n>>> {few} {few}\n"""', f'x = """{few} {few}"""', f"x = '# {few} {few}'", f"#!{few} {few}\nimport x  # noqa: {few} {few}",
                      f"# {few}\nx = 1\n# {few}", f'class X:\n    """{few}\n\n        {few}\n        {few}"""'):
            self.assertEqual(flaws_of_python("x.py", right), [], right)
        for wrong in (f'"""{few}\n{few}."""', f'def f():\n    """X.\n\n    {few}\n    {few}."""', f"# {few}\n# {few}", f"x = 1  # {few}\n       #: {few}",
                      "# Of x, a word.", 'class X:\n    async def f():\n        """X. The same of x."""'):
            self.assertEqual(len(flaws_of_python("x.py", wrong)), 1, wrong)
        self.assertTrue(flaws_of_python("x.py", f'def f():\n    """X.\n\n    {few}\n    {few}."""\n')[0].startswith("x.py:4: "))

    def test_sentences_items_and_code_are_told_apart(self):
        few = " ".join(["word"] * 20)
        for right in (f"/// {few}. {few}.", f"/// {few}. m_k {few}.", f"/// {few}; `x` {few}.", f"/// {few}: (1) {few}.", f"/// {few}.) {few}.", f"/// {few}\n///\n/// {few}",
                      f"/// {few}:\n/// - {few};\n/// - {few}", f"/// 1. {few}\n/// 2. {few}", f"/// {few}:\n///     {few}\n///     {few}",
                      f"/// \\code\n/// {few}\n/// {few}\n/// \\endcode", f"int x;  ///< {few}\nint yy;  ///< {few}", f'const char* x = "// {few} {few}";',
                      f"/// {few}\nint x;\n/// {few}", f"/// {few} `{few}`.", "/// " + "a + b - " * 30, "/// https://x.org/" + "-word" * 40):
            self.assertEqual(self.count(right), 0, right)

    def test_formulas_are_words(self):
        self.assertEqual(words_of("The error of n . (x - p) + |y| is 3."), 5)
        self.assertEqual(words_of("`a b c` is 1"), 2)


if __name__ == "__main__":
    unittest.main()
