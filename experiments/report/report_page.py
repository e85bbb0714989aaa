"""The files of the report: figures as PDF and SVG, tables as CSV, and the page. Nothing leaves without what made it."""

import csv
import html
import io
import os
import re
from dataclasses import dataclass, fields, replace

import matplotlib.pyplot as plt

from report_data import distinct
from report_style import GRID, INK, PAPER, box_of


def again(rows):
    """The words that made the rows, as these keep them, in the order of the rows."""
    return " && ".join(distinct(r["again"] for r in rows if r.get("again"))) or "not recorded in these rows"


def unbroken(cell):
    """The cell, in which no line ends within "1 of 2", "3 %", "< 4", "5 .. 6" and "7 ×"."""
    return re.sub(r"(?<=\d) (?=%|×|of \d|\.\. \d)|(?<=\d of) (?=\d)|(?<=\d \.\.) (?=\d)|(?<=&lt;) ",
                  "\N{NO-BREAK SPACE}", str(cell))


def of_its_own(drawing, name):
    """The SVG with ids that no other drawing of the page has."""
    return re.sub(r'(\bid="|href="#|url\(#)', rf"\g<1>{name}-", drawing)


@dataclass(frozen=True)
class Source:
    """What made a figure or a table."""
    asked: str    # the question, in a sentence
    cases: str    # of how many answers
    seed: str
    command: str  # that makes it again
    version: str
    compiler: str
    machine: str

    @staticmethod
    def of(rows, asked, cases, command=None, seed=None, compiler=None):
        """From the columns of the rows themselves; the command is `again(rows)` where none is given."""
        def all_of(key):
            return "; ".join(distinct(r[key] for r in rows))
        return Source(asked, cases, seed or all_of("seed"), command or again(rows), all_of("version"),
                      compiler or f"{all_of('compiler')}, flags {all_of('flags')}",
                      all_of("processor"))

    def about(self, **changes):
        return replace(self, **changes)

    def check(self):
        for field in fields(self):
            if not str(getattr(self, field.name)).strip():
                raise ValueError(f"a figure without its {field.name}: {self.asked or self.command}")

    def line(self):
        return f"{self.cases}; seed {self.seed}; version {self.version}; {self.compiler}; {self.machine}; {self.command}"


class Page:
    def __init__(self, out):
        self.out = out
        for folder in ("figures", "tables"):
            os.makedirs(os.path.join(out, folder), exist_ok=True)

    def write(self, name, text):
        path = os.path.join(self.out, name)
        part = path + ".part"
        with open(part, "w", encoding="utf-8", newline="") as file:
            file.write(text)
        os.replace(part, path)

    def table(self, name, header, lines, source):
        """Writes OUT/tables/NAME.csv, what made it in the last columns of each row; gives its address."""
        source.check()
        buffer = io.StringIO()
        made = [source.seed, source.version, source.compiler, source.machine, source.command]
        csv.writer(buffer, lineterminator="\n").writerows([header + ["seed", "version", "compiler", "processor", "command"]] +
                                                          [line + made for line in lines])
        self.write(f"tables/{name}.csv", buffer.getvalue())
        return f"tables/{name}.csv"

    def figure(self, name, fig, source, data):
        """Saves the figure as PDF and SVG; gives it for the page, with what made it and a link to its rows."""
        source.check()
        part = os.path.join(self.out, "figures", name + ".part")
        box = box_of(fig)
        fig.savefig(part, format="pdf", bbox_inches=box,
                    metadata={"CreationDate": None, "Title": source.asked, "Subject": source.line(), "Keywords": data})
        os.replace(part, os.path.join(self.out, "figures", name + ".pdf"))
        buffer = io.StringIO()
        fig.savefig(buffer, format="svg", bbox_inches=box,
                    metadata={"Date": None, "Title": source.asked, "Description": source.line()})
        plt.close(fig)
        svg = buffer.getvalue()
        self.write(f"figures/{name}.svg", svg.replace(PAPER, "#ffffff").replace("<svg ", '<svg style="background: #ffffff" ', 1))
        drawing = of_its_own(svg[svg.index("<svg"):], name)
        for colour, name_of_it in ((INK, "ink"), (GRID, "line"), (PAPER, "paper")):
            drawing = drawing.replace(colour, f"var(--{name_of_it})")
        drawing = drawing.replace("<svg ", f'<svg role="img" aria-label="{html.escape(source.asked)}" ', 1)
        caption = f"<figcaption class=source>{self.made(source, data, name)}</figcaption>"
        return f'<figure id="figure-{name}"><div class=drawing>{drawing}</div>{caption}</figure>'

    def made(self, source, data, figure=None):
        files = (f'<a href="figures/{figure}.pdf">PDF</a>, ' if figure else "") + f'<a href="{data}">{data}</a>'
        return (f"<b>Asked:</b> {html.escape(source.asked)} <b>Cases:</b> {html.escape(source.cases)}. <b>Seed:</b> "
                f"{html.escape(source.seed)}. <b>Again:</b> <code>{html.escape(source.command)}</code>. <b>Version:</b> "
                f"{html.escape(source.version)}, {html.escape(source.compiler)}. <b>Machine:</b> {html.escape(source.machine)}. "
                f"<b>Files:</b> {files}.")

    def html_table(self, head, body, source=None, data=None):
        """A table of rows (shaded, cells of HTML), what made it below."""
        rows = "".join("<tr%s>%s</tr>" % (' class="exact"' if exact else "",
                                          "".join(f"<td>{unbroken(c)}</td>" for c in cells)) for exact, cells in body)
        names = "".join(f"<th>{h}</th>" for h in head)
        table = f"<div class=scroll><table><thead><tr>{names}</tr></thead><tbody>{rows}</tbody></table></div>"
        if source is None:
            return table
        source.check()
        return table + f"<p class=source>{self.made(source, data)}</p>"

    @staticmethod
    def section(name, title, *parts):
        return f'<section id="{name}"><h2>{title}</h2>{"".join(parts)}</section>'
