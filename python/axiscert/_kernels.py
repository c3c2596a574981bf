"""Functions as kernels: in this process, or in a supervised one of its own."""
from __future__ import annotations

import functools
import hashlib
import inspect
import json
import numbers
import os
import re
import sys
import threading
import types
import weakref
from typing import Any, Callable, Dict, Iterable, List, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._errors import Error, KernelRaised, flag, real, text, whole
from ._queries import Queries, describe, entry_of

_newest: "weakref.WeakValueDictionary[str, Kernel]" = weakref.WeakValueDictionary()  # the library finds a function by its name
_naming = threading.Lock()
_SERVE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "serve.py")


class Kernel:
    """A function that is judged, as `kernel` makes it. It stands wherever a kernel's id does.

    `id` is its name in records; `seconds` and `calls` say how long the function itself has taken, of all threads together,
    and how often it was called (in this process alone). `code` is a digest of a function's code, and of the functions of its
    module, numbers, texts and arrays that it names; not of other modules and of objects.
    """

    def __init__(self, id: str, core: Any = None, function: Any = None, tensors: Any = None) -> None:
        self.id, self._core, self._function, self._tensors = id, core, function, tensors
        self._raised: Any = None  # (exception or None, numbers of the batch, message), by the library
        if core is not None:
            _newest[id] = self
            # The library keeps a kernel for ever, and finds the function by this, which the function may refer to.
            core.hold(weakref.ref(self))
            weakref.finalize(self, core.release)

    @property
    def seconds(self) -> float:
        return float(self._core.seconds) if self._core is not None else float("nan")

    @property
    def code(self) -> str:
        return _code(self._function) if self._function is not None else ""

    @property
    def calls(self) -> int:
        return int(self._core.calls) if self._core is not None else 0

    def require_newest(self) -> None:
        """Raises where another function has its name since, here or, of a supervised one, in its file."""
        if self._core is None and self._function is not None:
            _where(self._function, self)
        if self._core is not None and _newest.get(self.id) is not self:
            raise Error(f"kernel {self.id}: another function has been given that name since; axiscert.kernel(f, name=...) gives another")

    def raise_kept(self, cause: Optional[BaseException] = None) -> None:
        """Raises what the function has raised, if it has."""
        raised, self._raised = self._raised, None
        if raised is None:
            return
        original, numbers, message = raised
        if original is not None and not isinstance(original, Exception):
            raise original  # KeyboardInterrupt, SystemExit
        error = KernelRaised(message)
        error.queries = Queries(self._predicate[0], numbers, self._predicate[1])
        raise error from original

    _predicate: Tuple[str, str] = ("", "")
    _again: Optional[Callable[[], Any]] = None  # makes the same, supervised

    def __repr__(self) -> str:
        return f"<kernel {self.id}>"


def _measure_count(described: Dict[str, Any], measures: Union[int, str, Sequence[str]]) -> int:
    if isinstance(measures, numbers.Integral):
        return whole("measures", measures)
    names: List[str] = [measure["name"] for measure in described["measures"]]
    if not isinstance(measures, Iterable):
        raise Error(f"measures={measures!r}: give \"all\", names or how many; there are: {', '.join(names) or 'none'}")
    if measures == "all":
        return len(names)
    count = 0
    for asked in [measures] if isinstance(measures, str) else measures:
        if asked in names:
            count = max(count, names.index(asked) + 1)
        elif f"{asked}_x" in names:
            count = max(count, names.index(f"{asked}_x") + 3)
        else:
            raise Error(f"there is no measure '{asked}' in {described['id']}; there are: {', '.join(names) or 'none'}")
    return count


def _where(function: Callable[..., Any], used: Optional[Kernel] = None) -> str:
    """"file:name", by which another process finds the function. While a decorator makes its kernel, the name has another value yet,
    or none; when the kernel is used it has this one."""
    code = inspect.unwrap(function)
    name, module = getattr(code, "__qualname__", ""), sys.modules.get(getattr(code, "__module__", ""))
    file = getattr(module, "__file__", None)
    if not re.fullmatch(r"[A-Za-z_][\w.]*", name) or file is None or not os.path.exists(file):
        raise Error(f"supervised: another process has to find the function '{name or function!r}' by its name in a file; put it at "
                    "the top of a module")
    found: Any = module
    for part in name.split("."):
        found = getattr(found, part, None)
    if isinstance(found, Kernel):
        is_it = used is None or found._function is function
    else:
        is_it = found is function or isinstance(function, types.MethodType) and type(found) is type(function) and found == function \
            or found is None and used is None
    if not is_it:
        what = "it is a method of an object there" if isinstance(function, types.MethodType) else "that name has another value there"
        raise Error(f"supervised: another process has to find the function '{name}' by its name in {file}, and {what}; put a function "
                    "of one name at the top of a module")
    return f"{os.path.abspath(file)}:{name}"


