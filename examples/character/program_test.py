#!/usr/bin/env python3
"""The program gives the same output every time, a picture that shows it, refusals that say what would be right, and the
figures of README.md.

program_test.py BUILD_FOLDER MODELS_FOLDER TRIAL_DIVISOR [unittest arguments]
"""
import json
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
README = Path(__file__).with_name("README.md")
sys.path.insert(0, str(ROOT / "cli" / "tests"))
from command import BUILD, DIVISOR, MODELS, axiscert  # noqa: E402

SPIDER = MODELS / "OBJ/spider.obj"
SVG = "{http://www.w3.org/2000/svg}"
HAS_BULLET = (BUILD / "peers/bullet.so").exists()


def character(*args, program=BUILD / "character"):
    return subprocess.run([program, *map(str, args)], capture_output=True, text=True, timeout=300)


def tables(text):
    """The rows of the output's tables, each a list of words: those of the walk, of kernels by moment, and of kernels by
    triangle."""
    return [[line.split() for line in table.splitlines()[1:]] for table in text.split("NOT CHECKED")[0].split("\n\n")[1:]]


class Walked(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def walked(self, *args, **options):
        done = character(*args, **options)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "")
        return done.stdout


class Program(Walked):
    def test_the_same_walk_gives_the_same_bytes_and_another_seed_another(self):
        made = []
        for out in ("a.svg", "b.svg"):
            text = self.walked(SPIDER, "--steps", 100, "--out", self.folder / out)
            made.append((text, (self.folder / out).read_bytes()))
        self.assertEqual(*made)
        self.assertNotEqual(self.walked(SPIDER, "--steps", 100, "--seed", 2), made[0][0])

    def test_a_walk_meets_what_it_is_for(self):
        walk, kernels, _ = tables(self.walked(SPIDER, "--steps", 200))
        for row in walk:
            self.assertGreater(int(row[3]), 0, row)
        self.assertGreater(int(walk[-1][5]), 0, "no contact with a triangle without area")
        (published,) = [row for row in kernels if row[:2] == ["published", "all"]]
        self.assertGreater(int(published[2]), 0)
        self.assertGreater(int(published[3]), 0)

    def test_the_kernel_of_the_walk_itself_is_never_wrong(self):
        _, kernels, _ = tables(self.walked(SPIDER, "--steps", 200, "--kernel", "certified", "--kernel", "conservative"))
        for row in kernels:
            if row[0] == "certified":
                self.assertEqual(row[2:], ["0", "0", "0", "0"])
            else:
                self.assertEqual([row[2], row[4]], ["0", "0"], "conservative, which misses nothing")

    def test_the_picture_has_a_panel_a_kernel_and_marks_where_it_is_wrong(self):
        out = self.folder / "walk.svg"
        self.walked(SPIDER, "--steps", 100, "--kernel", "published", "--kernel", "certified", "--out", out)
        panels = [g for g in xml.parse(out).getroot().findall(f"{SVG}g") if g.find(f"{SVG}use") is not None]
        areas = [len([p for p in panel.iter(f"{SVG}path") if "area" in p.get("class", "")]) for panel in panels]
        self.assertEqual(len(areas), 3)
        self.assertEqual(areas[0], 0, "the walk's own panel")
        self.assertGreater(areas[1], 0, "published")
        self.assertEqual(areas[2], 0, "certified")

    def test_a_run_on_the_queries_of_a_walk_counts_what_the_walk_counts(self):
        file = self.folder / "walk.jsonl"
        walk, kernels, _ = tables(self.walked(SPIDER, "--steps", 20, "--kernel", "published", "--kernel", "certified", "--queries", file))
        lines = [json.loads(line) for line in file.read_text().splitlines()]
        (asked,) = [row for row in walk if row[0] == "all"]
        self.assertEqual(len(lines), int(asked[2]))
        self.assertEqual(len({line["id"] for line in lines}), len(lines), "each triangle of an ask once")
        for row in walk[:-1]:
            moments = [line["id"].split("-") for line in lines if line["id"].startswith(row[0] + "-")]
            self.assertEqual(len(moments), int(row[2]), row)
        done = axiscert("run", "--queries", file, "--precision", "binary32", "--kernel", "published", "--kernel", "certified",
                        "--out", self.folder / "run")
        self.assertEqual(done.returncode, 0, done.stderr)
        record = json.loads((self.folder / "run/record.json").read_text())
        for kernel in record["kernels"]:
            (found,) = kernel["families"].values()
            (row,) = [row for row in kernels if row[:2] == [kernel["id"], "all"]]
            self.assertEqual(found["trials"], len(lines))
            self.assertEqual([str(found["verdict"][kind]) for kind in ("false_separation", "false_contact")], row[2:4], row)

    def test_every_format_gives_the_same_walk(self):
        """The formats give the same triangles in the same order; the first line names the file."""
        walks = {self.walked(MODELS / file, "--steps", 50, "--up", "y", "--kernel", "published").split("\n", 1)[1]
                 for file in ("OBJ/WusonOBJ.obj", "PLY/Wuson.ply", "RAW/Wuson.raw")}
        self.assertEqual(len(walks), 1)

    def test_without_bullet_the_rest_is_done_and_that_is_said(self):
        program = self.folder / "character"
        shutil.copy(BUILD / "character", program)
        text = self.walked(SPIDER, "--steps", 20, program=program)
        self.assertIn("NOT CHECKED: ", text)
        self.assertIn("peer/bullet", text)
        self.assertEqual({row[0] for row in tables(text)[1]}, {"published"})

    def test_bad_input_is_refused_and_told_what_would_be_right(self):
        refusals = [
            ([], ["MESH is required"]),
            ([self.folder / "none.obj"], ["none.obj", "No such file or directory"]),
            ([MODELS / "OBJ/point_cloud.obj"], ["point_cloud.obj", "no triangles"]),
            ([MODELS / "invalid/malformed.obj"], ["malformed.obj", "not a mesh"]),
            ([SPIDER, "--steps", 0], ["--steps", "0", "1000000"]),
            ([SPIDER, "--steps", "many"], ["--steps", "many"]),
            ([SPIDER, "--seed", -1], ["--seed", "-1"]),
            ([SPIDER, "--seed", 2**64], ["--seed", str(2**64), "2^64 - 1"]),
            ([SPIDER, "--up", "w"], ["--up", "w", "x,y,z"]),
            ([SPIDER, "--radius", "wide"], ["--radius wide", "a number from"]),
            ([SPIDER, "--radius", "nan"], ["--radius nan", "a number from"]),
            ([SPIDER, "--radius", 0], ["--radius 0", "a number from"]),
            ([SPIDER, "--radius", -1], ["--radius -1", "a number from"]),
            ([SPIDER, "--radius", 1e9], ["--radius 1000000000.0", "a number from"]),
            ([SPIDER, "--kernel", "nobody"], ["nobody", "published"]),
            ([SPIDER, "--steps", 5, "--out", self.folder / "no/where.svg"], ["where.svg", "No such file or directory"]),
            ([SPIDER, "--steps", 5, "--queries", self.folder / "no/where.jsonl"], ["--queries", "where.jsonl", "No such file or directory"]),
        ]
        point = self.folder / "point.obj"
        point.write_text("v 1 1 1\nf 1 1 1\n")
        refusals.append(([point], ["point.obj", "diagonal 0"]))
        steep = self.folder / "steep.obj"
        steep.write_text("v 0 0 0\nv 0 1 0\nv 1 0.5 20\nf 1 2 3\n")
        refusals.append(([steep, "--up", "z", "--radius", "0.25"], ["nothing to stand on", "--up", "--radius"]))
        for arguments, says in refusals:
            with self.subTest(arguments=arguments):
                done = character(*arguments)
                self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
                self.assertEqual(done.stdout, "")
                for part in says:
                    self.assertIn(part, done.stderr)

    def test_the_least_radius_that_a_refusal_names_is_taken(self):
        said = character(SPIDER, "--radius", 0).stderr
        least = re.search(r"a number from (\S+) to", said).group(1)
        self.walked(SPIDER, "--steps", 1, "--radius", least)

    def test_a_walk_that_cannot_be_leaves_an_older_picture(self):
        steep, picture = self.folder / "steep.obj", self.folder / "old.svg"
        steep.write_text("v 0 0 0\nv 0 1 0\nv 1 0.5 20\nf 1 2 3\n")
        picture.write_text("older")
        self.assertEqual(character(steep, "--up", "z", "--radius", "0.25", "--out", picture).returncode, 2)
        self.assertEqual(picture.read_text(), "older")

    def test_faces_that_are_none_and_kernels_named_twice_are_told_and_dropped(self):
        mesh = self.folder / "floor.obj"
        mesh.write_text("v 0 0 0\nv 9 0 0\nv 0 9 0\nv 9 9 0\nv nan 0 0\nf 1 2 3\nf 2 4 3\nf 1 2 5\n")
        text = self.walked(mesh, "--up", "z", "--steps", 5, "--kernel", "published", "--kernel", "published")
        self.assertIn("floor.obj: 2 triangles, 0 of them without area, 1 with numbers that are not finite, or lines or points, left out; ", text)
        self.assertEqual(len([row for row in tables(text)[1] if row[1] == "all"]), 1)

    @unittest.skipUnless(HAS_BULLET and DIVISOR == 1, "the figures are those of a build with Bullet; sanitized they are slow")
    def test_the_figures_of_the_document_are_what_the_command_makes(self):
        section = re.search(r"## A walk\n(.*?)\n## ", README.read_text(), re.DOTALL)[1]
        blocks = re.findall(r"```\n\$ character (.*?)\n(.*?)```", section, re.DOTALL)
        self.assertTrue(blocks)
        for number in re.findall(r"\d[\d,]+\d", re.sub(r"```.*?```", "", section, flags=re.DOTALL)):
            self.assertRegex("".join(figures for _, figures in blocks), rf"\b{number.replace(',', '')}\b")
        for command, figures in blocks:
            arguments = [word.replace("/usr/share/assimp/models", str(MODELS)) for word in shlex.split(command)]
            self.assertEqual(self.walked(*arguments, "--out", self.folder / "walk.svg"), figures, command)
            stored = ROOT / "docs/plots" / f"walk-{Path(arguments[0]).stem}.svg"
            if stored.exists():
                self.assertEqual((self.folder / "walk.svg").read_bytes(), stored.read_bytes(), stored)


