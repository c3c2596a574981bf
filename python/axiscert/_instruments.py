"""The instruments: what the commands of the same names measure, find and compare."""
from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import warnings
from typing import Any, Dict, Iterable, List, Optional, Sequence, Tuple, Union

from . import _core
from ._errors import Error, Interrupted, Notice, above_zero, checked, flag, path, text, whole
from ._judge import Names, Path, Progress, Record, folder_of, names, of_family, query_files, require_no_load, run_watched
from ._kernels import Kernel, as_kernel, as_kernels
from ._queries import Queries, load_all_queries, show_notices

_BIN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "bin")


class Report:
    """The figures of an instrument: `json` as docs/data.md says, `str(report)` as the command prints them.

    `complete` is false where it was interrupted. `witnesses` are queries that it found, as lines of a query file.
    """

    def __init__(self, given: Tuple[str, str, str, str, Any], complete: bool = True, witnesses: str = "") -> None:
        self.name, text, self.text, self._page, _ = given
        self.bytes = text.encode()
        self.json: Dict[str, Any] = json.loads(text)
        self.complete, self.witnesses = complete, witnesses

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return f"<{self.name}: {', '.join(self.json)}>"

    def _repr_html_(self) -> str:
        import html

        return f"<pre>{html.escape(self.text)}</pre>"

    def to_pandas(self, member: str) -> Any:
        """A DataFrame of one member of `json` that is a list of objects."""
        import pandas

        rows = self.json.get(member)
        if not isinstance(rows, list):
            lists = [name for name, value in self.json.items() if isinstance(value, list)]
            raise Error(f"there is no list '{member}' in these figures; there are: {', '.join(lists) or 'none'}")
        return pandas.json_normalize(rows)

    def witness_queries(self) -> List[Queries]:
        """The queries of the witnesses, of each predicate, entry and precision by themselves."""
        if not self.witnesses:
            return []
        with tempfile.TemporaryDirectory(prefix="axiscert-") as folder:
            path = os.path.join(folder, "witnesses.jsonl")
            with open(path, "w", encoding="utf-8") as file:
                file.write(self.witnesses)
            return load_all_queries(path)

    def save(self, folder: Path) -> None:
        """Writes NAME.json, NAME.html and, where there are any, witnesses.jsonl."""
        folder = path("folder", folder)
        os.makedirs(folder, exist_ok=True)
        for name, text in ((f"{self.name}.json", self.bytes.decode()), (f"{self.name}.html", self._page),
                           ("witnesses.jsonl", self.witnesses)):
            if text:
                with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                    file.write(text)


def _whole_numbers(name: str, given: Any) -> List[int]:
    listed = [] if given is None else list(given) if isinstance(given, (list, tuple, range)) else [given]
    if given is not None and not listed:
        raise Error(f"{name}={given!r}: that is none; give one or more, or leave {name}= out")
    return [whole(name, one) for one in listed]


def _raise(raised: Any, found: Any, said: str = "what was found until it came is in `found` of this exception") -> None:
    """Raises what ended the work early, with what was found until then."""
    if raised is None:
        return
    if not isinstance(raised, KeyboardInterrupt):
        raise raised
    interrupted = Interrupted(said)
    interrupted.found = found
    raise interrupted from raised


def _figures(command: str, kernel: Any, options: Dict[str, Any], progress: Progress) -> Report:
    with query_files(options["queries"]) as (options["queries"], *of):
        asked = as_kernels(kernel, *of_family(options["families"], *of))
        options["kernels"] = [one.id for one in asked]
        given = run_watched(asked, lambda show: getattr(_core, command)(checked(options), show), progress, command)
    report = Report(given)
    _raise(given[4], report)
    return report


def ladder(kernel: Any = None, *, family: Names = None, trials: Optional[int] = None, seed: int = 1, precision: str = "binary32",
           queries: Any = None, mesh: Names = None, sweep: str = "", speed: bool = True, factorial: bool = False, threads: int = 0,
           progress: Progress = None) -> Report:
    """What each step of the derivation costs: errors, range, time; as `axiscert ladder`.

    >>> figures = ladder(["ladder-0", "published"], family="tangent", trials=64, speed=False)
    >>> figures.name
    'ladder'
    """
    return _figures("ladder", kernel, dict(
        families=names(family, "family"), trials=trials, seed=seed, precision=precision, queries=queries, meshes=names(mesh, "mesh"),
        sweep=sweep, no_speed=not flag("speed", speed), factorial=factorial, threads=threads), progress)


