"""The human falls from standing: error against time, and how errors grow after the impacts."""

import math
import textwrap

import matplotlib.pyplot as plt
from matplotlib.ticker import FuncFormatter, LogLocator

from charts import style
from charts.tables import in_order
from charts.work_precision import least_time

AFTER = "0.1"  # s, the instant of the left panel
TARGET = 1e-3  # rad, of the ranking
LATE = "0.8"  # s, that is told
JOINTS = {"1": "frictionless joints", "0.8": "friction in joints, in each its own"}


def error_at(row, instant):
    """Angle from the same program's reference [rad]; infinite if it did not get there."""
    return float(row[f"error_rad_at_{instant}_s"])


def instants(rows):
    """All that were looked at, as they are called."""
    return [name.split("_")[3] for name in rows[0] if name.startswith("error_rad_at_")]


def is_reference(row):
    """Whether it is of a much finer setting."""
    return row["method"].startswith("reference_")


def lines_of(rows):
    """method -> its rows, coarse to fine, without falls that broke off."""
    lines = {}
    for row in rows:
        if not is_reference(row) and math.isfinite(float(row["microseconds"])):
            lines.setdefault(row["method"], []).append(row)
    return lines


def known_to(rows, method, instant):
    """How well its program's reference is known there [rad]."""
    name = "reference_" + style.family(method)
    return next(error_at(row, instant) for row in rows if row["method"] == name)


def points(own, instant):
    """[(microseconds, error)]."""
    return [(float(row["microseconds"]), error_at(row, instant)) for row in own]


def usual(own):
    """The row at a new file's tolerance, or the program's default step."""
    return next(row for row in own if row["is_usual"] == "1")


def setting(row):
    """In words."""
    if row["unit"] == "rad":
        return f"{float(row['setting']) * 180 / math.pi:.2g}°"
    return f"{float(row['setting']) * 1e3:g} ms"


def ranking(rows):
    """[(microseconds, method)] of each program's fastest to the target, the fastest first."""
    best = {}
    for method, own in lines_of(rows).items():
        told = least_time(points(own, AFTER), TARGET), method
        family = style.family(method)
        best[family] = min(best.get(family, told), told)
    return sorted(told for told in best.values() if math.isfinite(told[0]))


def ranked(rows):
    """In words."""
    told = ranking(rows)
    return ", ".join(f"{style.in_sentence(method)} {style.duration(time)}" +
                     (f" (×{style.two_digits(time / told[0][0])})" if time > told[0][0] else "")
                     for time, method in told)


def least(rows, family):
    """In words: a program's least error at the first instant, as far as its reference is known, and
    the time of the fastest setting that has it."""
    found = [(max(error, known_to(rows, method, AFTER)), time, method)
             for method, own in lines_of(rows).items() if style.family(method) == family
             for time, error in points(own, AFTER)]
    error, time, method = min(found)
    return f"{style.in_sentence(method)}'s {error:.1g} rad in {style.duration(time)}"


def draw_errors(axes, rows):
    """The left panel. Rings: usual settings."""
    labels = []
    for method, own in lines_of(rows).items():
        name, colour, marker, dash = style.look(method)
        floor = known_to(rows, method, AFTER)
        line = [(time / 1e3, max(error, floor)) for time, error in points(own, AFTER)]
        ours = style.family(method) == "hazumi"
        axes.plot(*zip(*line), color=colour, marker=marker, linestyle=dash,
                  markeredgecolor="white", markeredgewidth=0.4, zorder=3 if ours else 2)
        x, y = line[own.index(usual(own))]
        axes.plot(x, y, color=colour, marker="o", markersize=9, markerfacecolor="none",
                  markeredgewidth=0.9)
        if method != "mujoco_implicit":  # just beside the other
            axes.annotate(setting(usual(own)), (x, y), (-7, -3), textcoords="offset points",
                          ha="right", fontsize=6.5, color=colour)
        labels.append((name, colour, *line[-1]))
        if not ours:
            continue
        for row, (x, y) in zip(own, line):
            if setting(row) == "1°":
                axes.annotate(setting(row), (x, y), (7, -3), textcoords="offset points",
                              fontsize=6.5, color=colour)
    axes.set(xscale="log", yscale="log", xlabel="time for all 2 s of the fall")
    axes.set_ylabel("error of the angles [rad]")
    axes.xaxis.set_major_formatter(FuncFormatter(lambda x, _: style.duration(1e3 * x)))
    axes.yaxis.set_major_locator(LogLocator(numticks=20))
    axes.set_title(f"{AFTER} s after the first impact", loc="left")
    style.label_right(axes, labels, gap=0.07, size=7)


