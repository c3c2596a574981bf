#!/usr/bin/env python3
"""The commands of README.md and docs/ do what the pages say: those of a session are run, of all others the options exist.

    sessions_test.py BUILD MODELS quick|long [unittest arguments]     quick or long: which of the sessions
    sessions_test.py BUILD MODELS --write PAGE...                     puts what the commands print now into these pages

A session is a page with the line `<!-- session -->`, or `<!-- session, long -->`: its commands are run in the page's order, by one shell, in an
empty folder in which axiscert/ is the tree with what BUILD has built, and `axiscert` is in the PATH. There

    <!-- file: NAME -->     the fence below is written to NAME
    $ COMMAND               in a fence without a language: is run, and what it prints compared with the lines up to the next command
    ...                     in these lines: any lines; within a line, any characters

`git clone ...` and `(cd axiscert && ./dev build release axiscert)` are not run: what they make is what is tested.
"""
import difflib
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import blocks

ROOT = Path(__file__).resolve().parents[2]
NOT_RUN = ("git clone ", "(cd axiscert && ./dev build release axiscert)")
SECONDS = 1200
# The line with which a command says once a minute how far it is, which a busy machine sees.
PROGRESS = re.compile(r"axiscert: [\w-]+: .* \(\d+ s\)")


class Shell:
    """One bash in a folder; `run` gives what a command printed, errors among it."""

    END = "end-of-the-command"

    def __init__(self, folder, build, models):
        tree = folder / "axiscert"
        (tree / "build").mkdir(parents=True)
        for path in ROOT.iterdir():
            if path.name not in ("build", ".git"):
                (tree / path.name).symlink_to(path)
        (tree / "build" / "release").symlink_to(build)
        (folder / "bin").mkdir()
        (folder / "bin" / "axiscert").symlink_to(build / "axiscert")
        (folder / "here").mkdir()
        (folder / "here" / "axiscert").symlink_to(tree)
        environment = {**os.environ, "PATH": f"{folder / 'bin'}:/usr/bin:/bin", "MODELS": str(models), "LC_ALL": "C.UTF-8"}
        self.folder = folder / "here"
        self.process = subprocess.Popen(["stdbuf", "-oL", "bash", "--norc"], cwd=self.folder, env=environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.STDOUT, text=True)

    def run(self, command):
        # Without input, so that no program reads the commands that follow.
        self.process.stdin.write(f"{{ {command}\n}} < /dev/null\nlast=$?; echo; echo {self.END}; (exit $last)\n")
        self.process.stdin.flush()
        printed = []
        for line in self.process.stdout:
            if line.rstrip("\n") == self.END:
                break
            if not PROGRESS.fullmatch(line.rstrip()):
                printed.append(line.rstrip("\n").rstrip())
        else:
            raise AssertionError(f"the shell ended at `{command}`: {printed}")
        if printed and not printed[-1]:
            printed.pop()  # of the echo
        return printed

    def close(self):
        self.process.stdin.close()
        self.process.stdout.close()
        self.process.wait()


def commands_of(lines):
    """(the command, the lines that it prints) of each command in a fence; a line that ends with a backslash goes on."""
    found = []
    goes_on = False
    for line in lines:
        if line.startswith("$ ") or goes_on:
            if goes_on:
                found[-1][0] += "\n" + line
            else:
                found.append([line[2:], []])
            goes_on = line.endswith("\\")
        else:
            found[-1][1].append(line.rstrip())
    return found


def pattern_of(expected):
    """The lines as a regular expression over the joined output: `...` alone is any lines, within a line any characters."""
    parts = [r"(?:[^\n]*\n)*" if line.strip() == "..." else re.escape(line).replace(r"\.\.\.", r"[^\n]*") + r"\n" for line in expected]
    return re.compile("".join(parts))


