#!/usr/bin/env python3
"""The known faults of the engines as entries of the corpus, with the exact answers that axiscert gives them:

    faults_corpus.py AXISCERT > fuzz/corpus/engines.jsonl

The corpus has no two queries that are equal up to a symmetry of the predicate. Faults on such queries are one entry, named after the first, whose
note has them all. Those with moving spheres are in the file of that predicate.
"""
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import asking

CORPUS = asking.FOLDER.parents[2] / "fuzz/corpus"
FILE = "engines.jsonl"


def provenance(line):
    engine = line["engine"]
    return f"address:{line['found']}" if "found" in line else f"made:known fault of {engine['package']} {engine['version']}"


def note(line):
    engine = line["engine"]
    kernel = Path(engine["manifest"]).stem
    fault = f"fault {line['id']}, {engine['answer']} by {engine['package']} {engine['version']} as {kernel}"
    if "found" in line:
        fault = "shrunk from it: " + fault
    return f"{fault}: {line['note']}" if "note" in line else fault


def entries(axiscert):
    """The lines of the file."""
    with tempfile.TemporaryDirectory() as folder:
        for file in CORPUS.glob("*.jsonl"):
            if file.name != FILE:
                shutil.copy(file, folder)
        made = {}
        for line in asking.faults():
            if line.get("predicate") == "moving-sphere":
                continue
            query = json.dumps(asking.query_of(line))
            done = subprocess.run([axiscert, "corpus", "add", "-", "--folder", folder, "--name", line["id"], "--provenance",
                                   provenance(line), "--note", note(line)], input=query, capture_output=True, text=True)
            if same := re.search(r"already in the corpus as '(.*?)'", done.stderr):
                if same[1] not in made:
                    sys.exit(f"{line['id']} is in the corpus as {same[1]}, which is no fault of an engine: {done.stderr}")
                made[same[1]]["note"] += "; " + note(line)
            elif done.returncode == 0:
                made[line["id"]] = json.loads(done.stdout[done.stdout.index("{"):])
            else:
                sys.exit(done.stderr)
        return [json.dumps(entry, separators=(",", ":")) for entry in made.values()]


if __name__ == "__main__":
    for entry in entries(sys.argv[1]):
        print(entry)
