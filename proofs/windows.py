#!/usr/bin/env python3
"""The window of exponents in which nothing over- or underflows: its table in docs/bounds.md and queries at its ends.

windows.py [--written DIR]            writes the table and proofs/windows.jsonl
windows.py [--written DIR] --check    says which of the two is not current, and exits 1

The window is a theorem (coq/formulae/Windows.v), and its numbers are read from there. Where it ends is found here, by
evaluating the FPCores in exact arithmetic with rounding, once with the format's exponents and once with unlimited
ones: the first size 2^h at which an operation overflows, among the cube's vertices, and the first grid 2^g on which
one underflows, among small integers. Each end is kept as two queries, the last that does not and the first that
does."""
import argparse
import itertools
import json
import pathlib
import re
import sys
from fractions import Fraction

import fpcore
from names import COMPARISONS, INPUTS, written_proofs

PROOFS = pathlib.Path(__file__).resolve().parent
DOCUMENT = PROOFS.parent / "docs" / "bounds.md"
QUERIES = PROOFS / "windows.jsonl"
BEGIN, END = "<!-- $ proofs/windows.py -->\n", "<!-- end -->\n"

# One comparison of each kind; the others are the same with the vertices renamed A -> B -> C -> A.
KINDS = ["plane_radius", "vertex_a_radius", "vertex_a_side_b", "edge_ab_radius", "edge_ab_side_c"]
RENAMED = {"edge_bc_radius": ("edge_ab_radius", 1), "edge_bc_side_a": ("edge_ab_side_c", 1),
           "edge_ca_radius": ("edge_ab_radius", 2), "edge_ca_side_b": ("edge_ab_side_c", 2)}
RENAMED |= {f"vertex_{v}_radius": ("vertex_a_radius", i) for i, v in enumerate("abc")}


def kind_of(comparison):
    return next(k for k in KINDS if k.split("_")[0] == comparison.split("_")[0] and
                ("radius" in k) == ("radius" in comparison))


def shown(comparison):
    """The name as `axiscert` spells it: vertex_a_side_b is vertex_a.side_b."""
    return re.sub(r"_(radius|side)", r".\1", comparison)


def proved_greatest():
    """The size 2^h up to which nothing overflows, by (form, precision, comparison), read from coq/formulae/Windows.v."""
    text = (PROOFS / "coq" / "formulae" / "Windows.v").read_text()
    found = {}
    for form in ("published", "reduced"):
        for precision in ("binary32", "binary64"):
            body = re.search(rf"Definition {form}_greatest{precision[-2:]} \(K.*?match K with(.*?)end\.", text, re.S)[1]
            rows = re.findall(r"\| ([\w| ]+?) => (\w+)", body)
            for comparison in COMPARISONS:
                value = next(v for names, v in rows if comparison in names.split(" | ") or names == "_")
                found[form, precision, comparison] = int(value) if value.isdigit() else found["published", precision, comparison]
    return found


def sides(written, form, contraction="plain", precision="binary32"):
    """The FPCores of each comparison, which write_proofs wrote in the folder `written`."""
    cores = fpcore.cores((written / "fpcore" / precision / f"{form}_{contraction}.fpcore").read_text())
    by_name = {core.name: core for core in cores}
    return {c: [by_name[name] for side in ("lhs", "rhs") if (name := f"{form}_{c}_{side}") in by_name] for c in COMPARISONS}


def degree(core):
    """The degree of the polynomial, which tells how the side of a query of size 2^h grows with h."""
    generic = {name: Fraction(n) for name, n in zip(INPUTS, (2, 3, 5, -7, 11, 13, 17, -19, 23, 0, 0, 0, 29))}
    once = fpcore.evaluate(core.body, generic, fpcore.exactly)
    twice = fpcore.evaluate(core.body, {n: 2 * x for n, x in generic.items()}, fpcore.exactly)
    ratio = twice / once
    assert ratio.denominator == 1 and ratio.numerator & (ratio.numerator - 1) == 0, core.name
    return ratio.numerator.bit_length() - 1


def scaled(query, e):
    return dict(zip(INPUTS, (x * fpcore.power(e) for x in query)))


def evaluated(cores, values, arithmetic):
    """The sides, or None where one overflows."""
    try:
        return [fpcore.evaluate(core.body, values, arithmetic) for core in cores]
    except fpcore.OutOfRange:
        return None


def overflows(cores, values, precision):
    return evaluated(cores, values, fpcore.Arithmetic(precision)) is None


def outside(cores, values, precision):
    """Whether some side differs from its value with an unbounded exponent."""
    bounded, free = fpcore.Arithmetic(precision), fpcore.Arithmetic(precision, bounded=False)
    return evaluated(cores, values, bounded) != evaluated(cores, values, free)