def play(shell, text, page, say):
    """Runs the page's commands. `say(page, command, expected, printed)` hears of each."""
    for block in blocks.blocks_of(page, text):
        if block.kind != "fence":
            continue
        if block.marker.startswith("file: "):
            # Where the shell is now, not where it began.
            (where,) = shell.run("pwd")
            path = Path(where) / block.marker.removeprefix("file: ")
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text("\n".join(block.lines) + "\n")
        elif not block.language and block.head().startswith("$ "):
            for command, expected in commands_of(block.lines):
                if not command.startswith(NOT_RUN):
                    assert "./dev" not in command, f"{page}: `{command}` would build or install"
                    while expected and not expected[-1]:
                        expected.pop()
                    say(page, command, expected, shell.run(command))


def is_as_said(expected, printed):
    return pattern_of(expected).fullmatch("".join(line + "\n" for line in printed)) is not None


def sessions(which):
    """Pages of the sessions, quick or long."""
    return [path for path in blocks.pages(ROOT)
            if (found := blocks.SESSION.search(path.read_text())) and bool(found[1]) == (which == "long")]


def stale(text, page, build, models):
    """A line for each command of the page that prints something else than the page says."""
    wrong = []

    def say(page, command, expected, printed):
        if not is_as_said(expected, printed):
            differ = "\n".join(difflib.unified_diff(expected, printed, "the page", "the command", lineterm="", n=1))
            wrong.append(f"{page}: `{command}` prints something else:\n{differ}")

    with tempfile.TemporaryDirectory() as folder:
        shell = Shell(Path(folder), build, models)
        try:
            play(shell, text, page, say)
        finally:
            shell.close()
    return wrong


def written(text, page, build, models):
    """The page with what its commands print; blocks that are as they should be stay, with their `...`."""
    at = 0  # where the commands that are still to be run begin

    def say(page, command, expected, printed):
        nonlocal text, at
        old = "\n".join([f"$ {command}", *expected]) + "\n"
        at = text.index(old, at)
        new = old if is_as_said(expected, printed) else "\n".join([f"$ {command}", *printed]) + "\n"
        text = text[:at] + new + text[at + len(old):]
        at += len(new)

    with tempfile.TemporaryDirectory() as folder:
        shell = Shell(Path(folder), build, models)
        try:
            play(shell, text, page, say)
        finally:
            shell.close()
    return text


def commands_in(text):
    """Every `axiscert ...` of a page: in fences, in code within lines and in indented lines."""
    fences = [line for block in blocks.blocks_of("", text) if not block.language for line in blocks.whole_lines(block.lines)]
    spans = [span.replace("\n", " ") for span in re.findall(r"(?<!`)`([^`]+)`(?!`)", re.sub(r"^```.*?^```", "", text, flags=re.S | re.M))]
    return [found for line in [*fences, *spans] if "git clone" not in line
            for found in re.findall(r"(?:^|[|(;&] *|\$ )(?:mpirun [^|]*?|[^\s|]*/)?axiscert ([a-z][a-z-]*(?: [^|#>]*)?)", line.strip())]


def unknown_options(command, options):
    """The options in the command's words that its subcommand has not; `options` has those of each subcommand."""
    words = command.split()
    known = options.get(words[0])
    if known is None:
        return [words[0]]
    if words[0] == "corpus" and len(words) > 1 and f"corpus {words[1]}" in options:
        known = options[f"corpus {words[1]}"]
    return [word for word in (re.match(r"--[a-z-]*|-[a-z]\b", w) for w in words[1:]) if word and word[0] not in known]


