"""Includes run one way: from a layer to those before it, and between the rooms (folders) of a layer in the order of rooms.txt beside
this file.

    rooms_test.py ROOT          checks it, and names the file and the line of each include that runs the other way
    rooms_test.py ROOT --draw   prints every room with the rooms that it includes

Tests and benchmarks (`_test.cpp`, `_bench.cpp`, and the headers with `testing` in their path that they share) may look into every room of
their own layer and of those before it. Nothing else includes them.

The imports of the theory run one way too, between the folders of proofs/coq.
"""
import os
import re
import sys
import unittest
from collections import defaultdict
from pathlib import Path

DRAW = "--draw" in sys.argv
if DRAW:
    sys.argv.remove("--draw")
ROOT = Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 else Path(__file__).resolve().parents[2]
LAYERS = ("kernel", "proofs", "exact", "fuzz", "reports", "plans", "python", "cli")
# Folders of two floors. The words in which the others speak (a query, a comparison, the formulae) stand below the rooms inside the folder;
# what is made of these rooms (the list of the test's kernels) above them.
WORDS = {
    "kernel/sphere_triangle": "formulae.h names.h proved_bounds.h query.h".split(),
}
THEORY = "proofs/coq"
ORDER = "docs/checks/rooms.txt"
IMPORT = re.compile(r"\bFrom Axiscert Require (?:Import |Export )?([\w\s]+)\.")
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^">]+)[">]')


def sources():
    """Path and text of every C and C++ source of the layers."""
    found = {}
    for layer in LAYERS:
        for path in (ROOT / layer).rglob("*"):
            if path.suffix in (".h", ".hpp", ".c", ".cpp"):
                found[path.relative_to(ROOT).as_posix()] = path.read_text()
    return found


def theory():
    """Path and text of every file of the theory; of those that are made in the build, which import what they are checked against, none."""
    made = {f"{THEORY}/{name}": "" for name in (ROOT / THEORY / "_CoqProject").read_text().split() if name.endswith(".v")}
    return made | {path.relative_to(ROOT).as_posix(): path.read_text() for path in (ROOT / THEORY).rglob("*.v")}


def room_of(file):
    folder, name = file.rsplit("/", 1)
    return folder + "/words" if name in WORDS.get(folder, ()) else folder


def layer_of(file):
    return THEORY if file.startswith(THEORY + "/") else file.split("/")[0]


def is_for_tests(file):
    return file.endswith(("_test.cpp", "_bench.cpp")) or "testing" in file


def orders():
    """The rooms of each layer and of the theory, in the order of rooms.txt: `LAYER: ROOM < ROOM ...`, continued on indented lines."""
    text = "\n".join(line for line in (Path(__file__).parent / "rooms.txt").read_text().split("\n") if not line.startswith("#"))
    return {layer: [layer if name == "(top)" else f"{layer}/{name}" for name in re.split(r"\s*<\s*", rooms.strip())]
            for layer, rooms in re.findall(r"^(\S+): (.+(?:\n +.+)*)", text, re.M)}


def arrows(texts):
    """(file, line, included file) of every include that crosses from one room into another."""
    found = []
    for file, text in texts.items():
        for number, line in enumerate(text.split("\n"), 1):
            included = INCLUDE.match(line)
            if not included:
                continue
            name = included[1]
            beside = os.path.normpath(os.path.join(os.path.dirname(file), name))
            target = next((path for path in (name, beside, "kernel/include/" + name) if path in texts), None)
            if target and room_of(target) != room_of(file):
                found.append((file, number, target))
    return found


def upward(texts, order):
    """A line for each include that runs against the order of the layers or of the rooms."""
    wrong = []
    for file, number, target in arrows(texts):
        layer, other = layer_of(file), layer_of(target)
        if layer != other:
            if LAYERS.index(layer) < LAYERS.index(other):
                wrong.append(f"{file}:{number} includes {target}: {layer}/ comes before {other}/")
        elif is_for_tests(target) and not is_for_tests(file):
            wrong.append(f"{file}:{number} includes {target}, which is for tests alone")
        elif not is_for_tests(file):
            rooms = order[layer]
            if room_of(file) in rooms and room_of(target) in rooms and rooms.index(room_of(file)) < rooms.index(room_of(target)):
                wrong.append(f"{file}:{number} includes {target}: {ORDER} has {room_of(file)} before {room_of(target)}")
    return wrong


def imports(texts):
    """(file, imported file) of every import of the theory. It names no folder."""
    place = {Path(file).stem: file for file in texts}
    return [(file, place[name]) for file, text in texts.items() for names in IMPORT.findall(text) for name in names.split()]