def draw_growth(axes, rows):
    """The right panel: at usual settings."""
    labels = []
    at = instants(rows)
    for method, own in lines_of(rows).items():
        name, colour, marker, dash = style.look(method)
        row = usual(own)
        errors = [max(error_at(row, i), known_to(rows, method, i)) for i in at]
        axes.plot([float(i) for i in at], errors, color=colour, marker=marker, linestyle=dash,
                  markeredgecolor="white", markeredgewidth=0.4)
        labels.append((f"{name}, {setting(row)}", colour, float(at[-1]), errors[-1]))
    axes.set(yscale="log", xlabel="instant of the fall [s]")
    axes.yaxis.set_major_locator(LogLocator(numticks=20))
    axes.set_title("settings of a new file or model", loc="left")
    style.label_right(axes, labels, gap=0.07, size=7)


def depth_and_energy(row):
    """In words, of a fall: how deep it got into the floor, and the energy not accounted for."""
    return (f"{style.two_digits(float(row['depth_mm']))} mm and {abs(float(row['unaccounted_j'])):.1g} J "
            f"of {style.two_digits(float(row['lost_j']))} J lost")


def late(rows, own):
    """In words: a method's error long after impacts, at its usual and its finest setting, as far as its
    reference is known."""
    known = known_to(rows, own[0]["method"], LATE)
    unknown = f"not known better than {known:.1g} rad"
    errors = [(max(error_at(row, LATE), known), setting(row)) for row in (usual(own), own[-1])]
    if max(errors)[0] == known:
        return unknown
    return " and ".join(f"{error:.1g} rad at {at}" if error > known else f"{unknown} at {at}"
                        for error, at in errors)


def sentence(rows):
    """For README.md, of the fall with frictionless joints."""
    rows = [row for row in rows if row["friction"] == "1"]
    lines = lines_of(rows)
    ours, theirs = lines["hazumi_exact"], lines["mujoco_euler"]
    soon = [f"{setting(usual(own))} {style.duration(float(usual(own)['microseconds']))} with "
            f"{error_at(usual(own), AFTER):.1g} rad" for own in (ours, theirs)]
    text = (
        f"*A human let go from standing falls for 2 s, with {JOINTS['1']}; the first impact is that of the "
        "soles at the start. Errors are those against much finer settings of the same program, for their "
        "contacts and limits differ: greatest depth in the floor and energy not accounted for are "
        f"{depth_and_energy(usual(ours))} with `exact` as a new file has it, "
        f"{depth_and_energy(usual(theirs))} with MuJoCo's defaults. All of the fall with an error of "
        f"{TARGET:g} rad {AFTER} s after the impact: {ranked(rows)}; as a new file at {soon[0]}, by MuJoCo's "
        f"default at {soon[1]}. The least error measured there: {least(rows, 'hazumi')}, "
        f"{least(rows, 'mujoco')}. At {LATE} s, after `exact` first entered time-stepping mode at "
        f"{float(usual(ours)['time_stepping_from_s']):.2g} s, its error is {late(rows, ours)}, "
        f"that of MuJoCo Euler {late(rows, theirs)}.*")
    return textwrap.fill(text, 112) + "\n"


def depths(rows):
    """In words: each program's greatest depth at its usual settings, by all of its methods."""
    found = {}
    for method, own in lines_of(rows).items():
        name = style.look(method)[0].split()[0]
        found.setdefault(name, []).append(float(usual(own)["depth_mm"]))
    told = []
    for name, own in found.items():
        low, high = style.two_digits(min(own)), style.two_digits(max(own))
        told.append(f"{name} {low} mm" if low == high else f"{name} {low} to {high} mm")
    return ", ".join(told)


def draw_case(rows, comment, folder):
    """The chart of one friction."""
    friction = rows[0]["friction"]
    figure, panels = plt.subplots(1, 2, figsize=(8, 4.5))
    figure.subplots_adjust(left=0.085, right=0.81, top=0.79, bottom=0.13, wspace=0.72)
    draw_errors(panels[0], rows)
    draw_growth(panels[1], rows)
    style.headline(figure, f"To 10⁻³ rad soon after the first impact: {ranked(rows)}",
                   f"A human falls from standing for 2 s; {JOINTS[friction]}. Error: from the "
                   "same program with much finer settings.")
    style.second_line(figure, "Contacts are each program's own. Rings: settings of a new file or model; "
                      f"depth in the floor then: {depths(rows)}.")
    style.footnote(figure, comment)
    style.save(figure, folder, "contact" if friction == "1" else f"contact_friction_{friction}")


def draw(comment, rows, folder):
    """A chart for each friction of joints."""
    for friction in in_order(row["friction"] for row in rows):
        draw_case([row for row in rows if row["friction"] == friction], comment, folder)
