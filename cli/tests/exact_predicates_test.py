#!/usr/bin/env python3
"""The rationals that the tests of predicates compare with, themselves."""
import sys
import unittest
from fractions import Fraction

from exact_predicates import truth


class ExactPredicates(unittest.TestCase):
    def test_what_a_drawing_settles(self):
        apart, meets, touches = ("separated", False), ("contact", False), ("contact", True)
        triangle = [0, 0, 0, 4, 0, 0, 0, 4, 0]
        upright, cube = [1, 0, 0, 0, 1, 0, 0, 0, 1], [0, 0, 0, 1, 1, 1]
        box = lambda m, s=(1, 1, 1), b=upright: [*m, *s, *b]
        for predicate, entry, numbers, right in [
                ("sphere-triangle", "vertices", [*triangle, 1, 1, 3, 2.5], apart),      # above the face
                ("sphere-triangle", "vertices", [*triangle, 1, 1, 3, 3], touches),
                ("sphere-triangle", "vertices", [*triangle, -3, -4, 0, 5], touches),    # a vertex
                ("sphere-triangle", "vertices", [*triangle, 2, -2, 0, 1.5], apart),     # an edge
                ("sphere-triangle", "vertices", [0] * 9 + [0, 0, 2, 3], meets),         # a triangle that is a point
                ("sphere-triangle", "vertices", [*triangle, 0, 0, 0, -1], ("invalid", False)),
                ("sphere-triangle", "vertices", [*triangle, 0, 0, float("inf"), 1], ("invalid", False)),
                ("moving-sphere", "displacement", [*triangle, 1, 1, 5, 0, 0, -3, 2], touches),
                ("moving-sphere", "endpoints", [*triangle, 1, 1, 5, 1, 1, -3, 0], meets),    # a point that crosses the face
                ("moving-sphere", "endpoints", [*triangle, 0, 1, 5, 0, 1, -3, 0], touches),  # an edge
                ("moving-sphere", "displacement", [*triangle, -2, -2, 3, 9, -9, 0, 0.5], apart),
                ("moving-sphere", "displacement", [*triangle, 2, -5, 1, 0, 0, 0, 0.5], apart),
                ("box-box", "matrix", box((0, 0, 0)) + box((2, 2, 2)), touches),
                ("box-box", "matrix", box((0, 0, 0)) + box((1, 2.5, 0)), apart),
                ("box-box", "matrix", box((0, 0, 0)) + box((1, 1, 1), (0, 0, 0)), touches),  # a point at the corner
                ("box-box", "matrix", box((0, 0, 0), (1, 1, 0)) + box((3, 0, 0), (1, 1, 0)), apart),  # in one plane
                ("box-box", "matrix", box((0, 0, 0), (1, 1, 0)) + box((1, 0, 0), (1, 1, 0)), touches),
                ("box-box", "matrix", box((0, 0, 0), (1, 0, 0)) + box((0, 1, 0), (1, 0, 0)), apart),  # parallel segments
                ("box-box", "matrix", box((0, 0, 0), (1, 0, 0)) + box((3, 0, 0), (1, 0, 0)), apart),  # in one line
                ("box-box", "matrix", box((0, 0, 0), (0, 0, 0)) + box((0, 0, 1), (0, 0, 0)), apart),  # points
                ("box-box", "matrix", box((0, 0, 0), b=[1, 0, 0, 2, 0, 0, 0, 0, 1]) + box((0, 0, 0)), ("invalid", False)),
                ("box-box", "quaternion", [*cube, 1, 0, 0, 1, 2.4, 0, 0, 1, 1, 1, 2, 0, 0, 0], apart),
                ("box-box", "quaternion", [*cube, 3, 0, 0, 4, Fraction(56, 25), 0, 0, 1, 1, 1, 2, 0, 0, 0], touches),
                ("box-box", "quaternion", [*cube, 0, 0, 0, 0, 2, 0, 0, 1, 1, 1, 2, 0, 0, 0], ("invalid", False)),
                ("box-box", "minmax", [0, 0, 0, 1, 2, 3, 1, 2, 3, 4, 4, 4], touches),
                ("box-box", "minmax", [0, 0, 0, 1, 2, 3, 1, 3, 3, 4, 4, 4], apart),
                ("box-box", "minmax", [0, 0, 0, 1, 2, 3, 0, 1, 1, 4, 4, 4], meets),
                ("box-box", "minmax-quaternion", [-1, -1, -1, 1, 1, 1, Fraction(56, 25), 0, 0, 1, 1, 1, 3, 0, 0, 4], touches),
                ("box-box", "minmax-quaternion", [-1, 2, -1, 1, 1, 1, 0, 0, 0, 1, 1, 1, 3, 0, 0, 4], ("invalid", False)),
                ("box-box", "minmax", [0, 0, 0, 1, 2, 3, 0, 1, 5, 4, 4, 4], ("invalid", False)),
                ("box-triangle", "quaternion", [0, 0, 0, 1, 1, 1, 3, 0, 0, 4, Fraction(25, 24), 0, 0, 4, 0, 1, 4, 0, -1], touches),
                ("box-triangle", "quaternion", [0, 0, 0, 1, 1, 1, 0, 0, 0, 0, *triangle], ("invalid", False)),
                ("box-triangle", "centre", [0, 0, 0, 1, 1, 1, 1, 0, 0, 3, 0, 0, 2, 1, 0], touches),
                ("box-triangle", "minmax", [-1, -1, -1, 1, 1, 1, 0, 0, 0, 3, 0, 0, 2, 1, 0], meets),
                ("box-triangle", "minmax", [2, 0, 0, 1, 1, 1, *triangle], ("invalid", False)),
                ("box-triangle", "matrix", [0, 0, 0, 1, 1, 1, *upright, 4, 0, 0, 0, 4, 0, 0, 0, 4], apart),
                ("capsule-triangle", "endpoints", [0, 0, 0, 4, 0, 0, 0, 4, 0, -5, 1, 2, 5, 1, 2, 2], touches),
                ("capsule-triangle", "endpoints", [0, 0, 0, 4, 0, 0, 0, 4, 0, 3, 3, -3, 3, 3, 3, 1], apart),
                ("capsule-triangle", "endpoints", [0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, -3, 1, 1, 3, 0], meets),
                ("point-box", "corners", [1, 1, 2, 0, 0, 0, 2, 2, 2], touches),
                ("point-box", "corners", [1, 1, 3, 0, 0, 0, 2, 2, 2], apart),
                ("point-box", "corners", [1, 1, 1, 0, 0, 0, 2, 2, 2], meets),
                ("point-box", "corners", [1, 1, 1, 0, 3, 0, 2, 2, 2], ("invalid", False))]:
            with self.subTest(predicate=predicate, numbers=numbers):
                self.assertEqual(truth(predicate, entry, numbers), right)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
