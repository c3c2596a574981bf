#!/usr/bin/env python3
"""trace_query.py PROGRAM [--predicate ID] [--all]: follows queries through the code, and holds docs/a-query.md to what it saw.

PROGRAM is `axiscert`, or `axiscert_toy`, which knows the suite's own predicate too; any build of it will do. For each predicate the
script runs

    PROGRAM run --kernel KERNEL --family FAMILY --precision binary64 --trials 1024 --threads 1 --shrink 0

with the first kernel and family of the program's own lists of which a query is kept as a witness, so that a new predicate needs no line
here. Every function of the tree has a breakpoint, which goes when it is hit: what is left is the order in which functions were first
entered, as by a reader, who reads each once. What the compiler inlined everywhere is no function of the program and is not seen.

The road of a predicate is the functions that docs/a-query.md names (`FILE: FUNCTION`, `FILE: CLASS::FUNCTION`), in the page's order;
**WORD** in a part stands for the predicate's cell in the column WORD of the table. A file and its header are one. A change is a step to
another file, a change back one to a file that was left before. It is wrong if
- a function was not entered, or before one that the page names earlier;
- it was called by a function of a file that the page has not named until then, so that a reader would not see where it comes from;
- a predicate of the program has no row in the table.
Functions of headers are exempt, as they may be inlined here and entered elsewhere.

--all prints instead every function that was entered between the first query and the reports, with its file, by the definitions of the
tree ("a | b": it could be either), `<` where the file had been left before.

Needs x86-64 Linux, nm and c++filt; ends with 77 (skipped) elsewhere."""
import argparse
import bisect
import ctypes
import json
import os
import pathlib
import platform
import re
import signal
import subprocess
import sys
import tempfile
from collections import defaultdict

ROOT = pathlib.Path(__file__).resolve().parents[2]
LAYERS = ("kernel", "exact", "fuzz", "reports", "plans", "cli")
STEP = r"`([\w./-]+\.(?:cpp|h|js)): ((?:\w+::)?\w+)`"


# The page.

def roads(page):
    """By predicate: the steps of its road, (file, function, heading of the part)."""
    rows = [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in page.splitlines() if line.startswith("|")]
    columns, rows = rows[0], [row for row in rows[1:] if not row[0].startswith("-")]
    parts = re.findall(r"^## ([^\n]*)\n(.*?)(?=^## |\Z)", re.sub(r"^\|.*$", "", page, flags=re.M), re.M | re.S)
    found = {}
    for row in rows:
        cells = dict(zip(columns, row))
        found[cells[columns[0]]] = [
            (file, function, heading) for heading, text in parts
            for word, file, function in re.findall(rf"\*\*(\w+)\*\*|{STEP}", text)
            for file, function in (re.findall(STEP, cells[word]) if word in cells else [(file, function)] if file else [])]
    return found


def stem(file):
    """A file and its header are one to a reader."""
    return re.sub(r"(-inl)?\.(cpp|h|js)$", "", file)


def changes(files):
    """(changes of file, changes back to a file that was left) along a road."""
    there, left, count, back = None, set(), 0, 0
    for file in map(stem, files):
        if there is not None and file != there:
            left.add(there)
            count += 1
            back += file in left
        there = file
    return count, back


# The tree.

def definitions():
    """(class or "", function) -> the files that define it. Sources are as clang-format leaves them: what is defined outside of a class
    begins in column 0."""
    found = defaultdict(set)
    for path in sorted(path for layer in LAYERS for path in (ROOT / layer).rglob("*")):
        if path.suffix not in (".cpp", ".h") or re.search(r"_(test|bench|target|testing)\.", path.name):
            continue
        file, text = str(path.relative_to(ROOT)), re.sub(r"//.*", "", path.read_text())
        for name, body in re.findall(r"^(?:template <[^\n]*>\s)?(?:class|struct) (\w+)[^;{()]*\{(.*?)^\}", text, re.M | re.S):
            for function in re.findall(r"(~?\w+)\(", body):
                found[name, function].add(file)
        for match in re.finditer(r"^(?!template|class|struct|namespace|using|enum|typedef|#)[A-Za-z_][^\n(;=]*?"
                                 r"(?:\b(\w+)(?:<[^()<>\n]*>)?::)?(~?\w+)\(", text, re.M):
            depth, end = 1, match.end()
            while depth and end < len(text):
                depth += {"(": 1, ")": -1}.get(text[end], 0)
                end += 1
            if re.match(r"[^;{]*\{", text[end:]):
                found[match[1] or "", match[2]].add(file)
    return found


