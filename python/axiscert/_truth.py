"""The exact answers to queries."""
from __future__ import annotations

import math
from fractions import Fraction
from functools import cached_property
from typing import Any, Dict, List, NamedTuple, Optional, Tuple

import numpy as np

from . import _core
from ._errors import Error, text, whole
from ._queries import Queries, describe, entry_of

CONTACT, SEPARATED, UNDECIDED, INVALID, UNANSWERED = range(5)
VERDICTS = ("contact", "separated", "undecided", "invalid", "unanswered")


def nearest_sqrt(value: Any) -> float:
    """The float nearest to the root of a fraction that is not negative: rounded once.

    >>> nearest_sqrt(Fraction(2)) == math.sqrt(2)
    True
    """
    try:
        value = Fraction(value.item() if isinstance(value, np.generic) else value)
    except (TypeError, ValueError, OverflowError):
        raise Error(f"{value!r} is no fraction") from None
    if value < 0:
        raise Error(f"{value} is negative, and has no root")
    if value == 0:
        return 0.0
    shift = max(0, 64 - (value.numerator.bit_length() - value.denominator.bit_length()) // 2)
    scaled, rest = divmod(value.numerator << (2 * shift), value.denominator)
    root = math.isqrt(scaled)
    is_exact = rest == 0 and root * root == scaled
    try:
        return float(Fraction(2 * root + (not is_exact), 2 << shift))  # 64 bits and the rest as half a bit: rounds as the root
    except OverflowError:
        return math.inf


class Exact:
    """A number that exact arithmetic tells: a rational, `rest + sign * sqrt(square)`, or a depth `|sqrt(dd) - r| / sqrt(ss)`.

    `float(x)` is the nearest of 17 digits, `str(x)` the number itself, `x.fraction` a Fraction, where it is one.
    """

    def __init__(self, given: Any) -> None:
        (self.kind, *parts), self._decimal, self._text = given
        self.parts: Tuple[Any, ...] = tuple(Fraction(*part) if isinstance(part, tuple) else part for part in parts)

    @property
    def fraction(self) -> Fraction:
        if self.kind == "root":
            rest, square, sign = self.parts
            root = Fraction(math.isqrt(square.numerator), math.isqrt(square.denominator))
            if root * root == square:
                return Fraction(rest + sign * root)
        elif self._text.lstrip("-").replace("/", "").isdigit():
            return Fraction(self._text)
        raise ValueError(f"{self._text} is not a fraction")

    def __float__(self) -> float:
        return float(self._decimal)

    def __str__(self) -> str:
        return str(self._text)

    def __repr__(self) -> str:
        return f"<exactly {self._text}>"


class Fact(NamedTuple):
    """What exact arithmetic tells of a query under a name: one number, or the three of a place or direction; or names."""

    numbers: Tuple[Exact, ...]
    names: Tuple[str, ...]
    unit: str
    note: str


class Truth:
    """The exact answers to queries, each found when it is first asked for. Of what is no valid query there are none: NaN,
    None, False.

    >>> from axiscert import Queries, truth
    >>> t = truth(Queries.of(a=[[0, 0, 0]], b=[[1, 0, 0]], c=[[0, 1, 0]], p=[[0, 0, 2]], r=[2]))
    >>> t.contact, t.touching, t.squared_distance_exact
    (array([ True]), array([ True]), [Fraction(4, 1)])
    >>> t.facts[0]["nearest_point"].numbers
    (<exactly 0>, <exactly 0>, <exactly 0>)
    """

    def __init__(self, queries: Queries, threads: int = 0) -> None:
        self.queries, self._threads = queries, threads

    def _asked(self, function: Any, *more: Any) -> Any:
        q = self.queries
        return function(q.predicate, q.entry, q.numbers, *more, self._threads)

    @cached_property
    def _verdicts(self) -> "Tuple[np.ndarray[Any, Any], np.ndarray[Any, Any]]":
        verdict, touching = self._asked(_core.verdicts)
        verdict.flags.writeable = touching.flags.writeable = False
        return verdict, touching

    @property
    def verdict(self) -> "np.ndarray[Any, Any]":
        """uint8, shape (n,): `CONTACT`, touching included, `SEPARATED` or `INVALID`."""
        return self._verdicts[0]

    @property
    def contact(self) -> "np.ndarray[Any, Any]":
        """bool, shape (n,)."""
        contact: "np.ndarray[Any, Any]" = self.verdict == CONTACT
        return contact

    @property
    def separated(self) -> "np.ndarray[Any, Any]":
        separated: "np.ndarray[Any, Any]" = self.verdict == SEPARATED
        return separated

    @property
    def valid(self) -> "np.ndarray[Any, Any]":
        valid: "np.ndarray[Any, Any]" = self.verdict != INVALID
        return valid

    @property
    def touching(self) -> "np.ndarray[Any, Any]":
        """bool, shape (n,): in contact without overlapping."""
        return self._verdicts[1]

    def signs(self, kernel: str = "") -> "Tuple[np.ndarray[Any, Any], np.ndarray[Any, Any]]":
        """The formulae of a built-in kernel in exact arithmetic: (holds, ties), bool of shape (n, comparisons).

        A tie has equal sides. Without a kernel, the formulae that the predicate's plug-ins are taken to have.
        """
        described = describe(self.queries.predicate)
        if not kernel:
            kernel = described["usual_formulae"] or entry_of(self.queries.predicate, self.queries.entry)["default_kernel"]
        bits = np.arange(len(described["comparisons"]), dtype=np.uint64)
        holds, ties = self._asked(_core.signs, text("kernel", kernel))
        one = np.uint64(1)
        return ((holds[:, None] >> bits) & one).astype(bool), ((ties[:, None] >> bits) & one).astype(bool)

    @cached_property
    def depth(self) -> "np.ndarray[Any, Any]":
        """float64, shape (n,): how far each query is from touching, as a share of its scene, rounded once."""
        depth: "np.ndarray[Any, Any]" = self._asked(_core.depths)
        depth.flags.writeable = False
        return depth

    @cached_property
    def squared_distance_exact(self) -> List[Optional[Fraction]]:
        """The square of the distance that the predicate compares; None where it is not valid, or tells none."""
        return [None if pair is None else Fraction(*pair) for pair in self._asked(_core.squared_distances)]

    @property
    def squared_distance(self) -> "np.ndarray[Any, Any]":
        """The same in float64, each the nearest."""
        return np.array([_float(value) for value in self.squared_distance_exact])

    @cached_property
    def squared_critical_value_exact(self) -> List[Optional[Fraction]]:
        """The square of the critical value: of the length (a radius, a half extent) from which on there is contact. None where
        there is contact at any."""
        return [None if pair is None else Fraction(*pair) for pair in self._asked(_core.squared_critical_values)]

    @property
    def critical_value(self) -> "np.ndarray[Any, Any]":
        """float64: the nearest to the critical value; NaN where there is none."""
        return np.array([math.nan if value is None else nearest_sqrt(value) for value in self.squared_critical_value_exact])

    @cached_property
    def facts(self) -> "List[Optional[Dict[str, Any]]]":
        """Of each query what there is to tell besides its verdict, by name: lengths, places, directions and times as a `Fact`;
        names of the nearest features, and other details, as they are."""

        def told(value: Any) -> Any:
            if not isinstance(value, tuple):
                return value
            numbers, names, unit, note = value
            return Fact(tuple(Exact(number) for number in numbers), tuple(names), unit, note)

        return [None if one is None else {name: told(value) for name, value in one.items()} for one in self._asked(_core.facts)]

    def fact(self, name: str) -> "np.ndarray[Any, Any]":
        """One of the facts as float64, shape (n,), or (n, 3) of places and directions; NaN where there is none.

        >>> from axiscert import generate, truth
        >>> truth(generate("general", 5)).fact("nearest_point").shape
        (5, 3)
        """
        rows: List[Optional[List[float]]] = []
        known: Dict[str, None] = {}
        for facts in self.facts:
            known.update(dict.fromkeys(facts or {}))
            value = (facts or {}).get(name)
            if isinstance(value, Fact):
                rows.append([float(number) for number in value.numbers] or None)
            else:
                rows.append([float(value)] if isinstance(value, (int, float)) else None)
        if known and name not in known:
            raise Error(f"no fact '{name}' is told of these queries; there are: {', '.join(known)}")
        width = max((len(row) for row in rows if row), default=1)
        array = np.array([row or [math.nan] * width for row in rows]).reshape(len(rows), width)
        return array[:, 0] if width == 1 else array


def _float(value: Optional[Fraction]) -> float:
    if value is None:
        return math.nan
    try:
        return float(value)
    except OverflowError:
        return math.inf


def truth(queries: Queries, *, threads: int = 0) -> Truth:
    """The exact answers to queries. Raises `HarnessFault` where two ways of finding one answer differ.

    >>> from axiscert import generate, truth
    >>> int(truth(generate("tangent", 1000)).touching.sum())
    0
    """
    if not isinstance(queries, Queries):
        raise Error(f"truth takes Queries, not {type(queries).__name__}; Queries.of makes them of arrays")
    return Truth(queries, whole("threads", threads, greatest=4096))
