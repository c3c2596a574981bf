#!/usr/bin/env python3
"""The tables of README.md and docs/ that are made of a run's record: each is between `<!-- table: NAME -->` and `<!-- end -->`.

    readme_test.py AXISCERT MODELS quick|long     makes them and fails where a page says otherwise
    readme_test.py AXISCERT MODELS --write [NAME...]    puts what the commands give now into the pages

The commands are those that stand with the tables, and in the function of each: of sphere-triangle in triangle_tables.py, of other predicates here. The
rows of a table are those that the page has.
"""
import json
import math
import re
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction
from pathlib import Path

from triangle_tables import answered, cells_of, Commands, declined, front, main_job, main_job_rows, options, row_of, short, shrunk, with_rows

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "kernel/peers/npm"))
import exact  # noqa: E402


# ---- docs/moving.md

SWEEPS = ("general huge_d", "approach", "line_sweep repeated_sweep")


def sweeps(commands, old):
    """Rows of engines from npm stay where the engine is not installed."""
    known = commands.text("kernels", "--predicate", "moving-sphere")

    def row(line):
        name = cells_of(line)[0].strip("`")
        kernel = name if name.startswith("moving-sphere/") else "moving-sphere/peer/" + name
        if not re.search(rf"^{re.escape(kernel)} +(?!NOT)", known, re.M):
            return line
        record = commands.run("--predicate", "moving-sphere", "--precision", "binary32", "--trials", "1000", "--kernel", kernel)[1]
        families = {family.split("/")[-1]: result["verdict"] for family, result in record["kernels"][0]["families"].items()}

        def cell(group):
            missed, phantom, declined = (sum(families[family][member] or 0 for family in group.split())
                                         for member in ("false_separation", "false_contact", "undecided"))
            return f"{missed:,} / {phantom:,}" + (f" / {declined:,}" if declined else "")

        return row_of([cells_of(line)[0], *map(cell, SWEEPS)])

    lines = old.splitlines(keepends=True)
    return "".join(lines[:2]) + "".join(row(line) for line in lines[2:])


START_FAMILIES = "general overlap_ulp lattice zero_d tiny_d slide along_edge line_sweep".split()
STARTS = ("still", "leaves", "approaches", "parallel")


def start_of(query, answer):
    """The column of a motion in contact, one of STARTS: how an overlap begins, from the distance at 0 and after 2^-60 of D; or that it begins clear
    of a triangle with area and goes parallel to its plane, and does not just touch. Nothing for all others."""
    number = lambda x: Fraction(float.fromhex(x) if isinstance(x, str) else x)
    points, (centre, way) = [list(map(number, query[name])) for name in "abc"], (list(map(number, query[name])) for name in "pd")
    if answer["start"] == "overlap":
        if not any(way):
            return "still"
        now, then = (exact.squared_distance([*sum(points, []), *(p + time * d for p, d in zip(centre, way))]) for time in (Fraction(0), Fraction(1, 2 ** 60)))
        return "leaves" if then > now else "approaches" if then < now else None
    normal = exact.cross(exact.minus(points[1], points[0]), exact.minus(points[2], points[0]))
    is_parallel = any(normal) and any(way) and exact.dot(normal, way) == 0
    return "parallel" if is_parallel and answer["start"] == "clear" and not answer["touching"] else None


def starts(commands, old):
    """Of the motions in contact, by how they begin: how many a peer misses of those that it answers. Rows of engines that are not installed stay."""
    known = commands.text("kernels", "--predicate", "moving-sphere")
    queries = commands.text("generate", *options("--family", ["moving-sphere/" + name for name in START_FAMILIES]), "--trials", "100", "--seed", "2")
    columns = {}

    def row(line):
        kernel = "moving-sphere/peer/" + cells_of(line)[0].strip("`")
        if not re.search(rf"^{re.escape(kernel)} +(?!NOT)", known, re.M):
            return line
        done = subprocess.run([commands.axiscert, "check", "-", "--kernel", kernel, "--format", "jsonl"], input=queries, text=True, capture_output=True)
        assert done.returncode == 0, done.stderr
        counts = {column: [0, 0] for column in STARTS}
        for query, found in zip(map(json.loads, queries.splitlines()), map(json.loads, done.stdout.splitlines())):
            answer = found["computed"]["verdict"]
            if found["exact"]["verdict"] != "contact" or answer not in ("contact", "separated"):
                continue
            if query["id"] not in columns:
                columns[query["id"]] = start_of(query, found["exact"])
            if columns[query["id"]]:
                counts[columns[query["id"]]][0] += answer == "separated"
                counts[columns[query["id"]]][1] += 1
        return row_of([cells_of(line)[0], *(f"{missed} of {count}" if count else "declined" for missed, count in counts.values())])

    lines = old.splitlines(keepends=True)
    return "".join(lines[:2]) + "".join(map(row, lines[2:]))


