#!/usr/bin/env python3
"""Interrupts, full disks and lost shards: what was done is kept and said, with the command that goes on in the last line."""
import json
import os
import resource
import shlex
import signal
import subprocess
import time
import unittest

from command import BUILD, fewer
from plan_case import PlanCase

ENDLESS = str(1 << 34)  # queries: the interrupt comes long before


class EndingCase(PlanCase):
    families = ["general", "lattice", "scale"]

    def interrupted(self, *args, ready=None, which=signal.SIGINT, times=1):
        """Sends the signal once the command shows progress, and `ready` says that there is something to lose; returns what it printed."""
        errors = self.folder / "errors"
        with open(errors, "w", encoding="utf-8") as to:
            process = subprocess.Popen([BUILD / "axiscert", *map(str, args), "--progress", "0.05"], stdout=subprocess.PIPE, stderr=to, text=True)
        self.come_to(process, lambda: errors.stat().st_size > 0 and (ready is None or ready()))
        process.send_signal(which)
        if times == 2:
            self.come_to(process, lambda: "a second interrupt" in errors.read_text())
            process.send_signal(which)
        out, _ = process.communicate(timeout=120)
        err = errors.read_text()
        self.assertEqual(process.returncode, {signal.SIGINT: 130, signal.SIGTERM: 143}[which], err)
        return out, err

    @staticmethod
    def come_to(process, ready):
        end = time.monotonic() + 100
        while process.poll() is None and not ready() and time.monotonic() < end:
            time.sleep(0.01)

    def command_of(self, err):
        """The words of the last line, but for the pace of progress."""
        words = shlex.split(err.splitlines()[-1])
        at = words.index("--progress") if "--progress" in words else len(words)
        return words[:at] + words[at + 2:]

    def goes_on(self, err, says="this goes on"):
        """The command of the last line, which is done."""
        self.assertIn(says, err)
        words = self.command_of(err)
        self.assertEqual(words[0], "axiscert", err)
        return self.ok(*words[1:])

    def limited(self, size, *args, code=2):
        """No file may become longer than so many bytes, as on a disk that is full."""
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_DFL)  # which Python ignores
            resource.setrlimit(resource.RLIMIT_FSIZE, (size, resource.RLIM_INFINITY))
        done = subprocess.run([BUILD / "axiscert", *map(str, args)], capture_output=True, text=True, preexec_fn=limit)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stderr

    def half_written(self):
        return [path for path in self.folder.rglob("*.part")]


class Interrupted(EndingCase):
    trials = fewer(300000)
    families = ["general", "lattice"]

    def test_a_run_says_of_how_many_and_meets_nothing(self):
        for which in (signal.SIGINT, signal.SIGTERM):
            run = ("run", "--family", "general", "--precision", "binary32", "--trials", ENDLESS, "--require", "exact", "--out", self.folder / "out")
            out, err = self.interrupted(*run, which=which)
            record = json.loads((self.folder / "out/record.json").read_text())
            asked = record["plan"]["trials"]["general"]["binary32"]
            self.assertFalse(record["complete"])
            self.assertEqual(record["plan"]["planned"], {"general": {"binary32": int(ENDLESS)}})
            text = f"interrupted after {asked:,} of {int(ENDLESS):,} queries"
            self.assertIn(text, out)
            self.assertIn(f"NOT CHECKED: {text}", err)
            for file, says in (("report.md", f"**INCOMPLETE**: {text}"), ("junit.xml", text)):
                self.assertIn(says, (self.folder / "out" / file).read_text())
            self.assertIn("a run without --plan keeps no journal to go on from; this begins it again", err)
            self.assertEqual(self.command_of(err), ["axiscert", *map(str, run)])

    def test_a_second_one_ends_at_once(self):
        run = ("run", "--family", "general", "--trials", ENDLESS, "--out", self.folder / "out")
        _, err = self.interrupted(*run, times=2)
        self.assertEqual(self.command_of(err), ["axiscert", *map(str, run)])

    def test_a_plan_goes_on_by_its_last_line(self):
        journal = self.folder / "out/journal"
        _, err = self.interrupted("run", "--plan", self.plan, "--threads", 1, "--out", self.folder / "out",
                                  ready=lambda: journal.exists() and journal.stat().st_size > 1500)
        self.assertFalse(json.loads(self.record())["complete"])
        self.goes_on(err)
        self.assertEqual(self.record(), self.uninterrupted())

    def test_a_search_goes_on_with_what_it_found(self):
        search = ("search", "--precision", "binary32", "--evaluations", 1 << 30, "--threads", 1)
        out, err = self.interrupted(*search, "--out", self.folder / "out")
        self.assertEqual(self.command_of(err), ["axiscert", *map(str, search), "--out", f"{self.folder}/out", "--resume"])
        self.assertIn("interrupted", out)
        self.assertTrue((self.folder / "out/search.state").exists())
        _, err = self.interrupted(*search)
        self.assertIn("without --out keeps no state", err)

    def test_a_certificate_goes_on_with_what_is_left_of_its_time(self):
        journal = self.folder / "out/run/journal"
        certify = ("certify", "published", "--effort", "quick", "--threads", 1, "--out", self.folder / "out")
        _, err = self.interrupted(*certify, "--time", 1999, ready=lambda: journal.exists() and journal.stat().st_size > 1500)
        self.assertRegex(err, r"the stretches that are done are in .*, and 1[0-9]{3} s of --time are left; this goes on")
        words = self.command_of(err)
        left = float(words.pop(words.index("--time") + 1))
        words.remove("--time")
        self.assertTrue(1000 < left < 2000, err)
        self.assertEqual(sorted(words), sorted(["axiscert", *map(str, certify), "--resume"]))

    def test_what_keeps_nothing_says_so_and_how_to_ask_less(self):
        for command, says in ((("precision",), "precision keeps nothing of a part of its figures; it asks less by fewer --trials (a tenth: --trials 204), kernels "
                               "and families, and each --number or --bits is one format in place of 26"),
                              (("ladder", "--trials", 1 << 22), "(a tenth: --trials 419430), kernels and families, and --no-speed measures no times"),
                              (("league", "--no-engines", "--trials", 1 << 20), "--no-speed and --no-engines leave out the times and the engines"),
                              (("map", "1:general:2:binary32:0:0", "--size", 4096), "--size 2048 draws a quarter of the pixels, and --what fewer than these "),
                              (("generate", "--trials", ENDLESS, "-o", self.folder / "q.jsonl"), "it keeps nothing to go on from")):
            _, err = self.interrupted(*command)
            self.assertIn(says, err)
            self.assertIn("this begins it again", err)
            self.assertEqual(self.command_of(err), ["axiscert", *map(str, command)])
        self.assertFalse((self.folder / "q.jsonl").exists())


