#!/usr/bin/env python3
"""The tables of docs/gpu.md that say what permitted evaluations cost, and what they reach of the bounds of their errors: the command after each
gives its figures.

table_test.py AXISCERT [--write] [unittest arguments]   --write puts what the command gives into the page
"""
import json
import re
import shlex
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PAGE = Path(__file__).resolve().parents[2] / "docs" / "gpu.md"
AXISCERT = Path(sys.argv.pop(1)).resolve()
WRITE = "--write" in sys.argv
if WRITE:
    sys.argv.remove("--write")
TABLE = re.compile(r"(<!-- held by kernel/permitted/table_test.py -->\n)((?:\|[^\n]*\n)+)\n```\n(.*?)```", re.S)


def cell(verdict):
    missed = verdict["false_separation"]
    return f"{missed:,} / {verdict['deepest_false_separation']:.2g}" if missed else "0"


def made_by(command):
    """The table of a run: the contacts that each kernel misses in each family, and the deepest."""
    program, *words = shlex.split(command.replace("\\\n", " "))
    if program != "axiscert":  # permitted_attack prints its table
        return subprocess.run([AXISCERT.parent / Path(program).name, *words], capture_output=True, text=True, check=True).stdout
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([AXISCERT, *words, "--quiet", "--out", "out"], cwd=folder, capture_output=True, text=True)
        assert done.returncode in (0, 1), done.stderr
        record = json.loads((Path(folder) / "out" / "record.json").read_text())
    families = list(record["kernels"][0]["families"])
    lines = ["| |" + "|".join(f" `{family.split('/')[-1]}` " for family in families) + "|", "|---|" + "|".join("---:" for _ in families) + "|"]
    for kernel in record["kernels"]:
        lines.append(f"| `{kernel['id']}` | " + " | ".join(cell(family["verdict"]) for family in kernel["families"].values()) + " |")
    return "".join(line + "\n" for line in lines)


def wrong_tables(page):
    """The tables of a page that are not what their commands give, each with what it should be."""
    return [(table, made) for _, table, command in (one.groups() for one in TABLE.finditer(page)) if table != (made := made_by(command))]


class Tables(unittest.TestCase):
    maxDiff = None

    def test_each_table_is_what_its_command_gives(self):
        page = PAGE.read_text()
        self.assertEqual(len(TABLE.findall(page)), 6)
        wrong = wrong_tables(page)
        if WRITE:
            for table, made in wrong:
                page = page.replace(table, made)
            PAGE.write_text(page)
            wrong = []
        self.assertEqual(wrong, [])

    def test_a_wrong_figure_is_told(self):
        command = "axiscert run --precision binary32 --trials 300 --family tangent --kernel published --kernel published+wgsl-misses\n"
        made = made_by(command)
        page = "before\n<!-- held by kernel/permitted/table_test.py -->\n%s\n```\n" + command + "```\nafter\n"
        self.assertEqual(wrong_tables(page % made), [])
        figure = re.search(r"\d+ / ", made)[0]
        for planted in (made.replace(figure, f"{int(figure[:-3]) + 1} / ", 1), made.replace("e-", "e-1", 1), made.replace("`tangent`", "`far`")):
            self.assertNotEqual(planted, made)
            self.assertEqual(wrong_tables(page % planted), [(planted, made)])


if __name__ == "__main__":
    unittest.main()
