#!/usr/bin/env python3
"""The evaluations that `axiscert check` prints of KERNEL+PART-misses and -invents, replayed by fractions: each expression is the formula over the
reals; rounded as it says it has the value that is printed beside it, and every rounding is permitted; the comparisons make the verdict. Nothing
here shares code with axiscert.

evaluation_test.py AXISCERT [unittest arguments]
evaluation_test.py AXISCERT --replay KERNEL FILE...   the queries of files, as `axiscert search` and `axiscert run` keep them
"""
import json
import re
import struct
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction
from pathlib import Path

import formulae

AXISCERT = Path(sys.argv.pop(1)).resolve()
LINE = re.compile(r"^  (\S+) (holds|does not hold): (.*) = (\S+) (>=|>) (.*) = (\S+)$", re.M)
TOKEN = re.compile(r"up\(|down\(|flushed\(|kept\(|near\(|fma\(|min\(|max\(|[()|,/]|[a-z][a-z0-9.]*|-?\d[\d.e+-]*\d|\d|[+-]")
NORMAL, GREATEST = 2.0**-126, 2.0**128 - 2.0**104


def single(x):
    return struct.unpack("<f", struct.pack("<f", x))[0]


def beside(x, step):
    bits = struct.unpack("<i", struct.pack("<f", x))[0]
    if x == 0:
        return step * 2.0**-149
    bits += step if x > 0 else -step
    return struct.unpack("<f", struct.pack("<i", bits))[0]


class Indeterminate(Exception):
    """Beyond the greatest float, and where the specification bounds no quotient, a value may be any."""


def nearest(x):
    """The floats around an exact value: below or at it, nearest to it, above or at it."""
    if abs(x) > GREATEST:
        raise Indeterminate
    near = single(float(x))
    # Rounded twice, it may be beside the nearest; of a tie the even one was taken.
    near = min((near, beside(near, -1), beside(near, 1)), key=lambda candidate: abs(Fraction(candidate) - x))
    exact = Fraction(near)
    return (near if exact <= x else beside(near, -1)), near, (near if exact >= x else beside(near, 1))


def ulp(x):
    below, near, above = nearest(x)
    if below != above:
        return Fraction(above) - Fraction(below)
    return min(Fraction(near) - Fraction(beside(near, -1)), Fraction(beside(near, 1)) - Fraction(near))


