#!/usr/bin/env -S /usr/bin/python3
"""Compares two motion JSON files of one clip: as Hazumi read it, and as it read what it had written.
usage: scripts/interop_round_trip.py NAME FIRST.json SECOND.json"""

import json
import sys

LARGEST_M, LARGEST_DEG = 1e-5, 1e-4


def largest(first, second, name):
    """The largest difference of the lists of numbers of this name, at any frame."""
    worst = 0.0
    for a, b in zip(first["frames"], second["frames"], strict=True):
        for p, q in zip(a[name], b[name], strict=True):
            for x, y in zip(p, q) if isinstance(p, list) else [(p, q)]:
                worst = max(worst, abs(x - y))
    return worst


def main():
    name, *paths = sys.argv[1:]
    motions = []
    for path in paths:
        with open(path, encoding="utf-8") as file:
            motions.append(json.load(file))
    if motions[0]["joint_groups"] != motions[1]["joint_groups"]:
        sys.exit(f"round trip {name}: other joints")
    metres = largest(*motions, "joint_positions_m")
    degrees = largest(*motions, "angles_deg")
    print(f"round trip {name}: off by {degrees:.1e} degrees, {metres:.1e} m at most")
    if metres > LARGEST_M or degrees > LARGEST_DEG:
        sys.exit(f"more than {LARGEST_DEG} degrees or {LARGEST_M} m")


main()
