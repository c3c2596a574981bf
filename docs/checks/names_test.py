"""names_test.py ROOT: no function in an unnamed namespace has the name of one that a header of its layer declares.

Sources are compiled many at a time (`axiscert_unity` in cmake/Targets.cmake), so what stands in an unnamed namespace is seen by all that
follow: a call from another one's unnamed namespace finds it first, and where its arguments convert, as JSON does to anything, it is
taken in silence for the function of the header.
"""
import re
import sys
import unittest
from collections import defaultdict
from pathlib import Path

ROOT = Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 else Path(__file__).resolve().parents[2]
LAYERS = ("fuzz", "reports", "plans", "cli", "python")  # whose sources are compiled so
UNNAMED = re.compile(r"^namespace \{\n(.*?)^\}  // namespace$", re.M | re.S)
FUNCTION = re.compile(r"^(?!return|else|using|if|for|namespace|struct|class|#|//|TEST|\s)[\w:<>,&*\[\] ]*?[ *&](\w+)\(", re.M)


def sources():
    """Path and text of the sources and headers of the layers, without tests, benchmarks and programs of their own."""
    found = {}
    for layer in LAYERS:
        for path in (ROOT / layer).rglob("*"):
            name = path.relative_to(ROOT).as_posix()
            if path.suffix in (".h", ".cpp") and not re.search(r"_(test|bench|target)\.cpp$|testing|/targets/|/bench/", name):
                found[name] = path.read_text()
    return found


def taken(texts):
    """A line for each function of an unnamed namespace whose name a header of its layer has too."""
    declared = defaultdict(set)
    for file, text in texts.items():
        if file.endswith(".h"):
            for function in FUNCTION.finditer(text):
                declared[file.split("/")[0], function[1]].add(file)
    wrong = set()
    for file, text in texts.items():
        if file.endswith(".cpp"):
            for block in UNNAMED.finditer(text):
                for function in FUNCTION.finditer(block[1]):
                    for header in declared[file.split("/")[0], function[1]]:
                        wrong.add(f"{file}: {function[1]}() in an unnamed namespace has the name of one of {header}; give it another")
    return sorted(wrong)


class Names(unittest.TestCase):
    def test_no_function_of_one_source_has_the_name_of_one_that_all_call(self):
        self.assertEqual(taken(sources()), [])

    def test_a_planted_name_is_seen(self):
        texts = sources()
        self.assertIn("std::string cell_text(const Json& key);", texts["reports/comparison/cells.h"])
        texts["reports/certificate/page.cpp"] = "namespace {\nstd::string cell_text(const Json& value) {\n}\n}  // namespace\n"
        self.assertEqual(taken(texts), ["reports/certificate/page.cpp: cell_text() in an unnamed namespace has the name of one of "
                                        "reports/comparison/cells.h; give it another"])


if __name__ == "__main__":
    unittest.main()
