#!/usr/bin/env python3
"""An empty value, as an unset variable of a script leaves it: refused by every option and argument of every subcommand."""
import unittest
from concurrent.futures import ThreadPoolExecutor

from command import QUERY, Case, axiscert

BLANK = ("", " ", "\t", "{}")  # CLI11 reads the last as an empty list


def manual():
    """Each subcommand with its entries of `axiscert man`: names, and whether they take a value."""
    commands = {}
    for section in axiscert("man").stdout.replace("\\-", "-").split("\n.SH EXIT STATUS")[0].split("\n.SS ")[1:]:
        entries = [entry.splitlines()[0].split(" ") for entry in section.split("\n.TP\n.B ")[1:]]
        commands[section.splitlines()[0]] = [(words[0].split(","), len(words) > 1) for words in entries]
    return commands


class EmptyValuesCase(Case):
    def blank(self, args, *says):
        done = self.refused(*args, says=[*says, "as of an unset variable"])
        self.assertEqual((len(done.stderr.strip().splitlines()), done.stdout), (1, ""), (args, done.stderr))

    def check_every_option(self, in_each_form):
        """Every option and argument; with in_each_form by each of its names, as a word of its own and after =, else in one of these by turns."""
        asked = []
        for command, entries in manual().items():
            head = command.split(" ")
            for names, has_value in entries:
                if not names[0].startswith("-"):
                    if (command, names[0]) != ("shrink", "KERNEL"):  # whose QUERY takes every word that is no kernel
                        asked.append(([*head, ""], f"axiscert {command}: {names[0]}: an empty value"))
                    head.append("x")  # for the arguments after it
                    continue
                says = f"axiscert {command}: {max(names, key=len)}: an empty value"
                forms = []
                for name in names:
                    if has_value:
                        forms.append(([*head, name, ""], says))
                    if name.startswith("--") and name != "--help":
                        forms.append(([*head, f"{name}="], says))
                asked += forms if in_each_form or not forms else [forms[len(asked) % len(forms)]]
        options = {says for _, says in asked}
        self.assertGreater(len(options), 200)
        self.assertIn("axiscert certify: --key: an empty value", options)
        self.assertIn("axiscert corpus add: FILE: an empty value", options)
        with ThreadPoolExecutor(4) as pool:
            list(pool.map(lambda each: self.blank(*each), asked))


class EmptyValuesLong(EmptyValuesCase):
    def test_every_option_and_argument_of_every_subcommand_in_each_form(self):
        self.check_every_option(True)


class EmptyValues(EmptyValuesCase):
    def test_every_option_and_argument_of_every_subcommand(self):
        self.check_every_option(False)

    def test_each_way_to_be_empty(self):
        for command, option in (("run", "--ratchet"), ("run", "--seed"), ("run", "--preset"), ("certify", "--key"), ("generate", "-o")):
            says = f"axiscert {command}: {option if option != '-o' else '--out-file'}: an empty value"
            for blank in BLANK:
                self.blank([command, option, blank], says)
                self.blank([command, option + "=" + blank], says)
            self.blank([command, option, "x", option, ""], says)
            for after in ("x", "--quiet"):
                self.blank([command, option + "=", after], says)

    def test_what_would_be_right_is_said(self):
        for args, says in ((["certify", "--kernel", "published", "--key", ""], "give one, or leave the option out: private Ed25519 key in PEM"),
                           (["check", ""], "axiscert check: FILE: an empty value, as of an unset variable; give one: query file"),
                           (["run", "--preset", ""], ", of {ci")):
            self.blank(args, says)

    def test_a_value_that_may_be_left_out_is_not_empty(self):
        for value in ([""], [" "]):
            self.blank(["run", "--corpus", *value, "--out", self.folder / "out"], "axiscert run: --corpus: an empty value")
        self.run_ok("--corpus", "--trials", 1, "--precision", "binary64")

    def test_a_list_and_a_word_that_nothing_takes(self):
        for args, says in ((["precision", "--bits", "8", ""], "axiscert precision: KERNEL: an empty value"),
                           (["compare", "a", "b", ""], "axiscert compare: KERNEL: an empty value"),
                           (["generate", "--binary", ""], "axiscert generate: an empty word after '--binary'"),
                           (["compare", "a", ""], "axiscert compare: NEW: an empty value"),
                           (["merge", "a", "", "b"], "axiscert merge: FOLDER: an empty value"),
                           (["run", "--quiet", ""], "axiscert run: KERNEL: an empty value"),
                           (["run", ""], "axiscert run: KERNEL: an empty value"),
                           (["generate", ""], "axiscert generate: an empty word after 'generate'"),
                           ([""], "axiscert: an empty word"), (["generate", "-o="], "--out-file: an empty value")):
            with self.subTest(args=args):
                self.blank(args, says)

    def test_the_parts_of_a_pair(self):
        for option in ("--tolerance", "--source", "--require"):
            for value in ("=3", "depth=", " =3", "depth= ", "="):
                self.blank(["run", option, value], f"axiscert run: {option}: an empty part in '{value.strip() if value == '=' else value}'")

    def test_an_empty_text_in_standard_input_is_no_empty_value(self):
        self.assertEqual(axiscert("check", "-", stdin=QUERY % 1).returncode, 0)


if __name__ == "__main__":
    unittest.main()