class Reader:
    """An expression's exact value, and its value rounded as it says. `kept` has the values of what is behind barriers, by what it is exactly."""

    def __init__(self, text, inputs, permits, kept):
        self.tokens, self.inputs, self.permits, self.kept = TOKEN.findall(text), inputs, permits, kept

    def value(self):
        found = self.operand()
        assert not self.tokens, self.tokens
        return found

    def take(self, *wanted):
        token = self.tokens.pop(0)
        assert token in wanted, (token, wanted)
        return token

    def operand(self):
        token = self.tokens.pop(0)
        if token == "-":
            exact, rounded = self.operand()
            return -exact, -rounded
        if token == "|":
            exact, rounded = self.operand()
            self.take("|")
            return abs(exact), abs(rounded)
        if token in ("min(", "max("):
            (x, xr), _, (y, yr), _ = self.operand(), self.take(","), self.operand(), self.take(")")
            chosen = {"min(": min, "max(": max}[token]
            return chosen(x, y), chosen(xr, yr)
        if token == "kept(":
            exact, rounded = self.operand()
            self.take(")")
            before = self.kept.setdefault(exact, rounded)
            assert before == rounded, f"behind one barrier two values, {before} and {rounded}"
            return exact, rounded
        if token == "fma(":
            (x, xr), _, (y, yr), _, (z, zr) = self.operand(), self.take(","), self.operand(), self.take(","), self.operand()
            self.take(")")
            assert self.permits & {"fused", "wgsl", "wgsl-kept"}
            return x * y + z, nearest(Fraction(xr) * Fraction(yr) + Fraction(zr))[1]
        if token in ("(", "up(", "down(", "flushed(", "near("):
            return self.operation(token)
        if token in self.inputs:
            return Fraction(self.inputs[token]), self.inputs[token]
        return Fraction(token), float(token)

    def operation(self, mark):
        exact, rounded = self.operand()
        if mark == "flushed(" and self.tokens[0] == ")":  # of an operand
            self.take(")")
            assert self.permits & {"flushed", "wgsl", "wgsl-kept"} and abs(rounded) < NORMAL
            return exact, 0.0
        sign = -1 if self.tokens[0] == "-" else 1
        kind = self.tokens.pop(0) if self.tokens[0] in "+-/" else "*"
        other, other_rounded = self.operand()
        a, b = Fraction(rounded), Fraction(other_rounded)
        if kind == "*":
            exact, unrounded = exact * other, a * b
        elif kind == "/" and (b == 0 or other == 0):
            raise Indeterminate
        elif kind == "/":
            exact, unrounded = exact / other, a / b
        else:
            exact, unrounded = exact + sign * other, a + sign * b
        below, near, above = nearest(unrounded)
        if mark == "near(":
            self.take(",")
            rounded = single(float(self.tokens.pop(0)))
            assert kind == "/" and self.permits & {"divided", "wgsl", "wgsl-kept"}
            if not NORMAL <= abs(b) <= 2**126:
                raise Indeterminate
            assert abs(Fraction(rounded) - unrounded) <= Fraction(5, 2) * ulp(unrounded), "more than 2.5 ulp"
        elif mark == "flushed(":
            assert self.permits & {"flushed", "wgsl", "wgsl-kept"} and abs(unrounded) < NORMAL
            rounded = 0.0
        else:
            assert mark == "(" or self.permits & {"faithful", "wgsl", "wgsl-kept"}
            rounded = {"(": near, "up(": above, "down(": below}[mark]
            if abs(rounded) == float("inf"):
                raise Indeterminate
        self.take(")")
        return exact, rounded


class NotReplayed(AssertionError):
    pass


def replayed(kernel, queries):
    """How many evaluations, of how many queries, `check` prints of the kernel, after each was replayed."""
    rung, _, permission = kernel.partition("+")
    part, _, wish = permission.rpartition("-")
    stored = [json.loads(line) for line in Path(queries).read_text().splitlines()]
    done = subprocess.run([AXISCERT, "check", queries, "--kernel", kernel], capture_output=True, text=True)
    assert done.returncode in (0, 1), done.stderr
    blocks = re.split(r"^(?=\S+: exact )", done.stdout, flags=re.M)[1:]
    assert len(blocks) == len(stored), f"{len(blocks)} answers to {len(stored)} queries"
    count = shown = 0
    for block in blocks:
        address = block.split(": exact ")[0]
        [query] = [q for q in stored if q["id"] == address]
        lines, kept, decisions = LINE.findall(block), {}, []
        columns = formulae.columns(query)
        for name, says, lhs, lhs_value, sign, rhs, rhs_value in lines:
            values = []
            for text, printed in ((lhs, lhs_value), (rhs, rhs_value)):
                try:
                    exact, rounded = Reader(text, columns, {part}, kept).value()
                except Indeterminate:
                    values.append((None, float(printed)))
                    continue
                except AssertionError as error:
                    raise NotReplayed(f"{kernel} {address} {name}: {text}: {error}") from None
                if f"{rounded + 0:.9g}" != f"{float(printed) + 0:.9g}":  # the sign of 0 is open
                    raise NotReplayed(f"{kernel} {address} {name}: {text} is {rounded:.9g}, not {printed}")
                values.append((exact, rounded))
                count += 1
            (lhs_exact, l), (rhs_exact, r) = values
            if (l >= r if sign == ">=" else l > r) != (says == "holds"):
                raise NotReplayed(f"{kernel} {address} {name}: {says}, of {l} and {r}")
            decisions.append((name, says == "holds", lhs_exact, rhs_exact, sign))
        if not lines:
            continue
        shown += 1
        verdict = formulae.verdict(rung, columns, decisions)
        if verdict != {"misses": "separated", "invents": "contact"}[wish]:
            raise NotReplayed(f"{kernel} {address}: the comparisons make it {verdict}")
    return count, shown


