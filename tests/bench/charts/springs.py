"""Swings on springs: error against time, one chart a case, drawn as those of work_precision."""

import math
import re
import textwrap

from charts import style, work_precision
from charts.tables import in_order

TARGETS = (1e-3, 1e-6)  # rad, that the sentence speaks of


def frequency(case):
    """Of its springs, e.g. "2.5 Hz"."""
    return f"{float(re.search(r'[0-9.]+', case).group()):g} Hz"


def detail(case):
    """What swings."""
    return (f"An arm of 7 hinges, each on a spring of {frequency(case)} with damping ratio 0.7, "
            "swings for 0.333 s")


def best(lines, target):
    """family -> (microseconds, subject) of its fastest method to an error of `target`, as far as
    measured; the fastest program first. None that does not get there."""
    found = {}
    for subject, line in lines.items():
        time = work_precision.least_time(line, target)
        if math.isfinite(time):
            family = style.family(subject)
            found[family] = min(found.get(family, (math.inf, "")), (time, subject))
    return sorted(found.values())


def ranking(lines, target):
    """In words: who takes how long."""
    told = best(lines, target)
    first = told[0][0]
    return ", ".join(f"{style.in_sentence(subject)} {style.duration(time)}" +
                     (f" (×{style.two_digits(time / first)})" if time > first else "")
                     for time, subject in told)


def sentence(rows):
    """For README.md: the fastest method of each program for errors that are told."""
    text = ("*An arm of 7 hinges, each on a spring with damping ratio 0.7, swings for 0.333 s; least "
            "time of each program for an error of the end pose (models made before):")
    for case in in_order(row["case"] for row in rows):
        lines = work_precision.points(rows, case)
        for target in TARGETS:
            text += f" springs of {frequency(case)}, {target:g} rad: {ranking(lines, target)};"
    return textwrap.fill(text.rstrip(";") + ".*", 112) + "\n"


def title(lines):
    """The first two of each ranking."""
    told = []
    for target, power in zip(TARGETS, ("10⁻³", "10⁻⁶")):
        told.append(f"to {power} rad {', '.join(ranking(lines, target).split(', ')[:2])}")
    return "; ".join(told).replace("to", "To", 1)


def draw(comment, rows, folder):
    """All cases."""
    for case in in_order(row["case"] for row in rows):
        lines = work_precision.points(rows, case)
        work_precision.draw_case(rows, case, comment, folder, (case, title(lines), detail(case)))
