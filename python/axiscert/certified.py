"""libaxiscert on arrays: the verdict of a sphere and a triangle that is never wrong, and the contact with bounds (docs/certified.md)."""
from __future__ import annotations

from typing import Any, NamedTuple, Optional

import numpy as np

from . import _core
from ._errors import Error, text
from ._queries import Queries, exactly

FEATURES = ("vertex_a", "vertex_b", "vertex_c", "edge_ab", "edge_bc", "edge_ca", "face", "none")


class Contacts(NamedTuple):
    """Of each query, or of each triangle in contact: `verdict`, uint8 (n,), 0 contact, 1 separated, 3 invalid; `feature`, uint8 (n,),
    an index of FEATURES; `has_normal`, bool (n,); `separation` (n,), `normal` and `point` (n, 3), in the precision of the queries."""

    verdict: "np.ndarray[Any, Any]"
    feature: "np.ndarray[Any, Any]"
    has_normal: "np.ndarray[Any, Any]"
    separation: "np.ndarray[Any, Any]"
    normal: "np.ndarray[Any, Any]"
    point: "np.ndarray[Any, Any]"


def _numbers(queries: Any) -> Any:
    if not isinstance(queries, Queries):
        raise Error(f"certified answers Queries, not {type(queries).__name__}; Queries.of(a=, b=, c=, p=, r=) makes them of arrays")
    expected = _core.entry_of("", "")
    if (queries.predicate, queries.entry) != expected:
        raise Error(f"certified answers {expected[0]}, entry {expected[1]}; these queries are of {queries.predicate}, entry "
                    f"{queries.entry}")
    return queries.numbers


def verdicts(queries: Queries, question: str = "closed") -> "np.ndarray[Any, Any]":
    """uint8, shape (n,): 0 contact, 1 separated, 3 invalid. `question` is "closed", where touching counts, "open", or
    "conservative", which is never a missed contact and sometimes one too many.

    >>> from axiscert import generate, truth
    >>> q = generate("tangent", 1000)
    >>> bool((verdicts(q) == truth(q).verdict).all())
    True
    """
    array: "np.ndarray[Any, Any]" = _core.certified_verdicts(_numbers(queries), text("question", question))
    return array


def contacts(queries: Queries, question: str = "closed") -> Contacts:
    """The verdict, the nearest part of the triangle, separation, normal and point, within the bounds of axiscert/contact.h."""
    return _contacts(_core.certified_contacts(_numbers(queries), text("question", question)))


def _contacts(said: Any, count: Optional[int] = None) -> Contacts:
    verdict, feature, has_normal, separation, normal, point = said
    return Contacts(verdict[:count], feature[:count], has_normal[:count], separation[:count], normal.T[:count], point.T[:count])


class MeshContacts(NamedTuple):
    """The triangles in contact, their numbers in `triangles`; `contacts` of each; `invalid`, how many were no query."""

    triangles: "np.ndarray[Any, Any]"
    contacts: Contacts
    invalid: int


def _whole_numbers(name: str, given: Any, shape: str) -> "np.ndarray[Any, Any]":
    try:
        return np.asarray(given)
    except (TypeError, ValueError):
        raise Error(f"{name} are of {type(given).__name__} that are no numbers of one shape; give integers of shape {shape}") from None


def mesh(sphere: Any, vertices: Any, indices: Any, triangles: Any = None, question: str = "closed") -> MeshContacts:
    """One sphere, (4,) of centre and radius, against triangles of a mesh: `vertices` (v, 3), float32 or float64, which is the precision
    of the sphere too, and `indices` (t, 3).
    `triangles` are the numbers of those that are asked, as a broad phase has them; without it all.

    >>> found = mesh([0, 0, 0.5, 1], [[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    >>> found.triangles, found.contacts.separation
    (array([0], dtype=uint32), array([-0.5]))
    """
    points = exactly("vertices are", vertices)
    if points.ndim != 2 or points.shape[1] != 3:
        raise Error(f"vertices have shape {points.shape}; give shape (v, 3)")
    if not points.flags.aligned or points.strides[1] != points.itemsize or points.strides[0] < 3 * points.itemsize or points.strides[0] % points.itemsize:
        points = np.require(points, requirements=("C", "A"))
    faces = _whole_numbers("indices", indices, "(t, 3)")
    if faces.ndim != 2 or faces.shape[1] != 3 or faces.dtype.kind not in "iu":
        raise Error(f"indices have shape {faces.shape} and type {faces.dtype}; give integers of shape (t, 3)")
    if faces.size and (faces.min() < 0 or faces.max() >= len(points)):
        raise Error(f"an index is {faces.min() if faces.min() < 0 else faces.max()}, and there are {len(points)} vertices")
    asked = np.arange(len(faces), dtype=np.uint32) if triangles is None else _whole_numbers("triangles", triangles, "(k,)")
    if asked.shape == (0,):
        asked = asked.astype(np.uint32)
    if asked.ndim != 1 or asked.dtype.kind not in "iu":
        raise Error(f"triangles have shape {asked.shape} and type {asked.dtype}; give integers of shape (k,)")
    if asked.size and (asked.min() < 0 or asked.max() >= len(faces)):
        raise Error(f"a triangle is number {asked.min() if asked.min() < 0 else asked.max()}, and there are {len(faces)}")
    ball = np.require(exactly("the sphere is", sphere, points.dtype, "vertices of float64"), requirements=("C", "A"))
    if ball.shape != (4,):
        raise Error(f"the sphere has shape {ball.shape}; give its centre and radius, shape (4,)")
    contact, invalid, hits, said = _core.certified_mesh(
        ball, points, np.require(faces, np.uint32, ("C", "A")), np.require(asked, np.uint32, ("C", "A")), text("question", question))
    found = _contacts(said, contact)
    return MeshContacts(hits[:contact], found._replace(verdict=np.zeros(contact, np.uint8)), invalid)
