"""FPCore 2.0 (https://fpbench.org/spec/fpcore-2.0.html): reads FPCores, checks them against the grammar, and evaluates
them exactly or rounded.

It covers the language without loops, tensors and annotations. Only + - * and fma are evaluated, in straight-line
programs."""
import re
from fractions import Fraction

TOKEN = re.compile(r'\s+|;[^\n]*|(?P<open>[(\[])|(?P<close>[)\]])|(?P<string>"(?:[ !#-\[\]-~]|\\["\\])*")|(?P<word>[^\s()\[\]";]+)')
SYMBOL = re.compile(r"[a-zA-Z~!@$%^&*_\-+=<>.?/:][a-zA-Z0-9~!@$%^&*_\-+=<>.?/:]*")
RATIONAL = re.compile(r"[+-]?[0-9]+/[0-9]*[1-9][0-9]*")
DECNUM = re.compile(r"[-+]?([0-9]+(\.[0-9]+)?|\.[0-9]+)(e[-+]?[0-9]+)?")
HEXNUM = re.compile(r"[+-]?0x([0-9a-f]+(\.[0-9a-f]+)?|\.[0-9a-f]+)(p[-+]?[0-9]+)?", re.I)
CONSTANTS = {"E", "LOG2E", "LOG10E", "LN2", "LN10", "PI", "PI_2", "PI_4", "M_1_PI", "M_2_PI", "M_2_SQRTPI", "SQRT2",
             "SQRT1_2", "INFINITY", "NAN", "TRUE", "FALSE"}
# Operations by their numbers of operands. Arithmetic: real operands, a real result; predicates: real operands, a boolean
# result.
ARITHMETIC = {"+": {2}, "-": {1, 2}, "*": {2}, "/": {2}, "fma": {3}}
ARITHMETIC |= dict.fromkeys("""fabs exp exp2 expm1 log log10 log2 log1p sqrt cbrt sin cos tan asin acos atan sinh cosh tanh asinh acosh
                               atanh erf erfc tgamma lgamma ceil floor trunc round nearbyint""".split(), {1})
ARITHMETIC |= dict.fromkeys("pow hypot atan2 fmod remainder fmax fmin fdim copysign".split(), {2})
TESTS = {"<", ">", "<=", ">=", "==", "!="}
CLASSES = {"isfinite", "isinf", "isnan", "isnormal", "signbit"}
ROUNDINGS = {"nearestEven", "nearestAway", "toPositive", "toNegative", "toZero"}


class Malformed(Exception):
    """The text is not an FPCore; the message says what was found, where, and what would be right."""


class String(str):
    pass


class Bracketed(list):
    """A list in [ ], which the grammar allows only for bindings."""


def parse(text):
    """The top-level S-expressions: words are str, strings String, lists list, and bracketed lists Bracketed."""
    stack, closers, at = [[]], [], 0
    while at < len(text):
        found = TOKEN.match(text, at)
        where = f"line {text.count(chr(10), 0, at) + 1}"
        if not found:
            raise Malformed(f"{where}: '{text[at:at + 20]}' is not a token")
        at = found.end()
        if found["open"]:
            stack.append(Bracketed() if found["open"] == "[" else [])
            closers.append("]" if found["open"] == "[" else ")")
        elif found["close"]:
            if not closers or closers.pop() != found["close"]:
                raise Malformed(f"{where}: '{found['close']}' closes nothing of its kind")
            done = stack.pop()
            stack[-1].append(done)
        elif found["string"]:
            stack[-1].append(String(found["string"]))
        elif found["word"]:
            stack[-1].append(found["word"])
    if closers:
        raise Malformed(f"at the end: '{closers[-1]}' is missing")
    return stack[0]


def is_number(word):
    return any(kind.fullmatch(word) for kind in (RATIONAL, DECNUM, HEXNUM))


def is_symbol(datum):
    return type(datum) is str and SYMBOL.fullmatch(datum) is not None and not is_number(datum)


def type_of(expression, bound):
    """'real' or 'boolean'. Every symbol has to be bound."""
    if isinstance(expression, String):
        raise Malformed(f"{expression}: a string is not an expression")
    if isinstance(expression, str):
        if is_number(expression):
            return "real"
        if expression in CONSTANTS:
            return "boolean" if expression in ("TRUE", "FALSE") else "real"
        if not is_symbol(expression) or expression not in bound:
            raise Malformed(f"'{expression}' is not bound")
        return bound[expression]
    if type(expression) is not list or not expression or not is_symbol(expression[0]):
        raise Malformed(f"{expression}: an operation and its operands are expected")
    operation, *operands = expression
    if operation in ("let", "let*"):
        if len(operands) != 2 or type(operands[0]) is not list:
            raise Malformed(f"{operation}: bindings and one body are expected")
        inner = dict(bound)
        for binding in operands[0]:
            if not isinstance(binding, Bracketed) or len(binding) != 2 or not is_symbol(binding[0]):
                raise Malformed(f"{binding}: [symbol expression] is expected")
            inner[binding[0]] = type_of(binding[1], inner if operation == "let*" else bound)
        return type_of(operands[1], inner)
    types = [type_of(operand, bound) for operand in operands]
    if operation in ARITHMETIC and len(operands) in ARITHMETIC[operation] and set(types) == {"real"}:
        return "real"
    if operation in TESTS and set(types) == {"real"} or operation in CLASSES and types == ["real"]:
        return "boolean"
    if operation in ("and", "or") and set(types) == {"boolean"} or operation == "not" and types == ["boolean"]:
        return "boolean"
    if operation == "if" and len(types) == 3 and types[0] == "boolean" and types[1] == types[2]:
        return types[1]
    raise Malformed(f"({operation} ...) with {len(operands)} operands {types} is not in the language")


