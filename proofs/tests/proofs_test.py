"""proofs_test.py WRITTEN SUITE: the scripts and ranges that write_proofs wrote are accepted, and wrong ones are refused."""
import os
import re
import shutil
import subprocess
import sys
import tempfile

written, suite = sys.argv[1:3]
# Ranges.v, on which the written ranges rest.
THEORY = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "coq", "formulae", "Ranges.v")


def scripts(pattern):
    found = []
    for where, _, names in os.walk(os.path.join(written, "gappa")):
        found += [os.path.join(where, name) for name in names]
    found = sorted(path for path in found if re.search(pattern, path))
    assert found, f"no script like {pattern}"
    return found


def accepted(text, seconds=600):
    """Whether Gappa proves a script. A script that it cannot read is an error of the test."""
    run = subprocess.run(["gappa"], input=text, capture_output=True, text=True, timeout=seconds)
    assert "syntax error" not in run.stderr, run.stderr
    return run.returncode == 0


def read(path):
    with open(path) as file:
        return file.read()


def proved(text):
    """Whether Gappa proves a script, in several attempts: its search depends on memory addresses, and on one script of
    176 about every seventh run fails, after minutes."""
    for seconds in (60, 60, 60, 600):
        try:
            if accepted(text, seconds):
                return True
        except subprocess.TimeoutExpired:
            pass
    return False


def require(paths):
    for path in paths:
        assert proved(read(path)), f"{path}: Gappa does not prove the bound"
    print(f"{len(paths)} bounds accepted")


def planted():
    """Plants each fault in one place of a script that is accepted without it: the shortest, since a vain search of
    Gappa takes long."""
    path = scripts(r"binary32/scaled/published_plain_vertex_a_radius")[0]
    text = read(path)
    assert accepted(text), path
    goal = re.search(r"<= (\d+)b-28\n\}", text)
    halved = text[: goal.start(1)] + str(int(goal.group(1)) // 2) + text[goal.end(1) :]
    faults = {
        "a bound halved": halved,
        "a wrong coefficient": text.replace("Mlhs = ", "Mlhs = 2 * "),
        "a swapped comparison": text.replace("(lhs - rhs)", "(rhs - lhs)"),
        "a coarser rounding": text.replace("float<24,", "float<23,"),
    }
    for fault, wrong in faults.items():
        assert wrong != text, fault
        assert not accepted(wrong), f"{fault}: Gappa accepts {path}"


def coq(work):
    for path in (THEORY, os.path.join(written, "ranges", "RangesClaimed.v")):
        shutil.copy(path, work)
        subprocess.run(["coqc", "-Q", ".", "Axiscert", os.path.basename(path)], cwd=work, check=True)


def ranges():
    with tempfile.TemporaryDirectory() as work:
        coq(work)
        claimed = read(os.path.join(work, "RangesClaimed.v"))
        names = re.findall(r"^Theorem (\w+)", claimed, re.M)
        with open(os.path.join(work, "Assumptions.v"), "w") as file:
            file.write("From Axiscert Require Import RangesClaimed.\n")
            file.writelines(f"Print Assumptions {name}.\n" for name in names)
        run = subprocess.run(["coqc", "-Q", ".", "Axiscert", "Assumptions.v"], cwd=work, check=True, capture_output=True,
                             text=True)
        # The axioms of Coq's Reals, and no others.
        axioms = set(re.findall(r"^(\S+) :", run.stdout, re.M)) - {"Axioms"}
        known = {"ClassicalDedekindReals.sig_forall_dec", "ClassicalDedekindReals.sig_not_dec",
                 "FunctionalExtensionality.functional_extensionality_dep", "Classical_Prop.classic"}
        assert axioms <= known, axioms - known
        # A range that is too narrow.
        narrow = claimed.replace("-4 <= exact_V_x", "-3 <= exact_V_x")
        assert narrow != claimed
        with open(os.path.join(work, "RangesClaimed.v"), "w") as file:
            file.write(narrow)
        run = subprocess.run(["coqc", "-Q", ".", "Axiscert", "RangesClaimed.v"], cwd=work, capture_output=True, text=True)
        assert run.returncode != 0 and "RangesClaimed.v" in run.stderr, "a range too narrow is accepted"


def certificates(pattern):
    """Gappa's certificates, checked by Coq."""
    for path in scripts(pattern):
        with tempfile.TemporaryDirectory() as work:
            certificate = subprocess.run(["gappa", "-Bcoq"], input=read(path), capture_output=True, text=True, check=True)
            with open(os.path.join(work, "certificate.v"), "w") as file:
                file.write(certificate.stdout)
            subprocess.run(["coqc", "certificate.v"], cwd=work, check=True, stdout=subprocess.DEVNULL)
            print(os.path.basename(path), "certificate accepted")


{
    "Scripts": lambda: require(scripts(r"scaled/\w+_plain_(plane|vertex_a|edge_ab)")),
    "Planted": planted,
    "AllScripts": lambda: require(scripts("")),
    "Ranges": ranges,
    "Certificates": lambda: certificates(r"binary32/scaled/(published_plain_vertex_a_(radius|side_b)|reduced_plain_edge_ab_radius)\.g$"),
    # One certificate of each kind.
    "AllCertificates": lambda: certificates(
        r"binary32/scaled/(published_plain_(plane_radius|edge_ab_\w+)|reduced_plain_edge_ab_side_c)\.g$"),
}[suite]()
