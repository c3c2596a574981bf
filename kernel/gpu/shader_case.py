"""A test case that asks shaders (shader.mjs), for shaders_test.py and languages_test.py, whose first argument is axiscert."""
import json
import os
import shutil
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
HOSTS = Path(os.environ.get("AXISCERT_GPU_HOSTS", FOLDER.parents[1] / "build" / "gpu"))
os.environ["AXISCERT_GPU"] = "software"


def missing_dawn():
    if shutil.which("node") is None:
        return "node"
    if not (FOLDER / "node_modules" / "webgpu").is_dir():
        return "the package webgpu"
    return None if (CHROMIUM / "vk_swiftshader_icd.json").exists() else f"SwiftShader in {CHROMIUM}"


def missing_native(language):
    for program in ("node", "glslangValidator") if language == "glsl" else ("node",):
        if shutil.which(program) is None:
            return program
    host = HOSTS / {"glsl": "vulkan_host", "cl": "opencl_host"}[language]
    return None if host.exists() else str(host)


def main(missing):
    """Runs the calling script, or says what is missing and exits with 77."""
    if missing:
        print(f"NOT CHECKED: {missing} is not there; `./dev gpu` brings it", file=sys.stderr)
        sys.exit(77)
    unittest.main()


def source(name, language="wgsl"):
    return (FOLDER / "shaders" / f"{name}.{language}").read_text()


class Shaders(unittest.TestCase):
    language = "wgsl"

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
        file = f"mine.{self.language}"
        (self.folder / file).write_text(text)
        manifest = {"format": "axiscert-program/2", "name": "mine", "command": ["node", str(FOLDER / "shader.mjs"), file, *question],
                    "precisions": ["binary32"]}
        (self.folder / "mine.json").write_text(json.dumps(manifest))
        return "program:mine.json"

    def told(self, text, *words, family="general"):
        """What axiscert says of a run of this shader, and its exit code."""
        done = self.axiscert("run", "--kernel", self.shader(text), "--family", family, "--trials", 1500, "--out", "out", *words)
        return done.stdout + done.stderr, done.returncode

    def answers(self, text, queries):
        file = f"mine.{self.language}"
        (self.folder / file).write_text(text)
        return asking.ask(["node", str(FOLDER / "shader.mjs"), file], self.folder, queries)

    def differing(self, name, command, kernels, families, trials):
        """On how many queries a command answers otherwise than each of these kernels."""
        queries, replies = self.folder / "queries", self.folder / "replies"
        self.axiscert("generate", "--binary", *[word for family in families for word in ("--family", family)], "--trials", trials, "-o", queries)
        with open(queries) as sent, open(replies, "w") as got:
            subprocess.run(command, stdin=sent, stdout=got, stderr=subprocess.DEVNULL, check=True, timeout=300)
        differ = {}
        for kernel in kernels:
            self.axiscert("judge", replies, "--conforms-to", kernel, "--out", kernel)
            judged = json.loads((self.folder / kernel / "record.json").read_text())["kernels"][0]["families"]
            self.assertEqual(len(judged), len(families))
            differ[kernel] = sum((family["verdict"][links] or {}).get("implementation", 0) for family in judged.values() for links in ("links", "masked_links"))
        return differ
