"""The formulae of the forms that evaluation_test.py replays, over the reals, written from their definitions in docs/ and not from kernel/."""
from fractions import Fraction


def number(x):
    return float.fromhex(x) if isinstance(x, str) else float(x)


def columns(query):
    """The numbers of a query line by the names of the columns."""
    found = {}
    for name, value in query.items():
        if isinstance(value, dict):
            for part, numbers in value.items():
                for i, one in enumerate(numbers):
                    if isinstance(one, list):
                        found.update({f"{name}.{part}{i}{k}": number(x) for k, x in zip("xyz", one)})
                    else:
                        found[f"{name}.{part}{i if part == 's' else 'xyz'[i]}"] = number(one)
        elif isinstance(value, list):
            found.update({name + k: number(x) for k, x in zip("xyz", value)})
        elif name == "r":
            found[name] = number(value)
    return found


def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def minus(u, v):
    return [x - y for x, y in zip(u, v)]


def along(u, v, t):
    """u + t v; None where t is a quotient by 0."""
    return None if u is None or t is None else [x + t * y for x, y in zip(u, v)]


def ratio(x, y):
    return None if y == 0 else x / y


def vector(q, name):
    return [Fraction(q[name + k]) for k in "xyz"]


def still(name, at, rr, form):
    """Both sides of one of the sixteen comparisons, the vertices `at` relative to the centre."""
    axis, kind = name.split(".")
    normal = cross(minus(at["b"], at["a"]), minus(at["c"], at["a"]))
    if axis == "plane":
        return dot(at["a"], normal)**2, rr * dot(normal, normal)
    if axis.startswith("vertex"):
        own = at[axis[-1]]
        return (dot(own, own), rr) if kind == "radius" else (dot(own, at[kind[-1]]), dot(own, own))
    one, other = at[axis[-2]], at[axis[-1]]
    edge = minus(other, one)
    e = dot(edge, edge)
    if form == "published":
        Q = minus([x * e for x in one], [x * dot(one, edge) for x in edge])
        third = at[({"a", "b", "c"} - set(axis[-2:])).pop()]
        return (dot(Q, Q), rr * e * e) if kind == "radius" else (dot(Q, minus([x * e for x in third], Q)), Fraction(0))
    of_edge = cross(one, other)
    return (dot(of_edge, of_edge), rr * e) if kind == "radius" else (Fraction(0), dot(of_edge, normal))


def sphere(name, q, form):
    return still(name, {v: minus(vector(q, v), vector(q, "p")) for v in "abc"}, Fraction(q["r"])**2, form)


def moving(name, q):
    moment, axis, kind = name.split(".")
    at, rr = {v: minus(vector(q, v), vector(q, "p")) for v in "abc"}, Fraction(q["r"])**2
    d = vector(q, "d") if "dx" in q else minus(vector(q, "p1" if "p1x" in q else "q"), vector(q, "p"))
    normal = cross(minus(at["b"], at["a"]), minus(at["c"], at["a"]))
    if moment == "sweep":
        if axis.startswith("vertex"):
            across = {v: cross(at[v], d) for v in "abc"}
            own = across[axis[-1]]
            return (dot(own, own), rr * dot(d, d)) if kind == "radius" else (dot(own, across[kind[-1]]), dot(own, own))
        swept = cross(d, minus(at[axis[-1]], at[axis[-2]]))
        delta = dot(at[axis[-2]], swept)
        return (delta**2, rr * dot(swept, swept)) if kind == "radius" else (delta * dot(d, normal), Fraction(0))
    if moment == "end":
        at = {v: minus(x, d) for v, x in at.items()}
    if kind != "heading":
        return still(f"{axis}.{kind}", at, rr, "reduced")
    if axis == "plane":
        closing = dot(at["a"], normal) * dot(d, normal)
    elif axis.startswith("vertex"):
        closing = dot(at[axis[-1]], d)
    else:
        edge = minus(at[axis[-1]], at[axis[-2]])
        closing = dot(cross(at[axis[-2]], edge), cross(d, edge))
    return (Fraction(0), closing) if moment == "start" else (closing, Fraction(0))


