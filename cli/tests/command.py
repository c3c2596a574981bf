"""Functions that the tests of the command share. A test file is run as

    FILE BUILD_FOLDER MODELS_FOLDER TRIAL_DIVISOR [unittest arguments]

The divisor makes the larger plans smaller for builds that are many times slower.
"""
import functools
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BUILD, MODELS, DIVISOR = Path(sys.argv.pop(1)).resolve(), Path(sys.argv.pop(1)).resolve(), int(sys.argv.pop(1))
ROOT = Path(__file__).resolve().parents[2]
REPORTS = ROOT / "reports"
SCHEMAS = BUILD / "schemas"  # which the command makes
VALIDATE = REPORTS / "formats/validate.py"


def fewer(trials):
    """As many as this build has time for, and enough that every family has a valid query: `nonfinite` has few."""
    return max(trials // DIVISOR, 40)


def axiscert(*args, program="axiscert", stdin=None):
    return subprocess.run([BUILD / program, *map(str, args)], input=stdin, capture_output=True, text=True, timeout=600)


@functools.cache
def schema_of(name):
    """The JSON Schema of a format, which the command makes of the fields that it writes."""
    return json.loads(axiscert("explain", "--schema", name).stdout)


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_ok(self, *args, out="out", code=0):
        done = axiscert("run", *args, "--out", self.folder / out)
        self.assertEqual(done.returncode, code, done.stderr)
        return json.loads((self.folder / out / "record.json").read_text())

    def refused(self, *args, says, stdin=None, code=2):
        done = axiscert(*args, stdin=stdin)
        self.assertEqual(done.returncode, code, f"{args}: {done.stdout}{done.stderr}")
        for part in says:
            self.assertIn(part, done.stderr)
        self.assertNotIn("terminate called", done.stderr)
        return done


def family(record, name, precision="binary32", kernel="published"):
    (entry,) = [k for k in record["kernels"] if k["id"] == kernel and k["precision"] == precision]
    return entry["families"][name]


QUERY = '{"id":"q","precision":"binary32","a":[2,0,0],"b":[2,0,0],"c":[3,0,0],"p":[0,0,0],"r":%s}\n'
