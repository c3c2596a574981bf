#!/usr/bin/env python3
"""A plan on the ranks of an MPI job: however it is distributed and whichever ranks are killed, the record is that of one thread."""
import json
import os
import signal
import subprocess
import time
import unittest

from command import BUILD, ROOT
from predicates.motion_records_test import MOTIONS
from plan_case import PlanCase

# For root, and for more ranks than cores, which Open MPI refuses to start otherwise.
MPI = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


class MpiCase(PlanCase):
    def mpirun(self, ranks, *args):
        command = ["mpirun", "-n", str(ranks), "--oversubscribe", BUILD / "axiscert", "run", "--plan", self.plan, *args]
        return subprocess.Popen(list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                env=os.environ | MPI)

    def mpi_ok(self, ranks, *args, code=0):
        run = self.mpirun(ranks, *args)
        out, err = run.communicate(timeout=300)
        self.assertEqual(run.returncode, code, out + err)
        return err


class Ranks(MpiCase):
    """Registered where there is an MPI."""
    def test_the_record_on_1_to_4_ranks(self):
        for ranks in range(1, 5):
            out = self.folder / f"ranks-{ranks}"
            said = self.mpi_ok(ranks, "--out", out, "--recheck", 0.1)
            self.assertEqual(self.record(out), self.uninterrupted(), ranks)
            if ranks > 1:
                self.assertIn("MiB at most", said)
                uses = json.loads((out / "run.json").read_text())["scale"]["ranks"]
                self.assertEqual(len(uses), ranks)

    def test_the_record_of_motions_on_1_to_3_ranks(self):
        self.ok("run", *MOTIONS, "--threads", 1, "--out", self.folder / "alone")
        self.ok("plan", *MOTIONS, "--units-per-stretch", 1, "-o", self.plan)
        for ranks in range(1, 4):
            self.mpi_ok(ranks, "--out", self.folder / f"ranks-{ranks}")
            self.assertEqual(self.record(f"ranks-{ranks}"), self.record("alone"), ranks)

    def test_a_certificate_is_the_same_on_ranks(self):
        alone = self.folder / "certified-alone/certificate.json"
        self.ok("certify", "published", "--effort", "smoke", "--out", alone.parent)
        out = self.folder / "certified"
        done = subprocess.run(["mpirun", "-n", "2", "--oversubscribe", BUILD / "axiscert", "certify", "published", "--effort", "smoke",
                               "--quiet", "--out", out], capture_output=True, text=True, env=os.environ | MPI, timeout=300)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("rank 1: ", done.stderr)
        self.assertNotIn("Warning", done.stderr)
        self.assertEqual((out / "certificate.json").read_bytes(), alone.read_bytes())

    def test_a_fault_ends_all_ranks_with_its_exit_code(self):
        self.plan.write_text("{}")
        self.assertIn("not a plan", self.mpi_ok(2, "--out", self.folder / "out", code=2))

    def test_the_job_scripts(self):
        scripts = ROOT / "examples"
        environment = os.environ | MPI | {"PATH": f"{BUILD}:{os.environ['PATH']}", "OMPI_MCA_rmaps_base_oversubscribe": "1"}
        run = lambda script, **more: subprocess.run(["bash", scripts / script], cwd=self.folder, env=environment | more,
                                                    check=True, capture_output=True)
        run("mpi.sbatch")
        self.assertEqual(self.record(), self.uninterrupted())
        for job in ("3", "1", "2"):
            run("array.sbatch", SLURM_ARRAY_TASK_ID=job, SLURM_ARRAY_TASK_COUNT="3")
        self.ok("merge", *(self.folder / "shards").iterdir(), "--out", self.folder / "merged")
        self.assertEqual(self.record("merged"), self.uninterrupted())


class KilledRank(MpiCase):
    """Registered where there is an MPI. Units of full size, so that there is time to kill."""
    options = ["--family", "tangent", "--family", "general", "--trials", 300000]

    def test_a_rank_is_killed(self):
        for rank in (0, 2):
            # A rank that is through before it could be killed is tried again.
            out = next(filter(None, (self.killed(rank, self.folder / f"killed-{rank}-{turn}") for turn in range(5))), None)
            self.assertIsNotNone(out, f"rank {rank} was through before it could be killed, five times")
            said = self.mpi_ok(3, "--out", out, "--resume")
            self.assertIn("units lost on the way: ", said)
            self.assertEqual(self.record(out), self.uninterrupted(), rank)

    def killed(self, rank, out):
        """The folder of a run of which that rank was killed; None where it was through."""
        run = self.mpirun(3, "--out", out)
        journal = out / "journal"
        while run.poll() is None and not (journal.exists() and journal.stat().st_size > 6000):
            time.sleep(0.002)
        process = self.process_of(rank, run.pid)
        if process is not None:
            os.kill(process, signal.SIGKILL)
        run.communicate(timeout=120)
        if process is None or run.returncode == 0:
            return None
        return out

    def process_of(self, rank, mpirun):
        for pid in filter(str.isdigit, os.listdir("/proc")):
            try:
                with open(f"/proc/{pid}/environ") as environ, open(f"/proc/{pid}/stat") as stat:
                    parent = int(stat.read().rsplit(")", 1)[1].split()[1])
                    if parent == mpirun and f"OMPI_COMM_WORLD_RANK={rank}" in environ.read().split("\0"):
                        return int(pid)
            except OSError:
                continue
        return None


class NoRanks(PlanCase):
    """Registered where there is no MPI."""
    def test_ranks_are_refused(self):
        done = subprocess.run([BUILD / "axiscert", "run", "--plan", self.plan, "--out", self.folder / "out"],
                              capture_output=True, text=True, env=os.environ | {"OMPI_COMM_WORLD_SIZE": "2"})
        self.assertEqual(done.returncode, 2)
        self.assertIn("without MPI", done.stderr)


if __name__ == "__main__":
    unittest.main()
