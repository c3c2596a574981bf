#!/usr/bin/env python3
"""Shaders in GLSL, by glslang and Vulkan, and kernels of OpenCL C: right ones answer as the processor's kernels do or as their compilers may make
them; faulty ones are told, each in its own words. What is missing of a language is not checked; exit code 77 where both miss something.

languages_test.py AXISCERT [unittest arguments]
"""
import os
import re
import signal
import subprocess
import unittest
from pathlib import Path

from shader_case import CHROMIUM, FOLDER, Shaders, asking, main, missing_dawn, missing_native, source


def parent_of(process):
    """The id of the parent of a process in /proc; None where it is gone."""
    try:
        return int((process / "stat").read_text().rsplit(")", 1)[1].split()[1])
    except OSError:
        return None


class Language:
    """Tests of one language; `published` is its text of the published test."""

    def setUp(self):
        if missing_native(self.language):
            self.skipTest(f"NOT CHECKED: {missing_native(self.language)} is not there")
        super().setUp()
        self.published = source("published", self.language)

    def test_where_nothing_is_rounded_each_answers_as_the_kernel_of_its_name(self):
        for name in ("published", "reduced-nonstrict"):
            record = self.judged(f"program:{FOLDER}/shaders/{name}.{self.language}.json", "--kernel", name, "--precision", "binary32",
                                 "--family", "lattice", "--trials", 3000)
            of_shader, of_kernel = ([family["verdict"][kind] for kind in ("false_separation", "false_contact", "deepest", "unanswered")]
                                    for kernel in record["kernels"] for family in kernel["families"].values())
            self.assertEqual(of_shader, of_kernel, name)
            self.assertEqual(record["findings"], [])

    def test_a_planted_fault_is_found(self):
        said, code = self.told(self.published.replace("opposite * e - Q", "opposite * e + Q"), "--require", "logic", family="lattice")
        self.assertEqual(code, 1, said)
        self.assertRegex(said, r"program:mine.json binary32: 1,500 queries that nothing rounds: [1-9].* contacts (missed|invented)")

    def test_what_does_not_compile_is_told_with_its_line(self):
        said, code = self.told(self.published.replace("rr = r * r;", "rr = r * s;"))
        line = self.published.split("rr = r * r;")[0].count("\n") + 1
        self.assertRegex(said, rf"mine.{self.language}:{line}:.*(undeclared|'s')")
        self.assertEqual(code, 2)

    def test_a_function_of_another_form_is_told_the_right_one(self):
        text = self.published.replace("uint separated(", "uint touching(")
        said, code = self.told(text)
        self.assertIn(f"mine.{self.language} does not fit what calls it: ", said)
        self.assertIn("its function is to be uint separated(", said)
        self.assertEqual(code, 2)

    def test_a_device_whose_process_ends_is_told(self):
        asked = subprocess.Popen(["node", FOLDER / "shader.mjs", FOLDER / "shaders" / f"published.{self.language}"], cwd=self.folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE)
        self.addCleanup(asked.kill)
        # Once it has answered a stream of no query, the host is there.
        asked.stdin.write(asking.stream([]))
        asked.stdin.flush()
        asked.stdout.read(64)
        [host] = [int(entry.name) for entry in Path("/proc").iterdir() if entry.name.isdigit() and parent_of(entry) == asked.pid]
        os.kill(host, signal.SIGKILL)
        answered, said = asked.communicate(asking.stream([[1.0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0.25]] * 64), timeout=60)
        self.assertIn(b"the device's process ended by SIGKILL", said)
        self.assertLess(len(answered), 1000)  # of 1024 bytes of replies, and headers
        self.assertEqual(asked.returncode, 2)

    def test_what_is_behind_a_barrier_is_computed_as_it_stands(self):
        vector = {"glsl": "vec3", "cl": "float3"}[self.language]
        text = f"uint separated({vector} a, {vector} b, {vector} c, {vector} p, float r) {{ return (%s + p.x == a.x) ? 1u : 0u; }}"
        queries = [[1 + i / 1024 + 2**-20, 0, 0, 1, 0, 0, 0, 1, 0, 4096, 0, 0, 1] for i in range(100)]
        kept = self.answers(text % "axiscert_kept(a.x - p.x)", queries)
        self.assertEqual(kept, ["contact"] * len(queries))  # the last bits of a.x are lost

    def test_a_device_that_is_not_there_is_not_asked(self):
        done = self.axiscert("run", "--kernel", self.shader(self.published, "sphere-triangle", "GeForce"), "--family", "general", "--trials", "100")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertRegex(done.stderr, "NOT CHECKED: no .* device whose name has 'GeForce'; there is ")

    def test_without_its_host_nothing_is_judged(self):
        done = subprocess.run(["node", FOLDER / "shader.mjs", FOLDER / "shaders" / f"published.{self.language}"], stdin=subprocess.DEVNULL,
                              env={**os.environ, "AXISCERT_GPU_HOSTS": "/nowhere"}, capture_output=True, text=True, timeout=60)
        self.assertRegex(done.stderr, "NOT CHECKED: /nowhere/(vulkan|opencl)_host is not there; ./dev gpu builds it")
        self.assertEqual(done.returncode, 2)

    def hanging(self):
        return re.sub(r"(const )?float rr = r \* r;", "float rr = r * r; while (rr >= 0.0) { rr = rr + 1.0; if (rr < 0.0) break; }", self.published)


