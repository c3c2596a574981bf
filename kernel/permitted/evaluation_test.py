#!/usr/bin/env python3
"""The evaluations that `axiscert check` prints of KERNEL+PART-misses and -invents, by fractions: each is the formula over the reals, and rounded
as it says it has the value that is printed beside it. Nothing here shares code with axiscert.

evaluation_test.py AXISCERT [unittest arguments]
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

AXISCERT = Path(sys.argv.pop(1)).resolve()
LINE = re.compile(r"^  (\S+) (?:holds|does not hold): (.*) = (\S+) (>=|>) (.*) = (\S+)$", re.M)
TOKEN = re.compile(r"up\(|down\(|kept\(|\(|\)|[a-z]+|-?\d[\d.e-]*|[+-]")


def nearest(x):
    """The floats around an exact value: below or at it, nearest to it, above or at it."""
    near = struct.unpack("f", struct.pack("f", float(x)))[0]
    # Rounded twice, it may be beside the nearest; of a tie the even one was taken.
    near = min((near, beside(near, -1), beside(near, 1)), key=lambda candidate: abs(Fraction(candidate) - x))
    exact = Fraction(near)
    return (near if exact <= x else beside(near, -1)), near, (near if exact >= x else beside(near, 1))


def beside(x, step):
    bits = struct.unpack("<i", struct.pack("<f", x))[0]
    if x == 0:
        return step * 2.0**-149
    bits += step if x > 0 else -step
    return struct.unpack("<f", struct.pack("<i", bits))[0]


class Reader:
    """An expression's exact value, and its value rounded as it says."""

    def __init__(self, text, inputs):
        self.tokens, self.inputs = TOKEN.findall(text), inputs

    def value(self):
        found = self.operand()
        assert not self.tokens, self.tokens
        return found

    def operand(self):
        token = self.tokens.pop(0)
        if token == "-":
            exact, rounded = self.operand()
            return -exact, -rounded
        if token in ("(", "up(", "down(", "kept("):
            exact, rounded = self.operand()
            if self.tokens[0] != ")":
                minus = self.tokens[0] == "-"
                is_sum = self.tokens[0] in "+-"
                if is_sum:
                    self.tokens.pop(0)
                other, other_rounded = self.operand()
                sign = -1 if minus else 1
                exact = exact + sign * other if is_sum else exact * other
                unrounded = Fraction(rounded) + sign * Fraction(other_rounded) if is_sum else Fraction(rounded) * Fraction(other_rounded)
                below, near, above = nearest(unrounded)
                rounded = {"(": near, "up(": above, "down(": below}[token]
            assert self.tokens.pop(0) == ")"
            return exact, rounded
        if token in self.inputs:
            return Fraction(self.inputs[token]), self.inputs[token]
        return Fraction(token), float(token)


def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def sides(comparison, q):
    """Both sides of a comparison of the reduced form, over the reals."""
    vertices = {name: [Fraction(q[name + k]) - Fraction(q["p" + k]) for k in "xyz"] for name in "abc"}
    rr = Fraction(q["r"]) ** 2
    between = lambda u, v: [y - x for x, y in zip(vertices[u], vertices[v])]  # noqa: E731
    normal = cross(between("a", "b"), between("a", "c"))
    axis, kind = comparison.split(".")
    if axis == "plane":
        return dot(vertices["a"], normal) ** 2, rr * dot(normal, normal)
    if axis.startswith("vertex"):
        at = vertices[axis[-1]]
        return (dot(at, at), rr) if kind == "radius" else (dot(at, vertices[kind[-1]]), dot(at, at))
    one, other = axis[-2:]
    of_edge = cross(vertices[one], vertices[other])
    along = between(one, other)
    return (dot(of_edge, of_edge), rr * dot(along, along)) if kind == "radius" else (Fraction(0), dot(of_edge, normal))


class Evaluations(unittest.TestCase):
    def test_each_is_the_formula_and_has_its_value(self):
        read = {}
        for part in ("faithful", "reassociated", "factored", "wgsl"):
            for wish in ("misses", "invents"):
                with tempfile.TemporaryDirectory() as folder:
                    queries = Path(folder) / "queries.jsonl"
                    subprocess.run([AXISCERT, "generate", "--family", "tangent", "--family", "far", "--trials", "30", "-o", queries], check=True)
                    stored = [json.loads(line) for line in queries.read_text().splitlines()]
                    done = subprocess.run([AXISCERT, "check", queries, "--kernel", f"reduced-nonstrict+{part}-{wish}"], capture_output=True, text=True,
                                          check=True)
                self.assertEqual(len(stored), 60)
                inputs = {q["id"]: {**{v + k: float.fromhex(x) if isinstance(x, str) else x for v in "abcp" for k, x in zip("xyz", q[v])},
                                    "r": float.fromhex(q["r"]) if isinstance(q["r"], str) else q["r"]} for q in stored}
                blocks = re.split(r"^(?=\S+: exact )", done.stdout, flags=re.M)[1:]
                self.assertEqual(len(blocks), 60)
                for block in blocks:
                    q = inputs[block.split(": exact ")[0]]
                    for comparison, lhs, lhs_value, _, rhs, rhs_value in LINE.findall(block):
                        for text, printed, real in ((lhs, lhs_value, sides(comparison, q)[0]), (rhs, rhs_value, sides(comparison, q)[1])):
                            exact, rounded = Reader(text, q).value()
                            self.assertEqual(exact, real, f"{part} {comparison}: {text}")
                            self.assertEqual(f"{rounded:.9g}", f"{float(printed):.9g}", f"{part} {comparison}: {text}")
                            read[part] = read.get(part, 0) + 1
        for part, count in read.items():
            self.assertGreater(count, 200, part)
        self.assertEqual(len(read), 4)


if __name__ == "__main__":
    unittest.main()