def rapier_times(commands, old):
    """Late and early by how much of the way at most. The row stays where the engine is not installed."""
    kernel = "moving-sphere/peer/rapier/sweep"
    if not re.search(rf"^{kernel} +(?!NOT)", commands.text("kernels", "--predicate", "moving-sphere"), re.M):
        return old

    def row(line):
        family = cells_of(line)[0].strip("`")
        record = commands.run("--kernel", kernel, "--family", f"moving-sphere/{family}", "--trials", "2000", "--precision", "binary32", "--shrink", "0")[1]
        (time,) = (found["contacts"]["time"] for found in record["kernels"][0]["families"].values())
        return row_of([cells_of(line)[0], *(short(time[kind]["largest_share"]) for kind in ("early_errors", "late_errors"))])

    lines = old.splitlines(keepends=True)
    return "".join(lines[:2]) + "".join(map(row, lines[2:]))


# ---- docs/boxes.md

BOX_KERNELS = "textbook rtcd gottschalk bullet projected cofactor".split()
BOX_FAMILIES = "resting crossed parallel ramp beams corridor".split()
BOX_PEERS = "ode ode-unimportant fcl-obb bullet libccd-gjk libccd-mpr mujoco dart".split()
BOX_PEER_FAMILIES = "lattice resting crossed parallel flat".split()


def missed_and_phantom(verdict):
    """What was declined follows where there was some."""

    def count_and_depth(kind):
        return f"{verdict[kind]} ({short(verdict['deepest_' + kind])})" if verdict[kind] else "0"

    declined = f" / {verdict['undecided']}" if verdict["undecided"] else ""
    return f"{count_and_depth('false_separation')} / {count_and_depth('false_contact')}{declined}"


def by_kernel(predicate, prefix, kernels, families, trials):
    """A row for each kernel, a column for each family."""

    def table(commands, old):
        ids, names = ([f"{predicate}/{part}{one}" for one in all] for part, all in ((prefix, kernels), ("", families)))
        record = commands.run(*options("--kernel", ids), *options("--family", names), "--trials", trials, "--precision", "binary32")[1]
        found = {kernel["id"]: kernel["families"] for kernel in record["kernels"]}
        return with_rows(old, [[f"`{kernel}`", *(missed_and_phantom(found[id][name]["verdict"]) for name in names)] for kernel, id in zip(kernels, ids)])

    return table


CELL_KERNELS = "textbook-minmax thirteen-minmax peer/cgal-epick peer/cgal-double".split()
CELL_FAMILIES = "touching_minmax terrain_minmax ramp_minmax level_voxel_minmax voxel".split()
BOX_ENTRIES = {"matrix": "", "quaternion": "_turned"}  # the families of each entry end so
CELL_ENTRIES = {"centre": "", "minmax": "_minmax", "matrix": "_oriented"}


def engines(predicate, ends, trials):
    """A row for each engine from npm: missed (deepest) / phantom (deepest) / declined. Where it is not installed its row stays."""

    def table(commands, old):
        known = commands.text("kernels", "--predicate", predicate)
        lines = old.splitlines(keepends=True)
        columns = [column.strip("`") for column in cells_of(lines[0])[2:]]

        def row(line):
            name, entry, *_ = cells_of(line)
            kernel = f"{predicate}/peer/" + name.strip("`")
            if not re.search(rf"^{re.escape(kernel)} +(?!NOT)", known, re.M):
                return line
            record = commands.run("--predicate", predicate, "--kernel", kernel, "--trials", trials, "--precision", "binary32")[1]
            found = {family.split("/")[-1]: result["verdict"] for family, result in record["kernels"][0]["families"].items()}

            def cell(family):
                return missed_and_phantom(found[family]) if family in found else ""

            return row_of([name, entry, *(cell(column + ends[entry]) for column in columns)])

        return "".join(lines[:2]) + "".join(row(line) for line in lines[2:])

    return table


# ---- docs/contacts.md

def contact_row(kernel, families):
    """The figures of `league --contacts` over all families: sums of counts, and the greatest of each error; lengths of scenes alone."""
    parts = {name: found["contacts"] for name, found in families.items() if found["contacts"]}

    def of(part, member, join=max, only=lambda _: True):
        found = [contacts[part][member] for name, contacts in parts.items() if contacts.get(part) and only(name)]
        found = [one for one in found if one is not None]
        return join(found) if found else None

    def pair(part, member, factor=1.0):
        """Of scenes, and of all."""
        most = of(part, member)
        return "" if most is None else ", ".join(re.sub("e([-+])0", r"e\1", f"{factor * x:.3g}") for x in (of(part, member, only=scene), most))

    scene = lambda name: name.startswith("scene-")  # noqa: E731
    length, most = of("separation", "largest_length", only=scene), of("separation", "largest_error")
    flips, pushed, left = of("pushed", "flips", sum), of("pushed", "judged", sum), of("pushed", "largest_left")
    positive = of("consistency", "positive", sum)
    return [f"`{kernel}`", f"{sum(one['answers'] for one in parts.values()):,}",
            "" if most is None else f"{metres(length)}, {short(most)}", "" if positive is None else f"{positive:,}",
            "" if flips is None else f"{flips:,} of {pushed:,}, {float(left):.2g}",
            pair("normal", "largest_angle", 180 / math.pi), pair("point", "largest_error")]


