"""emitted_test.py PRINT_SIDES WRITTEN SUITE: an independent reader checks the FPCores and the LaTeX that write_proofs
wrote.

FPCore  every file is in the grammar of FPCore 2.0; evaluated with fractions and rounded by hand, every core gives
the bits of
        the kernel's side; faults planted in the text are refused or detected
LaTeX   every row reads back as the exact value of the side"""
import os
import random
import re
import struct
import subprocess
import sys
from fractions import Fraction

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import fpcore
from names import COMPARISONS, INPUTS

SIDES = [f"{c}_{side}" for side in ("lhs", "rhs") for c in COMPARISONS]


def read(path):
    with open(path) as file:
        return file.read()


def number(random_source, precision):
    """A number of the format: a small integer, a uniform one, or one with an exponent that makes degree 6 underflow in
    binary32."""
    kind = random_source.randrange(4)
    if kind == 0:
        x = float(random_source.randint(-3, 3))
    else:
        x = random_source.uniform(-1, 1) * 2.0 ** (random_source.randint(-24, 10) if kind == 1 else 0)
    return struct.unpack("f", struct.pack("f", x))[0] if precision == "binary32" else x


def queries(precision, count, seed):
    source = random.Random(seed)
    made = [[number(source, precision) for _ in INPUTS] for _ in range(count)]
    return [q[:12] + [abs(q[12])] for q in made]


def kernel_sides(print_sides, kernel, precision, asked):
    """The sides of each query by name, as the kernel computes them."""
    lines = "".join(" ".join(x.hex() for x in q) + "\n" for q in asked)
    done = subprocess.run([print_sides, kernel, precision], input=lines, capture_output=True, text=True, check=True)
    return [dict(zip(SIDES, map(float.fromhex, line.split()))) for line in done.stdout.splitlines()]


def values_of(query):
    return dict(zip(INPUTS, map(Fraction, query)))


def differing(cores, form, precision, asked, computed):
    """The cores whose value differs from the kernel's side; the sign of a zero is ignored."""
    found = set()
    for query, sides in zip(asked, computed):
        for core in cores:
            value = fpcore.evaluate(core.body, values_of(query), fpcore.Arithmetic(precision))
            if value != Fraction(sides[core.name.removeprefix(form + "_")]):
                found.add(core.name)
    return found


FAULTS = {  # in a right text: what is replaced once, and what the reader then says
    "a symbol that is not bound": ("[d (", "[d_ (", "'d' is not bound"),
    "an operand too few": ("(- Ax Px)]", "(* Ax)]", "with 1 operands"),
    "a binding in parentheses": ("[a_x (- Ax Px)]", "(a_x (- Ax Px))", "[symbol expression]"),
    "another rounding": (":round nearestEven", ":round nearest", ":round nearest"),
    "another precision": (":precision binary32", ":precision float", ":precision float"),
    "a precondition that is not a boolean": (":pre (and", ":pre (+", "not in the language"),
    "a parenthesis too few": ("    (* d d))", "    (* d d)", "is missing"),
    "an operation of no language": ("(* d d)", "(square d d)", "not in the language"),
}


# Texts inside and outside the grammar, besides those that are emitted.
GRAMMATICAL = ["(FPCore () 1)", "(FPCore f (x) :cite () :pre (< 0 x 1) (sqrt x))", "(FPCore (x) (let ([a 1/2] [a* .5e-3]) (* a a*)))",
               "(FPCore (x) (if (not (isnan x)) (pow x 2) 0x1.8p-3))", "(FPCore (x) :pre (>= x) (let ([b (< x 1)]) (if b x E)))",
               '(FPCore (x) :name "a \\"b\\"" ; (\n :example ([x 1]) (- x))']
UNGRAMMATICAL = ["(FPCore 1)", "(FPCore (x x) x)", "(FPCore (x) y)", "(FPCore (x) (+ x x x))", "(FPCore (x) (let ((a x)) a))",
                 "(FPCore (x) :pre (and) x)", "(FPCore (x) :pre x x)", "(FPCore (x) (< x 1))", "(FPCore (x) (if x x x))",
                 "(FPCore (x) 1.)", "(FPCore (x) 1/0)", "(FPCore (x) x x)", "(FPCore (x) :cite (a) b x)", "(FPCore (x) (x))",
                 "(FPCore (x) (let ([a 1] [b a]) b))", "(FPCore (x) x", "(FPCore (x) [+ x x])", "(FPCore (1) 1)"]


def check_grammar():
    for text in GRAMMATICAL:
        fpcore.cores(text)
    for text in UNGRAMMATICAL:
        try:
            fpcore.cores(text)
        except fpcore.Malformed:
            continue
        raise AssertionError(f"{text} is accepted")


