#!/usr/bin/env python3
"""The distances, places and times that `check` prints, against rationals that share nothing with the program."""
import decimal
import json
import random
import unittest
from fractions import Fraction

from command import Case, axiscert
from exact_predicates import UPRIGHT, box, cross, dot, from_triangle, minus, plus, segment_from_triangle, times, turned

SEED = 20240607
decimal.getcontext().prec = 2000


def line(number, predicate, precision, **members):
    return json.dumps({"id": str(number), "predicate": predicate, "precision": precision, **members}) + "\n"


def shown(x):
    """As nearest as a decimal with so many digits can be."""
    return decimal.Decimal(x.numerator) / decimal.Decimal(x.denominator)


def valued(text):
    """"3/4", "sqrt(2)", "1/2 - sqrt(1/3)" and "|sqrt(2) - 1| / (3/4)" to two thousand digits."""
    if text.startswith("|"):
        length, scene = text[1:].split("| / ")
        return abs(valued(length)) / valued(scene[1:-1] if scene.startswith("(") else scene)
    sum, sign = decimal.Decimal(0), 1
    for word in text.split():
        if word in "+-":
            sign = 1 if word == "+" else -1
            continue
        if word.startswith("-"):
            sign, word = -sign, word[1:]
        root = word.startswith("sqrt(")
        x = shown(Fraction(word[5:-1] if root else word))
        sum += sign * (x.sqrt() if root else x)
    return sum


def rounded(x, digits):
    return +decimal.Context(prec=digits, rounding=decimal.ROUND_HALF_EVEN).create_decimal(x)


