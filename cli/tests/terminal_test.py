#!/usr/bin/env python3
"""The output on a terminal, and the manual page."""
import os
import pty
import re
import subprocess
import unittest

from command import BUILD, Case, axiscert


class Terminal(Case):
    def on_terminal(self, *args, **environment):
        """The text that the command writes to a terminal."""
        leader, follower = pty.openpty()
        env = {k: v for k, v in os.environ.items() if k != "NO_COLOR"} | {"TERM": "xterm"} | environment
        done = subprocess.Popen([BUILD / "axiscert", *map(str, args)], stdout=follower, stderr=follower, env=env)
        os.close(follower)
        text = b""
        while True:
            try:
                part = os.read(leader, 65536)
            except OSError:  # the end, on Linux
                break
            if not part:
                break
            text += part
        os.close(leader)
        self.assertEqual(done.wait(), 0)
        return text.decode()

    def test_colour_is_for_terminals_and_no_color_is_heard(self):
        run = ["run", "--family", "repeated", "--trials", "300", "--precision", "binary32", "--out", self.folder / "out"]
        self.assertIn("\x1b[33m  published", self.on_terminal(*run))
        for environment in ({"NO_COLOR": "1"}, {"TERM": "dumb"}):
            self.assertNotRegex(self.on_terminal(*run, **environment), r"\x1b\[3\dm")
        self.assertIn("\x1b[33m  published", self.on_terminal(*run, NO_COLOR=""))
        self.assertNotIn("\x1b", axiscert(*run).stdout)

    def test_quiet_says_nothing(self):
        run = ["run", "--family", "repeated", "--trials", "300", "--precision", "binary32", "--out", self.folder / "out"]
        self.assertEqual(self.on_terminal(*run, "--quiet"), "")
        table = [line for line in axiscert(*run).stdout.splitlines() if line.startswith("  ")]
        self.assertEqual(table[0].index("queries") + len("queries"), table[1].index(" 300 ") + 4, table)

    def test_the_manual_page_has_every_command_and_option(self):
        page = axiscert("man").stdout
        self.assertEqual((BUILD / "axiscert.1").read_text(), page, "the page that is installed")
        listed = axiscert("--help").stdout.split("Judge a kernel:")[1]
        commands = re.findall(r"^  ([a-z-]+) ", listed, re.M)
        self.assertIn("compare", commands)
        for command in commands:
            section = page.split(f".SS {command}\n".replace("-", "\\-"), 1)[1].split("\n.SS ")[0]
            for option in re.findall(r"^ +(?:-\w,)?(--[a-z-]+)", axiscert(command, "--help").stdout, re.M):
                self.assertIn(option.replace("-", "\\-"), section, command)
        self.assertNotIn(str(BUILD.parent), page)


if __name__ == "__main__":
    unittest.main()
