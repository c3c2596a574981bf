"""What axiscert raises. Messages have the words of the command: what was given, where, and what would be right."""
from __future__ import annotations

from typing import TYPE_CHECKING, Optional

if TYPE_CHECKING:
    from ._judge import Record
    from ._queries import Queries


class Error(ValueError):
    """Bad usage or input."""


class HarnessFault(RuntimeError):
    """axiscert found a fault of its own: oracles that differ, a build whose arithmetic is contracted."""


class KernelRaised(Error):
    """A kernel's function raised, which is the `__cause__`, or answered what is no answer.

    `queries` is the batch that it was asked.
    """

    queries: "Optional[Queries]" = None


class Interrupted(KeyboardInterrupt):
    """Ended by Ctrl-C. `record` is that of the units of queries that were done, with `complete` false."""

    record: "Optional[Record]" = None


class Notice(UserWarning):
    """What is said beside a result: queries that are left out, a kernel that is not fit to be asked."""
