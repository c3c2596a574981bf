#!/usr/bin/python3
"""Tests each claim of docs/precision.md on queries, with arithmetic and with exact answers that are this folder's own: no code of the project.

    claims.py                  tests all claims of docs/precision_claims.json; exits 1 where one is not shown
    claims.py ID...            these
    claims.py --queries N      on fewer queries: fails only where one is refuted

A part of a claim names a form and another, what is counted of both (counts.py), and the range in which the ratio of the two counts lies, `null` where it has
no end; `on`: the scenes (scenes.py) in which that is so; `not_on`: scenes in which it is not, each with the range that holds there. Bits, or a scene for the
other form, are named where they differ. In place of a ratio, `differ_at_most` is the greatest share of triangles on which any comparison differs.

Each part on each scene is a hypothesis. It is `shown` where everything outside its range is refused, `refuted` where everything inside is; both by Holm's
procedure over all hypotheses together, so that one false word among all of them has a probability of 1 %. Neither is `not shown`, which is no yes either:
the sample is too small for the effect, or nothing was wrong at all.
"""
import argparse
import json
import math
import sys
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

import claims_counts as counts
import claims_forms as forms
import claims_paired as paired
import claims_scenes as scenes

PAGE_CLAIMS = Path(__file__).resolve().parents[1] / "precision_claims.json"


@dataclass(frozen=True)
class Hypothesis:
    claim: str
    form: str
    against: str
    counted: str
    scene: str
    least: float = 0.0
    most: float = math.inf
    other_scene: str = ""       # of `against`; empty: the same, and the same queries
    bits: int = 24
    other_bits: int = 24
    differ_at_most: float = 0.0  # not 0: in place of the range


class Wrong(Exception):
    pass


def hypotheses(claims):
    """One for each part and scene; a claim that names what is not there, or nothing at all, is an error."""
    found = []
    for claim in claims:
        if not claim.get("parts"):
            raise Wrong(f"{claim['id']}: has no parts, so that nothing could refute it")
        for part in claim["parts"]:
            ranges = {scene: part.get("ratio") for scene in part["on"]} | part.get("not_on", {})
            if not part["on"]:
                raise Wrong(f"{claim['id']}: a part is `on` no scene")
            for name in (part["form"], part["against"]):
                if name not in forms.FORMS:
                    raise Wrong(f"{claim['id']}: no form is called {name}")
            for scene, limits in ranges.items():
                if scene.split()[0] not in scenes.SCENES:
                    raise Wrong(f"{claim['id']}: no scene is called {scene}")
                if scene in part.get("not_on", {}) and inside(limits, part["ratio"]):
                    raise Wrong(f"{claim['id']}: {scene} is in not_on with {limits}, inside of {part['ratio']}")
                bits = part.get("bits", 24)
                common = {"claim": claim["id"], "form": part["form"], "against": part["against"], "scene": scene, "bits": bits,
                          "other_bits": part.get("against_bits", bits), "other_scene": part.get("against_on", "")}
                if "differ_at_most" in part:
                    found.append(Hypothesis(**common, counted="comparisons", differ_at_most=part["differ_at_most"]))
                else:
                    found.append(Hypothesis(**common, counted=part["counted"], least=limits[0] or 0.0, most=limits[1] or math.inf))
    return found


def inside(inner, outer):
    return (inner[0] or 0) >= (outer[0] or 0) and (inner[1] or math.inf) <= (outer[1] or math.inf)


