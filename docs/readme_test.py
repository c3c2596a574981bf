#!/usr/bin/env python3
"""The figures of README.md are those of the run that it shows.

    readme_test.py AXISCERT MODELS           runs it, and fails where README says otherwise
    readme_test.py AXISCERT MODELS --write   puts the run's figures in their places
"""
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

README = Path(__file__).resolve().parents[1] / "README.md"
SUMMARY = re.compile(r"(?<=```\n)  kernel +precision +queries .*?(?=```\n)", re.S)
TABLE = re.compile(r"(?<=\| kernel \| family \| trials \| false_separation \| deepest \| false_contact \| deepest \| broken links \|\n"
                   r"\|---\|---\|---:\|---:\|---:\|---:\|---:\|---\|\n)(?:\|.*\n)+")
MESHES = ("OBJ/spider.obj", "PLY/Wuson.ply", "STL/sphereWithHole.stl")


def main_job(axiscert, models):
    """The summary of `./dev run`, and the rows of its report for binary32 by kernel and family."""
    with tempfile.TemporaryDirectory() as folder:
        meshes = [word for mesh in MESHES for word in ("--mesh", Path(models) / mesh)]
        done = subprocess.run([axiscert, "run", "--kernel", "published", "--kernel", "nonstrict", "--family", "all", *meshes, "--out",
                               folder], text=True, capture_output=True, check=True)
        report = (Path(folder) / "report.md").read_text()
    summary = "".join(done.stdout.splitlines(keepends=True)[:5])
    rows = {}
    head = "| kernel | precision | family | broken links | trials |"
    for line in report[report.index(head):].split("\n\n", 1)[0].splitlines()[2:]:
        kernel, precision, family, links, trials, _, _, _, _, missed, deepest, phantom, deepest_phantom, *_ = (
            cell.strip() for cell in line.strip("|").split("|"))
        if precision == "binary32":
            rows[kernel, family] = (trials, missed, deepest, phantom, deepest_phantom, links)
    return summary, rows


def with_figures(text, summary, rows):
    def row(line):
        kernel, family = (cell.strip() for cell in line.strip("|").split("|")[:2])
        return " | ".join(("| " + kernel, family, *rows[kernel, family])) + " |"

    text = SUMMARY.sub(lambda _: summary, text, count=1)
    return TABLE.sub(lambda table: "".join(row(line) + "\n" for line in table[0].splitlines()), text, count=1)


class Readme(unittest.TestCase):
    def test_its_figures_are_those_of_the_run(self):
        text = README.read_text()
        self.assertEqual((len(SUMMARY.findall(text)), len(TABLE.findall(text))), (1, 1), "the places of the figures")
        new = with_figures(text, *main_job(*ARGUMENTS))
        stale = [line for line in new.splitlines() if line not in text.splitlines()]
        self.assertEqual(stale, [], "README.md is stale: docs/readme_test.py AXISCERT MODELS --write puts these lines there")


if __name__ == "__main__":
    write = "--write" in sys.argv
    ARGUMENTS = [sys.argv.pop(1), sys.argv.pop(1)]
    if write:
        README.write_text(with_figures(README.read_text(), *main_job(*ARGUMENTS)))
    else:
        unittest.main()
