#!/usr/bin/python3
"""docs/plots/front-door.svg, the picture of README.md: three queries in a plane, what is true of them, and what a kernel answers.

    picture.py AXISCERT           writes it
    picture.py AXISCERT --check   fails where that would change it

The queries are docs/checks/front-door.jsonl; every verdict in the picture is asked of `axiscert check`. All points have z = 0, so that the circle and
the triangle are to scale and show the answer.
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams.update({"svg.hashsalt": "axiscert", "svg.fonttype": "none", "font.size": 11})
import matplotlib.pyplot as plt

ROOT = Path(__file__).resolve().parents[2]
QUERIES, PICTURE = ROOT / "docs/checks/front-door.jsonl", ROOT / "docs/plots/front-door.svg"
# The query, the kernel, its name, what the query is.
PANELS = [("repeated", "published", "the published test", "a triangle with two equal vertices"),
          ("on a line", "peer/bullet", "Bullet 3.24", "three vertices on a line"),
          ("small", "peer/bullet", "Bullet 3.24", "legs of 0.3 mm, in metres")]


def answers(axiscert, kernel):
    """By query's id: the exact verdict and the kernel's."""
    done = subprocess.run([axiscert, "check", QUERIES, "--kernel", kernel, "--format", "jsonl"], text=True, capture_output=True)
    lines = [json.loads(line) for line in done.stdout.splitlines()]
    return {line["id"]: (line["exact"]["verdict"], line["computed"]["verdict"]) for line in lines}


def draw(axes, query, title, truth):
    (a, b, c, p), r = ([query[name][:2] for name in "abcp"], query["r"])
    axes.add_patch(plt.Circle(p, r, facecolor="#dbe8f7", edgecolor="#0a58b0"))
    axes.add_patch(plt.Polygon([a, b, c], facecolor="#f0c9a8a0", edgecolor="#b3540e", linewidth=2, joinstyle="round"))
    axes.plot(*zip(a, b, c), linestyle="", marker="o", markersize=4, color="#b3540e")
    axes.plot(*p, marker="+", color="#0a58b0")
    axes.set(aspect="equal", xticks=[], yticks=[])
    axes.set_title(title, fontsize=11, color="#a8201a", fontweight="bold")
    axes.set_xlabel(truth, fontsize=10)
    # The same shape of panel for each, so that titles and labels stand on one line.
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    half = 0.55 * max(right - left, 1.5 * (high - low))
    axes.set_xlim((left + right) / 2 - half, (left + right) / 2 + half)
    axes.set_ylim((low + high) / 2 - half / 1.5, (low + high) / 2 + half / 1.5)
    for side in axes.spines.values():
        side.set_visible(False)


def made(axiscert):
    """The picture's text."""
    queries = {line["id"]: line for line in map(json.loads, QUERIES.read_text().splitlines())}
    figure, all_axes = plt.subplots(1, len(PANELS), figsize=(10, 3))
    for axes, (id, kernel, name, what) in zip(all_axes, PANELS):
        exact, computed = answers(axiscert, kernel)[id]
        if exact == computed:
            sys.exit(f"{QUERIES.name}: {kernel} is right about '{id}': {exact}; the picture shows where it is wrong")
        draw(axes, queries[id], f"{name}: {computed}", f"{what}\nin truth: {exact}")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "picture.svg"
        figure.savefig(path, metadata={"Date": None}, bbox_inches="tight")
        return path.read_text()


if __name__ == "__main__":
    text = made(sys.argv[1])
    if "--check" not in sys.argv:
        PICTURE.write_text(text)
    elif PICTURE.read_text() != text:
        sys.exit(f"{PICTURE.relative_to(ROOT)} is out of date: docs/checks/picture.py {sys.argv[1]} makes it again")
