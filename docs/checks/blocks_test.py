#!/usr/bin/env python3
"""Every printed block of README.md and docs/ is held by a check (blocks.py), and one that is not is seen."""
import re
import unittest
from pathlib import Path

import blocks

ROOT = Path(__file__).resolve().parents[2]


def errors_with(page, added):
    """The errors where the text stands at the end of the page."""
    return blocks.report(ROOT, {page: (ROOT / page).read_text() + "\n" + added})[1]


class Blocks(unittest.TestCase):
    def test_each_is_held(self):
        shown, errors = blocks.report(ROOT)
        self.assertGreater(len(shown), 150)
        self.assertEqual(errors, [])

    def test_a_planted_block_that_nothing_holds_is_seen(self):
        for page, added in (("README.md", "```\n  kernel     queries  missed\n  published      100       7\n```\n"),
                            ("docs/ci.md", "```\n$ axiscert kernels\npublished 7\n```\n"),  # whose commands no session runs
                            ("docs/scale.md", "| kernel | missed |\n|---|---:|\n| `published` | 1,234 |\n"),
                            ("docs/map.md", "It prints\n\n    published: 17 missed\n"),
                            ("docs/map.md", "![a map](plots/map.svg)\n"),
                            # Held by figures.py, but no test gives it this page.
                            ("docs/scale.md", "<!-- table 0 of: $ axiscert ladder -->\n```\n$ axiscert ladder\n17\n```\n<!-- end -->\n"),
                            # Said to be held by a test that says nothing of the page.
                            ("docs/map.md", "<!-- held by cli/tests/gates_test.py -->\n| a |\n|---|\n| 17 |\n"),
                            ("docs/map.md", "<!-- table: no-such -->\n| a |\n|---|\n| 17 |\n<!-- end -->\n")):
            errors = errors_with(page, added)
            self.assertEqual(len(errors), 1, (page, added, errors))
            self.assertTrue(errors[0].startswith(page), errors)

    def test_what_is_held_or_prints_nothing_is_no_error(self):
        for page, added in (("README.md", "```c\nint x = 7;\n```\n"), ("docs/ci.md", "```\naxiscert run --preset ci\n```\n"),
                            ("docs/queries.md", "```\n$ axiscert kernels\npublished 7\n```\n"),  # a session, whose test is another
                            ("docs/map.md", "| word | meaning |\n|---|---|\n| depth | how far |\n"),
                            ("docs/moving.md", "<!-- held by exact/moving_sphere/kernel_faults_test.cpp -->\n```\n17\n```\n")):
            self.assertEqual(errors_with(page, added), [], (page, added))

    def test_a_line_of_the_list_of_those_that_none_holds_is_about_a_block(self):
        page = "docs/truth.md"
        without = re.sub(r"^\| family \| precision \| naive.*?(?=^[^|])", "", (ROOT / page).read_text(), flags=re.M | re.S)
        (error,) = blocks.report(ROOT, {page: without})[1]
        self.assertIn("no block of docs/truth.md begins `| family | precision | naive", error)


class Links(unittest.TestCase):
    def test_each_link_to_a_file_leads_to_one_and_each_place_in_it_is_a_heading(self):
        wrong = []
        for path in blocks.pages(ROOT):
            for target in re.findall(r"\]\(([^)\s]+)\)", re.sub(r"^```.*?^```", "", path.read_text(), flags=re.M | re.S)):
                if re.match(r"https?:", target):
                    continue
                file, _, place = target.partition("#")
                to = (path.parent / file).resolve() if file else path
                if not to.exists():
                    wrong.append(f"{path.relative_to(ROOT)}: {target}")
                elif place and to.suffix == ".md" and place not in anchors(to.read_text()):
                    wrong.append(f"{path.relative_to(ROOT)}: {target}: no such heading")
        self.assertEqual(wrong, [])


def anchors(text):
    """The headings of a page as links name them."""
    heads = re.findall(r"^#+ (.*)$", re.sub(r"^```.*?^```", "", text, flags=re.M | re.S), re.M)
    return {re.sub(r"[^\w\- ]", "", head.lower()).replace(" ", "-") for head in heads}


if __name__ == "__main__":
    unittest.main()
