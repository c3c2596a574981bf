#!/usr/bin/env python3
"""The distances, places and parts that `check` prints for queries of every family, against fractions that share nothing with the program.
Numbers with a root are compared as such: no digit is rounded."""
import json
import unittest
from fractions import Fraction
from itertools import combinations
from math import isqrt

from command import Case, axiscert
from exact_predicates import box, cross, dot, from_segment, from_triangle, minus, plus, segment_from_triangle, times, turned, UPRIGHT

SEED = 9
PREDICATES = ("sphere-triangle", "moving-sphere", "capsule-triangle", "box-box", "box-triangle")
NO_NUMBER = "not one: the centre is on the triangle"


def root(x):
    """The root of a fraction, where it is one."""
    over, under = isqrt(x.numerator), isqrt(x.denominator)
    return Fraction(over, under) if over * over == x.numerator and under * under == x.denominator else None


class Root:
    """rest + way * sqrt(square): way 1 or -1, square 0 where the sum is a fraction."""
    def __init__(self, rest, way=1, square=0):
        square = Fraction(square)
        known = root(square)
        self.rest, self.way, self.square = (Fraction(rest), way, square) if known is None else (Fraction(rest) + way * known, 1, Fraction(0))

    def __eq__(self, other):
        return (self.rest, self.way, self.square) == (other.rest, other.way, other.square)

    def __repr__(self):
        return f"{self.rest} + {self.way} sqrt({self.square})"


def read(text):
    """The number that a fact has: "3/4", "-sqrt(2)", "1/2 - sqrt(1/3)", "sqrt(2) - 1"."""
    rest, way, square, sign = Fraction(0), 1, Fraction(0), 1
    for word in text.split():
        if word in "+-":
            sign = 1 if word == "+" else -1
            continue
        if word.startswith("-"):
            sign, word = -sign, word[1:]
        if word.startswith("sqrt("):
            way, square = sign, Fraction(word[5:-1])
        else:
            rest += sign * Fraction(word)
        sign = 1
    return Root(rest, way, square)


def point(fact):
    return tuple(map(Fraction, fact["exact"]))


def candidates(triangle, p, rims=False):
    """{part: squared distance} of the parts, without or with their rims, that p is over."""
    less = (lambda x, y: x <= y) if rims else (lambda x, y: x < y)
    found = {f"vertex_{name}": dot(minus(p, v), minus(p, v)) for name, v in zip("abc", triangle)}
    for name, (start, end) in zip(("ab", "bc", "ca"), ((0, 1), (1, 2), (2, 0))):
        along, to = minus(triangle[end], triangle[start]), minus(p, triangle[start])
        if any(along) and less(0, dot(to, along)) and less(dot(to, along), dot(along, along)):
            found[f"edge_{name}"] = dot(to, to) - Fraction(dot(to, along) ** 2, dot(along, along))
    normal = cross(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0]))
    if any(normal) and all(less(0, dot(cross(minus(triangle[(k + 1) % 3], triangle[k]), minus(p, triangle[k])), normal)) for k in range(3)):
        found["face"] = Fraction(dot(normal, minus(p, triangle[0])) ** 2, dot(normal, normal))
    return found


def is_in_box(p, m, s, axes):
    whole = dot(axes[0], cross(axes[1], axes[2]))
    at = minus(p, m)
    shares = [Fraction(dot(at, cross(axes[(k + 1) % 3], axes[(k + 2) % 3])), whole) for k in range(3)]
    return all(abs(share) <= half for share, half in zip(shares, s))


