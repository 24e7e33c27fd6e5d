"""Every test that daily_features.md names is run by the tests of a build.

usage: features_test.py CTEST BUILD"""

import json
import pathlib
import re
import subprocess
import sys

TESTS = pathlib.Path(__file__).resolve().parent


def plain(name):
    """Of a test with parameters, without them: Suite.Name of All/Suite.Name/3."""
    suite, _, rest = name.partition(".")
    return f"{suite.split('/')[-1]}.{rest.split('/')[0]}"


def tests_of(ctest, build):
    """Names of all tests that CTest runs there: of programs, and those inside Python files."""
    done = subprocess.run([ctest, "--test-dir", build, "--show-only=json-v1"], check=True,
                          capture_output=True, text=True)
    known = set()
    for test in json.loads(done.stdout)["tests"]:
        known.add(plain(test["name"]))
        for word in test.get("command", []):
            if word.endswith("_test.py"):
                known |= set(re.findall(r"^    def (test_\w+)", pathlib.Path(word).read_text(), re.M))
    return known


def main():
    known = tests_of(*sys.argv[1:])
    rows = [line.split("|") for line in (TESTS / "daily_features.md").read_text().splitlines()
            if line.startswith("|")][2:]
    missing = [f"{row[1].strip()}: {name}" for row in rows for name in row[2].strip().split(", ")
               if name not in known]
    print(f"{len(rows)} features, {len(known)} tests")
    if missing or len(rows) < 25:
        sys.exit("no such test in the build: " + "; ".join(missing))


main()
