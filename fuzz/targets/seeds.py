#!/usr/bin/env python3
"""Writes the inputs from which the fuzz targets begin, made from text files of the tree.

    seeds.py SOURCE_FOLDER OUT

OUT/TARGET/* are the inputs; OUT/TARGET.list names them all, separated by commas, for libFuzzer's -seed_inputs=@FILE.
The same tree gives the same bytes.
"""

import base64
import hashlib
import json
import pathlib
import shutil
import struct
import sys

POINTS = ("a", "b", "c", "p")
HEADER = "ax,ay,az,bx,by,bz,cx,cy,cz,px,py,pz,r"


def number(text):
    """The value of a number of a query file: hexadecimal, decimal, nan or inf."""
    if isinstance(text, str) and "0x" in text.lower():
        return float.fromhex(text)
    return float(text)


def texts_of(query):
    """The thirteen numbers, spelled as in the file, in the order of every column."""
    return [x for point in POINTS for x in query[point]] + [query["r"]]


def kernel_seed(query, kernel):
    """The bytes of an input of the kernel target, as described in fuzz/targets/query_moves.h."""
    is_wide = query["precision"] == "binary64"
    return struct.pack("<BB13" + ("d" if is_wide else "f"), is_wide, kernel, *map(number, texts_of(query)))


def plan_text(plan):
    return json.dumps(plan, separators=(",", ":"))


