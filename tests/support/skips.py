"""Runs the tests of a script as unittest.main does, but a skipped test does not count as passed. A
skipped test fails if HAZUMI_DATA is set, since all requirements of tests are then available. Skips
whose reason begins with "not here: " (a sanitizer, a missing permission) stay skips, which CTest
shows because of SKIPPED."""

import sys
import unittest

import data_folder

SKIPPED = "hazumi test: skipped"  # same text in tests/CMakeLists.txt
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
