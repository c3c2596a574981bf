#!/usr/bin/python3
"""docs/plots/contacts.svg: the five worst numbers of each kind that libraries and engines say beside a verdict, and what is right.

    contact_picture.py            writes it
    contact_picture.py --check    fails where that would change it, or where contacts.jsonl is not what it should be
    contact_picture.py --collect AXISCERT    asks `axiscert league --contacts` again, and writes contacts.jsonl

The queries and what was said of them are docs/checks/contacts.jsonl, lines of `worst_contacts` of league.json. A panel is the plane of the exact normal,
which is vertical, and what differs from it: lengths and angles in it are to scale.
"""
import io
import json
import re
import subprocess
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams.update({"svg.hashsalt": "axiscert", "svg.fonttype": "none", "font.size": 8, "font.sans-serif": ["DejaVu Sans"]})
import matplotlib.pyplot as plt

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "kernel/peers/npm"))
import exact  # noqa: E402

LINES, PICTURE = ROOT / "docs/checks/contacts.jsonl", ROOT / "docs/plots/contacts.svg"
KINDS = {"separation": "separation", "left": "after a push", "normal": "normal", "point": "point"}
ASKED = ["--precision", "binary32", "--trials", "1024", "--family", "scene-walk", "--family", "scene-edge", "--family", "general"]
SHOWN = 5


def library_of(kernel):
    """peer/three/octree is three's, peer/bullet-gjk Bullet's."""
    name = kernel.removeprefix("peer/")
    return name.split("/")[0] if "/" in name else name.split("-")[0]


def collected(axiscert):
    """The five worst of each kind among the libraries and engines, each library once."""
    listed = subprocess.run([axiscert, "kernels"], text=True, capture_output=True).stdout.splitlines()
    # A second triangle in the mesh changes nothing here.
    kernels = [line.split()[0] for line in listed if line.startswith("peer/") and not line.split()[0].endswith("-beside")]
    found = []
    for kernel in kernels:
        with tempfile.TemporaryDirectory() as folder:
            command = [axiscert, "league", kernel, "--contacts", *ASKED, "--out", folder]
            subprocess.run(command, check=True, capture_output=True)
            found += json.loads((Path(folder) / "league.json").read_text())["worst_contacts"]
    lines = []
    for kind in KINDS:
        worst = {}  # of each library
        for one in sorted((one for one in found if one["kind"] == kind), key=lambda one: -one["size"]):
            worst.setdefault(library_of(one["kernel"]), one)
        lines += list(worst.values())[:SHOWN]
    return "".join(json.dumps(line, separators=(",", ":")) + "\n" for line in lines)


def number(x):
    return float.fromhex(x) if isinstance(x, str) else float(x)


def unit(v):
    size = sum(x * x for x in v) ** 0.5
    return [x / size for x in v] if size else v


class Panel:
    """A query seen from its centre, in shares of its scene."""

    def __init__(self, line):
        query, given = line["query"], line["query"]["measures"]["given"]
        flat = [number(x) for name in "abcp" for x in query[name]] + [number(query["r"])]
        seen = lambda v: [float(Fraction(x) - Fraction(c)) for x, c in zip(v, flat[9:12])]
        corners = [seen(flat[k:k + 3]) for k in (0, 3, 6)]
        self.scene = max(flat[12], *(exact.dot(v, v) ** 0.5 for v in corners))
        share = lambda v: [x / self.scene for x in v]
        self.corners, self.r = [share(v) for v in corners], flat[12] / self.scene
        vector = lambda name: [number(given.get(f"{name}_{axis}", "nan")) for axis in "xyz"]
        self.point, self.normal = share(seen(vector("point"))) if self.has(vector("point")) else None, vector("normal")
        self.separation = number(given["separation"]) / self.scene
        self.nearest = share([-float(x) for x in exact.away(flat)])

    @staticmethod
    def has(v):
        return all(abs(x) < 1e30 for x in v)

    def axes(self):
        """Two directions at right angles: the exact normal, or where the centre is on the triangle what was said; and what differs from it most."""
        up = unit([-x for x in self.nearest]) if any(self.nearest) else unit(self.normal)
        off = lambda v: exact.minus(v, [exact.dot(v, up) * x for x in up])
        candidates = [off(v) for v in ([self.normal] if self.has(self.normal) else []) + ([exact.minus(self.point, self.nearest)] if self.point else [])]
        candidates += [off(exact.minus(v, self.nearest)) for v in self.corners]
        across = next((v for v in candidates if exact.dot(v, v) > 1e-6), candidates[-1])
        return unit(across), up


