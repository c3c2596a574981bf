"""A kernel in NumPy, judged, diagnosed by its worst query, and mended.

    python3 numpy_kernel.py [PICTURE.svg]

Each `# %%` begins a cell, for editors that run them one by one.
"""
# %%
import sys

import numpy as np

import axiscert as ax


# %% A sphere and a triangle: the point of the triangle that is nearest to the centre, by its regions.
# It looks complete. One region is missing.
def dot(u, v):
    return (u * v).sum(axis=1)


def nearest_point(a, b, c, p, edges):
    ab, ac, ap, bp, cp = b - a, c - a, p - a, p - b, p - c
    d1, d2, d3, d4, d5, d6 = dot(ab, ap), dot(ac, ap), dot(ab, bp), dot(ac, bp), dot(ab, cp), dot(ac, cp)
    va, vb, vc = d3 * d6 - d5 * d4, d5 * d2 - d1 * d6, d1 * d4 - d3 * d2
    whole = va + vb + vc
    point = a + ab * (vb / whole)[:, None] + ac * (vc / whole)[:, None]
    if "bc" in edges:
        t = (d4 - d3) / ((d4 - d3) + (d5 - d6))
        point = np.where(((va <= 0) & (d4 >= d3) & (d5 >= d6))[:, None], b + (c - b) * t[:, None], point)
    point = np.where(((vb <= 0) & (d2 >= 0) & (d6 <= 0))[:, None], a + ac * (d2 / (d2 - d6))[:, None], point)
    point = np.where(((vc <= 0) & (d1 >= 0) & (d3 <= 0))[:, None], a + ab * (d1 / (d1 - d3))[:, None], point)
    point = np.where(((d6 >= 0) & (d5 <= d6))[:, None], c, point)
    point = np.where(((d3 >= 0) & (d4 <= d3))[:, None], b, point)
    return np.where(((d1 <= 0) & (d2 <= 0))[:, None], a, point)


def first(a, b, c, p, r):
    away = p - nearest_point(a, b, c, p, edges=())
    return dot(away, away) <= r * r


def mended(a, b, c, p, r):
    away = p - nearest_point(a, b, c, p, edges=("bc",))
    return dot(away, away) <= r * r


# %% Judged in everyday scenes, in metres: contacts that are invented, where the sphere is beside that edge.
scenes = [family["name"] for family in ax.families("sphere-triangle") if family["is_scene"]]
options = dict(family=scenes, trials=2000, precision="binary32", unit="m")
before = ax.judge(first, require="depth=1mm", **options)
print(before)

# %% The shortest query that shows it, and what exact arithmetic says there.
worst = max((one for one in before.witnesses if one["kernel"] == "first"), key=lambda one: one.get("depth") or 0)
small = ax.shrink(worst["address"], first, evaluations=500)[0]
exact = ax.truth(small.query)
print(small.query.numbers.T, "distance", np.sqrt(exact.squared_distance), "nearest", *exact.facts[0]["features"].names)

# %% Mended.
after = ax.judge(mended, require="depth=1mm", **options)
print(after)

# %% Which scenes it was wrong in: a picture.
if len(sys.argv) > 1:
    import matplotlib

    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "axiscert"
    import matplotlib.pyplot as plt

    frames = [record.to_pandas() for record in (before, after)]
    figure, axes = plt.subplots(figsize=(7, 2.6), layout="constrained")
    for place, (frame, label) in enumerate(zip(frames, ("an edge left out", "mended"))):
        wrong = frame[["verdict.false_contact", "verdict.false_separation"]].sum(axis=1)
        axes.barh(np.arange(len(frame)) + 0.2 - 0.4 * place, wrong, 0.4, label=label)
    axes.set_yticks(np.arange(len(scenes)), [name.removeprefix("scene-") for name in scenes])
    axes.set_xlabel("wrong verdicts of 2,000")
    axes.legend()
    figure.savefig(sys.argv[1], metadata={"Date": None, "Creator": None})
