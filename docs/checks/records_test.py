#!/usr/bin/env python3
"""Tables of docs/ whose figures are committed elsewhere, where a proof, a test or a lock file holds them, say the same here as there.

    docs/league.md    versions of the engines: kernel/peers/npm/package.json
    docs/proofs.md    bounds and thresholds: proofs/coq/formulae/Thresholds.v, kernel/sphere_triangle/forms/filter_thresholds.h; theorems named
                      beside the steps of the certified predicate: proofs/theorems.txt
                      how many faults ./dev prove --planted has: proofs/faults.py
    docs/bounds.md    bounds: proofs/bounds.cpp, which Gappa proves; errors attained: proofs/bounds.h, and these those of docs/search.md
    CITATION.bib    title, authors, version, date and the article: CITATION.cff
    CITATION.cff, CHANGELOG.md, docs/ci.md, docs/pipe.md    the version: CMakeLists.txt
"""
import json
import math
import re
import sys
import unittest
from fractions import Fraction
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "proofs"))
import prove  # noqa: E402


def text_of(path):
    return (ROOT / path).read_text()


def table(page, head):
    """The rows of the table whose head begins so: lists of cells without ` and *."""
    lines = text_of(page).splitlines()
    (at,) = [i for i, line in enumerate(lines) if line.startswith(head)]
    rows = []
    for line in lines[at + 2:]:
        if not line.startswith("|"):
            return rows
        rows.append([cell.strip(" `*") for cell in line.strip("|").split("|")])


def numbers(text):
    return [int(word) for word in re.findall(r"\d+", text)]


