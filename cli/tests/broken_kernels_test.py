#!/usr/bin/env python3
"""A kernel that is not fit to be asked is named by every command that takes one: on the first line of standard error, before any table, with
what was given and what would be right."""
import json
import subprocess
import unittest

from command import BUILD, DIVISOR, ROOT, Case, axiscert

QUERY = '{"id":"q","precision":"binary32","a":[2,0,0],"b":[3,0,0],"c":[2,1,0],"p":[0,0,0],"r":1}\n'
QUICK = ("--plugin-seconds", "0.2")
# Each command over the kernel K, the query file Q and a folder of its own, O.
COMMANDS = {
    "run": "run --kernel K --family general --trials 300 --precision binary32 --out O",
    "check": "check Q --kernel K",
    "diagnose": "diagnose K",
    "certify": "certify K --effort smoke --time 0.1 --out O",
    "league": "league --kernel K --family general --trials 64 --precision binary32",
    "critical-radius": "critical-radius --kernel K --family general --trials 10",
    "search": "search --kernel K --evaluations 1000",
    "shrink": "shrink Q --kernel K",
    "map": "map Q --kernel K --size 16 --out O",
}
LISTS = "kernels --kernel K"
NO_HEADER = """import struct, sys
read, write = sys.stdin.buffer.read, sys.stdout.buffer.write
while head := read(64):
    count, = struct.unpack_from("<Q", head, 16)
    size, record = struct.unpack_from("<II", head, 24)
    read(size - 64 + count * record)
    write(bytes(16) * count)
    sys.stdout.flush()
"""


class BrokenKernels(Case):
    def setUp(self):
        super().setUp()
        (self.folder / "q.jsonl").write_text(QUERY)

    def first_line(self, command, kernel):
        """Of standard error. Where the kernel can be asked, the command may go on; standard output comes after."""
        places = {"K": kernel, "Q": self.folder / "q.jsonl", "O": self.folder / "out"}
        done = axiscert(*(places.get(word, word) for word in command.split()), *(() if command == LISTS else QUICK))
        self.assertNotIn("terminate called", done.stderr)
        return (done.stderr.splitlines() or [""])[0]

    def misbehaving(self, name):
        return f"plugin:{BUILD}/misbehaving/{name}.so"

    def file(self, name, bytes):
        (self.folder / name).write_bytes(bytes)
        return f"plugin:{self.folder / name}"

    def program(self, name, *command):
        (self.folder / f"{name}.json").write_text(json.dumps(
            {"format": "axiscert-program/2", "name": name, "command": command, "precisions": ["binary32"]}))
        return f"program:{self.folder / name}.json"

    def no_header(self):
        (self.folder / "no_header.py").write_text(NO_HEADER)
        return self.program("no_header", "/usr/bin/python3", "no_header.py")

    def names_each(self, kinds):
        for name, command in COMMANDS.items():
            for kernel, says in kinds.items():
                with self.subTest(command=name, kernel=kernel):
                    first = self.first_line(command, kernel)
                    self.assertIn(kernel, first)
                    self.assertIn(says, first)
                    subprocess.run(["rm", "-rf", self.folder / "out"], check=True)

    def test_every_command_names_a_file_of_text(self):
        self.names_each({self.file("text.so", b"this is text\n"): 'it is no shared object, but begins with the text "this is text"'})

    def test_each_kind_is_named(self):
        whole = (BUILD / "misbehaving/exchanged.so").read_bytes()
        other = "64-bit ARM" if whole[18] != 0xb7 else "x86-64"
        machine = b"\xb7\x00" if other == "64-bit ARM" else b"\x3e\x00"
        narrow = "compile it without -m32" if other == "64-bit ARM" else "32-bit"
        (self.folder / "script").write_text("#!/no/such/interpreter -u\n")
        (self.folder / "script").chmod(0o755)
        program = f"{BUILD}/programs/program"
        kinds = {self.file("empty.so", b""): "it is empty: `cc -shared -fPIC my_kernel.c -o my_kernel.so` makes one",
                 self.file("cut.so", whole[:1000]): "it is cut short, after 1000 of ",
                 self.file("arm.so", whole[:18] + machine + whole[20:]): f"it is for {other}, and this axiscert for ",
                 self.file("narrow.so", whole[:4] + b"\1" + whole[5:]): narrow,
                 self.file("archive.so", b"!<arch>\n" + bytes(60)): "it is a static library",
                 self.file("object.so", whole[:16] + b"\1\0" + whole[18:]): "",
                 self.program("no_interpreter", "./script"): "begins with #!/no/such/interpreter, and that program is not there",
                 self.program("not_installed", "no-such-program"): "the program no-such-program is not installed",
                 self.program("prints", program, "text"): 'but with "engine 1.0 loaded"; messages belong on standard error',
                 self.program("changes", program, "wrong-header"): "it changed the header of its queries, at byte 40",
                 self.program("ends", program, "nothing"): "it ended with exit code 0",
                 self.program("fails", program, "fails"): "Error: Cannot find package 'engine'"}
        for kernel, says in kinds.items():
            for name in ("run", "check"):
                if not says:
                    continue
                with self.subTest(command=name, kernel=kernel):
                    self.assertIn(says, self.first_line(COMMANDS[name], kernel))

    def test_exchanged_verdicts_are_a_finding_that_fails_every_level(self):
        kernel = self.misbehaving("exchanged")
        done = axiscert("run", "--kernel", kernel, "--family", "general", "--trials", "300", "--require", "depth=1", "--out", self.folder / "out")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("exchanged: its verdicts are exchanged", done.stderr)
        self.assertIn("the values are in axiscert/plugin.h", done.stderr)

    def test_a_right_kernel_is_not_named(self):
        for kernel in (self.misbehaving("neighbour"), self.program("right", f"{BUILD}/programs/program", "right")):
            self.assertEqual(self.first_line(COMMANDS["check"], kernel), "")