def draw(axes, line):
    panel = Panel(line)
    frame = panel.axes()
    flat = lambda v: [exact.dot(v, axis) for axis in frame]
    axes.add_patch(plt.Circle((0, 0), panel.r, facecolor="#dbe8f7", edgecolor="#0a58b0", linewidth=0.8))
    axes.add_patch(plt.Polygon([flat(v) for v in panel.corners], facecolor="#f0c9a8a0", edgecolor="#b3540e", linewidth=1.2, joinstyle="round"))
    axes.plot(0, 0, marker="+", color="#0a58b0")
    near, size = flat(panel.nearest), 0.45

    def arrow(start, way, colour):
        axes.annotate("", [s + size * w for s, w in zip(start, way)], start, arrowprops={"arrowstyle": "->", "color": colour, "linewidth": 1.3})

    if any(panel.nearest):
        arrow(near, (0, 1), "#14632d")
    axes.plot(*near, marker="o", markersize=3.5, color="#14632d")
    if line["kind"] == "separation" and panel.separation + panel.r > 0:
        axes.add_patch(plt.Circle((0, 0), panel.separation + panel.r, fill=False, edgecolor="#a8201a", linestyle=":", linewidth=1.3))
    if line["kind"] in ("left", "normal") and Panel.has(panel.normal):
        arrow(near, unit(flat(panel.normal)), "#a8201a")
    if panel.point and line["kind"] == "point":
        axes.plot(*flat(panel.point), marker="x", markersize=5, color="#a8201a")
    shown = {"separation": "off by {:.2g} of the scene", "point": "off by {:.2g} of the scene", "left": "leaves {:.2g} of the depth", "normal": "{:.3g} degrees"}
    size = line["size"] * 180 / 3.141592653589793 if line["kind"] == "normal" else line["size"]
    axes.set_title(line["kernel"].removeprefix("peer/"), fontsize=8)
    axes.set_xlabel(shown[line["kind"]].format(size), fontsize=7)
    axes.set(aspect="equal", xticks=[], yticks=[], xlim=(-1.15, 1.15), ylim=(-1.15, 1.15))
    axes.set_frame_on(False)
    for drawn in [*axes.patches, *axes.lines]:
        drawn.set_clip_on(False)


def made():
    lines = [json.loads(line) for line in LINES.read_text().splitlines()]
    figure, grid = plt.subplots(len(KINDS), SHOWN, figsize=(10, 9))
    for row, kind in zip(grid, KINDS):
        of_kind = [line for line in lines if line["kind"] == kind]
        if len(of_kind) != SHOWN:
            sys.exit(f"{LINES.name}: {len(of_kind)} lines of kind '{kind}', not {SHOWN}")
        for axes, line in zip(row, of_kind):
            draw(axes, line)
        row[0].set_ylabel(KINDS[kind], fontsize=9)
    figure.tight_layout(h_pad=2)
    written = io.StringIO()
    figure.savefig(written, metadata={"Date": None})
    # A tenth of a point is enough, and names are of what is referred to.
    tenths = lambda tag: re.sub(r"\d+\.\d{2,}", lambda number: f"{float(number[0]):.1f}", tag[0])
    text = re.sub(r"<metadata>.*</metadata>|<!--.*?-->|(?<=<g) id=\"[^\"]*\"", "", re.sub("<[^>]*>", tenths, written.getvalue()), flags=re.DOTALL)
    return "".join(line.lstrip() + "\n" for line in text.splitlines() if line.strip())


if __name__ == "__main__":
    if sys.argv[1:2] == ["--collect"]:
        LINES.write_text(collected(sys.argv[2]))
    text = made()
    if "--check" not in sys.argv:
        PICTURE.write_text(text)
    elif PICTURE.read_text() != text:
        sys.exit(f"{PICTURE.relative_to(ROOT)} is out of date: docs/checks/contact_picture.py makes it again")
