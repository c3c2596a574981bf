"""axiscert judges collision kernels beside exact arithmetic: NumPy functions, tensors, plug-ins and programs.

    import axiscert as ax
    q = ax.generate("tangent", 1000)      # queries as arrays
    ax.truth(q).contact                   # the exact answers
    ax.judge(my_function, family="tangent", require="logic")

docs/python.md has the rest; numbers are in the unit of the queries, precisions are "binary32" and "binary64".
"""
from __future__ import annotations

import os as _os

from ._errors import Error, HarnessFault, Interrupted, KernelRaised, Notice
from . import _core

# What comes with the command: the process in which plug-ins and programs run, peers, the corpus.
_core.set_own_folder(_os.path.join(_os.path.dirname(_os.path.abspath(__file__)), "bin"))

from ._queries import (Queries, corpus, describe, families, generate, kernels, load_all_queries, load_mesh, load_queries,
                       predicates, query_at)
from ._truth import CONTACT, INVALID, SEPARATED, UNANSWERED, UNDECIDED, VERDICTS, Exact, Fact, Truth, nearest_sqrt, truth
from ._kernels import Kernel, kernel
from ._judge import Outcome, Record, judge
from ._formulae import Computed, formulae, number_formats
from ._instruments import (Comparison, Report, Shrunk, certify, compare, condition, diagnose, ladder, precision, search, shrink)
from . import certified

__version__: str = _core.version()
__all__ = [
    "CONTACT", "INVALID", "SEPARATED", "UNANSWERED", "UNDECIDED", "VERDICTS", "Comparison", "Computed", "Error", "Exact", "Fact",
    "HarnessFault", "Interrupted", "Kernel", "KernelRaised", "Notice", "Outcome", "Queries", "Record", "Report", "Shrunk", "Truth",
    "certified", "certify", "compare", "condition", "corpus", "describe", "diagnose", "families", "formulae", "generate", "judge",
    "kernel", "kernels", "ladder", "load_all_queries", "load_mesh", "load_queries", "nearest_sqrt", "number_formats", "precision",
    "predicates", "query_at", "search", "shrink", "truth",
]
