#!/usr/bin/env python3
"""--kernel program:MANIFEST.json: programs in any language as kernels, wherever a plug-in can be one."""
import hashlib
import json
import os
import shutil
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

from command import BUILD, DIVISOR, QUERY, ROOT, Case, axiscert, family

EXAMPLES = ROOT / "examples/pipe"
QUICK = ("--plugin-seconds", "0.5")
COMPILERS = {"published_c.json": ["cc", "-std=c99", "-O2", "-ffp-contract=off", "-o", "published", "published.c"],
             "published_rust.json": ["rustc", "--edition", "2021", "-O", "-o", "published_rust", "published.rs"],
             "published_go.json": ["go", "build", "-o", "published_go", "published.go"],
             "published_node.json": ["node", "--check", "published.mjs"]}


def without_id(record):
    """A record without what tells a program from the plug-in that answers the same."""
    del record["plan"]["kernels"], record["plan"]["files"]
    for kernel in record["kernels"]:
        for member in ("id", "name", "digest", "summary"):
            del kernel[member]
    for part in record["witnesses"] + record.get("findings", []):
        part.pop("id", None), part.pop("kernel", None)
    return record


def without_errors(family):
    """A family's results without those that only a kernel has that shows its sides."""
    for part in (*family["axes"].values(), *family["comparisons"].values()):
        for member in ("max_error_u", "smallest_passing_tolerance", "range_events", "error_without_scale"):
            part.pop(member, None)
    return family


def written(folder, command, file="m.json", **more):
    """The id of a program whose manifest is written to the folder."""
    members = {"format": "axiscert-program/2", "name": "tested", "command": command, "precisions": ["binary32"], **more}
    (folder / file).write_text(json.dumps(members))
    return f"program:{folder / file}"