class ExactFacts(Case):
    queries = 30

    def facts(self, text):
        done = axiscert("check", "-", "--format", "jsonl", stdin=text)
        self.assertEqual(done.returncode, 0, done.stderr)
        found = [json.loads(each)["exact"] for each in done.stdout.splitlines()]
        for exact, precision in zip(found, [json.loads(each)["precision"] for each in text.splitlines()], strict=True):
            for name, fact in exact["facts"].items():
                with self.subTest(name=name):
                    self.assert_rounded_once(fact, 9 if precision == "binary32" else 17)
        return [{"verdict": exact["verdict"], "touching": exact["touching"], **exact["facts"]} for exact in found]

    def assert_rounded_once(self, fact, digits):
        if fact["exact"] is None:
            return
        both = [fact["value"], fact["exact"]] if isinstance(fact["value"], list) else [[fact["value"]], [fact["exact"]]]
        for value, exact in zip(*both, strict=True):
            self.assertEqual(decimal.Decimal(value), rounded(valued(exact), digits), exact)

    def assert_same(self, x, y):
        """To a thousand digits."""
        self.assertAlmostEqual(x, y, delta=decimal.Decimal(10) ** -1000 * (1 + abs(y)))

    def point(self, fact):
        return tuple(map(Fraction, fact["exact"]))

    def assert_direction(self, fact, vector):
        """That of this vector, and of length 1."""
        squared = dot(vector, vector)
        for part, x in zip(fact["exact"], vector, strict=True):
            square, size = (valued(part) ** 2 * shown(squared)), shown(x * x)
            self.assertAlmostEqual(square, size, delta=decimal.Decimal(10) ** -500 * shown(squared))
            self.assertEqual(valued(part) < 0, x < 0)

    def test_a_sphere_and_a_triangle(self):
        numbers = random.Random(SEED)
        queries, text = [], ""
        for i in range(3 * self.queries):
            wide = 2 ** numbers.randrange(1, 40)
            at = lambda: tuple(Fraction(numbers.randint(-wide, wide), 8) for _ in range(3))
            a, b, c, p = at(), at(), at(), at()
            if i % 5 == 0:  # a segment, a point
                b, c = plus(a, times(numbers.randint(0, 2), minus(b, a))), a if i % 10 else plus(a, times(3, minus(b, a)))
            if i % 7 == 0:  # on the triangle
                p = times(Fraction(1, 2), plus(a, b))
            r = Fraction(numbers.randint(0, wide), 8)
            queries.append((a, b, c, p, r))
            text += line(i, "sphere-triangle", "binary64", **dict(zip("abc", map(lambda v: list(map(float, v)), (a, b, c)))),
                         p=list(map(float, p)), r=float(r))
        for (a, b, c, p, r), found in zip(queries, self.facts(text), strict=True):
            with self.subTest(seed=SEED, query=(a, b, c, p, r)):
                squared = from_triangle(p, (a, b, c))
                self.assert_same(valued(found["centre_distance"]["exact"]), shown(squared).sqrt())
                is_apart = squared > r * r
                depth = abs(shown(squared).sqrt() - shown(r))
                self.assertEqual(set(found) & {"distance", "penetration"}, {"distance" if is_apart else "penetration"})
                self.assert_same(valued(found["distance" if is_apart else "penetration"]["exact"]), depth)
                # The nearest point: it is in the triangle, and no corner is nearer along the way from it to the centre.
                x = self.point(found["nearest_point"])
                away = minus(p, x)
                self.assertEqual(dot(away, away), squared)
                self.assertTrue(all(dot(away, minus(corner, x)) <= 0 for corner in (a, b, c)))
                self.assertEqual(from_triangle(x, (a, b, c)), 0)
                scene = max(r * r, *(dot(minus(v, p), minus(v, p)) for v in (a, b, c)))
                if scene:
                    share = depth / shown(scene).sqrt()
                    self.assertAlmostEqual(valued(found["depth"]["exact"]), share, delta=decimal.Decimal(10) ** -1000)
                if squared:
                    self.assert_direction(found["normal"], away)
                else:
                    self.assertEqual((found["normal"]["value"], found["normal"]["note"]), (None, "not one: the centre is on the triangle"))
                parts = {f"vertex_{name}" for name, v in zip("abc", (a, b, c)) if v == x}
                self.assertEqual({name for name in found["features"]["value"] if name.startswith("vertex")}, parts)

    def test_a_motion(self):
        numbers = random.Random(SEED)
        queries, text, contacts = [], "", 0
        for i in range(2 * self.queries):
            at = lambda size=40: tuple(Fraction(numbers.randint(-size, size), 4) for _ in range(3))
            a, b, c, p, d, r = at(), at(), at(), at(), at(120), Fraction(numbers.randint(0, 30), 4)
            queries.append((a, b, c, p, d, r))
            text += line(i, "moving-sphere", "binary64", **{name: list(map(float, v)) for name, v in zip("abcpd", (a, b, c, p, d))}, r=float(r))
        for (a, b, c, p, d, r), found in zip(queries, self.facts(text), strict=True):
            with self.subTest(seed=SEED, query=(a, b, c, p, d, r)):
                least = segment_from_triangle(p, plus(p, d), (a, b, c))
                self.assert_same(valued(found["centre_distance"]["exact"]), shown(Fraction(least)).sqrt())
                if least > r * r:
                    self.assertNotIn("time", found)
                    continue
                contacts += 1
                time = valued(found["time"]["exact"])
                # Just before it the two are apart, at it they touch, to a thousand digits.
                near = Fraction(str(rounded(time, 1000)))
                x = [valued(part) for part in found["nearest_point"]["exact"]]
                normal = [valued(part) for part in found["normal"]["exact"] or []]
                centre = [shown(u) + shown(v) * time for u, v in zip(p, d)]
                away = [u - v for u, v in zip(centre, x)]
                squared = sum(u * u for u in away)
                tiny = decimal.Decimal(10) ** -900
                self.assertAlmostEqual(squared, shown(Fraction(from_triangle(plus(p, times(near, d)), (a, b, c)))), delta=tiny)
                self.assertTrue(all(sum(u * (shown(v) - w) for u, v, w in zip(away, corner, x)) <= tiny for corner in (a, b, c)))
                for u, n in zip(away, normal):
                    self.assertAlmostEqual(n * squared.sqrt(), u, delta=tiny)
                if time > 0:
                    self.assertAlmostEqual(squared, shown(r * r), delta=tiny)
                    before = near - Fraction(1, 10 ** 40)
                    self.assertGreater(from_triangle(plus(p, times(before, d)), (a, b, c)), r * r)
                else:
                    self.assertLessEqual(from_triangle(p, (a, b, c)), r * r)
        self.assertGreater(contacts, self.queries // 4)

    def pair(self, found, first, second):
        return self.point(found["nearest_point_" + first]), self.point(found["nearest_point_" + second])

    def assert_nearest(self, found, names, a, b):
        """Hulls by their corners: the two points are in them, and the planes through them at right angles to what is between part the hulls."""
        x, y = self.pair(found, *names)
        way = minus(y, x)
        self.assertTrue(all(dot(way, minus(p, x)) <= 0 for p in a) and all(dot(way, minus(p, y)) >= 0 for p in b))
        self.assert_same(valued(found["distance"]["exact"]), shown(dot(way, way)).sqrt())
        self.assert_direction(found["normal"], way)

    def assert_penetration(self, found, axes, a, b):
        """The least over these axes of what is left of the two projections beside each other."""
        ways = []
        for axis in axes:
            if any(axis):
                of_a, of_b = [dot(axis, p) for p in a], [dot(axis, p) for p in b]
                ways += [(Fraction(left) ** 2 / dot(axis, axis), way) for left, way in ((max(of_a) - min(of_b), axis),
                                                                                     (max(of_b) - min(of_a), times(-1, axis)))]
        least = min(square for square, _ in ways)
        self.assert_same(valued(found["penetration"]["exact"]), shown(least).sqrt())
        best = [way for square, way in ways if square == least]
        only = all(not any(cross(best[0], way)) and dot(best[0], way) > 0 for way in best)
        self.assertEqual(found["normal"].get("note", "the only one"), "the only one" if only else "not the only one")
        squares = [tuple(valued(part) for part in found["normal"]["exact"])]
        self.assertTrue(any(all(abs(n * shown(dot(way, way)).sqrt() - shown(u)) < decimal.Decimal(10) ** -500 for n, u in zip(squares[0], way))
                            for way in best))

    def test_two_boxes(self):
        numbers = random.Random(SEED)
        queries, text, apart = [], "", 0
        for i in range(self.queries):
            whole = lambda size: [numbers.randint(-size, size) for _ in range(3)]
            both = []
            for _ in "ab":
                q = [1, 0, 0, 0] if i % 4 == 0 else [numbers.randint(-3, 3) for _ in range(4)]
                both.append({"m": whole(3), "s": [numbers.randint(0, 3) for _ in range(3)], "q": q if any(q) else [1, 0, 0, 0]})
            queries.append(both)
            text += line(i, "box-box", "binary32", a=both[0], b=both[1])
        for both, found in zip(queries, self.facts(text), strict=True):
            with self.subTest(seed=SEED, query=both):
                turns = [turned(*map(Fraction, one["q"])) for one in both]
                (a, edges_a), (b, edges_b) = [box(tuple(one["m"]), one["s"], axes) for one, axes in zip(both, turns)]
                if found["verdict"] == "separated":
                    apart += 1
                    self.assert_nearest(found, "ab", a, b)
                else:
                    axes = [*turns[0], *turns[1], *(cross(u, v) for u in turns[0] for v in turns[1])]
                    self.assert_penetration(found, axes, a, b)
        self.assertTrue(self.queries // 8 < apart < self.queries * 7 // 8, apart)

    def test_a_box_and_a_triangle(self):
        numbers = random.Random(SEED)
        queries, text, apart = [], "", 0
        for i in range(self.queries):
            whole = lambda size: tuple(numbers.randint(-size, size) for _ in range(3))
            m, s, corners = whole(4), [numbers.randint(0, 4) for _ in range(3)], [whole(6) for _ in range(3)]
            queries.append((m, s, corners))
            text += line(i, "box-triangle", "binary32", box={"m": m, "s": s}, **dict(zip("abc", corners)))
        for (m, s, corners), found in zip(queries, self.facts(text), strict=True):
            with self.subTest(seed=SEED, query=(m, s, corners)):
                own, _ = box(m, s, UPRIGHT)
                edges = [minus(corners[(k + 1) % 3], corners[k]) for k in range(3)]
                if found["verdict"] == "separated":
                    apart += 1
                    self.assert_nearest(found, ("box", "triangle"), own, corners)
                else:
                    self.assert_penetration(found, [*UPRIGHT, cross(edges[0], edges[1]), *(cross(u, v) for u in UPRIGHT for v in edges)],
                                            own, corners)
        self.assertTrue(self.queries // 8 < apart < self.queries * 7 // 8, apart)

    def test_points_that_are_not_the_only_ones_say_so(self):
        cube = {"m": [0, 0, 0], "s": [1, 1, 1], "q": [1, 0, 0, 0]}
        for other, only in (({**cube, "m": [3, 0, 0]}, False), ({**cube, "m": [3, 4, 5]}, True), ({**cube, "m": [3, 4, 0]}, False),
                            ({**cube, "m": [2, 2, 2]}, True), ({**cube, "m": [2, 2, 0]}, False), ({**cube, "m": [2, 1, 0]}, False),
                            ({**cube, "m": [4, 0, 0], "q": [12, 0, 0, 5]}, False), ({**cube, "m": [4, 0, 0], "q": [8, 1, 3, 2]}, True)):
            with self.subTest(other=other):
                (found,) = self.facts(line(0, "box-box", "binary64", a=cube, b=other))
                for name in ("nearest_point_a", "nearest_point_b"):
                    self.assertEqual(found[name].get("note"), None if only else "not the only one")

    def test_text_says_the_digits_and_with_exact_the_fractions(self):
        text = line("q", "sphere-triangle", "binary32", a=[0, 0, 0], b=[3, 0, 0], c=[0, 3, 0], p=[1, 1, 1], r=0.5)
        self.assertEqual(axiscert("check", "-", stdin=text).stdout.splitlines()[1],
                         "  rounded to 9 digits: distance 0.5; depth 0.204124145 of the scene; centre_distance 1; features face; "
                         "nearest_point (1, 1, 0); normal (0, 0, 1)")
        self.assertIn("depth 0.204124145 = sqrt(1/24) of the scene", axiscert("check", "-", "--exact", stdin=text).stdout)
        self.refused("check", "1:general:2:binary32:0:0-1", "--format", "csv", "--exact", says=["--exact", "queries in a file"])


class ExactFactsLong(ExactFacts):
    queries = 100


if __name__ == "__main__":
    unittest.main()
