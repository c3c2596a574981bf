#!/usr/bin/env python3
"""Wrong input: each message says what was given, where, and what would be right."""
import unittest

from command import BUILD, QUERY, Case, axiscert

PLUGIN = BUILD / "faults/none.so"
SMALL = ["--family", "general", "--trials", 4, "--precision", "binary32"]


class InputCase(Case):
    def one_line(self, *args, says, not_says=(), **more):
        done = self.refused(*args, says=says, **more)
        self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        for part in not_says:
            self.assertNotIn(part, done.stderr)
        return done.stderr


class Inputs(InputCase):
    def test_a_command_line_is_told_what_was_meant(self):
        for args, says in (([], ["a subcommand is missing", "run, certify, verify, check"]),
                           (["runn"], ["unknown subcommand 'runn'; did you mean 'run'?"]),
                           (["rum", "--family", "tangent"], ["unknown subcommand 'rum'; did you mean 'run'?"]),
                           (["--kernel", "published"], ["the option --kernel belongs after a subcommand, as in axiscert run --kernel"]),
                           (["frobnicate"], ["unknown subcommand 'frobnicate'; the nearest of "]),
                           (["corpus", "lst"], ["axiscert corpus: unknown subcommand 'lst'; did you mean 'list'?"]),
                           (["--versoin"], ["unknown option '--versoin'; did you mean '--version'?"]),
                           (["run", "--kernle", "published"], ["axiscert run: unknown option '--kernle'; did you mean '--kernel'?"]),
                           (["check", "--formt=text"], ["unknown option '--formt'; did you mean '--format'?"]),
                           (["run", "tangent"], ["'tangent' is not expected here; did you mean --family tangent?"]),
                           (["generate", "plugin:x.so"], ["'plugin:x.so' is not expected here"]),
                           (["diagnose", "published", "--kernel", "nonstrict"], ["--kernel is given 2 times (published, nonstrict); give it once"]),
                           (["diagnose"], ["axiscert diagnose: KERNEL is required"]),
                           (["check"], ["axiscert check: FILE is required"]),
                           (["run", "--kernel", "--quiet"], ["--kernel has no value: the option --quiet follows it"]),
                           (["run", "published", "--family"], ["--family has no value: the line ends after it; write --family VALUE"]),
                           (["run", "--format", "x"], ["--format: unknown value 'x'; values: text, csv"]),
                           (["run", "--map", "x"], ["unknown option '--map'"]),
                           (["kernels", "--format", "jsn"], ["unknown value 'jsn'; did you mean 'json'?", "text, json"]),
                           (["run", "--preset", "CI"], ["unknown value 'CI'; did you mean 'ci'?"])):
            with self.subTest(args=args):
                self.one_line(*args, says=says)

    def test_a_repeated_option_is_told_its_values(self):
        for option, first, second in (("--trials", 8, 9), ("--seed", 1, 2), ("--out", "o", "p"), ("--precision", "binary32", "binary64")):
            self.one_line("run", "--family", "general", option, first, option, second,
                          says=[f"axiscert run: {option} is given 2 times ({first}, {second}); give it once"])

    def test_numbers(self):
        for command, option in (("run", "--trials"), ("ladder", "--trials"), ("mutate", "--trials"), ("search", "--evaluations"),
                                ("shrink", "--evaluations")):
            file = ["-"] if command == "shrink" else []
            for given, says in (("99999999999999999999", "99999999999999999999 is too large; the greatest is"),
                                ("1e6", "'1e6' is not a whole number from 1 to"), ("1e6", "in digits: write 1000000"),
                                ("2^20", "write 1048576"), ("1,000", "write 1000"), ("many", "'many' is not a whole number from 1"),
                                ("0", "0 is too small; the least is 1"), ("-5", "'-5' is not a whole number")):
                with self.subTest(command=command, given=given):
                    self.one_line(command, *file, option, given, says=[option, says])
        for command in ("run", "ladder", "mutate", "search", "league", "generate", "plan"):
            for given in ("-1", "99999999999999999999", "1e3"):
                self.one_line(command, "--seed", given, says=["--seed", given, "too large" if given[0] == "9" else "in digits"])
        self.one_line("run", "--threads", 0, says=["0 is too small; the least is 1"])
        self.one_line("run", "--time", "5s", says=["'5s' is not a number > 0"])
        self.one_line("run", "--plugin-seconds", 0, says=["'0' is not a number from 0.001 to 1000000"])

    def test_names_nearest_first(self):
        for args, says in (
                (["--kernel", "publishd"], ["unknown kernel 'publishd'; did you mean 'published'?", " kernels: published, "]),
                (["--kernel", "fualt/inverted"], ["did you mean 'fault/inverted'?"]),
                (["--kernel", "fault/invertd"], ["did you mean 'fault/inverted'? the nearest of ", " kernels of fault/: inverted, "]),
                (["--kernel", "published,nonstrict"], ["one kernel is given at a time, without commas"]),
                (["--kernel", "published+fmaa"], ["unknown arithmetic 'fmaa'; did you mean 'fma'? arithmetics: fma, "]),
                (["--kernel", "publishd+fma"], ["did you mean 'published'? rungs that do: published, "]),
                (["--kernel", "published@upwards"], ["after '@', 'upwards'", "did you mean 'upward'?"]),
                (["--kernel", "nonstrict~operatr:0"], ["did you mean 'operator'?"]),
                (["--family", "tangnet"], ["unknown family 'tangnet'; did you mean 'tangent'? the nearest of ", " families: tangent, ", "; `axiscert families --predicate ID` lists them"]),
                (["--family", "tangent,sliver"], ["one name is given at a time"]),
                (["--precision", "float"], ["unknown precision 'float'; did you mean 'binary32'?"]),
                (["--precision", "64"], ["did you mean 'binary64'?"]), (["--precision", "binray32"], ["did you mean 'binary32'?"]),
                (["--predicate", "sphere"], ["unknown predicate 'sphere'; did you mean 'sphere-triangle'?"]),
                (["--tolerance", "edge_ab.radus=3"], ["unknown comparison 'edge_ab.radus'; did you mean 'edge_ab.radius'?"]),
                (["--require", "conservative=2"], ["--require conservative=2: D is a depth, a share of the scene from 0 to 1 in a predicate of sphere-triangle"]),
                (["--require", "depth=1.2"], ["--require depth=1.2: D is a depth, a share of the scene from 0 to 1 in a predicate of sphere-triangle"]),
                (["--predicate", "capsule-triangle", "--require", "depth=2.5"], ["--require depth=2.5: D is a depth, a share of the scene from 0 to 2 in a predicate of capsule-triangle"]),
                (["--predicate", "box-box", "--require", "depth=1.6"], ["--require depth=1.6: D is a depth, a share of the scene from 0 to 1.58 in a predicate of box-box"]),
                (["--require", "depth"], ["'depth': it is written depth=D"]),
                (["--require", "logic=1"], ["'logic=1': it is written logic"]),
                (["--require", "logc"], ["unknown requirement 'logc'; did you mean 'logic'? the nearest of ", " levels: logic, ", "; `axiscert run --help` lists them"]),
                (["--allow-unchecked", "range"], ["'range' may be left unchecked, but is not required"]),
                (["--require", "no-worse-than=nonstrict"], ["that kernel is not in this run; add --kernel nonstrict"])):
            with self.subTest(args=args):
                self.one_line("run", *args, "--out", self.folder / "out", says=says)
        self.assertFalse((self.folder / "out").exists(), "something was begun")
        for args, says in ((["search", "--comparison", "verdit"], ["--comparison verdit: unknown comparison"]),
                           (["map", "-", "--along", "ax"], ["did you mean 'a.x'?"]),
                           (["map", "-", "--what", "verdit"], ["did you mean 'verdict'?"]),
                           (["shrink", "-", "--what", "edge_ab.radus:error"], ["did you mean 'edge_ab.radius:error'?"]),
                           (["mutate", "--kernel", "nonstrct"], ["did you mean 'nonstrict'?"]),
                           (["mutate", "--mutant", "sgn"], ["did you mean 'sign'?"])):
            with self.subTest(args=args):
                self.one_line(*args, stdin=QUERY % 1, says=says)

    def test_a_plug_in_is_given_by_plugin_and_its_file(self):
        for given, says in ((PLUGIN, f"with 'plugin:' before the path: plugin:{PLUGIN}"), ("my_kernel.so", "plugin:my_kernel.so"),
                            (PLUGIN.with_suffix(""), f"plugin:{PLUGIN}"), (f"Plugin:{PLUGIN}", f": plugin:{PLUGIN}"),
                            (f"plugin={PLUGIN}", f": plugin:{PLUGIN}"), ("plugin", "plugin:PATH.so"),
                            ("plugin:", "no path after 'plugin:'"), (f"plugin:{self.folder}", f"{self.folder} is a directory"),
                            (f"plugin:{PLUGIN.parent}", "is a directory, which has copy_paste.so"),
                            (f"plugin:{PLUGIN.with_suffix('')}", f"did you mean plugin:{PLUGIN}?"),
                            (f"plugin:{PLUGIN.parent}/nnoe.so", f"did you mean plugin:{PLUGIN}?"),
                            ("plugin:nowhere/at.so", "there is no file nowhere/at.so")):
            for command in (["run", *SMALL], ["check", "-"], ["search"], ["critical-radius"]):
                with self.subTest(given=given, command=command):
                    self.one_line(*command, "--kernel", given, says=[f"kernel '{given}'", says])

    def test_a_directory_is_not_a_file(self):
        here = str(self.folder)
        for args in (["run", "--mesh", here], ["run", "--queries", here], ["check", here], ["shrink", here], ["map", here],
                     ["judge", here], ["run", "--plan", here], ["corpus", "add", here, "--name", "x", "--provenance", "made:x", "--folder", here]):
            with self.subTest(args=args):
                self.one_line(*args, says=[here, "is a directory"])

    def test_the_example_of_a_wrong_address_is_an_address(self):
        huge = 10**20
        for address, says in ((f"1:tangent:2:binary32:{huge}:0", f"unit {huge} is too large: at most {2**47 - 1}"),
                              (f"{huge}:tangent:2:binary32:0:0", f"seed {huge} is too large"),
                              ("1:tangent:4294967298:binary32:0:0", "version 4294967298 is too large"),
                              ("1:tangent:2:binary32:0:65536", "index 65536 is too large: at most 65535"),
                              ("1:tangent:2:binary32:0:-1", "index '-1' is not a whole number"), ("1:tangent", "2 fields instead of 6")):
            for command in (["query"], ["shrink"]) if address.count(":") else (["query"],):
                message = self.one_line(*command, address, says=[f"address '{address}'", says])
                example = message.split("for instance ")[1].strip()
                self.assertEqual(axiscert("query", example).returncode, 0, example)
        for command in (["query", "w12"], ["check", "w12", "--kernel", "published"], ["shrink", "w12"]):
            self.one_line(*command, says=["address 'w12': is the id of a witness", "grep '\"w12\"' out/witnesses.jsonl"])
        self.one_line("query", "1:tangnet:2:binary32:0:0", says=["address '1:tangnet:2:binary32:0:0'", "did you mean 'tangent'?"])
        stored = self.folder / "q.jsonl"
        stored.write_text(QUERY % 1)
        self.one_line("query", stored, says=["is a file", "axiscert check"])

    def test_query_files(self):
        header = "ax,ay,az,bx,by,bz,cx,cy,cz,px,py,pz,r"
        for text, says in ((header.replace(",", ";"), "separated by ';', not by ','"), (header.upper(), "lower case"),
                           (header.replace(",", "\t"), "separated by tabs"), ("0,0,0,1,0,0,0,1,0,0,0,1,1", "without a header"),
                           (header.replace(",r", ",radius"), "column 13 of the header is 'radius'"),
                           ("x,y,z,u,v,w", "CSV with another header, 'x,y,z,u,v,w'")):
            message = self.one_line("check", "-", stdin=text + "\n1\n", says=["stdin:1:", says, header], not_says=["malformed JSON"])
            self.assertNotIn("malformed", message)
        for name, wrong, says in (("precision", "precison", "'precison' (did you mean 'precision'?)"),
                                  ("r", "radius", "'radius' (did you mean 'r'?)"), ("p", "center", "'center' (did you mean 'p'?)")):
            self.one_line("check", "-", stdin=QUERY.replace(f'"{name}"', f'"{wrong}"') % 1, says=[f"field '{name}': missing", says])

    def test_fields_that_are_not_read_are_named_and_those_of_axiscert_are_not(self):
        extra = QUERY.replace("{", '{"Id":"x","colour":1,') % 1
        done = axiscert("check", "-", stdin=extra.replace('"id":"q",', "") * 3)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr.splitlines(), ["axiscert: stdin:1: field 'Id' is not read; did you mean 'id'?",
                                                    "axiscert: stdin:1: field 'colour' is not read"])
        self.run_ok("--family", "repeated", "--trials", 300, "--shrink", 20)
        for lines in [(self.folder / "out" / name).read_text() for name in ("witnesses.jsonl", "witnesses-shrunk.jsonl")]:
            self.assertEqual(axiscert("check", "-", stdin=lines).stderr, "")
        self.assertEqual(axiscert("run", "--corpus", "--out", self.folder / "corpus").stderr, "")
        shrunk = axiscert("shrink", "1:repeated:2:binary64:0:143", "--kernel", "published", "--format", "jsonl")
        self.assertEqual(axiscert("check", "-", stdin=shrunk.stdout).stderr, "")

    def test_a_folder_of_another_kind_is_told_what_writes_one(self):
        here, nowhere = str(self.folder), str(self.folder / "nowhere")
        for args, says in ((["merge", here], [here, "no part of a plan", "axiscert run --plan --shard --out"]),
                           (["merge", nowhere], [nowhere, "does not exist"]), (["report", here], ["axiscert run --out"]),
                           (["compare", here, here], ["axiscert run --out"]),
                           (["search", "--resume", "--out", here], [f"there is no {here}/search.state", "--out"])):
            with self.subTest(args=args):
                self.one_line(*args, says=says)

    def test_a_preset_says_nothing_of_what_was_not_asked(self):
        def said(*args):
            done = axiscert("run", *args, "--trials", 64, "--precision", "binary32", "--out", self.folder / "out")
            self.assertEqual(done.returncode, 0, done.stderr)
            return done.stderr

        self.assertEqual(said("--preset", "ci"), "")
        self.assertIn("corpus: --precision leaves out", said("--corpus"))

    def test_a_finding_has_its_precision_and_family(self):
        done = axiscert("run", "--kernel", f"plugin:{BUILD}/misbehaving/crash.so", "--family", "scale", "--precision", "binary32", "--trials", 3000, "--require", "logic", "--out", self.folder / "out")
        self.assertIn("crash.so binary32: crash on family scale", done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
