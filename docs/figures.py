#!/usr/bin/python3
"""Writes the figures of the documents from the commands that are stated with them.

figures.py AXISCERT FILE.md...            runs each command and replaces what is below it
figures.py --check AXISCERT FILE.md...    fails where that would change a file

A figure is a block
    <!-- $ axiscert NAME ARGS -->
    (text, generated)
    <!-- end -->
whose text is the command's output; with `<!-- table N of: $ axiscert NAME ARGS -->` its N-th table, from 0; with
`<!-- plot N of: ... -->` the N-th plot of its page, as plots/*.svg.
The commands are deterministic: figures that vary from run to run (times) are not made this way.
"""
import html
import io
import json
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams.update({"svg.hashsalt": "axiscert", "svg.fonttype": "none", "font.size": 10, "font.sans-serif": ["DejaVu Sans"],
                            "axes.grid": True, "grid.color": "#d8dde4", "axes.spines.top": False,
                            "axes.spines.right": False})
import matplotlib.pyplot as plt

COLOURS = ["#0a58b0", "#b3540e", "#14632d", "#a8201a", "#6d3fb0", "#00707a", "#8a6d00", "#7a3b62"]
BLOCK = re.compile(r"<!-- (?:(?P<part>plot|table) (?P<number>\d+) of: )?\$ axiscert (?P<command>[^\n]*?) -->\n.*?<!-- end -->\n", re.S)


class Commands:
    """Runs each command once: its text, and the plots of its page."""

    def __init__(self, axiscert):
        self.axiscert = axiscert
        self.results = {}

    def run(self, command):
        if command not in self.results:
            with tempfile.TemporaryDirectory() as folder:
                words = [self.axiscert, *shlex.split(command)]
                done = subprocess.run([*words, "--out", folder], text=True, capture_output=True)
                if done.returncode != 0:
                    sys.exit(f"{shlex.join(words)}: exit {done.returncode}: {done.stderr}")
                page = next(pathlib.Path(folder).glob("*.html"))
                text = "\n".join(line for line in done.stdout.splitlines() if folder not in line).strip()
                plots = re.search(r'<script id="plots" type="application/json">(.*?)</script>', page.read_text(), re.S)
                captions = re.findall(r'<canvas role="img" aria-label="(.*?)">', page.read_text())
                self.results[command] = (text, json.loads(plots[1]), [html.unescape(c) for c in captions])
        return self.results[command]


def draw(plot, caption, path):
    figure, axes = plt.subplots(figsize=(8, 4.2))
    longest = max((len(series["points"]) for series in plot["series"]), default=0)
    is_full = sum(len(series["points"]) for series in plot["series"]) > 40
    for i, series in enumerate(plot["series"]):
        points = series["points"]
        x, y = [p[0] for p in points], [p[1] for p in points]
        turn = i // len(COLOURS)  # of the colours: a colour that comes again has another marker
        style = {"color": COLOURS[i % len(COLOURS)], "label": series["name"], "marker": "osD^vPX*"[(i + turn) % 8]}
        if series.get("intervals"):
            below = [v - low for v, (low, _) in zip(y, series["intervals"])]
            above = [high - v for v, (_, high) in zip(y, series["intervals"])]
            # Where there are many points, every fourth has its interval, without caps: the file stays small.
            axes.errorbar(x, y, yerr=[below, above], fmt="none", ecolor=style["color"], elinewidth=0.9, capsize=0 if is_full else 2,
                          errorevery=(i % 4, 4) if is_full else 1)
        if plot["kind"] == "line":
            # Long lines have a few markers, each at other points: lines upon one another are seen, and the file stays small.
            every = max(1, min(longest // 8, len(points))) if longest > 32 else 1
            axes.plot(x, y, markersize=4, markevery=(i % every, every), linestyle="-" if i < len(COLOURS) else "--", **style)
        else:
            axes.scatter(x, y, **style)
            for point, label in zip(points, () if is_full else series["labels"]):
                axes.annotate(label, point, textcoords="offset points", xytext=(6, 4), fontsize=8)
    for axis, name in ((axes.xaxis, "x"), (axes.yaxis, "y")):
        axis.set_label_text(plot[name]["label"])
        if plot[name]["log"]:
            getattr(axes, f"set_{name}scale")("log")
            axis.set_tick_params(which="minor", length=0 if is_full else 2)
        if plot[name].get("names"):
            axis.set_ticks(range(len(plot[name]["names"])), plot[name]["names"], rotation=40, ha="right")
    axes.set_title(caption, fontsize=11)
    beside = {"loc": "upper left", "bbox_to_anchor": (1.01, 1)} if len(plot["series"]) > len(COLOURS) else {}
    axes.legend(fontsize=8, frameon=False, **beside)
    svg = io.StringIO()
    figure.savefig(svg, format="svg", metadata={"Date": None}, bbox_inches="tight")
    plt.close(figure)
    # Hundredths are exact enough, and shorter.
    path.write_text(re.sub(r"\d+\.\d{3,}", lambda number: f"{float(number[0]):.2f}", svg.getvalue()))


def figure_of(match, commands, folder):
    """The block again, and the plot file that it needs."""
    command = match["command"]
    text, plots, captions = commands.run(command)
    head = match[0].split("\n", 1)[0]
    number = int(match["number"] or 0)
    if match["part"] != "plot":
        shown = text.split("\n\n")[1 + number] if match["part"] == "table" else text
        return f"{head}\n```\n$ axiscert {command}\n{shown}\n```\n<!-- end -->\n"
    name = f"{command.split()[0]}-{number}-" + re.sub(r"[^a-z0-9]+", "-", captions[number].lower()).strip("-") + ".svg"
    folder.mkdir(exist_ok=True)
    draw(plots[number], captions[number], folder / name)
    return f"{head}\n![{captions[number]}](plots/{name})\n<!-- end -->\n"


def main(arguments):
    check = arguments[0] == "--check"
    axiscert, *files = arguments[check:]
    commands = Commands(axiscert)
    stale = []
    for name in files:
        path = pathlib.Path(name)
        old = path.read_text()
        with tempfile.TemporaryDirectory() as scratch:
            plots = pathlib.Path(scratch) if check else path.parent / "plots"
            new = BLOCK.sub(lambda match: figure_of(match, commands, plots), old)
            if check:
                stale += [f"plots/{made.name}" for made in plots.glob("*.svg")
                          if not (kept := path.parent / "plots" / made.name).exists()
                          or kept.read_bytes() != made.read_bytes()]
        if new != old:
            stale.append(name)
            if not check:
                path.write_text(new)
    if check and stale:
        sys.exit(f"out of date: {', '.join(stale)}; make them again with docs/figures.py {axiscert} {' '.join(files)}")


if __name__ == "__main__":
    main(sys.argv[1:])
