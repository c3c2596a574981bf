"""windows_test.py PRINT_SIDES WRITTEN: the table and the queries are what windows.py makes; the kernels, plain and fused, give
the sides of an unbounded exponent on every query inside the window, and do not on those one step beyond its ends."""
import json
import pathlib
import random
import subprocess
import sys
from fractions import Fraction

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import fpcore
import windows
from emitted_test import kernel_sides
from names import COMPARISONS, INPUTS

PRINT_SIDES, WRITTEN = sys.argv[1], pathlib.Path(sys.argv[2])
FORMS = ("published", "reduced")


def is_unbounded(cores, comparison, form, precision, query, computed):
    """Whether the kernel's sides of the comparison are those of the FPCores with an unbounded exponent."""
    values = dict(zip(INPUTS, map(Fraction, query)))
    return all(fpcore.evaluate(core.body, values, fpcore.Arithmetic(precision, bounded=False))
               == computed[core.name.removeprefix(form + "_")] for core in cores[comparison])


def replay():
    lines = [json.loads(line) for line in windows.QUERIES.read_text().splitlines()]
    asked = {}
    for line in lines:
        form, comparison, precision, *_ = line["id"].split()
        query = [float.fromhex(x) for x in (*line["a"], *line["b"], *line["c"], *line["p"], line["r"])]
        asked.setdefault((form, precision), []).append((line["id"], comparison.replace(".", "_"), query))
    for (form, precision), queries in asked.items():
        for contraction in ("plain", "fma"):
            cores = windows.sides(WRITTEN, form, contraction, precision)
            kernel = form + ("+fma" if contraction == "fma" else "")
            computed = kernel_sides(PRINT_SIDES, kernel, precision, [q for _, _, q in queries])
            for (name, comparison, query), sides in zip(queries, computed):
                inside = is_unbounded(cores, comparison, form, precision, query, sides)
                assert inside == name.endswith("inside"), f"{name}: {kernel} {'is' if inside else 'is not'} as unbounded"
    kinds = [line["id"].split()[-1] for line in lines]
    assert kinds.count("overflows") == kinds.count("underflows") == kinds.count("inside") / 2 == 2 * (16 + 6)
    return len(lines)


def within(source, g, h):
    """A multiple of 2^g, at most 2^h and of at most 24 significant bits: at either end of the range, or anywhere."""
    kind = source.randrange(4)
    low = g if kind == 0 else source.randint(g, h - 23)
    n = source.randint(-3, 3) if kind < 2 else source.randint(-2 ** 23, 2 ** 23)
    return float(n) * 2.0 ** (h if kind == 1 and abs(n) == 1 else low)


def inside(seed):
    """Checks random queries of each window, both ends among them; returns the number of sides checked."""
    source, greatest, count = random.Random(seed), windows.proved_greatest(), 0
    for form in FORMS:
        for precision in ("binary32", "binary64"):
            for contraction in ("plain", "fma"):
                cores = windows.sides(WRITTEN, form, contraction, precision)
                ends = {}
                for comparison in COMPARISONS:
                    k = max(map(windows.degree, cores[comparison]))
                    g = -(-fpcore.FORMATS[precision][1] // k)
                    ends.setdefault((g, greatest[form, precision, comparison]), []).append(comparison)
                for (g, h), comparisons in ends.items():
                    queries = [[within(source, g, h) for _ in range(9)] + [0.0] * 3 + [abs(within(source, g, h))] for _ in range(6)]
                    kernel = form + ("+fma" if contraction == "fma" else "")
                    for query, sides in zip(queries, kernel_sides(PRINT_SIDES, kernel, precision, queries)):
                        for comparison in comparisons:
                            assert is_unbounded(cores, comparison, form, precision, query, sides), (
                                f"{kernel} {precision} {comparison}, {' '.join(x.hex() for x in query)}, seed {seed}")
                            count += 1
    return count


def main():
    seed = 20260002
    subprocess.run([sys.executable, windows.__file__, "--check", "--written", WRITTEN], check=True)
    print(f"{replay()} queries at the ends, {inside(seed)} sides inside, seed {seed}")


if __name__ == "__main__":
    main()
