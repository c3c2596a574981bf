#!/usr/bin/env python3
"""Every printed block of README.md and docs/, and the check that holds it.

    blocks.py [ROOT]     prints each with what holds it; exits 1 where one is held by nothing

A block is a fence (```), lines that are indented like one, a table of figures (one with a column of numbers) or a picture. What may hold it:

- docs/figures.py, which runs the command of `<!-- $ axiscert ... -->`, `<!-- table N of: $ axiscert ... -->`, where a test gives it the page
- docs/checks/readme_test.py, which makes the table between `<!-- table: NAME -->` and `<!-- end -->`
- docs/checks/sessions_test.py, which runs each `$ command` of a page with `<!-- session -->` (quick) or `<!-- session, long -->`, in order, and
  compares what it prints; there the fence after `<!-- file: NAME -->` is a file
- the test named in `<!-- held by PATH -->` before it, which has to exist and to name the page
- kernel/peers/npm/upstream_test.py, for the programs of docs/upstream
- of a picture, a script or test that names its file (docs/checks/picture.py), or a page of a session that compares it

A fence in a language (```c) is source, and no output. A fence of commands alone prints nothing; sessions_test.py asks whether each option in
it exists. docs/checks/unheld.txt lists what none can hold, each with its reason; a line there that matches no block is an error too.
"""
import re
import sys
from dataclasses import dataclass
from pathlib import Path

FIGURES, TABLES, SESSIONS = "docs/figures.py", "docs/checks/readme_test.py", "docs/checks/sessions_test.py"
UPSTREAM = "kernel/peers/npm/upstream_test.py"
UNHELD = "docs/checks/unheld.txt"
LANGUAGES = ("c", "cpp", "js", "json", "python", "cmake", "yaml", "rust", "wgsl")
COMMENT = re.compile(r"<!-- (.*?) -->")
SESSION = re.compile(r"^<!-- session(, long)? -->$", re.M)
# A line of a block of commands: a program, its arguments, perhaps a comment. No program that is listed here prints its own name first.
COMMAND = re.compile(r"^\s*\(?(axiscert|\./dev|\./my-program|build/\S+|P/bin/axiscert|cmake|ctest|cpack|cd|mpirun|cc|c\+\+|sed|grep|git|eval)( .*)?$")
NUMBER = re.compile(r"^[-~<>=|]*\s*\d[\d.,]*(e[-+]?\d+)?(?=$|[\s%^(/;:.])")


@dataclass
class Block:
    file: str      # from the root
    line: int      # of its first line, from 1
    kind: str      # "fence", "indented", "table" or "picture"
    language: str  # of a fence; empty where none is named
    marker: str    # the comment before it, without <!-- -->; empty where there is none
    lines: list

    def name(self):
        return f"{self.file}:{self.line}"

    def head(self):
        """Its name in unheld.txt: the first line that says something."""
        return next((line.strip() for line in self.lines if line.strip()), "")


def is_of_figures(rows):
    """Whether some column of the table's rows (without its head) is of numbers for the most part."""
    columns = list(zip(*([cell.strip(" `*") for cell in row.strip().strip("|").split("|")] for row in rows)))
    return any(2 * sum(bool(NUMBER.match(cell)) for cell in column) > len(column) for column in columns)


def blocks_of(file, text):
    """Every fence and table of figures in the text of a page."""
    found, marker, inside, in_list = [], "", "", False
    lines = text.split("\n")
    at = 0
    while at < len(lines):
        line = lines[at]
        comment = COMMENT.fullmatch(line)
        if line.startswith("```"):
            end = next(i for i in range(at + 1, len(lines)) if lines[i].startswith("```"))
            found.append(Block(file, at + 1, "fence", line[3:].strip(), marker or inside, lines[at + 1:end]))
            at = end
        elif line.startswith("|") and at + 1 < len(lines) and re.fullmatch(r"\|[-:| ]+\|", lines[at + 1]):
            end = next(i for i in range(at, len(lines)) if not lines[i].startswith("|"))
            if is_of_figures(lines[at + 2:end]):
                found.append(Block(file, at + 1, "table", "", marker or inside, lines[at:end]))
            at = end - 1
        elif line.startswith("    ") and (at == 0 or not lines[at - 1].strip() or lines[at - 1].startswith("#")) and not in_list:
            end = next(i for i in range(at, len(lines)) if not lines[i].startswith("    "))
            found.append(Block(file, at + 1, "indented", "", marker, [part[4:] for part in lines[at:end]]))
            at = end - 1
        elif line.startswith("!["):
            found.append(Block(file, at + 1, "picture", "", marker or inside, [line]))
        elif comment and comment[1] != "end" and not comment[1].startswith("session"):
            marker = comment[1]
            inside = marker if re.match(r"table: |\$ |(table|plot) \d", marker) else ""
            at += 1
            continue
        if comment and comment[1] == "end":
            inside = ""
        if line.strip():
            marker = ""
            in_list = line.startswith(("- ", "* ", "  ")) or re.match(r"\d+\. ", line) is not None
        at += 1
    return found


