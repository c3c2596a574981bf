#!/usr/bin/env python3
"""Shaders as kernels (shader.mjs): right ones answer as the processor's kernels do, but for flushing; faulty ones are told, each in its own
words. They run on SwiftShader. Where node, the package webgpu or SwiftShader is missing nothing is checked: exit code 77.

shaders_test.py AXISCERT [unittest arguments]
"""
import csv
import json
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent / "peers" / "npm"))
import asking  # noqa: E402

AXISCERT = Path(sys.argv.pop(1)).resolve()
CHROMIUM = Path(os.environ.get("AXISCERT_CHROMIUM", "/usr/lib/chromium"))
PUBLISHED = (FOLDER / "sphere-triangle" / "published.wgsl").read_text()
os.environ["AXISCERT_GPU"] = "software"


def missing():
    if shutil.which("node") is None:
        return "node"
    if not (FOLDER / "node_modules" / "webgpu").is_dir():
        return "the package webgpu"
    return None if (CHROMIUM / "vk_swiftshader_icd.json").exists() else f"SwiftShader in {CHROMIUM}"


class Shaders(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def axiscert(self, *words):
        return subprocess.run([AXISCERT, *map(str, words)], cwd=self.folder, capture_output=True, text=True, timeout=300)

    def judged(self, kernel, *words):
        """The record of a run."""
        done = self.axiscert("run", "--kernel", kernel, "--quiet", "--out", "out", *words)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        return json.loads((self.folder / "out" / "record.json").read_text())

    def shader(self, text, *question):
        """The id of a kernel that is this shader."""
        (self.folder / "mine.wgsl").write_text(text)
        manifest = {"format": "axiscert-program/2", "name": "mine", "command": ["node", str(FOLDER / "shader.mjs"), "mine.wgsl", *question],
                    "precisions": ["binary32"]}
        (self.folder / "mine.json").write_text(json.dumps(manifest))
        return "program:mine.json"

    def told(self, text, *words, family="general"):
        """What axiscert says of a run of this shader, and its exit code."""
        done = self.axiscert("run", "--kernel", self.shader(text), "--family", family, "--trials", 1500, "--out", "out", *words)
        return done.stdout + done.stderr, done.returncode

    def answers(self, text, queries):
        (self.folder / "mine.wgsl").write_text(text)
        return asking.ask(["node", str(FOLDER / "shader.mjs"), "mine.wgsl"], self.folder, queries)


class Right(Shaders):
    def test_reduced_and_published_answer_as_the_processor_that_flushes(self):
        for name in ("published", "reduced-nonstrict"):
            with self.subTest(name):
                queries, replies = self.folder / "queries", self.folder / "replies"
                families = [word for family in ("general", "tangent", "scale", "needle", "speck") for word in ("--family", family)]
                self.axiscert("generate", "--binary", *families, "--trials", 20000, "-o", queries)
                with open(queries) as sent, open(replies, "w") as got:
                    subprocess.run(["node", FOLDER / "shader.mjs", FOLDER / "sphere-triangle" / f"{name}.wgsl"], stdin=sent, stdout=got,
                                   stderr=subprocess.DEVNULL, check=True, timeout=300)
                differ = {}
                for kernel in (name, f"{name}+ftz"):
                    self.axiscert("judge", replies, "--conforms-to", kernel, "--out", kernel)
                    record = json.loads((self.folder / kernel / "record.json").read_text())
                    families = record["kernels"][0]["families"]
                    self.assertEqual(len(families), 5)
                    differ[kernel] = sum(family["verdict"]["links"]["implementation"] + family["verdict"]["masked_links"]["implementation"]
                                         for family in families.values())
                self.assertGreater(differ[name], 0)  # flushing is seen
                self.assertEqual(differ[f"{name}+ftz"], 0)

    def test_where_nothing_is_rounded_every_shader_answers_as_the_kernel_of_its_name(self):
        for file in sorted(FOLDER.glob("*-*/*.json")):
            with self.subTest(f"{file.parent.name}/{file.stem}"):
                prefix = "" if file.parent.name == "sphere-triangle" else f"{file.parent.name}/"
                record = self.judged(f"program:{file}", "--kernel", prefix + file.stem.removesuffix("-kept"), "--precision", "binary32",
                                     "--family", f"{prefix}lattice", "--trials", 4000)
                wrong = []
                for kernel in record["kernels"]:
                    [family] = kernel["families"].values()
                    self.assertEqual(family["trials"], 4000)
                    wrong.append({kind: family["verdict"][kind] for kind in ("false_separation", "false_contact", "deepest", "unanswered")})
                self.assertEqual(wrong[0], wrong[1])
                self.assertEqual(record["findings"], [])

    def test_answers_are_within_what_wgsl_permits(self):
        for name in ("published", "reduced-nonstrict", "moving-sphere/twenty-nonstrict"):
            file = FOLDER / f"{name if '/' in name else 'sphere-triangle/' + name}.json"
            family = ["--predicate", "moving-sphere", "--family", "moving-sphere/graze"] if "/" in name else ["--family", "tangent"]
            first = json.loads(self.axiscert("generate", *family, "--trials", 1).stdout)["id"]
            kernels = [f"program:{file}", f"{name}+wgsl-misses", f"{name}+wgsl-invents"]
            done = self.axiscert("check", f"{first}-299", *[word for kernel in kernels for word in ("--kernel", kernel)], "--format", "csv")
            rows = list(csv.DictReader(done.stdout.splitlines()))
            verdict = {(row["address"], row["kernel"]): row["computed.verdict"] for row in rows}
            shader = {address: said for (address, kernel), said in verdict.items() if kernel == kernels[0]}
            self.assertEqual((len(shader), len(rows)), (300, 900), done.stderr)
            for address, said in shader.items():
                within = kernels[1] if said == "separated" else kernels[2]
                self.assertEqual(verdict[address, within], said, f"{name}: {address}")

    def test_what_is_behind_a_barrier_is_computed_as_it_stands(self):
        text = "fn separated(a: vec3f, b: vec3f, c: vec3f, p: vec3f, r: f32) -> u32 { return u32((%s) + p.x == a.x); }"
        queries = [[1 + i / 1024 + 2**-20, 0, 0, 1, 0, 0, 0, 1, 0, 4096, 0, 0, 1] for i in range(100)]

        def rounded(x):
            return struct.unpack("f", struct.pack("f", x))[0]

        expected = ["separated" if rounded(rounded(q[0] - q[9]) + q[9]) == rounded(q[0]) else "contact" for q in queries]
        self.assertEqual(self.answers(text % "axiscert_kept(a.x - p.x)", queries), expected)
        # Without it the compiler takes (x - y) + y for x, as it may.
        self.assertEqual(self.answers(text % "a.x - p.x", queries), ["separated"] * len(queries))
        self.assertNotEqual(expected, ["separated"] * len(queries))


    def test_the_probe_says_what_the_page_says_of_swiftshader(self):
        said = subprocess.run(["node", FOLDER / "probe.mjs"], capture_output=True, text=True, check=True, timeout=300).stdout
        answers = {line[:40].strip(): line[41:] for line in said.splitlines()}
        page = (FOLDER.parents[1] / "docs" / "gpu.md").read_text()
        self.assertRegex(answers["device"], "swiftshader")
        for question, answer, row in (("the error of a sum, by two-sum", "kept", "| the error of a sum, by two-sum | kept |"),
                                      ("x y + x z", "factored", "| `x * y + x * z` | `x * (y + z)` |"), ("(x / y) y", "cancelled", "| `(x / y) * y` | `x` |"),
                                      ("(x - y) + y", "x", "| `(x - y) + y` | `x` |"), ("x y + z", "two roundings", "| `x * y + z`, `fma(x, y, z)` | two roundings |"),
                                      ("a subnormal times 1", "flushed", "| subnormal operands and results | 0 |"), ("NaN != NaN", "no", "| `x != x` of NaN | false |")):
            self.assertEqual(answers[question], answer)
            self.assertIn(row, page)
        self.assertEqual(answers["the same behind a barrier"], "as written")


class Told(Shaders):
    def test_a_planted_fault_is_found(self):
        said, code = self.told(PUBLISHED.replace("opposite * e - Q", "opposite * e + Q"), "--require", "logic", family="lattice")
        self.assertEqual(code, 1, said)
        self.assertRegex(said, r"program:mine.json binary32: 1,500 queries that nothing rounds: [1-9].* contacts (missed|invented)")

    def test_what_does_not_compile_is_told_with_line_and_column(self):
        said, code = self.told(PUBLISHED.replace("let rr = r * r;", "let rr = r * s;"))
        line = PUBLISHED.split("let rr = r * r;")[0].count("\n") + 1
        self.assertIn(f"mine.wgsl:{line}:16: unresolved value 's'", said)
        self.assertEqual(code, 2)

    def test_a_function_of_another_form_is_told_the_right_one(self):
        for text in (PUBLISHED.replace("p: vec3f, r: f32", "r: f32, p: vec3f"), PUBLISHED.replace("fn separated", "fn touching"), ""):
            said, code = self.told(text)
            self.assertIn("mine.wgsl does not fit what calls it: ", said)
            self.assertIn("its function is to be fn separated(vec3f, vec3f, vec3f, vec3f, f32) -> u32", said)
            self.assertEqual(code, 2)

    def test_a_loop_without_end_is_a_hang(self):
        said, code = self.told(PUBLISHED.replace("let rr = r * r;", "var rr = r * r; loop { rr += 1.0; if (rr < 0.0) { break; } }"))
        self.assertRegex(said, r"hang: no answer within [0-9.]+ s")
        self.assertEqual(code, 1)

    def test_a_value_that_is_no_verdict_is_told(self):
        said, _ = self.told(PUBLISHED.replace("return u32(", "return 7u * u32("))
        self.assertRegex(said, r"query [0-9]+: '7' is not a verdict")

    def test_more_memory_than_the_device_has_is_told(self):
        said, code = self.told("var<workgroup> much: array<f32, 60000>;\n" + PUBLISHED.replace("r * r;", "r * r * (1.0 + 0.0 * much[u32(r)]);"))
        self.assertIn("mine.wgsl compiles, but not into a pipeline of this device: ", said)
        self.assertIn("workgroup storage", said)
        self.assertEqual(code, 2)

    def test_without_a_device_nothing_is_judged(self):
        id = self.shader(PUBLISHED)
        for wish, why in (("hardware", "no GPU adapter: Vulkan offers none"), ("software", "/nowhere/vk_swiftshader_icd.json is not there; ./dev gpu brings it")):
            environment = {**os.environ, "AXISCERT_GPU": wish, "AXISCERT_CHROMIUM": "/nowhere", "VK_DRIVER_FILES": "/nowhere"}
            done = subprocess.run([AXISCERT, "run", "--kernel", id, "--family", "general", "--trials", "100"], cwd=self.folder, env=environment,
                                  capture_output=True, text=True, timeout=300)
            self.assertIn("NOT CHECKED: no GPU adapter", done.stderr)
            self.assertIn(why, done.stderr)
            self.assertEqual((done.returncode, done.stdout), (2, ""))


    def test_a_manifest_that_names_its_device_is_asked_on_no_other(self):
        for device, code in (("SwiftShader", 0), ("GeForce", 2)):
            done = self.axiscert("run", "--kernel", self.shader(PUBLISHED, "sphere-triangle", device), "--family", "general", "--trials", "100")
            self.assertEqual(done.returncode, code, done.stderr)
        self.assertRegex(done.stderr, "NOT CHECKED: the GPU adapter is 'google, swiftshader.*', not GeForce")


class Manifests(unittest.TestCase):
    def test_each_shader_has_one_that_says_what_is_installed(self):
        package = json.loads((FOLDER / "package.json").read_text())["dependencies"]
        lock = json.loads((FOLDER / "package-lock.json").read_text())["packages"]
        self.assertEqual({file.with_suffix("") for file in FOLDER.glob("*-*/*.wgsl")}, {file.with_suffix("") for file in FOLDER.glob("*-*/*.json")})
        for file in FOLDER.glob("*-*/*.json"):
            manifest = json.loads(file.read_text())
            self.assertEqual((manifest["name"], manifest["predicate"]), (f"wgsl/{file.stem}", file.parent.name))
            self.assertEqual(package[manifest["package"]], manifest["version"])
            self.assertEqual(lock[f"node_modules/{manifest['package']}"]["version"], manifest["version"])


if __name__ == "__main__":
    if missing():
        print(f"NOT CHECKED: {missing()} is not there; `./dev gpu` brings it", file=sys.stderr)
        sys.exit(77)
    unittest.main()
