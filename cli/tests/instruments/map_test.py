#!/usr/bin/env python3
"""Maps: the pictures contain what the index counts, read by another PNG library; one clear line for every bad input."""
import json
import unittest

import jsonschema
from PIL import Image

from command import Case, axiscert, schema_of

# The sphere touches A; the nearest other feature is far away.
TOUCHING = {"id": "touching", "precision": "binary32", "a": [1, 0, 0], "b": [2, 1, 0], "c": [2, -1, 1], "p": [0, 0, 0],
            "r": 1}


class Map(Case):
    def map(self, *args, query=TOUCHING):
        done = axiscert("map", "-", *args, "--out", self.folder, "--format", "json", stdin=json.dumps(query))
        self.assertEqual(done.returncode, 0, done.stderr)
        (found,) = json.loads(done.stdout)["maps"]
        return found

    def index(self):
        index = json.loads((self.folder / "maps/index.json").read_text())
        jsonschema.validate(index, schema_of("maps"))
        return index

    def picture(self, file):
        with Image.open(self.folder / "maps" / file) as image:
            self.assertEqual(image.mode, "P")
            return image.convert("RGB")

    def test_pictures_are_what_the_index_counts(self):
        found = self.map("--size", 32, "--name", "ulps")
        index = self.index()
        self.assertEqual(index["maps"], [found])
        self.assertEqual(len(found["pictures"]), 1 + 7 + 16)
        colours = {entry["colour"]: entry["class"] for entry in index["legend"]}
        self.assertEqual(len(colours), 14)
        for entry in found["pictures"]:
            image = self.picture(entry["file"])
            self.assertEqual(image.size, (found["along"]["pixels"], found["across"]["pixels"]))
            counts = dict.fromkeys(entry["counts"], 0)
            for n, rgb in image.getcolors():
                counts[colours["#%02x%02x%02x" % rgb]] += n
            self.assertEqual(counts, entry["counts"], entry["name"])

    def test_a_pixel_is_where_the_index_says(self):
        found = self.map("--size", 16, "--what", "verdict")
        image = self.picture(found["pictures"][0]["file"])
        legend = {entry["colour"]: entry["class"] for entry in self.index()["legend"]}
        shown = lambda right, up: legend["#%02x%02x%02x" % image.getpixel(
            (found["along"]["origin"] + right, found["across"]["pixels"] - 1 - found["across"]["origin"] - up))]
        self.assertEqual(shown(0, 0), "tie")
        self.assertIn(shown(3, 0), ("yes", "yes_uncertain"))     # A farther away
        self.assertIn(shown(0, -3), ("yes", "yes_uncertain"))    # r smaller
        self.assertIn(shown(0, 3), ("no", "no_uncertain"))
        self.assertIn(shown(-3, 0), ("no", "no_uncertain"))

    def test_exponents_show_the_window(self):
        found = self.map("--exponents", "--what", "edge_ab.radius", "--what", "vertex_a.radius")
        self.assertEqual((found["along"]["pixels"], found["across"]["pixels"]), (277, 277))
        edge, vertex = ({p["name"]: p["counts"] for p in found["pictures"]}[n] for n in ("edge_ab.radius",
                                                                                         "vertex_a.radius"))
        self.assertGreater(edge["missed_separation"], vertex["missed_separation"])
        self.assertGreater(edge["no_query"], 0)

    def test_maps_gather_in_one_index(self):
        self.map("--size", 4, "--name", "one", "--what", "plane")
        self.map("--size", 4, "--name", "two", "--what", "plane")
        again = self.map("--size", 8, "--name", "one", "--what", "plane")
        maps = self.index()["maps"]
        self.assertEqual([m["name"] for m in maps], ["two", "one"])
        self.assertEqual(maps[1], again)

    def test_an_address_and_a_kernel_that_shows_only_verdicts(self):
        done = axiscert("map", "1:tangent:2:binary64:0:5", "--kernel", "closest-point", "--size", 8, "--out", self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        for part in ("closest-point in binary64", "along a.x", "verdict", "false_separation", "1 pictures"):
            self.assertIn(part, done.stdout)

    def test_bad_input(self):
        one = json.dumps(TOUCHING)
        self.refused("map", "-", "--along", "a.w", stdin=one, says=["a.w", "a.x"])
        self.refused("map", "-", "--along", "a", stdin=one, says=["a:", "--exponents"])
        self.refused("map", "-", "--along", "r", stdin=one, says=["--along r", "different"])
        self.refused("map", "-", "--exponents", "--along", "p", stdin=one, says=["p:", "zero"])
        self.refused("map", "-", "--exponents", "--ulps", 2, stdin=one, says=["--ulps", "excludes"])
        self.refused("map", "-", "--size", 5000, stdin=one, says=["--size", "4096"])
        self.refused("map", "-", "--what", "plain", stdin=one, says=["plain", "plane.radius"])
        self.refused("map", "-", "--kernel", "minkowski", "--what", "plane", stdin=one, says=["minkowski", "verdict"])
        self.refused("map", "-", stdin=one + "\n" + one, says=["2 queries", "--id"])
        self.refused("map", "-", "--id", "x", stdin=one, says=["--id x: unknown", "touching"])
        self.refused("map", "-", stdin=json.dumps({**TOUCHING, "r": -1}), says=["'touching'", "not a valid query"])
        self.refused("map", "-", "--kernel", "published+in-double", stdin=json.dumps({**TOUCHING, "precision": "binary64"}),
                     says=["in-double", "binary64"])
        self.refused("map", "-", "--name", "../x", "--out", self.folder, stdin=one, says=["../x", "letters"])

    def test_an_index_that_is_none_stays_as_it_is(self):
        self.map("--size", 4, "--what", "plane", "--name", "other")
        path = self.folder / "maps/index.json"
        good = path.read_text()
        for text, says in {"[]": ["axiscert-maps/3", "remove it, or give another --out"],
                           good[:-20]: ["axiscert-maps/3"],
                           good.replace("axiscert-maps/3", "axiscert-maps/2"): ["axiscert-maps/2", "axiscert-maps/3", "remove it"],
                           good.replace('"level": "axis"', '"level": "pane"'): ["/maps/0/pictures/0/level", "remove it"],
                           good.replace('"witness"', '"witless"'): ["/maps/0", "witness"]}.items():
            with self.subTest(says=says):
                self.assertNotEqual(text, good)
                path.write_text(text)
                self.refused("map", "-", "--size", 4, "--out", self.folder, stdin=json.dumps(TOUCHING),
                             says=["maps/index.json", *says])
                self.assertEqual(path.read_text(), text)


if __name__ == "__main__":
    unittest.main()