def whole_lines(lines):
    """The lines, each with what follows it after a backslash."""
    return re.sub(r"\\\n\s*", "", "\n".join(lines)).split("\n")


def holder_of_picture(block, text, root, calls):
    """As holder, of a picture."""
    name = re.search(r"\((?:\S*/)?([^/\s]+)\)", block.lines[0])[1]
    if "$ axiscert" in block.marker:
        return FIGURES if re.search(rf"figures.*/{re.escape(block.file)}\b", calls) else ""
    if SESSION.search(text) and re.search(rf"^\$ cmp .*/{re.escape(name)}$", text, re.M):
        return SESSIONS
    # The picture of a walk is named after its mesh.
    words = (name, 'f"walk-') if name.startswith("walk-") else (name,)
    scripts = [path for path in (*root.glob("docs/checks/*.py"), *root.glob("examples/**/*_test.py"), *root.glob("python/tests/*.py"))
               if not path.name.startswith("blocks") and any(word in path.read_text() for word in words)]
    return scripts[0].relative_to(root).as_posix() if scripts else ""


def holder(block, text, root, calls):
    """The check that holds the block, or nothing; `calls` is the text of the lists of tests."""
    if block.language in LANGUAGES:
        return "source"
    if block.kind == "picture":
        return holder_of_picture(block, text, root, calls)
    page = block.file.removeprefix("docs/")
    if re.match(r"((table|plot) \d+ of: )?\$ axiscert ", block.marker):
        return FIGURES if re.search(rf"figures.*/docs/{re.escape(page)}\b", calls) else ""
    if block.marker.startswith("table: "):
        return TABLES if f'"{block.marker.split()[1]}"' in (root / TABLES).read_text() else ""
    script = re.match(r"(?:held by|\$) (\S+\.(?:py|cpp|h))$", block.marker)
    if script:
        path = root / script[1]
        return script[1] if path.is_file() and page.split("/")[-1] in path.read_text() else ""
    session = SESSION.search(text)
    if session and block.marker.startswith("file: "):
        return "source"
    if session and block.kind == "fence" and block.head().startswith("$ "):
        return SESSIONS + (session[1] or "")
    if block.file.startswith("docs/upstream/") and block.kind == "fence" and re.search(
            r"\n```\n\nIt prints\n\n```\n" + re.escape("\n".join(block.lines)) + "\n```\n", text):
        return UPSTREAM
    if block.kind in ("fence", "indented") and all(COMMAND.match(line) for line in whole_lines(block.lines) if line.strip()):
        return SESSIONS + ", options"
    return ""


def unheld_lines(root):
    """(page, beginning of the block's head, reason) of each line of unheld.txt."""
    entries = []
    for line in (root / UNHELD).read_text().splitlines():
        if line and not line.startswith("#"):
            page, head, reason = (part.strip() for part in line.split(" :: "))
            entries.append((page, head, reason))
    return entries


def pages(root):
    return [root / "README.md", *sorted((root / "docs").rglob("*.md"))]


def report(root, changed=None):
    """(a line for each block, the errors). `changed` maps pages to other texts, for the tests."""
    changed = changed or {}
    calls = "\n".join(path.read_text() for path in (root / "cli").glob("CMakeLists.txt"))
    entries, used = unheld_lines(root), set()
    shown, errors = [], []
    for path in pages(root):
        file = path.relative_to(root).as_posix()
        text = changed.get(file, path.read_text())
        for block in blocks_of(file, text):
            held = holder(block, text, root, calls)
            if not held:
                entry = next((e for e in entries if e[0] == file and block.head().startswith(e[1])), None)
                if entry:
                    used.add(entry)
                    held = f"{UNHELD}: {entry[2]}"
            shown.append(f"{block.name()}: {block.kind}: {held or 'NOT HELD'}: {block.head()[:60]}")
            if not held:
                errors.append(f"{block.name()}: no check holds this {block.kind}, which begins `{block.head()[:80]}`; blocks.py says what can")
    errors += [f"{UNHELD}: no block of {page} begins `{head}`" for page, head, _ in set(entries) - used]
    return shown, errors


if __name__ == "__main__":
    shown, errors = report(Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else Path(__file__).resolve().parents[2])
    print("\n".join(shown))
    sys.exit("\n".join(errors))
