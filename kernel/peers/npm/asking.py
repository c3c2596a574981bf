"""Asks a program over the pipe (docs/pipe.md): the side of the format that axiscert has, for tests that need no build of it."""
import hashlib
import json
import struct
import subprocess
import sys
import unittest
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
VERDICTS = ("contact", "separated", "undecided", "invalid")
# Each question: a predicate, or PREDICATE/ENTRY where the predicate has several; the members of its query lines, and how many numbers these have.
MEMBERS = {"sphere-triangle": ("a", "b", "c", "p", "r"), "moving-sphere": ("a", "b", "c", "p", "d", "r"), "box-box": ("a", "b"),
           "box-triangle": ("box", "a", "b", "c")}
COLUMNS = {"sphere-triangle": 13, "moving-sphere": 16, "box-box/matrix": 30, "box-box/quaternion": 20, "box-triangle/centre": 15,
           "box-triangle/minmax": 15, "box-triangle/matrix": 24}
FIRST_ENTRY = {"sphere-triangle": "vertices", "moving-sphere": "displacement"}  # of those that need no name of theirs above
BOX_MEMBERS = "mslhbq"
VERSION, REPLY = 3, 16  # of the streams; bytes of a reply without measures
SECONDS = 300  # for a program to answer a stream


def installed():
    """Whether the engines' packages are there, in the versions of package.json."""
    wanted = json.loads((FOLDER / "package.json").read_text())["dependencies"]
    for package, version in wanted.items():
        file = FOLDER / "node_modules" / package / "package.json"
        if not file.exists() or json.loads(file.read_text())["version"] != version:
            return False
    return True


def main():
    """Runs the calling script's tests where the engines are installed; otherwise says so and exits with 77."""
    if not installed():
        print("NOT CHECKED: the engines of kernel/peers/npm are not installed, or in other versions than package.json has; "
              "`./dev engines` brings them", file=sys.stderr)
        sys.exit(77)
    unittest.main()


def manifests():
    """Every manifest by its path, in order; a predicate's are in a folder of its id."""
    return {file: json.loads(file.read_text()) for file in sorted(FOLDER.glob("*-*/*.json"))}


def faults():
    """Every known fault, predicate by predicate in the order of the files."""
    return [json.loads(line) for predicate in MEMBERS for line in (FOLDER / predicate / "faults.jsonl").read_text().splitlines()]


def contact_faults():
    """Every known fault in the numbers beside a verdict, alike. `what` is what `axiscert shrink --what` keeps of it; `engine` has the numbers too."""
    files = [FOLDER / predicate / "contact_faults.jsonl" for predicate in MEMBERS]
    return [json.loads(line) for file in files if file.exists() for line in file.read_text().splitlines()]


def question_of(manifest):
    """The question that a program answers, as COLUMNS names it."""
    return f"{manifest['predicate']}/{manifest['entry']}" if "entry" in manifest else manifest["predicate"]


def query_of(line):
    """A known fault as a line of a query file."""
    return {member: line[member] for member in ("id", "predicate", "entry", "precision", *MEMBERS[line.get("predicate", "sphere-triangle")]) if member in line}


def flat(given):
    if isinstance(given, str):
        return [float.fromhex(given)]
    parts = [given[member] for member in BOX_MEMBERS if member in given] if isinstance(given, dict) else given
    return [number for part in parts for number in flat(part)]


def numbers_of(line):
    """The numbers of a query line, in the order of the predicate's columns; exact, as each has to be given as a hex float."""
    return flat([line[member] for member in MEMBERS[line.get("predicate", "sphere-triangle")]])


def stream(queries, precision="binary32", question="sphere-triangle", measures=0):
    """The bytes of a query stream that asks for so many measures beside each verdict."""
    bits = {"binary32": 32, "binary64": 64}[precision]
    predicate, _, entry = question.partition("/")
    columns = COLUMNS.get(question, 13)
    plan = json.dumps({"predicate": predicate, "entry": entry or FIRST_ENTRY.get(predicate, ""), "columns": columns,
                       **({"measures": measures} if measures else {})}).encode().ljust(128)
    head = struct.pack("<8sIIQII", b"AXISCERT", VERSION, bits, len(queries), 64 + len(plan), columns * bits // 8)
    record = struct.Struct(f"<{columns}{'f' if bits == 32 else 'd'}")
    return head + hashlib.sha256(plan).digest() + plan + b"".join(record.pack(*query) for query in queries)


def run(command, folder, sent):
    """The exit status, standard output and standard error of a program that is started in `folder` and given `sent`."""
    return subprocess.run(command, cwd=folder, input=sent, capture_output=True, timeout=SECONDS)


def verdicts(output, sent, count):
    """The verdicts of the reply stream that `output` begins with, to `sent` of `count` queries; and what follows the stream."""
    size = struct.unpack_from("<I", sent, 24)[0]
    end = size + REPLY * count
    assert output[:size] == sent[:size], "the reply stream does not begin with the query stream's header"
    assert len(output) >= end, f"{len(output)} bytes of reply, not {end}"
    assert not any(output[i] for i in range(size, end) if (i - size) % REPLY), "a reply has more than a verdict"
    return [VERDICTS[v] for v in output[size:end:REPLY]], output[end:]


def ask_measures(command, folder, queries, count, precision="binary32", question="moving-sphere"):
    """Verdict and `count` measures of each query, from a stream that asks for these."""
    sent = stream(queries, precision, question, count)
    done = run(command, folder, sent)
    assert done.returncode == 0, f"{command} exited with {done.returncode}: {done.stderr.decode(errors='replace')[-2000:]}"
    size = struct.unpack_from("<I", sent, 24)[0]
    reply = struct.Struct(f"<BB14x{count}{'f' if precision == 'binary32' else 'd'}")
    assert len(done.stdout) == size + reply.size * len(queries), f"{len(done.stdout)} bytes"
    answers = []
    for verdict, flags, *numbers in reply.iter_unpack(done.stdout[size:]):
        assert flags == 2, f"the flags are {flags}; bit 1 says that measures follow"
        answers.append((VERDICTS[verdict], numbers))
    return answers


def ask_each(command, folder, streams, precision="binary32", question="sphere-triangle"):
    """The verdicts of one process on several streams, a list of queries each."""
    sent = [stream(queries, precision, question) for queries in streams]
    done = run(command, folder, b"".join(sent))
    assert done.returncode == 0, f"{command} exited with {done.returncode}: {done.stderr.decode(errors='replace')[-2000:]}"
    answers, rest = [], done.stdout
    for queries, bytes_sent in zip(streams, sent):
        given, rest = verdicts(rest, bytes_sent, len(queries))
        answers.append(given)
    assert not rest, f"{len(rest)} bytes after the last reply"
    return answers


def ask(command, folder, queries, precision="binary32", question="sphere-triangle"):
    return ask_each(command, folder, [queries], precision, question)[0]
