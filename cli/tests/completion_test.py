#!/usr/bin/env python3
"""`axiscert completion`: each shell completes the words of the command line."""
import shutil
import subprocess
import unittest

from command import BUILD, Case, axiscert

BASH = """source "$1"; shift
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
compopt() { :; }
_axiscert
printf '%s\\n' "${COMPREPLY[@]}"
"""
# The words so far, and words that have to be among those offered, and that may not.
ASKED = [(["axiscert", "co"], {"compare", "condition", "corpus", "completion"}, {"run"}),
         (["axiscert", "run", "--pre"], {"--precision", "--preset"}, {"--kernel"}),
         (["axiscert", "run", "--kernel", "reduced-n"], {"reduced-nonstrict"}, {"published"}),
         (["axiscert", "run", "--kernel", "published", "--family", "scene"], {"scene-walk", "scene-edge"}, {"tangent"}),
         (["axiscert", "check", "--format", ""], {"text", "jsonl"}, {"--kernel"}),
         (["axiscert", "corpus", "a"], {"add"}, {"list"}),
         (["axiscert", "completion", ""], {"bash", "zsh", "fish"}, set()),
         (["axiscert", "explain", "dep"], {"depth"}, {"family"})]


class Completion(Case):
    def script(self, shell):
        done = axiscert("completion", shell)
        self.assertEqual(done.returncode, 0, done.stderr)
        path = self.folder / f"completion.{shell}"
        path.write_text(done.stdout)
        return path

    def test_bash_offers_subcommands_options_and_values(self):
        script = self.script("bash")
        for words, offered, withheld in ASKED:
            done = subprocess.run(["bash", "-c", BASH, "bash", script, *words], text=True, capture_output=True, timeout=60)
            found = set(done.stdout.split())
            self.assertEqual((offered - found, withheld & found, done.stderr), (set(), set(), ""), words)

    @unittest.skipUnless(shutil.which("fish"), "fish is not installed")
    def test_fish_offers_the_same(self):
        script = self.script("fish")
        for words, offered, withheld in ASKED:
            line = " ".join(words)
            done = subprocess.run(["fish", "-c", f"source {script}; complete -C '{line}'"], text=True, capture_output=True, timeout=60)
            found = {word.split("\t")[0] for word in done.stdout.splitlines()}
            self.assertEqual((offered - found, withheld & found, done.stderr), (set(), set(), ""), words)

    @unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
    def test_zsh_reads_it(self):
        done = subprocess.run(["zsh", "-fc", f"autoload -U compinit; compinit -D; source {self.script('zsh')}; print $_comps[axiscert]"],
                              text=True, capture_output=True, timeout=60)
        self.assertEqual((done.stdout, done.stderr), ("_axiscert\n", ""))

    def test_every_subcommand_and_option_of_the_manual_is_in_it(self):
        manual = axiscert("man").stdout.replace("\\-", "-")
        names = {section.split("\n")[0] for section in manual.split("\n.SS ")[1:]}
        script = self.script("bash").read_text()
        self.assertEqual({name for name in names if f"    '{name}') echo '" not in script}, set())
        for section in manual.split("\n.SS ")[1:]:
            name, words = section.split("\n")[0], script.split(f"    '{section.splitlines()[0]}') echo '")[1].split("'")[0].split()
            for line in section.split("\n.TP\n.B ")[1:]:
                for option in (word.strip() for word in line.split("\n")[0].split(" ")[0].split(",")):
                    if option.startswith("--"):
                        self.assertIn(option, words, name)

    def test_another_shell_is_told_which_there_are(self):
        self.refused("completion", "ksh", says=["'ksh'", "bash", "zsh", "fish"])
        self.refused("completion", says=["SHELL"])


class Help(Case):
    def test_subcommands_stand_under_what_their_users_want(self):
        text = axiscert("--help").stdout
        places = [text.index(f"\n{head}:\n") for head in ("Judge a kernel", "Use the right one", "Keep it right in CI", "Study precision", "Look up")]
        self.assertEqual(places, sorted(places))
        self.assertNotIn("\nSubcommands:", text)
        for word, before in (("\n  run ", places[1]), ("\n  league ", places[2]), ("\n  compare ", places[3]), ("\n  ladder ", places[4])):
            self.assertLess(text.index(word), before)

    def test_the_shells_are_found_by_the_build(self):
        for file in ("bash-completion/completions/axiscert", "zsh/vendor-completions/_axiscert", "fish/vendor_completions.d/axiscert.fish"):
            self.assertIn("_axiscert" if "fish" not in file else "complete -c axiscert", (BUILD / "completion/share" / file).read_text(), file)


if __name__ == "__main__":
    unittest.main()