class Core:
    """One FPCore, checked. Raises Malformed."""

    def __init__(self, datum):
        if type(datum) is not list or datum[:1] != ["FPCore"]:
            raise Malformed("(FPCore ...) is expected")
        rest = datum[1:]
        self.name = rest.pop(0) if rest and is_symbol(rest[0]) else None
        if not rest or type(rest[0]) is not list or not all(is_symbol(a) for a in rest[0]):
            raise Malformed(f"{self.name}: a list of arguments is expected")
        self.arguments = rest.pop(0)
        if len(set(self.arguments)) != len(self.arguments):
            raise Malformed(f"{self.name}: an argument appears twice")
        self.properties = {}
        while len(rest) >= 2 and type(rest[0]) is str and rest[0].startswith(":"):
            key = rest.pop(0)[1:]
            if not is_symbol(key) or key in self.properties:
                raise Malformed(f"{self.name}: the property :{key} appears twice, or is not a symbol")
            self.properties[key] = rest.pop(0)
        if len(rest) != 1:
            raise Malformed(f"{self.name}: properties and one expression are expected")
        (self.body,) = rest
        self._check()

    def _check(self):
        bound = dict.fromkeys(self.arguments, "real")
        if type_of(self.body, bound) != "real":
            raise Malformed(f"{self.name}: a real is expected")
        p = self.properties
        if "pre" in p and type_of(p["pre"], bound) != "boolean":
            raise Malformed(f"{self.name}: :pre has to be a boolean")
        if p.get("precision", "real") not in ("real", "binary32", "binary64"):
            raise Malformed(f"{self.name}: :precision {p['precision']} is not known")
        if p.get("round", "nearestEven") not in ROUNDINGS:
            raise Malformed(f"{self.name}: :round {p['round']} is not known")
        for key in ("name", "description"):
            if key in p and not isinstance(p[key], String):
                raise Malformed(f"{self.name}: :{key} has to be a string")
        if "cite" in p and not (type(p["cite"]) is list and all(is_symbol(s) for s in p["cite"])):
            raise Malformed(f"{self.name}: :cite has to be a list of symbols")


def cores(text):
    return [Core(datum) for datum in parse(text)]


# Precision in bits, the exponent of the least number's last place, and that of the first power of two that is too
# great.
FORMATS = {"binary32": (24, -149, 128), "binary64": (53, -1074, 1024)}


class OutOfRange(Exception):
    """An operation overflowed."""


def power(e):
    return Fraction(2 ** e) if e >= 0 else Fraction(1, 2 ** -e)


def nearest_even(x, digits, least_exponent):
    """x rounded to `digits` digits; with least_exponent None the exponents are unlimited."""
    if x == 0:
        return x
    n, d = abs(x.numerator), x.denominator
    e = n.bit_length() - d.bit_length()
    if (n << max(-e, 0)) < (d << max(e, 0)):
        e -= 1  # 2^e <= |x| < 2^(e + 1)
    place = e - digits + 1
    if least_exponent is not None:
        place = max(place, least_exponent)
    return round(x / power(place)) * power(place)  # to an integer, ties to even


class Arithmetic:
    """Rounding to nearest in one format. If `bounded`, with the format's exponents, gradual underflow and overflow
    (OutOfRange); otherwise with unlimited exponents. `underflows` counts the operations whose result the least
    exponent changed."""

    def __init__(self, precision, bounded=True):
        self.digits, self.least, self.greatest = FORMATS[precision]
        self.bounded = bounded
        self.underflows = 0

    def __call__(self, x):
        free = nearest_even(x, self.digits, None)
        if not self.bounded:
            return free
        found = nearest_even(x, self.digits, self.least)
        self.underflows += found != free
        if abs(found) >= power(self.greatest):
            raise OutOfRange
        return found


def exactly(x):
    return x


def evaluate(expression, values, rounded):
    """The value of an expression whose symbols have these values, with each operation rounded by `rounded`."""
    if isinstance(expression, str):
        return values[expression] if expression in values else Fraction(expression)
    operation, *operands = expression
    if operation in ("let", "let*"):
        inner = dict(values)
        for name, value in operands[0]:
            inner[name] = evaluate(value, inner if operation == "let*" else values, rounded)
        return evaluate(operands[1], inner, rounded)
    x = [evaluate(operand, values, rounded) for operand in operands]
    if operation == "-" and len(x) == 1:
        return -x[0]
    exact = {"+": lambda: x[0] + x[1], "-": lambda: x[0] - x[1], "*": lambda: x[0] * x[1],
             "fma": lambda: x[0] * x[1] + x[2]}[operation]
    return rounded(exact())