def boxes(name, q, form):
    box = {v: {"m": vector(q, f"{v}.m"), "s": [Fraction(q[f"{v}.s{k}"]) for k in range(3)], "b": [vector(q, f"{v}.b{k}") for k in range(3)]} for v in "ab"}
    between = minus(box["b"]["m"], box["a"]["m"])
    if form == "projected":
        facets = [cross(box[name[0]]["b"][(int(name[1]) + 1) % 3], box[name[0]]["b"][(int(name[1]) + 2) % 3])] if len(name) == 2 else []
        L = facets[0] if facets else cross(box["a"]["b"][int(name[1])], box["b"]["b"][int(name[3])])
        return abs(dot(L, between)), sum(one["s"][k] * abs(dot(L, one["b"][k])) for one in box.values() for k in range(3))
    R = [[dot(u, v) for v in box["b"]["b"]] for u in box["a"]["b"]]
    t, sa, sb = [dot(u, between) for u in box["a"]["b"]], box["a"]["s"], box["b"]["s"]
    if len(name) == 2 and name[0] == "a":
        i = int(name[1])
        return abs(t[i]), sa[i] + sum(sb[j] * abs(R[i][j]) for j in range(3))
    if len(name) == 2:
        j = int(name[1])
        return abs(sum(t[i] * R[i][j] for i in range(3))), sb[j] + sum(sa[i] * abs(R[i][j]) for i in range(3))
    i, j = int(name[1]), int(name[3])
    (i1, i2), (j1, j2) = ((k + 1) % 3 for k in (i, i + 1)), ((k + 1) % 3 for k in (j, j + 1))

    def cofactor(col):
        one, last = (col + 1) % 3, (col + 2) % 3
        return abs(R[i1][one] * R[i2][last] - R[i1][last] * R[i2][one])

    return (abs(t[i2] * R[i1][j] - t[i1] * R[i2][j]),
            sa[i1] * abs(R[i2][j]) + sa[i2] * abs(R[i1][j]) + sb[j1] * cofactor(j2) + sb[j2] * cofactor(j1))


def box_and_triangle(name, q, form):
    if "box.minx" in q:
        low, high = vector(q, "box.min"), vector(q, "box.max")
        m, s = [(x + y) / 2 for x, y in zip(low, high)], [(y - x) / 2 for x, y in zip(low, high)]
    else:
        m, s = vector(q, "box.m"), [Fraction(q[f"box.s{k}"]) for k in range(3)]
    b = [vector(q, f"box.b{k}") if "box.b0x" in q else [Fraction(k == i) for i in range(3)] for k in range(3)]
    v = [minus(vector(q, corner), m) for corner in "abc"]
    i, j = "xyz".find(name[0]), ("ab", "bc", "ca").index(name[2:]) if "_" in name else None

    def beyond(numbers):
        return max(min(numbers), -max(numbers))

    if form.startswith("thirteen"):
        edges = [minus(v[(k + 1) % 3], v[k]) for k in range(3)]
        L = cross(edges[0], minus(v[2], v[0])) if name == "plane" else cross(b[i], edges[j]) if j is not None else cross(b[(i + 1) % 3], b[(i + 2) % 3])
        return beyond([dot(L, corner) for corner in v]), sum(half * abs(dot(L, axis)) for half, axis in zip(s, b))
    v = [[dot(axis, corner) for axis in b] for corner in v]
    edges = [minus(v[(k + 1) % 3], v[k]) for k in range(3)]
    if name == "plane":
        normal = cross(edges[0], edges[1])
        return abs(dot(normal, v[0])), sum(half * abs(x) for half, x in zip(s, normal))
    if j is None:
        return beyond([corner[i] for corner in v]), s[i]
    i1, i2 = (i + 1) % 3, (i + 2) % 3
    one, other = edges[j][i1], edges[j][i2]
    return beyond([one * v[k][i2] - other * v[k][i1] for k in (j, (j + 2) % 3)]), s[i1] * abs(other) + s[i2] * abs(one)


