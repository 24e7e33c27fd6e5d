"""Random tests that new seeds are tried of, by .ci/run (scripts/new_seeds) and scripts/soak. A test
takes its seeds from HAZUMI_FIRST_CASE and HAZUMI_CASES: RandomCases of
tests/support/from_environment.h. A new property is one more entry."""

import dataclasses
import os
import pathlib
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent


@dataclasses.dataclass(frozen=True)
class RandomTest:
    name: str
    program: str  # in build/PRESET/tests, or a script in tests that is given hazumi
    cases: int  # of a run of .ci/run
    only: str = ""  # a filter of GTest

    def command(self, build):
        """For the folder of a build."""
        if self.program.endswith(".py"):
            return [sys.executable, ROOT / "tests" / self.program, build / "hazumi"]
        return [build / "tests" / self.program, "--gtest_brief=1",
                *([f"--gtest_filter={self.only}"] if self.only else [])]


WORKING = RandomTest("working regions", "property/working_region_test", 30,
                     "WorkingRegion.ClosesItsAccountAndKeepsItsTolerance")
FALLS = RandomTest("falls", "property/fall_test", 6, "Fall.*EndsAtRest")
REGIONS = RandomTest("regions", "property/exact_region_test", 40, "ExactRegion.Of*")
TRIMMED = RandomTest("trimmed ends", "property/causal_test", 15)
TOUCHING = RandomTest("touching starts", "property/touching_start_test", 40,
                      "TouchingStart.KeepsItsVelocityAndClosesItsAccount")
SLIDING = RandomTest("slide to roll", "property/slide_to_roll_test", 50)
IMPORTS = RandomTest("import twice", "cli/import_twice_test.py", 20)
SCRIPTS = RandomTest("random scripts", "ui/ui_headless_test", 60, "RandomScripts.*")
OPERATORS = RandomTest("random operators", "unit/edit/edit_test", 40, "RandomOperators.*")
KILLS = RandomTest("kills", "unit/edit/kill_test", 10)
TESTS = [WORKING, FALLS, REGIONS, TRIMMED, TOUCHING, SLIDING, IMPORTS, SCRIPTS, OPERATORS, KILLS]


def first_case():
    """A seed that no run before has begun with, unless HAZUMI_FIRST_CASE says which: runs that begin
    in different minutes share none."""
    stated = os.environ.get("HAZUMI_FIRST_CASE")
    return int(stated) if stated else int(time.time()) // 60 % 1_000_000 * 1000
