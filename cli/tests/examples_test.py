#!/usr/bin/env python3
"""The installed axiscert, moved elsewhere, as a user of find_package(axiscert) sees it: the examples build against it and
are judged by it."""
import ctypes
import json
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from command import BUILD, DIVISOR, ROOT, family

EXAMPLES = ROOT / "examples" / "plugin"
EXAMPLE_KERNELS = {"box_kernel": [32], "my_kernel": [32], "my_formulae": [32, 64]}
if DIVISOR == 1:  # a program without one cannot load a library with a sanitizer in it
    EXAMPLE_KERNELS["certified_plugin"] = [32, 64]


def done(*command):
    result = subprocess.run([*map(str, command)], capture_output=True, text=True, timeout=600)
    assert result.returncode == 0, f"{command}: {result.stdout}{result.stderr}"
    return result.stdout


def exported(library):
    """The names that a shared object exports."""
    return {line.split()[-1] for line in done("nm", "--dynamic", "--defined-only", library).splitlines()}


class Examples(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        done("cmake", "--install", BUILD, "--prefix", cls.folder / "first")
        cls.prefix = cls.folder / "moved"
        (cls.folder / "first").rename(cls.prefix)
        cls.plugins = cls.built(EXAMPLES)

    @classmethod
    def built(cls, source, *targets):
        """The plug-ins of the examples by name, built against the installed axiscert."""
        build = Path(tempfile.mkdtemp(dir=cls.folder))
        done("cmake", "-S", source, "-B", build, f"-DCMAKE_PREFIX_PATH={cls.prefix}")
        done("cmake", "--build", build, "--target", *(targets or ["all"]))
        return {file.stem: file for file in build.glob("*.so")}

    def installed(self, *arguments):
        return done(self.prefix / "bin" / "axiscert", *arguments)

    def judged(self, *kernels, families=("general", "tangent", "lattice", "repeated"), options=(), trials=max(4000 // DIVISOR, 2000)):
        out = Path(tempfile.mkdtemp(dir=self.folder))
        arguments = [part for kernel in kernels for part in ("--kernel", kernel)]
        arguments += [part for name in families for part in ("--family", name)]
        self.installed("run", *arguments, "--trials", trials, *options, "--out", out)
        return json.loads((out / "record.json").read_text())

    def test_installed_is_what_a_user_needs(self):
        for file in ("bin/axiscert", "libexec/axiscert/axiscert-plugin-host", "include/axiscert/plugin.h",
                     "lib/cmake/axiscert/axiscertConfig.cmake", "lib/cmake/axiscert/axiscertConfigVersion.cmake",
                     "include/axiscert/formulae.hpp", "include/axiscert/exact_number.hpp", "share/axiscert/schemas/ladder.schema.json",
                     "share/doc/axiscert/docs/start-c-kernel.md", "share/doc/axiscert/docs/plots/front-door.svg",
                     "share/doc/axiscert/examples/plugin/my_kernel.c", "lib/axiscert/faults/none.so", "share/doc/axiscert/README.md", "share/doc/axiscert/LICENSE",
                     "share/doc/axiscert/NOTICE"):
            self.assertTrue((self.prefix / file).is_file(), file)
        self.assertEqual((self.prefix / "include/axiscert/plugin.h").read_text(), (ROOT / "kernel/include/axiscert/plugin.h").read_text())

    def test_nothing_installed_names_the_build_or_the_first_place(self):
        for file in (self.prefix / "lib/cmake/axiscert").iterdir():
            for place in (BUILD, ROOT, self.folder / "first"):
                self.assertNotIn(str(place), file.read_text(), file.name)

    def test_plugins_that_come_along_are_installed(self):
        names = {kind: {file.stem for file in (self.prefix / "lib/axiscert" / kind).glob("*.so")}
                 for kind in ("peers", "faults")}
        self.assertEqual(names["faults"], {file.stem for file in (ROOT / "kernel/sphere_triangle/faults").glob("*.c")})
        self.assertEqual(names["peers"] != set(), any((BUILD / "peers").glob("*.so")))

    def test_programs_that_come_along_are_installed_without_the_engines(self):
        here, there = ROOT / "kernel/peers/npm", self.prefix / "lib/axiscert/peers/npm"
        wanted = {file.relative_to(here) for files in ("package*.json", ".npmrc", "engines/**/*.mjs", "*-*/*.json") for file in here.glob(files)}
        self.assertEqual({file.relative_to(there) for file in there.rglob("*") if file.is_file()}, wanted)

    def test_an_installed_engine_names_the_command_that_brings_its_package(self):
        refused = subprocess.run([self.prefix / "bin/axiscert", "kernels", "--kernel", "peer/jolt/mesh"], capture_output=True, text=True)
        self.assertEqual(refused.returncode, 2)
        self.assertIn(f"`npm ci --ignore-scripts --prefix {(self.prefix / 'lib/axiscert/peers/npm').resolve()}`", refused.stderr)

    def test_an_example_exports_its_kernels_and_nothing_else(self):
        for name, precisions in EXAMPLE_KERNELS.items():
            with self.subTest(name=name):
                self.assertEqual(exported(self.plugins[name]), {"axiscert_plugin"})
                kernel = ctypes.CDLL(str(self.plugins[name])).axiscert_plugin
                kernel.argtypes, kernel.restype = [ctypes.c_uint32], ctypes.POINTER(ctypes.c_uint32)
                told = [kernel(i) for i in range(len(precisions) + 1)]
                self.assertEqual([(entry[0], entry[1]) for entry in told[:-1]], [(3, bits) for bits in precisions])
                self.assertFalse(told[-1], "null after the last kernel")

    def test_the_one_query_example_is_right_where_nothing_is_rounded(self):
        own = f"plugin:{self.plugins['my_kernel']}"
        record = self.judged(own, families=("general", "lattice", "repeated"), options=("--require", "logic"))
        self.assertEqual(record["findings"], [])
        self.assertEqual({kernel["precision"] for kernel in record["kernels"]}, {"binary32"})
        self.assertIsNone(family(record, "lattice", kernel=own)["comparisons"], "it shows verdicts only")

    def changed(self, file, changes, *targets):
        """Plug-ins of the examples with these changes to a file."""
        source = Path(tempfile.mkdtemp(dir=self.folder)) / "changed"
        shutil.copytree(EXAMPLES, source)
        text = (source / file).read_text()
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new)
        (source / file).write_text(text)
        return self.built(source, *targets)

    def formulae(self, *changes):
        """The ids of the formulae with these changes, in floats and in exact arithmetic."""
        names = ("my_formulae", "my_formulae-exact")
        plugins = self.changed("my_formulae.cpp", changes, *names) if changes else self.plugins
        return [f"plugin:{plugins[name]}" for name in names]

    def wrong(self, record, kernel, names):
        """(missed, phantom) contacts of a kernel in binary32, by family."""
        verdicts = {name: family(record, name, "binary32", kernel)["verdict"] for name in names}
        return {name: {kind: verdict[kind] or 0 for kind in ("false_separation", "false_contact")} for name, verdict in verdicts.items()}

    FORMULAE_FAMILIES = ("tangent", "lattice", "repeated", "scale")

    def formulae_judged(self, kernels):
        """In binary32: a run looks for the window of a kernel, which takes exact arithmetic nine seconds in binary64."""
        record = self.judged(*kernels, families=self.FORMULAE_FAMILIES, options=("--precision", "binary32"), trials=1000)
        self.assertEqual(record["findings"], [])
        self.assertEqual(len(record["kernels"]), len(kernels))
        return record

    def test_formulae_of_ones_own_are_judged_in_exact_arithmetic(self):
        rounded, exact = self.formulae()
        record = self.formulae_judged([rounded, exact])
        # `precision` evaluates the built-in formulae of the same predicate exactly, by other code.
        options = [part for name in self.FORMULAE_FAMILIES for part in ("--family", name)]
        known = json.loads(self.installed("precision", "--kernel", "published", *options, "--trials", 1000, "--bits", 24, "--format", "json"))
        mine = self.wrong(record, exact, self.FORMULAE_FAMILIES)
        self.assertEqual(mine, {name: known["families"][name]["kernels"]["published"]["exact"] for name in self.FORMULAE_FAMILIES})
        self.assertGreater(mine["repeated"]["false_contact"], 100, "its comparisons are strict")
        self.assertEqual(mine["scale"], {"false_separation": 0, "false_contact": 0})
        self.assertGreater(self.wrong(record, rounded, ["scale"])["scale"]["false_contact"], 0, "it over- and underflows")

    def test_formulae_that_are_right_are_right_in_exact_arithmetic_alone(self):
        rounded, exact = self.formulae(("dot(a, b) > aa && dot(a, c) > aa", "dot(a, b) >= aa && dot(a, c) >= aa"),
                                        ("nearest) > T(0)", "nearest) >= T(0)"))
        record = self.formulae_judged([rounded, exact])
        nothing = {"false_separation": 0, "false_contact": 0}
        self.assertEqual(self.wrong(record, exact, self.FORMULAE_FAMILIES), dict.fromkeys(self.FORMULAE_FAMILIES, nothing))
        self.assertNotEqual(self.wrong(record, rounded, ["tangent"])["tangent"], nothing, "it rounds")
        queries = self.folder / "binary64.jsonl"
        self.installed("generate", *(f"--family={name}" for name in self.FORMULAE_FAMILIES), "--trials", 200, "--precision", "binary64", "-o", queries)
        flips = {kernel: sum(json.loads(line)["flips"] != [] for line in self.installed("check", queries, "--kernel", kernel, "--format", "jsonl").splitlines())
                 for kernel in (rounded, exact)}
        self.assertTrue(flips[rounded] > 0 == flips[exact], flips)

    def test_a_division_by_zero_is_undecided_in_exact_arithmetic(self):
        _, exact = self.formulae(("if (d * d > dot(normal, normal) * rr) return true;", "if (d * d / dot(normal, normal) > rr) return true;"))
        record = self.formulae_judged([exact, "published"])
        self.assertGreater(family(record, "repeated", "binary32", exact)["verdict"]["undecided"], 100)

    def test_without_cmake_two_lines_build_them(self):
        source, include = EXAMPLES / "my_formulae.cpp", f"-I{self.prefix / 'include'}"
        warnings = ["-std=c++17", "-pedantic-errors", "-Wall", "-Wextra", "-Werror"]
        done("c++", *warnings, "-O2", "-ffp-contract=off", "-shared", "-fPIC", include, source, "-o", self.folder / "mine.so")
        done("c++", *warnings, "-O2", "-shared", "-fPIC", "-DAXISCERT_FORMULAE_EXACT", include, source, "-o", self.folder / "mine-exact.so", "-lgmp")
        for name in ("mine", "mine-exact"):
            listed = self.installed("kernels", "--kernel", f"plugin:{self.folder / name}.so")
            self.assertIn("binary32 binary64", listed)
            self.assertEqual("in exact arithmetic" in listed, name == "mine-exact")

    @unittest.skipUnless("certified_plugin" in EXAMPLE_KERNELS, "the library is sanitized")
    def test_the_library_is_exact_as_a_plugin_too(self):
        own = f"plugin:{self.plugins['certified_plugin']}"
        record = self.judged(own, families=("all",), options=("--require", "exact"))
        self.assertEqual(record["findings"], [])
        self.assertEqual({kernel["precision"] for kernel in record["kernels"]}, {"binary32", "binary64"})
        self.assertEqual(family(record, "nonfinite", kernel=own)["verdict"]["unanswered"], 0)

    def test_a_fault_in_the_one_query_example_is_found(self):
        own = f"plugin:{self.changed('my_kernel.c', [('ca = to_segment(C, A)', 'ca = to_segment(B, A)')], 'my_kernel')['my_kernel']}"
        verdict = family(self.judged(own, families=("lattice",)), "lattice", kernel=own)["verdict"]
        self.assertGreater(verdict["false_separation"], 0)

    def test_each_fault_that_comes_along_is_the_implementation_and_the_control_is_not(self):
        faults = sorted(file.stem for file in (self.prefix / "lib/axiscert/faults").glob("*.so"))
        record = self.judged(*(f"fault/{name}" for name in faults), families=("general", "lattice", "tie"))
        self.assertEqual({(finding["kernel"], finding["kind"]) for finding in record["findings"]}, {("fault/inverted", "exchanged")})
        for kernel in record["kernels"]:
            verdicts = [result["verdict"] for result in kernel["families"].values()]
            broken = sum(verdict["links"]["implementation"] for verdict in verdicts)
            self.assertEqual(broken == 0, kernel["id"] == "fault/none", (kernel["id"], kernel["precision"], broken))

    def test_contraction_is_off_unless_asked_for(self):
        """g++ fuses a * b + c by default where the target can."""
        source = self.folder / "contracted"
        shutil.copytree(EXAMPLES, source)
        lists = (source / "CMakeLists.txt").read_text()
        fused = {}
        for name, option in (("off", "-mfma"), ("fast", "-mfma -ffp-contract=fast")):
            (source / "CMakeLists.txt").write_text(f"{lists}target_compile_options(my_kernel PRIVATE {option})\n")
            fused[name] = "vfmadd" in done("objdump", "-d", self.built(source, "my_kernel")["my_kernel"])
        self.assertEqual(fused, {"off": False, "fast": True})


if __name__ == "__main__":
    unittest.main()
