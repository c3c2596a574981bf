"""What axiscert raises. Messages have the words of the command: what was given, where, and what would be right."""
from __future__ import annotations

import numbers
import operator
import os
import reprlib
from typing import TYPE_CHECKING, Any, Dict, Optional

if TYPE_CHECKING:
    from ._judge import Record
    from ._queries import Queries


class Error(ValueError):
    """Bad usage or input."""


def whole(name: str, value: Any, least: int = 0, greatest: int = 2**63 - 1) -> int:
    """The value of an argument that is a whole number."""
    try:
        number = None if isinstance(value, bool) else operator.index(value)
    except TypeError:
        number = None
    if number is None:
        raise Error(f"{name}={value!r}: give a whole number")
    if not least <= number <= greatest:
        raise Error(f"{name}={value!r}: give a whole number from {least} to {greatest}")
    return number


_LIMITS = {"trials": (1, 2**48), "evaluations": (1, 2**48), "seed": (0, 2**64 - 1), "threads": (0, 4096), "flips": (0, 2**32),
           "sample": (0, 2**32), "rounding_seeds": (1, 1000)}


def checked(options: Dict[str, Any]) -> Dict[str, Any]:
    """The options, with numbers within the limits that the command has for them."""
    for name, (least, greatest) in _LIMITS.items():
        if options.get(name) is not None:
            options[name] = whole(name, options[name], least, greatest)
    if options.get("seconds") is not None:
        options["seconds"] = above_zero("seconds", options["seconds"])
    return options


def real(value: Any) -> float:
    """The value of an argument that is a number of any type; NaN of what is none."""
    try:
        return float(value) if isinstance(value, numbers.Real) and not isinstance(value, bool) else float("nan")
    except OverflowError:
        return float("inf")


def above_zero(name: str, value: Any) -> float:
    if not 0 < real(value) < float("inf"):
        raise Error(f"{name}={value!r}: give a number above 0")
    return real(value)


def flag(name: str, value: Any) -> bool:
    """The value of an argument that is True or False, NumPy's too."""
    if type(value).__name__ not in ("bool", "bool_"):
        raise Error(f"{name}={value!r}: give True or False")
    return bool(value)


def path(name: str, value: Any) -> str:
    """The value of an argument that is the path of a file."""
    try:
        return os.fsdecode(value)
    except TypeError:
        raise Error(f"{name}={reprlib.repr(value)}: give a path, as a text") from None


def text(name: str, value: Any) -> str:
    """The value of an argument that is a text."""
    if not isinstance(value, str):
        raise Error(f"{name}={value!r}: give a text")
    return value


class HarnessFault(RuntimeError):
    """axiscert found a fault of its own: oracles that differ, a build whose arithmetic is contracted."""


class KernelRaised(Error):
    """A kernel's function raised, which is the `__cause__`, or answered what is no answer.

    `queries` is the batch that it was asked.
    """

    queries: "Optional[Queries]" = None


class Interrupted(KeyboardInterrupt):
    """Ended by Ctrl-C. `record` is that of the units of queries that were done, with `complete` false; `found` is what another
    function would have returned, of what was found until then."""

    record: "Optional[Record]" = None
    found: Any = None


class Notice(UserWarning):
    """What is said beside a result: queries that are left out, a kernel that is not fit to be asked."""
