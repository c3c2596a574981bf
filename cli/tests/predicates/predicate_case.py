"""What each command tells of a predicate. A method ask_COMMAND runs it, yields what it says of verdicts, and checks the rest itself."""
import json
import struct
from collections import Counter, namedtuple
from functools import cached_property

from PIL import Image

from command import Case, axiscert
from predicate_queries import Query, Told, counted_in, counts, moved, named, pixels, verdicts, wrong

# A kernel of each entry; the first is wrong on many queries of `family`, and `axes` are two numbers that a map changes there.
# `mutated` is a kernel that mutants are made of.
Plan = namedtuple("Plan", "program kernels family axes mutated", defaults=[None])
PLANS = {
    "sphere-triangle": Plan("axiscert", ["published"], "repeated", ("p.x", "r"), "nonstrict"),
    "moving-sphere": Plan("axiscert", ["moving-sphere/twenty", "moving-sphere/ends-twenty"], "moving-sphere/line_sweep", ("p.x", "r"),
                          "moving-sphere/twenty-nonstrict"),
    "box-box": Plan("axiscert", ["box-box/textbook", "box-box/textbook-turned", "box-box/textbook-minmax", "box-box/textbook-mixed"], "box-box/resting", ("a.m.x", "a.s.x")),
    "box-triangle": Plan("axiscert", ["box-triangle/textbook", "box-triangle/textbook-minmax", "box-triangle/textbook-oriented",
                                      "box-triangle/textbook-turned"],
                         "box-triangle/touching", ("box.m.x", "box.s.x")),
    "capsule-triangle": Plan("axiscert", ["capsule-triangle/twenty"], "capsule-triangle/line", ("p.x", "r")),
    "point-box": Plan("axiscert_toy", ["point-box/fault"], "point-box/general", ("p.x", "p.z")),
}

CODES = {"contact": 0, "separated": 1, "undecided": 2, "invalid": 3}
SAME_CLASS = {"boundary": "no", "no_uncertain": "no", "yes_uncertain": "yes"}