def seeds(source):
    """The inputs by target."""
    files = sorted((source / "fuzz/corpus").glob("*.jsonl")) + sorted((source / "examples").rglob("*.jsonl"))
    lines = [line for file in files for line in file.read_text().splitlines() if line.strip()]
    # Queries of three points, a centre and a radius; the boxes of other predicates are texts for the parser alone.
    queries = [query for query in map(json.loads, lines) if "box" not in query.get("predicate", "")]
    result = {}
    result["kernel"] = [kernel_seed(query, i) for i, query in enumerate(queries)]

    extras = [
        '{"id":"ok","precision":"binary32","a":[0,0,0],"b":[1,0,0],"c":[0,1,0],"p":[0,0,1],"r":0.5}',
        '{"precision":"binary64","a":[1e-320,-0,4.9e-324],"b":["inf","-inf","nan"],"c":[0.1,1e22,1E-5],"p":["-0x1p-1074",'
        '"0X1.8P+3",2],"r":"0x0p+0","more":[{"x":[null,true]},"y"]}',
    ]
    result["query_file"] = [text.encode() for text in extras + lines[::3]]
    result["query_file"] += ["\n".join(lines[:4]).encode(), b"\xef\xbb\xbf" + extras[0].encode() + b"\r\n\r\n" + extras[1].encode()]
    rows = [",".join(str(x) for x in texts_of(query)) for query in queries]
    result["query_csv"] = [f"{HEADER}\n{row}\n".encode() for row in rows[::5]]
    result["query_csv"] += [
        f"id,{HEADER}\nfirst,{rows[0]}\n,{rows[1]}\n".encode(),
        f"\ufeff{HEADER}\r\n\r\n 1 ,\t2,3.5e-3,-4e10,5,6,7,8,9,10,11,nan,inf\r\n".encode(),
    ]
    result["mesh"] = [
        b"\0v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 1 1e-40\nf 1 2 3\nf 1 2 3 4\nf 1 1 2\nl 1 2\n",
        b"\0v 1e39 0 0\nv nan 0 0\nv 0 1 0\nv 0 0 1\nv 1 0 0\nf 1 3 4\nf 2 3 4\nf 3 4 5\n",
        b"\1ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
        b"property list uchar int vertex_indices\nend_header\n0 0 0\n3e38 0 0\n0 -3e38 0\n3 0 1 2\n",
        b"\2solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid s\n",
        b"\2" + b"\0" * 80 + struct.pack("<I12fH", 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0),
        b"\3OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1e-45\n3 0 1 2\n3 0 2 3\n",
    ]

    part = {"kind": "family", "name": "tangent", "version": 1, "queries": 2}
    version = project_version(source)
    one = {"axiscert": version, "seed": 1, "precision": "binary32", "predicate": "sphere-triangle", "entry": "vertices", "columns": 13,
           "sources": [part]}
    file = (extras[0] + "\n").encode()
    read = {"kind": "queries", "name": "given.jsonl", "path": "given.jsonl", "version": 1,
            "sha256": hashlib.sha256(file).hexdigest(), "queries": 1}
    two = dict(one, precision="binary64", seed=2**64 - 1, sources=[dict(part, name="general", version=2), dict(part, queries=0)])
    three = dict(one, sources=[read, dict(part, name="lattice", queries=1)])
    contact, separated, undecided, invalid, bits = (struct.pack("<BB6xQ", *reply) for reply in ((0, 0, 0), (1, 0, 0), (2, 0, 0), (3, 0, 0), (1, 1, 7)))
    result["pipe"] = [
        plan_text(one).encode() + b"\0" + contact + separated,
        plan_text(two).encode() + b"\0" + bits * 2,
        plan_text(three).encode() + b"\0" + undecided + invalid,
        plan_text(one).encode() + b"\0" + contact,
        *(b"AXISCERT" + struct.pack("<IIQII32x", number, 32, 2, 128, 52) + b" " * 64 for number in (1, 2, 3)),
        b"hello, world\n",
    ]

    manifest = {"format": "axiscert-program/2", "name": "a/b", "command": ["node", "b.mjs"], "precisions": ["binary32", "binary64"]}
    result["manifest"] = [plan_text(one).encode() for one in (
        manifest, dict(manifest, predicate="sphere-triangle", entry="vertices", touching="either", may_decline=True, exposes="comparisons", summary="s",
                       package="p", version="1.0", source="b.mjs:1", formulae="published", limits={"least_radius": 1e-3}),
        dict(manifest, conforms_to="published", precisions=["binary32"]), dict(manifest, format="axiscert-program/1"), {}, [])]
    result["manifest"] += [path.read_bytes() for path in sorted((source / "examples").rglob("*.json"))]
    result["program_replies"] = [bytes([2, options, part]) + replies for options, part, replies in (
        (4, 0, contact + separated), (4, 6, bits * 3), (5, 1, bits * 2), (4, 4, b"\1\0\0\0" * 8), (4, 255, b"\x07\0\0\0hello, all of you"),
        (0, 3, b"engine loaded\n"), (2, 3, b"more"), (0, 2, b"AXISCERT\3\0\0\0"))]

    result["journal"] = [b"", b"\x01\x07", b"\x03\x00\x00\x07\x00\x80", bytes([0x40, 4]) + b"\x83\x00\x80\x40"]
    options = {"predicate": "sphere-triangle", "kernels": ["published", "certified"], "families": ["tangent", "lattice"], "meshes": [], "queries": [],
               "corpus": None, "trials": 1000, "seed": 1, "precision": "binary32", "tolerances": ["plane.radius=2"], "require": "logic"}
    plan = {"schema": "axiscert-plan/2", "plan": {"seed": 1}, "options": options, "queries": 2000, "units": 2,
            "units_per_stretch": 1, "stretches": 2, "digest": ""}
    least = dict(options, kernels=["published+fma"], families=[], trials=2**64 - 1, seed=0, precision="", require="")
    unnamed = {name: value for name, value in options.items() if name != "predicate"}
    plans = [plan, dict(plan, schema="axiscert-plan/1"), dict(plan, options=unnamed), dict(plan, options=least), dict(plan, options=least, plan={}), dict(plan, queries=1.8e19), {}]
    result["plan"] = [plan_text(one).encode() for one in plans]

    stored = statement(source)
    statements = [stored, statement(source, signed_at="2026-01-01T00:00:00Z"), dict(stored, predicateType="urn:axiscert:certificate:2"),
                  dict(stored, predicate={})]
    whole = [canonical(one) for one in statements]
    sealed = {"payload": base64.b64encode(whole[0]).decode(), "payloadType": "application/vnd.in-toto+json",
              "signatures": [{"keyid": "0" * 64, "sig": base64.b64encode(bytes(range(64))).decode()}]}
    envelopes = [sealed, dict(sealed, signatures=[]), dict(sealed, signatures=sealed["signatures"] * 3), dict(sealed, payloadType="text/plain")]
    result["certificate"] = [one + b"\n" for one in whole] + [canonical(sealed) + b"\n", whole[0][:-40], b'{"a":1,"a":2}']
    result["envelope"] = [canonical(one) + b"\n" for one in envelopes] + [canonical(sealed)[:-40], b"[" * 5000]

    record = json.loads((source / "reports/testing/record.json").read_text())
    for kernel in record["kernels"]:  # a smaller record: fewer cells, but all kinds of members
        kernel["families"] = dict(list(kernel["families"].items())[:1])
    record["kernels"], record["witnesses"] = record["kernels"][:1], record["witnesses"][:2]
    # Deeper than any recursion survives.
    deep = b'{"schema":' + b"[" * 500000 + b"]" * 500000 + b"}"
    result["plan"].append(deep)
    result["record"] = [
        (source / "reports/testing/record.json").read_bytes(),
        json.dumps(record).encode(),
        (source / "reports/testing/run.json").read_bytes(),
        deep,
    ]
    return result


def canonical(value):
    return json.dumps(value, sort_keys=True, separators=(",", ":"), ensure_ascii=False).encode()


def statement(source, **changes):
    """The stored certificate, which has one of everything that one can have, with the digest of itself."""
    made = json.loads((source / "reports/testing/certificate.json").read_text())
    made["predicate"].update(changes)
    made["predicate"]["digest"] = hashlib.sha256(canonical(made)).hexdigest()
    return made


def project_version(source):
    words = (source / "CMakeLists.txt").read_text().split()
    return words[words.index("VERSION", words.index("project(axiscert")) + 1]


def main():
    source, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    for target, inputs in seeds(source).items():
        folder = out / target
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        for i, content in enumerate(inputs):
            (folder / f"{i:03}").write_bytes(content)
        paths = [str(path) for path in sorted(folder.iterdir())]
        (out / f"{target}.list").write_text(",".join(paths))


if __name__ == "__main__":
    main()
