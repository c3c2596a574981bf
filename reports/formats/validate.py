"""Checks files against a JSON Schema: validate.py SCHEMA FILE...

Exit 0: all conform. 1: one does not; each fault is one line, with the file and the place in it. 2: bad usage.
"""

import json
import sys

import jsonschema


def faults(validator, path):
    try:
        with open(path, encoding="utf-8") as file:
            value = json.load(file)
    except (OSError, ValueError) as error:
        yield f"{path}: not readable as JSON: {error}"
        return
    for error in validator.iter_errors(value):
        where = "".join(f"/{step}" for step in error.absolute_path) or "/"
        yield f"{path}: {where}: {error.message[:300]}"


def main(arguments):
    if len(arguments) < 2:
        print(__doc__, file=sys.stderr)
        return 2
    with open(arguments[0], encoding="utf-8") as file:
        schema = json.load(file)
    validator_type = jsonschema.validators.validator_for(schema)
    validator_type.check_schema(schema)
    validator = validator_type(schema)
    found = [fault for path in arguments[1:] for fault in faults(validator, path)]
    for fault in found:
        print(fault, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
