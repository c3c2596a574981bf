#!/usr/bin/env python3
"""The pipe: queries to a program in another language, whose replies are judged like those of a user's own kernel."""
import copy
import json
import os
import pty
import shutil
import struct
import subprocess
import sys
import unittest

from command import BUILD, DIVISOR, MODELS, QUERY, ROOT, SCHEMAS, VALIDATE, Case, axiscert, family

EXAMPLES = ROOT / "examples/pipe"
PYTHON = [sys.executable, EXAMPLES / "published.py"]
SPIDER = MODELS / "OBJ/spider.obj"
REPLY = 16  # bytes, without measures


def comparable(record):
    """A record without the parts that a pipe cannot have: who answered, critical radii, what is asked of a kernel again, and the sides with their errors."""
    record = copy.deepcopy(record)
    del record["plan"]["kernels"]
    record["plan"].pop("replies", None)
    for kernel in record["kernels"]:
        for member in ("id", "summary", "exposes", "critical_radius", "slack", "cause", "window"):
            del kernel[member]
        for family in kernel["families"].values():
            del family["critical_radius"]
            for level in ("axes", "comparisons"):
                for tally in family[level].values():
                    for member in ("max_error_u", "smallest_passing_tolerance", "range_events", "error_without_scale"):
                        tally.pop(member, None)
    witnesses = []
    for witness in record["witnesses"]:
        witness["shows"] = [what for what in witness["shows"] if not what.startswith("largest error of")]
        del witness["id"], witness["kernel"], witness["sides"]
        if witness["shows"]:
            witnesses.append(witness)
    record["witnesses"] = witnesses
    return record


