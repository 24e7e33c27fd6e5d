"""Error against time, one chart a case."""

import math

import matplotlib.pyplot as plt
from matplotlib.ticker import FuncFormatter, LogLocator

from charts import style
from charts.tables import in_order

DETAILS = {
    "arm7_smooth": "A passive arm of 7 hinges swings for 0.333 s without friction or stops",
    "free_swing": "A passive arm of 7 hinges swings for ten frames without friction or stops",
    "swing_with_stops": "A passive arm of 7 hinges swings for ten frames with friction; "
                        "two joints hit their stops",
    "near_gimbal": "An arm that starts 2° from the shoulder's singular pose swings for ten frames",
}
WORST = 3.0  # rad; beyond, a method has failed


def points(rows, case):
    """subject -> [(microseconds, error)] of a case, coarse to fine; failures are infinite."""
    lines = {}
    for row in rows:
        if row["case"] == case and row["subject"] != "reference":
            point = float(row["microseconds"]), float(row["error_rad"])
            lines.setdefault(row["subject"], []).append(point)
    return lines


def time_to(line, target):
    """Microseconds for an error of `target`, by logarithms; infinite if out of reach."""
    for (t0, e0), (t1, e1) in zip(line, line[1:]):
        if e0 >= target >= e1 > 0 and math.isfinite(e0):
            part = math.log(e0 / target) / math.log(e0 / e1) if e0 > e1 else 0.0
            return t0 * (t1 / t0) ** part
    return math.inf


def finding(lines):
    """The title: who needs the least time for 1e-6 rad, and the best of the other programs."""
    target = 1e-6
    best_of = {}
    for subject, line in lines.items():
        time = time_to(line, target)
        family = style.family(subject)
        if time < best_of.get(family, (math.inf, ""))[0]:
            best_of[family] = time, style.in_sentence(subject)
    ranking = sorted(best_of.values())
    if not ranking:
        error, time, subject = min((line[-1][1], line[-1][0], subject)
                                   for subject, line in lines.items())
        return (f"{style.look(subject)[0]}: still wrong by {error:.1g} rad after "
                f"{style.duration(time)}")
    title = f"To 10⁻⁶ rad: {ranking[0][1]} {style.duration(ranking[0][0])}"
    for time, name in ranking[1:3]:
        title += f", {name} {style.duration(time)} (×{style.two_digits(time / ranking[0][0])})"
    return title


def draw_line(axes, subject, line):
    """One method: its points joined, failures as marks at the top. Returns its label."""
    name, colour, marker, dash = style.look(subject)
    front = 3 if style.family(subject) == "hazumi" else 2
    axes.plot([t for t, _ in line], [e if e <= WORST else math.nan for _, e in line], color=colour,
              marker=marker, linestyle=dash, markeredgecolor="white", markeredgewidth=0.4,
              zorder=front)
    failed = [t for t, e in line if e > WORST]
    axes.plot(failed, [WORST] * len(failed), color=colour, marker="x", linestyle="none",
              clip_on=False)
    end = [point for point in line if point[1] <= WORST][-1]
    return name, colour, *end


def down_to(floor, line):
    """The line up to the first point that is as good as the reference itself."""
    kept = []
    for time, error in line:
        kept.append((time, max(error, floor)))
        if error <= floor:
            break
    return kept


def draw_case(rows, case, comment, folder):
    """The chart of one case."""
    lines = points(rows, case)
    floor = next(float(row["error_rad"]) for row in rows
                 if row["case"] == case and row["subject"] == "reference")
    figure, axes = plt.subplots(figsize=(8, 5))
    figure.subplots_adjust(left=0.085, right=0.765, top=0.855, bottom=0.125)
    axes.set(xscale="log", yscale="log")
    lines = {subject: down_to(floor, line) for subject, line in lines.items()}
    labels = [draw_line(axes, subject, line) for subject, line in lines.items()]
    lowest = min(label[3] for label in labels)
    axes.set_ylim(max(lowest / 4, floor / 6), WORST)
    if lowest < 30 * floor:
        axes.axhspan(floor / 10, floor, color="#F0F0F0", zorder=0)
        axes.text(0.01, floor / 1.25, "below the digits of the reference", fontsize=7, va="top",
                  color="#777777", transform=axes.get_yaxis_transform())
    axes.yaxis.set_major_locator(LogLocator(numticks=20))
    axes.xaxis.set_major_formatter(FuncFormatter(style.duration))
    axes.set_xlabel("time for the whole swing")
    axes.set_ylabel("largest error of the end pose [rad]")
    style.label_right(axes, labels)
    failures = any(error > WORST for line in lines.values() for _, error in line)
    style.headline(figure, finding(lines), DETAILS.get(case, case) + "." +
                   (f" ×: error above {WORST:g} rad, or broken off." if failures else ""))
    style.footnote(figure, comment)
    style.save(figure, folder, f"work_precision_{case}")


def draw(comment, rows, folder):
    """All cases."""
    for case in in_order(row["case"] for row in rows):
        draw_case(rows, case, comment, folder)
