#!/usr/bin/env python3
"""The list of `axiscert tests` compared with what the other commands say."""
import json
import unittest

from command import Case, axiscert


class Tests(Case):
    def listed(self):
        done = axiscert("tests", "--format", "json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

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
            named = json.loads(axiscert(command, "--format", "json").stdout)
            names = [one.get("id", one.get("name")) for one in named if "/" not in one.get("id", "")]
            self.assertEqual([name for test in self.listed() for name in test[member]], names)

    def test_the_text_has_each_name(self):
        text = axiscert("tests").stdout
        for test in self.listed():
            self.assertIn(f"{test['id']}: {test['asks']}", text)
            for kind in ("comparisons", "clauses", "measures", "entries", "wrong_answers"):
                for one in test[kind]:
                    self.assertIn(one["name"], text)
            self.assertIn(f"{len(test['kernels'])} kernels, {len(test['families'])} families", text)


if __name__ == "__main__":
    unittest.main()