def _code(function: Any) -> str:
    """The digest of `Kernel.code`."""
    kept: Dict[int, Any] = {}  # once each, by their ids

    def told(value: Any) -> Any:
        if value is None or isinstance(value, (bool, int, float, complex, str, bytes, np.generic)):
            return repr(value)
        if isinstance(value, frozenset):
            return sorted(map(repr, value))
        if isinstance(value, np.ndarray):
            return [str(value.dtype), value.shape, hashlib.sha256(value.tobytes()).hexdigest()]
        if isinstance(value, types.CodeType):
            return [value.co_code.hex(), value.co_names, told(value.co_consts)]
        if id(value) in kept:
            return "again"
        kept[id(value)] = value
        if isinstance(value, (list, tuple)):
            return [told(one) for one in value]
        if isinstance(value, dict):
            return {str(name): told(one) for name, one in value.items()}
        if isinstance(value, functools.partial):
            return told([value.func, value.args, value.keywords])
        if isinstance(value, types.MethodType):
            return told(value.__func__)
        value = inspect.unwrap(value) if callable(value) else value
        if isinstance(value, types.FunctionType) and value.__module__ == module:
            try:
                named = inspect.getclosurevars(value)
            except ValueError:  # a name of the enclosing function that has no value yet
                used = {name: value.__globals__[name] for name in value.__code__.co_names if name in value.__globals__}
                return told([value.__code__, value.__defaults__, value.__kwdefaults__, used])
            return told([value.__code__, value.__defaults__, value.__kwdefaults__, named.globals, named.nonlocals])
        return getattr(value, "__qualname__", type(value).__qualname__)

    base = inspect.unwrap(function.func if isinstance(function, functools.partial) else function)
    if not isinstance(base, (types.FunctionType, types.MethodType)):
        function = base = type(base).__call__
    module = getattr(base, "__module__", None)
    return hashlib.sha256(json.dumps(told(function)).encode()).hexdigest()


def kernel(function: Optional[Callable[..., Any]] = None, *, name: str = "", predicate: str = "", entry: str = "",
           precisions: Sequence[str] = ("binary32", "binary64"), layout: str = "groups",
           tensors: Optional[Callable[[Any], Any]] = None, formulae: str = "", conforms_to: str = "",
           measures: Union[int, str, Sequence[str]] = 0, touching: str = "contact", sides: str = "both", margin: float = 0.0,
           may_decline: bool = False, on_error: str = "raise", supervised: bool = False) -> Any:
    """A function as a kernel; a decorator too.

    The function is asked about a batch of queries at a time, and must answer each by its own numbers alone.

    It takes, with layout "groups", an argument for each group of columns of the entry (`describe`), shape (n, size), or (n,)
    where the group has one column: of sphere-triangle a, b, c, p, each (n, 3), and r, (n,). With layout "columns" it takes one
    array, shape (columns, n). They are float32 or float64, as `precisions` says, read-only, and its own to keep. `tensors`, such
    as `torch.from_dlpack`, is applied to each array first; those can be written.

    It returns an array of shape (n,), or what has `__array__` or `__dlpack__`, on the CPU: bool, True for contact; or uint8,
    0 contact, 1 separated, 2 undecided (with `may_decline`), 3 invalid; or, with `formulae` or `conforms_to` a built-in kernel,
    comparison bits, uint32 or uint64. With `measures`, "all" or names of the predicate's, it returns a dictionary: "verdict", and
    each measure by its name, shape (n,), or a vector, as "normal", shape (n, 3).

    `touching` ("contact", "separated", "either"), `sides`, `margin` and `may_decline` say what it promises, as for a plug-in
    (docs/plugins.md). What the function raises is raised as `KernelRaised`; with `on_error` "record" it is a finding, and the
    query that it raises for has no answer. `supervised`: it runs in a process of its own, which finds it by its name in its file,
    and is told how by a manifest in ~/.cache/axiscert/functions; a crash, a hang and answers that change are findings of the record.

    >>> import numpy as np
    >>> @kernel(name="centre-only")
    ... def centre_only(a, b, c, p, r):
    ...     return np.linalg.norm(a - p, axis=1) <= r
    >>> centre_only
    <kernel centre-only>
    """
    options = dict(locals())
    del options["function"]
    if function is None:
        return lambda given: kernel(given, **options)
    if isinstance(function, Kernel):
        raise Error(f"{function!r} is a kernel already, and was given its options when it was made of its function")
    if not callable(function):
        raise Error(f"a kernel is a function, or an id as a text, not {type(function).__name__}")
    if layout not in ("groups", "columns"):
        raise Error(f"layout='{layout}': there are: groups, columns")
    if on_error not in ("raise", "record"):
        raise Error(f"on_error='{on_error}': there are: raise, record")
    if touching not in ("contact", "separated", "either"):
        raise Error(f"touching='{touching}': there are: contact, separated, either")
    if sides not in ("both", "front"):
        raise Error(f"sides='{sides}': there are: both, front")
    if tensors is not None and not callable(tensors):
        raise Error(f"tensors={tensors!r}: give a function of an array, as torch.from_dlpack")
    if not 0 <= real(margin) < float("inf"):
        raise Error(f"margin={margin!r}: give a number from 0, in the unit of the queries")
    listed = [precisions] if isinstance(precisions, str) else precisions
    if not isinstance(listed, Iterable) or not (known := list(listed)):
        raise Error(f"precisions={precisions!r}: give \"binary32\", \"binary64\" or both")
    of, described = entry_of(predicate, entry), describe(predicate)
    id = text("name", name) or re.sub(r"[^A-Za-z0-9._-]+", "-", getattr(function, "__name__", type(function).__name__)).strip("-") or "function"
    if not re.fullmatch(r"[A-Za-z0-9._-]{1,100}", id):
        raise Error(f"name={id!r}: give 1 to 100 letters, digits, '-', '_', '.'")
    has_bits, count = bool(formulae or conforms_to), _measure_count(described, measures)
    flag("may_decline", may_decline)
    if flag("supervised", supervised):
        if tensors is not None:
            raise Error("supervised: the function converts arrays itself; tensors= is for this process")
        return _program(function, id, of, known, layout, dict(
            conforms_to=conforms_to, formulae=formulae, touching=touching, sides=sides, may_decline=may_decline, measures=count),
            real(margin), described["is_of_motions"])
    claims = dict(
        id=id, predicate=of["predicate"], entry=of["name"], precisions=known, bits=has_bits, measures=count,
        touching=touching, sides=sides, margin=real(margin), may_decline=may_decline, conforms_to=conforms_to, formulae=formulae)
    with _naming:
        made = Kernel(id, _core.Callable(layout, on_error == "record", claims), function, tensors)
    made._predicate = of["predicate"], of["name"]
    made._again = lambda: kernel(function, **dict(options, supervised=True))
    return made


