#!/usr/bin/env python3
"""A peer whose package is absent is reported with a warning when the build is configured, and listed so that axiscert
can say NOT CHECKED.

absent_test.py CMAKE CXX_COMPILER [unittest arguments]
"""
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CMAKE, COMPILER = sys.argv.pop(1), sys.argv.pop(1)
ROOT = Path(__file__).resolve().parents[2]
ODE = ["ode", "moving-sphere/ode-capsule", "box-box/ode", "box-box/ode-unimportant", "box-box/ode-touches"]


class Absent(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.build = Path(folder.name)
        self.peers = self.build / "peers"
        self.peers.mkdir()
        (self.peers / "ode.so").touch()  # left by a build made while the package was installed

    def configured(self, *options):
        done = subprocess.run(
            [CMAKE, "-S", ROOT, "-B", self.build, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={COMPILER}", "-DAXISCERT_TESTS=OFF",
             *options], capture_output=True, text=True, timeout=600)
        self.assertEqual(done.returncode, 0, done.stderr)
        rules = (self.build / "build.ninja").read_text()
        return " ".join(done.stderr.split()), re.findall(r"^build peers/([a-z/-]+)\.so:", rules, re.MULTILINE)

    def test_a_peer_without_its_package_is_named_with_it_and_the_others_are_built(self):
        warning, built = self.configured("-Dpeer_ode_ode_LIBRARY=")
        self.assertIn("peer/ode is not built: install the Debian package libode-dev, or it is NOT CHECKED", warning)
        self.assertEqual((self.peers / "absent.txt").read_text(), "".join(f"{name}\tlibode-dev\n" for name in ODE))
        self.assertFalse((self.peers / "ode.so").exists())
        self.assertIn("moving-sphere/peer/ode-capsule is not built", warning)
        self.assertEqual(set(ODE) & set(built), set())
        self.assertLessEqual({"bullet", "moving-sphere/bullet-world"}, set(built))

    def test_with_all_packages_none_is_absent(self):
        _, built = self.configured()
        self.assertEqual((self.peers / "absent.txt").read_text(), "")
        self.assertIn("ode", built)

    def test_switched_off_none_is_left(self):
        _, built = self.configured("-DAXISCERT_PEERS=OFF")
        self.assertFalse(self.peers.exists())
        self.assertEqual(built, [])


if __name__ == "__main__":
    unittest.main()
