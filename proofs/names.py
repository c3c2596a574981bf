"""The thirteen numbers of a query and the sixteen comparisons, in the order of kernel/sphere_triangle/names.h."""

INPUTS = ["Ax", "Ay", "Az", "Bx", "By", "Bz", "Cx", "Cy", "Cz", "Px", "Py", "Pz", "r"]
COMPARISONS = ["plane_radius"] + [
    f"vertex_{v}_{c}" for v, others in (("a", "bc"), ("b", "ac"), ("c", "ab")) for c in ["radius"] + [f"side_{o}" for o in others]
] + [f"edge_{e}_{c}" for e, o in (("ab", "c"), ("bc", "a"), ("ca", "b")) for c in ("radius", f"side_{o}")]
