"""Recomputes the sides of a run's witnesses from the article's formulae in Python's rationals.

    sides_test.py AXISCERT
"""
import decimal
import json
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

AXISCERT = sys.argv.pop(1)
SEED = 11
NAMES = """plane.radius vertex_a.radius vertex_a.side_b vertex_a.side_c vertex_b.radius vertex_b.side_a vertex_b.side_c
vertex_c.radius vertex_c.side_a vertex_c.side_b edge_ab.radius edge_ab.side_c edge_bc.radius edge_bc.side_a
edge_ca.radius edge_ca.side_b""".split()


def number(text):
    return Fraction(*float.fromhex(text).as_integer_ratio())


def sub(u, v): return [x - y for x, y in zip(u, v)]
def mul(u, k): return [x * k for x in u]
def dot(u, v): return sum(x * y for x, y in zip(u, v))
def cross(u, v): return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def published(witness):
    """The two sides (lhs, rhs) of each comparison, by the article's last block of pseudocode."""
    a, b, c, p = ([number(x) for x in witness[point]] for point in "abcp")
    rr = number(witness["r"]) ** 2
    a, b, c = sub(a, p), sub(b, p), sub(c, p)
    v = cross(sub(b, a), sub(c, a))
    d, e = dot(a, v), dot(v, v)
    sides = [(d * d, rr * e)]
    for x, y, z in ((a, b, c), (b, a, c), (c, a, b)):
        sides += [(dot(x, x), rr), (dot(x, y), dot(x, x)), (dot(x, z), dot(x, x))]
    for x, y, z in ((a, b, c), (b, c, a), (c, a, b)):
        w = sub(y, x)
        d1, e1 = dot(x, y) - dot(x, x), dot(w, w)
        q = sub(mul(x, e1), mul(w, d1))
        sides += [(dot(q, q), rr * e1 * e1), (dot(q, sub(mul(z, e1), q)), Fraction(0))]
    return dict(zip(NAMES, sides))


def digits17(x):
    """x, a dyadic rational, rounded to nearest with 17 significant digits; its decimal expansion ends, so it is rounded once."""
    shift = x.denominator.bit_length() - 1
    with decimal.localcontext() as wide:
        wide.prec, wide.Emax, wide.Emin = 40000, decimal.MAX_EMAX, decimal.MIN_EMIN
        value = decimal.Decimal(x.numerator * 5 ** shift).scaleb(-shift)
    with decimal.localcontext() as context:
        context.prec = 17
        return +value


def ulp(x, precision):
    digits, least = (24, -149) if precision == "binary32" else (53, -1074)
    if x == 0:
        return Fraction(2) ** least
    x = abs(x)
    exponent = x.numerator.bit_length() - x.denominator.bit_length()
    exponent -= x < Fraction(2) ** exponent
    return Fraction(2) ** max(exponent - digits + 1, least)


def is_rounded_up(stored, exact):
    """Whether `stored` is the least number of six significant digits that is not below `exact`."""
    stored = decimal.Decimal(str(stored))
    if exact == 0:
        return stored == 0
    if stored == decimal.Decimal("1e-300"):
        return exact <= Fraction(stored)
    return 0 <= Fraction(stored) - exact < Fraction(10) ** (stored.adjusted() - 5)


class Sides(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([AXISCERT, "run", "--kernel", "published", "--kernel", "published+fma", "--trials", "500", "--seed",
                            str(SEED), "--out", folder] +
                           [word for family in "tangent sliver repeated tie lattice scale bits nonfinite".split()
                            for word in ("--family", family)], check=True, stdout=subprocess.DEVNULL)
            with open(folder + "/record.json") as file:
                cls.witnesses = json.load(file)["witnesses"]

    def test_exact_sides_and_errors(self):
        print(f"seed {SEED}, {len(self.witnesses)} witnesses")
        seen = 0
        for witness in self.witnesses:
            if witness["sides"] is None:
                self.assertEqual(witness["truth"], "invalid")
                continue
            sides, u = published(witness), Fraction(2) ** (-24 if witness["precision"] == "binary32" else -53)
            for name, side in witness["sides"].items():
                seen += 1
                where = f"{witness['id']} {witness['address']} {name}"
                lhs, rhs = sides[name]
                for member, exact in (("lhs", lhs), ("rhs", rhs), ("margin", lhs - rhs)):
                    self.assertEqual(decimal.Decimal(side["exact"][member]), digits17(exact), where)
                computed = side["computed"]
                if any(text in ("nan", "inf", "-inf") for text in computed.values()):
                    self.assertIsNone(side["error_u"], where)
                    continue
                left, right = number(computed["lhs"]), number(computed["rhs"])
                for stored, value, exact in ((side["lhs_ulps"], left, lhs), (side["rhs_ulps"], right, rhs)):
                    self.assertTrue(is_rounded_up(stored, abs(value - exact) / ulp(exact, witness["precision"])), where)
                off, scale = abs(left - right - (lhs - rhs)), u * (abs(lhs) + abs(rhs))
                if scale == 0 and off != 0:
                    self.assertIsNone(side["error_u"], where)
                else:
                    self.assertTrue(is_rounded_up(side["error_u"], off / scale if off else Fraction(0)), where)
        self.assertGreater(seen, 1000)

    def test_flips_and_largest_errors_have_their_sides(self):
        for witness in self.witnesses:
            if witness["sides"] is None:
                continue
            for flip in witness["flips"]:
                if flip["level"] == "comparison":
                    self.assertIn(flip["name"], witness["sides"])
            for reason in witness["shows"]:
                if reason.startswith("largest error of "):
                    name, amount = reason.removeprefix("largest error of ").split(": ")
                    self.assertEqual(f"{witness['sides'][name]['error_u']} u".replace(".0 u", " u"), amount.replace(".0 u", " u"))
            if witness["flips"] and all(flip["level"] == "verdict" for flip in witness["flips"]):
                self.assertGreaterEqual(len(witness["sides"]), 1)


if __name__ == "__main__":
    unittest.main()
