#!/usr/bin/env python3
"""One form for every command: kernels, options that several commands have, help with examples that work."""
import functools
import os
import re
import shutil
import subprocess
import unittest

from command import BUILD, QUERY, ROOT, Case, axiscert

SHARED = ("kernel", "predicate", "family", "queries", "precision", "trials", "seed", "target", "out", "format", "quiet", "threads", "progress", "plugin-seconds")
SMALL = ("--family", "general", "--trials", 64, "--precision", "binary32")


def manual():
    """The lines of options and arguments of each command, from `axiscert man`."""
    sections = axiscert("man").stdout.replace("\\-", "-").split("\n.SH EXIT STATUS")[0].split("\n.SS ")[1:]
    return {section.splitlines()[0]: re.findall(r"^\.TP\n\.B (\S+)", section, re.M) for section in sections}


class KernelsGiven(Case):
    def test_every_command_that_takes_kernels_takes_them_both_ways(self):
        both = {command for command, entries in manual().items() if "--kernel" in entries}
        self.assertGreater(len(both), 15)
        self.assertEqual(both, {command for command, entries in manual().items() if "KERNEL" in entries})

    def test_they_may_be_mixed_and_keep_their_order(self):
        record = self.run_ok("nonstrict", "--kernel", "published", *SMALL, "certified", "--kernel=conservative")
        self.assertEqual(list(dict.fromkeys(kernel["id"] for kernel in record["kernels"])), ["nonstrict", "published", "certified", "conservative"])

    def test_the_same_is_judged_both_ways(self):
        for before, after in (([], []), (["--seed", 2], ["--trials", 32])):
            self.run_ok(*before, "--kernel", "nonstrict", "--family", "tie", *after, out="named")
            self.run_ok(*before, "nonstrict", "--family", "tie", *after, out="argument")
            self.assertEqual((self.folder / "named/record.json").read_bytes(), (self.folder / "argument/record.json").read_bytes())

    def test_beside_files_in_any_order(self):
        file = self.folder / "q.jsonl"
        file.write_text(QUERY % 1)
        for command in ("check", "shrink"):
            shown = {axiscert(command, *args).stdout for args in ((file, "published"), ("published", file), (file, "--kernel", "published"),
                                                                  ("--kernel", "published", file), ("--kernel", "published", "--format", "text", file))}
            self.assertEqual(len(shown), 1, command)
            self.assertIn("published", shown.pop())
        self.run_ok(*SMALL, out="old")
        self.assertEqual(axiscert("compare", self.folder / "old", self.folder / "old", f"plugin:{BUILD}/faults/none.so").returncode, 2)

    def test_an_unknown_one_is_told_alike(self):
        for command in ("run", "check", "diagnose", "search", "kernels", "ladder", "critical-radius", "league", "certify", "plan"):
            file = ("-",) if command == "check" else ()
            with self.subTest(command=command):
                told = {self.refused(command, *file, *args, stdin=QUERY % 1, says=["unknown kernel 'publishd'; did you mean 'published'?"]).stderr
                        for args in (("publishd",), ("--kernel", "publishd"))}
                self.assertEqual(len(told), 1, told)

    def test_one_is_enough_for_a_command_that_takes_one(self):
        for given in (("published", "nonstrict"), ("published", "--kernel", "nonstrict")):
            self.refused("diagnose", *given, says=["axiscert diagnose: --kernel is given 2 times (published, nonstrict); give it once"])


class OneDeclaration(unittest.TestCase):
    def places(self, text_of):
        found = {name: [] for name in SHARED}
        for path, text in text_of.items():
            for name in re.findall(r"add_(?:option|flag)(?:_function<[^(]*>)?\(\s*\"(?:-\w,)?--([a-z-]+)\"", text):
                if name in found:
                    found[name].append(path)
        return found

    def test_a_name_is_declared_in_one_place(self):
        sources = {str(path.relative_to(ROOT)): path.read_text() for path in (ROOT / "cli").rglob("*.cpp") if "tests" not in path.parts}
        # The file in which an address is, of which there is one; and the one file of each kind that replies are of.
        others = {"queries": ["cli/shared_options.cpp", "cli/reply_plan.cpp"], "trials": ["cli/shared_options.cpp"]}
        for name, places in self.places(sources).items():
            for one in others.get(name, []):
                places.remove(one)
            self.assertEqual(len(places), 1, f"--{name}: {places}")

    def test_a_second_is_seen(self):
        found = self.places({"a.cpp": 'add_option("--seed", x)', "b.cpp": 'command.add_option_function<std::string>(\n      "--seed", f)', "c.cpp": 'add_option("-o,--out", x)'})
        self.assertEqual((found["seed"], found["out"]), (["a.cpp", "b.cpp"], ["c.cpp"]))