class Programs(Case):
    def setUp(self):
        super().setUp()
        shutil.copy(BUILD / "programs/program", self.folder)

    def tearDown(self):
        self.come_to(lambda left: not left, "no process is left")

    def processes(self):
        """The commands of the processes that run in this test's folder."""
        found = []
        for process in Path("/proc").glob("[0-9]*"):
            try:
                if Path(os.readlink(process / "cwd")) == self.folder.resolve():
                    found.append((process / "cmdline").read_text())
            except OSError:
                pass
        return found

    def come_to(self, holds, what):
        """Waits until it holds of the processes. A process that has been killed may be there for a moment longer."""
        until = time.monotonic() + 60
        while not holds(found := self.processes()):
            self.assertLess(time.monotonic(), until, f"{what}: {found}")
            time.sleep(0.02)

    def manifest(self, *command, file="m.json", **more):
        return written(self.folder, command, file, **more)

    def plugin(self, real):
        """A plug-in of published verdicts alone."""
        source = self.folder / f"published-{real}.c"
        source.write_text(f"""#include "kernel/include/axiscert/plugin.h"
#define real {real}
#define OF_REAL(name) name
#include "kernel/sphere_triangle/faults/published_test.h"
static int one(const real a[3], const real b[3], const real c[3], const real p[3], real r) {{
  uint64_t bits;
  return published(a, b, c, p, r, &bits);
}}
AXISCERT_PLUGIN({real}, "published", one)
""")
        plugin = source.with_suffix(".so")
        subprocess.run(["cc", "-O2", "-ffp-contract=off", "-shared", "-fPIC", f"-I{ROOT}", source, "-o", plugin], check=True)
        return f"plugin:{plugin}"

    def test_programs_in_c_and_python_have_the_record_of_the_plugin_that_answers_the_same(self):
        shutil.copy(EXAMPLES / "published.py", self.folder)  # whose comparisons this manifest leaves unread
        for command, real, precision in ((["./program"], "float", "binary32"), (["./program", "once"], "float", "binary32"),
                                         ([sys.executable, "published.py"], "double", "binary64")):
            plan = ("--family", "tie", "--family", "scale", "--trials", "3000", "--precision", precision)
            program = self.run_ok("--kernel", self.manifest(*command, precisions=[precision]), *plan)
            self.assertEqual(program["findings"], [])
            self.assertEqual(without_id(program), without_id(self.run_ok("--kernel", self.plugin(real), *plan)), command)

    def test_programs_of_the_examples_have_the_record_of_the_built_in_kernel(self):
        """In each language whose compiler is here. They claim to conform, and all but one show comparisons."""
        for name, command in COMPILERS.items():
            with self.subTest(name):
                if not shutil.which(command[0]):
                    self.skipTest(f"{command[0]} is not installed")
                manifest = json.loads(Path(shutil.copy(EXAMPLES / name, self.folder)).read_text())
                shutil.copy(EXAMPLES / command[-1], self.folder)
                subprocess.run(command, cwd=self.folder, check=True)
                mine = f"program:{self.folder / name}"
                for precision in manifest["precisions"]:
                    record = self.run_ok("--kernel", mine, "--kernel", "published", "--family", "sliver", "--trials", "3000",
                                         "--precision", precision)
                    ours, own = (family(record, "sliver", precision, kernel) for kernel in (mine, "published"))
                    self.assertEqual(ours.pop("asked_again"), 1024)
                    if "exposes" in manifest:
                        self.assertEqual(without_errors(ours), without_errors(own))
                    self.assertEqual(ours["verdict"], own["verdict"])
                    self.assertEqual(record["findings"], [])
                    links = [flip["links"] for w in record["witnesses"] for flip in w["flips"]]
                    self.assertFalse(any("implementation" in each for each in links))

    def test_a_template_answers_another_question_by_the_names_of_its_columns(self):
        """The box of a triangle in the place of the triangle: no contact is missed, and some are invented."""
        apart = {"py": "    return np.any([(np.minimum(np.minimum(q['a' + k], q['b' + k]), q['c' + k]) > q['box.max' + k]) |\n"
                       "                   (np.maximum(np.maximum(q['a' + k], q['b' + k]), q['c' + k]) < q['box.min' + k]) for k in 'xyz'], axis=0), []\n",
                 "mjs": "  return ['x', 'y', 'z'].some((k) => Math.min(q['a' + k], q['b' + k], q['c' + k]) > q['box.max' + k] ||\n"
                        "    Math.max(q['a' + k], q['b' + k], q['c' + k]) < q['box.min' + k]);\n"}
        for kind, interpreter in (("py", sys.executable), ("mjs", "node")):
            with self.subTest(kind):
                if not shutil.which(interpreter):
                    self.skipTest(f"{interpreter} is not installed")
                text = (EXAMPLES / f"published.{kind}").read_text()
                # The beginning of the function goes before its own, which is not reached.
                for old, new in (("sphere-triangle", "box-triangle"), ("vertices", "minmax"), ("ax ay az bx by bz cx cy cz px py pz r", "box.minx box.miny box.minz "
                                  "box.maxx box.maxy box.maxz ax ay az bx by bz cx cy cz"), ("separated(q):\n", f"separated(q):\n{apart['py']}"),
                                 ("separated(q) {\n", f"separated(q) {{\n{apart['mjs']}")):
                    text = text.replace(old, new)
                (self.folder / f"mine.{kind}").write_text(text)
                mine = self.manifest(interpreter, f"mine.{kind}", predicate="box-triangle", entry="minmax")
                record = self.run_ok("--kernel", mine, "--family", "box-triangle/lattice_minmax", "--trials", "500", "--precision", "binary32")
                verdict = family(record, "box-triangle/lattice_minmax", kernel=mine)["verdict"]
                self.assertEqual((verdict["false_separation"], record["findings"]), (0, []))
                self.assertGreater(verdict["false_contact"], 0)
                mine = self.manifest(interpreter, f"mine.{kind}", predicate="box-triangle", entry="centre")
                done = axiscert("run", "--kernel", mine, "--family", "box-triangle/lattice", "--trials", "5", "--precision", "binary32", "--out", self.folder / "out")
                self.assertIn("the stream asks box-triangle, entry centre; this program answers box-triangle, entry minmax", done.stderr)

    def test_a_program_is_known_by_its_name_and_by_the_digests_of_its_files(self):
        (self.folder / "package-lock.json").write_text("{}\n")
        (self.folder / "table.txt").write_text("what the program reads\n")
        id = self.manifest("./program", "right", files=["table.txt"])
        record = self.run_ok("--kernel", id, "--family", "general", "--trials", "100")
        (kernel,) = record["kernels"]
        self.assertEqual(kernel["name"], "tested")
        files = {"manifest": "m.json", "program": "program", "file": "table.txt", "lock": "package-lock.json"}
        self.assertEqual(kernel["digest"], [{"kind": kind, "sha256": hashlib.sha256((self.folder / name).read_bytes()).hexdigest()}
                                            for kind, name in files.items()])
        self.assertEqual([(file["kind"], file["name"]) for file in record["plan"]["files"]], list(files.items()))
        # Another name of the manifest is the same kernel; another lock file is a change.
        (self.folder / "package-lock.json").write_text("{ }\n")
        (self.folder / "other").mkdir()
        moved = self.manifest("./program", "right", file="n.json", files=["table.txt"])
        self.run_ok("--kernel", moved, "--family", "general", "--trials", "100", out="new")
        done = axiscert("compare", self.folder / "out", self.folder / "new", "--kernel", moved)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("its lock was SHA-256", done.stdout)
        self.assertNotIn("its program was", done.stdout)
        gone = self.manifest("./program", "right", file="gone.json", files=["table.txt", "nosuch.txt"])
        self.refused("run", "--kernel", gone, says=["gone.json: \"files\": 'nosuch.txt' is not the name of a file"])

    def test_no_program_that_a_record_names_is_started_unasked(self):
        id = self.manifest("/bin/sh", "-c", "echo x >> started; exec ./program")
        self.run_ok("--kernel", id, "--family", "scale", "--trials", "500")
        (self.folder / "started").unlink()
        axiscert("kernels", "--kernel", id)
        done = axiscert("compare", self.folder / "out", self.folder / "out")
        self.assertFalse((self.folder / "started").exists())
        self.assertIn("a program that a record names is started only with --kernel", done.stdout + (done.stderr or ""))

    def test_programs_that_misbehave_are_a_finding_each_and_the_run_goes_on(self):
        kinds = {"crash": "crash", "crash-1000": "crash", "spin": "hang", "too-little": "crash", "too-much": "inconsistent",
                 "garbage": "inconsistent", "nothing": "crash", "forks": "crash", "chatter-1000000": "crash",
                 "changes": "nondeterministic"}
        ids = {how: self.manifest("./program", how, file=f"{how}.json", name=how) for how in kinds}
        kernels = [part for id in ids.values() for part in ("--kernel", id)]
        plan = ("--family", "scale", "--trials", "2100", "--precision", "binary32", *QUICK)
        record = self.run_ok("--kernel", "published", *kernels, *plan, code=1)  # some gave no answer at all
        self.assertTrue(record["complete"])
        found = {(f["kernel"], f["kind"]) for f in record["findings"]}
        for how, kind in kinds.items():
            self.assertIn((ids[how], kind), found)
        for kernel in record["kernels"]:
            self.assertEqual(kernel["families"]["scale"]["trials"], 2100, kernel["id"])
        text = (self.folder / "out/report.md").read_text()
        for how in kinds:
            self.assertIn(how, text)
        self.assertIn("on standard error: the last word", json.dumps(record["findings"]))
        for id in ids.values():
            done = axiscert("run", "--kernel", id, *plan, "--require", "conservative=1", "--out", self.folder / "required")
            self.assertEqual(done.returncode, 1, id + done.stderr)
            break  # what a finding fails is not a matter of which

    def test_the_record_depends_on_neither_threads_nor_the_run(self):
        plan = ("--kernel", self.manifest("./program", "crash"), "--family", "scale", "--trials", str(70000 // DIVISOR),
                "--precision", "binary32")
        self.assertEqual(self.run_ok(*plan, "--threads", "1", out="one"), self.run_ok(*plan, "--threads", "2", out="two"))

    def test_wherever_a_plugin_can_be_a_program_can(self):
        id = self.manifest("./program")
        query = self.folder / "q.jsonl"
        query.write_text(QUERY % 1)
        checked = json.loads(axiscert("check", query, "--kernel", id, "--format", "jsonl").stdout)
        own = json.loads(axiscert("check", query, "--kernel", "published", "--format", "jsonl").stdout)
        self.assertEqual([flip["kind"] for flip in checked["flips"] if flip["level"] == "verdict"],
                         [flip["kind"] for flip in own["flips"] if flip["level"] == "verdict"])
        small = ("--family", "sliver", "--trials", "64", "--precision", "binary32")
        for command in (("critical-radius", "--kernel", id, *small), ("league", "--kernel", id, *small),
                        ("shrink", query, "--kernel", id, "--evaluations", "20"),
                        ("map", query, "--kernel", id, "--size", "8", "--out", self.folder / "map"),
                        ("search", "--kernel", id, "--evaluations", "2000", "--out", self.folder / "search")):
            done = axiscert(*command)
            self.assertIn(done.returncode, (0, 1), (command, done.stderr))

    def test_the_league_shows_a_manifests_code_with_the_numbers_of_the_worst_query(self):
        id = self.manifest("./program", code=["ask([{a}], {r});"], package="engine", version="1.2")
        done = axiscert("league", "--kernel", id, "--family", "tangent", "--family", "general", "--trials", "256", "--precision", "binary32",
                        "--out", self.folder / "league")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"binary32: may I trust it\?\n  kernel +resting +deepest miss\n  \S+ +no: [\d,]+ of 256 missed")
        self.assertRegex(done.stdout, r"binary32: It misses a contact .* deep, where r is .* With engine 1\.2:\n    ask\(\[.+, .+, .+\], .+\);\n")
        worst = json.loads((self.folder / "league/league.json").read_text())["kernels"][0]["worst"]
        self.assertEqual((worst["what"], worst["family"]), ("missed", "tangent"))
        self.assertIn(worst["code"].strip(), (self.folder / "league/league.html").read_text())
        given = [float(number) for number in worst["code"].strip()[5:-2].replace("]", "").split(", ")]
        self.assertEqual(given, [float.fromhex(number) for number in [*worst["query"]["a"], worst["query"]["r"]]])

    def test_what_cannot_be_a_program_is_one_clear_line(self):
        plan = ("--family", "general", "--trials", "10", "--out", self.folder / "out")
        (self.folder / "text.json").write_text("hello\n")
        cases = [(f"program:{self.folder}/nosuch.json", "there is no such file"),
                 (f"program:{self.folder}/text.json", "not a manifest: it is not JSON"),
                 (self.manifest("./program", format="axiscert-program/1"),
                  ".json: format 'axiscert-program/1', but this axiscert reads axiscert-program/2: write the manifest again as docs/plugins.md has it"),
                 ("program:", "no path after 'program:'"),
                 (str(self.folder / "text.json"), "with 'program:' before the path"),
                 (self.manifest("./nosuch", file="a.json"), "./nosuch is not there"),
                 (self.manifest("no-such-program-anywhere", file="b.json"), "no-such-program-anywhere is not installed"),
                 (self.manifest("./program", "fails", file="c.json"), "exit code 1; on standard error: Error: Cannot find package"),
                 (self.manifest("./program", file="d.json", precision="x"), "unknown member 'precision'"),
                 (self.manifest("./program", file="f.json", code=["ask({q});"]), "unknown place {q}; known: {ax}, {ay}"),
                 (self.manifest("./program", file="e.json", conforms_to="nosuch"), "not a built-in kernel")]
        for id, says in cases:
            done = self.refused("run", "--kernel", id, *plan, says=[says])
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)

    def test_nothing_is_left_of_a_program_whose_axiscert_is_killed(self):
        """A program that has started others, in sessions of their own, that ignore SIGTERM."""
        id = self.manifest("./program", "deaf")
        run = subprocess.Popen([BUILD / "axiscert", "run", "--kernel", id, "--family", "scale", "--precision", "binary32", "--trials",
                                "2000", "--plugin-seconds", "30", "--out", self.folder / "out"], stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
        self.addCleanup(run.kill)
        self.come_to(lambda found: len(found) >= 2, "the program and what it has started")
        run.send_signal(signal.SIGKILL)
        run.wait()  # and tearDown looks for what is left


class ProgramsLong(Case):
    def test_a_gigabyte_on_standard_error_fills_nothing(self):
        shutil.copy(BUILD / "programs/program", self.folder)
        id = written(self.folder, ["./program", "chatter-1000000000"])
        query = self.folder / "q.jsonl"
        query.write_text(QUERY % 2000)
        done = axiscert("check", query, "--kernel", id, "--plugin-seconds", "30")
        self.assertIn("the last word", done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
