"""theorems.txt: the axioms that the main theorems rest on, each with a letter; each main theorem with the letters of its axioms and its
statement, as Coq prints it; and each definition that the statements use, by the SHA-256 of what Coq prints of it.

A definition's name has its file (`Filter.values`) where two files define it."""
import dataclasses
import hashlib
import re
import sys

HEADINGS = ["# The axioms of Coq's library that the main theorems rest on", "# The main theorems, with the axioms of each",
            "# The definitions that the statements use, by the SHA-256 of what Coq prints"]


@dataclasses.dataclass
class Theorems:
    axioms: dict       # letter: "NAME : STATEMENT"
    theorems: dict     # name: (letters, statement); None where prove.py --update has to complete the line
    definitions: dict  # name, with its file where two have it: digest, or None

    def text(self):
        lines = [HEADINGS[0], *(f"{letter} {axiom}" for letter, axiom in self.axioms.items()), "", HEADINGS[1],
                 *(f"{name} [{letters}] : {statement}" for name, (letters, statement) in self.theorems.items()), "", HEADINGS[2],
                 *(f"{name} {digest}" for name, digest in self.definitions.items())]
        return "\n".join(lines) + "\n"


def read(path):
    pieces = path.read_text().split("\n\n")
    if [piece.splitlines()[0] for piece in pieces] != HEADINGS:
        sys.exit(f"prove: {path}: there are not three parts, with a blank line between them, that begin with {HEADINGS}")
    axioms, theorems, definitions = (piece.splitlines()[1:] for piece in pieces)
    lines = [re.fullmatch(r"(\w+)(?: \[(\w*)\] : (.+))?", line) or line for line in theorems]
    if wrong := [line for line in lines if isinstance(line, str)]:
        sys.exit(f"prove: {path}: '{wrong[0]}' is not 'NAME [AXIOMS] : STATEMENT', nor a NAME alone, which prove.py --update completes")
    return Theorems(dict(line.split(" ", 1) for line in axioms), {line[1]: (line[2], line[3]) for line in lines},
                    {name: digest or None for name, _, digest in (line.partition(" ") for line in definitions)})


def digest_of(text):
    return hashlib.sha256(text.encode()).hexdigest()


def printing(command, names):
    """The commands of Coq that print something of each name, under a line that has the name."""
    return "".join(f'Goal True. idtac "== {name}". Abort.\n{command} {name}.\n' for name in names)


def asking(held, imports):
    """The files Statements.v and Assumptions.v, which print what theorems.txt holds."""
    begin = "From Coq Require Import Reals ZArith List.\nFrom Flocq Require Import Core BinarySingleNaN.\n" \
            f"From Axiscert Require Import {' '.join(imports)}.\n"
    return {"Statements.v": begin + "Open Scope R_scope.\nSet Printing Width 120.\n" + printing("Check", held.theorems)
            + printing("Print", held.definitions),
            "Assumptions.v": begin + printing("Print Assumptions", held.theorems)}


def by_name(printed):
    """What Coq printed, by name."""
    pieces = re.split(r"^== ([\w.']+)\n", printed, flags=re.M)
    return dict(zip(pieces[1::2], pieces[2::2]))


def one_line(text):
    return " ".join(text.split())


def axioms_in(printed):
    """The axioms in what Print Assumptions printed: 'NAME : STATEMENT' each."""
    if printed.startswith("Closed under the global context"):
        return []
    return [one_line(axiom) for axiom in re.split(r"^(?=\S)", printed, flags=re.M)[1:] if axiom.strip() != "Axioms:"]


def statement_in(name, printed):
    return one_line(printed).removeprefix(f"{name} : ")