def precision(kernel: Any = None, *, format: Names = None, bits: Union[None, int, Sequence[int]] = None,
              family: Names = None, trials: Optional[int] = None, seed: int = 1, precision: str = "binary32", queries: Any = None,
              mesh: Names = None, sweep: str = "", rounding: str = "nearest", rounding_seeds: Optional[int] = None, fused: str = "none",
              round_inputs: bool = False, threads: int = 0, progress: Progress = None) -> Report:
    """Formulae in formats by name ("bfloat16", "bits=10,emax=31") or of any number of bits; as `axiscert precision`."""
    return _figures("precision", kernel, dict(
        families=names(family, "family"), trials=trials, seed=seed, precision=precision, queries=queries, meshes=names(mesh, "mesh"),
        sweep=sweep, numbers=names(format, "format"), bits=_whole_numbers("bits", bits), rounding=rounding,
        rounding_seeds=rounding_seeds, contraction=fused, round_inputs=round_inputs, threads=threads), progress)


def condition(kernel: Any = None, *, family: Names = None, trials: Optional[int] = None, seed: int = 1, precision: str = "binary32",
              queries: Any = None, mesh: Names = None, sweep: str = "", flips: int = 256, sample: int = 64, threads: int = 0,
              progress: Progress = None) -> Report:
    """Flips of the query's condition apart from those of the formula; as `axiscert condition`."""
    return _figures("condition", kernel, dict(
        families=names(family, "family"), trials=trials, seed=seed, precision=precision, queries=queries, meshes=names(mesh, "mesh"),
        sweep=sweep, flips=flips, sample=sample, threads=threads), progress)


def _one(kernel: Any, predicate: str, entry: str = "") -> Kernel:
    return as_kernel(kernel, predicate, entry)


def diagnose(kernel: Any, *, precision: str = "", seed: int = 1, predicate: str = "", entry: str = "", progress: Progress = None,
             out: Optional[Path] = None) -> Report:
    """What a kernel is like, by its verdicts: open or closed, one-sided, thresholds, order; as `axiscert diagnose`.

    A kernel is as in `judge`; `predicate` and `entry` are those of a function. After Ctrl-C `Interrupted` has the report of what was
    found until then.
    """
    asked = _one(kernel, predicate, entry)
    options, folder = dict(kernel=asked.id, precision=precision, seed=seed), folder_of(out)
    given, complete, witnesses = run_watched([asked], lambda show: _core.diagnose(checked(options), show), progress, "diagnose")
    report = Report(given, complete, witnesses)
    if folder is not None:
        report.save(folder)
    _raise(given[4], report)
    return report


def search(kernel: Any, *, precision: str = "binary32", comparison: Names = None, family: Names = None,
           evaluations: Optional[int] = None, seconds: Optional[float] = None, seed: int = 1, target: str = "auto", threads: int = 0,
           out: Optional[Path] = None, resume: bool = False, predicate: str = "", entry: str = "",
           progress: Progress = None) -> Report:
    """The worst cases of a kernel; as `axiscert search`.

    `out` keeps the state, with which `resume` goes on, after Ctrl-C too: `Interrupted` is raised when the state is written, with the
    report of what was found until then.
    """
    asked = _one(kernel, predicate, entry)
    options = dict(kernel=asked.id, precision=precision, comparisons=names(comparison, "comparison"), families=names(family, "family"),
                   evaluations=evaluations, seconds=seconds, seed=seed, target=target, threads=threads,
                   out=folder_of(out) or "", resume=resume)
    given, complete, witnesses = run_watched([asked], lambda show: _core.search(checked(options), show), progress, "search")
    report = Report(given, complete, witnesses)
    if out is not None:
        report.save(out)
    _raise(given[4], report, "what was found, and the state of the search, are kept" if out is not None else
           "what was found until it came is in `found` of this exception; a search without out= keeps no state to go on from")
    return report


class Shrunk:
    """A query that was made smaller: `query`, the one that it was, `before`, and `json`, what it keeps."""

    def __init__(self, line: str) -> None:
        self.json: Dict[str, Any] = json.loads(line)
        self.line = line
        self._parts: Optional[List[Queries]] = None

    @property
    def query(self) -> Queries:
        with tempfile.TemporaryDirectory(prefix="axiscert-") as folder:
            path = os.path.join(folder, "shrunk.jsonl")
            with open(path, "w", encoding="utf-8") as file:
                file.write(self.line + "\n")
            parts = load_all_queries(path)
        return parts[0]

    def __repr__(self) -> str:
        kept = self.json["keeps"] if "keeps" in self.json else self.json.get("kept", {})
        return f"<{self.json.get('id', '')}: {kept.get('name', '')}, {self.json.get('steps', '')} steps>"


