#!/usr/bin/env python3
"""record.csv: the figures of a record as a table, from which the tables of report.md can be made again."""
import csv
import io
import json
import re

import unittest

from command import Case, axiscert, fewer

HEAD = ["kernel", "precision", "family", "level", "name"]
# By level, where record.json has the places of a family.
PLACES = {"axis": "axes", "comparison": "comparisons", "image": "invariance", "class": "classes"}


def rows_in(text):
    return list(csv.DictReader(io.StringIO(text, newline=""), strict=True))


def amount(value, digits):
    """A number as reports show it."""
    text = f"{value:.{digits}g}"
    if value < 1000:
        return text
    return f"{int(float(text)):,}" + (text[text.index("."):] if "." in text and "e" not in text else "")


def verdict_table(rows):
    """The table "Kernels and families" of report.md, by record.csv alone."""
    table = []
    for row in rows:
        if row["level"] != "verdict":
            continue
        count = {column: int(cell) for column, cell in row.items() if re.fullmatch(r"\d+", cell)}
        links = [f"{column.split('.')[-1]} {n:,}" for column, n in count.items() if column.startswith("verdict.links.") and n]
        valid = count["trials"] - count["truth.invalid"]
        # Those that could be missed, and those that could be called contact, of a kernel to which touching is contact.
        outside, outside_contact = (count.get(f"verdict.outside_limits.{what}", 0) for what in ("trials", "contact"))
        contacts, declined = count["truth.contact"] - outside_contact, count["verdict.undecided_contact"]
        kinds = {"false_separation": contacts - declined,
                 "false_contact": valid - outside - contacts - (count["verdict.undecided"] - declined)}

        def figures(kind):
            n, depth = count.get(f"verdict.{kind}", 0), amount(float(row[f"verdict.deepest_{kind}"] or 0), 4)
            if n:
                return [f"{n:,} ({amount(1e6 * n / valid, 3)} per million)", depth]
            decided = max(0, kinds[kind] - count["verdict.invalid"] - count["verdict.unanswered"])
            counted = min(count["base_triangles"], decided)
            limit = f"0 (< {amount(1e6 * (1 - 0.05 ** (1 / counted)), 3)} per million, 95 %)" if counted else "not checked"
            return [limit, depth if decided else "-"]

        table.append([row["kernel"], row["precision"], row["family"] + (" (exact arithmetic)" if row["exact_arithmetic"] == "true" else ""),
                      ", ".join(links) or ("none" if count["verdict.decided"] else "-"), f"{count['trials']:,}",
                      *(f"{count[f'truth.{what}']:,}" for what in ("separated", "contact", "touching", "invalid")),
                      *figures("false_separation"), *figures("false_contact"),
                      f"{count['verdict.touching_flips']:,}" if count["verdict.decided_touching"] else "-",
                      *(f"{count[f'verdict.{what}']:,}" for what in ("undecided", "unanswered"))])
    return sorted(table)


def table_of(markdown, heading):
    """The rows of all tables of a section, sorted."""
    section = re.search(rf"^## {heading}\n(.*?)(?=^## |\Z)", markdown, re.M | re.S)[1]
    lines = [[cell.strip() for cell in line.strip("|").split("|")] for line in section.splitlines() if line.startswith("|")]
    return sorted(line for line in lines if line[0] != "kernel" and not line[0].startswith("---"))


def value_at(figures, path):
    """The value of a member, or of the path to one; None where there is none."""
    if not isinstance(figures, dict):
        return None
    if path in figures:
        return figures[path]
    for dot in (i for i, c in enumerate(path) if c == "."):
        if path[:dot] in figures:
            found = value_at(figures[path[:dot]], path[dot + 1:])
            if found is not None:
                return found
    return None


def leaves(figures, path=""):
    """The paths of all numbers and texts; not of those in lists of objects, nor of counts by a size."""
    for name, value in figures.items():
        here = f"{path}.{name}" if path else name
        if isinstance(value, dict):
            if name not in ("by_size", "margins"):
                yield from leaves(value, here)
        elif value is not None and not (isinstance(value, list) and value and isinstance(value[0], dict)):
            yield here, value


