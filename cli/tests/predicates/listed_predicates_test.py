#!/usr/bin/env python3
"""The list of `axiscert predicates` compared with what the other commands say."""
import json
import unittest

from command import Case, axiscert


class Tests(Case):
    def listed(self):
        done = axiscert("predicates", "--format", "json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)["predicates"]

    def test_sphere_triangle_is_what_a_record_calls_it(self):
        record = self.run_ok("--kernel", "published", "--family", "general", "--trials", "10", "--precision", "binary32")
        first = self.listed()[0]
        self.assertEqual(first["id"], "sphere-triangle")
        counted = record["kernels"][0]["families"]["general"]
        self.assertEqual({c["name"] for c in first["comparisons"]}, set(counted["comparisons"]))
        self.assertEqual({c["name"] for c in first["clauses"]}, set(counted["axes"]))
        for clause in first["clauses"]:
            self.assertEqual(clause["comparisons"],
                             [c["name"] for c in first["comparisons"] if c["clause"] == clause["name"]])
        (entry,) = first["entries"]
        header = "ax,ay,az,bx,by,bz,cx,cy,cz,px,py,pz,r"
        self.assertEqual(",".join(column["name"] for column in entry["columns"]), header)
        self.refused("check", "-", stdin=header.replace("ax", "no") + "\n", says=[entry["columns"][0]["name"]])

    def test_each_kernel_and_family_is_of_one_test(self):
        for member, command in (("kernels", "kernels"), ("families", "families")):
            for predicate in self.listed():
                named = json.loads(axiscert(command, "--predicate", predicate["id"], "--format", "json").stdout)[command]
                names = [one.get("id", one.get("name")) for one in named]
                shipped = ("peer/", "fault/", predicate["id"] + "/peer/", predicate["id"] + "/fault/")
                self.assertEqual(predicate[member], [name for name in names if not name.startswith(shipped)])
                self.assertEqual({one["predicate"] for one in named}, {predicate["id"]} if named else set())

    def test_the_first_test_is_the_default(self):
        for command in ("kernels", "families"):
            for form in ("text", "json"):
                self.assertEqual(axiscert(command, "--format", form).stdout,
                                 axiscert(command, "--predicate", "sphere-triangle", "--format", form).stdout)
        options = ["--family", "tangent", "--trials", "100", "--precision", "binary32"]
        self.assertEqual(axiscert("generate", *options).stdout,
                         axiscert("generate", "--predicate", "sphere-triangle", *options).stdout)
        for name, predicate in (("without", []), ("with", ["--predicate", "sphere-triangle"])):
            self.run_ok(*options, *predicate, out=name)
            self.assertEqual(axiscert("plan", *options, *predicate, "-o", self.folder / f"{name}.json").returncode, 0)
        for file in ("record.json", "witnesses.jsonl", "ratchet.txt"):
            self.assertEqual((self.folder / "without" / file).read_bytes(), (self.folder / "with" / file).read_bytes(), file)
        self.assertEqual((self.folder / "without.json").read_bytes(), (self.folder / "with.json").read_bytes())

    def test_an_unknown_test_is_one_clear_line(self):
        for command in ("run", "plan", "generate", "kernels", "families"):
            done = self.refused(command, "--predicate", "nosuch", says=["unknown predicate 'nosuch'; predicates: box-box, moving-sphere, box-triangle, capsule-triangle, sphere-triangle"])
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        self.refused("run", "--plan", "plan.json", "--predicate", "sphere-triangle", says=["--plan", "--predicate"])

    def test_the_text_has_each_name(self):
        text = axiscert("predicates").stdout
        for predicate in self.listed():
            self.assertIn(f"{predicate['id']}: {predicate['asks']}", text)
            for kind in ("comparisons", "clauses", "measures", "entries", "wrong_answers"):
                for one in predicate[kind]:
                    self.assertIn(one["name"], text)
            self.assertIn(f"{len(predicate['kernels'])} kernels, {len(predicate['families'])} families", text)


if __name__ == "__main__":
    unittest.main()
