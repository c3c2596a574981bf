"""Kernels judged on queries, as `axiscert run` judges them, and the record of it."""
from __future__ import annotations

import contextlib
import html
import json
import os
import reprlib
import sys
import tempfile
from typing import Any, Callable, Dict, Iterable, Iterator, List, NamedTuple, Optional, Sequence, Tuple, Union

from . import _core
from ._errors import Error, Interrupted, above_zero, checked, flag, path
from ._kernels import Kernel, as_kernels
from ._queries import Queries, query_at, show_notices

Names = Union[None, str, Iterable[str]]
Path = Union[str, "os.PathLike[str]"]
Progress = Union[None, bool, Callable[[int, int, int, float, str], Any]]


def names(given: Any, option: str = "") -> List[str]:
    """A name, or several, as a list; where the option is named, not none of them: without it, all would be asked."""
    if given is None or isinstance(given, str) and not given and not option:
        return []
    try:
        listed = [os.fsdecode(one) for one in ([given] if isinstance(given, (str, bytes, os.PathLike)) else given)]
    except TypeError:
        raise Error(f"{reprlib.repr(given)}: give a name or a path, as a text, or several") from None
    if option and not any(listed):
        raise Error(f"{option}={given!r}: that is none; give one or more, or leave {option}= out")
    return listed


def folder_of(out: Any, name: str = "out") -> Optional[str]:
    """A folder that is given, as a text."""
    if out is None:
        return None
    given = names(out) if isinstance(out, (str, bytes, os.PathLike)) else []
    if not given:
        raise Error(f"{name}={reprlib.repr(out)}: give the path of a folder")
    return given[0]


def _known(join: Callable[[Any], Any], verdicts: List[Dict[str, Any]], member: str) -> Any:
    """The sum or maximum over families of what is None where nothing was looked at; None where it is in each."""
    known = [one[member] for one in verdicts if one[member] is not None]
    return join(known) if known else None


@contextlib.contextmanager
def query_files(queries: Any) -> Iterator[Tuple[List[str], str, str]]:
    """The paths of files of queries, and of ones that Queries are written to meanwhile; and the predicate and entry of these."""
    several: List[Any] = list(queries) if isinstance(queries, (list, tuple)) else [] if queries is None else [queries]
    if not several and queries is not None:
        raise Error(f"queries={queries!r}: that is none; give one or more, or leave queries= out")
    paths: List[str] = []
    predicate = entry = ""
    with tempfile.TemporaryDirectory(prefix="axiscert-") as folder:
        for part in several:
            if hasattr(part, "dtype"):
                raise Error(f"the queries are an array of shape {part.shape}; Queries.of makes queries of arrays")
            if isinstance(part, Queries):
                if not len(part):
                    raise Error(f"the queries are {part!r}; give one or more")
                predicate, entry = predicate or part.predicate, entry or part.entry
                paths.append(os.path.join(folder, f"queries-{len(paths) + 1}.jsonl" if paths else "queries.jsonl"))
                part.save(paths[-1])
            else:
                paths += names(part, "queries")
        yield paths, predicate, entry


class _Bar:
    """A progress bar of tqdm."""

    def __init__(self, what: str) -> None:
        from tqdm.auto import tqdm

        self._bar = tqdm(desc=what, unit=" queries", unit_scale=True, leave=False)

    def __call__(self, units_done: int, units: int, queries: int, seconds: float, stage: str) -> None:
        if queries > self._bar.n:
            self._bar.update(queries - self._bar.n)
        self._bar.set_postfix_str(stage or (f"{units_done} of {units} units" if units else ""), refresh=False)

    def close(self) -> None:
        self._bar.close()


def shower(progress: Progress, what: str) -> Any:
    """What is called with the progress: a bar of tqdm where that is there, and somebody to see it."""
    if callable(progress):
        return progress
    if progress not in (None, True, False):
        raise Error(f"progress={progress!r}: give True, False, or a function of (units done, units, queries, seconds, stage)")
    if progress is None:
        progress = sys.stderr is not None and sys.stderr.isatty()
    if not progress:
        return None
    try:
        return _Bar(what)
    except ImportError:
        return None