class Names(Case):
    def test_families_by_a_pattern(self):
        record = self.run_ok("--family", "scene-*", "--family", "tie", "--trials", 64, "--precision", "binary32")
        self.assertGreater(len(record["plan"]["families"]), 2)
        self.assertEqual({name.split("-")[0] for name in record["plan"]["families"]}, {"scene", "tie"})

    def test_what_matches_nothing_is_told_the_nearest(self):
        file = self.folder / "q.jsonl"
        file.write_text(QUERY % 1)
        for command in ("run", "plan", "generate", "ladder", "search", "mutate", "league", "critical-radius"):
            for given, says in (("tangnet", "did you mean 'tangent'?"), ("tangnt*", "families: tangent, "), ("nothing-*", "unknown family 'nothing-*'")):
                self.refused(command, "--family", given, says=["--family: unknown family", says])
        for command in ("run", "search", "check 1:tangent:2:binary32:0:0-1 --format csv", "mutate --list", "mutate certified --list", "prove", "diagnose published",
                        "map -", "shrink -", "generate"):
            self.refused(*command.split(), "--precision", "binray32", says=["--precision: unknown precision 'binray32'; did you mean 'binary32'?"])
        for args, says in ((["map", file, "--id", "p"], "--id p: unknown; of the 1 ids of"),
                           (["corpus", "add", file, "--name", "n", "--provenance", "adress:x"], "unknown kind 'adress'; did you mean 'address'?"),
                           (["corpus", "add", file, "--name", "n", "--provenance", "report:x", "--about", "swep"], "did you mean 'sweep'?"),
                           (["run", *SMALL, "--source", "publishd=x.c:3", "--out", self.folder / "o"], "with a kernel of this run: published"),
                           (["explain", "--schema", "recrd"], "did you mean 'record'?")):
            self.refused(*args, says=[says])


@functools.cache
def help_of(command, columns):
    environment = {key: value for key, value in os.environ.items() if key != "COLUMNS"} | ({"COLUMNS": str(columns)} if columns else {})
    done = subprocess.run([BUILD / "axiscert", *command.split(), "--help"], capture_output=True, text=True, timeout=60, env=environment)
    assert done.returncode == 0, done.stderr
    return done.stdout


def too_long(text, columns):
    """The lines that could have been broken at a word, and are longer."""
    return [line for line in text.split("\n") if len(line) > columns and any(" " in cell for cell in re.split(" {2,}", line.strip()))]


def examples_in(text):
    """The lines of the examples in a help, each as one."""
    block = text.split("\nExamples:\n")[1].split("\n\n")[0].replace(" \\\n", " ")
    return [" ".join(line.split()) for line in block.split("\n") if not line.startswith(("  # ", "    "))]


class HelpOfCommands(Case):
    # Longer than some seconds, or with a key, a program or replies of one's own.
    SLOW = re.compile(r"effort standard|signing|resume|recheck|certify|my_program|replies|search published --time|prove|--out (league|ladder|condition|precision)|verdict-only"
                      r"|SHA256|verify|merge")

    def test_lines_are_no_longer_than_the_terminal(self):
        commands = ["", *manual()]
        self.assertGreater(len(commands), 25)
        for command in commands:
            for columns in (None, 60, 300):
                text = help_of(command, columns)
                self.assertEqual(too_long(text, columns if columns == 60 else 100), [], command)
                self.assertGreater(max(map(len, text.split("\n"))), 50 if columns == 60 else 70, command)

    def test_a_long_line_is_seen(self):
        self.assertEqual(too_long("a bc\nabcdef", 3), ["a bc"])

    def test_options_stand_in_groups(self):
        text = help_of("run", None)
        places = [text.index(f"\n{head}:\n") for head in ("Examples", "Options", "Kernels and queries", "What has to hold", "Output", "How it runs")]
        self.assertEqual(places[:2], sorted(places)[:2])
        self.assertLess(text.index("Kernels and queries:"), text.index("\n  --family"))

    def test_the_fast_examples_run(self):
        (self.folder / "mine.jsonl").write_text(QUERY % 1)
        shutil.copy(BUILD / "faults/none.so", self.folder / "my_kernel.so")
        (self.folder / "corpus").mkdir()
        few = {"league": "--no-engines", "shrink": "--evaluations 20", "run": "--trials 32"}  # engines take minutes where they are installed
        def run(line):
            arguments = re.sub(r"--trials \d+", "--trials 32", line.split(" > ")[0]).split()[1:]
            more = few.get(arguments[0], "").split()
            if more and more[0] not in arguments:
                arguments += more
            return subprocess.run([BUILD / "axiscert", *arguments], cwd=self.folder, capture_output=True, text=True, timeout=300)

        ran = 0
        for command in manual():
            for line in examples_in(help_of(command, None)):
                self.assertTrue(line.startswith("axiscert "), line)
                if self.SLOW.search(line):
                    continue
                if command in ("compare", "report", "shrink"):
                    for out in ("out", "out-before"):
                        self.assertEqual(run(f"axiscert run plugin:./my_kernel.so --family repeated --trials 300 --out {out}").returncode, 0)
                with self.subTest(line=line):
                    done = run(line)
                    # The kernel is the published test, which does not meet every level.
                    self.assertIn(done.returncode, (0, 1) if "--require" in line else (0,), done.stderr)
                    ran += 1
        self.assertGreater(ran, 40)

    def test_the_manual_page_has_them(self):
        page = axiscert("man").stdout.replace("\\-", "-").replace("\\e", "\\")
        for command in manual():
            for line in examples_in(help_of(command, None)):
                self.assertIn(f"\n.nf\n{line}\n.fi\n", page)


if __name__ == "__main__":
    unittest.main()
