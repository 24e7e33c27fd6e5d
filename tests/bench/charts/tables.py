"""Reading the tables of out/bench."""

import csv


def read(path):
    """(comment without its mark, rows as dictionaries)."""
    with open(path, encoding="utf-8") as lines:
        comment = lines.readline().lstrip("# ").strip()
        return comment, list(csv.DictReader(lines))


def in_order(values):
    """Each value once, in the order of its first appearance."""
    return list(dict.fromkeys(values))
