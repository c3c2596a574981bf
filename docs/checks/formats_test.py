#!/usr/bin/env python3
"""The table of docs/data.md has every format with its number and with how many files of it are tracked; nothing but a test, which refuses it,
and the CHANGELOG has another number.

    formats_test.py ROOT
"""
import re
import subprocess
import sys
import unittest
from collections import Counter
from pathlib import Path

ROOT = Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 else Path(__file__).resolve().parents[2]
PAGE = "docs/data.md"
NAMED = re.compile(r"axiscert-([a-z]+(?:-[a-z]+)*)/(\d+)")
# A file of a format: a member of JSON has its name, or its first line begins with it.
FILE_OF = re.compile(r'^\s*"(?:schema|format)"\s*:\s*"axiscert-([a-z-]+)/(\d+)"|\Aaxiscert-([a-z-]+)/(\d+) ', re.MULTILINE)
# Numbers that are not in a name: the row of the table, the file, the number in it. Every one is the row's.
OTHERS = [("plug-in interface", "kernel/include/axiscert/plugin.h", r"#define AXISCERT_PLUGIN_ABI (\d+)u"),
          ("plug-in interface", "docs/plugins.md", r"states the whole interface, version (\d+)"),
          ("stream of the pipe", "kernel/plugin/pipe_format.h", r"std::uint32_t version = (\d+);"),
          ("stream of the pipe", "kernel/peers/npm/engines/frame.mjs", r"const VERSION = (\d+);"),
          ("stream of the pipe", "kernel/peers/npm/asking.py", r"^VERSION, REPLY = (\d+), 16"),
          ("stream of the pipe", "docs/pipe.md", r"^## Format, version (\d+)"),
          ("stream of the pipe", "docs/pipe.md", r"`version` \| (\d+), unsigned"),
          *(("stream of the pipe", f"examples/pipe/published.{kind}", r"version !==? (\d+)") for kind in ("c", "go", "mjs", "py", "rs")),
          ("`certificate`, its predicateType", "reports/certificate/certificate_data.h", r'"urn:axiscert:certificate:(\d+)"')]
REFUSING = re.compile(r"_test\.(cpp|py)$|^cli/tests/|^fuzz/targets/seeds\.py$|^docs/checks/formats_test\.py$|^CHANGELOG\.md$")


def tracked():
    """Path and text of every tracked file; where there is no git, as in an archive, of all but what .gitignore names."""
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z"], capture_output=True, text=True)
    files = [name for name in listed.stdout.split("\0") if name] if listed.returncode == 0 else \
        [path.relative_to(ROOT).as_posix() for path in ROOT.rglob("*") if path.is_file()]
    left_out = re.compile(r"^(build|out|\.git)/|node_modules/|__pycache__/")
    return {name: (ROOT / name).read_text(errors="replace") for name in files if not left_out.search(name) and (ROOT / name).is_file()}


def table(text):
    """{format: (number, files)} of the page."""
    rows = re.findall(r"^\| (.+?) \| (\d+) \| (\d+) \| ", text.partition("\n## Formats\n")[2].partition("\n## ")[0], re.MULTILINE)
    return {name: (int(number), int(files)) for name, number, files in rows}


def faults(files):
    told, rows = [], table(files[PAGE])
    numbers, counts = {}, Counter()
    for name, text in files.items():
        if REFUSING.search(name):
            continue
        for format_name, number in NAMED.findall(text):
            numbers.setdefault(format_name, set()).add(int(number))
            if rows.get(f"`{format_name}`", (0,))[0] != int(number):
                told.append(f"{name}: axiscert-{format_name}/{number}, which {PAGE} does not have")
        if name.endswith((".json", ".jsonl", ".txt")):
            counts.update({a or b for a, _, b, _ in FILE_OF.findall(text)})
    told += [f"{PAGE}: {name}, which nothing names" for name in rows if re.fullmatch(r"`[a-z-]+`", name) and name.strip("`") not in numbers]
    for name, (_, tracked_files) in rows.items():
        found = counts[name.strip("`")] if name.startswith("`") and "," not in name else 0
        if found != tracked_files:
            told.append(f"{PAGE}: {name} has {tracked_files} tracked files, and there are {found}")
    for row, name, pattern in OTHERS:
        found = [int(number) for number in re.findall(pattern, files[name], re.MULTILINE)]
        if not found or set(found) != {rows.get(row, (0,))[0]}:
            told.append(f"{name}: {row} {found}, which {PAGE} does not have")
    return told


class Formats(unittest.TestCase):
    FILES = tracked()

    def test_the_table_has_every_format_and_its_number(self):
        told = faults(self.FILES)
        self.assertFalse(told, "\n" + "\n".join(told))
        self.assertGreater(len(table(self.FILES[PAGE])), 25)

    def test_what_is_planted_is_seen(self):
        number = table(self.FILES[PAGE])["`record`"][0]
        for name, old, new in (("fuzz/record/record.h", f"axiscert-record/{number}", f"axiscert-record/{number + 1}"),
                               ("docs/ci.md", "axiscert-ratchet/", "axiscert-ratchet/1"), (PAGE, f"| `record` | {number} | 1 |", f"| `record` | {number} | 2 |"),
                               (PAGE, "| `record` |", "| `recording` |"), ("kernel/include/axiscert/plugin.h", "_ABI 3u", "_ABI 4u"),
                               ("examples/pipe/published.rs", "version != 3", "version != 2"), ("docs/pipe.md", "## Format, version 3", "## Format, version 2"),
                               ("reports/testing/record.json", f"axiscert-record/{number}", f"axiscert-record/{number - 1}")):
            with self.subTest(name + ": " + new):
                self.assertIn(old, self.FILES[name])
                self.assertTrue(faults({**self.FILES, name: self.FILES[name].replace(old, new)}))


if __name__ == "__main__":
    unittest.main()