# All triangles of the cube's vertices up to its symmetries, which negate coordinates: A is (1, 1, 1).
CUBE = [(1, 1, 1, *rest, 0, 0, 0, 1) for rest in itertools.product((1, -1), repeat=6)]
SMALL = [(*a, *b, *c, 0, 0, 0, 1) for a in ((1, 0, 0), (1, 1, 0)) for b in itertools.product((0, 1, 2), repeat=3)
         for c in itertools.product((0, 1, 2), repeat=3)]


def overflow(cores, k, precision):
    """The least h at which a query of the cube overflows, and that query."""
    start = (fpcore.FORMATS[precision][2] - 9) // k  # a side is less than 2^9 2^(k h)
    for h in itertools.count(start):
        for query in CUBE:
            if overflows(cores, scaled(query, h), precision):
                return h, query


def underflow(cores, k, precision):
    """The first g below the least grid, and a query of small multiples of 2^g that underflows."""
    g = -((-fpcore.FORMATS[precision][1]) // k) - 1
    return g, next(q for q in SMALL if outside(cores, scaled(q, g), precision))


def renamed(query, turns):
    """The query whose vertices A, B, C are this query's, moved on by `turns` places."""
    vertices = [query[0:3], query[3:6], query[6:9]]
    return sum((vertices[(i - turns) % 3] for i in range(3)), ()) + query[9:]


def entry(name, precision, query, e):
    numbers = [f"{'-' * (x < 0)}0x{abs(x)}p{e if x else 0:+d}" for x in query]
    fields = {"a": numbers[0:3], "b": numbers[3:6], "c": numbers[6:9], "p": numbers[9:12], "r": numbers[12]}
    return json.dumps({"id": name, "precision": precision, **fields})


def made(written):
    """The table's rows and the lines of the queries."""
    greatest, rows, lines = proved_greatest(), [], []
    for form in ("published", "reduced"):
        cores = sides(written, form)
        for kind in KINDS:
            if form == "reduced" and not kind.startswith("edge"):
                continue
            for precision in ("binary32", "binary64"):
                k = max(map(degree, cores[kind]))
                h, tall = overflow(cores[kind], k, precision)
                g, fine = underflow(cores[kind], k, precision)
                proved = greatest[form, precision, kind]
                bits = fpcore.FORMATS[precision][0]
                title = (form + " " if kind.startswith("edge") else "") + re.sub(r"_.*_", " ", re.sub("_[bc]$", "", kind))
                rows.append(f"| {title.replace('_', ' ')} | {k} | {precision} | 2^{g + 1} | 2^{proved} | {g + bits}..{proved} | "
                            f"2^{g} | 2^{h} |")
                for comparison in COMPARISONS:
                    if kind_of(comparison) != kind:
                        continue
                    turns = RENAMED[comparison][1] if comparison in RENAMED else 0
                    exact = [renamed(q, turns) for q in (tall, fine)]
                    if comparison not in RENAMED and comparison != kind:  # the other sides of a vertex
                        exact = [next(q for q in CUBE if overflows(cores[comparison], scaled(q, h), precision)),
                                 next(q for q in SMALL if outside(cores[comparison], scaled(q, g), precision))]
                    name = f"{form} {shown(comparison)} {precision}"
                    lines += [entry(f"{name} size {h - 1} inside", precision, exact[0], h - 1),
                              entry(f"{name} size {h} overflows", precision, exact[0], h),
                              entry(f"{name} grid {g + 1} inside", precision, exact[1], g + 1),
                              entry(f"{name} grid {g} underflows", precision, exact[1], g)]
    return rows, lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--written", type=pathlib.Path, help="where write_proofs wrote; default: where it did last")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    rows, lines = made(written_proofs(options.written))
    table = ("| comparison | degree | precision | grid, least | size, greatest | m of whole significands | underflows at | overflows at |\n"
             "|---|---:|---|---:|---:|---:|---:|---:|\n" + "\n".join(rows) + "\n")
    text = DOCUMENT.read_text()
    before, rest = text.split(BEGIN)
    after = rest.split(END, 1)[1]
    stale = []
    for path, new in ((DOCUMENT, before + BEGIN + table + END + after), (QUERIES, "\n".join(lines) + "\n")):
        if not path.exists() or path.read_text() != new:
            stale.append(path)
            if not options.check:
                path.write_text(new)
    for path in stale:
        print(f"{path}: is not what windows.py makes" if options.check else path)
    return 1 if stale and options.check else 0


if __name__ == "__main__":
    sys.exit(main())
