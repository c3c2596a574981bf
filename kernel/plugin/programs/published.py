"""The predicate `published` in binary64, without its comparisons, as a program for the pipe (docs/pipe.md) in Python:
Python's numbers are binary64, and nothing is fused. With the argument `once` it answers one stream and ends.
"""
import struct
import sys

HEAD = struct.Struct("<8sIIQII")


def dot(u, v):
    return (u[0] * v[0] + u[1] * v[1]) + u[2] * v[2]


def cross(u, v):
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def minus(u, v):
    return (u[0] - v[0], u[1] - v[1], u[2] - v[2])


def beyond_edge(u, v, w, uu, uv, rr):
    edge = minus(v, u)
    d, e = uv - uu, dot(edge, edge)
    q = tuple(x * e - y * d for x, y in zip(u, edge))
    return dot(q, q) > (rr * e) * e and dot(q, tuple(x * e - y for x, y in zip(w, q))) > 0


def separated(numbers):
    a, b, c = (minus(numbers[k:k + 3], numbers[9:12]) for k in (0, 3, 6))
    rr = numbers[12] * numbers[12]
    normal = cross(minus(b, a), minus(c, a))
    d, e = dot(a, normal), dot(normal, normal)
    aa, ab, ac, bb, bc, cc = dot(a, a), dot(a, b), dot(a, c), dot(b, b), dot(b, c), dot(c, c)
    return (d * d > rr * e or (aa > rr and ab > aa and ac > aa) or (bb > rr and ab > bb and bc > bb)
            or (cc > rr and ac > cc and bc > cc) or beyond_edge(a, b, c, aa, ab, rr) or beyond_edge(b, c, a, bb, bc, rr)
            or beyond_edge(c, a, b, cc, ac, rr))


def main():
    read, write = sys.stdin.buffer.read, sys.stdout.buffer.write
    while head := read(64):
        magic, version, precision, count, header_size, record_size = HEAD.unpack_from(head)
        if magic != b"AXISCERT" or version != 3 or precision != 64:
            sys.exit("published.py: standard input is no stream of version 3 in binary64")
        write(head + read(header_size - 64))
        for numbers in struct.iter_unpack("<13d", read(count * record_size)):
            write(bytes([separated(numbers)]).ljust(16, b"\0"))
        sys.stdout.flush()
        if "once" in sys.argv[1:]:
            return


if __name__ == "__main__":
    main()
