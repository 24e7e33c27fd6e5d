#!/usr/bin/env -S /usr/bin/python3
"""What the program says of its version, and how a build finds its commit. usage: version_test.py HAZUMI"""

import os
import re
import shutil
import subprocess
import unittest

from command_line import ROOT, InFolder, main, run

LINE = re.compile(r"hazumi \d+\.\d+\.\d+ \((unknown|[0-9a-f]{7,40}\+?)\)\n")


def git(folder, *arguments):
    settings = ["-c", "user.name=a", "-c", "user.email=a@example.org", "-c", "commit.gpgsign=false"]
    # Whatever repository these tests are run from, even by a hook of git's.
    others = {name: value for name, value in os.environ.items() if not name.startswith("GIT_")}
    return subprocess.run(["git", *settings, "-C", folder, *arguments], check=True, text=True,
                          capture_output=True, env=others).stdout


class Version(InFolder):
    def setUp(self):
        super().setUp()
        self.tree = self.folder / "tree"
        base = self.tree / "engine" / "base"
        base.mkdir(parents=True)
        for name in ("commit.cmake", "commit.cpp.in", "commit.txt"):
            shutil.copy(ROOT / "engine" / "base" / name, base)
        shutil.copy(ROOT / ".gitattributes", self.tree)
        self.written = self.folder / "commit.cpp"

    def commit(self):
        git(self.folder, "init", "-q", self.tree)
        git(self.tree, "add", ".")
        git(self.tree, "commit", "-q", "-m", "all")
        return git(self.tree, "rev-parse", "--short=7", "HEAD").strip()

    def built_from(self, tree):
        subprocess.run([shutil.which("cmake"), f"-DSOURCE={tree}", f"-DOUTPUT={self.written}", "-P",
                        tree / "engine" / "base" / "commit.cmake"], check=True)
        return re.search(r'kCommit = "(.*)"', self.written.read_text())[1]

    def test_the_program_says_version_and_commit(self):
        done = run("--version")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, LINE)

    def test_a_build_carries_the_commit_with_a_plus_if_files_of_it_were_changed(self):
        commit = self.commit()
        self.assertEqual(self.built_from(self.tree), commit)
        (self.tree / "notes.txt").write_text("of nobody's concern")
        self.assertEqual(self.built_from(self.tree), commit)
        with (self.tree / "engine" / "base" / "commit.cpp.in").open("a") as source:
            source.write("// changed\n")
        self.assertEqual(self.built_from(self.tree), commit + "+")

    def test_a_source_whose_commit_is_the_same_is_not_written_again(self):
        self.commit()
        self.built_from(self.tree)
        os.utime(self.written, (1, 1))
        self.built_from(self.tree)
        self.assertEqual(self.written.stat().st_mtime, 1)

    def test_an_archive_made_by_git_carries_its_commit(self):
        commit = self.commit()
        archive = self.folder / "archive"
        archive.mkdir()
        git(self.tree, "archive", "-o", self.folder / "a.tar", "HEAD")
        subprocess.run(["tar", "-xf", self.folder / "a.tar", "-C", archive], check=True)
        self.assertTrue(commit.startswith(self.built_from(archive)[:7]))

    def test_a_tree_without_git_is_unknown_even_inside_another_repository(self):
        self.assertEqual(self.built_from(self.tree), "unknown")
        git(self.folder, "init", "-q", self.folder)
        git(self.folder, "add", ".")
        git(self.folder, "commit", "-q", "-m", "another's")
        self.assertEqual(self.built_from(self.tree), "unknown")

    def test_without_the_program_git_it_is_unknown(self):
        self.commit()
        script = self.tree / "engine" / "base" / "commit.cmake"
        script.write_text(script.read_text().replace("find_program(git git", "find_program(git nogit"))
        self.assertEqual(self.built_from(self.tree), "unknown")


if __name__ == "__main__":
    main()
