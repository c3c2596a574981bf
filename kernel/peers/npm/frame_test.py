#!/usr/bin/env python3
"""The frame of the engines (engines/frame.mjs) with streams, with engines that throw, trap and print, and with what is no
stream; and that manifests, lock file and package.json say the same. Needs node and no package; without node nothing is checked: exit
code 77.

frame_test.py [unittest arguments]
"""
import json
import math
import re
import shutil
import struct
import subprocess
import sys
import time
import unittest

import asking

TOY = ["node", "frame_toy.mjs"]
RIGHT, REFUSED, TRAP, PRINTS, MADE_ONCE, TALKS, ABORT, NO_VERDICT = range(8)


def query(what, r=1.0):
    return [what] + [0.0] * 11 + [r]


def ask(queries, precision="binary32"):
    return asking.ask(TOY, asking.FOLDER, queries, precision)


def run(sent):
    return asking.run(TOY, asking.FOLDER, sent)


class Answers(unittest.TestCase):
    def test_replies_are_in_the_order_of_the_queries_whatever_their_number(self):
        for count in (0, 1, 63, 64, 65, 1000):
            radii = [(i * 7 + i // 64) % 3 / 2 for i in range(count)]
            self.assertEqual(ask([query(RIGHT, r) for r in radii]), ["contact" if r >= 1 else "separated" for r in radii])

    def test_binary64_is_read_as_such(self):
        self.assertEqual(ask([query(RIGHT, 1 - 2**-50), query(RIGHT, 1)], "binary64"), ["separated", "contact"])

    def test_what_is_no_query_is_invalid_and_not_handed_on(self):
        asked = [query(TRAP)[:k] + [number] + query(TRAP)[k + 1:] for k in range(13) for number in (math.nan, math.inf, -math.inf)]
        asked.append(query(TRAP, -2**-149))
        self.assertEqual(ask(asked + [query(MADE_ONCE)]), ["invalid"] * len(asked) + ["contact"])
        self.assertEqual(ask([query(RIGHT, -0.0)]), ["separated"])

    def test_an_exception_declines_one_query(self):
        self.assertEqual(ask([query(RIGHT), query(REFUSED), query(MADE_ONCE)]), ["contact", "undecided", "contact"])

    def test_after_a_trap_and_an_abort_the_engine_is_made_anew(self):
        for end in (TRAP, ABORT):
            self.assertEqual(ask([query(MADE_ONCE), query(end), query(MADE_ONCE), query(RIGHT)]),
                             ["contact", "undecided", "separated", "contact"])

    def test_what_engines_print_is_on_standard_error_and_bounded(self):
        self.assertEqual(ask([query(PRINTS), query(TALKS)]), ["separated", "contact"])
        done = run(asking.stream([query(PRINTS), query(TALKS)]))
        self.assertIn(b"a line for the console\n", done.stderr)
        self.assertLessEqual(len(done.stderr.splitlines()), 20)

    def test_a_program_answers_one_stream_after_another(self):
        self.assertEqual(asking.ask_each(TOY, asking.FOLDER, [[query(RIGHT)] * 3, [], [query(TRAP)], [query(MADE_ONCE)]]),
                         [["contact"] * 3, [], ["undecided"], ["separated"]])

    def test_another_predicate_has_its_own_columns(self):
        moved = [query(RIGHT)[:12] + rest for rest in ([0, 0, 7, 1], [7, 0, 0, 1], [-7, 0, 7, 0], [0, 0, 7, -1])]
        self.assertEqual(asking.ask(TOY, asking.FOLDER, moved, question="moving-sphere"),
                         ["contact", "separated", "contact", "invalid"])

    def test_an_entry_has_its_own_columns_and_its_own_queries(self):
        box, triangle, turn = [0.0] * 3 + [1.0] * 3, [1.0] * 9, [1.0, 0, 0, 0]

        def with_number(query, k, number):
            return query[:k] + [number] + query[k + 1:]

        # A query, and the columns of which each makes it none with the number given: a half extent below 0, a corner above the other.
        for question, query, none in (("box-triangle/centre", box + triangle, {3: -1, 4: -1, 5: -1}),
                                      ("box-triangle/minmax", box + triangle, {0: 2, 1: 2, 2: 2, 3: -1, 4: -1, 5: -1}),
                                      ("box-box/quaternion", box + turn + box + turn, {3: -1, 4: -1, 5: -1, 13: -1, 14: -1, 15: -1})):
            with self.subTest(question):
                asked = [query, with_number(query, len(query) - 1, 7.0)] + [with_number(query, k, number) for k, number in none.items()]
                self.assertEqual(asking.ask(TOY, asking.FOLDER, asked, "binary64", question), ["separated", "contact"] + ["invalid"] * len(none))
        for none in (box + [0.0] * 4 + box + turn, box + turn + box + [0.0] * 4):
            self.assertEqual(asking.ask(TOY, asking.FOLDER, [none], question="box-box/quaternion"), ["invalid"])

    def test_measures_follow_each_reply_where_the_stream_asks_for_them(self):
        moved = [query(RIGHT)[:12] + [0, 0, dz, 1] for dz in (7, 0, 8, 9, math.nan)]
        for precision in ("binary32", "binary64"):
            for count in (1, 5, 8):
                answers = asking.ask_measures(TOY, asking.FOLDER, moved, count, precision)
                self.assertEqual([verdict for verdict, _ in answers], ["contact", "separated", "invalid", "contact", "invalid"])
                self.assertEqual(str(answers[0][1]), str([0.5, math.nan, 0.0, 0.0, 1.0, math.nan, math.nan, math.nan][:count]))
                for _, said in answers[1:]:
                    self.assertTrue(all(math.isnan(number) for number in said), said)
        self.assertEqual(asking.ask(TOY, asking.FOLDER, moved, question="moving-sphere"),
                         ["contact", "separated", "invalid", "contact", "invalid"])

    def test_replies_come_before_the_input_ends(self):
        sent = asking.stream([query(RIGHT)])
        with subprocess.Popen(TOY, cwd=asking.FOLDER, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as program:
            for _ in range(2):
                program.stdin.write(sent)
                program.stdin.flush()
                answer = program.stdout.read(struct.unpack_from("<I", sent, 24)[0] + asking.REPLY)
                self.assertEqual(asking.verdicts(answer, sent, 1), (["contact"], b""))
            program.stdin.close()
            self.assertEqual(program.wait(asking.SECONDS), 0)

    def test_input_that_comes_in_pieces_is_put_together(self):
        radii = [i % 2 for i in range(8)]
        sent = asking.stream([query(RIGHT, r) for r in radii])
        with subprocess.Popen(TOY, cwd=asking.FOLDER, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as program:
            program.stdin.write(asking.stream([]))
            program.stdin.flush()
            program.stdout.read(len(asking.stream([])))  # from here on it waits for every piece
            for first in range(0, len(sent), 50):
                program.stdin.write(sent[first:first + 50])
                program.stdin.flush()
                time.sleep(0.01)
            program.stdin.close()
            self.assertEqual(asking.verdicts(program.stdout.read(), sent, 8), (["contact" if r else "separated" for r in radii], b""))


class Faulty(unittest.TestCase):
    def test_an_engine_that_returns_no_verdict_ends_the_program(self):
        done = run(asking.stream([query(RIGHT), query(NO_VERDICT)]))
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"query 1: 'contact' is not a verdict", done.stderr)


class NoStream(unittest.TestCase):
    def refused(self, sent, says):
        done = run(sent)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn(says, done.stderr.decode())
        self.assertEqual(len(done.stderr.splitlines()), 1)

    def test_nothing_at_all_is_the_end(self):
        done = run(b"")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, b"", b""))

    def test_each_is_refused_in_a_line(self):
        good = asking.stream([query(RIGHT)] * 3)

        def with_field(offset, value):
            return good[:offset] + struct.pack("<I", value) + good[offset + 4:]

        for sent, says in ((b"{}", "not a query stream"), (b"x" * 200, "not a query stream"), (good[:70], "within its header"),
                           (good[:-1], "ends after 2 of 3 queries"), (with_field(8, 1), "version is 1; this program reads 3"),
                           (with_field(8, 2), "version is 2; this program reads 3"), (with_field(8, 4), "version is 4"),
                           (with_field(12, 16), "precision is 16"), (with_field(24, 32), "header's size is 32"),
                           (with_field(24, 2**21), "header's size"), (with_field(28, 51), "has 52 bytes, not 51"),
                           (good + b"AXIS", "not a query stream"),
                           (asking.stream([], question="moving-sphere").replace(b"moving-sphere", b"parking-cones"), "'parking-cones'"),
                           (asking.stream([], question="moving-sphere").replace(b'{"predicate"', b'["predicate"'), "JSON"),
                           (asking.stream([], question="moving-sphere", measures=9), "9 measures; moving-sphere has 8"),
                           (asking.stream([], question="moving-sphere", measures="x"), "x measures")):
            with self.subTest(says):
                self.refused(sent, says)


class Manifests(unittest.TestCase):
    MANIFESTS = asking.manifests()
    WANTED = json.loads((asking.FOLDER / "package.json").read_text())["dependencies"]
    IMPORTS = re.compile(r"^import .*? from '(\.[^']*)';$", re.MULTILINE)

    def test_each_names_a_program_that_is_there_and_the_version_that_is_installed(self):
        self.assertTrue(self.MANIFESTS)
        for file, of in self.MANIFESTS.items():
            with self.subTest(file):
                self.assertEqual(of["format"], "axiscert-program/2")
                self.assertEqual(of["name"].replace("/", "-") + ".json", file.name)
                self.assertEqual(self.WANTED[of["package"]], of["version"])
                self.assertEqual(of["command"][0], "node")
                program = (file.parent / of["command"][1]).read_text()
                for form in of["command"][2:]:
                    self.assertIn(f"'{form}':", program)
                self.assertIn(of["touching"], ("contact", "separated", "either"))
                self.assertIs(of.get("may_decline"), True)  # what an engine throws, the frame declines
                self.assertLessEqual(set(of["precisions"]), {"binary32", "binary64"})
                self.assertEqual(of["predicate"], file.parent.name)
                self.assertIn(asking.question_of(of), asking.COLUMNS)
                self.assertIn(of.get("measures", 0), (8,) if of["predicate"] == "moving-sphere" else (0, 8 if of["predicate"] == "sphere-triangle" else 10))

    def test_each_names_the_files_that_its_answers_depend_on(self):
        for file, of in self.MANIFESTS.items():
            with self.subTest(file):
                found, to_read = {(asking.FOLDER / "package-lock.json").resolve()}, [(file.parent / of["command"][1]).resolve()]
                while to_read:
                    at = to_read.pop()
                    used = {(at.parent / name).resolve() for name in self.IMPORTS.findall(at.read_text())}
                    to_read += used - found
                    found |= used
                self.assertEqual({(file.parent / name).resolve() for name in of["files"]}, found)

    def test_every_engine_has_one(self):
        self.assertEqual({of["package"] for of in self.MANIFESTS.values()}, set(self.WANTED))

    def test_versions_are_exact_and_the_lock_file_has_them_and_no_address(self):
        text = (asking.FOLDER / "package-lock.json").read_text()
        self.assertNotIn("://", text)
        locked = json.loads(text)["packages"]
        for package, version in self.WANTED.items():
            self.assertRegex(version, r"^\d+\.\d+\.\d+$")
            self.assertEqual(locked["node_modules/" + package]["version"], version)
        for name, package in locked.items():
            if name:
                self.assertIn("integrity", package, name)


if __name__ == "__main__":
    if shutil.which("node") is None:
        print("NOT CHECKED: node is not installed; `./dev engines` brings it", file=sys.stderr)
        sys.exit(77)
    unittest.main()
