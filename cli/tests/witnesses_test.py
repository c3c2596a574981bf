#!/usr/bin/env python3
"""Every kind of witness of a run can be given back: to check by the command that the report prints, to shrink and to map."""
import json
import re
import unittest

from command import BUILD, Case, axiscert

RUNS = {
    "times": ("--predicate", "moving-sphere", "--kernel", "moving-sphere/rounded", "--kernel", "moving-sphere/gated", "--family",
              "moving-sphere/exact_time", "--family", "moving-sphere/seam_time", "--family", "moving-sphere/along_edge"),
    "images of motions": ("--predicate", "moving-sphere", "--kernel", "moving-sphere/rounded", "--family", "moving-sphere/orders",
                          "--family", "moving-sphere/split", "--family", "moving-sphere/halved"),
    "ends": ("--kernel", "moving-sphere/ends-rounded", "--family", "moving-sphere/ends_graze"),
    "spheres": ("--kernel", "published", "--family", "tangent", "--family", "axes", "--family", "units"),
    "images of boxes": ("--predicate", "box-box", "--kernel", "box-box/rtcd", "--kernel", "box-box/bullet"),
    "a plug-in": ("--kernel", f"plugin:{BUILD}/promises/always_contact.so", "--family", "general"),
}


def kind_of(reason):
    """What a witness shows, without its numbers and addresses."""
    return re.sub(r"(image|base) .*", r"\1", re.sub(r"-?\d[\d.e+-]*", "N", re.sub(r"(error|of) \w+\.\w+(\.\w+)?", r"\1 COMPARISON", reason)))


def in_decimals(value, digits):
    """The same with decimals for hexadecimal texts, as numbers and as texts in turn: by so many digits each is told from any other."""
    if isinstance(value, dict):
        return {name: in_decimals(part, digits) for name, part in value.items()}
    if isinstance(value, list):
        return [in_decimals(part, digits) for part in value]
    if not isinstance(value, str) or not re.fullmatch(r"-?0x[0-9a-f.]+p[-+]\d+", value):
        return value
    text = f"{float.fromhex(value):.{digits}g}"
    return text if len(text) % 2 else float(text)


class Witnesses(Case):
    def given_back(self, witness, line):
        query = axiscert("query", witness["address"])
        yield "query", query
        yield "check of the query", axiscert("check", "-", "--kernel", witness["kernel"], stdin=query.stdout)
        hexadecimal = axiscert("check", "-", "--kernel", witness["kernel"], stdin=line)
        yield "check", hexadecimal
        decimals = json.dumps(in_decimals(json.loads(line), 9 if witness["precision"] == "binary32" else 17))
        again = axiscert("check", "-", "--kernel", witness["kernel"], stdin=decimals)
        yield "check of decimals", again
        self.assertEqual(again.stdout, hexadecimal.stdout, "decimals name another query")
        yield "shrink of decimals", axiscert("shrink", "-", "--kernel", witness["kernel"], "--evaluations", "20", stdin=decimals)
        yield "map of decimals", axiscert("map", "-", "--kernel", witness["kernel"], "--size", "2", "--out", self.folder / "map",
                                          stdin=decimals)
        yield "shrink", axiscert("shrink", "-", "--kernel", witness["kernel"], "--evaluations", "20", stdin=line)
        yield "map", axiscert("map", "-", "--kernel", witness["kernel"], "--size", "2", "--out", self.folder / "map", stdin=line)

    def test_every_kind_can_be_given_back(self):
        seen = set()
        for number, (what, args) in enumerate(RUNS.items()):
            out = self.folder / str(number)
            done = axiscert("run", *args, "--trials", "300", "--out", out)
            self.assertEqual(done.returncode, 0, done.stderr)
            lines = {json.loads(line)["id"]: line for line in (out / "witnesses.jsonl").read_text().splitlines()}
            for witness in json.loads((out / "record.json").read_text())["witnesses"]:
                kinds = {(what, kind_of(reason)) for reason in witness["shows"]} - seen
                if not kinds:
                    continue
                seen |= kinds
                for command, given in self.given_back(witness, lines[witness["id"]]):
                    with self.subTest(command=command, what=what, shows=witness["shows"], address=witness["address"]):
                        self.assertEqual(given.returncode, 0, given.stderr + given.stdout)
        kinds = {kind for _, kind in seen}
        for expected in ("latest time: N ulps", "a wrong feature", "largest angle of a normal: N radians",
                         "deepest false_separation", "largest error of COMPARISON: N u"):
            self.assertIn(expected, kinds)
        self.assertTrue(any(kind.startswith("asymmetry: another verdict") for kind in kinds), sorted(kinds))

    def test_the_worst_measure_is_kept_and_another_on_demand(self):
        late = ('{"id":"late","predicate":"moving-sphere","precision":"binary32","a":[-10,-10,0],"b":[10,-10,0],"c":[0,10,0],'
                '"p":[0,0,3],"d":[0,0,-4],"r":1}')
        right = self.refused("shrink", "-", "--kernel", "moving-sphere/rounded", "--what", "normal", stdin=late, says=["has no normal that is wrong"])
        self.assertEqual(right.stdout, "")
        self.refused("shrink", "-", "--kernel", "published", "--what", "time", stdin=late, says=["unknown"])


class Promises(Case):
    def test_an_answer_on_a_side_or_within_a_margin_that_is_not_promised_is_outside(self):
        for kernel, member, value in (("front_alone", "sides", "front"), ("with_margin", "margin", 0.0625)):
            args = ("--kernel", f"plugin:{BUILD}/promises/{kernel}.so", "--family", "general", "--family", "grid", "--trials", "2000", "--require", "depth=0.001")
            record = self.run_ok(*args)
            entry = record["kernels"][0]
            self.assertEqual(entry["limits"][member], value)
            for family in entry["families"].values():
                self.assertFalse(family["verdict"]["false_separation"] or family["verdict"]["false_contact"])
            self.assertGreater(sum(family["verdict"]["outside_limits"]["trials"] for family in entry["families"].values()), 0)
            self.assertGreater(sum(family["verdict"]["outside_limits"][kind] or 0 for family in entry["families"].values()
                                   for kind in ("false_separation", "false_contact")), 0, "the planted skin and the culling are seen")
            self.assertIn(f"{member} ", axiscert("kernels", "--kernel", args[1]).stdout)

    def test_replies_declare_both(self):
        self.refused("judge", "-", "--sides", "back", stdin="", says=["--sides", "front"])
        self.refused("judge", "-", "--margin", "-1", stdin="", says=["--margin"])


if __name__ == "__main__":
    unittest.main()
