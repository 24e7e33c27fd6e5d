"""Random tests that .ci/run (scripts/new_seeds) and scripts/soak run with new seeds. A test takes
its seeds from HAZUMI_FIRST_CASE and HAZUMI_CASES: RandomCases of tests/support/from_environment.h.
Add an entry for each new property."""

import dataclasses
import os
import pathlib
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent


@dataclasses.dataclass(frozen=True)
class RandomTest:
    name: str
    program: str  # program in build/PRESET/tests, or script in tests that takes the path of hazumi
    cases: int  # number of cases in .ci/run
    only: str = ""  # GTest filter

    def command(self, build):
        """Command line for the folder of a build."""
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
TESTS = [OPERATORS, WORKING, FALLS, REGIONS, TRIMMED, TOUCHING, SLIDING, IMPORTS, SCRIPTS, KILLS]  # long ones first


def first_case():
    """First seed: HAZUMI_FIRST_CASE, or a new one. Runs that begin in different minutes share no
    seeds."""
    stated = os.environ.get("HAZUMI_FIRST_CASE")
    return int(stated) if stated else int(time.time()) // 60 % 1_000_000 * 1000
