#!/usr/bin/env -S /usr/bin/python3
"""The manual page, and what bash, zsh and fish complete. usage: document_test.py HAZUMI

Shells and readers of manual pages that are not installed are passed over."""

import json
import os
import pty
import select
import shutil
import subprocess
import time
import unittest

from command_line import InFolder, main, run

BASH_HELPERS = "/usr/share/bash-completion/bash_completion"


def needs(program):
    return unittest.skipUnless(shutil.which(program), f"no {program} here")


def said_by(*command, **more):
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, **more)
    assert done.returncode == 0, (command, done.stderr)
    return done.stdout


class ManPage(InFolder):
    def setUp(self):
        super().setUp()
        self.page = self.folder / "hazumi.1"
        done = run("--man")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.page.write_text(done.stdout)

    def test_it_says_all_that_the_help_says_of_options(self):
        text = self.page.read_text()
        for line in run("--help").stdout.splitlines():
            if line.startswith("  --"):
                self.assertIn("\n\\fB" + line.split()[0].replace("-", "\\-"), text)

    def test_its_sweep_is_one(self):
        text = self.page.read_text()
        example = text.partition(".SH SWEEP FILES")[2].partition(".nf\n")[2].partition("\n.fi")[0]
        (self.folder / "sweep.json").write_text(example.replace("\\-", "-"))
        project = self.project()
        (self.folder / "throw.kfa").write_text(json.dumps(project))
        done = run("--sweep", self.folder / "sweep.json", "--count")
        self.assertEqual((done.returncode, done.stdout), (0, "12\n"), done.stderr)

    def test_it_says_where_files_are(self):
        text = self.page.read_text().replace("\\-", "-")
        for place in ("examples", "schema"):
            self.assertRegex(text, rf"\n\\fB/[^\n]*/share/hazumi/{place}\\fR\n")

    @needs("man")
    def test_man_has_no_warnings(self):
        shown = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", self.page],
                               capture_output=True, text=True, timeout=60,
                               env={**os.environ, "LC_ALL": "C.UTF-8", "MANWIDTH": "80"})
        self.assertEqual((shown.returncode, shown.stderr), (0, ""))
        self.assertIn("EXIT STATUS", shown.stdout)

    @needs("mandoc")
    def test_mandoc_misses_nothing_but_a_date(self):
        found = subprocess.run(["mandoc", "-T", "lint", "-W", "warning", self.page],
                               capture_output=True, text=True, timeout=60).stdout
        self.assertEqual([line for line in found.splitlines() if "missing date" not in line], [])


