"""Includes run one way: from layer to layer, and between the rooms (folders) of a layer without a circle.

    rooms_test.py ROOT

Tests (`_test.cpp`, `testing`) may look into any room of the layers below and of their own.
"""
import re
import sys
import unittest
from collections import defaultdict
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

ROOT = Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 else Path(__file__).resolve().parents[1]
LAYERS = ("kernel", "proofs", "exact", "fuzz", "reports", "cli")
# Files that list what the rooms below them hold: their includes are the list.
LISTS = ("kernel/sphere_triangle/kernels.cpp",)


def sources():
    """Path and text of every C++ source of the layers."""
    found = {}
    for layer in LAYERS:
        for path in (ROOT / layer).rglob("*"):
            if path.suffix in (".h", ".cpp"):
                found[path.relative_to(ROOT).as_posix()] = path.read_text()
    return found


def room_of(file):
    return file.rsplit("/", 1)[0]


def is_for_tests(file):
    return file.endswith("_test.cpp") or "testing" in file or file == "reports/formats/test_run.h"


def arrows(texts):
    """The includes that cross from one room into another, as {(room, room): [(file, file)]}."""
    found = defaultdict(list)
    for file, text in texts.items():
        for included in re.findall(r'^\s*#\s*include "([^"]+)"', text, re.MULTILINE):
            if included in texts and room_of(included) != room_of(file):
                found[room_of(file), room_of(included)].append((file, included))
    return found


def layer_of(room):
    return LAYERS.index(room.split("/")[0])


def upward(texts):
    return [f"{file} includes {included}" for (room, other), includes in arrows(texts).items()
            if layer_of(room) < layer_of(other) for file, included in includes]


def circle(texts):
    """The includes along one circle of rooms; empty where there is none."""
    rooms = arrows({file: text for file, text in texts.items() if not is_for_tests(file) and file not in LISTS})
    graph = defaultdict(set)
    for room, other in rooms:
        graph[room].add(other)
    try:
        TopologicalSorter(graph).prepare()
        return []
    except CycleError as error:
        way = error.args[1][::-1]
        return [f"{file} includes {included}" for room, other in zip(way, way[1:]) for file, included in rooms[room, other]]


class Rooms(unittest.TestCase):
    def test_no_layer_includes_one_above_it(self):
        self.assertEqual(upward(sources()), [])

    def test_no_rooms_include_each_other_in_a_circle(self):
        self.assertEqual(circle(sources()), [], "each line is an arrow of the circle: one of them has to go")

    def test_a_planted_arrow_is_seen(self):
        texts = sources()
        self.assertGreater(len(arrows(texts)), 100)
        texts["kernel/base/error.h"] += '#include "exact/judge/judge.h"\n'
        self.assertEqual(upward(texts), ["kernel/base/error.h includes exact/judge/judge.h"])
        self.assertIn("kernel/base/error.h includes exact/judge/judge.h", circle(texts))


if __name__ == "__main__":
    unittest.main()