def check_fpcore(print_sides, folder):
    check_grammar()
    seed, count = 20260000, 12
    checked = 0
    for precision in ("binary32", "binary64"):
        for form in ("published", "reduced"):
            for contraction, kernel in (("plain", form), ("fma", form + "+fma")):
                path = os.path.join(folder, "fpcore", precision, f"{form}_{contraction}.fpcore")
                cores = fpcore.cores(read(path))
                zero = {f"edge_{e}_{'rhs' if form == 'published' else 'lhs'}" for e in ("ab_side_c", "bc_side_a", "ca_side_b")}
                assert [c.name for c in cores] == sorted(
                    (f"{form}_{s}" for s in SIDES if s not in zero),
                    key=lambda n: (COMPARISONS.index(n[len(form) + 1:-4]), n[-3:])), path
                assert all(c.properties["precision"] == precision for c in cores), path
                asked = queries(precision, count, seed)
                computed = kernel_sides(print_sides, kernel, precision, asked)
                wrong = differing(cores, form, precision, asked, computed)
                assert not wrong, f"{path}: {sorted(wrong)} differ from {kernel}; seed {seed}"
                checked += len(cores)
    print(f"{checked} cores, {count} queries each, seed {seed}: the kernel's bits")

    text = read(os.path.join(folder, "fpcore", "binary32", "published_plain.fpcore"))
    for fault, (old, new, says) in FAULTS.items():
        assert old in text, fault
        try:
            fpcore.cores(text.replace(old, new, 1))
        except fpcore.Malformed as malformed:
            assert says in str(malformed), f"{fault}: {malformed}"
        else:
            raise AssertionError(f"{fault} is accepted")
    # Texts that are in the grammar but compute something else.
    asked = queries("binary32", count, seed)
    computed = kernel_sides(print_sides, "published", "binary32", asked)
    for old, new in (("(* d d)", "(* d a_x)"), ("[AB_x (- b_x a_x)]", "[AB_x (- a_x b_x)]")):
        wrong = differing(fpcore.cores(text.replace(old, new)), "published", "binary32", asked, computed)
        assert wrong, f"{new} for {old} is not seen"
    fused = read(os.path.join(folder, "fpcore", "binary32", "published_fma.fpcore"))
    assert differing(fpcore.cores(fused), "published", "binary32", asked, computed), "fused is not told from plain"


NAME = re.compile(r"(?:\\mathit\{([A-Za-z]+)\}|([A-Za-z]))(?:_\{(\d*),?([xyz]?)\})?")


def arithmetic_of(latex):
    """A formula of the LaTeX as a Python expression, with the names of the recorder."""
    def name(found):
        letters, index, component = found[1] or found[2], found[3] or "", found[4] or ""
        return f"{letters}{index}{'_' if component else ''}{component}"
    return NAME.sub(name, latex).replace(r"\cdot", "*")


def reads_back(text, form, cores, seed):
    """Whether every row has the values of the FPCores over the reals."""
    for query in queries("binary64", 5, seed):
        values = {n[0] + "_" + n[1] if len(n) == 2 else n: v for n, v in values_of(query).items()}
        for name, value in re.findall(r"^  (\S+) &= (.*?)(?: \\\\)?$", text, re.M):
            values[arithmetic_of(name)] = eval(arithmetic_of(value), {}, values)
        rows = re.findall(r"^  \\text\{(\S+):\}\\quad & (.*?) > (.*?)(?: \\\\)?$", text, re.M)
        titles = [title.replace("\\", "").replace(".", "_") for title, _, _ in rows]
        assert titles == COMPARISONS, titles
        for title, (_, *sides) in zip(titles, rows):
            for side, latex in zip(("lhs", "rhs"), sides):
                key = f"{form}_{title}_{side}"
                exact = fpcore.evaluate(cores[key].body, values_of(query), fpcore.exactly) if key in cores else 0
                if eval(arithmetic_of(latex), {}, values) != exact:
                    return False
    return True


def check_latex(folder):
    seed = 20260001
    for form in ("published", "reduced"):
        path = os.path.join(folder, "latex", form + ".tex")
        text = read(path)
        assert text.count(r"\begin{align*}") == text.count(r"\end{align*}") == 2 and text.count("{") == text.count("}"), path
        cores = {c.name: c for c in fpcore.cores(read(os.path.join(folder, "fpcore", "binary64", form + "_plain.fpcore")))}
        assert reads_back(text, form, cores, seed), f"{path}: not the exact sides, seed {seed}"
        planted = text.replace(r"b_{x} - a_{x}", r"a_{x} - b_{x}", 1)
        assert planted != text and not reads_back(planted, form, cores, seed), "an edge turned round is not seen"
    print("LaTeX reads back as the exact sides")


def main():
    print_sides, folder, suite = sys.argv[1:4]
    if suite == "FPCore":
        check_fpcore(print_sides, folder)
    else:
        {"LaTeX": check_latex}[suite](folder)


if __name__ == "__main__":
    main()