class PredicateCase(Case):
    @cached_property
    def plan(self):
        return PLANS[self.predicate]

    @cached_property
    def description(self):
        return next(t for t in self.json("predicates")["predicates"] if t["id"] == self.predicate)

    @cached_property
    def kernel(self):
        return self.plan.kernels[0]

    def said(self, *args, stdin=None, code=0):
        done = axiscert(*args, program=self.plan.program, stdin=stdin)
        self.assertEqual(done.returncode, code, f"{args}: {done.stdout[-400:]}{done.stderr}")
        return done.stdout

    def json(self, *args, **more):
        return json.loads(self.said(*args, "--format", "json", **more))

    def record(self, folder):
        return json.loads((self.folder / folder / "record.json").read_text())

    def read(self, lines):
        return [Query(self.description, json.loads(line)) for line in lines.splitlines()]

    def queries(self, families, trials, precision="binary32"):
        named = [part for family in families for part in ("--family", family)]
        return self.read(self.said("generate", *named, "--trials", trials, "--precision", precision))

    def checked(self, queries, kernel=None):
        lines = "".join(json.dumps(query.line) + "\n" for query in queries)
        return [json.loads(line) for line in
                self.said("check", "-", "--kernel", kernel or self.kernel, "--format", "jsonl", stdin=lines).splitlines()]

    def answers(self, queries, kernel=None):
        return [found["computed"]["verdict"] for found in self.checked(queries, kernel)]

    @cached_property
    def entries(self):
        """The entry of each family."""
        return {family: query.entry["name"] for family, query in zip(self.description["families"], self.queries(self.description["families"], 1), strict=True)}

    def families_of(self, kernel):
        """Those of the kernel's entry, apart that with few valid queries."""
        (entry,) = [k["entry"] for k in self.json("kernels", "--kernel", kernel)["kernels"]]
        own = [family for family, its in self.entries.items() if its == entry]
        return [part for part in ([f for f in own if f != "nonfinite"], [f for f in own if f == "nonfinite"]) if part]

    @cached_property
    def wrong_query(self):
        """One that the kernel is wrong on, and whose numbers that a map changes are not small."""
        for query, answer in zip(queries := self.queries([self.plan.family], 64), self.answers(queries)):
            shown = [abs(query.numbers[query.column(name)]) for name in self.plan.axes]
            if answer != query.truth()[0] and min(shown) > 1e-3:
                return query
        self.fail(f"{self.kernel} is right on all of {self.plan.family}")

    def told_by_record(self, record, families=None):
        """A record's counts, family by family, beside those of the same queries and what `check` says to them."""
        for entry in record["kernels"]:
            counted = [(name, family) for name, family in entry["families"].items() if families is None or name in families]
            (trials,) = {family["trials"] for _, family in counted}
            queries = self.queries([name for name, _ in counted], trials, entry["precision"])
            said = self.answers(queries, entry["id"])
            for name, family in counted:
                own, answers = queries[:trials], said[:trials]
                del queries[:trials], said[:trials]
                yield Told(f"{entry['id']} {entry['precision']} {name}", own, counted_in(family), counts(answers))

    @cached_property
    def run_folder(self):
        self.said("run", "--kernel", self.kernel, "--family", self.plan.family, "--trials", 48, "--threads", 1, "--quiet", "--out",
                  self.folder / "one")
        return self.folder / "one"

    def ask_run(self):
        for kernel in self.plan.kernels:
            for families in self.families_of(kernel):
                named = [part for family in families for part in ("--family", family)]
                trials = 48 if "nonfinite" in families else 6
                self.said("run", "--kernel", kernel, *named, "--trials", trials, "--precision", "binary32", "--threads", 1, "--quiet", "--out",
                          self.folder / "all")
                record = self.record("all")
                self.assertEqual(record["plan"]["predicate"], self.predicate)
                yield from self.told_by_record(record)
        yield from self.told_by_record(self.record(self.run_folder))

    def ask_check(self):
        for kernel in self.plan.kernels:
            queries = self.queries(sum(self.families_of(kernel), []), 6, "binary64")
            found = [(one["exact"]["verdict"], one["exact"]["touching"]) for one in self.checked(queries, kernel)]
            yield Told(kernel, queries, found, list)

    def ask_report(self):
        before = {file: (self.run_folder / file).read_bytes() for file in ("record.json", "report.md", "report.html", "junit.xml")}
        self.said("report", self.run_folder)
        for file, content in before.items():
            self.assertEqual((self.run_folder / file).read_bytes(), content, file)
        shown = {one["id"]: one for one in self.record(self.run_folder)["witnesses"]}
        queries = self.read((self.run_folder / "witnesses.jsonl").read_text())
        self.assertEqual([query.line["id"] for query in queries], list(shown))
        self.assertEqual(self.answers(queries), [one["computed"] for one in shown.values()])
        yield Told("witnesses", queries, [(one["truth"], one["touching"]) for one in shown.values()], list)

    def ask_diagnose(self):
        found = self.json("diagnose", self.kernel)
        self.assertEqual(found["predicate"], self.predicate)
        for one in found["properties"]:
            for witness in one["witnesses"]:
                (query,) = self.read(json.dumps(witness["query"]))
                if witness["answered"] in CODES:  # else two answers, of two ways to call it
                    self.assertEqual(self.answers([query]), [witness["answered"]], one["name"])
                yield Told(one["name"], [query], witness["truth"], named(witness["truth"]))

    @cached_property
    def certificate(self):
        self.said("certify", self.kernel, "--effort", "smoke", "--threads", 1, "--quiet", "--out", self.folder / "certified")
        return json.loads((self.folder / "certified/certificate.json").read_text())["predicate"]

    def ask_certify(self):
        self.assertEqual(self.certificate["kernel"]["question"], self.predicate)
        if "r" not in self.plan.axes:
            self.assertIn("does not depend on one radius", self.certificate["safe_margin"]["reason"])
            self.assertEqual(self.certificate["safe_margin"]["precisions"], [])
        self.assertIsNone(self.certificate["search"]["reason"])  # a test need not have a radius to be searched
        for precision in self.certificate["kernel"]["precisions"]:
            search = self.certificate["search"]["precisions"][precision]
            self.assertGreater(search["evaluations"], 0)
            self.assertIn("missed_contact", search["finds"])
        self.assertTrue(self.certificate["witnesses"])
        record = self.record("certified/run")
        own = [one for one in record["kernels"] if one["id"] == self.kernel]
        for one in own:
            (shown,) = [row for row in self.certificate["comparison"]
                        if (row["kernel"], row["precision"]) == (self.kernel, one["precision"])]
            for name, kind in (("missed", "false_separation"), ("phantom", "false_contact")):
                self.assertEqual(shown[name], sum(family["verdict"][kind] or 0 for family in one["families"].values()), name)
        families = [self.plan.family, *list(own[0]["families"])[:2]]
        yield from self.told_by_record({"kernels": own}, families)
        for witness in self.certificate["witnesses"]:
            (query,) = self.read(self.said("query", witness["address"]))
            self.assertEqual(witness["query"].get("predicate", "sphere-triangle"), self.predicate)
            self.assertLessEqual({group for group, _ in query.groups}, set(witness["query"]))  # what the page draws
            shown, _ = witness["sentence"].removeprefix("The truth is ").split(",", 1)
            yield Told(witness["title"], [query], shown, named(shown))

    def ask_verify(self):
        self.assertTrue(self.certificate)
        self.said("verify", self.folder / "certified/certificate.json", "--recheck", "10%", "--recheck-seed", 1, "--threads", 1)
        yield from ()

    def ask_search(self, kernel=None, family=None):
        kernel = kernel or self.kernel
        self.said("search", "--kernel", kernel, "--family", family or self.plan.family, "--evaluations", 256, "--threads", 1, "--out",
                  self.folder / "found")
        finds = [query for query in self.read((self.folder / "found/witnesses.jsonl").read_text())
                 if query.line["id"].split()[0] in ("missed_contact", "phantom_contact")]
        self.assertTrue(finds)
        for query in finds:
            right, said = ("contact", "separated") if query.line["id"].startswith("missed") else ("separated", "contact")
            self.assertEqual(self.answers([query], kernel), [said])
            yield Told(query.line["id"], [query], [right], verdicts)

    def ask_shrink(self, kernel=None, query=None):
        kernel, query = kernel or self.kernel, query or self.wrong_query
        found = json.loads(self.said("shrink", "-", "--kernel", kernel, "--evaluations", 200, "--format", "jsonl", stdin=json.dumps(query.line)))
        self.assertEqual(found["kept"]["level"], "verdict")
        right, said = {"false_separation": ("contact", "separated"), "false_contact": ("separated", "contact")}[found["kept"]["kind"]]
        members = ("id", "precision", "predicate", "entry", *{group.split(".")[0] for group, _ in query.groups})
        (smaller,) = self.read(json.dumps({name: found[name] for name in members if name in found}))
        self.assertEqual(self.answers([smaller, query], kernel), [said] * 2)
        self.assertLessEqual(found["bits"]["after"], found["bits"]["before"])
        yield Told(smaller.line["id"], [smaller, query], [right] * 2, verdicts)

    def ask_map(self, kernel=None, query=None, axes=None):
        kernel, query, (along, across) = kernel or self.kernel, query or self.wrong_query, axes or self.plan.axes
        found = self.json("map", "-", "--kernel", kernel, "--along", along, "--across", across, "--size", 8, "--what", "verdict", "--out",
                          self.folder, stdin=json.dumps(query.line))
        legend = {one["colour"]: one["class"] for one in found["legend"]}
        (drawn,) = found["maps"]
        (picture,) = drawn["pictures"]
        steps = [(up, right) for up in range(8) for right in range(8)]
        columns = {"along": query.column(along), "across": query.column(across)}
        pixel = lambda side, at: moved(query.numbers[columns[side]], (at - drawn[side]["origin"]) * drawn[side]["step"], query.precision)
        asked = [query.changed({columns["along"]: pixel("along", right), columns["across"]: pixel("across", up)}) for up, right in steps]
        with Image.open(self.folder / "maps" / picture["file"]) as image:
            rgb = image.convert("RGB")
        shown = [legend["#%02x%02x%02x" % rgb.getpixel((right, 7 - up))] for up, right in steps]
        self.assertEqual({name: n for name, n in picture["counts"].items() if n}, Counter(shown))
        yield Told(f"{along}, {across}", asked, [SAME_CLASS.get(name, name) for name in shown], pixels(self.answers(asked, kernel)))

    def streams(self):
        """(queries, header, numbers) of the binary stream of each entry's first families."""
        for kernel in self.plan.kernels:
            families = self.families_of(kernel)[0][:3]
            named = [part for family in families for part in ("--family", family)]
            self.said("generate", *named, "--trials", 20, "--binary", "-o", self.folder / "queries.bin")
            stream = (self.folder / "queries.bin").read_bytes()
            (size,) = struct.unpack_from("<I", stream, 24)
            yield self.queries(families, 20), stream[:size], [x for (x,) in struct.iter_unpack("<f", stream[size:])]

    def ask_generate(self):
        for queries, _, numbers in self.streams():
            own = [x for query in queries for x in query.numbers]
            self.assertEqual([struct.pack("f", x) for x in numbers], [struct.pack("f", x) for x in own])
        yield from ()

    def ask_judge(self):
        """A program of the test's own that answers by the rationals, and one with every seventh answer turned round."""
        for queries, header, _ in self.streams():
            right = verdicts([query.truth() for query in queries])
            for planted in (False, True):
                other = {"contact": "separated", "separated": "contact"} if planted else {}
                said = [other.get(one, one) if i % 7 == 3 else one for i, one in enumerate(right)]
                (self.folder / "replies.bin").write_bytes(header + b"".join(struct.pack("<BB14x", CODES[one], 0) for one in said))
                self.said("judge", self.folder / "replies.bin", "--quiet", "--threads", 1, "--out", self.folder / "judged")
                (kernel,) = self.record("judged")["kernels"]
                found = [family["verdict"][kind] or 0 for family in kernel["families"].values() for kind in ("false_separation", "false_contact")]
                self.assertEqual(sum(found), sum(a != b for a, b in zip(said, right)))
                first = 0
                for name, family in kernel["families"].items():
                    last = first + family["trials"]
                    yield Told(f"{name}, planted: {planted}", queries[first:last], counted_in(family), counts(said[first:last]))
                    first = last

    def ask_kernels(self):
        listed = self.json("kernels", "--predicate", self.predicate)["kernels"]
        self.assertEqual({one["predicate"] for one in listed}, {self.predicate})
        self.assertLessEqual(set(self.plan.kernels), {one["id"] for one in listed})
        self.assertEqual([one["entry"] for one in listed if one["id"] in self.plan.kernels], [e["name"] for e in self.description["entries"]])
        yield from ()

    def ask_families(self):
        listed = self.json("families", "--predicate", self.predicate)["families"]
        self.assertEqual([one["name"] for one in listed], self.description["families"])
        yield from ()

    def ask_predicates(self):
        self.assertIn(f"{self.predicate}: {self.description['asks']}", self.said("predicates"))
        yield from ()

    def ask_query(self):
        for query in self.queries(self.description["families"][::7], 1):
            self.assertEqual(json.loads(self.said("query", query.line["id"])), query.line)
        yield from ()

    def ask_compare(self):
        found = self.json("compare", self.run_folder, self.run_folder)
        self.assertEqual((found["answer"], found["passes"]), ("no change", True))
        self.assertEqual({name for name, count in found["counts"].items() if count}, {"unchanged"})
        for precision in ("binary32", "binary64"):
            queries = self.queries([self.plan.family], 48, precision)
            shown = {cell["figure"]: cell["old"] for cell in found["cells"] if cell["precision"] == precision and cell["place"] == "verdict"}
            yield Told(precision, queries, tuple(shown.get(kind, 0) for kind in ("false_separation", "false_contact")), wrong(self.answers(queries)))

    def ask_corpus(self):
        kept = [json.loads(line) for line in self.said("corpus", "list", "--format", "jsonl").splitlines()]
        line = json.dumps(self.wrong_query.line)
        add = ("corpus", "add", "-", "--name", "one", "--provenance", "made:here", "--note", "wrong", "--folder", self.folder / "corpus")
        (self.folder / "corpus").mkdir()
        self.said(*add, stdin=line)
        added = [json.loads(line) for line in self.said("corpus", "list", "--format", "jsonl", "--folder", self.folder / "corpus").splitlines()]
        self.assertEqual(len(added), 1)
        for one in kept + added:
            if one.get("predicate", "sphere-triangle") == self.predicate:
                yield Told(one["id"], [Query(self.description, one)], [(one["expected"]["verdict"], one["expected"]["touching"])], list)

    def ask_plan(self):
        self.said("plan", "--kernel", self.kernel, "--family", self.plan.family, "--trials", 48, "-o", self.folder / "plan.json")
        self.assertEqual(json.loads((self.folder / "plan.json").read_text())["options"]["kernels"], [self.kernel])
        yield from ()

    def ask_merge(self):
        list(self.ask_plan())
        for part in (1, 2):
            self.said("run", "--plan", self.folder / "plan.json", "--shard", f"{part}/2", "--threads", 1, "--quiet",
                      "--out", self.folder / f"part{part}")
        self.said("merge", self.folder / "part1", self.folder / "part2", "--out", self.folder / "merged")
        merged = self.record("merged")
        self.assertEqual(merged, self.record(self.run_folder))
        yield from self.told_by_record(merged)

    def measured(self, command, *options, trials=48):
        """What an instrument says of the kernel and the family, and of these queries."""
        found = self.json(command, "--kernel", self.kernel, "--family", self.plan.family, "--precision", "binary32", "--trials", trials,
                          "--threads", 1, *options)
        return found, self.queries([self.plan.family], trials)

    def ask_league(self):
        found, queries = self.measured("league", "--no-speed", "--no-engines")
        family = found["kernels"][0]["families"][self.plan.family]
        yield Told("league", queries, (family["false_separation"], family["false_contact"]), wrong(self.answers(queries)))

    def ask_ladder(self):
        found, queries = self.measured("ladder", "--no-speed")
        family = found["kernels"][0]["families"][self.plan.family]["verdict"]
        yield Told("ladder", queries, (family["false_separation"], family["false_contact"]), wrong(self.answers(queries)))

    def ask_condition(self):
        found, queries = self.measured("condition")
        family = found["rows"][0]["wrong_verdicts"]
        yield Told("condition", queries, (family["false_separation"], family["false_contact"]), wrong(self.answers(queries)))

    def ask_precision(self):
        """At 24 bits and binary32's exponents the formulae are the kernel."""
        found, queries = self.measured("precision", "--bits", 24)
        family = found["families"][self.plan.family]["kernels"][self.kernel]["precisions"][0]["limited"]["verdict"]
        yield Told("precision", queries, (family["false_separation"], family["false_contact"]), wrong(self.answers(queries)))

    def ask_critical_radius(self):
        """Right is who says separated at the greatest length that is, and contact at the next; lengths are bisected by the rationals."""
        family = next(f for f in self.description["families"] if f.endswith("tangent") or f.endswith("graze"))
        found = self.json("critical-radius", "--kernel", self.kernel, "--family", family, "--trials", 8, "--threads", 1)
        (row,) = found["rows"]
        self.assertEqual([row[name] for name in ("unbounded", "not_monotone", "left_out")], [0, 0, 0])
        pairs = []
        for query in self.queries([family], 8):
            length = next(i for i, column in enumerate(query.entry["columns"]) if column["role"] == "length")
            low, high = 0, 0x7F7FFFFF  # the greatest binary32, in floats above 0
            at = lambda ulps: query.changed({length: moved(0.0, ulps, "binary32")})
            if at(low).truth()[0] == "contact" or at(high).truth()[0] == "separated":
                continue  # no length turns the answer
            while high - low > 1:
                middle = (low + high) // 2
                low, high = (middle, high) if at(middle).truth()[0] == "separated" else (low, middle)
            pairs += [at(low), at(high)]
        self.assertEqual(len(pairs), 2 * row["measured"])
        said = self.answers(pairs)

        def counted(truths):
            both = list(zip(said[::2], said[1::2], verdicts(truths)[::2], verdicts(truths)[1::2]))
            return (sum((a, b) == (x, y) for a, b, x, y in both), sum(a != x and b == y for a, b, x, y in both),
                    sum(a == x and b != y for a, b, x, y in both))
        yield Told(family, pairs, (row["right"], row["early"], row["late"]), counted)

    def ask_mutate(self):
        # Twelve of some hundreds, each of which costs 30 ms of a moving sphere.
        mutants = [part for site in range(12) for part in ("--mutant", f"{self.plan.mutated}~operator:{site}")]
        found = self.json("mutate", "--kernel", self.plan.mutated, "--verdict-only", *mutants, "--no-controls",
                          "--family", self.plan.family, "--trials", 48, "--precision", "binary32", "--threads", 1)
        queries = self.queries([self.plan.family], 48)
        planted = [one for one in found["mutants"] if one["survival"]["wrong"]]
        self.assertTrue(planted)
        own = self.answers(queries, self.plan.mutated)
        for one in planted[:3]:
            other = [(query, a) for query, a, b in zip(queries, self.answers(queries, one["id"]), own) if a != b]
            self.assertEqual(len(other), one["survival"]["other_verdicts"])
            yield Told(one["id"], [query for query, _ in other], one["survival"]["wrong"],
                       lambda truths, other=other: sum(wrong([answer for _, answer in other])(truths)))

    def ask_refused(self, command, *args, lacks="", stdin=None):
        """One line with the predicate and what it lacks, and the exit code of a wrong usage."""
        which = ("--predicate", self.predicate) if command == "mutate" else args or ("--kernel", self.kernel)
        done = axiscert(command, *which, program=self.plan.program, stdin=stdin)
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        says = "no kernel of the predicate {} is one that mutants are made of" if command == "mutate" else f"{command} does not serve {lacks}the predicate {{}}"
        self.assertRegex(done.stderr, says.format(self.predicate) + "\\b")
