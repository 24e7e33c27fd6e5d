#!/usr/bin/env -S /usr/bin/python3
"""Tests of the sources that scripts/lint checks in a clone, and of the reports of scripts/soak."""

import importlib.machinery
import importlib.util
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "scripts"))
sys.dont_write_bytecode = True


def script(name):
    loader = importlib.machinery.SourceFileLoader(name, str(ROOT / "scripts" / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


def git(folder, *words):
    return subprocess.run(["git", "-C", folder, "-c", "user.name=n", "-c", "user.email=e", *words],
                          capture_output=True, text=True, check=True).stdout.strip()


class Lint(unittest.TestCase):
    """Repository of one source, its header, and another source that includes the header."""

    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.addCleanup(self.place.cleanup)
        self.origin = pathlib.Path(self.place.name) / "origin"
        (self.origin / "engine").mkdir(parents=True)
        git(self.origin, "init", "-q", "-b", "main")
        self.commit("engine/a.h", "")
        self.commit("engine/a.cpp", '#include "engine/a.h"\n')
        self.commit("engine/b.cpp", '#include "engine/a.h"\n')
        self.lint = script("lint")
        self.lint.ROOT = self.origin

    def commit(self, name, text):
        (self.origin / name).write_text(text)
        git(self.origin, "add", ".")
        git(self.origin, "commit", "-q", "-m", name)
        return git(self.origin, "rev-parse", "HEAD")

    def clone(self, *options):
        self.lint.ROOT = pathlib.Path(self.place.name) / "clone"
        git(self.place.name, "clone", "-q", *options, f"file://{self.origin}", self.lint.ROOT)

    def chosen(self, commit):
        flags = {"engine/a.cpp": "", "engine/b.cpp": ""}
        return self.lint.to_check(self.lint.changed_since(commit), flags)

    def test_a_branch_is_compared_with_its_fork_from_main(self):
        left = git(self.origin, "rev-parse", "HEAD")
        git(self.origin, "checkout", "-q", "-b", "work")
        self.commit("engine/b.cpp", "// changed\n")
        self.assertEqual(self.lint.base(None)[0], left)
        self.assertEqual(self.chosen(left), {"engine/b.cpp"})
        self.clone()
        self.assertEqual(self.lint.base(None)[0], left)

    def test_main_is_compared_with_the_last_commits(self):
        self.lint.LAST = 1
        self.assertEqual(self.lint.base(None)[0], git(self.origin, "rev-parse", "HEAD~1"))
        self.lint.LAST = 100
        self.clone("--depth", "2")
        self.assertEqual(self.lint.base(None)[0], git(self.origin, "rev-parse", "HEAD~1"))

    def test_a_clone_of_one_commit_has_nothing_to_compare_with(self):
        self.clone("--depth", "1")
        self.assertIsNone(self.lint.base(None)[0])

    def test_a_missing_commit_is_reported(self):
        with self.assertRaisesRegex(SystemExit, "nowhere is no commit of this clone"):
            self.lint.base("nowhere")

    def test_a_changed_header_is_checked_in_its_source(self):
        before = git(self.origin, "rev-parse", "HEAD")
        (self.origin / "engine/a.h").write_text("// changed\n")
        self.assertEqual(self.chosen(before), {"engine/a.cpp"})

    def test_a_new_source_is_checked_before_it_is_committed(self):
        before = git(self.origin, "rev-parse", "HEAD")
        (self.origin / "engine/a.h").write_text("// changed\n")
        (self.origin / "engine/b.cpp").write_text('#include "engine/a.h"\nint b;\n')
        self.assertEqual(self.chosen(before), {"engine/b.cpp"})


class Soak(unittest.TestCase):
    def setUp(self):
        self.soak = script("soak")

    def test_the_last_half_is_distinguished_from_the_first(self):
        row = self.soak.Row("fuzz kfa")
        self.assertEqual(self.soak.last_half([row], 90), "The last half found nothing.")
        row.findings, row.found_at = ["a"], [44 * 60.0]
        self.assertEqual(self.soak.last_half([row], 90),
                         "The last half found nothing; the last finding is of minute 44.")
        row.found_at = [46 * 60.0]
        self.assertEqual(self.soak.last_half([row], 90), "The last half found 1.")

    def test_skipped_tests_are_named_and_do_not_count_as_passed(self):
        said = ("1/3 Test #1: A.B .......   Passed    0.1 sec\n"
                "2/3 Test #2: A.C .......***Skipped   0.1 sec\n"
                "3/3 Test #3: A.D .......***Failed    0.1 sec\n")
        self.soak.run = lambda *_: (8, said)
        row = self.soak.suite("asan")
        self.assertEqual((row.executions, row.coverage, row.findings),
                         (2, "skipped: A.C", ["A.D: Failed"]))

    def test_an_old_soak_is_reported(self):
        self.soak.last_commit = lambda: "abc"
        self.soak.git = lambda *_: "151"
        said, is_old = self.soak.age()
        self.assertIn("151 commits ago", said)
        self.assertTrue(is_old)
        self.soak.git = lambda *_: "150"
        self.assertFalse(self.soak.age()[1])

    def test_the_table_names_its_commit(self):
        self.assertRegex(self.soak.last_commit(), r"^[0-9a-f]{10}$")

    def test_every_fuzzer_is_run(self):
        text = (ROOT / "tests/fuzz/CMakeLists.txt").read_text()

        made = set(re.findall(r"^hazumi_fuzz\((\w+)", text, re.M))
        self.assertEqual({part[0][1] for part in self.soak.PARTS if part[0][0] is self.soak.fuzz}, made)


if __name__ == "__main__":
    unittest.main()
