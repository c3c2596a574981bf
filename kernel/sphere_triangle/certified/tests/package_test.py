#!/usr/bin/env python3
"""The library as a user takes it. Package: installed and moved elsewhere, found by CMake and by pkg-config, used from C and C++; and
the Debian packages, unpacked. Both: the lines of docs/certified.md that link it. Included: by FetchContent and by add_subdirectory, shared and static, and the static one installed.
Usage: package_test.py BUILD_FOLDER Package|Included"""
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BUILD = Path(sys.argv.pop(1)).resolve()
ROOT = Path(__file__).resolve().parents[4]
EXAMPLE = ROOT / "examples" / "certified"
VERSION = re.search(r"^CMAKE_PROJECT_VERSION:STATIC=(\S+)$", (BUILD / "CMakeCache.txt").read_text(), re.M)[1]
TOUCHES = "touching, closed sphere: contact\ntouching, open sphere: separated\nan ulp smaller: separated\n"
HITS = "3\n4\n"
CONTACT = """contact: face, separation -0.25, point 1 1 0, normal 0 0 1
contact: edge AB, separation 0, point 2 0 0, normal 0 -0.6 0.8
separated: vertex B, separation 3, point 4 0 0, normal 0.6 -0.8 0
contact: face, separation -1, point 1 2 0, normal 0 0 1 (chosen)
"""
SAID = {"touches": TOUCHES, "contact": CONTACT, "hits": HITS}


# The fences of these lines in the page are marked as held by this test.
LINES = [line for fence in re.findall(r"<!-- held by kernel/sphere_triangle/certified/tests/package_test.py -->\n```\n(.*?)```",
                                      (ROOT / "docs/certified.md").read_text(), re.DOTALL) for line in fence.splitlines()]


def run_lines(lines, folder, **places):
    """Runs the lines of the page in a folder in which the tree and these places have the names that the page gives them."""
    for name, place in {"kernel": ROOT / "kernel", "examples": ROOT / "examples", **places}.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).symlink_to(place)
    for line in lines:
        program = re.search(r" -o (\w+)", line)[1]
        done("bash", "-c", line, cwd=folder)
        assert done(folder / program) == SAID[program], line
        (folder / program).unlink()


def done(*command, **options):
    result = subprocess.run([*map(str, command)], capture_output=True, text=True, timeout=600, **options)
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
        self.assertEqual({program: done(build / program) for program in SAID}, SAID)

    def test_by_pkg_config_in_strict_c99_and_cpp17(self):
        environment = {**os.environ, "PKG_CONFIG_PATH": str(self.prefix / "lib/pkgconfig"),
                       "LD_LIBRARY_PATH": str(self.prefix / "lib")}
        flags = done("pkg-config", "--cflags", "--libs", "axiscert", env=environment).split()
        for name, said in SAID.items():
            program = self.folder / name
            compiler, ending = (["c++", "-std=c++17"], "cpp") if name == "hits" else (["cc", "-std=c99"], "c")
            done(*compiler, "-pedantic-errors", "-Wall", "-Wextra", "-Werror", EXAMPLE / f"{name}.{ending}", "-o", program, *flags)
            self.assertEqual(done(program, env=environment), said)

    def test_the_lines_of_the_page_link_the_shared_library(self):
        lines = [line for line in LINES if "-laxiscert" in line]
        self.assertEqual(len(lines), 2)
        run_lines(lines, self.folder / "lines", **{"build/release": BUILD, "P": self.prefix})

    def test_it_exports_its_functions_and_needs_no_exact_library(self):
        library = self.prefix / "lib/libaxiscert.so"
        exported = {line.split()[-1] for line in done("nm", "--dynamic", "--defined-only", library).splitlines()}
        header = "".join((self.prefix / "include/axiscert" / name).read_text() for name in ("certified.h", "contact.h"))
        declared = set(re.findall(r"\b(axiscert_\w+_f(?:32|64)|axiscert_passed_self_check)\(", header))
        self.assertEqual(len(declared), 19)
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