def metres(length):
    """With two digits, in the unit that leaves 1 to 1000 of them."""
    for unit, size in (("m", 1), ("mm", 1e-3), ("um", 1e-6), ("nm", 1e-9)):
        if length >= size or unit == "nm":
            return f"{float(f'{length / size:.2g}'):g} {unit}"


def contact_engines(commands, old):
    """A row for each library and engine; where it is not there its row stays."""
    known = commands.text("kernels")

    def row(line):
        kernel = "peer/" + (name := cells_of(line)[0].strip("`"))
        if not re.search(rf"^{re.escape(kernel)} +(?!NOT)", known, re.M):
            return line
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([commands.axiscert, "league", kernel, "--contacts", "--precision", "binary32", "--trials", "1024", "--out", folder],
                                  text=True, capture_output=True)
            assert done.returncode == 0, done.stderr
            (found,) = json.loads((Path(folder) / "league.json").read_text())["kernels"]
        return row_of(contact_row(name, found["families"]))

    lines = old.splitlines(keepends=True)
    return "".join(lines[:2]) + "".join(map(row, lines[2:]))


# The page, the function and whether a test that makes it again takes long.
TABLES = {
    "front": ("README.md", front, "quick"),
    "main-job": ("docs/main-job.md", main_job, "long"),
    "main-job-rows": ("docs/main-job.md", main_job_rows, "long"),
    "declined": ("docs/bounds.md", declined, "quick"),
    "answered": ("docs/precision.md", answered, "quick"),
    "sweeps": ("docs/moving.md", sweeps, "long"),
    "starts": ("docs/moving.md", starts, "long"),
    "rapier-times": ("docs/moving.md", rapier_times, "long"),
    "box-forms": ("docs/boxes.md", by_kernel("box-box", "", BOX_KERNELS, BOX_FAMILIES, "4096"), "long"),
    "box-peers": ("docs/boxes.md", by_kernel("box-box", "peer/", BOX_PEERS, BOX_PEER_FAMILIES, "300"), "long"),
    "box-triangle": ("docs/boxes.md", by_kernel("box-triangle", "", CELL_KERNELS, CELL_FAMILIES, "2000"), "long"),
    "box-engines": ("docs/boxes.md", engines("box-box", BOX_ENTRIES, "300"), "long"),
    "box-triangle-engines": ("docs/boxes.md", engines("box-triangle", CELL_ENTRIES, "300"), "long"),
    "contact-engines": ("docs/contacts.md", contact_engines, "long"),
    "shrunk": ("docs/corpus.md", shrunk, "quick"),
}


def place(name):
    return re.compile(rf"(?<=<!-- table: {name} -->\n).*?(?=<!-- end -->\n)", re.S)


def made_again(name, text, commands):
    """The page with the table as its command gives it now."""
    (old,) = place(name).findall(text)
    return place(name).sub(lambda _: TABLES[name][1](commands, old), text)


def stale_lines(name, text, commands):
    return [line for line in made_again(name, text, commands).splitlines() if line not in text.splitlines()]


class Tables(unittest.TestCase):
    def test_each_is_what_its_command_gives(self):
        commands = Commands(*ARGUMENTS)
        for name, (page, _, which) in TABLES.items():
            if which == WHICH:
                with self.subTest(name):
                    stale = stale_lines(name, (ROOT / page).read_text(), commands)
                    self.assertEqual(stale, [], f"{page} is stale: docs/checks/readme_test.py AXISCERT MODELS --write {name} puts these lines there")

    def test_a_planted_stale_number_is_seen(self):
        name = "declined"
        text = (ROOT / TABLES[name][0]).read_text()
        (table,) = place(name).findall(text)
        number = re.search(r"\d[\d,.]+(?= |$)", table.splitlines()[2])[0]
        planted = text.replace(table, table.replace(number, number[:-1] + str((int(number[-1]) + 1) % 10), 1))
        self.assertEqual(len(stale_lines(name, planted, Commands(*ARGUMENTS))), 1)


class Readme(unittest.TestCase):
    def test_it_is_one_page(self):
        self.assertLessEqual(len((ROOT / "README.md").read_text().splitlines()), 120)


if __name__ == "__main__":
    ARGUMENTS = [sys.argv.pop(1), sys.argv.pop(1)]
    WHICH = sys.argv.pop(1)
    if WHICH == "--write":
        commands = Commands(*ARGUMENTS)
        for name in sys.argv[1:] or TABLES:
            path = ROOT / TABLES[name][0]
            path.write_text(made_again(name, path.read_text(), commands))
    else:
        unittest.main()
