"""What is counted on a sample: arrays of errors a query, for a form."""
from functools import lru_cache

import numpy as np

import claims_exact as exact
import claims_forms as forms
import claims_scenes as scenes

# Ties are apart: no comparison whose exact sides are equal, and no query that touches, is in any of these.
GROUPS = {"plane": [0], "vertex radii": [1, 4, 7], "vertex sides": [2, 3, 5, 6, 8, 9], "edge radii": [10, 12, 14], "edge sides": [11, 13, 15],
          "edges": [10, 11, 12, 13, 14, 15]}
VERDICTS = ("missed", "phantom", "wrong")


class Sample:
    def __init__(self, scene, seed, n, bits):
        self.columns, self.triangle = scenes.sample(scene, seed, n, bits)
        self.bits = bits
        self.signs = exact.comparison_signs(self.columns)
        self.distance = exact.distance_sign(self.columns)
        self.held = lru_cache(maxsize=None)(lambda form: forms.comparisons(form, self.columns, self.bits))
        # Two ways to the truth: no axis separates where the regions say contact, and some axis does where they say apart.
        assert np.array_equal(forms.separated(self.signs > 0), self.distance > 0)

    def ties(self):
        """Queries that touch, comparisons of equal sides."""
        return int((self.distance == 0).sum()), int((self.signs == 0).sum())

    def errors(self, form, counted):
        """How many errors of this kind the form makes on each query."""
        held = self.held(form)
        if counted in GROUPS:
            rows = GROUPS[counted]
            return ((held[rows] != (self.signs[rows] > 0)) & (self.signs[rows] != 0)).sum(axis=0)
        says = forms.separated(held)
        missed, phantom = says & (self.distance < 0), ~says & (self.distance > 0)
        return {"missed": missed, "phantom": phantom, "wrong": missed | phantom}[counted].astype(int)

    def differing(self, form, other):
        """How many comparisons of each query the forms answer differently, ties among them."""
        return (self.held(form) != self.held(other)).sum(axis=0)
