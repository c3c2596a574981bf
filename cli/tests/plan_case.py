"""The common part of the tests of plans in parts: a plan, and the record of one thread that it has to come to."""
from command import MODELS, Case, axiscert, fewer


class PlanCase(Case):
    """Every test starts from the record of one thread, made once for each plan."""
    trials = fewer(700)
    families = ["general", "lattice", "grid", "scale", "repeated", "tangent", "far", "bits"]
    expected = {}

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        if hasattr(cls, "options"):  # of the class' own
            return
        named = [part for family in cls.families for part in ("--family", family)]
        cls.options = [*named, "--mesh", MODELS / "OBJ/spider.obj", "--trials", cls.trials, "--tolerance", "3"]

    def setUp(self):
        super().setUp()
        self.plan = self.folder / "plan.json"
        self.ok("plan", *self.options, "-o", self.plan)

    def ok(self, *args, code=0):
        done = axiscert(*args)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def run_plan(self, *args, out="out", code=0):
        return self.ok("run", "--plan", self.plan, "--out", self.folder / out, *args, code=code)

    def record(self, out="out"):
        return (self.folder / out / "record.json").read_bytes()

    def uninterrupted(self):
        """The record of one thread, without a plan file and a journal."""
        if type(self) not in self.expected:
            self.ok("run", *self.options, "--threads", 1, "--out", self.folder / "uninterrupted")
            self.expected[type(self)] = self.record("uninterrupted")
        return self.expected[type(self)]
