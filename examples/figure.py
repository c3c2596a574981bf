"""A figure for a paper: how many verdicts of a published test are wrong, by the bits of the arithmetic and the shape of the triangles.

    python3 figure.py FIGURE.svg [QUERIES]
"""
# %%
import sys

import matplotlib
import numpy as np

import axiscert as ax

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "axiscert"
import matplotlib.pyplot as plt

queries = int((sys.argv + [""])[2] or 400)
families = ["general", "tangent", "sliver", "far"]
bits = [8, 11, 14, 17, 20, 24]

# %% The same queries in each format, beside the exact verdict. The queries are those of binary32: only the operations are rounded.
shares = {}
for family in families:
    q = ax.generate(family, queries)
    exact = ax.truth(q)
    shares[family] = [np.mean(ax.formulae("published", q, format=f"bits={b}").verdict[exact.valid] != exact.verdict[exact.valid])
                      for b in bits]

# %%
figure, axes = plt.subplots(figsize=(5, 3), layout="constrained")
for family, share in shares.items():
    axes.plot(bits, share, marker="o", label=family)
axes.set_xlabel("bits of the significand")
axes.set_ylabel("wrong verdicts")
axes.set_yscale("symlog", linthresh=1 / queries)
axes.legend()
figure.savefig(sys.argv[1], metadata={"Date": None, "Creator": None})