class RecordCsv(Case):
    RUNS = {
        "sphere": ("--kernel", "published", "--kernel", "eigen", "--kernel", "certified", "--family", "tangent", "--family", "orders",
                   "--family", "nonfinite", "--family", "repeated", "--family", "bits"),
        "motion": ("--kernel", "moving-sphere/twenty", "--kernel", "moving-sphere/gated", "--family", "moving-sphere/approach",
                   "--family", "moving-sphere/line_sweep"),
        "boxes": ("--kernel", "box-box/cofactor", "--family", "box-box/stacked", "--family", "box-box/general"),
    }

    def ran(self, which):
        self.run_ok(*self.RUNS[which], "--trials", fewer(300))
        return self.folder / "out"

    def test_the_verdicts_of_the_report_are_made_again_of_the_table_alone(self):
        for which in self.RUNS:
            out = self.ran(which)
            rows = rows_in((out / "record.csv").read_text())
            self.assertEqual(verdict_table(rows), table_of((out / "report.md").read_text(), "Kernels and families"), which)
            self.assertTrue(any(int(row["verdict.false_contact"] or 0) for row in rows if row["level"] == "verdict"), which)

    def test_the_comparison_of_tables_is_not_blind(self):
        out = self.ran("sphere")
        rows, shown = rows_in((out / "record.csv").read_text()), table_of((out / "report.md").read_text(), "Kernels and families")
        for column in ("trials", "truth.contact", "verdict.false_separation", "verdict.deepest_false_contact", "verdict.links.rounding"):
            row = next(row for row in rows if row["level"] == "verdict" and float(row[column] or 0) > 0)
            kept = row[column]
            row[column] = "12345"
            self.assertNotEqual(verdict_table(rows), shown, column)
            row[column] = kept

    def test_every_figure_of_the_record_is_in_the_table_once(self):
        for which in self.RUNS:
            out = self.ran(which)
            record, rows = json.loads((out / "record.json").read_text()), rows_in((out / "record.csv").read_text())
            self.assertEqual(list(rows[0])[:5], HEAD)
            by_place = {tuple(row[name] for name in HEAD): row for row in rows}
            self.assertEqual(len(by_place), len(rows))
            for kernel in record["kernels"]:
                for family, result in kernel["families"].items():
                    places = {("verdict", "verdict"): {name: value for name, value in result.items() if name not in PLACES.values()}}
                    for level, member in PLACES.items():
                        places.update({(level, name): figures for name, figures in (result.get(member) or {}).items()})
                    for place, figures in places.items():
                        row = by_place.pop((kernel["id"], kernel["precision"], family, *place))
                        there = dict(leaves(figures))
                        self.assertLessEqual(set(there), set(row), (which, place))
                        for column in list(row)[5:]:
                            self.assertEqual(bool(row[column]), column in there and there[column] != "", (which, place, column))
                        for column, value in there.items():
                            self.assertEqual(row[column] if isinstance(value, str) else json.loads(row[column]), value, (place, column))
            self.assertEqual(by_place, {}, which)

    def test_run_and_report_print_the_file(self):
        out = self.folder / "out"
        done = axiscert("run", *self.RUNS["boxes"], "--trials", 40, "--out", out, "--format", "csv")
        self.assertEqual((done.returncode, done.stdout), (0, (out / "record.csv").read_text()), done.stderr)
        (out / "record.csv").unlink()
        again = axiscert("report", out, "--format", "csv")
        self.assertEqual((again.returncode, again.stdout), (0, done.stdout), again.stderr)
        self.assertEqual((out / "record.csv").read_text(), done.stdout)
        self.refused("run", "--format", "json", says=["--format", "text", "csv"])

    def test_standard_output_has_nothing_else(self):
        out = self.folder / "out"
        done = axiscert("run", "--kernel", "published", "--family", "repeated", "--trials", 200, "--require", "logic", "--out", out, "--format", "csv")
        self.assertEqual((done.returncode, done.stdout), (1, (out / "record.csv").read_text()))
        self.assertIn("--require", done.stderr)


if __name__ == "__main__":
    unittest.main()