class FullDisk(EndingCase):
    small = ("--family", "repeated", "--trials", 300)

    def test_a_run_names_the_file_and_leaves_no_half_of_one(self):
        err = self.limited(20000, "run", *self.small, "--out", self.folder / "out")
        self.assertRegex(err, r"out/record\.json: cannot be written: File too large; it has \d+ bytes")
        self.assertIn("this begins it again", err)
        self.assertEqual(list((self.folder / "out").iterdir()), [])
        self.goes_on(err, "this begins it again")
        whole = self.record()
        (self.folder / "out/report.html").unlink()
        err = self.limited(len(whole) + 1000, "run", *self.small, "--out", self.folder / "out")
        self.assertIn("report.html: cannot be written", err)
        self.assertIn("out/record.json is whole; this goes on", err)
        self.assertEqual(self.half_written(), [])
        self.goes_on(err)
        self.assertTrue((self.folder / "out/report.html").exists())
        self.assertEqual(self.record(), whole)

    def test_a_plan_goes_on(self):
        err = self.limited(6000, "run", "--plan", self.plan, "--out", self.folder / "out")
        self.assertIn("the stretches that are done are in", err)
        self.goes_on(err)
        self.assertEqual(self.record(), self.uninterrupted())

    def test_every_command_leaves_its_files_whole_or_not_at_all(self):
        out = ("--out", self.folder / "out")
        for command in (("search", "--evaluations", 3000, "--precision", "binary32", *out), ("precision", "--trials", 50, *out),
                        ("mutate", "--mutant", "swap", "--trials", 50, "--no-controls", *out), ("diagnose", "published", *out),
                        ("map", "1:general:2:binary32:0:0", "--size", 8, *out), ("plan", *self.small, "--out-file", self.folder / "plan"),
                        ("generate", "--trials", 9000, "-o", self.folder / "queries")):
            err = self.limited(500, *command)
            self.assertIn("cannot be written: File too large", err)
            self.assertRegex(err, "this (begins it again|goes on)", command)
            self.assertEqual(self.half_written(), [], command)
        left = [path for path in self.folder.rglob("*") if path.is_file() and path != self.plan]
        self.assertTrue(all(path.stat().st_size < 500 for path in left), left)

    def test_standard_output_counts(self):
        for command in (("families", "--format", "csv"), ("run", *self.small, "--out", self.folder / "out")):
            with open("/dev/full", "w", encoding="ascii") as full:
                done = subprocess.run([BUILD / "axiscert", *map(str, command)], stdout=full, stderr=subprocess.PIPE, text=True)
            self.assertEqual(done.returncode, 2, command)
            self.assertIn("No space left on device", done.stderr)
        with subprocess.Popen([BUILD / "axiscert", "families"], stdout=subprocess.PIPE) as reader_left:
            reader_left.stdout.close()
        self.assertIn(reader_left.returncode, (0, -signal.SIGPIPE))

    def test_a_folder_that_cannot_be_written_is_refused_before_anything_runs(self):
        (self.folder / "file").write_text("")
        for command in (("run", "--trials", ENDLESS), ("search",), ("precision", "--trials", ENDLESS), ("league", "--trials", ENDLESS),
                        ("mutate",), ("diagnose", "published")):
            self.refused(*command, "--out", self.folder / "file/out", says=["--out", "cannot write there"])


class LostShard(EndingCase):
    def test_merge_says_which_and_how_it_goes_on(self):
        for shard in (1, 2):
            self.ok("run", "--plan", self.plan, "--shard", f"{shard}/3", "--out", self.folder / f"shards/{shard}")
        journal = self.folder / "shards/2/journal"
        os.truncate(journal, journal.stat().st_size // 2)  # as kill -9 leaves it
        folders = [self.folder / f"shards/{shard}" for shard in (1, 2)]
        done = self.refused("merge", *folders, "--out", self.folder / "out", says=["units are missing"])
        self.assertRegex(done.stderr, "shard 2/3 is not done in .*/shards/2; this goes on")
        self.assertIn("shard 3/3 is in none of these folders; this does it", done.stderr)
        commands = [line for line in done.stderr.splitlines() if line.startswith("  axiscert run")]
        self.assertEqual(len(commands), 2)
        for command in commands:
            self.ok(*shlex.split(command)[1:])
        self.ok("merge", *folders, self.folder / "shards/3", "--out", self.folder / "out")
        self.assertEqual(self.record(), self.uninterrupted())


if __name__ == "__main__":
    unittest.main()