class Data:
    """The samples, each made once; all seeds of one are joined."""

    def __init__(self, queries, seeds):
        self.queries, self.seeds = queries, seeds
        self.samples = lru_cache(maxsize=None)(
            lambda scene, bits: [counts.Sample(scene, seed, queries // len(seeds), bits) for seed in seeds])
        self.errors = lru_cache(maxsize=None)(self.count)

    def count(self, form, counted, scene, bits, other=""):
        """Errors by triangle, or with `other` the triangles on which any comparison differs."""
        return np.concatenate([paired.by_triangle(s.differing(form, other) if other else s.errors(form, counted), s.triangle)
                               for s in self.samples(scene, bits)])


class Result:
    """A hypothesis and what the data say: p_shown and p_refuted are probabilities of data this extreme, were it not so, were it so."""

    def __init__(self, hypothesis, data):
        self.hypothesis = h = hypothesis
        if h.differ_at_most:
            differing = data.count(h.form, "", h.scene, h.bits, h.against) > 0
            self.triangles, self.total = len(differing), (int(differing.sum()), 0)
            self.p_shown = at_most(self.total[0], self.triangles, h.differ_at_most)
            self.p_refuted = 1 - at_most(self.total[0] - 1, self.triangles, h.differ_at_most)
            return
        is_paired = not h.other_scene and h.bits == h.other_bits
        self.ratio = r = paired.Ratio(data.errors(h.form, h.counted, h.scene, h.bits),
                                      data.errors(h.against, h.counted, h.other_scene or h.scene, h.other_bits), is_paired)
        self.triangles, self.total = r.triangles, r.total
        self.p_shown, self.p_refuted = 0.0, 1.0
        ends = (h.least > 0) + (h.most < math.inf)
        if h.least > 0:
            self.p_shown = max(self.p_shown, r.p_above(h.least))
            self.p_refuted = min(self.p_refuted, ends * r.p_below(h.least))
        if h.most < math.inf:
            self.p_shown = max(self.p_shown, r.p_below(h.most))
            self.p_refuted = min(self.p_refuted, ends * r.p_above(h.most))
        if not ends:
            self.p_shown = 1.0  # a range without an end says nothing
        if is_paired and (h.least >= 1 or h.most <= 1):  # a direction, which an exact test has to show too
            self.p_shown = max(self.p_shown, paired.sign_test(r.more, r.fewer) / 2 if (r.more > r.fewer) == (h.least >= 1) else 1.0)

    def sentence(self, level, verdict):
        h = self.hypothesis
        place = h.scene + (f" {h.bits} bits" if h.bits != 24 else "")
        if h.other_scene or h.other_bits != h.bits:
            place += f" / {h.other_scene or h.scene} {h.other_bits} bits"
        what = f"  {verdict:9s} {place:28s} {h.form} / {h.against}, {h.counted}: "
        if h.differ_at_most:
            return what + f"{self.total[0]} of {self.triangles:,} triangles differ, said at most {h.differ_at_most:g}"
        low, high = self.ratio.interval(level)
        said = f"{h.least:g} to {h.most:g}" if h.least and h.most < math.inf else f"at least {h.least:g}" if h.least else f"at most {h.most:g}"
        votes = f", {self.ratio.more:,} triangles more and {self.ratio.fewer:,} fewer" if self.ratio.paired else ""
        return what + (f"{self.total[0]:,} / {self.total[1]:,} = {self.ratio.value():.3g} [{low:.3g}, {high:.3g}], said {said}; {self.triangles:,} triangles"
                       f"{votes}; shows ratios from {self.ratio.least_effect(level):.3g} on")


def at_most(k, n, share):
    """The probability of k or fewer of n, each with this share."""
    return math.fsum(math.exp(math.lgamma(n + 1) - math.lgamma(i + 1) - math.lgamma(n - i + 1) + i * math.log(share) + (n - i) * math.log1p(-share))
                     for i in range(k + 1))


def verdicts(results, level):
    """"shown", "refuted" or "not shown" of each."""
    shown, refuted = paired.holm([r.p_shown for r in results], level), paired.holm([r.p_refuted for r in results], level)
    return ["refuted" if no else "shown" if yes else "not shown" for yes, no in zip(shown, refuted)]


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("ids", nargs="*")
    arguments.add_argument("--queries", type=int)
    arguments.add_argument("--seeds", type=int, nargs="+")
    given = arguments.parse_args()
    book = json.loads(PAGE_CLAIMS.read_text())
    sample, level = book["sample"], book["level"]
    claims = [claim for claim in book["claims"] if not given.ids or claim["id"] in given.ids]
    unknown = set(given.ids) - {claim["id"] for claim in claims}
    if unknown or not claims:
        sys.exit(f"claims.py: no claim is called {', '.join(sorted(unknown))}; {PAGE_CLAIMS.name} has {', '.join(c['id'] for c in book['claims'])}")
    whole = given.queries is None
    data = Data(given.queries or sample["queries"], given.seeds or sample["seeds"])
    results = [Result(h, data) for h in hypotheses(claims)]
    said = verdicts(results, level)
    print(f"{len(claims)} claims, {len(results)} hypotheses, {data.queries:,} queries of each scene from seeds {', '.join(map(str, data.seeds))}; "
          f"numpy {np.__version__}, PCG64; family-wise error {level:g}, intervals at {level:g} / {len(results)}")
    for claim in claims:
        print(f"\n{claim['id']}: {claim['sentence']}")
        for result, verdict in zip(results, said):
            if result.hypothesis.claim == claim["id"]:
                print(result.sentence(level / len(results), verdict))
    touching = sum(s.ties()[0] for scene, bits in {(h.scene, h.bits) for h in (r.hypothesis for r in results)} for s in data.samples(scene, bits))
    equal = sum(s.ties()[1] for scene, bits in {(h.scene, h.bits) for h in (r.hypothesis for r in results)} for s in data.samples(scene, bits))
    print(f"\nTies, in no count: {touching:,} queries touch, {equal:,} comparisons have equal sides")
    failed = [v for v in said if v == "refuted" or (whole and v != "shown")]
    print(f"{said.count('shown')} shown, {said.count('refuted')} refuted, {said.count('not shown')} not shown")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
