#!/usr/bin/env python3
"""A plan in parts: whatever was killed, cut off or shuffled, the record is that of one thread."""
import hashlib
import json
import random
import resource
import signal
import subprocess
import time
import unittest

from command import BUILD, DIVISOR, MODELS, SCHEMAS, VALIDATE
from plan_case import PlanCase

SEED = 20261121


class Plan(PlanCase):
    def test_the_record_is_that_of_a_run_without_a_plan(self):
        for threads in (1, 2):
            out = f"threads-{threads}"
            self.run_plan("--threads", threads, out=out)
            self.assertEqual(self.record(out), self.uninterrupted(), out)
        scale = json.loads((self.folder / "threads-2/run.json").read_text())["scale"]
        self.assertEqual([rank["threads"] for rank in scale["ranks"]], [2])
        self.assertEqual(scale["ranks"][0]["stretches"], scale["stretches"])
        self.assertEqual(scale["journal_bytes"], (self.folder / "threads-2/journal").stat().st_size)
        subprocess.run(["/usr/bin/python3", VALIDATE, SCHEMAS / "run.schema.json",
                        self.folder / "threads-2/run.json"], check=True)

    def resigned(self, text, where, name, value):
        """A plan with another value of a member, and the digest of the changed plan."""
        plan = json.loads(text)
        (plan[where] if where else plan)[name] = value
        del plan["digest"]
        compact = json.dumps(plan, separators=(",", ":"), ensure_ascii=False)
        plan["digest"] = hashlib.sha256(compact.encode()).hexdigest()
        broken = self.folder / "broken.json"
        broken.write_text(json.dumps(plan))
        return broken

    def test_a_plan_of_an_unknown_test_is_refused(self):
        plan = self.resigned(self.plan.read_text(), "options", "predicate", "nosuch")
        self.refused("run", "--out", self.folder / "out", "--plan", plan, says=["unknown predicate 'nosuch'"])

    def test_what_is_no_plan_of_this_axiscert_is_refused(self):
        text = self.plan.read_text()
        run = ["run", "--out", self.folder / "out", "--plan"]
        broken = self.folder / "broken.json"
        for wrong, says in ((text[:-20], ["not a plan, or cut off"]), ("{}", ["not a plan"]),
                            (text.replace("axiscert-plan/2", "axiscert-plan/1"), ['its schema is "axiscert-plan/1"', 'reads "axiscert-plan/2"', "`axiscert plan -o "]),
                            (text.replace('"seed": 1', '"seed": 2'), ["changed after it was written", "digest"])):
            broken.write_text(wrong)
            self.refused(*run, broken, says=["broken.json", *says])
        for where, name, value, says in (("options", "trials", 1.8e19, "1.8e+19 is not a whole number"),
                                         ("options", "seed", -1, "-1 is not a whole number"),
                                         ("options", "families", 7, "must be array"),
                                         (None, "units_per_stretch", 0.5, "0.5 is not a whole number"),
                                         (None, "queries", -7, "-7 is not a whole number"),
                                         (None, "stretches", "many", "is not a whole number"),
                                         (None, "plan", "\x1b[31m", "is not an object")):
            self.refused(*run, self.resigned(text, where, name, value),
                         says=["broken.json: does not conform to axiscert-plan/2", f"'{name}'", says])
        self.refused(*run, self.resigned(text, None, "plan", {}), says=["broken.json", ", not "])
        self.refused(*run, self.folder / "none.json", says=["none.json"])
        self.refused(*run, self.plan, "--kernel", "reduced", says=["--plan", "--kernel"])
        self.refused("run", "--resume", says=["--plan"])
        for shard in ("0/3", "4/3", "1", "a/b", "1/2/3", "-1/2"):
            self.refused(*run, self.plan, "--shard", shard, says=["--shard", "I/N"])
        self.refused("plan", "--queries", "-", says=["standard input"])
        self.refused("plan", "--trials", 2**48, "--units-per-stretch", 1, says=["at least", "units per stretch"])

    def test_a_mesh_that_has_changed_is_told_and_one_that_has_moved_is_found(self):
        mesh = self.folder / "mesh.obj"
        mesh.write_bytes((MODELS / "OBJ/spider.obj").read_bytes())
        self.ok("plan", "--mesh", mesh, "--trials", 100, "-o", self.plan)
        (self.folder / "elsewhere").mkdir()
        moved = self.folder / "elsewhere/plan.json"
        moved.write_bytes(self.plan.read_bytes())
        mesh.rename(self.folder / "elsewhere/mesh.obj")
        self.refused("run", "--plan", self.plan, "--out", self.folder / "out", says=["mesh.obj"])
        self.ok("run", "--plan", moved, "--out", self.folder / "out")
        with open(self.folder / "elsewhere/mesh.obj", "a") as more:
            more.write("\n")
        self.refused("run", "--plan", moved, "--out", self.folder / "out2", says=["sha256", ", not "])

    def test_a_requirement_is_the_plans(self):
        self.ok("plan", "--family", "repeated", "--trials", 500, "--require", "logic", "-o", self.plan)
        self.run_plan(code=1)
        self.assertEqual(json.loads(self.record())["plan"]["require"], "logic")


