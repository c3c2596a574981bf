"""Queries of any predicate as the tests read, change and judge them, and what a command tells of some beside their truths."""
import json
import struct
from collections import Counter, namedtuple
from itertools import groupby

from exact_predicates import truth

# The statement of a command, `shown`, about these queries, and the function of their truths that it has to be.
Told = namedtuple("Told", "what queries shown expected")


def counts(said):
    """The function of the truths that counts them, and the wrong ones of these verdicts, as a record does."""
    def counted(truths):
        found = Counter(verdict for verdict, _ in truths)
        found["touching"] = sum(touching for _, touching in truths)
        found.update({"separated contact": "false_separation", "contact separated": "false_contact"}[f"{answer} {right}"]
                     for answer, (right, _) in zip(said, truths, strict=True) if {answer, right} == {"separated", "contact"})
        return {name: found[name] for name in ("separated", "contact", "touching", "invalid", "false_separation", "false_contact")}
    return counted


def wrong(said):
    def counted(truths):
        found = counts(said)(truths)
        return found["false_separation"], found["false_contact"]
    return counted


def counted_in(family):
    """The same of a family of a record."""
    return {**family["truth"], **{name: family["verdict"][name] or 0 for name in ("false_separation", "false_contact")}}


def verdicts(truths):
    return [verdict for verdict, _ in truths]


def named(shown):
    """The one truth, as texts name it: "touching", or the verdict of what may touch."""
    return lambda truths: "touching" if shown == "touching" and truths[0][1] else truths[0][0]


def pixels(said):
    """The classes of a map's pixels, those apart that differ in the truth or the kernel's answer alone."""
    def classed(truths):
        return ["no_query" if right == "invalid" else "false_separation" if answer == "separated" != right else
                "missed_separation" if answer == "contact" != right else "tie" if touching else "yes" if right == "separated" else "no"
                for answer, (right, touching) in zip(said, truths, strict=True)]
    return classed


def turned_round(truths):
    """One truth is the other verdict, and nothing else changes."""
    at = next(i for i, (verdict, _) in enumerate(truths) if verdict != "invalid")
    other = {"contact": "separated", "separated": "contact"}[truths[at][0]]
    return [*truths[:at], (other, False), *truths[at + 1:]]


def number(shown):
    return float.fromhex(shown) if isinstance(shown, str) else float(shown)


def moved(x, ulps, precision):
    """The number so many floats above x; 0 and -0 are one."""
    real, bits, size = ("f", "I", 32) if precision == "binary32" else ("d", "Q", 64)
    (code,) = struct.unpack(bits, struct.pack(real, x))
    at = (code if code < 1 << size - 1 else (1 << size - 1) - code) + ulps
    return struct.unpack(real, struct.pack(bits, at if at >= 0 else (1 << size - 1) - at))[0]


class Query:
    """A line of a query file, with its numbers in the order of the columns."""

    def __init__(self, description, line):
        self.description, self.line, self.precision = description, line, line["precision"]
        self.entry = next(e for e in description["entries"] if e["name"] == line.get("entry", description["entries"][0]["name"]))
        self.groups = [(name, len(list(group))) for name, group in groupby(c["group"] for c in self.entry["columns"])]
        self.numbers = []
        for name, size in self.groups:
            shown = self.parent(name)[0][self.parent(name)[1]]
            self.numbers += map(number, shown if size > 1 or isinstance(shown, list) else [shown])

    def parent(self, group):
        """What holds a group, and its key there: "a.b.0" is line["a"]["b"][0]."""
        *path, last = [int(part) if part.isdigit() else part for part in group.split(".")]
        inside = self.line
        for part in path:
            inside = inside[part]
        return inside, last

    def truth(self):
        return truth(self.description["id"], self.entry["name"], self.numbers)

    def column(self, name):
        """That of "a.m.x", the first number of the group a.m, or of "r"."""
        first = 0
        for group, size in self.groups:
            for k in range(size):
                if name == (group if size == 1 else f"{group}.{'xyz'[k % 3]}"):
                    return first + k
            first += size
        raise KeyError(name)

    def changed(self, changes):
        """The query with other numbers at these columns."""
        other = Query(self.description, json.loads(json.dumps(self.line)))
        for column, value in changes.items():
            other.numbers[column] = value
        first = 0
        for group, size in self.groups:
            inside, last = other.parent(group)
            values = [x.hex() for x in other.numbers[first:first + size]]
            inside[last] = values if isinstance(inside[last], list) else values[0]
            first += size
        return other