class Outcome:
    """What came of a level of `require` for a kernel in a precision: `state` is "met", "not met" or "NOT CHECKED"."""

    def __init__(self, text: str) -> None:
        self.json: Dict[str, Any] = json.loads(text)
        self.kernel: str = self.json["kernel"]
        self.precision: Optional[str] = self.json["precision"]
        self.state: str = self.json["state"]
        self.text: str = self.json["text"]

    @property
    def passes(self) -> bool:
        return self.state == "met" or bool(self.json["allowed"])

    def __repr__(self) -> str:
        return f"<{self.text}>"


class Record:
    """The record of a run. `json` has it as docs/data.md says, `bytes` as record.json has it: the same as the command's for the
    same plan. `complete` is false of one that was interrupted."""

    def __init__(self, judged: Any, kernels: Sequence[Kernel]) -> None:
        self._judged, self._kernels = judged, list(kernels)
        self.bytes: bytes = judged.record()
        self.json: Dict[str, Any] = json.loads(self.bytes)
        self.complete: bool = judged.complete
        self.outcomes = [Outcome(text) for text in judged.outcomes()]
        self._folder: Optional["tempfile.TemporaryDirectory[str]"] = None

    def __reduce__(self) -> Any:
        return Record, (self._judged, [])  # functions stay where they are

    @property
    def met(self) -> bool:
        """Whether every level of `require` is met, or was allowed to stay unchecked. Raises `Error` where none was required."""
        if not self.outcomes:
            raise Error('no level was required; judge(..., require="logic") requires one')
        return all(outcome.passes for outcome in self.outcomes)

    @property
    def run(self) -> Dict[str, Any]:
        """What run.json has: when and on what it ran, and how long."""
        run: Dict[str, Any] = json.loads(self._judged.run())
        return run

    @property
    def witnesses(self) -> List[Dict[str, Any]]:
        """Queries that show a wrong answer or an extreme, as the record has them: `address`, `kind`, `kernel` and so on."""
        return list(self.json["witnesses"])

    def witness_queries(self) -> List[Queries]:
        """The queries of the witnesses that have an address of a family, each by itself."""
        families = {known["name"] for known in _core.families("")}
        addresses = [witness.get("address") or "" for witness in self.witnesses]
        return [query_at(address) for address in addresses if address and address.split(":")[1] in families]

    def rows(self) -> List[Dict[str, Any]]:
        """A row for each kernel, precision and family, with every count under its path: "verdict.false_contact"."""
        rows = []
        for kernel in self.json["kernels"]:
            for family, counts in kernel["families"].items():
                row: Dict[str, Any] = {"kernel": kernel["kernel"] if "kernel" in kernel else kernel["id"],
                                       "precision": kernel["precision"], "family": family}
                _flatten(counts, "", row)
                rows.append(row)
        return rows

    def to_pandas(self) -> Any:
        """A DataFrame of `rows`."""
        import pandas

        return pandas.DataFrame(self.rows())

    def save(self, folder: Path) -> None:
        """Writes the run's folder: record.json, run.json, and the reports, as `axiscert run --out` does."""
        self._judged.save(path("folder", folder))

    def report(self, folder: Optional[Path] = None) -> str:
        """Writes the reports and returns the path of report.html; without a folder, into one that goes with the record."""
        if folder is None:
            if self._folder is None:
                self._folder = tempfile.TemporaryDirectory(prefix="axiscert-")
            folder = self._folder.name
        self.save(folder)
        return os.path.join(os.fspath(folder), "report.html")

    def summary(self) -> List[Dict[str, Any]]:
        """Of each kernel and precision the sums over its families: `trials`; `decided`, those that it promises and has called
        contact or separated; `missed` and `phantom` contacts; and `deepest`, the greatest depth of these, as a share of the scene.
        `missed` is None where no contact was decided, `phantom` where no separation, `deepest` where neither, or the predicate has
        no depth."""
        sums = []
        for kernel, decided in zip(self.json["kernels"], self._judged.decided()):
            families = list(kernel["families"].values())
            verdicts = [counts["verdict"] for counts in families]
            missed, phantom = (_known(sum, verdicts, kind) for kind in ("false_separation", "false_contact"))
            has_depth = all(one["depths"] is not None for one in verdicts)
            sums.append({"kernel": kernel["id"], "precision": kernel["precision"], "trials": sum(counts["trials"] for counts in families),
                         "decided": decided, "missed": missed, "phantom": phantom,
                         "deepest": _known(max, verdicts, "deepest") if has_depth else None})
        return sums

    def __repr__(self) -> str:
        lines = []
        for one in self.summary():
            missed = "no contact decided" if one["missed"] is None else f"{one['missed']:,} missed"
            phantom = "no separation decided" if one["phantom"] is None else f"{one['phantom']:,} phantom contacts"
            said = f"{missed} and {phantom}" if one["decided"] else "nothing was decided"
            if 0 < one["decided"] < one["trials"]:
                said += f" among {one['decided']:,} that it promises and decided"
            lines.append(f"{one['kernel']} {one['precision']}: {one['trials']:,} queries, {said}")
        lines += [outcome.text for outcome in self.outcomes]
        lines += [f"{finding['kernel']}: {finding['kind']}: {finding['detail']}" for finding in self.json["findings"]]
        return "\n".join(lines or ["no kernel could be judged"]) + ("" if self.complete else "\ninterrupted")

    def _repr_html_(self) -> str:
        head = ("kernel", "precision", "queries", "decided", "missed contacts", "phantom contacts", "deepest")
        rows = [[one["kernel"], one["precision"], f"{one['trials']:,}", f"{one['decided']:,}" if one["decided"] else "nothing",
                 *("not known" if one[key] is None else f"{one[key]:,}" for key in ("missed", "phantom")),
                 "-" if one["deepest"] is None else f"{one['deepest']:.3g}"] for one in self.summary()]
        cells = "".join("<tr>" + "".join(f"<td>{html.escape(str(cell))}</td>" for cell in row) + "</tr>" for row in rows)
        said = [outcome.text for outcome in self.outcomes] + [
            f"{finding['kernel']}: {finding['kind']}: {finding['detail']}" for finding in self.json["findings"]]
        return ("<table><tr>" + "".join(f"<th>{name}</th>" for name in head) + f"</tr>{cells}</table>" +
                "".join(f"<p>{html.escape(line)}</p>" for line in said) + ("" if self.complete else "<p>interrupted</p>"))