def shrink(query: Any, kernel: Any = None, *, what: str = "", evaluations: int = 1000000, any_class: bool = False,
           precision: str = "binary32", target: str = "auto", progress: Progress = None) -> List[Shrunk]:
    """Smaller queries on which a kernel has the same fault, no less severe; as `axiscert shrink`.

    `query` is Queries, an address, a file, or a list of addresses and files. Queries that show nothing to keep are left out, with a
    `Notice`; where it is the only one, `Error` says why. After Ctrl-C `Interrupted` has those that were done, and the last as far as it
    was.
    """
    with query_files(query) as (given, predicate, entry):
        if not given:
            raise Error("no query is given to shrink: give Queries, an address or a file")
        for address in given:
            if address.count(":") == 5:
                predicate, entry = of_family([address.split(":")[1]], "", "")
        asked = as_kernels(kernel, predicate, entry)
        options = dict(queries=given, kernels=[one.id for one in asked], what=what, evaluations=evaluations, any_class=any_class,
                       precision=precision, target=target)
        lines, nothing, raised = run_watched(asked, lambda show: _core.shrink(checked(options), show), progress, "shrink")
    for line in nothing:
        warnings.warn(line, Notice, stacklevel=2)
    found = [Shrunk(line) for line in lines]
    _raise(raised, found)
    return found


class Comparison(Report):
    """Two runs compared: `passes` where nothing is new or worse; `markdown` for a pull request."""

    def __init__(self, given: Any, passes: bool, markdown: str) -> None:
        super().__init__(given)
        self.passes, self.markdown = passes, markdown


def compare(before: Union[Record, Path], after: Union[Record, Path], *, allow_not_compared: Names = None, replay: bool = True,
            progress: Progress = None) -> Comparison:
    """Compares two runs, records or folders: what is new, worse, better, fixed; as `axiscert compare`."""
    with tempfile.TemporaryDirectory(prefix="axiscert-") as folder:
        paths = []
        for name, run in (("before", before), ("after", after)):
            if isinstance(run, Record):
                paths.append(os.path.join(folder, name))
                run.save(paths[-1])
            else:
                paths.append(folder_of("" if run is None else run, name) or "")
        given, passes, markdown = run_watched(
            [], lambda show: _core.compare(paths[0], paths[1], names(allow_not_compared), flag("replay", replay), show), progress, "compare")
    found = Comparison(given, passes, markdown)
    _raise(given[4], found)
    return found


def certify(kernel: Any, out: Path, *, effort: str = "quick", seed: int = 1, mesh: Names = None, seconds: Optional[float] = None,
            key: Optional[Path] = None, threads: int = 0, resume: bool = False) -> Dict[str, Any]:
    """A certificate of a kernel, in the folder `out`; as `axiscert certify`, which does it in a process of its own.

    A certificate states the SHA-256 of files, by which others check it: a function is certified by its file, in a process of its own
    (`axiscert.kernel`, `supervised`), which finds it there by its name. Ctrl-C ends it, and `resume` goes on. Returns certificate.json.
    """
    require_no_load("certify")
    asked, folder = _one(kernel, ""), folder_of("" if out is None else out) or ""
    if asked._again is not None:
        try:
            asked = asked._again()
        except Error as why:
            raise Error(f"certify: a certificate states the SHA-256 of the files of a kernel, and of {asked.id} there are none: "
                        f"{why}") from None
    asked.require_newest()
    words = [os.path.join(_BIN, "axiscert"), "certify", asked.id, "--out", folder, "--effort", text("effort", effort), "--seed",
             str(whole("seed", seed, greatest=2**64 - 1))]
    for one in names(mesh, "mesh"):
        words += ["--mesh", one]
    if seconds is not None:
        words += ["--time", str(above_zero("seconds", seconds))]
    if key is not None:
        words += ["--key", path("key", key)]
    if whole("threads", threads, greatest=4096):
        words += ["--threads", str(threads)]
    if flag("resume", resume):
        words.append("--resume")
    try:
        ended = subprocess.run(words, capture_output=True, text=True)
    except FileNotFoundError:
        raise Error(f"certify: the command is not beside the package: {words[0]}; the Debian package axiscert has it, and `./dev build "
                    "python axiscert` builds it") from None
    made = os.path.join(folder, "certificate.json")
    if ended.returncode not in (0, 1) or not os.path.exists(made):
        lines = [line.removeprefix("axiscert: ") for line in ended.stderr.strip().split("\n") if line]
        if ended.returncode < 0:
            lines.append(f"the command was ended by signal {-ended.returncode}")
        raise Error("certify: " + "; ".join(lines))
    with open(made, encoding="utf-8") as file:
        certificate: Dict[str, Any] = json.load(file)
    return certificate