class Sweeps(Walked):
    def tables(self, *args):
        """The rows of a journey's tables by their first cell, "twenty, certain" among them; without their head."""
        found = []
        for table in self.walked(*args).split("\n\n")[1:]:
            rows = [re.split(r"\s{2,}", line.strip()) for line in table.splitlines()[1:]]
            found.append({row[0]: row[1:] for row in rows})
        return found

    def test_the_certain_sphere_enters_nothing_and_every_errand_meets_something(self):
        for errand in ("walk", "fall", "bullet"):
            motions, answers, entered, rates = self.tables(SPIDER, "--sweep", errand, "--steps", 40)
            self.assertEqual(len(motions), 4, errand)
            self.assertGreater(int(motions["twenty, certain"][1]), 0, errand)
            self.assertEqual(answers["twenty, certain"], ["0", "0", "-", "-"])
            self.assertEqual(entered["twenty, certain"], ["0", "0", "0", "-"])
            self.assertEqual(rates["twenty, certain"], ["0.00", "0.00", "-", "0.00", "0.00", "0.00"])

    def test_the_same_journey_gives_the_same_bytes_and_another_seed_another(self):
        made = [self.walked(SPIDER, "--sweep", "walk", "--steps", 30) for _ in range(2)]
        self.assertEqual(*made)
        self.assertNotEqual(self.walked(SPIDER, "--sweep", "walk", "--steps", 30, "--seed", 2), made[0])

    def test_a_run_on_the_motions_of_falls_counts_what_is_counted_here(self):
        file = self.folder / "falls.jsonl"
        kernel = "moving-sphere/rounded"  # it steers another sphere, and all falls are the same motions
        motions, answers, _, _ = self.tables(SPIDER, "--sweep", "fall", "--steps", 60, "--kernel", kernel, "--queries", file)
        lines = [json.loads(line) for line in file.read_text().splitlines()]
        self.assertEqual(len(lines), int(motions["twenty, certain"][2]))
        self.assertEqual({line["predicate"] for line in lines}, {"moving-sphere"})
        self.assertEqual(len({line["id"] for line in lines}), len(lines))
        done = axiscert("run", "--predicate", "moving-sphere", "--queries", file, "--precision", "binary32", "--kernel", kernel, "--out", self.folder / "run")
        self.assertEqual(done.returncode, 0, done.stderr)
        (judged,) = json.loads((self.folder / "run/record.json").read_text())["kernels"]
        (found,) = judged["families"].values()
        self.assertEqual(found["trials"], len(lines))
        self.assertEqual(found["truth"]["contact"], int(motions[kernel][3]))
        self.assertEqual([str(found["verdict"][kind]) for kind in ("false_separation", "false_contact")], answers[kernel][:2])

    def test_bad_options_are_refused(self):
        for arguments, says in (
                ([SPIDER, "--sweep", "swim"], ["--sweep", "swim", "walk"]),
                ([SPIDER, "--sweep", "walk", "--kernel", "published"], ["--kernel published", "sphere-triangle", "moving-sphere"]),
                ([SPIDER, "--kernel", "moving-sphere/rounded"], ["--kernel moving-sphere/rounded", "--sweep"]),
                ([SPIDER, "--sweep", "walk", "--out", self.folder / "walk.svg"], ["--sweep", "--out"]),
                ([SPIDER, "--stride", 4], ["--stride", "--sweep"]),
                ([SPIDER, "--sweep", "walk", "--stride", 0], ["--stride", "0.125"]),
                ([SPIDER, "--sweep", "walk", "--skin", 1], ["--skin", "0.5"])):
            with self.subTest(arguments=arguments):
                done = character(*arguments)
                self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
                self.assertEqual(done.stdout, "")
                for part in says:
                    self.assertIn(part, done.stderr)

    @unittest.skipUnless(DIVISOR == 1, "sanitized they are slow")
    def test_the_figures_of_the_document_are_what_the_command_makes(self):
        section = re.search(r"### Bullets\n(.*?)\n## ", README.read_text(), re.DOTALL)[1]
        blocks = re.findall(r"```\n\$ character (.*?)\n(.*?)```", section, re.DOTALL)
        self.assertTrue(blocks)
        for command, figures in blocks:
            self.assertEqual(self.walked(*(word.replace("/usr/share/assimp/models", str(MODELS)) for word in shlex.split(command))), figures, command)


if __name__ == "__main__":
    unittest.main()