def _flatten(value: Any, path: str, into: Dict[str, Any]) -> None:
    if isinstance(value, dict):
        for name, inner in value.items():
            _flatten(inner, f"{path}.{name}" if path else name, into)
    elif not isinstance(value, list):
        into[path] = value


def of_family(family: List[str], predicate: str, entry: str) -> Tuple[str, str]:
    """The predicate and entry of functions that are judged on families."""
    for name in family:
        for known in _core.families(""):
            if known["name"] == name:
                is_of = predicate in ("", known["predicate"])
                return predicate or known["predicate"], entry or (known["entry"] if is_of else "")
    return predicate, entry


class _Shown(NamedTuple):
    """What the library is given beside options: whom it tells, and the functions that a second Ctrl-C lets fail."""

    progress: Any
    callables: List[Any]


def require_no_load(what: str) -> None:
    """Refuses what a script does while the process of its own supervised function loads it: it would begin itself again."""
    script = getattr(sys.modules.get("__main__"), "AXISCERT_LOADS", None)
    if script is not None:
        raise Error(f"{what} begins when {script} is loaded, as the process of a supervised function does: put what is to run once under "
                    "if __name__ == \"__main__\":")


def run_watched(kernels: Sequence[Kernel], work: Callable[[Any], Any], progress: Progress, what: str,
                plugin_seconds: Optional[float] = None) -> Any:
    """Calls work(progress), and raises what a kernel's function has raised."""
    require_no_load(what)
    show = shower(progress, what)

    def require_newest() -> None:
        for kernel in kernels:
            kernel.require_newest()

    require_newest()
    for kernel in kernels:
        kernel._raised = None
    seconds_before = None if plugin_seconds is None else _core.set_plugin_seconds(plugin_seconds)
    try:
        made = work(_Shown(show, [kernel._core for kernel in kernels if kernel._core is not None]))
        require_newest()  # no thread has taken a name meanwhile
        return made
    except BaseException as error:
        for kernel in kernels:
            kernel.raise_kept(error)
        raise
    finally:
        if seconds_before is not None:
            _core.set_plugin_seconds(seconds_before)
        if isinstance(show, _Bar):
            show.close()
        show_notices()


