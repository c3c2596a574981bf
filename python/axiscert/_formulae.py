"""The formulae of built-in kernels, in the precision of the queries or in any format."""
from __future__ import annotations

from typing import Any, Dict, List, Optional

import numpy as np

from . import _core
from ._errors import Error, text, whole
from ._queries import Queries, describe


class Computed:
    """What formulae come to: `verdict`, uint8, shape (n,); `holds`, bool, (n, comparisons), and `bits`, uint64, None where there are
    no comparisons; `lhs` and `rhs`, (comparisons, n), the sides in the precision of the queries.

    In a format the sides are float64, each the nearest to the format's number, NaN where `valid` is False: the query is none, or is
    beyond the format that its numbers are rounded to. `unlimited` is verdict and bits with unlimited exponents, so that
    `verdict != unlimited.verdict` is the cost of range.
    """

    lhs: "Optional[np.ndarray[Any, Any]]" = None
    rhs: "Optional[np.ndarray[Any, Any]]" = None
    unlimited: "Optional[Computed]" = None
    valid: "Optional[np.ndarray[Any, Any]]" = None

    def __init__(self, verdict: Any, bits: Any, comparisons: List[str]) -> None:
        self.verdict: "np.ndarray[Any, Any]" = verdict
        self.bits: "Optional[np.ndarray[Any, Any]]" = bits
        self.comparisons = comparisons

    @property
    def holds(self) -> "Optional[np.ndarray[Any, Any]]":
        if self.bits is None:
            return None
        places = np.arange(len(self.comparisons), dtype=np.uint64)
        holds: "np.ndarray[Any, Any]" = ((self.bits[:, None] >> places) & np.uint64(1)).astype(bool)
        return holds

    @property
    def contact(self) -> "np.ndarray[Any, Any]":
        contact: "np.ndarray[Any, Any]" = self.verdict == 0
        return contact

    def __repr__(self) -> str:
        return f"<verdicts of {len(self.verdict)} queries, {len(self.comparisons)} comparisons of each>"


def formulae(kernel: str, queries: Queries, *, format: str = "", rounding: str = "nearest", fused: str = "none",
             round_inputs: bool = False, seed: int = 1, target: str = "scalar", threads: int = 0) -> Computed:
    """The formulae of a built-in kernel ("published", "ladder-3", "published+fma") on queries.

    Without a format, as the kernel computes them, with both sides of every comparison. With one, "bfloat16", "binary16",
    "fp8-e4m3", "bits=12,emax=15" (`number_formats`), every operation is rounded once to it: `rounding` nearest, up, down, zero,
    faithful or stochastic (by `seed`), `fused` "dots" for dot and cross products of fused operations. Inputs are taken as they are,
    or rounded first.

    >>> from axiscert import generate
    >>> q = generate("tangent", 200)
    >>> exact = formulae("published", q)
    >>> rough = formulae("published", q, format="bfloat16")
    >>> exact.lhs.shape, rough.lhs.shape, rough.bits.shape
    ((16, 200), (16, 200), (200,))
    """
    if not isinstance(queries, Queries):
        raise Error(f"formulae takes Queries, not {type(queries).__name__}; Queries.of makes them of arrays")
    if not isinstance(round_inputs, (bool, np.bool_)):
        raise Error(f"round_inputs={round_inputs!r}: give True or False")
    comparisons: List[str] = describe(queries.predicate)["comparisons"]
    asked = (queries.predicate, queries.entry, queries.numbers, text("kernel", kernel))
    threads = whole("threads", threads, greatest=4096)
    if not text("format", format):
        if rounding != "nearest" or fused != "none" or round_inputs:
            raise Error("rounding, fused and round_inputs are of a format; give one, as format=\"binary32\"")
        verdict, bits, lhs, rhs = _core.computed(*asked, text("target", target), threads)
        made = Computed(verdict, bits, comparisons)
        made.lhs, made.rhs = lhs, rhs
        return made
    verdict, bits, unlimited_verdict, unlimited_bits, valid, lhs, rhs = _core.in_format(
        *asked, format, text("rounding", rounding), text("fused", fused), whole("seed", seed, greatest=2**64 - 1), round_inputs, threads)
    made = Computed(verdict, bits, comparisons)
    made.unlimited, made.valid = Computed(unlimited_verdict, unlimited_bits, comparisons), valid
    made.lhs, made.rhs = lhs, rhs
    return made


def number_formats() -> Dict[str, str]:
    """The formats that have a name, and what each is."""
    return dict(_core.number_formats())
