"""The thirteen numbers of a query and the sixteen comparisons, in the order of kernel/sphere_triangle/names.h; and where the target
write_proofs has written what is made of the kernel's sources."""
import pathlib
import sys

INPUTS = ["Ax", "Ay", "Az", "Bx", "By", "Bz", "Cx", "Cy", "Cz", "Px", "Py", "Pz", "r"]
COMPARISONS = ["plane_radius"] + [
    f"vertex_{v}_{c}" for v, others in (("a", "bc"), ("b", "ac"), ("c", "ab")) for c in ["radius"] + [f"side_{o}" for o in others]
] + [f"edge_{e}_{c}" for e, o in (("ab", "c"), ("bc", "a"), ("ca", "b")) for c in ("radius", f"side_{o}")]

ROOT = pathlib.Path(__file__).resolve().parents[1]


def written_proofs(given=None):
    """The folder `given`, or else that of the build in which write_proofs ran last. Exits with status 2 where there is none."""
    found = [pathlib.Path(given)] if given else ROOT.glob("build/*/written_proofs")
    if not (written := [path for path in found if (path / "programs").is_dir()]):
        print(f"{given or ROOT / 'build/*/written_proofs'}: nothing is written there: ./dev build proofs write_proofs writes it", file=sys.stderr)
        sys.exit(2)
    return max(written, key=lambda path: (path / "programs").stat().st_mtime_ns).resolve()
