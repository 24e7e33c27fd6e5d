#!/usr/bin/env -S /usr/bin/python3
"""Checks that the fuzzers cover every field and every operator: a dictionary must contain its
words, and a file of the corpora must use it. usage: words_test.py HAZUMI"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import words

HAZUMI = sys.argv.pop(1)
REMEDY = "tests/fuzz/words.py build/dev/hazumi adds them"


class Dictionaries(unittest.TestCase):
    def test_dictionaries_have_every_field_and_value_of_the_schemas(self):
        for name in words.DICTIONARIES:
            self.assertEqual(words.missing_words(name, HAZUMI), [], f"{name}.dict: {REMEDY}")

    def test_the_scripts_dictionary_has_every_operator_and_parameter(self):
        self.assertGreater(len(words.operators(HAZUMI)), 50)
        self.assertEqual(words.missing_words("script", HAZUMI), [], f"script.dict: {REMEDY}")


class Corpora(unittest.TestCase):
    def test_corpora_use_every_field_and_value_of_the_schemas(self):
        for name in words.CORPORA:
            self.assertEqual(words.unused_fields(name), [],
                             f"add a file that has them to tests/fuzz/corpus/{name}")

    def test_scripts_use_every_operator_and_parameter(self):
        self.assertEqual(words.unused_operators(HAZUMI), [],
                         "add a script that has them to tests/fuzz/corpus/script")

    def test_project_files_of_every_field_are_accepted(self):
        files = sorted((words.FUZZ / "corpus/kfa").glob("every_*.kfa"))
        self.assertGreater(len(files), 5)
        for path in files:
            done = subprocess.run([HAZUMI, "--check", path], capture_output=True, text=True,
                                  check=False, timeout=120)
            self.assertEqual(done.returncode, 0, f"{path.name}: {done.stderr}")

    def test_every_file_is_within_the_length_that_fuzzers_try(self):
        for path in (words.FUZZ / "corpus").rglob("*.*"):
            self.assertLessEqual(path.stat().st_size, 8192, path.name)


class Schema(unittest.TestCase):
    """Search for a field that is added to the schema."""

    def test_a_new_field_is_missing_in_the_dictionary_and_the_corpus(self):
        with tempfile.TemporaryDirectory() as folder:
            there = pathlib.Path(folder)
            for path in words.SCHEMAS.iterdir():
                text = path.read_text().replace('"break_force_n"', '"snap_force_n"')
                (there / path.name).write_text(text)
            before, words.SCHEMAS = words.SCHEMAS, there
            try:
                self.assertEqual(words.missing_words("kfa", HAZUMI), ["snap_force_n"])
                self.assertEqual(words.unused_fields("kfa"), ["constraint.snap_force_n"])
            finally:
                words.SCHEMAS = before


if __name__ == "__main__":
    unittest.main()
