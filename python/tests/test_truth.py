"""The exact answers, against fractions that know nothing of axiscert, and against `axiscert check`."""
import json
import math
from fractions import Fraction

import numpy as np
import pytest

import axiscert as ax


def squared_distance(q, i):
    """Of a point from a triangle: the least of its vertices, edges and face, in fractions."""
    a, b, c, p = ([Fraction(float(x)) for x in getattr(q, name)[i]] for name in "abcp")
    sub = lambda u, v: [x - y for x, y in zip(u, v)]
    dot = lambda u, v: sum(x * y for x, y in zip(u, v))
    found = [dot(sub(p, v), sub(p, v)) for v in (a, b, c)]
    for u, v in ((a, b), (b, c), (c, a)):
        edge, w = sub(v, u), sub(p, u)
        if dot(edge, edge) and 0 <= dot(w, edge) <= dot(edge, edge):
            found.append(dot(w, w) - dot(w, edge) ** 2 / dot(edge, edge))
    e1, e2, w = sub(b, a), sub(c, a), sub(p, a)
    m11, m12, m22, r1, r2 = dot(e1, e1), dot(e1, e2), dot(e2, e2), dot(w, e1), dot(w, e2)
    area = m11 * m22 - m12 * m12
    if area:
        s, t = (r1 * m22 - r2 * m12) / area, (r2 * m11 - r1 * m12) / area
        if s >= 0 and t >= 0 and s + t <= 1:
            inside = [x + s * y + t * z for x, y, z in zip(a, e1, e2)]
            found.append(dot(sub(p, inside), sub(p, inside)))
    return min(found)


@pytest.mark.parametrize("family", ["general", "tangent", "sliver", "repeated", "subnormal", "tie"])
@pytest.mark.parametrize("precision", ["binary32", "binary64"])
def test_distances_and_verdicts_are_those_of_fractions(family, precision):
    q = ax.generate(family, 60, seed=5, precision=precision)
    t = ax.truth(q)
    critical = t.critical_value
    for i in range(len(q)):
        squared, r = squared_distance(q, i), Fraction(float(q.r[i]))
        assert t.squared_distance_exact[i] == squared
        assert t.contact[i] == (squared <= r * r) and t.touching[i] == (squared == r * r)
        assert t.squared_critical_value_exact[i] in (squared, None) and (squared == 0 or t.squared_critical_value_exact[i] == squared)
        place = t.facts[i]["nearest_point"].numbers
        if place:
            point = [x.fraction for x in place]
            centre = [Fraction(float(x)) for x in q.p[i]]
            assert sum((x - y) ** 2 for x, y in zip(point, centre)) == squared
        if squared:
            assert critical[i] == ax.nearest_sqrt(squared)


def test_a_root_is_rounded_once():
    random = np.random.default_rng(7)
    for _ in range(500):
        x = Fraction(int(random.integers(1, 2**62)), int(random.integers(1, 2**62))) * Fraction(2) ** int(random.integers(-900, 900))
        root = ax.nearest_sqrt(x)
        below, above = Fraction(math.nextafter(root, 0)), Fraction(math.nextafter(root, math.inf))
        assert ((below + Fraction(root)) / 2) ** 2 <= x <= ((above + Fraction(root)) / 2) ** 2
    assert ax.nearest_sqrt(Fraction(2) ** -2148) == 2.0**-1074 and ax.nearest_sqrt(Fraction(2) ** 4000) == math.inf


@pytest.mark.parametrize("family", sorted({one["predicate"]: one["name"] for one in ax.families()}.values()))
def test_the_answers_are_those_of_check(family, command, tmp_path):
    """Of a family of every predicate."""
    q = ax.generate(family, 12, seed=2)
    q.save(tmp_path / "q.jsonl")
    t = ax.truth(q)
    for i, line in enumerate(command("check", tmp_path / "q.jsonl", "--format", "jsonl", "--exact").splitlines()):
        exact = json.loads(line)["exact"]
        assert exact["verdict"] == ax.VERDICTS[t.verdict[i]]
        if exact["verdict"] == "invalid":
            assert t.facts[i] is None
            continue
        assert exact["touching"] == bool(t.touching[i])
        if exact.get("squared_distance") is not None:
            assert Fraction(exact["squared_distance"]) == t.squared_distance_exact[i]


def test_signs_are_those_of_exact_formulae(command, tmp_path):
    q = ax.generate("tie", 40)
    holds, ties = ax.truth(q).signs("published")
    q.save(tmp_path / "q.jsonl")
    lines = command("check", tmp_path / "q.jsonl", "--format", "jsonl", "--kernel", "published").splitlines()
    for i, line in enumerate(lines):
        exact = json.loads(line)["exact"]
        if exact.get("comparisons"):
            assert exact["comparisons"] == "".join("1" if bit else "0" for bit in holds[i])
        if exact.get("ties"):
            assert exact["ties"] == "".join("1" if bit else "0" for bit in ties[i])
    with pytest.raises(ax.Error, match="it claims no formulae with comparisons"):
        ax.truth(q).signs("closest-point")


def test_what_is_no_query_has_no_answers():
    numbers = ax.generate("general", 6).numbers.copy()
    numbers[0, 0], numbers[12, 1], numbers[3, 2] = np.nan, -1, np.inf
    t = ax.truth(ax.Queries("sphere-triangle", numbers))
    assert list(t.valid) == [False, False, False, True, True, True]
    assert not t.contact[:3].any() and not t.separated[:3].any()
    assert np.isnan(t.depth[:3]).all() and t.facts[:3] == [None] * 3 and np.isnan(t.fact("nearest_point")[:3]).all()
    assert np.isnan(t.squared_distance[:3]).all() and t.squared_distance_exact[0] is None


def test_a_fact_that_is_not_told_names_those_that_are():
    with pytest.raises(ax.Error, match="there are: .*nearest_point"):
        ax.truth(ax.generate("general", 3)).fact("colour")


def test_threads_change_nothing():
    q = ax.generate("tangent", 5000)
    one, three = ax.truth(q, threads=1), ax.truth(q, threads=3)
    assert np.array_equal(one.verdict, three.verdict) and np.array_equal(one.depth, three.depth)


def test_truth_takes_queries():
    with pytest.raises(ax.Error, match="Queries.of makes them"):
        ax.truth(np.zeros((13, 2)))