def _program(function: Callable[..., Any], id: str, of: Dict[str, Any], precisions: List[str], layout: str,
             claims: Dict[str, Any], margin: float, is_of_motions: bool) -> Kernel:
    where = _where(function)
    manifest: Dict[str, Any] = {
        "format": "axiscert-program/2", "name": id, "summary": "a function of Python",
        "command": [sys.executable, _SERVE, where, json.dumps(of["groups"] if layout == "groups" else None),
                    json.dumps([measure["name"] for measure in describe(of["predicate"])["measures"]][:claims["measures"]]),
                    json.dumps(of["predicate"] if claims["conforms_to"] or claims["formulae"] else None), json.dumps(sys.path)],
        "precisions": precisions, "predicate": of["predicate"], "entry": of["name"], "touching": claims["touching"],
        "files": [where.rsplit(":", 1)[0]],
    }
    for member in ("conforms_to", "formulae"):
        if claims[member]:
            manifest[member], manifest["exposes"] = claims[member], "comparisons"
    if claims["measures"]:
        manifest["measures"] = claims["measures"]
    if claims["may_decline"]:
        manifest["may_decline"] = True
    if margin:
        manifest["limits"] = {"margin": margin}
    if claims["sides"] != "both":
        if is_of_motions:
            manifest["motion"] = {"sides": claims["sides"]}
        else:
            manifest["sides"] = claims["sides"]
    # A place that is its own: the same function has the same id again, and a certificate's manifest stays.
    text = json.dumps(manifest, indent=1)
    cache = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    folder = os.path.join(cache, "axiscert", "functions", hashlib.sha256(text.encode()).hexdigest()[:16])
    path = os.path.join(folder, f"{id}.json")
    if not os.path.exists(path):
        try:
            os.makedirs(folder, exist_ok=True)
            written = f"{path}.{os.getpid()}"
            with open(written, "w", encoding="utf-8") as file:
                file.write(text)
            os.replace(written, path)
        except OSError as why:
            raise Error(f"supervised: {path} cannot be written: {why.strerror}; XDG_CACHE_HOME names another folder") from None
    return Kernel(f"program:{path}", function=function)


def as_kernels(given: Any, predicate: str, entry: str) -> List[Kernel]:
    """Kernels of one, or of several; of None, none."""
    several = [] if given is None else [given] if isinstance(given, (str, Kernel)) or callable(given) else given
    if not isinstance(several, Iterable):
        raise Error(f"a kernel is a function, or an id as a text, or several of these, not {type(given).__name__}")
    made = [as_kernel(one, predicate, entry) for one in several]
    if given is not None and not made:
        raise Error(f"no kernel is given: {given!r}")
    return made


def as_kernel(given: Any, predicate: str, entry: str) -> Kernel:
    """A kernel of an id, a function or a Kernel."""
    if isinstance(given, Kernel):
        return given
    if isinstance(given, str):
        return Kernel(given)
    if not callable(given):
        raise Error(f"a kernel is a function, or an id as a text, not {type(given).__name__}")
    made: Kernel = kernel(given, predicate=predicate, entry=entry)
    return made
