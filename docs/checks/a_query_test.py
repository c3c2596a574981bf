#!/usr/bin/env python3
"""a_query_test.py ROOT: every function that docs/a-query.md names is in the file that it names, every predicate has its row, and the road of each
follows the layers: from cli/ down to the campaign, through kernel/ and exact/ as the campaign calls them, and up to reports/ at the end.
trace_query.py asks a program whether that is the order in which a query comes to them."""
import pathlib
import re
import sys

from trace_query import changes, roads

root = pathlib.Path(sys.argv[1])
page = roads((root / "docs/a-query.md").read_text())
wrong = []

listed = re.findall(r"X\((\w+)\)", (root / "kernel/predicate_list.h").read_text().split("#define AXISCERT_PREDICATES(X)")[1])
for missing in {name.replace("_", "-") for name in listed} - set(page):
    wrong.append(f"docs/a-query.md has no row for {missing}")

# Parts of the page in their order, and the layers that each may name.
layers = {"1. The plan": "cli plans", "2. A unit": "fuzz kernel exact", "3. The record": "fuzz exact", "4. The reports": "reports"}
for predicate, road in page.items():
    if len(road) <= 20:
        wrong.append(f"{predicate}: {len(road)} functions; there were more than 20")
    for file, function, heading in road:
        path = root / file
        if not path.is_file():
            wrong.append(f"{predicate}: {file} does not exist")
        elif any(not re.search(rf"\b{name}\b", re.sub(r"//.*", "", path.read_text())) for name in function.split("::")):
            wrong.append(f"{predicate}: {file} has no {function}")
        if file.split("/")[0] not in layers.get(heading, "").split():
            wrong.append(f"{predicate}: {file} is named in '{heading}', which belongs to {layers.get(heading)}")
    if list(dict.fromkeys(heading for _, _, heading in road)) != list(layers):
        wrong.append(f"{predicate}: the parts of the page are not {', '.join(layers)}")
    count, back = changes([file for file, _, _ in road])
    print(f"{predicate}: {len(road)} functions, {count} changes of file, {back} of them back")
for line in dict.fromkeys(wrong):
    print(line, file=sys.stderr)
sys.exit(1 if wrong else 0)
