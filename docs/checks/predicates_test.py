"""predicates_test.py ROOT: generic code does not ask which predicate it has, and includes nothing of one's rooms.

Generic is what lies outside the rooms of the predicates; tests, benchmarks and programs of the suite may name one. What a predicate has and
another has not is data of its description or a capability (fuzz/queries/capabilities.h, exact/judge/oracles.h). The lists that name every
predicate once expand kernel/predicate_list.h.

    predicates_test.py ROOT --list   prints every place that is counted
"""
import re
import sys
import unittest
from collections import Counter
from pathlib import Path

LIST = "--list" in sys.argv
if LIST:
    sys.argv.remove("--list")
ROOT = Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 else Path(__file__).resolve().parents[2]
LAYERS = ("kernel", "exact", "fuzz", "reports", "plans", "cli")
PREDICATES = ("sphere_triangle", "moving_sphere", "boxes", "capsule_triangle", "point_box")
NAMES = "sphere_triangle|moving_sphere|box_box|box_triangle|capsule_triangle|point_box"  # as in kernel/predicate_list.h, and the suite's own
ROOM = "|".join(PREDICATES)

# Each count is the most that there may be, by layer. They only fall.
COMPARISONS = {}
INCLUDES = {"kernel": 7, "fuzz": 16, "reports": 12, "plans": 1, "cli": 2}

# Tests, what they share, and programs of the suite or for developers; in kernel/plugin also the plug-ins that its tests load.
EXEMPT = re.compile(rf"_(test|bench)\.(cpp|h)$|testing|/(bench|targets|oracle_checks|peers|examples)/|(^|/)write_\w+\.cpp$"
                    rf"|^kernel/plugin/(misbehaving|declarations)/|/({ROOM})/")
COMPARISON = re.compile(
    rf"\b(?:{NAMES})_predicate\(\)"              # a particular predicate, whatever is done with it
    r"|\bfirst_predicate\(\)|\bfirst_predicate\b(?=[;,)])|\bis_first_predicate\b|\bis_first\(\)"
    r"|\bis_implied\b"                      # written_name() and test_named() alone ask this
    r"|(?:==|!=)\s*\"(?:" + NAMES.replace("_", "-") + r")\"|\"(?:" + NAMES.replace("_", "-") + r")\"\s*(?:==|!=)"
    r"|\bfind_predicate\(\"")                    # of a name that is written in the code
INCLUDE = re.compile(rf'^\s*#\s*include\s*[<"](?:[\w./-]*/)?(?:{ROOM})/')
# Where the list of kernel/predicate_list.h and is_implied are declared and defined.
OWN = {"kernel/registry/predicates.cpp", "kernel/predicate.h", "kernel/predicate_list.h"}


def generic():
    """Path and text of every source of generic code."""
    found = {}
    for layer in LAYERS:
        for path in sorted((ROOT / layer).rglob("*")):
            name = path.relative_to(ROOT).as_posix()
            if path.suffix in (".h", ".cpp") and not EXEMPT.search(name) and name not in OWN:
                found[name] = path.read_text()
    return found


def code_of(line):
    """The line without its comment; a string keeps its slashes."""
    return re.sub(r'("(?:\\.|[^"\\])*")|//.*', lambda found: found[1] or "", line)


def places(texts, pattern):
    """[(file, line number, line)] of what the pattern finds."""
    return [(file, number, line.strip())
            for file, text in texts.items()
            for number, line in enumerate(text.split("\n"), 1)
            if pattern.search(code_of(line))]


def too_many(found, allowed):
    """Lines that tell of each layer with more than is allowed, with every place in it."""
    counts = Counter(file.split("/")[0] for file, _, _ in found)
    told = []
    for layer in LAYERS:
        count, most = counts[layer], allowed.get(layer, 0)
        if count > most:
            told += [f"{layer}: {count}, at most {most}"]
            told += [f"  {file}:{number}: {line}" for file, number, line in found if file.startswith(layer + "/")]
    return told


class Predicates(unittest.TestCase):
    def assert_none(self, told):
        self.assertFalse(told, "\n" + "\n".join(told))

    def test_generic_code_compares_with_no_predicate(self):
        self.assert_none(too_many(places(generic(), COMPARISON), COMPARISONS))

    def test_generic_code_includes_no_room_of_a_predicate(self):
        self.assert_none(too_many(places(generic(), INCLUDE), INCLUDES))

    def test_what_is_planted_is_seen(self):
        for planted in ("if (&predicate == &sphere_triangle_predicate()) return 1;", "if (kernel.predicate != &box_box_predicate()) continue;",
                        "const bool own = &predicate == &first_predicate();", "  const Predicate& (*predicate)() = first_predicate;",
                        "if (subject.is_first_predicate()) return;", "return is_first() ? a : b;", "if (predicate.is_implied) return;",
                        'return predicate.id == "moving-sphere";', 'if ("box-triangle" != id) return;', 'find_predicate("box-box")'):
            self.assertEqual(places({"fuzz/instruments/x.cpp": "\n" + planted}, COMPARISON), [("fuzz/instruments/x.cpp", 2, planted.strip())])
        for planted in ('#include "exact/sphere_triangle/oracles/cascade.h"', '#include "kernel/boxes/boxes.h"',
                        '#include "fuzz/testing/point_box/point_box.h"', '# include <fuzz/moving_sphere/mesh_motion.h>'):
            self.assertEqual(len(places({"fuzz/instruments/x.cpp": planted}, INCLUDE)), 1, planted)
        self.assertEqual(too_many([("cli/x.cpp", 3, "y")], {"cli": 0}), ["cli: 1, at most 0", "  cli/x.cpp:3: y"])

    def test_what_is_no_comparison_is_not(self):
        for line in ('// as "sphere-triangle" == it says', 'const auto& predicate = find_predicate(name);', "bool is_first_call = true;",
                     '{"moving-sphere", of_moving_sphere},', "X(sphere_triangle)      \\"):
            self.assertEqual(places({"fuzz/instruments/x.cpp": line}, COMPARISON), [])

    def test_generic_code_is_read(self):
        read = generic()
        self.assertIn("fuzz/files/corpus.cpp", read)
        self.assertIn("kernel/plugin/supervisor.cpp", read)
        self.assertFalse([file for file in read if "sphere_triangle/" in file or file.endswith("_test.cpp")])


if LIST:
    for found in (places(generic(), COMPARISON), places(generic(), INCLUDE)):
        for file, number, line in found:
            print(f"{file}:{number}: {line}")
        print(dict(Counter(file.split("/")[0] for file, _, _ in found)))
elif __name__ == "__main__":
    unittest.main()
