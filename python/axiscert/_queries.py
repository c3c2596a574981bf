"""Queries as arrays: of families, meshes, files and addresses."""
from __future__ import annotations

import os
import warnings
from typing import Any, Dict, Iterable, Iterator, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._errors import Error, Notice, path as path_of, text, whole

DTYPES = {"binary32": np.float32, "binary64": np.float64}
_PRECISIONS = {np.dtype(np.float32): "binary32", np.dtype(np.float64): "binary64"}


def show_notices() -> None:
    """Warns of what the library has said since the last call."""
    for line in _core.take_notices():
        warnings.warn(line, Notice, stacklevel=3)


def predicates() -> List[str]:
    """The ids of the predicates: the questions that axiscert judges.

    >>> predicates()[:2]
    ['sphere-triangle', 'moving-sphere']
    """
    return list(_core.predicates())


def describe(predicate: str = "") -> Dict[str, Any]:
    """What a predicate asks and answers: `entries` with their `columns` and `groups`, `comparisons`, `measures`.

    >>> describe("sphere-triangle")["entries"][0]["columns"]
    ['ax', 'ay', 'az', 'bx', 'by', 'bz', 'cx', 'cy', 'cz', 'px', 'py', 'pz', 'r']
    """
    return dict(_core.predicate(text("predicate", predicate)))


def entry_of(predicate: str, entry: str = "") -> Dict[str, Any]:
    """The description of an entry: a form in which the numbers of a query are given; the first where none is named."""
    described = describe(predicate)
    name = _core.entry_of(predicate, text("entry", entry))[1]
    return next(dict(one, predicate=described["id"]) for one in described["entries"] if one["name"] == name)


def families(predicate: str = "") -> List[Dict[str, Any]]:
    """The families of a predicate, or of all: `name`, `purpose`, `entry`, `version`, `is_scene`.

    >>> [family["name"] for family in families("sphere-triangle")][:3]
    ['general', 'tangent', 'seam']
    """
    return list(_core.families(text("predicate", predicate)))


def kernels(predicate: str = "") -> List[Dict[str, Any]]:
    """The built-in kernels of a predicate, or of all: `id`, `summary`, `formulae`, `exposes`."""
    return list(_core.kernels(text("predicate", predicate)))


def attribute(group: str) -> str:
    """The name of a group of columns as Python has it: `a.m` is `a_m`."""
    return group.replace(".", "_")


def _plain(given: Any) -> "np.ndarray[Any, Any]":
    if isinstance(given, np.ma.MaskedArray):
        raise Error("the numbers of queries are a masked array; give those that are not masked, as a plain one")
    return np.asarray(given)


def is_wide(given: Any) -> bool:
    """Whether an array, a scalar of NumPy, a tensor, or a list with one of these, is of float64 in any order of bytes."""
    if isinstance(given, (list, tuple)):
        return any(map(is_wide, given))
    dtype = getattr(given, "dtype", None)
    if dtype is None:
        dtype = None if isinstance(given, (int, float, str)) else np.asarray(given).dtype  # of a buffer
    if isinstance(dtype, np.dtype):
        return bool(dtype.newbyteorder("=") == np.float64)
    return str(dtype).endswith(".float64")


def exactly(name: str, given: Any, dtype: Any = None, wider: str = "precision=\"binary64\"") -> "np.ndarray[Any, Any]":
    """The numbers in a type, or in float64 where they are not of float32, native and aligned; Error for those of another type that it
    would round. What Python writes as a float has no type: it is rounded to this one."""
    try:
        value = _plain(given)
        right = np.dtype(dtype or (np.float32 if value.dtype.newbyteorder("=") == np.float32 else np.float64))
        if value.dtype.kind not in "biufO" or value.dtype.kind == "O" and any(one is None for one in value.flat):
            raise TypeError
        with np.errstate(all="ignore"):
            made = np.require(value, right, "A") if value.dtype.kind == "f" else value.astype(right)
    except Error:
        raise
    except (TypeError, ValueError, OverflowError, RuntimeError):
        what = getattr(given, "dtype", type(given).__name__)
        raise Error(f"{name} of {what} that are no numbers of one shape; give float32 or float64") from None
    is_typed = value.dtype.itemsize > 8 or is_wide(given)
    if value.dtype.kind == "f" and value.dtype.itemsize > right.itemsize and is_typed:
        longer = f", or {wider}" if value.dtype.itemsize == 8 else " or float64" if right.itemsize == 4 else ""
        raise Error(f"{name} of {value.dtype.newbyteorder('=')}, which {right} would round; give {right}{longer}")
    if value.dtype.kind == "O" or value.dtype.kind in "iu" and np.abs(made).max(initial=0) > 2.0 ** np.finfo(right).nmant:
        for one, number in zip(value.flat if value.dtype.kind == "O" else value.ravel().tolist(), made.flat):
            if (not isinstance(one, float) or isinstance(one, np.floating)) and one != number.item():
                raise Error(f"{name} of {value.dtype} with {one}, which is no number of {right}; round it to one before")
    return made