class Completion(InFolder):
    """What is typed, and what a shell makes of it, in a folder with some files."""

    def setUp(self):
        super().setUp()
        for name in ("walk.bvh", "own.kfa", "notes.txt", "edits.json"):
            (self.folder / name).write_text("")
        (self.folder / "pictures").mkdir()

    def script(self, shell):
        done = run("--completion", shell)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        path = self.folder / f".{shell}"
        path.write_text(done.stdout)
        return path

    def check(self, offers):
        """By a function from words to what is offered for the last one."""
        self.assertLessEqual({"--render", "--bake", "--check", "--help", "--trace"},
                             set(offers("--")))
        self.assertNotIn("--method", offers("--"))
        self.assertEqual(offers("--check", "--me"), ["--method"])
        self.assertEqual(offers("--check", "--fp"), [])
        self.assertEqual(offers("--import", "walk.bvh", "--sa"), ["--save"])
        self.assertEqual(sorted(offers("--check", "--method", "")), ["exact", "paper"])
        self.assertEqual(offers("--render", "out", "--body", "cap"), ["capsules"])
        self.assertEqual(sorted(offers("--export", "x.bvh", "--bvh-unit", "")), ["cm", "m"])
        self.assertEqual(offers("--check", "own"), ["own.kfa"])
        self.assertEqual(offers("--info", "wa"), ["walk.bvh"])
        self.assertEqual(offers("ow"), ["own.kfa"])
        self.assertEqual(offers("--completion", "f"), ["fish"])

    def bash(self, words, source=""):
        """As bash asks: with words cut at = as well."""
        cut = []
        for word in ["hazumi", *words]:
            name, sign, value = word.partition("=")
            cut += [name, sign, value] if sign else [word]
        quoted = " ".join(f"'{word}'" for word in cut if word or word is cut[-1])
        return said_by("bash", "--norc", "-c",
                       f"{source} source {self.script('bash')}; COMP_WORDS=({quoted}); "
                       f"COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)); _hazumi 2>/dev/null; "
                       "printf '%s\\n' \"${COMPREPLY[@]}\"", cwd=self.folder).split()

    def test_bash_takes_it_for_a_script(self):
        said_by("bash", "-n", self.script("bash"))

    def test_bash_completes_by_itself(self):
        self.check(lambda *words: self.bash(words))
        self.assertEqual(self.bash(["--check", "--method=pa"]), ["paper"])
        self.assertEqual(self.bash(["--check", "--method="]), ["exact", "paper"])
        self.assertEqual(self.bash(["--check", ""]), ["pictures", "own.kfa"])
        self.assertEqual(self.bash(["--run", ""]), ["pictures", "edits.json"])
        self.assertEqual(self.bash(["--render", ""]), ["pictures"])

    @unittest.skipUnless(os.path.exists(BASH_HELPERS), "no bash-completion here")
    def test_bash_completes_with_the_helpers_of_bash_completion(self):
        def helped(*words):
            return self.bash(words, f"source {BASH_HELPERS};")
        self.check(helped)
        self.assertEqual(sorted(helped("--check", "")), ["own.kfa", "pictures"])
        self.assertEqual(helped("--render", ""), ["pictures"])

    @needs("fish")
    def test_fish_completes(self):
        script = self.script("fish")
        said_by("fish", "-n", script)

        def offers(*words):
            out = said_by("fish", "-N", "-c", f"source {script}; complete -C 'hazumi {' '.join(words)}'",
                          cwd=self.folder, env={**os.environ, "HOME": str(self.folder)})
            return [line.split("\t")[0] for line in out.splitlines()]
        self.check(offers)
        self.assertEqual(sorted(offers("--check", "--method=")), ["--method=exact", "--method=paper"])

    @needs("zsh")
    def test_zsh_completes(self):
        said_by("zsh", "-n", self.script("zsh"))
        with Zsh(self.folder, self.script("zsh")) as zsh:
            for typed, completed in (("--ren", "--render="), ("--check --me", "--method="),
                                     ("--check --fp", "--fp"), ("--check --method pa", "paper "),
                                     ("--check --method=ex", "--method=exact "),
                                     ("--render out --body cap", "capsules "),
                                     ("--import walk.bvh --sa", "--save="),
                                     ("--check own", "own.kfa "), ("--info wa", "walk.bvh "),
                                     ("--run ed", "edits.json "), ("--render pi", "pictures/"),
                                     ("ow", "own.kfa "), ("--completion f", "fish ")):
                line = zsh.completed("hazumi " + typed)
                self.assertEqual(line.removeprefix("hazumi " + typed.rpartition(" ")[0]).lstrip(" "),
                                 completed, typed)


class Zsh:
    """An interactive zsh that writes down its line as it stands once completed."""

    def __init__(self, folder, script):
        self.line = folder / ".line"
        setup = folder / ".zshrc"
        setup.write_text(f"PROMPT=; autoload -U compinit; compinit -u -D; source {script}\n"
                         f"say() {{ zle complete-word; print -rn -- \"$BUFFER|\" > {self.line}; BUFFER=; }}\n"
                         "zle -N say; bindkey '^X' say\n"
                         "setopt no_list_beep no_auto_list\n"
                         f"touch {self.line}\n")
        self.child, self.terminal = pty.fork()
        if self.child == 0:
            os.chdir(folder)
            os.execvpe("zsh", ["zsh", "-i", "--no-globalrcs"],
                       {**os.environ, "ZDOTDIR": str(folder), "TERM": "dumb"})
        self.wait_for_line()

    def wait_for_line(self):
        for _ in range(600):
            if select.select([self.terminal], [], [], 0.05)[0]:
                os.read(self.terminal, 65536)
            if self.line.exists():
                time.sleep(0.05)
                text = self.line.read_text()
                self.line.unlink()
                return text
        raise AssertionError("zsh does not answer")

    def completed(self, typed):
        os.write(self.terminal, f"{typed}\x18".encode())
        return self.wait_for_line().removesuffix("|")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        os.close(self.terminal)
        os.waitpid(self.child, 0)


if __name__ == "__main__":
    main()
