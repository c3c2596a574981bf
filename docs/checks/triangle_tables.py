"""The parts of which readme_test.py makes its tables, and the tables of sphere-triangle."""
import json
import re
import subprocess
import tempfile
from pathlib import Path

MESHES = ("OBJ/spider.obj", "PLY/Wuson.ply", "STL/sphereWithHole.stl")


class Commands:
    """Runs each command once."""

    def __init__(self, axiscert, models):
        self.axiscert, self.models, self.done = axiscert, models, {}

    def run(self, *words):
        """The output of `axiscert run WORDS`, its record and its report.md."""
        if words not in self.done:
            with tempfile.TemporaryDirectory() as folder:
                text = self.text("run", *words, "--out", folder)
                self.done[words] = (text, json.loads((Path(folder) / "record.json").read_text()), (Path(folder) / "report.md").read_text())
        return self.done[words]

    def text(self, *words):
        """The output of `axiscert WORDS`. Where it fails, as it does on a peer that is not built, so does the check, in its words."""
        result = subprocess.run([self.axiscert, *map(str, words)], text=True, capture_output=True)
        if result.returncode:
            raise AssertionError(f"`axiscert {' '.join(map(str, words))}` ends with {result.returncode}:\n{result.stderr}")
        return result.stdout


def thousands(number):
    return f"{number:,}"


def options(name, values):
    return [word for value in values for word in (name, value)]


def cells_of(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def row_of(cells):
    return "| " + " | ".join(cells) + " |\n"


def short(depth):
    return re.sub(r"e-0", "e-", f"{depth:.2g}")


def with_rows(old, rows):
    return "".join(old.splitlines(keepends=True)[:2]) + "".join(map(row_of, rows))


# ---- README.md

FRONT_KERNELS = {"published": "the published test", "peer/bullet": "Bullet 3.24", "peer/ode": "ODE 0.16.2",
                 "reduced-along-nonstrict": "`reduced-along-nonstrict`", "certified": "**libaxiscert**"}
FRONT_FAMILIES = {"scene-walk": "a character rests on a floor, in metres", "far": "far from the origin", "sliver": "thin triangles",
                  "repeated": "triangles with two equal vertices"}


def front(commands, old):
    _, record, _ = commands.run(*options("--kernel", FRONT_KERNELS), "--precision", "binary32", "--trials", "65536",
                                *options("--family", FRONT_FAMILIES))
    lines = row_of(["", *FRONT_FAMILIES.values(), "deepest miss"]) + "|---|" + "---:|" * (len(FRONT_FAMILIES) + 1) + "\n"
    for kernel in record["kernels"]:
        verdicts = [kernel["families"][family]["verdict"] for family in FRONT_FAMILIES]
        deepest = max(verdict["deepest_false_separation"] for verdict in verdicts)
        lines += row_of([FRONT_KERNELS[kernel["id"]],
                         *(f"{thousands(v['false_separation'])} / {thousands(v['false_contact'])}" for v in verdicts), f"{deepest:.2g}"])
    return lines


# ---- docs/main-job.md

def main_job_run(commands):
    return commands.run("--kernel", "published", "--kernel", "nonstrict", "--family", "all",
                        *options("--mesh", (str(Path(commands.models) / mesh) for mesh in MESHES)))


def main_job(commands, old):
    return "```\n$ ./dev run\n" + "".join(main_job_run(commands)[0].splitlines(keepends=True)[:5]) + "```\n"


def main_job_rows(commands, old):
    report, rows = main_job_run(commands)[2], {}
    section = report[report.index("## Kernels and families"):].split("\n## ", 1)[0]
    for line in section.splitlines():
        if not line.startswith("| ") or line.startswith(("| kernel |", "| --- |")):
            continue
        kernel, precision, family, links, trials, _, _, _, _, missed, deepest, phantom, deepest_phantom, *_ = cells_of(line)
        if precision == "binary32":
            rows[kernel, family] = (trials, missed, deepest, phantom, deepest_phantom, links)
    lines = old.splitlines(keepends=True)
    return "".join(lines[:2]) + "".join(row_of([*cells_of(line)[:2], *rows[tuple(cells_of(line)[:2])]]) for line in lines[2:])


# ---- docs/bounds.md

def declined(commands, old):
    _, record, _ = commands.run("--kernel", "certified-filter", "--kernel", "certified-filter-published", "--family", "all", "--trials", "65536")

    def share(family, precision, kernel):
        (entry,) = [k for k in record["kernels"] if (k["id"], k["precision"]) == (kernel, precision)]
        verdict, trials = entry["families"][family]["verdict"], entry["families"][family]["trials"]
        assert not verdict["false_separation"] and not verdict["false_contact"], f"{kernel} is wrong on {family}"
        undecided = verdict["undecided"]
        percent = f"{100 * undecided / trials:.3g}"
        return "0" if undecided == 0 else "> 99.9 %" if percent == "100" and undecided < trials else f"{percent} %"

    lines = old.splitlines(keepends=True)
    return "".join(lines[:2]) + "".join(
        row_of([family, *(share(family, precision, kernel) for precision in ("binary32", "binary64")
                          for kernel in ("certified-filter", "certified-filter-published"))])
        for family in (cells_of(line)[0] for line in lines[2:]))


# ---- docs/search.md and docs/corpus.md

def shrunk(commands, old):
    def row(line):
        address = cells_of(line)[0]
        shown = commands.text("shrink", address)
        (bits, depth), (less, deeper) = [re.search(rf"\n  {when} +(\d+) bits in +\d+ numbers, (\S+) of the scene", shown).groups()
                                         for when in ("before", "after")]
        return row_of([address, f"{bits} to {less}", f"{float(depth):.3g} to {float(deeper):.3g}"])

    lines = old.splitlines(keepends=True)
    return "".join(lines[:2]) + "".join(row(line) for line in lines[2:])


# ---- docs/precision.md

def answered(commands, old):
    """Of the edge comparisons that `published` gets wrong, those that `reduced` gets right, and the other way round."""
    def row(line):
        family, seed, trials = (cell.strip("`").replace(",", "") for cell in cells_of(line)[:3])
        queries = commands.text("generate", "--family", family, "--trials", trials, "--seed", seed)
        wrong = {}
        for kernel in ("published", "reduced"):
            done = subprocess.run([commands.axiscert, "check", "-", "--kernel", kernel, "--format", "jsonl"], input=queries, text=True, capture_output=True)
            assert done.returncode == 0, done.stderr
            wrong[kernel] = {(found["id"], flip["name"]) for found in map(json.loads, done.stdout.splitlines()) for flip in found["flips"]
                             if flip["level"] == "comparison" and flip["name"].startswith("edge")}
        one, other = wrong["published"], wrong["reduced"]
        return row_of([*cells_of(line)[:3], f"{len(one):,}", f"{len(one - other):,}", f"{len(other):,}", f"{len(other - one):,}"])

    lines = old.splitlines(keepends=True)
    return "".join(lines[:2]) + "".join(map(row, lines[2:]))