class ResumeCase(PlanCase):
    def kill_and_resume(self, folders):
        """In each folder the run is killed five times, then finished."""
        print(f"seed {SEED}")
        dice = random.Random(SEED)
        start = time.monotonic()
        self.run_plan(out="timed")
        whole = time.monotonic() - start
        for folder in range(folders):
            args = [BUILD / "axiscert", "run", "--plan", self.plan, "--out", self.folder / str(folder), "--resume"]
            for _ in range(5):
                run = subprocess.Popen(args, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                time.sleep(dice.uniform(0, 0.6 * whole))
                run.kill()
                run.wait()
            self.run_plan("--resume", out=str(folder))
            self.assertEqual(self.record(str(folder)), self.uninterrupted(), f"folder {folder} of seed {SEED}")


class ResumeLong(ResumeCase):
    families = ["all"]

    def test_killed_at_20_random_moments(self):
        self.kill_and_resume(4 if DIVISOR == 1 else 1)  # sanitized, each takes many times longer


class Resume(ResumeCase):
    def test_a_journal_is_not_overwritten(self):
        self.run_plan()
        self.refused("run", "--plan", self.plan, "--out", self.folder / "out", says=["journal", "--resume"])
        done = self.run_plan("--resume")
        self.assertIn("units lost on the way: 0", done.stderr)
        self.assertEqual(self.record(), self.uninterrupted())

    def test_killed_at_5_random_moments(self):
        self.kill_and_resume(1)

    def test_interrupted_it_says_what_there_is_and_goes_on(self):
        run = subprocess.Popen([BUILD / "axiscert", "run", "--plan", self.plan, "--out", self.folder / "out"],
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        journal = self.folder / "out/journal"
        while run.poll() is None and not (journal.exists() and journal.stat().st_size > 4000):
            time.sleep(0.002)
        run.send_signal(signal.SIGINT)
        if run.wait() != 0:  # it may have been finished
            self.assertEqual(run.returncode, 130)
            self.assertFalse(json.loads(self.record())["complete"])
        self.run_plan("--resume")
        self.assertEqual(self.record(), self.uninterrupted())

    def test_a_torn_entry_is_dropped_and_a_corrupt_one_stops(self):
        self.run_plan()
        journal = self.folder / "out/journal"
        whole = journal.read_bytes()
        journal.write_bytes(whole[:-7])
        done = self.run_plan("--resume")
        self.assertIn("cut off", done.stderr)
        self.assertIn("units lost on the way: 1", done.stderr)
        self.assertEqual(self.record(), self.uninterrupted())
        changed = bytearray(whole)
        changed[len(whole) // 2] ^= 4
        journal.write_bytes(changed)
        done = self.refused("run", "--plan", self.plan, "--out", self.folder / "out", "--resume", says=["corrupt", "at byte"])
        start = int(done.stderr.split("at byte ")[1].split()[0])
        journal.write_bytes(changed[:start])
        self.run_plan("--resume")
        self.assertEqual(self.record(), self.uninterrupted())

    def test_a_full_disk(self):
        args = [BUILD / "axiscert", "run", "--plan", self.plan, "--out", self.folder / "out"]
        full = subprocess.run(args, capture_output=True, text=True,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (15000, resource.RLIM_INFINITY)))
        self.assertEqual(full.returncode, 2, full.stderr)
        self.assertIn("journal: cannot be written: File too large", full.stderr)
        self.run_plan("--resume")
        self.assertEqual(self.record(), self.uninterrupted())

    def test_a_folder_that_cannot_be_written(self):
        (self.folder / "file").write_text("")
        self.refused("run", "--plan", self.plan, "--out", self.folder / "file/out", says=["--out", "cannot write"])
        (self.folder / "out/journal").mkdir(parents=True)
        self.refused("run", "--plan", self.plan, "--out", self.folder / "out", "--resume", says=["journal", "cannot be"])


class Shards(PlanCase):
    def shards(self, count=3):
        for i in range(1, count + 1):
            self.run_plan("--shard", f"{i}/{count}", "--threads", 1, out=f"shard-{i}")
        return [self.folder / f"shard-{i}" for i in range(1, count + 1)]

    def merge(self, *folders, code=0):
        return self.ok("merge", *folders, "--out", self.folder / "merged", code=code)

    def test_shards_in_any_order_and_what_is_refused(self):
        folders = self.shards()
        for order in (folders, folders[::-1], [folders[1], folders[0], folders[2]]):
            self.merge(*order)
            self.assertEqual(self.record("merged"), self.uninterrupted())
        self.assertIn("units are missing: ", self.merge(folders[0], folders[2], code=2).stderr)
        self.assertIn("give each part once", self.merge(*folders, folders[1], code=2).stderr)

        other = self.folder / "other.json"
        self.ok("plan", *self.options, "--seed", 2, "-o", other)
        self.ok("run", "--plan", other, "--shard", "2/3", "--out", self.folder / "seed-2")
        said = self.merge(folders[0], self.folder / "seed-2", folders[2], code=2).stderr
        self.assertIn("there seed is 2, not 1", said)
        # Its plan is exchanged as well: the journal itself identifies its plan.
        (self.folder / "seed-2/plan.json").write_bytes(self.plan.read_bytes())
        said = self.merge(folders[0], self.folder / "seed-2", folders[2], code=2).stderr
        self.assertIn("is not a journal of this plan", said)
        self.assertNotIn("of another version", said)

        journal = folders[1] / "journal"
        whole = journal.read_bytes()
        journal.write_bytes(whole.replace(b"axiscert-journal/7", b"axiscert-journal/2", 1))
        said = self.merge(*folders, code=2).stderr
        self.assertIn('it begins with "axiscert-journal/2 ', said)
        self.assertIn("it is of another version: run the plan again into an empty folder", said)
        journal.write_bytes(whole[:len(whole) - 100])
        said = self.merge(*folders, code=2).stderr
        self.assertIn("cut off", said)
        self.assertIn("1 of the plan's ", said)
        changed = bytearray(whole)
        changed[len(whole) // 3] ^= 1
        journal.write_bytes(changed)
        self.assertIn("corrupt: the entry at byte ", self.merge(*folders, code=2).stderr)
        journal.unlink()
        self.assertIn("journal", self.merge(*folders, code=2).stderr)

    def test_the_missing_units_are_listed(self):
        self.ok("plan", "--family", "general", "--precision", "binary32", "--trials", 65536 * 5 // DIVISOR, "-o",
                self.plan)
        if DIVISOR == 1:
            self.run_plan("--shard", "2/2", out="half")
            said = self.merge(self.folder / "half", code=2).stderr
            self.assertIn("3 of the plan's 5 units are missing: general binary32: units 0, 2, 4;", said)


def entries(journal):
    """Offset, head and content of each entry, read by the format in fuzz/campaign/journal.h."""
    offset = journal.index(b"\n") + 1
    while offset < len(journal):
        length = int.from_bytes(journal[offset:offset + 4], "little")
        yield offset, journal[offset + 16:offset + 16 + length]
        offset += 16 + length


class Recheck(PlanCase):
    def test_it_finds_what_a_journal_has_wrong(self):
        done = self.run_plan("--recheck", 1)
        self.assertIn("every tally the same", done.stdout)
        journal = self.folder / "out/journal"
        changed = bytearray(journal.read_bytes())
        cbor = b"\x18" + bytes([self.trials]) if self.trials < 256 else b"\x19" + self.trials.to_bytes(2, "big")
        # The first tally of the third stretch counts another number of queries, and every checksum is right.
        offset, content = [e for e in entries(bytes(changed)) if len(e[1]) > 20][2]
        at = content.index(cbor) + len(cbor) - 1
        content = content[:at] + bytes([content[at] ^ 1]) + content[at + 1:]
        changed[offset + 8:offset + 16] = hashlib.sha256(offset.to_bytes(8, "little") + content).digest()[:8]
        changed[offset + 16:offset + 16 + len(content)] = content
        journal.write_bytes(changed)
        for another in ([], ["--recheck-target", "SSE4"], ["--recheck-with", BUILD / "axiscert"]):
            args = ["run", "--plan", self.plan, "--out", self.folder / "out", "--resume", "--recheck", 1, *another]
            self.refused(*args, code=3, says=["--recheck: kernel published on ", "unit 0: ", "digest"])

    def test_by_another_build(self):
        done = self.run_plan("--recheck", 0.1, "--recheck-with", BUILD / "axiscert", "--recheck-seed", 5)
        self.assertIn("every tally the same (--recheck-seed 5)", done.stdout)
        self.assertFalse((self.folder / "out/recheck").exists())
        again = ["run", "--plan", self.plan, "--out", self.folder / "out", "--resume", "--recheck", 0.1, "--recheck-with"]
        self.refused(*again, self.folder / "none", says=["none", "cannot be started"])
        self.refused(*again, "/bin/false", says=["/bin/false", "exit status 1"])


if __name__ == "__main__":
    unittest.main()