FORMS = {"reduced-nonstrict": ("tangent", "far"), "published": ("tangent", "far"), "closest-point": ("tangent", "far"),
         "moving-sphere/twenty-nonstrict": ("moving-sphere/graze", "moving-sphere/approach"), "box-box/cofactor": ("box-box/tangent", "box-box/far"),
         "box-box/projected": ("box-box/tangent",), "moving-sphere/ends-twenty-nonstrict": ("moving-sphere/ends_graze",),
         "capsule-triangle/twenty-nonstrict": ("capsule-triangle/graze",), "box-triangle/textbook": ("box-triangle/touching",),
         "box-triangle/textbook-minmax": ("box-triangle/touching_minmax",), "box-triangle/textbook-oriented": ("box-triangle/touching_oriented",),
         "box-triangle/thirteen-oriented": ("box-triangle/touching_oriented",)}


class Evaluations(unittest.TestCase):
    def test_each_is_the_formula_and_has_its_value(self):
        with tempfile.TemporaryDirectory() as folder:
            for form, families in FORMS.items():
                queries = Path(folder) / "queries.jsonl"
                subprocess.run([AXISCERT, "generate", *[w for f in families for w in ("--family", f)], "--trials", "4", "-o", queries], check=True)
                for part in ("faithful", "reassociated", "fused", "factored", "divided", "wgsl", "wgsl-kept"):
                    with self.subTest(f"{form}+{part}"):
                        found = [replayed(f"{form}+{part}-{wish}", queries) for wish in ("misses", "invents")]
                        # Some evaluation of each query gives one of the two verdicts.
                        self.assertGreaterEqual(sum(shown for _, shown in found), 4 * len(families))

    def test_finds_of_a_search_are_replayed(self):
        with tempfile.TemporaryDirectory() as folder:
            kernel = "reduced-nonstrict+wgsl-misses"
            subprocess.run([AXISCERT, "search", "--kernel", kernel, "--precision", "binary32", "--evaluations", "2048", "--family", "tangent",
                            "--progress", "0", "--out", "found"], cwd=folder, capture_output=True, check=False)
            count, shown = replayed(kernel, Path(folder) / "found" / "witnesses.jsonl")
            self.assertGreater(shown, 0)
            self.assertGreaterEqual(count, 2)

    def test_what_is_not_permitted_is_told(self):
        q = {"x": 1.0, "y": 2.0**-30, "z": 3.0}
        for text, permits, why in (("up(x + y)", {"fused"}, ""), ("near(x / z, 0.333333433)", {"faithful"}, ""), ("near(x / z, 0.3333335)", {"wgsl"}, "2.5 ulp"),
                                   ("flushed(x + y)", {"wgsl"}, ""), ("fma(x, y, z)", {"faithful"}, "")):
            with self.subTest(text), self.assertRaisesRegex(AssertionError, why):
                Reader(text, q, permits, {}).value()
        self.assertEqual(Reader("up(x + y)", q, {"wgsl"}, {}).value(), (1 + Fraction(2)**-30, 1 + 2.0**-23))
        with self.assertRaisesRegex(AssertionError, "two values"):
            Reader("(kept(up(x + y)) - kept((x + y)))", q, {"wgsl-kept"}, {}).value()


if __name__ == "__main__":
    if sys.argv[1:2] == ["--replay"]:
        for file in sys.argv[3:]:
            count, shown = replayed(sys.argv[2], file)
            print(f"{file}: {count:,} expressions of {shown:,} queries replayed, each as printed")
    else:
        unittest.main()