class Options(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        page = subprocess.run([BUILD / "axiscert", "man"], text=True, capture_output=True, check=True).stdout.replace("\\-", "-")
        cls.options = {}
        for section in page.split("\n.SS ")[1:]:
            name, _, body = section.partition("\n")
            cls.options[name] = set(re.findall(r"(?<![\w-])--?[a-z][a-z-]*", "\n".join(re.findall(r"^\.TP\n\.B (.*)$", body, re.M))))
            cls.options[name] |= {"--help", "-h"}
        cls.options |= {"man": {"-l", "-"}}

    def test_each_command_and_option_that_a_page_names_exists(self):
        wrong, seen = [], 0
        for path in blocks.pages(ROOT):
            for command in commands_in(path.read_text()):
                seen += 1
                wrong += [f"{path.relative_to(ROOT)}: `axiscert {command}`: there is no {word if isinstance(word, str) else word[0]}"
                          for word in unknown_options(command, self.options)]
        self.assertGreater(seen, 100)
        self.assertEqual(wrong, [])

    def test_a_planted_option_is_seen(self):
        for command, word in (("run --kernle x", "--kernle"), ("check q.jsonl --errorz", "--errorz"), ("rnu --kernel x", "rnu")):
            (found,) = unknown_options(command, self.options)
            self.assertEqual(found if isinstance(found, str) else found[0], word)


class Workflow(unittest.TestCase):
    def test_it_installs_the_libraries_that_the_program_is_linked_with(self):
        """docs/ci.md, where the build comes from a cache."""
        installed = set(re.search(r"apt-get install -y.*?\n +- uses", (ROOT / "docs/ci.md").read_text(), re.S)[0].split())
        present = {"libc6", "zlib1g", "libgcc-s1", "libstdc++6"}  # of debian:12, and of its gcc
        linked = subprocess.run(["ldd", BUILD / "axiscert"], text=True, capture_output=True, check=True).stdout
        needed = subprocess.run(["readelf", "-d", BUILD / "axiscert"], text=True, capture_output=True, check=True).stdout
        packages = set()
        for name in re.findall(r"\(NEEDED\).*\[(.*)\]", needed):
            path = Path(re.search(rf"^\s*{re.escape(name)} => (\S+)", linked, re.M)[1]).resolve()
            owner = subprocess.run(["dpkg", "-S", path], text=True, capture_output=True)
            # A merged /usr: the package may say /lib.
            owner = owner if owner.returncode == 0 else subprocess.run(["dpkg", "-S", str(path).removeprefix("/usr")], text=True, capture_output=True, check=True)
            packages.add(owner.stdout.split(":")[0])
        self.assertEqual(packages - present - installed, set())


class Figures(unittest.TestCase):
    def test_a_planted_stale_number_is_seen(self):
        command = [sys.executable, ROOT / "docs/figures.py", "--check", BUILD / "axiscert"]
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder) / "page.md"
            page.write_text("<!-- table 0 of: $ axiscert condition --trials 64 --family tangent -->\n<!-- end -->\n")
            subprocess.run([word for word in command if word != "--check"] + [page], check=True)
            self.assertEqual(subprocess.run([*command, page]).returncode, 0)
            number = re.search(r"published +tangent +(\d+)", page.read_text())[1]
            page.write_text(page.read_text().replace(f" {number} ", f" {int(number) + 1} ", 1))
            done = subprocess.run([*command, page], text=True, capture_output=True)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("out of date", done.stderr)


class Sessions(unittest.TestCase):
    def test_each_page_prints_what_it_says(self):
        pages = sessions(WHICH)
        self.assertTrue(pages)
        for path in pages:
            with self.subTest(path.name):
                self.assertEqual(stale(path.read_text(), path.name, BUILD, MODELS), [],
                                 f"docs/checks/sessions_test.py BUILD MODELS --write {path.relative_to(ROOT)} puts these lines there")

    def test_a_planted_stale_number_is_seen(self):
        page = "<!-- session -->\n<!-- file: a.txt -->\n```json\n17\n```\n\n```\n$ cat a.txt\n18\n$ printf 'a 1\\nb 2\\nc 3\\n'\na ...\n...\nc 3\n```\n"
        (wrong,) = stale(page, "planted.md", BUILD, MODELS)
        self.assertIn("`cat a.txt` prints something else", wrong)
        self.assertIn("-18\n+17", wrong)
        self.assertEqual(stale(page.replace("18", "17"), "planted.md", BUILD, MODELS), [])


if __name__ == "__main__":
    BUILD, MODELS, WHICH = Path(sys.argv.pop(1)).resolve(), Path(sys.argv.pop(1)).resolve(), sys.argv.pop(1)
    if WHICH == "--write":
        for name in sys.argv[1:]:
            path = Path(name).resolve()
            path.write_text(written(path.read_text(), path.name, BUILD, MODELS))
    else:
        # The options are asked for once.
        unittest.main(defaultTest=None if WHICH == "quick" else "Sessions")
