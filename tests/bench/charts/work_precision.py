"""Error against time, one chart a case."""

import math
import textwrap

import matplotlib.pyplot as plt
from matplotlib.ticker import FuncFormatter, LogLocator

from charts import style
from charts.tables import in_order

DETAILS = {
    "arm7_smooth": "A passive arm of 7 hinges swings for 0.333 s without friction or limits",
    "free_swing": "A passive arm of 7 hinges swings for ten frames without friction or limits",
    "swing_with_limits": "A passive arm of 7 hinges swings for ten frames with friction; "
                        "two joints hit their limits",
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


def set_ups(rows, case):
    """subject -> microseconds to make its model from the figure, which the lines leave out."""
    return {row["subject"]: float(row["set_up_microseconds"]) for row in rows
            if row["case"] == case and row["set_up_microseconds"]}


def later(line, microseconds):
    """The line of somebody who makes the model for this swing alone."""
    return [(time + microseconds, error) for time, error in line]


def is_peer(subject):
    return style.family(subject) != "hazumi"


def least_time(line, target):
    """Microseconds for an error of `target` or less, as far as measured; infinite if out of reach."""
    return min([time_to(line, target)] + [time for time, error in line if error <= target])


def ahead(ours, lines):
    """(least, greatest) error [rad] of the widest range, by a grid of 100 a decade, in which our
    line takes less time than each other program's that gets there at all; None if there is none."""
    peers = [line for subject, line in lines.items() if is_peer(subject)]
    reached = [error for line in peers for _, error in line if 0 < error <= WORST]
    low, high = math.floor(100 * math.log10(min(reached))), math.ceil(100 * math.log10(WORST))
    best, current = [], []
    for i in range(low, high + 1):
        error = 10 ** (i / 100)
        time = least_time(ours, error)
        theirs = min(least_time(line, error) for line in peers)
        if math.isinf(time) and math.isinf(theirs):
            continue  # nobody's
        current = [*current, error] if time < theirs else []
        best = max(best, current, key=len)
    return (best[0], best[-1]) if best else None


def sentence(rows, case="arm7_smooth"):
    """For README.md: where our line is ahead, as far as it was measured."""
    lines = points(rows, case)
    ours, own = lines["hazumi_exact"], set_ups(rows, case)["hazumi_exact"]
    names = in_order(style.look(subject)[0].split()[0] for subject in lines if is_peer(subject))
    text = (f"*{DETAILS[case].replace(' without', ', without')}: `exact` takes less time than "
            f"{', '.join(names[:-1])} and {names[-1]} ")
    reach = ahead(ours, lines)
    text += (f"for errors of the end pose from {reach[0]:.1g} to {reach[1]:.1g} rad" if reach
             else "for no error")
    alone = ahead(later(ours, own), lines)
    text += (f"; with the compilation of its model, {style.duration(own)}, counted for this one swing "
             "alone (dotted) and that of the others not, ")
    text += f"from {alone[0]:.1g} to {alone[1]:.1g} rad" if alone else "for none"
    return textwrap.fill(text + ".*", 112) + "\n"


def finding(lines):
    """The title: who needs the least time for 1e-6 rad, and the best of the other programs."""
    target = 1e-6
    best_of = {}
    for subject, line in lines.items():
        time = least_time(line, target)
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


def draw_set_up(axes, line, microseconds):
    """The same with the making of the model."""
    shown = [point for point in later(line, microseconds) if point[1] <= WORST]
    axes.plot(*zip(*shown), color=style.look("hazumi_exact")[1], linestyle=":", linewidth=1.2,
              zorder=2.5)


def set_up_note(costs):
    """What making each program's model from the figure takes."""
    shown = {}
    for subject, us in costs.items():
        if not subject.startswith("hazumi_paper"):
            shown.setdefault(style.look(subject)[0].split()[0], us)
    return ("Without making the models from the figure: " +
            ", ".join(f"{name} {style.duration(us)}" for name, us in shown.items()) +
            ". Dotted: Hazumi with it.")


def down_to(floor, line):
    """The line up to the first point that is as good as the reference itself."""
    kept = []
    for time, error in line:
        kept.append((time, max(error, floor)))
        if error <= floor:
            break
    return kept


def draw_case(rows, case, comment, folder, named=None):
    """The chart of one case. `named`: file, title and detail of one that is not of this table."""
    lines = points(rows, case)
    floor = next(float(row["error_rad"]) for row in rows
                 if row["case"] == case and row["subject"] == "reference")
    figure, axes = plt.subplots(figsize=(8, 5))
    figure.subplots_adjust(left=0.085, right=0.765, top=0.835, bottom=0.125)
    axes.set(xscale="log", yscale="log")
    lines = {subject: down_to(floor, line) for subject, line in lines.items()}
    labels = [draw_line(axes, subject, line) for subject, line in lines.items()]
    making = set_ups(rows, case)
    draw_set_up(axes, lines["hazumi_exact"], making["hazumi_exact"])
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
    name, title, detail = named or (f"work_precision_{case}", finding(lines),
                                    DETAILS.get(case, case))
    if any(error > WORST for line in lines.values() for _, error in line):
        detail += f". ×: error above {WORST:g} rad, or broken off"
    style.headline(figure, title, detail + ".")
    style.second_line(figure, set_up_note(making))
    style.footnote(figure, comment)
    style.save(figure, folder, name)


def draw(comment, rows, folder):
    """All cases."""
    for case in in_order(row["case"] for row in rows):
        draw_case(rows, case, comment, folder)
