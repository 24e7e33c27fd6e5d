"""Every test that daily_features.md names is there."""

import pathlib
import re
import sys

TESTS = pathlib.Path(__file__).resolve().parent
TEST = re.compile(r"^TEST(?:_F|_P)?\((\w+),\s*(\w+)\)", re.M)


def main():
    known = set()
    for source in (TESTS / "cli").glob("*_test.py"):
        known |= set(re.findall(r"def (test_\w+)", source.read_text()))
    for source in TESTS.rglob("*.cpp"):
        known |= {".".join(names) for names in TEST.findall(source.read_text())}
    rows = [line.split("|") for line in (TESTS / "daily_features.md").read_text().splitlines()
            if line.startswith("|")][2:]
    missing = [f"{row[1].strip()}: {name}" for row in rows for name in row[2].strip().split(", ")
               if name not in known]
    print(f"{len(rows)} features")
    sys.exit("no such test: " + "; ".join(missing) if missing or len(rows) < 25 else 0)


main()
