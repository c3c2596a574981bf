"""A function as a program for `--kernel program:MANIFEST.json` (docs/pipe.md): the process in which a supervised one runs.

    serve.py FILE:FUNCTION GROUPS MEASURES BITS PATH

GROUPS is JSON, a list of [name, first column, columns], or null where the function takes all columns in one array; MEASURES the
names of the measures that follow each reply; BITS whether it returns comparison bits; PATH is where modules are found.
"""
import importlib.util
import json
import os
import struct
import sys

import numpy as np


def load(where):
    file, name = where.rsplit(":", 1)
    sys.path.insert(0, os.path.dirname(file))
    spec = importlib.util.spec_from_file_location(os.path.splitext(os.path.basename(file))[0], file)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    found = module
    for part in name.split("."):
        found = getattr(found, part)
    return getattr(found, "function", found)


def array_of(given, what, size, width=1):
    array = np.asarray(given) if hasattr(given, "__array__") or not hasattr(given, "__dlpack__") else np.from_dlpack(given)
    shape = (size,) if width == 1 else (size, width)
    if array.shape != shape:
        sys.exit(f"its {what} have shape {array.shape}, of {size} queries; give shape {shape}")
    return array


def replies(result, queries, dtype, measures, bits):
    answers = result if isinstance(result, dict) else {"verdict": result}
    if "verdict" not in answers:
        sys.exit('the dictionary that it returns has no "verdict"')
    size = len(queries)
    given = array_of(answers["verdict"], "verdicts", size)
    reply = np.zeros(size, dtype)
    if bits and given.dtype.kind == "u" and given.dtype.itemsize >= 4:
        sys.exit("comparison bits need the verdict beside them in a supervised process: return a dictionary with both")
    if given.dtype != np.bool_ and given.dtype != np.uint8:
        sys.exit(f"its verdicts are {given.dtype}; give bool, where True is contact, or uint8, where 0 is contact, 1 separated, "
                 "2 undecided and 3 invalid")
    reply["verdict"] = ~given if given.dtype == np.bool_ else given
    if bits:
        reply["bits"] = array_of(answers["bits"], "bits", size)
        reply["flags"] |= 1
    if measures:
        reply["flags"] |= 2
        columns = np.full((size, len(measures)), np.nan)
        for name, value in answers.items():
            if name in ("verdict", "bits"):
                continue
            if name in measures:
                columns[:, measures.index(name)] = array_of(value, name, size)
            elif f"{name}_x" in measures:
                first = measures.index(f"{name}_x")
                columns[:, first:first + 3] = array_of(value, name, size, 3)
            else:
                sys.exit(f"the dictionary that it returns has '{name}'; it may have: verdict, {', '.join(measures)}")
        reply["measures"] = columns
    return reply.tobytes()


def main(where, groups, measures, bits, path):
    sys.path[:0] = [folder for folder in json.loads(path) if folder not in sys.path]
    groups, measures, bits = json.loads(groups), json.loads(measures), json.loads(bits)
    read, write = sys.stdin.buffer.read, sys.stdout.buffer.write
    sys.stdout = sys.stderr  # what the function prints is no reply
    np.seterr(all="ignore")  # queries that overflow are asked on purpose
    function = load(where)
    while head := read(64):
        precision, count, header_size, record_size = struct.unpack_from("<IQII", head, 12)
        write(head + read(header_size - 64))
        number = np.dtype({32: "<f4", 64: "<f8"}[precision])
        dtype = np.dtype([("verdict", "u1"), ("flags", "u1"), ("zeros", "u1", 6), ("bits", "<u8")] +
                         ([("measures", number, len(measures))] if measures else []))
        if count:
            rows = np.frombuffer(read(count * record_size), number).reshape(count, -1)
            columns = np.ascontiguousarray(rows.T)
            columns.setflags(write=False)
            if groups is None:
                result = function(columns)
            else:
                result = function(*[columns[first] if size == 1 else columns[first:first + size].T for _, first, size in groups])
            write(replies(result, rows, dtype, measures, bits))
        sys.__stdout__.buffer.flush()


if __name__ == "__main__":
    main(*sys.argv[1:])
