"""A function as a program for `--kernel program:MANIFEST.json` (docs/pipe.md): the process in which a supervised one runs.

    serve.py FILE:FUNCTION GROUPS MEASURES BITS PATH

GROUPS is JSON, a list of [name, first column, columns], or null where the function takes all columns in one array; MEASURES the
names of the measures that follow each reply; BITS the predicate of whose comparisons the function returns the bits, or null; PATH
is where modules are found.
"""
import importlib.util
import json
import os
import struct
import sys

import numpy as np

AXISCERT_LOADS = None  # the file that is being loaded, for axiscert, which then begins nothing


def load(where):
    global AXISCERT_LOADS
    file, name = where.rsplit(":", 1)
    sys.path.insert(0, os.path.dirname(file))
    spec = importlib.util.spec_from_file_location(os.path.splitext(os.path.basename(file))[0], file)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    AXISCERT_LOADS = file
    spec.loader.exec_module(module)
    AXISCERT_LOADS = None
    found = module
    for part in name.split("."):
        found = getattr(found, part)
    return found._function if type(found).__module__ == "axiscert._kernels" else found


def array_of(given, what, size, width=1):
    try:
        array = np.asarray(given) if hasattr(given, "__array__") or not hasattr(given, "__dlpack__") else np.from_dlpack(given)
    except Exception as why:
        sys.exit(f"its {what} are {type(given).__name__}, of which NumPy makes no array: {why}")
    if isinstance(given, np.ma.MaskedArray):
        sys.exit(f"its {what} are a masked array; give each query an answer")
    shape = (size,) if width == 1 else (size, width)
    if array.shape != shape:
        sys.exit(f"its {what} have shape {array.shape}, of {size} queries; give shape {shape}")
    return array


def numbers_of(given, name, size, width, number):
    array = array_of(given, f"numbers of {name}", size, width)
    if array.dtype.kind not in "biuf" or (array.dtype.kind == "f" and array.dtype.itemsize > number.itemsize):
        sys.exit(f"its numbers of {name} are {array.dtype}; give {number}")
    return array


def replies(result, size, dtype, measures, predicate):
    if not isinstance(result, dict) and measures:
        sys.exit(f"it returns {type(result).__name__}; with measures= it returns a dictionary: \"verdict\", and each measure by its name")
    answers = result if isinstance(result, dict) else {"verdict": result}
    if "verdict" not in answers:
        sys.exit('the dictionary that it returns has no "verdict"')
    given = array_of(answers["verdict"], "comparison bits" if predicate else "verdicts", size)
    reply = np.zeros(size, dtype)
    if predicate:
        if given.dtype.kind != "u" or given.dtype.itemsize < 4:
            sys.exit(f"its comparison bits are {given.dtype}; give uint32 or uint64, bit i for comparison i")
        from axiscert import _core
        reply["bits"] = given
        reply["verdict"] = _core.verdicts_of_bits(predicate, reply["bits"])
        reply["flags"] |= 1
    elif given.dtype == np.bool_ or given.dtype == np.uint8:
        reply["verdict"] = ~given if given.dtype == np.bool_ else given
    else:
        sys.exit(f"its verdicts are {given.dtype}; give bool, where True is contact, or uint8, where 0 is contact, 1 separated, "
                 "2 undecided and 3 invalid; comparison bits take formulae=")
    columns = np.full((size, len(measures)), np.nan)
    for name, value in answers.items():
        if name == "verdict":
            continue
        if name in measures:
            columns[:, measures.index(name)] = numbers_of(value, name, size, 1, dtype["measures"].base)
        elif f"{name}_x" in measures and measures.index(f"{name}_x") + 3 <= len(measures):
            first = measures.index(f"{name}_x")
            columns[:, first:first + 3] = numbers_of(value, name, size, 3, dtype["measures"].base)
        else:
            sys.exit(f"the dictionary that it returns has \"{name}\"; it may have: {', '.join(['verdict', *measures])}")
    if measures:
        reply["flags"] |= 2
        reply["measures"] = columns
    return reply.tobytes()


def main(where, groups, measures, bits, path):
    sys.path[:0] = [folder for folder in json.loads(path) if folder not in sys.path]
    groups, measures, predicate = json.loads(groups), json.loads(measures), json.loads(bits)
    read, write = sys.stdin.buffer.read, sys.stdout.buffer.write
    sys.stdout = sys.stderr  # what the function prints is no reply
    np.seterr(all="ignore")  # queries that overflow are asked on purpose
    function = load(where)
    while head := read(64):
        precision, count, header_size, record_size = struct.unpack_from("<IQII", head, 12)
        write(head + read(header_size - 64))
        number = np.dtype({32: "<f4", 64: "<f8"}[precision])
        dtype = np.dtype([("verdict", "u1"), ("flags", "u1"), ("zeros", "u1", 6), ("bits", "<u8")] +
                         ([("measures", number, (len(measures),))] if measures else []))
        if count:
            rows = np.frombuffer(read(count * record_size), number).reshape(count, -1)
            columns = np.ascontiguousarray(rows.T)
            columns.setflags(write=False)
            if groups is None:
                result = function(columns)
            else:
                result = function(*[columns[first] if size == 1 else columns[first:first + size].T for _, first, size in groups])
            write(replies(result, len(rows), dtype, measures, predicate))
        sys.__stdout__.buffer.flush()


if __name__ == "__main__":
    main(*sys.argv[1:])
