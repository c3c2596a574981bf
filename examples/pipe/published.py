#!/usr/bin/env python3
"""The published sphere-triangle predicate in numpy, as a program for axiscert's pipe (docs/pipe.md):

    axiscert generate --family tangent --binary | ./published.py | axiscert judge --conforms-to published
    axiscert run --kernel program:published.json

numpy rounds after every operation and fuses none, so the replies are those of axiscert's own kernel, bit for bit.
"""
import struct
import sys

import numpy as np

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


def comparisons(a, b, c, p, r):
    """The sixteen comparisons, in axiscert's order. Points are arrays of shape (3, n), r of shape (n)."""
    a, b, c, rr = a - p, b - p, c - p, r * r
    normal = cross(b - a, c - a)
    d, e = dot(a, normal), dot(normal, normal)
    aa, ab, ac, bb, bc, cc = dot(a, a), dot(a, b), dot(a, c), dot(b, b), dot(b, c), dot(c, c)
    return [d * d > rr * e,
            aa > rr, ab > aa, ac > aa,
            bb > rr, ab > bb, bc > bb,
            cc > rr, ac > cc, bc > cc,
            *beyond_edge(a, b, c, aa, ab, rr),
            *beyond_edge(b, c, a, bb, bc, rr),
            *beyond_edge(c, a, b, cc, ac, rr)]


def replies(queries):
    """Sixteen bytes per query: verdict, flags, six zeros, comparison bits."""
    columns = np.ascontiguousarray(queries.T)
    held = comparisons(columns[0:3], columns[3:6], columns[6:9], columns[9:12], columns[12])
    plane, vertices, edges = held[:1], zip(*[iter(held[1:10])] * 3), zip(*[iter(held[10:])] * 2)
    separated = np.any([np.all(axis, axis=0) for axis in (plane, *vertices, *edges)], axis=0)
    reply = np.zeros(len(queries), np.dtype([("verdict", "u1"), ("flags", "u1"), ("zeros", "u1", 6), ("bits", "<u8")]))
    reply["verdict"] = separated  # 1 separated, 0 contact
    reply["flags"] = 1            # comparison bits are given
    reply["bits"] = sum(bit.astype(np.uint64) << np.uint64(i) for i, bit in enumerate(held))
    return reply.tobytes()


def main():
    read, write = sys.stdin.buffer.read, sys.stdout.buffer.write
    while head := read(64):  # one stream in a pipe; `--kernel program:` writes one after another
        magic, version, precision, count, header_size, record_size = struct.unpack_from("<8sIIQII", head)
        if magic != b"AXISCERT":
            sys.exit("published.py: standard input is not a query stream; axiscert generate --binary makes one")
        if version != 3:
            sys.exit("published.py: the stream is not of version 3")
        write(head + read(header_size - 64))
        number = np.dtype({32: "<f4", 64: "<f8"}[precision])
        with np.errstate(all="ignore"):  # overflow and NaN are part of the queries
            for first in range(0, count, BATCH):
                queries = read(min(BATCH, count - first) * record_size)
                write(replies(np.frombuffer(queries, number).reshape(-1, 13)))
        sys.stdout.buffer.flush()


if __name__ == "__main__":
    main()
