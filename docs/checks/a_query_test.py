#!/usr/bin/env python3
"""a_query_test.py ROOT: every function that docs/a-query.md names is in the file that it names, and the page follows the layers:
from cli/ down to the campaign, through kernel/ and exact/ as the campaign calls them, and up to reports/ at the end."""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
page = (root / "docs/a-query.md").read_text()
steps = re.findall(r"`([\w./-]+\.(?:cpp|h|js)): (\w+)`", page)
wrong = [] if len(steps) > 20 else [f"docs/a-query.md names {len(steps)} functions as `FILE: FUNCTION`; there were more than 20"]
for file, function in steps:
    path = root / file
    if not path.is_file():
        wrong.append(f"docs/a-query.md names {file}, which does not exist")
    elif not re.search(rf"\b{function}\b", re.sub(r"//.*", "", path.read_text())):
        wrong.append(f"docs/a-query.md names {function} in {file}, which has no such name")

# Parts of the page in their order, and the layers that each may name.
for heading, layers in (("1. The plan", "cli"), ("2. A unit", "fuzz kernel exact"), ("3. The record", "fuzz exact"), ("4. The reports", "reports")):
    part = re.search(rf"## {re.escape(heading)}\n(.*?)(?=\n## |\Z)", page, re.DOTALL)
    if not part:
        wrong.append(f"docs/a-query.md has no part '{heading}'")
        continue
    for file, _ in re.findall(r"`([\w./-]+\.(?:cpp|h|js)): (\w+)`", part[1]):
        if file.split("/")[0] not in layers.split():
            wrong.append(f"docs/a-query.md: {file} is named in '{heading}', which belongs to {layers}")

# One function a step, so the changes of file along the query are those between neighbours.
files = [file for file, _ in steps]
changes = sum(a != b for a, b in zip(files, files[1:]))
print(f"{len(steps)} functions, {changes} changes of file")
for line in wrong:
    print(line, file=sys.stderr)
sys.exit(1 if wrong else 0)