def judge(kernel: Any, *, family: Names = None, trials: Optional[int] = None, seed: int = 1, precision: str = "",
          require: Names = None, allow_unchecked: Names = None, unit: str = "", predicate: str = "", entry: str = "",
          queries: Any = None, mesh: Names = None, corpus: Union[None, bool, str] = None, preset: str = "", tolerance: Names = None,
          seconds: Optional[float] = None, target: str = "auto", threads: int = 0, exact_only: bool = False, source: Names = None,
          plugin_seconds: Optional[float] = None, progress: Progress = None, out: Optional[Path] = None,
          resume: bool = False) -> Record:
    """Judges a kernel, or several, on the same queries, beside exact arithmetic.

    A kernel is an id, as `axiscert run --kernel` takes it ("published", "plugin:./mine.so"), a function, or what
    `axiscert.kernel` makes of one. All other arguments are the options of `axiscert run` of the same names. `queries` are files, or
    Queries. Without a family, mesh or file all families of the predicate are asked; empty lists of them are refused. `progress` is True for a bar (default: where
    standard error is a terminal), or a function of (units done, units, queries, seconds, stage). `out` is a folder for the reports.
    Unless `seconds` limits the run, the folder keeps what is done too: after Ctrl-C, an exception or a kill the same call with
    `resume` does the rest, and the record is the same. It refuses what was another plan, or a function of other code
    (`axiscert.Kernel.code`).

    Returns a `Record`. Raises `Error` for what cannot be judged, `KernelRaised` where a function raises, and after Ctrl-C
    `Interrupted`, which has the record of what was done; a second Ctrl-C gives that up.

    >>> record = judge("certified", family="tangent", trials=1000, require="exact")
    >>> record.met
    True
    """
    families, folder_out = names(family, "family"), folder_of(out)
    if flag("resume", resume) and out is None:
        raise Error("resume=True goes on from what out= keeps; give the folder of the run that ended early")
    if resume and seconds is not None:
        raise Error(f"resume=True with seconds={seconds}: a run with a time limit keeps nothing to go on from; give trials=")
    with query_files(queries) as (paths, predicate_given, entry_given):
        predicate_of, entry_of_ = of_family(families, predicate or predicate_given, entry or entry_given)
        kernels = as_kernels(kernel, predicate_of, entry_of_)
        ids = [one.id for one in kernels]
        if not ids:
            raise Error("no kernel is given to judge")
        if len(set(ids)) != len(ids):
            raise Error(f"two kernels have the name '{next(id for id in ids if ids.count(id) > 1)}'; axiscert.kernel(f, name=...) gives "
                        "another")
        options = dict(
            kernels=ids, predicate=predicate or predicate_given, families=families, meshes=names(mesh, "mesh"), queries=paths,
            corpus=None if corpus is None or corpus is False else default_corpus() if corpus is True else corpus, trials=trials,
            seed=seed, seconds=seconds, precision=precision, preset=preset, tolerances=names(tolerance), require=names(require),
            allow_unchecked=names(allow_unchecked), unit=unit, sources=names(source), target=target, exact_only=exact_only,
            threads=threads, out=folder_out, resume=flag("resume", resume),
            code=json.dumps({one.id: one.code for one in kernels}))
        if plugin_seconds is not None:
            plugin_seconds = above_zero("plugin_seconds", plugin_seconds)
        judged, raised = run_watched(kernels, lambda show: _core.judge(checked(options), show), progress, "judging", plugin_seconds)
    record = Record(judged, kernels)
    if folder_out is not None:
        record.save(folder_out)
        journal = os.path.join(folder_out, "journal")
        if record.complete and os.path.exists(journal):
            os.remove(journal)
    if raised is not None:
        if not isinstance(raised, KeyboardInterrupt):
            raise raised
        rest = "" if out is None or seconds is not None else f"; judge(..., out={folder_out!r}, resume=True) does the rest"
        interrupted = Interrupted("all was done when it came: the record is whole" if record.complete else
                                  "the record has the units of queries that were done" + rest)
        interrupted.record = record
        raise interrupted from raised
    return record


def default_corpus() -> str:
    return str(_core.default_corpus_folder())