class Glsl(Language, Shaders):
    language = "glsl"

    def test_lavapipe_cuts_a_loop_without_end(self):
        said, _ = self.told(self.hanging())
        self.assertRegex(said, r"wrong on [0-9]+ of [0-9]+ separated spheres")

    def test_lavapipe_answers_as_the_processor(self):
        differ = self.differing("published", ["node", FOLDER / "shader.mjs", FOLDER / "shaders" / "published.glsl", "sphere-triangle", "llvmpipe"],
                                ("published",), ("general", "tangent", "scale", "far"), 10000)
        self.assertEqual(differ["published"], 0)


class OpenCl(Language, Shaders):
    language = "cl"

    def test_a_loop_without_end_is_a_hang(self):
        said, code = self.told(self.hanging())
        self.assertRegex(said, r"hang: no answer within [0-9.]+ s")
        self.assertEqual(code, 1)

    def test_pocl_contracts_published(self):
        differ = self.differing("published", ["node", FOLDER / "shader.mjs", FOLDER / "shaders" / "published.cl", "sphere-triangle", "portable"],
                                ("published",), ("tangent",), 4000)
        self.assertGreater(differ["published"], 20)


class Engines(Shaders):
    """Shaders of packages that `./dev engines` brings."""

    def setUp(self):
        super().setUp()
        if not asking.installed():
            self.skipTest("NOT CHECKED: the engines are not installed; `./dev engines` brings them")

    def test_three_mesh_bvh_misses_the_nearest_vertex(self):
        triangle, point = [0, 0, 0, 4, 0, 0, -6, 1, 0], [4, -1, 0]
        for language, missing in (("wgsl", missing_dawn()), ("glsl", missing_native("glsl"))):
            if not missing:
                queries = [[*triangle, *point, radius] for radius in (0.5, 1.5, 4, 4.25)]
                found = asking.ask(["node", "../shader.mjs", f"three-mesh-bvh.{language}.mjs"], FOLDER / "shaders", queries)
                # The distance is 1; that of the shader's point is between 4 and 4.25.
                self.assertEqual(found, ["separated", "separated", "separated", "contact"], language)

    @unittest.skipIf(missing_dawn(), missing_dawn())
    def test_the_program_of_its_text_prints_what_is_said(self):
        text = (FOLDER.parents[1] / "docs" / "upstream" / "three-mesh-bvh-shader-obtuse.md").read_text()
        program, printed = re.search(r"\n```js\n(.*?)\n```\n\nIt prints\n\n```\n(.*?)\n```\n", text, re.DOTALL).groups()
        (self.folder / "node_modules").mkdir()
        for folder, package in ((asking.FOLDER, "three"), (asking.FOLDER, "three-mesh-bvh"), (FOLDER, "webgpu")):
            (self.folder / "node_modules" / package).symlink_to(folder / "node_modules" / package)
        done = subprocess.run(["node", "--input-type=module"], cwd=self.folder, input=program, capture_output=True, text=True, timeout=300,
                              env={**os.environ, "LD_LIBRARY_PATH": str(CHROMIUM), "VK_ICD_FILENAMES": f"{CHROMIUM}/vk_swiftshader_icd.json"})
        self.assertEqual(done.stdout.strip(), printed, done.stderr)


class Probes(unittest.TestCase):
    def test_the_table_of_the_page_is_what_the_probes_say(self):
        page = (FOLDER.parents[1] / "docs" / "gpu.md").read_text()
        table = page.split("<!-- held by kernel/gpu/languages_test.py -->")[1].split("\n\n")[0].strip().splitlines()[2:]
        rows = {cells[0]: cells[1:] for cells in ([cell.strip() for cell in line.strip("|").split("|")] for line in table)}
        for column, words in enumerate((["wgsl"], ["glsl", "llvmpipe"], ["cl", "portable"], ["cl", "portable", "-cl-fast-relaxed-math"])):
            done = subprocess.run(["node", FOLDER / "probe.mjs", *words], capture_output=True, text=True, timeout=600)
            if "NOT CHECKED" in done.stderr:
                continue
            self.assertEqual(done.returncode, 0, done.stderr)
            answers = {line[:40].strip(): line[41:] for line in done.stdout.splitlines()}
            for question, cells in rows.items():
                self.assertEqual(answers[question.replace("`", "")].replace("of 262144 not the nearest float, error at most ", "not nearest, "), cells[column],
                                 f"{question} by {words}")
        self.assertGreater(len(rows), 12)


if __name__ == "__main__":
    main(missing_native("glsl") and missing_native("cl"))
