#!/usr/bin/env python3
"""The tables of docs/gpu.md that say what permitted evaluations cost: the command after each gives its figures.

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
    words = shlex.split(command.replace("\\\n", " "))[1:]
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([AXISCERT, *words, "--quiet", "--out", "out"], cwd=folder, capture_output=True, text=True)
        assert done.returncode in (0, 1), done.stderr
        record = json.loads((Path(folder) / "out" / "record.json").read_text())
    families = list(record["kernels"][0]["families"])
    lines = ["| |" + "|".join(f" `{family.split('/')[-1]}` " for family in families) + "|", "|---|" + "|".join("---:" for _ in families) + "|"]
    for kernel in record["kernels"]:
        lines.append(f"| `{kernel['id']}` | " + " | ".join(cell(family["verdict"]) for family in kernel["families"].values()) + " |")
    return "".join(line + "\n" for line in lines)


class Tables(unittest.TestCase):
    def test_each_table_is_what_its_command_gives(self):
        page = PAGE.read_text()
        found = list(TABLE.finditer(page))
        self.assertEqual(len(found), 3)
        for one in found:
            _, table, command = one.groups()
            with self.subTest(command):
                made = made_by(command)
                if WRITE:
                    PAGE.write_text(PAGE.read_text().replace(table, made))
                else:
                    self.assertEqual(table, made)


if __name__ == "__main__":
    unittest.main()
