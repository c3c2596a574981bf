"""words_test.py ROOT: generic code of reports and the page know no family, level, comparison or predicate by its name.

Their words (situation, advice, section) are members of their definitions: struct Family, struct GateLevel, a predicate's capabilities, and for the page
the script of a predicate's picture. A string literal that is a name of one, is a list of names, or gives one to an option, is knowledge in another place.
"""
import re
import sys
import unittest
from pathlib import Path

ROOT = Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 else Path(__file__).resolve().parents[2]

# Names that are something else in reports too, and what.
HOMONYMS = {
    "axes": "the member of a record with the axes' tallies, a picture's axes", "bits": "a number of bits, a witness's comparisons",
    "decided": "a count of queries", "degenerate": "a kind of margin", "depth": "of a wrong verdict", "end": "of an alignment of labels",
    "exact": "the truth, beside what was computed", "level": "what a flip is of, and the member with a level's name", "on": "the word",
    "point": "a measure of a contact", "range": "a link", "ratio": "of two errors", "repeated": "a property of a diagnosis",
    "scaled": "a domain of bounds", "start": "of an alignment of labels", "stack": "a look of the page", "tie": "a bin of margins",
    "touching": "of a truth",
}
EXEMPT = re.compile(r"_test\.(cpp|mjs|py)$|_target\.cpp$|/(testing|browser)/|_scene\.js$")
# A comparison with a name is knowledge of it even where it is a homonym.
COMPARED = re.compile(r"\b(level|asked\.name|family|predicate)\b(?:\.name)?\s*[!=]==?\s*[\"'`]([\w-]+)[\"'`]")
KIND_OF = {"level": "level", "asked.name": "level", "family": "family", "predicate": "predicate"}
LITERAL = re.compile(r'"((?:\\.|[^"\\\n])*)"|\'((?:\\.|[^\'\\\n])*)\'|`((?:\\.|[^`\\\n])*)`')


def texts(pattern):
    return [path.read_text() for path in sorted(ROOT.glob(pattern)) if not EXEMPT.search(path.as_posix())]


def names():
    """The names of each kind, as the definitions have them."""
    def found(pattern, regex):
        return {name for text in texts(pattern) for name in re.findall(regex, text, re.MULTILINE)}
    families = found("fuzz/**/families.cpp", r"^  X\((\w+)\)")
    return {
        "family": families | {name.replace("_", "-") for name in families},
        "level": found("reports/gates/*_level.cpp", r'(?:\.usage = |_level = \{\s*)"([\w-]+)'),
        "comparison": found("kernel/*/names.h", r'(?<!include )"(\w[\w.]*)"'),
        "predicate": found("kernel/*/*.cpp", r'\.id = "([\w-]+)"'),
    }


def literals(line):
    if line.lstrip().startswith(("#include", "//")):
        return []
    # A comment begins after the last literal that closes before it.
    code = re.sub(LITERAL.pattern + r"|//.*", lambda m: m[0] if not m[0].startswith("//") else "", line)
    return [next(part for part in match.groups() if part is not None) for match in LITERAL.finditer(code)]


def known_in(text, kinds):
    """What a literal knows by name: [(name, kind)]."""
    told = [(name, "predicate") for name in re.findall(r"([\w-]+)/[\w-]", text) if name in kinds["predicate"]]
    told += [(name, kind) for name in re.findall(r"--(?:require|family|predicate)[ =]([\w-]+)", text) for kind in kinds if name in kinds[kind]]
    words = text.split()
    for kind, all_names in kinds.items():
        if words and all(word in all_names for word in words) and not (len(words) == 1 and words[0] in HOMONYMS):
            told += [(word, kind) for word in words]
    return told


def told_by(line, kinds):
    told = [found for literal in literals(line) for found in known_in(literal, kinds)]
    return told + [(name, KIND_OF[what]) for what, name in COMPARED.findall(line) if name in HOMONYMS and name in kinds[KIND_OF[what]]]


def places(files, kinds):
    return [f"{file}:{number}: {name}, a {kind}: {line.strip()}"
            for file, text in files.items() for number, line in enumerate(text.split("\n"), 1) for name, kind in told_by(line, kinds)
            if not (kind == "level" and re.match(r"reports/gates/\w+_level\.cpp", file))]


def generic():
    return {path.relative_to(ROOT).as_posix(): path.read_text() for path in sorted((ROOT / "reports").rglob("*"))
            if path.suffix in (".h", ".cpp", ".js") and not EXEMPT.search(path.as_posix())}


class Words(unittest.TestCase):
    def test_generic_code_knows_nothing_by_its_name(self):
        told = places(generic(), names())
        self.assertFalse(told, "\n" + "\n".join(told))

    def test_the_names_are_read(self):
        kinds = names()
        for kind, some in {"family": {"tangent", "scene-walk", "ends_graze", "voxel"}, "level": {"logic", "no-tunnel", "decided", "invariant"},
                           "comparison": {"plane.radius", "vertex_a", "a0b0", "sweep.edge_ab.side"},
                           "predicate": {"sphere-triangle", "box-triangle"}}.items():
            self.assertLessEqual(some, kinds[kind])
        self.assertIn("reports/page/report.js", generic())

    def test_every_homonym_is_a_name_that_occurs(self):
        said = {literal.strip() for text in generic().values() for line in text.split("\n") for literal in literals(line)}
        self.assertLessEqual(set(HOMONYMS), set().union(*names().values()) & said)

    def test_what_is_planted_is_seen(self):
        for planted in ('if (family == "tangent") return 1;', "const hard = ['sliver', 'needle'];", '{"parallel", "motions", "slide skim along_edge"},',
                        "if (of.predicate === 'moving-sphere') draw();", 'if (level == "conservative") return "";', "row.name === 'plane.radius'",
                        "el('code', '', 'axiscert run --require logic')", '"take moving-sphere/general"', "`--family ${x} --family scene_walk`",
                        'if (asked.name == "decided") share = 1;', 'return level == "exact" || other;'):
            self.assertTrue(places({"reports/x.cpp": planted}, names()), planted)

    def test_what_is_no_name_is_not(self):
        for line in ("const tangent = 1;", '// as "tangent" says', 'fmt::format("a tangent sphere")', "el('div', 'stack', level)", '#include "tangent"'):
            self.assertEqual(places({"reports/x.cpp": line}, names()), [], line)


if __name__ == "__main__":
    unittest.main()
