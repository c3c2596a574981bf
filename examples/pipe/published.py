#!/usr/bin/env python3
"""The published sphere-triangle predicate in numpy, as a program for axiscert's pipe (docs/pipe.md), and a template:

    axiscert generate --family tangent --binary | ./published.py | axiscert judge --conforms-to published
    axiscert run --kernel program:published.json

Another question takes other COLUMNS, as `axiscert predicates` lists them, and another function `separated`. numpy rounds
after every operation and fuses none, so the replies are those of axiscert's own kernel, bit for bit.
"""
import json
import struct
import sys

import numpy as np

PREDICATE, ENTRY = "sphere-triangle", "vertices"
COLUMNS = "ax ay az bx by bz cx cy cz px py pz r".split()
BATCH = 4096  # queries; any number gives the same replies


def dot(u, v):
    return (u[0] * v[0] + u[1] * v[1]) + u[2] * v[2]


def cross(u, v):
    return np.stack([u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]])


def beyond_edge(u, v, w, uu, uv, rr):
    """Whether edge uv lies beyond the sphere, and whether the third vertex w does."""
    edge = v - u
    d, e = uv - uu, dot(edge, edge)
    q = u * e - edge * d
    return [dot(q, q) > (rr * e) * e, dot(q, w * e - q) > 0]


def separated(q):
    """Whether the two are apart, of a batch of queries, each column an array by its name. And an array of each comparison, in
    axiscert's order; or [], where the program shows none."""
    p, rr = np.stack([q["px"], q["py"], q["pz"]]), q["r"] * q["r"]
    a, b, c = (np.stack([q[f"{vertex}x"], q[f"{vertex}y"], q[f"{vertex}z"]]) - p for vertex in "abc")
    normal = cross(b - a, c - a)
    d, e = dot(a, normal), dot(normal, normal)
    aa, ab, ac, bb, bc, cc = dot(a, a), dot(a, b), dot(a, c), dot(b, b), dot(b, c), dot(c, c)
    axes = [[d * d > rr * e],
            [aa > rr, ab > aa, ac > aa],
            [bb > rr, ab > bb, bc > bb],
            [cc > rr, ac > cc, bc > cc],
            beyond_edge(a, b, c, aa, ab, rr),
            beyond_edge(b, c, a, bb, bc, rr),
            beyond_edge(c, a, b, cc, ac, rr)]
    return np.any([np.all(axis, axis=0) for axis in axes], axis=0), sum(axes, [])


# What follows is the same for every question.

def replies(queries):
    """Sixteen bytes for each query: verdict, flags, six zeros, comparison bits."""
    apart, comparisons = separated(dict(zip(COLUMNS, np.ascontiguousarray(queries.T))))
    reply = np.zeros(len(queries), np.dtype([("verdict", "u1"), ("flags", "u1"), ("zeros", "u1", 6), ("bits", "<u8")]))
    reply["verdict"] = apart            # 1 separated, 0 contact
    reply["flags"] = bool(comparisons)  # 1: comparison bits are given
    for i, holds in enumerate(comparisons):
        reply["bits"] |= holds.astype(np.uint64) << np.uint64(i)
    return reply.tobytes()


def main():
    read, write = sys.stdin.buffer.read, sys.stdout.buffer.write
    while head := read(64):  # one stream in a pipe; `--kernel program:` writes one after another
        magic, version, precision, count, header_size, record_size = struct.unpack_from("<8sIIQII", head.ljust(64))
        if magic != b"AXISCERT":
            sys.exit("published.py: standard input is not a query stream; axiscert generate --binary makes one")
        if version != 3:
            sys.exit("published.py: the stream is not of version 3")
        plan = read(header_size - 64)
        asked = json.loads(plan)
        if (asked["predicate"], asked["entry"]) != (PREDICATE, ENTRY):
            sys.exit(f"published.py: the stream asks {asked['predicate']}, entry {asked['entry']}; this program answers "
                     f"{PREDICATE}, entry {ENTRY}")
        if record_size != len(COLUMNS) * precision // 8:
            sys.exit(f"published.py: a query has {record_size * 8 // precision} numbers, and COLUMNS {len(COLUMNS)} names")
        write(head + plan)
        number = np.dtype({32: "<f4", 64: "<f8"}[precision])
        with np.errstate(all="ignore"):  # overflow and NaN are part of the queries
            for first in range(0, count, BATCH):
                queries = read(min(BATCH, count - first) * record_size)
                write(replies(np.frombuffer(queries, number).reshape(-1, len(COLUMNS))))
        sys.stdout.buffer.flush()


if __name__ == "__main__":
    main()
