#!/usr/bin/env python3
"""The kernels and arithmetics as a user sees them."""
import json
import unittest

from command import DIVISOR, QUERY, ROOT, Case, axiscert, family


class Kernels(Case):
    """Tests of the rungs, the other methods and the arithmetics, by their ids."""

    def listed(self):
        """The built-in kernels; the plug-ins supplied with axiscert have a '/' in their ids."""
        done = axiscert("kernels", "--format", "json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return [kernel for kernel in json.loads(done.stdout)["kernels"] if "/" not in kernel["id"]]

    def test_every_kernel_and_every_arithmetic_is_listed_once(self):
        listed = self.listed()
        ids = [kernel["id"] for kernel in listed] + [c["id"] for kernel in listed for c in kernel["arithmetics"]]
        self.assertEqual(len(ids), len(set(ids)))
        arithmetics = [c["arithmetic"] for c in listed[0]["arithmetics"]]
        self.assertEqual(len(arithmetics), len(set(arithmetics)))
        for kernel in listed:
            self.assertIn([c["arithmetic"] for c in kernel["arithmetics"]], [arithmetics, []], kernel["id"])
        refused = axiscert("check", "-", "--kernel", "nosuch").stderr.strip()
        others = [kernel["id"] for predicate in ("moving-sphere", "box-box", "box-triangle", "capsule-triangle")
                  for kernel in json.loads(axiscert("kernels", "--predicate", predicate, "--format", "json").stdout)["kernels"]]
        built_in = [kernel["id"] for kernel in listed] + [id for id in others if "/peer/" not in id]
        self.assertIn(f"; plugin:PATH.so or program:MANIFEST.json is one of your own; the nearest of {len(built_in)} kernels: ", refused)
        nearest = refused.split(" kernels: ")[1].split("; `axiscert kernels --predicate ID` lists them")[0].split(", ")
        self.assertEqual((len(nearest), set(nearest) - set(built_in)), (8, set()))
        refused = axiscert("check", "-", "--kernel", "published+nosuch").stderr.strip()
        text = axiscert("kernels").stdout.splitlines()
        parts = [line.split()[0][1:] for line in text if line.startswith("+") and line.split()[0].endswith("-")]
        permitted = [part + wish for part in parts for wish in ("misses", "invents")]
        self.assertGreater(len(permitted), 10)
        self.assertEqual(sorted(refused.split("; arithmetics: ")[1].split(", ")), sorted(arithmetics + permitted))
        refused = axiscert("check", "-", "--kernel", "certified@nosuch").stderr.strip()
        modes = refused.split("; modes: ")[1].split(", ")
        self.assertIn(f"instruction sets here: {', '.join(listed[0]['targets'])};", refused)
        for name in [kernel["id"] for kernel in listed] + ["+" + a for a in arithmetics] + ["@" + m for m in modes]:
            self.assertEqual(len([line for line in text if line.split()[:1] == [name]]), 1, name)

    def test_what_is_listed_exists_in_the_precisions_it_says(self):
        queries = {p: QUERY.replace("binary32", p) % 1 for p in ("binary32", "binary64")}
        for composed in self.listed()[2]["arithmetics"] + self.listed():
            for precision, query in queries.items():
                done = axiscert("check", "-", "--kernel", composed["id"], stdin=query)
                self.assertEqual(done.returncode, 0 if precision in composed["precisions"] else 2, done.stderr)

    def test_the_documentation_names_what_is_registered(self):
        tables, header = {}, None
        for line in (ROOT / "docs/kernels.md").read_text().splitlines():
            cells = [cell.strip() for cell in line.strip("|").split(" | ")] if line.startswith("|") else None
            if cells is None:
                header = None
            elif header is None:
                header = tuple(cells)
                tables[header] = []
            elif cells[0].startswith("`"):
                tables[header].append([cell.strip("`") for cell in cells])
        # A row may be of several kernels.
        named = {header: [name.strip("`") for row in rows for name in row[0].split("`, `")] for header, rows in tables.items()}
        listed = self.listed()
        ids, arithmetics = [k["id"] for k in listed], [c["arithmetic"] for c in listed[0]["arithmetics"]]
        for first, expected, registry in (("kernel", ids, "kernel/sphere_triangle/kernels.cpp"),
                                          ("arithmetic", arithmetics, "kernel/base/arithmetic_list.h")):
            found = {header: names for header, names in named.items() if header[0] == first}
            self.assertEqual(len(found), 1, f"docs/kernels.md: tables whose first column is '{first}'")
            for header, names in found.items():
                table = f"docs/kernels.md, table '{' | '.join(header)}'"
                for name in expected:
                    self.assertEqual(names.count(name), 1, f"{table} should have {first} '{name}' of {registry} once")
                for name in names:
                    self.assertIn(name, expected, f"{table} has '{name}', which is not in {registry}")
        refused = axiscert("check", "-", "--kernel", "certified@nosuch").stderr.strip()
        (calls,) = [names for header, names in named.items() if header[0] == "call"]
        self.assertEqual(calls[1:], refused.split("; modes: ")[1].split(", "))

    def test_the_slips_are_specification_faults(self):
        slips = ("first-publication", "vertex-typo")
        record = self.run_ok(*slips, "--family", "general", "--trials", 100000 // DIVISOR, "--precision", "binary32", "--require", "logic", code=1)
        told = json.loads((self.folder / "out/run.json").read_text())["requirements"]
        self.assertEqual([(one["kernel"], one["state"]) for one in told], [(kernel, "not met") for kernel in slips])
        for kernel in slips:
            self.assertGreater(family(record, "general", kernel=kernel)["verdict"]["links"]["specification"], 0)

    def test_the_reduced_test_has_no_fault_of_logic(self):
        self.run_ok("--kernel", "reduced-nonstrict", "--family", "all", "--trials", 1000, "--require", "logic")

    def test_every_kernel_is_judged_by_its_own_formulae(self):
        listed = self.listed()
        plan = [f"--kernel={kernel['id']}" for kernel in listed]
        plan += [f"--kernel={c['id']}" for c in listed[0]["arithmetics"] if c["precisions"] == ["binary32", "binary64"]]
        record = self.run_ok(*plan, "--family", "sliver", "--family", "repeated", "--family", "scale", "--trials", 200)
        self.assertEqual(len(record["kernels"]), 2 * len(plan))
        for entry in record["kernels"]:
            # Eigen chooses its own order of operations and some kernels claim no formulae: they have no reference, and a
            # difference has no known link.
            references = {"eigen": False} | {kernel["id"]: None for kernel in listed if kernel["formulae"] == ""}
            self.assertEqual(entry["reference"], references.get(entry["id"], True),
                             f"kernel '{entry['id']}': is_reference in kernel/sphere_triangle/kernels.cpp, references of this predicate")
            for name, found in entry["families"].items():
                links = found["verdict"]["links"]
                self.assertEqual(links is None, found["verdict"]["decided"] == 0, (entry["id"], name))
                if links is None:
                    continue
                self.assertEqual(links["implementation"], 0, (entry["id"], name))
                if entry["id"] not in ("eigen", "conservative"):
                    self.assertEqual(links["unattributed"], 0, (entry["id"], name))
        found = family(record, "sliver", kernel="eigen")
        self.assertGreater(found["verdict"]["links"]["unattributed"], 0)
        self.assertEqual(found["verdict"]["links"]["rounding"], 0)
        self.assertGreater(found["comparisons"]["plane.radius"]["links"]["unattributed"], 0)
        self.assertIsNone(family(record, "sliver", kernel="minkowski")["comparisons"])

    def test_a_precision_that_an_arithmetic_lacks(self):
        self.refused("run", "--kernel", "published+spu", "--precision", "binary64", "--out", self.folder / "out",
                     says=["--precision binary64", "published+spu", "binary32 only"])
        self.refused("check", "-", "--kernel", "published+world-double", stdin=QUERY % 1,
                     says=["query 'q'", "binary32", "published+world-double"])
        for wrong, says in (("published+nope", "unknown arithmetic 'nope'"), ("minkowski+fma", "'minkowski' is not a rung"),
                            ("nope+fma", "'nope' is not a rung")):
            done = self.refused("run", "--kernel", wrong, says=[wrong, says])
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)

    def test_a_kernel_is_judged_as_it_is_called(self):
        """The exact kernel is right in every way of calling it, in one run; the published one loses what is flushed, and rounds up."""
        targets = self.listed()[0]["targets"]
        exact = [f"certified@{target}" for target in targets] + ["certified@scalar,upward,flushed", "certified@downward"]
        plan = [f"--kernel={kernel}" for kernel in exact]
        plan += ["--family=scale", "--family=tangent", "--family=subnormal", "--trials", 2000]
        record = self.run_ok(*plan, "--kernel", f"certified@{targets[0].lower()}", "--require", "exact")
        self.assertEqual(list(dict.fromkeys(k["id"] for k in record["kernels"])), exact)

        record = self.run_ok(*plan, "--kernel", "published", "--kernel", f"published@{targets[0]}", "--kernel",
                             "published@flushed", "--require", "exact", code=1)
        plain, there, flushed = (family(record, "scale", kernel=k)["verdict"]
                                 for k in ("published", f"published@{targets[0]}", "published@flushed"))
        self.assertEqual(there, plain)
        self.assertGreater(flushed["false_contact"], plain["false_contact"])
        references = {k["id"]: k["reference"] for k in record["kernels"]}
        self.assertTrue(references[f"published@{targets[0]}"])
        self.assertFalse(references["published@flushed"])
        self.assertEqual(flushed["links"]["range"] + flushed["links"]["implementation"], 0)
        self.assertGreater(flushed["links"]["unattributed"], 0)

        record = self.run_ok("--kernel=published@upward", "--kernel=published+up", "--family=sliver", "--trials", 2000)
        called, arithmetic = (family(record, "sliver", kernel=k) for k in ("published@upward", "published+up"))
        for name, counts in arithmetic["comparisons"].items():
            for kind in ("false_separation", "missed_separation", "max_error_u"):
                self.assertEqual(called["comparisons"][name][kind], counts[kind], (name, kind))

    def test_what_cannot_be_called_otherwise(self):
        best = self.listed()[0]["targets"][0]
        for wrong, says in (("fault/none@upward", "process of its own"), ("ladder-0@" + best, "same instructions"),
                            ("certified@upward,downward", "two directions"), ("certified@", "instruction sets here: ")):
            done = self.refused("run", "--kernel", wrong, says=[wrong, says])
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        for command in ("ladder", "precision", "condition"):
            self.refused(command, "--kernel", "published@upward", says=["published@upward", "formulae"])


if __name__ == "__main__":
    unittest.main()
