#!/usr/bin/env python3
"""The installed library as a user finds it: moved elsewhere, found by CMake and by pkg-config, used from C and C++; and
the Debian packages, unpacked. Usage: package_test.py BUILD_FOLDER"""
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BUILD = Path(sys.argv.pop(1)).resolve()
EXAMPLE = Path(__file__).resolve().parents[4] / "examples" / "certified"
VERSION = re.search(r"^CMAKE_PROJECT_VERSION:STATIC=(\S+)$", (BUILD / "CMakeCache.txt").read_text(), re.M)[1]
TOUCHES = "touching, closed sphere: contact\ntouching, open sphere: separated\nan ulp smaller: separated\n"
HITS = "3\n4\n"


def done(*command, **options):
    result = subprocess.run([*map(str, command)], capture_output=True, text=True, timeout=300, **options)
    assert result.returncode == 0, f"{command}: {result.stdout}{result.stderr}"
    return result.stdout


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        done("cmake", "--install", BUILD, "--component", "library", "--prefix", cls.folder / "first")
        cls.prefix = cls.folder / "moved"
        (cls.folder / "first").rename(cls.prefix)

    def test_an_outside_project_finds_it_by_cmake(self):
        build = self.folder / "cmake"
        done("cmake", "-S", EXAMPLE, "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}")
        done("cmake", "--build", build)
        self.assertEqual(done(build / "touches"), TOUCHES)
        self.assertEqual(done(build / "hits"), HITS)

    def test_by_pkg_config_in_strict_c99_and_cpp17(self):
        environment = {**os.environ, "PKG_CONFIG_PATH": str(self.prefix / "lib/pkgconfig"),
                       "LD_LIBRARY_PATH": str(self.prefix / "lib")}
        flags = done("pkg-config", "--cflags", "--libs", "axiscert", env=environment).split()
        for compiler, source, said in ((["cc", "-std=c99"], "touches.c", TOUCHES), (["c++", "-std=c++17"], "hits.cpp", HITS)):
            program = self.folder / source.split(".")[0]
            done(*compiler, "-pedantic-errors", "-Wall", "-Wextra", "-Werror", EXAMPLE / source, "-o", program, *flags)
            self.assertEqual(done(program, env=environment), said)

    def test_it_exports_its_functions_and_needs_no_exact_library(self):
        library = self.prefix / "lib/libaxiscert.so"
        exported = {line.split()[-1] for line in done("nm", "--dynamic", "--defined-only", library).splitlines()}
        header = (self.prefix / "include/axiscert/certified.h").read_text()
        declared = set(re.findall(r"\b(axiscert_\w+_f(?:32|64)|axiscert_passed_self_check)\(", header))
        self.assertEqual(len(declared), 11)
        self.assertEqual({name for name in exported if not name.startswith("_Z")}, declared)
        needed = set(re.findall(r"\(NEEDED\).*\[(.*?)\.so", done("readelf", "--dynamic", library)))
        self.assertLessEqual(needed, {"libhwy", "libstdc++", "libm", "libgcc_s", "libc", "ld-linux-x86-64"})

    def test_the_debian_packages_hold_it(self):
        done("cpack", "-G", "DEB", "-B", self.folder / "deb", "--config", BUILD / "CPackConfig.cmake",
             "-D", "CPACK_COMPONENTS_ALL=runtime;development")
        (runtime,) = (self.folder / "deb").glob("libaxiscert0_*.deb")
        (development,) = (self.folder / "deb").glob("libaxiscert-dev_*.deb")
        self.assertRegex(done("dpkg-deb", "--field", runtime, "Depends"), "libhwy")
        self.assertRegex(done("dpkg-deb", "--field", development, "Depends"), r"^libaxiscert0 \(= ")
        root = self.folder / "root"
        done("dpkg-deb", "--extract", runtime, root)
        self.assertEqual({file.name for file in root.rglob("libaxiscert.so*")}, {"libaxiscert.so.0", f"libaxiscert.so.{VERSION}"})
        done("dpkg-deb", "--extract", development, root)
        build = self.folder / "from_deb"
        done("cmake", "-S", EXAMPLE, "-B", build, f"-DCMAKE_PREFIX_PATH={root / 'usr'}")
        done("cmake", "--build", build)
        self.assertEqual(done(build / "hits"), HITS)


if __name__ == "__main__":
    unittest.main()
