"""Runs the tests of a script, as unittest.main does, except that a skipped test does not count as
passed: where HAZUMI_DATA is set, all that tests need is promised, and a skipped test fails. Skips
whose reason begins with "not here: " (a sanitizer, a right that a user lacks) stay skips, which ctest
shows by SKIPPED."""

import sys
import unittest

import data_folder

SKIPPED = "hazumi test: skipped"  # also in tests/CMakeLists.txt
ALLOWED = "not here: "


def main():
    result = unittest.main(exit=False).result
    if not result.wasSuccessful():
        sys.exit(1)
    for test, reason in result.skipped:
        print(f"hazumi test: {test} is skipped: {reason}")
    if data_folder.is_promised() and any(not reason.startswith(ALLOWED)
                                         for _, reason in result.skipped):
        sys.exit("hazumi test: no test may be skipped where HAZUMI_DATA is set")
    if result.skipped:
        print(SKIPPED)
