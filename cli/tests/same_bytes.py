#!/usr/bin/env python3
"""Two builds of the command write the same bytes: a whole record of each predicate, and what a search finds.

same_bytes.py AXISCERT OTHER_AXISCERT MODELS
"""
import subprocess
import sys
import tempfile
from pathlib import Path

BUILDS, MODELS = sys.argv[1:3], sys.argv[3]
MESH = ("--family", "all", "--mesh", f"{MODELS}/OBJ/spider.obj")
KERNELS = ["published", "nonstrict", "reduced", "ladder-0", "packed", "published+fma", "published+up", "published+spu"]
MOTIONS = [f"moving-sphere/{name}" for name in ("twenty", "gated", "rounded", "physx5", "twenty+fma")]
FILES = ("record.json", "search/witnesses.jsonl", "moving-sphere/record.json", "moving-sphere/search/witnesses.jsonl")


def write(axiscert, folder):
    """All files, of one build."""
    for out, kernels, trials, searched, evaluations in ((folder, KERNELS, 256, "published", 200000),
                                                        (folder / "moving-sphere", MOTIONS, 64, "moving-sphere/rounded", 20000)):
        subprocess.run([axiscert, "run", *(f"--kernel={kernel}" for kernel in kernels), *MESH, "--trials", str(trials), "--out", out],
                       check=True, stdout=subprocess.DEVNULL)
        subprocess.run([axiscert, "search", "--kernel", searched, "--evaluations", str(evaluations), "--out", out / "search"],
                       check=True, stdout=subprocess.DEVNULL)


if not Path(BUILDS[0]).is_file():
    sys.exit(f"{BUILDS[0]} is not built: cmake --build --preset release")
with tempfile.TemporaryDirectory() as temporary:
    folders = [Path(temporary) / name for name in ("first", "other")]
    for axiscert, folder in zip(BUILDS, folders):
        write(axiscert, folder)
    different = [file for file in FILES if (folders[0] / file).read_bytes() != (folders[1] / file).read_bytes()]
sys.exit(f"{BUILDS[0]} and {BUILDS[1]} write different bytes: {', '.join(different)}" if different else 0)