class BrokenKernelsLong(BrokenKernels):
    """Kinds that are only known once a kernel is asked, which takes a second or more of each command."""

    def test_every_command_names_each_kind(self):
        self.names_each({self.misbehaving("exchanged"): "its verdicts are exchanged: it says contact (0)",
                         self.misbehaving("crash_always"): "crash: SIGSEGV (Segmentation fault) at a null pointer",
                         self.no_header(): "it did not begin with the header of its queries, copied unchanged"})


class FromCallToCall(Case):
    """What a kernel answers depends on the query alone."""

    def test_each_dependence_is_found_and_its_cause_named(self):
        causes = {"cached_axis": "keeps state from call to call", "state": "keeps state from call to call",
                  "neighbour": "its answer depends on its neighbour", "lane_leak": "its answer depends on its neighbour"}
        kernels = [part for name in causes for part in ("--kernel", f"plugin:{BUILD}/misbehaving/{name}.so")]
        record = self.run_ok(*kernels, "--precision", "binary32", "--trials", str(4096 // DIVISOR))
        for name, cause in causes.items():
            details = [finding["detail"] for finding in record["findings"] if finding["kernel"].endswith(f"/{name}.so")]
            self.assertTrue(any(cause in detail for detail in details), f"{name}: {details[:3]}")

    def test_right_kernels_have_no_finding_and_their_queries_are_counted(self):
        """A plug-in of the examples, and a peer; a built-in kernel is not asked again."""
        source = ROOT / "examples/plugin/my_kernel.c"
        mine = self.folder / "mine.so"
        subprocess.run(["cc", "-O2", "-ffp-contract=off", "-shared", "-fPIC", f"-I{ROOT}/kernel/include", source, "-o", mine], check=True)
        record = self.run_ok("--kernel", f"plugin:{mine}", "--kernel", "fault/none", "--kernel", "published", "--trials", "2048",
                             "--precision", "binary32", "--family", "general", "--family", "lattice")
        self.assertEqual(record["findings"], [])
        for kernel in record["kernels"]:
            for family in kernel["families"].values():
                self.assertEqual("asked_again" in family, kernel["id"] != "published")
                self.assertGreaterEqual(family.get("asked_again", 1024), 1024)


if __name__ == "__main__":
    unittest.main()