# The example as it is, where find_package finds what FetchContent brings, or in a project that has axiscert as a folder.
OUTSIDE = """cmake_minimum_required(VERSION 3.25)
project(includes_axiscert LANGUAGES C CXX)
if(FOLDER)
  add_subdirectory(${FOLDER} ${CMAKE_BINARY_DIR}/_deps/axiscert-build)
  function(find_package)
  endfunction()
else()
  include(FetchContent)
  FetchContent_Declare(axiscert URL https://example.org/axiscert.tar.gz OVERRIDE_FIND_PACKAGE)
endif()
add_subdirectory(%s example)
axiscert_add_plugin(my_kernel %s)
""" % (EXAMPLE, ROOT / "examples/plugin/my_kernel.c")


class Included(unittest.TestCase):
    """One build folder, so that the library is compiled once."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        (cls.folder / "CMakeLists.txt").write_text(OUTSIDE)
        cls.build = cls.folder / "build"

    def included(self, *options):
        """Configured with these options, built, and run."""
        done("cmake", "-G", "Ninja", "-S", self.folder, "-B", self.build, "-DCMAKE_BUILD_TYPE=Debug",
             "-DCMAKE_CXX_FLAGS=-DHWY_COMPILE_ONLY_STATIC", *options)  # one instruction set: a fifth of the time
        done("cmake", "--build", self.build)
        self.assertEqual({program: done(self.build / "example" / program) for program in SAID}, SAID)
        self.assertTrue((self.build / "my_kernel.so").is_file())
        axiscert = self.build / "_deps/axiscert-build"
        self.assertEqual({path.name for path in axiscert.rglob("*.o")},
                         {f"{name}.cpp.o" for name in ("contact_forms", "contact_library", "exact_contact", "exact_only", "exact_step", "forms",
                                                       "library", "self_check")})
        self.assertIn("Total Tests: 0", done("ctest", "--test-dir", self.build, "-N"))
        return {path.name for path in axiscert.rglob("libaxiscert.*") if not path.is_symlink()}

    def test_by_fetch_content_static_and_by_add_subdirectory_shared(self):
        self.assertEqual(self.included(f"-DFETCHCONTENT_SOURCE_DIR_AXISCERT={ROOT}", "-DAXISCERT_INSTALL=ON"), {"libaxiscert.a"})
        self.static_installed()
        self.assertIn(f"libaxiscert.so.{VERSION}", self.included(f"-DFOLDER={ROOT}", "-DAXISCERT_INSTALL=OFF", "-DBUILD_SHARED_LIBS=ON"))

    def static_installed(self):
        prefix = self.folder / "prefix"
        done("cmake", "--install", self.build, "--component", "library", "--prefix", prefix)
        self.assertEqual({path.name for path in (prefix / "lib").glob("libaxiscert*")}, {"libaxiscert.a"})
        build = self.folder / "found"
        done("cmake", "-S", EXAMPLE, "-B", build, f"-DCMAKE_PREFIX_PATH={prefix}")
        done("cmake", "--build", build)
        self.assertEqual(done(build / "hits"), HITS)
        flags = done("pkg-config", "--static", "--cflags", "--libs", "axiscert",
                     env={**os.environ, "PKG_CONFIG_PATH": str(prefix / "lib/pkgconfig")}).split()
        done("cc", "-std=c99", EXAMPLE / "touches.c", "-o", self.folder / "touches", *flags)
        self.assertEqual(done(self.folder / "touches"), TOUCHES)
        lines = [line for line in LINES if "libaxiscert.a" in line]
        self.assertEqual(len(lines), 3)
        run_lines(lines, self.folder / "lines", **{"build/static": self.build / "_deps/axiscert-build", "S": prefix})


if __name__ == "__main__":
    unittest.main()