class Queries:
    """Queries of one predicate, in one entry and precision.

    `numbers` is an array of shape (columns, n), float32 for binary32 and float64 for binary64: row k is column k of the
    entry. A column is `queries["ax"]`, shape (n,). A group of columns is `queries["a"]` or `queries.a`, shape (n, size),
    or (n,) where it has one column; these are views. `queries[3]`, a slice and an array of indices or bools select. Nothing of it can
    be written: an address, and what was found of a query, stay those of its numbers. `Queries.of` makes queries of changed copies.

    >>> q = Queries.of("sphere-triangle", a=[[0, 0, 0]], b=[[1, 0, 0]], c=[[0, 1, 0]], p=[[0, 0, 2]], r=[1])
    >>> len(q), q.precision, q.p.shape
    (1, 'binary32', (1, 3))
    """

    predicate: str
    entry: str
    numbers: "np.ndarray[Any, Any]"

    def __init__(self, predicate: str, numbers: Any, entry: str = "", ids: Optional[Sequence[str]] = None,
                 addresses: Optional[Sequence[str]] = None) -> None:
        described = entry_of(predicate, entry)
        array = _plain(numbers)
        if array.dtype.newbyteorder("=") not in _PRECISIONS:
            raise Error(f"the numbers of queries are {array.dtype}; give float32, which is binary32, or float64")
        columns: List[str] = described["columns"]
        if array.ndim != 2 or array.shape[0] != len(columns):
            raise Error(f"the numbers of queries have shape {array.shape}; those of {described['predicate']}, entry "
                        f"{described['name']}, have shape ({len(columns)}, n): a row for each column, {' '.join(columns)}")
        if not array.dtype.isnative or not array.flags.aligned or (array.shape[1] > 1 and array.strides[1] != array.itemsize) \
                or array.strides[0] < 0:
            array = np.require(array, array.dtype.newbyteorder("="), ("C", "A"))
        if array.flags.writeable:
            array = array.copy() if array is numbers or array.base is not None else array
            array.flags.writeable = False
        self.predicate, self.entry, self.numbers = described["predicate"], described["name"], array
        self._columns = columns
        self._groups: Dict[str, Tuple[int, int]] = {name: (first, size) for name, first, size in described["groups"]}
        for what, given in (("ids", ids), ("addresses", addresses)):
            if given is not None and len(given) != array.shape[1]:
                raise Error(f"{len(given)} {what} are given for {array.shape[1]} queries")
        self._ids = list(ids) if ids is not None else None
        self._addresses = list(addresses) if addresses is not None else None
        self._made_by: Optional[Tuple[Any, int, "np.ndarray[Any, Any]"]] = None  # source, seed, positions

    @classmethod
    def of(cls, predicate: str = "", entry: str = "", precision: str = "", numbers: Optional[Mapping[str, Any]] = None,
           **groups: Any) -> "Queries":
        """Queries of arrays by their names: columns, shape (n,), or groups of columns, shape (n, size).

        `a_m` is the group `a.m`; `numbers` takes names as they are. Without a precision, binary32 unless an array is float64
        already. Numbers of a type that the precision would round are refused; floats of Python have none. The arrays are copied into one.
        """
        if numbers is not None and not isinstance(numbers, Mapping):
            raise Error(f"numbers= is of {type(numbers).__name__}; give a dictionary of arrays by their names")
        given = {**(numbers or {}), **groups}
        described = entry_of(predicate, entry)
        columns: List[str] = described["columns"]
        if not precision:
            precision = "binary64" if any(map(is_wide, given.values())) else "binary32"
        if text("precision", precision) not in DTYPES:
            raise Error(f"there is no precision '{precision}'; there are: binary32, binary64")
        places = {name: [k] for k, name in enumerate(columns)}
        for name, first, size in described["groups"]:
            places[name] = list(range(first, first + size))
        names = {attribute(name): name for name in places}
        rows: Dict[int, Any] = {}
        count = None
        for asked, array in given.items():
            name = names.get(attribute(asked))
            if name is None:
                raise Error(f"there is no column or group '{asked}' in {described['predicate']}, entry {described['name']}; "
                            f"there are: {', '.join(attribute(group) for group, _, _ in described['groups'])}")
            value = exactly(f"'{asked}' is", array, DTYPES[precision])
            width = len(places[name])
            if value.ndim == (0 if width == 1 else 1):
                value = value[None]
            if value.ndim == 0 or value.shape != ((len(value),) if width == 1 else (len(value), width)):
                raise Error(f"'{asked}' has shape {value.shape}; give shape {'(n,)' if width == 1 else f'(n, {width})'}")
            count = len(value) if count is None else count
            if len(value) != count:
                raise Error(f"'{asked}' is of {len(value)} queries, and others are of {count}")
            for place, k in enumerate(places[name]):
                if k in rows:
                    raise Error(f"the column {columns[k]} is given twice")
                rows[k] = value if width == 1 else value[:, place]
        missing = [columns[k] for k in range(len(columns)) if k not in rows]
        if missing:
            raise Error(f"no numbers are given for {', '.join(missing)}")
        made = np.stack([rows[k] for k in range(len(columns))])
        made.flags.writeable = False
        return cls(described["predicate"], made, described["name"])

    @property
    def precision(self) -> str:
        return _PRECISIONS[self.numbers.dtype]

    @property
    def columns(self) -> List[str]:
        return list(self._columns)

    @property
    def groups(self) -> List[str]:
        return list(self._groups)

    @property
    def ids(self) -> List[str]:
        """Their names in a file; numbers where they have none."""
        return list(self._ids) if self._ids is not None else [str(i) for i in range(len(self))]

    @property
    def addresses(self) -> List[str]:
        """What makes each query again on any machine (`query_at`); empty where it has none."""
        if self._addresses is None:
            if self._made_by is None:
                return [""] * len(self)
            source, seed, positions = self._made_by
            self._addresses = source.addresses(self.precision, seed, [int(i) for i in positions])
        return list(self._addresses)

    def __reduce__(self) -> Any:
        has_addresses = self._addresses is not None or self._made_by is not None
        return Queries, (self.predicate, self.numbers, self.entry, self._ids, self.addresses if has_addresses else None)

    def __len__(self) -> int:
        return int(self.numbers.shape[1])

    def __iter__(self) -> Iterator["Queries"]:
        return (self[i] for i in range(len(self)))

    def __getattr__(self, name: str) -> "np.ndarray[Any, Any]":
        if not name.startswith("_"):
            for group in self._groups:
                if attribute(group) == name:
                    return self._group(group)
        raise AttributeError(f"queries of {self.__dict__.get('predicate', '')} have no '{name}'")

    def __dir__(self) -> List[str]:
        return [*super().__dir__(), *(attribute(group) for group in self._groups)]

    def _group(self, name: str) -> "np.ndarray[Any, Any]":
        first, size = self._groups[name]
        view: "np.ndarray[Any, Any]" = self.numbers[first] if size == 1 else self.numbers[first:first + size].T
        return view

    def __getitem__(self, which: Any) -> Any:
        if isinstance(which, str):
            if which in self._groups:
                return self._group(which)
            if which in self._columns:
                return self.numbers[self._columns.index(which)]
            raise KeyError(f"there is no column or group '{which}'; there are: {', '.join(self._columns)}")
        if isinstance(which, (int, np.integer)):
            if not -len(self) <= which < len(self):
                raise IndexError(f"there is no query {which} of {len(self)}")
            which = slice(int(which) % len(self), int(which) % len(self) + 1)
        indices = np.arange(len(self))[which]
        numbers = np.ascontiguousarray(self.numbers[:, which])
        numbers.flags.writeable = False
        chosen = Queries(self.predicate, numbers, self.entry,
                         None if self._ids is None else [self._ids[i] for i in indices],
                         None if self._addresses is None else [self._addresses[i] for i in indices])
        if self._made_by is not None:
            chosen._made_by = (*self._made_by[:2], self._made_by[2][which])
        return chosen

    def __repr__(self) -> str:
        return f"<{len(self)} queries of {self.predicate}, entry {self.entry}, in {self.precision}>"

    def to_pandas(self) -> Any:
        """A DataFrame with a row for each query: its columns, and its address where it has one."""
        import pandas

        frame = pandas.DataFrame(dict(zip(self._columns, self.numbers)))
        if any(self.addresses):
            frame.insert(0, "address", self.addresses)
        return frame

    def lines(self) -> str:
        """The lines of a query file (docs/queries.md), as `axiscert check` reads them."""
        names = [address or id for address, id in zip(self.addresses, self.ids)]
        return str(_core.query_lines(self.predicate, self.entry, self.numbers, names))

    def save(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes a query file, JSON Lines."""
        with open(path_of("path", path), "w", encoding="utf-8") as file:
            file.write(self.lines())


def _made(source: Any, n: int, seed: int, precision: str, first: int, threads: int) -> Queries:
    n, first, seed = whole("n", n), whole("first", first), whole("seed", seed, greatest=2**64 - 1)
    numbers = source.queries(text("precision", precision), seed, first, n, whole("threads", threads, greatest=4096))
    numbers.flags.writeable = False
    queries = Queries(source.predicate, numbers, source.entry)
    queries._made_by = (source, seed, np.arange(first, first + n))
    return queries


def generate(family: str, n: int, seed: int = 1, precision: str = "binary32", *, first: int = 0, threads: int = 0) -> Queries:
    """The queries `first` to `first + n - 1` of a family: the same on every machine, whatever the threads.

    >>> q = generate("tangent", 1000)
    >>> q
    <1000 queries of sphere-triangle, entry vertices, in binary32>
    >>> q.addresses[7]
    '1:tangent:2:binary32:0:7'
    """
    return _made(_core.family_source(text("family", family)), n, seed, precision, first, threads)


def _whole(source: Any, precision: str, n: Optional[int], seed: int, threads: int) -> Queries:
    fixed = source.fixed_size(text("precision", precision))
    if n is None and fixed is None:
        raise Error(f"{source.name}: say how many queries, as n=1000")
    return _made(source, fixed if n is None else n, seed, precision, 0, threads)


def load_mesh(path: Union[str, "os.PathLike[str]"], n: int, predicate: str = "", seed: int = 1, precision: str = "binary32", *,
              threads: int = 0) -> Queries:
    """Queries on the triangles of a mesh, of any format that assimp reads."""
    return _whole(_core.mesh_source(path_of("path", path), text("predicate", predicate)), precision, n, seed, threads)


def load_queries(path: Union[str, "os.PathLike[str]"], precision: str = "binary32") -> Queries:
    """The queries of a file, JSON Lines or CSV; `precision` is that of CSV, which states none.

    Raises `Error` where they are of more than one predicate, entry or precision: `load_all_queries` has them apart.
    """
    parts = load_all_queries(path, precision)
    if len(parts) > 1:
        raise Error(f"{path_of('path', path)}: it has " + "; ".join(repr(part)[1:-1] for part in parts) +
                    "; load_all_queries gives each by itself")
    return parts[0]


def _parts(parts: Any) -> List[Queries]:
    for _, _, numbers, _, _ in parts:
        numbers.flags.writeable = False
    return [Queries(predicate, numbers, entry, ids, addresses) for predicate, entry, numbers, ids, addresses in parts]


def load_all_queries(path: Union[str, "os.PathLike[str]"], precision: str = "binary32") -> List[Queries]:
    """The queries of a file, of each predicate, entry and precision by themselves."""
    parts = _parts(_core.read_queries(path_of("path", path), text("precision", precision)))
    show_notices()
    return parts


def corpus(predicate: str = "", entry: str = "", precision: str = "binary32", folder: str = "") -> Queries:
    """The queries of the corpus: those that were hard once."""
    return _whole(_core.corpus_source(path_of("folder", folder), text("predicate", predicate), text("entry", entry)), precision, None, 1, 1)


def query_at(address: Union[str, Sequence[str]], *, mesh: str = "", queries: str = "", corpus: str = "") -> Queries:
    """The query of an address, or of several of one predicate and precision; files are where their queries are.

    >>> query_at("1:tangent:2:binary32:0:7").r.shape
    (1,)
    """
    given = [address] if isinstance(address, str) or not isinstance(address, Iterable) else address
    addresses = [text("address", one) for one in given]
    if not addresses:
        raise Error("no address is given; an address is SEED:NAME:VERSION:PRECISION:UNIT:INDEX")
    parts = _parts(_core.queries_at(addresses, path_of("mesh", mesh), path_of("queries", queries), path_of("corpus", corpus)))
    if len(parts) > 1:
        raise Error("the addresses are of " + "; ".join(repr(part)[1:-1] for part in parts))
    return parts[0]
