#!/usr/bin/env python3
"""attained_test.py WRITTEN: each figure of proofs/bounds.h is attained by a query of proofs/attained.jsonl.

A query's error is |(l^ - r^) - (l - r)| in u = 2^-24: the recorded program of its comparison (fpcore/ in the folder WRITTEN), each operation
rounded to binary32, compared with the exact value, in fractions. The query is in the scaled domain: every exact coordinate of
A - P, B - P, C - P in [-1, 1], r in [0, 1]. A figure is the error rounded down to its digits, so that it is attained; a query
that attains more than its figure is as wrong as one that attains less."""
import functools
import json
import pathlib
import re
import sys
import unittest
from fractions import Fraction

PROOFS = pathlib.Path(__file__).resolve().parents[1]
WRITTEN = pathlib.Path(sys.argv.pop(1))
sys.path.insert(0, str(PROOFS))
import fpcore
from names import INPUTS


def attained():
    """The figures of bounds.h, as text, by kernel and kind of comparison."""
    found = re.findall(r'\{"(\w+)", Kind::(\w+), ([\d.]+), "', (PROOFS / "bounds.h").read_text())
    return {(kernel, kind): figure for kernel, kind, figure in found}


def witnesses():
    """The queries by kernel and comparison: thirteen fractions each."""
    found = {}
    for line in (PROOFS / "attained.jsonl").read_text().splitlines():
        query = json.loads(line)
        numbers = (*query["a"], *query["b"], *query["c"], *query["p"], query["r"])
        found[tuple(query["id"].split())] = tuple(Fraction(float.fromhex(x)) for x in numbers)
    return found


def kind_of(comparison):
    axis, what = comparison.split(".")
    return f"{axis.split('_')[0]}_{what.split('_')[0]}"


@functools.lru_cache(maxsize=None)
def error_in_u(kernel, comparison, query):
    """The exact error of lhs - rhs in u. A side that is the constant zero is not among the FPCores."""
    values = dict(zip(INPUTS, query))
    name = f"{kernel}_{comparison.replace('.', '_')}"
    cores = [core for core in fpcore.cores((WRITTEN / f"fpcore/binary32/{kernel}_plain.fpcore").read_text())
             if core.name in (f"{name}_lhs", f"{name}_rhs")]
    assert cores, name
    computed = exact = Fraction(0)
    for core in cores:
        sign = 1 if core.name.endswith("lhs") else -1
        computed += sign * fpcore.evaluate(core.body, values, fpcore.Arithmetic("binary32"))
        exact += sign * fpcore.evaluate(core.body, values, lambda x: x)
    return abs(computed - exact) * 2 ** 24


def outside(query):
    """The numbers that are not in the scaled domain."""
    differences = {f"{INPUTS[i]} - {INPUTS[9 + i % 3]}": query[i] - query[9 + i % 3] for i in range(9)}
    found = [f"{name} = {float(x)}: not in [-1, 1]" for name, x in differences.items() if abs(x) > 1]
    return found + ([] if 0 <= query[12] <= 1 else [f"r = {float(query[12])}: not in [0, 1]"])


def rounded_down(error, figure):
    """The error with as many digits after the point as the figure, cut off."""
    digits = len(figure.partition(".")[2])
    units = error.numerator * 10 ** digits // error.denominator
    return Fraction(units, 10 ** digits)


def wrong(figures, queries):
    """Says which figure is not attained, or not the greatest with its digits."""
    found = []
    for (kernel, comparison), query in queries.items():
        figure = figures[kernel, kind_of(comparison)]
        error = error_in_u(kernel, comparison, query)
        found += [f"{kernel} {comparison}: {says}" for says in outside(query)]
        if rounded_down(error, figure) != Fraction(figure):
            found.append(f"{kernel} {comparison}: bounds.h has {figure} u, the query of attained.jsonl attains {float(error):.6f} u")
    return found


class Attained(unittest.TestCase):
    def test_each_figure_has_its_query(self):
        self.assertEqual({(kernel, kind_of(comparison)) for kernel, comparison in witnesses()}, set(attained()))

    def test_each_figure_is_attained(self):
        self.assertEqual(wrong(attained(), witnesses()), [])

    def test_a_figure_too_great_and_one_too_small_are_seen(self):
        figures, queries = attained(), witnesses()
        for key, figure in figures.items():
            last = Fraction(1, 10 ** len(figure.partition(".")[2]))
            for changed in (Fraction(figure) + last, Fraction(figure) - last):
                text = f"{float(changed):.{len(figure.partition('.')[2])}f}"
                self.assertEqual(len(wrong(figures | {key: text}, queries)), 1, (key, text))

    def test_a_query_outside_the_domain_is_seen(self):
        figures, queries = attained(), witnesses()
        key = ("reduced", "edge_ab.side_c")
        moved = list(queries[key])
        moved[12] = Fraction(3, 2)
        self.assertIn("r = 1.5: not in [0, 1]", " ".join(wrong(figures, queries | {key: tuple(moved)})))
        moved = list(queries[key])
        moved[0] += 2
        self.assertIn("not in [-1, 1]", " ".join(wrong(figures, queries | {key: tuple(moved)})))

    def test_a_changed_query_is_seen(self):
        figures, queries = attained(), witnesses()
        key = ("reduced", "edge_ab.radius")
        moved = list(queries[key])
        moved[1], moved[4] = moved[4], moved[1]
        self.assertEqual(len([says for says in wrong(figures, queries | {key: tuple(moved)}) if "attains" in says]), 1)


if __name__ == "__main__":
    unittest.main()