class Pipe(Case):
    def bytes_of(self, *args, code=0, stdin=None):
        done = subprocess.run([BUILD / "axiscert", *map(str, args)], input=stdin, capture_output=True, timeout=600)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stdout

    def queries(self, *args):
        return self.bytes_of("generate", "--binary", *args)

    def answered(self, queries, program=PYTHON):
        done = subprocess.run(program, input=queries, capture_output=True, timeout=600)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def stored(self, name, replies):
        (self.folder / name).write_bytes(replies)
        return self.folder / name

    def judged(self, *args, out="judged", code=0, stdin=None):
        self.bytes_of("judge", *args, "--out", self.folder / out, code=code, stdin=stdin)
        return json.loads((self.folder / out / "record.json").read_text())

    def refused_replies(self, replies, *args, says):
        out = self.folder / "refused"
        done = self.refused("judge", self.stored("bad.bin", replies), *args, "--out", out, says=says)
        self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertFalse(out.exists(), "output was begun")

    def compiled(self, real):
        program = self.folder / f"published-{real}"
        subprocess.run(["cc", "-std=c99", "-O2", "-Wall", "-Wextra", "-Werror", "-pedantic", "-ffp-contract=off",
                        f"-DREAL={real}", "-o", program, EXAMPLES / "published.c"], check=True)
        return [program]

    def test_both_examples_are_judged_as_the_published_kernel_is(self):
        # Two units, the second one incomplete; every family; a mesh and a query file.
        mine = self.folder / "mine.jsonl"
        mine.write_text("".join(QUERY % r for r in (1, 2, 3)))
        plans = [(["--family", "tie", "--family", "repeated", "--seed", 5], (65536 + 1000) // DIVISOR),
                 (["--family", "all", "--mesh", SPIDER, "--queries", mine], 2000 // DIVISOR)]
        for sources, trials in plans:
            plan = [*sources, "--trials", trials, "--precision", "binary32"]
            own = comparable(self.run_ok(*plan))
            queries = self.queries(*plan)
            for program in (PYTHON, self.compiled("float")):
                replies = self.answered(queries, program)
                record = self.judged("--conforms-to", "published", stdin=replies)
                self.assertEqual(comparable(record), own, program)
                self.assertEqual(record["kernels"][0]["exposes"], ["verdict", "comparisons"])
                self.assertEqual(record["kernels"][0]["critical_radius"]["sampled"], 0)

    def test_files_at_both_ends_and_both_precisions(self):
        plan = ["--family", "sliver", "--family", "tie", "--trials", 5000 // DIVISOR]
        own = comparable(self.run_ok(*plan))
        files = []
        for precision, real in (("binary64", "double"), ("binary32", "float")):
            queries = self.folder / f"{precision}.queries"
            self.bytes_of("generate", *plan, "--precision", precision, "--binary", "-o", queries)
            self.assertEqual(queries.read_bytes(), self.queries(*plan, "--precision", precision))
            replies = self.answered(queries.read_bytes(), self.compiled(real))
            self.assertEqual(replies, self.answered(queries.read_bytes()))
            files.append(self.stored(f"{precision}.replies", replies))
        self.assertEqual(comparable(self.judged(*files, "--conforms-to", "published")), own)
        first = (self.folder / "judged/record.json").read_bytes()
        self.judged(*reversed(files), "--conforms-to", "published", "--threads", 1)
        self.assertEqual((self.folder / "judged/record.json").read_bytes(), first, "threads or order")

    def test_replies_that_are_judged_by_exact_sides_keep_their_positions(self):
        plan = ["--family", "tangent", "--trials", 3000, "--precision", "binary32"]
        own = comparable(self.run_ok(*plan, "--kernel", "ladder-9"))
        replies = self.answered(self.queries(*plan))
        self.assertEqual(comparable(self.judged("--conforms-to", "ladder-9", stdin=replies)), own)

    def test_the_folder_is_that_of_a_run_and_says_how_to_repeat_it(self):
        replies = self.answered(self.queries("--family", "repeated", "--trials", 2000))
        record = self.judged("--conforms-to", "published", "--as", "mine", stdin=replies)
        for name, schema in {name: SCHEMAS / f"{name}.schema.json" for name in ("record", "run")}.items():
            done = subprocess.run([sys.executable, VALIDATE, schema, self.folder / f"judged/{name}.json"],
                                  capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        report = (self.folder / "judged/report.md").read_text()
        for name in ("report.html", "junit.xml", "witnesses.jsonl"):
            self.assertGreater((self.folder / "judged" / name).stat().st_size, 0, name)
        self.assertEqual(record["kernels"][0]["id"], "mine")

        def repeated(command, out):
            """Runs a command of the report with the example as PROGRAM, and returns its record."""
            self.assertIn("PROGRAM", command)
            path = {"PATH": f"{BUILD}:{os.environ['PATH']}"}
            command = command.replace("PROGRAM", f"{PYTHON[0]} {PYTHON[1]}")
            subprocess.run(command, shell=True, check=True, cwd=self.folder, env={**os.environ, **path}, stdout=subprocess.PIPE)
            return json.loads((self.folder / out / "record.json").read_text())

        commands = [line for line in report.splitlines() if line.startswith("axiscert ")]
        self.assertEqual(repeated(next(c for c in commands if c.startswith("axiscert generate")), "out"), record)
        once = repeated(next(c for c in commands if c.startswith("axiscert query")), "witness")
        (family,) = once["kernels"][0]["families"].values()
        wrong = [family["verdict"][kind] for kind in ("false_separation", "false_contact")]
        self.assertEqual(sorted(wrong, key=str), [1, None], "the one query is of one kind")

    def test_what_the_program_is_said_to_be(self):
        queries = self.queries("--family", "repeated", "--family", "tangent", "--trials", 2000)
        replies = self.answered(queries)

        def links(*args, code=0, of=replies):
            record = self.judged(self.stored("r.bin", of), *args, code=code)
            (kernel,) = record["kernels"]
            self.assertEqual(record["plan"]["kernels"], ["pipe"])
            return kernel, {f: v["verdict"]["links"] for f, v in kernel["families"].items()}

        kernel, found = links()
        self.assertEqual(kernel["formulae"], "published")
        self.assertGreater(found["repeated"]["specification"], 0)
        self.assertGreater(found["tangent"]["unattributed"], 0)
        kernel, found = links("--conforms-to", "published")
        self.assertEqual([f["implementation"] for f in found.values()], [0, 0])
        self.assertGreater(found["tangent"]["rounding"], 0)
        kernel, found = links("--conforms-to", "nonstrict", "--require", "logic", code=1)
        self.assertGreater(found["repeated"]["implementation"], 0)
        self.assertEqual(kernel["strictness"], "nonstrict")
        kernel, found = links("--formulae", "reduced")
        self.assertEqual(kernel["formulae"], "reduced")
        self.assertEqual(found["tangent"]["implementation"], 0)

        # One flipped bit of one reply is an implementation fault of one comparison.
        (header_size,) = struct.unpack_from("<I", replies, 24)
        wrong = bytearray(replies)
        at = next(i for i in range(header_size, len(wrong), REPLY) if wrong[i] == 0 and not any(wrong[i + 8:i + REPLY]))
        wrong[at + 8] |= 2  # vertex_a.radius alone: no axis, no verdict
        record = self.judged(self.stored("wrong.bin", wrong), "--conforms-to", "published")
        flips = [f["comparisons"]["vertex_a.radius"]["links"]["implementation"]
                 for f in record["kernels"][0]["families"].values()]
        self.assertEqual(sum(flips), 1)

    def test_verdicts_alone(self):
        queries = self.queries("--family", "repeated", "--family", "lattice", "--trials", 1000)
        replies = bytearray(self.answered(queries))
        (header_size,) = struct.unpack_from("<I", replies, 24)
        for i in range(header_size, len(replies), REPLY):
            replies[i + 1:i + REPLY] = bytes(REPLY - 1)
        for i in range(header_size, header_size + 10 * REPLY, REPLY):
            replies[i] = 2
        record = self.judged(self.stored("v.bin", replies))
        (kernel,) = record["kernels"]
        self.assertIsNone(kernel["formulae"])
        self.assertEqual(kernel["exposes"], ["verdict"])
        self.assertEqual(kernel["families"]["repeated"]["verdict"]["undecided"], 10)
        links = kernel["families"]["lattice"]["verdict"]["links"]
        self.assertGreater(links["unattributed"], 0)
        self.assertEqual(sum(links.values()), links["unattributed"])
        self.judged("-", "--touching", "either", "--require", "exact", stdin=bytes(replies), code=1)

    def test_a_program_that_may_decline_says_so(self):
        """Ten replies are undecided, the others contact: the command alone says whether that is a fault."""
        queries = self.queries("--family", "lattice", "--trials", 1000)
        (size,) = struct.unpack_from("<I", queries, 24)
        replies = queries[:size] + b"\2".ljust(REPLY, b"\0") * 10 + bytes(REPLY) * 990
        for flag in ((), ("--may-decline",)):
            out = "may" if flag else "may-not"
            record = self.judged("-", *flag, "--require", "conservative=1", stdin=replies, out=out, code=0 if flag else 1)
            self.assertEqual((record["plan"]["replies"]["may_decline"], record["kernels"][0]["may_decline"]), (bool(flag),) * 2)
            self.assertEqual("--may-decline" in (self.folder / out / "report.md").read_text().split("PROGRAM")[1].split("\n")[0], bool(flag))

    def test_times_of_motions_are_judged(self):
        """Contact at the start is never late; at the end it is wherever the motion touches before."""
        plan = ("--predicate", "moving-sphere", "--family", "moving-sphere/general", "--trials", 400)
        late = {}
        for time in (0, 1):
            queries = self.queries(*plan, "--measures", 1)
            size, count = struct.unpack_from("<I", queries, 24)[0], struct.unpack_from("<Q", queries, 16)[0]
            self.assertEqual(count, 400)
            replies = queries[:size] + struct.pack("<BB6xQf", 0, 2, 0, time) * count
            file = self.stored(f"{time}.bin", replies)
            code = 0 if time == 0 else 1
            record = self.judged(file, "--require", "never-late", out=f"late{time}", code=code)
            late[time] = family(record, "moving-sphere/general", kernel="pipe")["contacts"]["time"]["late"]
            self.assertEqual(record["plan"]["replies"]["measures"], 1)
            self.assertEqual(record["kernels"][0]["measures"], ["time"])
        self.assertEqual(late[0], 0)
        self.assertGreater(late[1], 10)
        self.assertIn("--measures 1 | PROGRAM", (self.folder / "late1/report.md").read_text())
    def test_what_is_no_time_is_counted_and_nothing_is_lost(self):
        plan = ("--predicate", "moving-sphere", "--family", "moving-sphere/general", "--trials", 300)
        queries = self.queries(*plan, "--measures", 1)
        size, count = struct.unpack_from("<I", queries, 24)[0], struct.unpack_from("<Q", queries, 16)[0]
        replies = lambda time: queries[:size] + struct.pack("<BB6xQf", 0, 2, 0, time) * count
        contacts = None
        for kind, times in (("invalid", (-1e-45, -1, 1.0000002, 7, float("inf"), float("-inf"))), ("none", (float("nan"),))):
            for time in times:
                record = self.judged(self.stored("times.bin", replies(time)), "--require", "never-late", out=f"{kind}{time}", code=1)
                motion = family(record, "moving-sphere/general", kernel="pipe")["contacts"]
                self.assertEqual((motion["time"][kind], motion["time"]["late"]), (motion["answers"], 0), time)
                contacts = contacts or motion["answers"]
                self.assertEqual(motion["answers"], contacts)
                self.assertIn("pipe", (self.folder / f"{kind}{time}/report.md").read_text())
        self.assertGreater(contacts, 10)
        # Records without their measure, or with two, are no replies to this stream.
        for reply in (struct.pack("<BB6xQ", 0, 2, 0), struct.pack("<BB6xQff", 0, 2, 0, 0.5, 0.5)):
            self.refused_replies(queries[:size] + reply * count, says=["bad.bin"])
        self.refused_replies(replies(0.5)[:-3], says=["bad.bin"])

    def test_measures_are_of_a_test_that_has_them(self):
        plan = ("--predicate", "moving-sphere", "--family", "moving-sphere/general", "--trials", 400)
        done = axiscert("generate", "--binary", "--family", "point-box/general", "--measures", 1, program="axiscert_toy")
        self.assertEqual((done.returncode, "the predicate point-box has none" in done.stderr), (2, True), done.stderr)
        self.refused("generate", "--binary", *plan, "--measures", 9, says=["has 8, from time to point_z"])
        self.refused("generate", *plan, "--measures", 1, says=["--measures", "--binary"])

    def test_json_lines_are_a_query_file_with_addresses(self):
        lines = self.bytes_of("generate", "--family", "tie", "--mesh", SPIDER, "--trials", 3, "--precision", "binary64").decode()
        queries = [json.loads(line) for line in lines.splitlines()]
        self.assertEqual(len(queries), 6)
        self.assertEqual(queries[1]["id"], "1:tie:2:binary64:0:1")
        for query, line in zip(queries, lines.splitlines()):
            again = axiscert("query", query["id"], "--mesh", SPIDER)
            self.assertEqual(again.stdout, line + "\n", again.stderr)
        checked = axiscert("check", "-", stdin=lines)
        self.assertEqual(len([line for line in checked.stdout.splitlines() if not line.startswith(" ")]), 6, checked.stderr)

    def test_a_reader_that_has_enough_is_no_error(self):
        for options in (["--binary"], []):
            generate = subprocess.Popen([BUILD / "axiscert", "generate", *options], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            generate.stdout.read(100)
            generate.stdout.close()
            errors = generate.stderr.read()
            self.assertEqual((generate.wait(timeout=300), errors), (0, b""))
            generate.stderr.close()

    def test_what_generate_refuses(self):
        mine = self.folder / "mine.jsonl"
        mine.write_text(QUERY % 1)
        self.refused("generate", "--queries", mine, "--precision", "binary64", says=["no queries in binary64"])
        self.refused("generate", "--binary", "--queries", "-", stdin=QUERY % 1, says=["--queries -", "give a file"])
        self.refused("generate", "--precision", "binary16", says=["binary16"])
        self.refused("generate", "--trials", 1 << 62, "--family", "tie", says=["--trials", "too large"])
        self.refused("generate", "-o", self.folder / "none/q.bin", says=["none/q.bin", "cannot be written"])
        self.refused("generate", "-o", "/dev/full", "--family", "tie", "--trials", 9, says=["No space left"])
        primary, secondary = pty.openpty()
        done = subprocess.run([BUILD / "axiscert", "generate", "--binary"], stdout=secondary, stderr=subprocess.PIPE, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("terminal", done.stderr)
        done = subprocess.run([BUILD / "axiscert", "judge"], stdin=secondary, capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("nothing is piped in", done.stderr)
        os.close(primary), os.close(secondary)

    def test_bad_replies(self):
        good = self.answered(self.queries("--family", "tie", "--trials", 10))
        header = struct.unpack_from("<I", good, 24)[0]

        def changed(at, byte):
            return good[:at] + bytes([byte]) + good[at + 1:]

        third = header + 2 * REPLY
        self.refused_replies(b"", says=["bad.bin", "empty"])
        for version in (1, 2, 4):
            self.refused_replies(changed(8, version), says=[f"bad.bin: version {version} of the format, but this axiscert reads version 3: "
                                                            "generate the queries again, and reply as docs/pipe.md says"])
        self.refused_replies(b"starting up...\n" + good, says=["begins with text", "starting up", "standard error"])
        self.refused_replies(good[header:], says=["does not begin with AXISCERT"])
        self.refused_replies(good[:50], says=["ends after 50 bytes, inside the header"])
        self.refused_replies(changed(16, 11), says=["header was changed", "11 queries"])
        self.refused_replies(changed(70, 0), says=["header was changed", "SHA-256"])
        self.refused_replies(good[:header + 3 * REPLY], says=["ends after 3 of 10 replies"])
        self.refused_replies(good[:-1], says=["ends after 9 of 10 replies and 15 bytes"])
        self.refused_replies(good + b"\0", says=["continues after 10 of 10 replies"])
        self.refused_replies(good + b"10 queries answered\n", says=["continues after", "it is text, \"10 queries answered"])
        self.refused_replies(changed(third, 4), says=["reply 3 of 10", f"at byte {third}", "verdict 4"])
        self.refused_replies(changed(third + 1, 3), says=["reply 3 of 10", "flags 0x03"])
        self.refused_replies(changed(third + 1, 0), says=["reply 3 of 10", "no comparison bits, but"])
        self.refused_replies(changed(header, 1 - good[header]), says=["reply 1 of 10", "but its comparison bits", "say"])
        done = self.refused("judge", says=["stdin: empty"], stdin="")
        self.assertEqual(len(done.stderr.splitlines()), 1)
        done = self.refused("judge", self.folder / "none.bin", says=["none.bin"])
        # A program that passes the queries through has not answered them.
        self.refused_replies(self.queries("--family", "tie", "--trials", 10), says=["reply "])

    def test_claims_that_do_not_fit(self):
        good = self.answered(self.queries("--family", "tie", "--trials", 10))
        for args, says in {("--conforms-to", "nosuch"): ["unknown kernel 'nosuch'"],
                           ("--conforms-to", "eigen"): ["eigen", "--formulae eigen"],
                           ("--conforms-to", "minkowski"): ["minkowski", "no comparisons"],
                           ("--formulae", "closest-point"): ["closest-point", "no comparisons"],
                           ("--formulae", "plugin:x.so"): ["plugin:x.so", "built-in"],
                           ("--as", "published"): ["--as published", "built-in"],
                           ("--as", "a b"): ["--as a b"],
                           ("--require", "nosuch"): ["nosuch"],
                           ("--mesh", SPIDER): ["spider.obj", "none of the queries"]}.items():
            with self.subTest(args=args):
                self.refused_replies(good, *args, says=says)
        self.refused("judge", self.stored("g.bin", good), "--touching", "maybe", says=["--touching", "maybe"])
        self.refused("judge", self.folder / "g.bin", "--conforms-to", "published", "--formulae", "published", says=["--formulae"])
        self.refused("judge", self.folder / "g.bin", self.folder / "g.bin", says=["g.bin", "a second stream in binary32"])

    def test_a_file_that_is_gone_or_changed(self):
        mesh = self.folder / "mesh.obj"
        shutil.copy(SPIDER, mesh)
        replies = self.answered(self.queries("--mesh", mesh, "--trials", 10))
        self.judged("-", stdin=replies)
        mesh.rename(self.folder / "moved.obj")
        self.refused_replies(replies, says=["mesh.obj", "cannot be read", "--mesh FILE"])
        (self.folder / "elsewhere").mkdir()
        moved = self.folder / "elsewhere/mesh.obj"
        shutil.copy(SPIDER, moved)
        self.judged("-", "--mesh", moved, stdin=replies)
        mesh.write_text(SPIDER.read_text() + "# another file\n")
        self.refused_replies(replies, says=["mesh.obj", "is not the file", "SHA-256"])


if __name__ == "__main__":
    unittest.main()