def components(symbol):
    """KernelRun, judge of `axiscert::KernelRun<double>::judge(unsigned long)`; none of what is not the tree's."""
    symbol = re.sub(r"\(anonymous namespace\)|\[[^\]]*\]", "", symbol)
    flat, depth = "", 0
    for c in re.sub(r"operator *(\(\)|[^\w(]+)", "operator_", symbol):
        if c in "<({":
            if c == "(" and depth == 0:
                break
            depth += 1
        elif c in ">)}":
            depth -= 1
        elif depth == 0:
            flat += c
    names = [name for name in flat.split(" ")[-1].split("::") if name]
    return names[1:] if names[:1] == ["axiscert"] else []


class Tree:
    def __init__(self):
        self.defined = definitions()
        self.texts = {}

    def files(self, names):
        """Where a function of these components may be defined: a member in the file of one of its classes."""
        for i in range(len(names) - 2, -1, -1):
            if (names[i], names[-1]) in self.defined:
                return self.defined[names[i], names[-1]]
        return self.defined.get(("", names[-1]), set())

    def stems(self, names):
        return sorted(set(map(stem, self.files(names)))) if names else []

    def is_step(self, names, file, function):
        wanted = function.split("::")
        if names[-len(wanted):] != wanted:
            return False
        files = self.files(names)
        if files:
            return stem(file) in map(stem, files)
        text = self.texts.setdefault(file, (ROOT / file).read_text())  # a macro made it
        return re.search(rf"\b{wanted[-1]}\b", text) is not None


# The trace.

TRACEME, PEEKUSER, POKEUSER, CONT, SETOPTIONS = 0, 3, 6, 7, 0x4200
FORK, VFORK, CLONE, EXITKILL = 2, 4, 8, 0x100000
RIP, RSP = 16 * 8, 19 * 8  # in the registers that the kernel shows
ALL_THREADS = 0x40000000


def symbols(program):
    """Address -> name, of every function of the program in the order of addresses."""
    found = {}
    lines = subprocess.run(["nm", "--defined-only", "--numeric-sort", program], text=True, capture_output=True, check=True).stdout
    for address, kind, name in (line.split(maxsplit=2) for line in lines.splitlines()):
        if kind in "tTwW":
            found.setdefault(int(address, 16), name)
    names = subprocess.run(["c++filt"], input="\n".join(found.values()), text=True, capture_output=True, check=True).stdout
    return dict(zip(found, names.splitlines()))


def first_entries(command, addresses):
    """Address -> the address to which it returned, in the order in which they were first executed."""
    libc = ctypes.CDLL(None, use_errno=True)
    libc.ptrace.argtypes, libc.ptrace.restype = [ctypes.c_long, ctypes.c_long, ctypes.c_void_p, ctypes.c_void_p], ctypes.c_long
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               preexec_fn=lambda: libc.ptrace(TRACEME, 0, None, None))
    _, status = os.waitpid(process.pid, 0)
    if not os.WIFSTOPPED(status):
        raise SystemExit("this machine lets no process trace another")
    libc.ptrace(SETOPTIONS, process.pid, None, FORK | VFORK | CLONE | EXITKILL)
    program = os.path.realpath(command[0])
    base = next(int(line.split("-")[0], 16) for line in open(f"/proc/{process.pid}/maps") if line.rstrip().endswith(program))
    memory = os.open(f"/proc/{process.pid}/mem", os.O_RDWR)
    planted = {}
    for address in addresses:
        planted[base + address] = os.pread(memory, 1, base + address)
        os.pwrite(memory, b"\xcc", base + address)
    entered = {}
    libc.ptrace(CONT, process.pid, None, None)
    while True:
        thread, status = os.waitpid(-1, ALL_THREADS)
        if not os.WIFSTOPPED(status):
            if thread != process.pid:
                continue
            process.returncode = os.waitstatus_to_exitcode(status)
            os.close(memory)
            return entered, process.returncode
        stop = os.WSTOPSIG(status)
        at = libc.ptrace(PEEKUSER, thread, RIP, None) - 1
        if stop == signal.SIGTRAP and status >> 16 == 0 and at in planted:
            with open(f"/proc/{thread}/mem", "rb+", buffering=0) as own:  # that of a child, which has the breakpoints too
                own.seek(at)
                own.write(planted[at])
            returns_to = os.pread(memory, 8, libc.ptrace(PEEKUSER, thread, RSP, None))
            entered.setdefault(at - base, int.from_bytes(returns_to, "little") - base)
            libc.ptrace(POKEUSER, thread, RIP, at)
        passed_on = 0 if stop in (signal.SIGTRAP, signal.SIGSTOP) else stop
        libc.ptrace(CONT, thread, None, passed_on)


def listed(program, *arguments):
    return json.loads(subprocess.run([program, *arguments, "--format", "json"], capture_output=True, check=True).stdout)