def up(value, parts):
    """value / parts, rounded up to a tenth, as text: a bound may not be shown less than it is."""
    tenths = -(-value * 10 // parts)
    return f"{tenths // 10:,}.{tenths % 10}" if tenths % 10 else f"{tenths // 10:,}"


def thresholds_rows():
    """The rows of docs/proofs.md, from the theory: bounds in u / 1024, thresholds as the filter has them."""
    theory = text_of("proofs/coq/formulae/Thresholds.v")

    def errors(name):
        plain, fused = re.search(rf"Theorem {name} :.*?\[(.*?)\].*?\[(.*?)\]", theory, re.S).groups()
        return [list(map(int, re.findall(r"Some \((\d+), ", part))) for part in (plain, fused)]

    published, reduced = errors("published_errors"), errors("reduced_errors")
    kinds = [("plane radius", published, 0), ("vertex radius", published, 1), ("vertex side", published, 2), ("edge radius, published", published, 3),
             ("edge side, published", published, 4), ("edge radius, reduced", reduced, 3), ("edge side, reduced", reduced, 4)]
    return [[name, *(up(form[part][at], 1024).replace(",", "") for part in (0, 1))] for name, form, at in kinds]


def bounds_rows():
    """The rows of docs/bounds.md: bounds of the scaled domain in u / 16, plain and fused, and what a search attained."""
    source, attained = text_of("proofs/bounds.cpp"), text_of("proofs/bounds.h")
    rows = []
    for name in ("vertex radius", "vertex side", "plane radius", "published edge radius", "published edge side", "reduced edge radius", "reduced edge side"):
        form, kind = (name.split(" ", 1) if name.startswith(("published", "reduced")) else ("published", name))
        plain, fused = numbers(re.search(rf'\{{"{name.replace(" radius", ".radius").replace(" side", ".side")}", \{{\{{\{{(.*?)\}}', source)[1])
        (greatest,) = re.findall(rf'\{{"{form}", Kind::{kind.replace(" ", "_")}, ([\d.]+),', attained)
        hundredths = math.ceil(Fraction(plain, 16) / Fraction(greatest) * 100)  # rounded up: no bound may look sharper than it is
        shown = f"{int(greatest.partition('.')[0]):,}.{greatest.partition('.')[2]}"
        rows.append([name, up(plain, 16), up(fused, 16), shown, f"{hundredths // 100}.{hundredths % 100:02}"])
    return rows


class Records(unittest.TestCase):
    def test_versions_of_engines_are_those_of_the_package(self):
        packages = json.loads(text_of("kernel/peers/npm/package.json"))["dependencies"]
        self.assertEqual({row[0]: row[1] for row in table("docs/league.md", "| package | version |")}, packages)

    def test_bounds_of_the_theory(self):
        rows = table("docs/proofs.md", "| comparison | degree | bound, plain |")
        self.assertEqual([[row[0], *row[2:4]] for row in rows], thresholds_rows())
        filters = set(numbers(text_of("kernel/sphere_triangle/forms/filter_thresholds.h")))
        for row in rows:
            self.assertGreater(int(row[4]), float(row[2]), row)
            self.assertLessEqual(int(row[4]), math.ceil(float(row[2])) + 2, row)
            self.assertIn(int(row[4]), filters, row)

    def test_theorems_named_beside_the_steps_are_main_theorems(self):
        theorems = set(re.findall(r"^(\w+) \[", text_of("proofs/theorems.txt"), re.M))
        lines = text_of("docs/proofs.md").partition("| step | proved | recorded |")[2].partition("\n\n")[0].splitlines()[2:]
        named = {name for line in lines for name in re.findall(r"`(\w+)`", line.split("|")[2])}
        self.assertGreater(len(named), 20)
        self.assertEqual(named - theorems, set())
        self.assertEqual({"never_lies", "open_exact"} - theorems, {"never_lies"})  # a definition is not a theorem

    def test_planted_faults_of_the_theory(self):
        said = re.search(r"plants (\d+) faults .*?weakens (\d+) theorems", text_of("docs/proofs.md"), re.S)
        self.assertEqual(list(map(int, said.groups())), [len(prove.FAULTS), len(prove.WEAKENED)])

    def test_bounds_of_the_scaled_domain(self):
        self.assertEqual(table("docs/bounds.md", "| comparison | plain | fma | attained"), bounds_rows())

    def test_what_searches_attained_is_what_the_page_of_searches_shows(self):
        found = dict(re.findall(r"^  ([\w.]+) +([\d.,]+) ", text_of("docs/search.md"), re.M))
        for name, kind in (("plane.radius", "plane_radius"), ("vertex_a.radius", "vertex_radius"), ("vertex_a.side_b", "vertex_side"),
                           ("edge_ab.radius", "edge_radius"), ("edge_ab.side_c", "edge_side")):
            (greatest,) = re.findall(rf'\{{"published", Kind::{kind}, ([\d.]+),', text_of("proofs/bounds.h"))
            self.assertEqual(f"{float(greatest):.4g}", found[name].replace(",", ""), name)



def versions(text=text_of):
    """Each place that states axiscert's version, and what it states."""
    places = {"CMakeLists.txt": r"^project\(axiscert VERSION (\S+)", "CITATION.cff": r"^version: (\S+)", "CHANGELOG.md": r"\A.*?^## (\S+)$",
              "docs/ci.md": r"AXISCERT: v(\S+)\}", "docs/pipe.md": r'"axiscert":"(.*?)"'}
    return {place: re.search(pattern, text(place), re.M | re.S)[1] for place, pattern in places.items()}


class Citation(unittest.TestCase):
    def test_the_article_has_the_title_that_the_formulae_state(self):
        (title,) = set(re.findall(r'C\. Ericson, "(.*?)" \(2010\)', text_of("kernel/sphere_triangle/formulae.h")))
        self.assertIn(f'    title: "{title}"\n', text_of("CITATION.cff"))

    def test_each_test_is_named(self):
        """sphere-triangle as "sphere and triangle" and so on."""
        said = re.search(r"collision tests \((.*?)\)", text_of("CITATION.cff"))[1].split(", ")
        listed = re.findall(r"^  X\((\w+)\)", text_of("kernel/predicate_list.h"), re.M)
        self.assertEqual([{*one.split(" and ")} for one in said], [{*name.replace("moving_sphere", "moving sphere_triangle").split("_")} for name in listed])


def cited(text=text_of):
    """What CITATION.cff and CITATION.bib say of the tool, then of the article: title, author, version or address, date or year."""
    def of_cff(part):
        def value(name): return re.search(rf'^ *(?:- )?{name}: "?(.*?)"?$', part, re.M)[1]
        author = value("name") if "  - name:" in part else f"{value('family-names')}, {value('given-names')}"
        return (value("title"), author, *((value("version"), value("date-released")) if "version:" in part else (value("url"), value("year"))))

    def of_bib(entry):
        fields = dict(re.findall(r"^  (\w+) = \{+(.*?)\}+,?$", entry, re.M))
        return (fields["title"], fields["author"], *((fields["version"], fields["date"]) if "version" in fields else (fields["url"], fields["year"])))

    tool, article = re.split(r"^references:\n", re.sub(r"^cff-version.*\n", "", text("CITATION.cff")), flags=re.M)
    return [of_cff(tool), of_cff(article)], [of_bib(entry) for entry in re.split(r"^@", text("CITATION.bib"), flags=re.M)[1:]]


class Bibliography(unittest.TestCase):
    def test_both_citations_say_the_same(self):
        cff, bib = cited()
        self.assertEqual(cff, bib)

    def test_a_difference_is_seen(self):
        for old, new in (("axiscert: collision", "collision"), ("version = {0", "version = {9"), ("-11-", "-12-"), ("Ericson, C", "Erikson, C"), ("2010", "2011"), ("p=103", "p=104")):
            changed = text_of("CITATION.bib").replace(old, new)
            self.assertNotEqual(changed, text_of("CITATION.bib"), old)
            cff, bib = cited(lambda path: changed if path.endswith("bib") else text_of(path))
            self.assertNotEqual(cff, bib, old)


class Version(unittest.TestCase):
    def test_it_is_the_same_wherever_it_is_stated(self):
        self.assertEqual(len(set(versions().values())), 1, versions())

    def test_one_that_was_forgotten_is_seen(self):
        version = versions()["CMakeLists.txt"]
        for place in versions():
            forgotten = versions(lambda path: text_of(path).replace(version, "9.9.9") if path == place else text_of(path))
            self.assertEqual({one for one, stated in forgotten.items() if stated == "9.9.9"}, {place})


if __name__ == "__main__":
    unittest.main()