class FamilyFacts(Case):
    queries = 2

    def same_length(self, fact, expected):
        self.assertEqual(read(fact["exact"]), expected)

    def same_direction(self, fact, ways):
        """The unit vector of one of these."""
        given = [read(part) for part in fact["exact"]]
        self.assertTrue(all(part.rest == 0 or part.square == 0 for part in given))
        squares = [part.square or part.rest ** 2 for part in given]
        signs = [(part.way if part.square else (part.rest > 0) - (part.rest < 0)) for part in given]
        self.assertIn((squares, signs), [([Fraction(x * x, dot(way, way)) for x in way], [(x > 0) - (x < 0) for x in way]) for way in ways])

    def same_gap(self, facts, squared, r):
        """The distance, or the penetration, of what is at this squared distance from a centre with a radius."""
        is_apart = squared > r * r
        self.assertEqual(set(facts) & {"distance", "penetration"}, {"distance" if is_apart else "penetration"})
        if is_apart:
            self.same_length(facts["distance"], Root(-r, 1, squared))
        else:
            self.same_length(facts["penetration"], Root(r, -1, squared))

    def sphere_triangle(self, triangle, p, r, facts):
        by_part = candidates(triangle, p)
        squared = min(by_part.values())
        self.assertEqual(squared, from_triangle(p, triangle))
        self.same_gap(facts, squared, r)
        self.same_length(facts["centre_distance"], Root(0, 1, squared))
        self.assertEqual(set(facts["features"]["value"]), {part for part, square in by_part.items() if square == squared})
        at = point(facts["nearest_point"])
        self.assertEqual((from_triangle(at, triangle), dot(minus(p, at), minus(p, at))), (0, squared))
        if squared:
            self.same_direction(facts["normal"], [minus(p, at)])
        else:
            self.assertEqual((facts["normal"]["value"], facts["normal"]["note"]), (None, NO_NUMBER))

    def moving_sphere(self, triangle, p, q, r, facts):
        squared = segment_from_triangle(p, q, triangle)
        self.same_gap(facts, squared, r)
        self.same_length(facts["centre_distance"], Root(0, 1, squared))
        self.assertEqual("time" in facts, squared <= r * r)
        if squared > r * r:
            return
        time = read(facts["time"]["exact"])
        if time.square:
            return  # held in exact_facts_test.py
        at = time.rest
        centre = plus(p, times(at, minus(q, p)))
        by_part = candidates(triangle, centre, rims=True)
        least = min(by_part.values())
        self.assertEqual(set(facts["features"]["value"]), {part for part, square in by_part.items() if square == least})
        nearest = point(facts["nearest_point"])
        self.assertEqual((from_triangle(nearest, triangle), dot(minus(centre, nearest), minus(centre, nearest))), (0, least))
        if at > 0:
            self.assertEqual(least, r * r)
            before = at * (1 - Fraction(1, 2 ** 60))
            self.assertGreater(segment_from_triangle(p, plus(p, times(before, minus(q, p))), triangle), r * r)
        else:
            self.assertLessEqual(least, r * r)

    def capsule_triangle(self, triangle, p, q, r, facts):
        squared = segment_from_triangle(p, q, triangle)
        self.same_length(facts["segment_distance"], Root(0, 1, squared))
        if squared:
            self.same_gap(facts, squared, r)
            x, y = point(facts["nearest_point_segment"]), point(facts["nearest_point_triangle"])
            self.assertEqual((from_segment(x, p, q), from_triangle(y, triangle), dot(minus(y, x), minus(y, x))), (0, 0, squared))
            self.same_direction(facts["normal"], [minus(y, x)])
            return
        # Out of the prism that the two sweep together, and r farther.
        edges = [edge for edge in [minus(q, p)] + [minus(triangle[(k + 1) % 3], triangle[k]) for k in range(3)] if any(edge)]
        squares = {way: Fraction((max(dot(p, way), dot(q, way)) - min(dot(v, way) for v in triangle)) ** 2, dot(way, way))
                   for u, v in combinations(edges, 2) for axis in [cross(u, v)] if any(axis) for way in (axis, times(-1, axis))}
        least = min(squares.values(), default=Fraction(0))
        self.same_length(facts["penetration"], Root(r, 1, least))
        if least:
            self.same_direction(facts["normal"], [way for way, square in squares.items() if square == least])
        else:
            x = point(facts["nearest_point_segment"])
            self.assertEqual((x, from_segment(x, p, q), from_triangle(x, triangle)), (point(facts["nearest_point_triangle"]), 0, 0))

    def hulls(self, facts, names, first, second):
        """Two bodies, each its corners, its edges, and whether a point is in it."""
        (a, edges_a, in_a), (b, edges_b, in_b) = first, second
        if "distance" in facts:
            x, y = point(facts[names[0]]), point(facts[names[1]])
            way = minus(y, x)
            self.assertTrue(in_a(x) and in_b(y))
            self.assertTrue(all(dot(way, minus(v, x)) <= 0 for v in a) and all(dot(way, minus(v, y)) >= 0 for v in b))
            self.same_length(facts["distance"], Root(0, 1, dot(way, way)))
            self.same_direction(facts["normal"], [way])
            return
        edges = [edge for edge in edges_a + edges_b if any(edge)]
        axes = {way for u, v in combinations(edges, 2) for axis in [cross(u, v)] if any(axis) for way in (axis, times(-1, axis))}
        reach = {way: max(dot(v, way) for v in a) - min(dot(v, way) for v in b) for way in axes}
        self.assertTrue(all(left >= 0 for left in reach.values()))
        squares = {way: Fraction(left ** 2, dot(way, way)) for way, left in reach.items()}
        least = min(squares.values(), default=Fraction(0))
        self.same_length(facts["penetration"], Root(0, 1, least))
        if least > 0:
            best = [way for way, square in squares.items() if square == least]
            self.same_direction(facts["normal"], best)
            only = all(not any(cross(best[0], way)) and dot(best[0], way) > 0 for way in best)
            self.assertEqual(facts["normal"].get("note", ""), "" if only else "not the only one")
        else:
            x = point(facts[names[0]])
            self.assertEqual(x, point(facts[names[1]]))
            self.assertTrue(in_a(x) and in_b(x))

    def body(self, one):
        """Of a box as a file has it."""
        number = lambda text: Fraction(float.fromhex(text))  # noqa: E731
        vector = lambda texts: tuple(map(number, texts))  # noqa: E731
        if "min" in one:
            low, high = vector(one["min"]), vector(one["max"])
            m, s, axes = times(Fraction(1, 2), plus(low, high)), times(Fraction(1, 2), minus(high, low)), UPRIGHT
        else:
            m, s = vector(one["m"]), vector(one["s"])
            axes = [vector(axis) for axis in one["b"]] if "b" in one else turned(*vector(one["q"])) if "q" in one else UPRIGHT
        corners, edges = box(m, s, axes)
        return corners, edges, lambda p: is_in_box(p, m, s, axes)

    def look_at(self, predicate, query, facts):
        vector = lambda name: tuple(Fraction(float.fromhex(text)) for text in query[name])  # noqa: E731
        if predicate == "box-box":
            self.hulls(facts, ("nearest_point_a", "nearest_point_b"), self.body(query["a"]), self.body(query["b"]))
            return
        triangle = [vector(name) for name in "abc"]
        if predicate == "box-triangle":
            edges = [minus(triangle[(k + 1) % 3], triangle[k]) for k in range(3)]
            self.hulls(facts, ("nearest_point_box", "nearest_point_triangle"), self.body(query["box"]),
                       (triangle, edges, lambda p: from_triangle(p, triangle) == 0))
            return
        p, r = vector("p"), Fraction(float.fromhex(query["r"]))
        if predicate == "sphere-triangle":
            self.sphere_triangle(triangle, p, r, facts)
        elif predicate == "capsule-triangle":
            self.capsule_triangle(triangle, p, vector("q"), r, facts)
        else:
            end = plus(p, vector("d")) if "d" in query else vector("p1")
            self.moving_sphere(triangle, p, end, r, facts)

    def test_every_family(self):
        seen, contacts = 0, 0
        for predicate in PREDICATES:
            families = json.loads(axiscert("families", "--predicate", predicate, "--format", "json").stdout)["families"]
            for precision in ("binary32", "binary64"):
                made = axiscert("generate", *(f"--family={family['name']}" for family in families), "--seed", SEED, "--precision", precision,
                                "--trials", self.queries).stdout
                done = axiscert("check", "-", "--format", "jsonl", stdin=made)
                self.assertIn(done.returncode, (0, 1), done.stderr)
                for text, line in zip(made.splitlines(), done.stdout.splitlines(), strict=True):
                    query, exact = json.loads(text), json.loads(line)["exact"]
                    if exact["verdict"] == "invalid":
                        continue
                    with self.subTest(query["id"]):
                        self.look_at(predicate, query, exact["facts"])
                    seen += 1
                    contacts += exact["verdict"] == "contact"
        print(f"{seen} queries, {contacts} contacts")
        self.assertTrue(seen // 4 < contacts < seen * 3 // 4, (seen, contacts))


class FamilyFactsLong(FamilyFacts):
    queries = 40


if __name__ == "__main__":
    unittest.main()
