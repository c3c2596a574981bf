#!/usr/bin/env python3
"""Text that a kernel, a manifest, a query or a file brings is shown escaped, whatever shows it: no terminal obeys it, no line is
forged by it, and no text is turned around."""
import base64
import json
import os
import re
import unittest
import zlib

from command import BUILD, MODELS, QUERY, Case, axiscert

# What a terminal, a browser or an editor obeys: control characters but the formats' own line ends and tabs, and those that turn text.
OBEYED = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ufeff]")
FORGED = re.compile("^other binary32", re.M)  # the second line of the plug-in's name
EVIL = "\x1b[2J\n\u202e"
SHOWN = r"\u001b[2J\n\u202e"
TEXTS = f"plugin:{BUILD}/misbehaving/texts.so"
QUICK = ("--precision", "binary32", "--trials", 300)


class ForeignText(Case):
    def holds(self, text, where):
        if isinstance(text, bytes):
            text = text.decode()  # which has to be UTF-8
        found = OBEYED.search(text) or FORGED.search(text)
        self.assertIsNone(found, f"{where}: {text[max(0, found.start() - 60):found.end() + 60]!r}" if found else "")

    def page_text(self, page):
        """A page without the scripts that every page has, and with what it has packed."""
        packed = re.findall(r'<script[^>]*id="[a-z-]*data"[^>]*>\s*([A-Za-z0-9+/=]{20,})\s*</script>', page)
        return re.sub(r"<script>.*?</script>", "", page, flags=re.S) + "".join(
            json.dumps(json.loads(zlib.decompress(base64.b64decode(one))), ensure_ascii=False) for one in packed)

    def values(self, json_value):
        """All texts of a JSON value, for their escapes are undone by who reads it."""
        if isinstance(json_value, dict):
            return [text for member in json_value.items() for one in member for text in self.values(one)]
        if isinstance(json_value, list):
            return [text for one in json_value for text in self.values(one)]
        return [json_value] if isinstance(json_value, str) else []

    def folder_holds(self, folder):
        files = [path for path in folder.rglob("*") if path.is_file()]
        self.assertTrue(files)
        for path in files:
            text = path.read_bytes().decode()
            if path.suffix == ".html":
                text = self.page_text(text)
            self.holds(text, path)
            if path.suffix in (".json", ".sarif", ".jsonl"):
                for line in text.splitlines() if path.suffix == ".jsonl" else [text]:
                    for one in self.values(json.loads(line)):
                        self.holds(one, path)
        return files

    def said(self, *args, codes=(0, 1), stdin=None):
        done = axiscert(*args, stdin=stdin)
        self.assertIn(done.returncode, codes, done.stderr)
        self.holds(done.stdout, args)
        self.holds(done.stderr, args)
        return done.stdout + done.stderr

    def test_of_a_plug_in_in_every_format(self):
        files = {}
        for out in ("one", "two"):
            text = self.said("run", "--kernel", TEXTS, "--kernel", "published", *QUICK, "--family", "general", "--family", "scale",
                             "--require", "exact", "--out", self.folder / out)
            files = {path.name for path in self.folder_holds(self.folder / out)}
        self.assertLessEqual({"report.html", "report.md", "junit.xml", "report.sarif", "record.csv", "ratchet.txt", "record.json"}, files)
        record = json.loads((self.folder / "one/record.json").read_text())
        self.assertIn(r"evil\u001b[2J\nother binary32: exact: met\u202e: \x9b31m\u0007 <b>|`]]>&" + '" ' + r"\u2066turned\r",
                      [kernel["summary"] for kernel in record["kernels"]])
        self.assertIn("src/%5Cu202etxet", (self.folder / "one/report.sarif").read_text())
        for form in ("text", "markdown", "json"):
            self.said("compare", self.folder / "one", self.folder / "two", "--format", form, "--out", self.folder / "compared")
        self.folder_holds(self.folder / "compared")
        for form in ("text", "json", "csv"):
            self.assertIn(r"evil\u001b".replace("\\", "\\\\" if form == "json" else "\\"), self.said("kernels", "--kernel", TEXTS, "--format", form))
        line = QUERY % 1
        for form in ("text", "jsonl"):
            self.said("check", "-", "--kernel", TEXTS, "--format", form, stdin=line)

    def test_of_a_plug_in_by_the_other_commands(self):
        for command in (("league", "--kernel", TEXTS, *QUICK, "--no-speed"), ("diagnose", TEXTS),
                        ("search", "--kernel", TEXTS, "--evaluations", 2000, "--family", "general"),
                        ("critical-radius", "--kernel", TEXTS, "--family", "general", "--trials", 20, "--precision", "binary32")):
            out = self.folder / command[0]
            self.said(*command, "--out", out)
            self.folder_holds(out)

    def test_of_a_manifest_and_its_program(self):
        manifest = {"format": "axiscert-program/2", "name": f"p{EVIL}", "summary": EVIL, "source": f"{EVIL}:1", "version": EVIL,
                    "package": f"p{EVIL}", "command": [f"{BUILD}/programs/program", "right"], "precisions": ["binary32"]}
        path = self.folder / "m.json"
        path.write_text(json.dumps(manifest))
        self.said("run", "--kernel", f"program:{path}", *QUICK, "--family", "general", "--out", self.folder / "out")
        self.folder_holds(self.folder / "out")
        record = json.loads((self.folder / "out/record.json").read_text())
        self.assertIn(SHOWN, record["kernels"][0]["summary"])
        path.write_text(json.dumps(manifest | {"command": ["sh", "-c", "printf '\\033[2J\\n\\342\\200\\256' >&2; exit 3"]}))
        self.said("run", "--kernel", f"program:{path}", *QUICK, "--out", self.folder / "out", codes=(1, 2))
        path.write_text(json.dumps(manifest | {EVIL: 1}))
        self.assertIn(SHOWN, self.said("run", "--kernel", f"program:{path}", codes=(2,)))

    def test_of_the_names_of_files(self):
        mesh, queries, kernel = (self.folder / f"{EVIL}{end}" for end in (".obj", ".jsonl", ".so"))
        mesh.write_bytes((MODELS / "OBJ/spider.obj").read_bytes())
        queries.write_text(QUERY % 1 + QUERY % 2)
        kernel.write_bytes((BUILD / "misbehaving/texts.so").read_bytes())
        given = ("--mesh", mesh, "--queries", queries, "--kernel", f"plugin:{kernel}", *QUICK)
        text = self.said("run", *given, "--shrink", 20, "--out", self.folder / "out")
        self.assertIn(SHOWN, text)
        self.folder_holds(self.folder / "out")
        record = json.loads((self.folder / "out/record.json").read_text())
        self.assertEqual(record["plan"]["families"], [f"mesh/{SHOWN}.obj", f"queries/{SHOWN}.jsonl"])
        self.ok_plan(given)
        self.said("report", self.folder / "out")
        os.truncate(mesh, 10)
        self.said("run", "--mesh", mesh, codes=(2,))
        self.said("run", "--mesh", self.folder / f"none{EVIL}", codes=(2,))

    def ok_plan(self, given):
        """A plan finds the files by their own names."""
        self.said("plan", *given, "--out-file", self.folder / "plan.json")
        self.said("run", "--plan", self.folder / "plan.json", "--out", self.folder / "planned")
        self.assertEqual((self.folder / "planned/record.json").read_bytes(), (self.folder / "out/record.json").read_bytes())

    def test_of_a_query_and_of_a_record(self):
        line = json.loads(QUERY % 1) | {"id": f"q{EVIL}"}
        for form in ("text", "jsonl"):
            self.assertIn(SHOWN.replace("\\", "\\\\" if form == "jsonl" else "\\"),
                          self.said("check", "-", "--format", form, stdin=json.dumps(line)))
        self.run_ok("--family", "general", *QUICK)
        record = self.folder / "out/record.json"
        record.write_text(record.read_text().replace('"published"', json.dumps(f"published{EVIL}")))
        self.said("report", self.folder / "out")
        record.unlink(), (self.folder / "out/run.json").unlink()
        self.folder_holds(self.folder / "out")


if __name__ == "__main__":
    unittest.main()
