#!/usr/bin/env python3
"""Shaders as kernels (shader.mjs): right ones answer as the processor's kernels do, but for flushing; faulty ones are told, each in its own
words. They run on SwiftShader. Where node, the package webgpu or SwiftShader is missing nothing is checked: exit code 77.

shaders_test.py AXISCERT [unittest arguments]
"""
import csv
import json
import os
import re
import struct
import subprocess
import unittest

from shader_case import AXISCERT, FOLDER, Shaders, main, missing_dawn, source

PUBLISHED = source("published")


class Right(Shaders):
    def test_reduced_and_published_answer_as_the_processor_that_flushes(self):
        for name in ("published", "reduced-nonstrict"):
            with self.subTest(name):
                differ = self.differing(name, ["node", FOLDER / "shader.mjs", FOLDER / "shaders" / f"{name}.wgsl"], (name, f"{name}+ftz"),
                                        ("general", "tangent", "scale", "needle", "speck"), 20000)
                self.assertGreater(differ[name], 0)  # flushing is seen
                self.assertEqual(differ[f"{name}+ftz"], 0)

    def test_where_nothing_is_rounded_every_shader_answers_as_the_kernel_of_its_name(self):
        for file in sorted(file for file in FOLDER.glob("shaders/*.json") if file.with_suffix(".wgsl").exists()):
            with self.subTest(file.stem):
                predicate = json.loads(file.read_text())["predicate"]
                prefix = "" if predicate == "sphere-triangle" else f"{predicate}/"
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
            file = FOLDER / f"shaders/{name.split('/')[-1]}.json"
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

    def test_without_barriers_it_is_told_what_these_save(self):
        done = self.axiscert("diagnose", self.shader(source("reduced-nonstrict")), "--out", "found")
        [said] = re.findall(r"^evaluation: flushed.*$", done.stdout, re.M)
        without, behind = map(float, re.search(r"as deep as (\S+) of the scene; .* behind barriers, (\S+) ", said).groups())
        self.assertTrue(without > 1e-3 > 1e-5 > behind, said)

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

    def ended(self, script):
        """What a process says that opens `published` and asks it once, after `script` has had the device."""
        (self.folder / "mine.mjs").write_text(f'''
import {{open}} from {json.dumps(str(FOLDER / "webgpu.mjs"))};
const answer = await open({{file: "mine.wgsl", text: {json.dumps(PUBLISHED)}, language: "wgsl", question: "sphere-triangle", device: ""}});
{script}
process.stdout.write("answered\\n");
process.exit(0);
''')
        done = subprocess.run(["node", "mine.mjs"], cwd=self.folder, capture_output=True, text=True, timeout=300)
        return done.stderr, done.stdout, done.returncode

    def test_a_lost_device_ends_the_program_and_answers_nothing(self):
        said, answered, code = self.ended("answer.lose(); await answer(new Float32Array(13 * 64)); await new Promise((done) => setTimeout(done, 5000));")
        self.assertRegex(said, "the device was lost|of the device: ")
        self.assertEqual((answered, code != 0), ("", True))
        _, answered, code = self.ended("await answer(new Float32Array(13 * 64));")
        self.assertEqual((answered, code), ("answered\n", 0))

    def test_a_batch_beyond_the_memory_of_the_device_is_told(self):
        said, answered, code = self.ended("await answer(new Float32Array(13 * (1 << 24)));")
        self.assertRegex(said, "(lack of memory|fault) of the device: ")
        self.assertEqual((answered, code != 0), ("", True))

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
        told = set()
        for file in FOLDER.glob("shaders/*.json"):
            manifest = json.loads(file.read_text())
            shader = file.parent / manifest["command"][2]
            told.add(shader)
            if shader.suffix == ".mjs":  # of a package that is asked
                wanted = json.loads((FOLDER.parent / "peers" / "npm" / "package.json").read_text())["dependencies"]
                self.assertEqual(wanted[manifest["package"]], manifest["version"])
                continue
            name = {".wgsl": "wgsl", ".glsl": "glsl", ".cl": "opencl"}[shader.suffix]
            self.assertEqual(manifest["name"], f"{name}/{shader.stem}")
            if name == "wgsl":
                self.assertEqual(package[manifest["package"]], manifest["version"])
                self.assertEqual(lock[f"node_modules/{manifest['package']}"]["version"], manifest["version"])
            for other in manifest["files"]:
                self.assertTrue((file.parent / other).exists(), other)
        self.assertEqual(told, {file for suffix in ("wgsl", "glsl", "cl", "mjs") for file in FOLDER.glob(f"shaders/*.{suffix}")})


if __name__ == "__main__":
    main(missing_dawn())