def run_with_witness(program, predicate, folder):
    """The first run of the lists that keeps a witness."""
    for kernel in listed(program, "kernels", "--predicate", predicate)["kernels"]:
        for family in listed(program, "families", "--predicate", predicate)["families"]:
            command = [program, "run", "--kernel", kernel["id"], "--family", family["name"], "--precision", "binary64", "--trials",
                       "1024", "--threads", "1", "--shrink", "0", "--out", folder]
            record = pathlib.Path(folder, "record.json")
            record.unlink(missing_ok=True)
            subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            if record.exists() and json.loads(record.read_text())["witnesses"]:
                return command
    raise SystemExit(f"{predicate}: no kernel is wrong in any family")


class Trace:
    """The functions of a program that are the tree's, by their components, in the order of first entry."""

    def __init__(self, functions, entered):
        self.functions, self.starts = functions, list(functions)
        self.addresses = list(entered)
        self.names = [functions[address] for address in entered]
        self.returns_to = entered

    def caller(self, address):
        """The function that called this one when it was first entered; None if that is in a library, or unknown."""
        at = bisect.bisect_left(self.starts, self.returns_to.get(address, -1)) - 1
        return self.starts[at] if 0 <= at < len(self.starts) - 1 else None


# The printout.

def print_all(names_in_order, tree):
    there, left, count, back, files, seen = None, set(), 0, 0, set(), set()
    begin, end = (next(i for i, names in enumerate(names_in_order) if names[-1:] == [name]) for name in ("run_unit", "render_reports"))
    for names in names_in_order[begin:end + 1]:
        found = tree.stems(names)
        if not found or names[-1].startswith("~") or tuple(names) in seen:
            continue
        seen.add(tuple(names))
        where = there if there in found else " | ".join(found)
        if where != there:
            left.add(there)
            count += 1
            back += where in left
            print(f"{'<' if where in left else ' '} {where}")
        print(f"      {'::'.join(names)}")
        there = where
        files.add(where)
    print(f"{len(seen)} functions, {len(files)} files, {count} changes of file, {back} of them back")


def passed_through(address, seen_files, trace, tree):
    """The functions between this one and the nearest caller in one of the files."""
    between, walked = [], set()
    while (address := trace.caller(address)) is not None and address not in walked:
        walked.add(address)
        files = tree.stems(trace.functions[address])
        if seen_files.intersection(files):
            return between
        between += [f"{'::'.join(trace.functions[address])} of {' or '.join(files)}"] if files else []
    return []


def faults_of(road, trace, tree):
    """What is wrong with a road, given what was entered."""
    wrong, place, seen = [], 0, set()
    for file, function, _ in road:
        seen.add(stem(file))
        if not file.endswith(".cpp"):
            continue
        at = [i for i, names in enumerate(trace.names) if tree.is_step(names, file, function)]
        after = [i for i in at if i >= place]
        if after:
            place = after[0]
            between = passed_through(trace.addresses[place], seen, trace, tree)
            if between:
                wrong.append(f"{file}: {function} is reached through {', '.join(between)}, which the page does not name")
        elif at:
            wrong.append(f"{file}: {function} is entered, but before a step that the page has earlier")
        elif any(tree.is_step(names, file, function) for names in trace.functions.values()):
            wrong.append(f"{file}: {function} is not entered, or inlined where it is called")
        else:
            print(f"  {file}: {function} is inlined")
    return wrong


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--predicate")
    parser.add_argument("--all", action="store_true")
    asked = parser.parse_args()
    if platform.machine() != "x86_64" or sys.platform != "linux":
        print("NOT CHECKED: breakpoints are those of x86-64 Linux")
        return 77
    program, page, tree = os.path.realpath(asked.program), roads((ROOT / "docs/a-query.md").read_text()), Tree()
    functions = {address: components(name) for address, name in symbols(program).items()}
    wrong = []
    for predicate in [asked.predicate] if asked.predicate else [predicate["id"] for predicate in listed(program, "predicates")["predicates"]]:
        with tempfile.TemporaryDirectory() as folder:
            command = run_with_witness(program, predicate, folder)
            entered, code = first_entries(command, [address for address, names in functions.items() if names])
        trace = Trace(functions, entered)
        print(f"{predicate}: kernel {command[3]}, family {command[5]}, exit code {code}")
        if asked.all:
            print_all(trace.names, tree)
            continue
        if predicate not in page:
            wrong.append(f"docs/a-query.md has no row for {predicate}")
            continue
        for file, function, _ in page[predicate]:
            print(f"  {file}: {function}")
        count, back = changes([file for file, _, _ in page[predicate]])
        print(f"  {len(page[predicate])} functions, {count} changes of file, {back} of them back")
        wrong += [f"docs/a-query.md, {predicate}: {fault}" for fault in faults_of(page[predicate], trace, tree)]
    for line in wrong:
        print(line, file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
