#!/usr/bin/env python3
"""made_whole.py AXISCERT: adds to record.json what the record has now and the file has not, each at zero, null or empty."""
import json
import subprocess
import sys
from pathlib import Path

FILE = Path(__file__).with_name("record.json")


def nothing(schema):
    """The value of which a schema says nothing but its kind."""
    if "anyOf" in schema or "null" in schema.get("type", ()):
        return None
    if "const" in schema or "enum" in schema:
        return schema.get("const", schema.get("enum", [None])[0])
    if "properties" in schema:
        return made_whole({}, schema)
    kind = schema.get("type")
    return {"object": {}, "array": [], "string": "", "boolean": False, "number": 0.0}.get(kind if isinstance(kind, str) else kind[0], 0)


def made_whole(value, schema):
    if value is None:
        return None
    schema = next((part for part in schema.get("anyOf", ()) if part.get("type") != "null"), schema)
    if isinstance(value, list):
        return [made_whole(item, schema.get("items", {})) for item in value]
    if not isinstance(value, dict):
        return value
    members = schema.get("properties", {})
    value |= {name: nothing(members[name]) for name in schema.get("required", ()) if name not in value}
    other = schema.get("additionalProperties")
    return {name: made_whole(inner, members.get(name, other or {})) for name, inner in value.items()}


def text(value, indent=0):
    """On one line what is no longer than the width and holds no family, and else a line a member."""
    line = json.dumps(value)
    if not isinstance(value, (dict, list)) or not value or (indent > 2 and len(line) < 400) or indent > 5:
        return line
    inner = [(json.dumps(name) + ": " if isinstance(value, dict) else "") + text(value[name] if isinstance(value, dict) else name, indent + 1)
             for name in value]
    begin, end = "{}" if isinstance(value, dict) else "[]"
    return f"{begin}\n" + ",\n".join(" " * (indent + 1) + part for part in inner) + f"\n{' ' * indent}{end}"


def main():
    schema = json.loads(subprocess.run([sys.argv[1], "explain", "--schema", "record"], capture_output=True, check=True).stdout)
    record = json.loads(FILE.read_text())
    FILE.write_text(text(made_whole(record, schema)) + "\n")


if __name__ == "__main__":
    main()