def imports_upward(texts, order):
    """A line for each import that runs against the order of the theory's folders."""
    rooms = order[THEORY]
    return [f"{file} imports {target}: {ORDER} has {room_of(file)} before {room_of(target)}"
            for file, target in imports(texts) if rooms.index(room_of(file)) < rooms.index(room_of(target))]


def not_in_order(texts, order):
    """A line for each room that the order lacks, or lists and that does not exist."""
    wrong = []
    for layer in order:
        rooms = {room_of(file) for file in texts if layer_of(file) == layer}
        wrong += [f"{ORDER}: {layer} lacks {room}" for room in sorted(rooms - set(order[layer]))]
        wrong += [f"{ORDER}: {layer} has {room}, which does not exist or appears twice"
                  for room in order[layer] if room not in rooms or order[layer].count(room) > 1]
    return wrong


def draw(texts, order):
    """A line for each room, in that order: the rooms that its files other than tests include or import."""
    included = defaultdict(set)
    for file, target in [(file, target) for file, _, target in arrows(texts)] + imports(theory()):
        if not is_for_tests(file) and room_of(file) != room_of(target):
            included[room_of(file)].add(room_of(target))
    every = [room for layer in order for room in order[layer]]
    return [f"{room} -> {', '.join(sorted(included[room], key=every.index)) or '-'}" for room in every]


class Rooms(unittest.TestCase):
    def test_every_room_has_its_place_in_the_order_of_its_layer(self):
        self.assertEqual(not_in_order({**sources(), **theory()}, orders()), [])

    def test_every_include_goes_to_an_earlier_layer_or_room(self):
        self.assertEqual(upward(sources(), orders()), [])

    def test_planted_includes_are_seen(self):
        texts, order = sources(), orders()
        self.assertGreater(len(arrows(texts)), 500)
        for file, target, says in (
                ("kernel/base/error.h", "exact/judge/judge.h", "kernel/ comes before exact/"),
                ("reports/run_folder/run_folder.cpp", "reports/comparison/cells.h", f"{ORDER} has reports/run_folder before"),
                ("kernel/sphere_triangle/names.h", "kernel/sphere_triangle/forms/simd.h", f"{ORDER} has kernel/sphere_triangle/words before"),
                ("reports/formats/html.cpp", "reports/testing/test_run.h", "which is for tests alone")):
            # The planted line alone, so that a real one elsewhere is told by the test above and not here too.
            wrong = upward({path: f'#include "{target}"\n' if path == file else "" for path in texts}, order)
            self.assertEqual(len(wrong), 1, wrong)
            self.assertTrue(wrong[0].startswith(f"{file}:1 includes {target}"), wrong)
            self.assertIn(says, wrong[0])

    def test_a_planted_room_is_asked_for(self):
        self.assertEqual(not_in_order({**sources(), **theory(), "fuzz/attic/old.h": "", "proofs/coq/attic/Old.v": ""}, orders()),
                         [f"{ORDER}: fuzz lacks fuzz/attic", f"{ORDER}: proofs/coq lacks proofs/coq/attic"])


class Theory(unittest.TestCase):
    def test_every_import_goes_to_an_earlier_folder(self):
        texts = theory()
        self.assertGreater(len(imports(texts)), 300)
        self.assertEqual(imports_upward(texts, orders()), [])

    def test_a_planted_import_is_seen(self):
        file, line = "proofs/coq/numbers/Run.v", "From Axiscert Require Import Format\n  Filter.\n"
        self.assertEqual(imports_upward({path: line if path == file else "" for path in theory()}, orders()),
                         [f"{file} imports proofs/coq/formulae/Filter.v: {ORDER} has proofs/coq/numbers before proofs/coq/formulae"])

    def test_no_two_files_have_the_same_name(self):
        names = [Path(file).name for file in theory()]
        self.assertEqual(sorted(set(names)), sorted(names))

    def test_each_file_says_what_it_proves_or_the_README_does(self):
        listed = (ROOT / "proofs/coq/README.md").read_text()
        self.assertEqual([file for file, text in theory().items() if text and not text.startswith("(* ") and f"`{Path(file).name}`" not in listed], [])

    def test_the_README_names_every_folder(self):
        listed = (ROOT / "proofs/coq/README.md").read_text()
        self.assertEqual([folder for folder in {Path(file).parent.name for file in theory()} - {"coq"} if f"`{folder}/`" not in listed], [])


if __name__ == "__main__":
    if DRAW:
        print("\n".join(draw(sources(), orders())))
    else:
        unittest.main()
