#!/usr/bin/python3
"""Wrong verdicts against the bits of precision, from the JSON of `axiscert precision`.

    axiscert precision --kernel published --kernel reduced --format json > bits.json
    bits.py bits.json OUT.svg [FAMILY...]      all families together, or a panel for each

A kernel that is wrong on no query at some precision has no point there: the scale is logarithmic. The dotted line is a kernel's own error in
exact arithmetic, which no precision removes; one without any has none.
"""
import json
import sys

import matplotlib

matplotlib.use("svg")
# The same file from the same numbers, and a small one.
matplotlib.rcParams.update({"svg.hashsalt": "axiscert", "svg.fonttype": "none", "font.sans-serif": ["DejaVu Sans"],
                            "axes.grid": True, "grid.color": "#d8dde4", "xtick.bottom": False, "ytick.left": False})
import matplotlib.pyplot as plt

PRECISION_BITS = {"binary32": 24, "binary64": 53}


def per_million(counts, queries):
    return 1e6 * (counts["false_separation"] + counts["false_contact"]) / queries


def panel(axes, result, title):
    """One panel: a line for each kernel."""
    for name, kernel in result["kernels"].items():
        points = [(row["bits"], per_million(row["unlimited"]["verdict"], row["queries"])) for row in kernel["precisions"]]
        # Every second point has a marker, the last one or the only one always.
        (line,) = axes.plot(*zip(*[point for point in points if point[1] > 0]), marker="o", markersize=3, markevery=slice(None, None, -2), label=name)
        own = per_million(kernel["exact"], result["queries"])
        if own > 0:
            axes.axhline(own, color=line.get_color(), linestyle=":", linewidth=1)
    axes.set(title=title, xscale="log", yscale="log", xlabel="bits of precision", ylabel="wrong verdicts per million")


def main(source, target, *families):
    with open(source) as file:
        data = json.load(file)
    panels = [(name, data["families"][name]) for name in families] or [("all families", data["all"])]
    figure, all_axes = plt.subplots(1, len(panels), figsize=(1 + 4.5 * len(panels), 4), sharey=True, squeeze=False)
    for axes, (title, result) in zip(all_axes[0], panels):
        panel(axes, result, title)
        axes.axvline(PRECISION_BITS[data["precision"]], color="grey", linewidth=1)
        ticks = [8, 16, 24, 32, 53, 128, 256]
        axes.set_xticks(ticks, ticks)
        axes.minorticks_off()
    all_axes[0][0].legend(frameon=False, fontsize=8)
    figure.savefig(target, metadata={"Date": None}, bbox_inches="tight")


if __name__ == "__main__":
    main(*sys.argv[1:])