def closest_point(q, decide):
    """Whether separated, by the closest point of the triangle to the origin; decide(lhs, rhs, sign) says how each comparison goes."""
    A, B, C = (minus(vector(q, v), vector(q, "p")) for v in "abc")
    zero = Fraction(0)
    AB, AC, BC = minus(B, A), minus(C, A), minus(C, B)
    one = {v: -dot(AB, at) for v, at in (("a", A), ("b", B), ("c", C))}
    two = {v: -dot(AC, at) for v, at in (("a", A), ("b", B), ("c", C))}

    def at_least(lhs, rhs):
        return decide(lhs, rhs, ">=")

    def nearest():
        if not decide(one["a"], zero, ">") and not decide(two["a"], zero, ">"):
            return A
        if at_least(one["b"], zero) and at_least(one["b"], two["b"]):
            return B
        weight_c = one["a"] * two["b"] - one["b"] * two["a"]
        if at_least(zero, weight_c) and at_least(one["a"], zero) and at_least(zero, one["b"]):
            return along(A, AB, ratio(one["a"], one["a"] - one["b"]))
        if at_least(two["c"], zero) and at_least(two["c"], one["c"]):
            return C
        weight_b = one["c"] * two["a"] - one["a"] * two["c"]
        if at_least(zero, weight_b) and at_least(two["a"], zero) and at_least(zero, two["c"]):
            return along(A, AC, ratio(two["a"], two["a"] - two["c"]))
        weight_a = one["b"] * two["c"] - one["c"] * two["b"]
        past_b, past_c = two["b"] - one["b"], one["c"] - two["c"]
        if at_least(zero, weight_a) and at_least(past_b, zero) and at_least(past_c, zero):
            return along(B, BC, ratio(past_b, past_b + past_c))
        whole = weight_a + weight_b + weight_c
        return along(along(A, AB, ratio(weight_b, whole)), AC, ratio(weight_c, whole))

    Q = nearest()
    return decide(None if Q is None else dot(Q, Q), Fraction(q["r"])**2, ">")


CLAUSES = {"sphere-triangle": [["plane.radius"]] + [[f"vertex_{v}.radius"] + [f"vertex_{v}.side_{o}" for o in "abc" if o != v] for v in "abc"] +
           [[f"edge_{e}.radius", f"edge_{e}.side_{o}"] for e, o in (("ab", "c"), ("bc", "a"), ("ca", "b"))]}
CLAUSES["moving-sphere"] = [[f"{m}.{c}" for c in clause] + [f"{m}.{clause[0].split('.')[0]}.heading"] for m in ("start", "end")
                            for clause in CLAUSES["sphere-triangle"]]
CLAUSES["moving-sphere"] += [[f"sweep.{c}" for c in clause] if "vertex" in clause[0] else [f"sweep.{clause[0]}", f"sweep.{clause[0].split('.')[0]}.side"]
                             for clause in CLAUSES["sphere-triangle"][1:]]
CLAUSES["capsule-triangle"] = CLAUSES["moving-sphere"]
CLAUSES["box-triangle"] = [[name] for name in ("x", "y", "z", "plane", *(f"{i}_{j}" for i in "xyz" for j in ("ab", "bc", "ca")))]
CLAUSES["box-box"] = [[f"{v}{k}"] for v in "ab" for k in range(3)] + [[f"a{i}b{j}"] for i in range(3) for j in range(3)]


def agree(sides, shown):
    """Whether both sides are the formula's; None is of one that divides by 0 or overflows on the way."""
    return all(one is None or side is None or one == side for side, one in zip(sides, shown))


def verdict(form, q, decisions):
    """What the decisions make, each (name, holds, lhs, rhs, sign) with both sides exactly, after the sides were compared with the formulae's."""
    if form == "closest-point":
        left = list(decisions)

        def decide(lhs, rhs, sign):
            name, holds, shown_lhs, shown_rhs, shown_sign = left.pop(0)
            assert sign == shown_sign and agree((lhs, rhs), (shown_lhs, shown_rhs)), f"{name} is not the formula's comparison"
            return holds

        separated = closest_point(q, decide)
        assert not left, "more comparisons than the way has"
        return "separated" if separated else "contact"
    predicate, _, rung = form.rpartition("/")
    of = {"": lambda name: sphere(name, q, rung), "moving-sphere": lambda name: moving(name, q), "capsule-triangle": lambda name: moving(name, q),
          "box-box": lambda name: boxes(name, q, rung), "box-triangle": lambda name: box_and_triangle(name, q, rung)}[predicate]
    for name, _, lhs, rhs, _ in decisions:
        assert agree(of(name), (lhs, rhs)), f"{name} is not the formula's comparison"
    held, failed = ({name for name, holds, *_ in decisions if holds is says} for says in (True, False))
    clauses = CLAUSES[predicate or "sphere-triangle"]
    if any(set(clause) <= held for clause in clauses):
        return "separated"
    return "contact" if all(set(clause) & failed for clause in clauses) else "undetermined"
