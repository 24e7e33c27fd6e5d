"""What a second on springs costs at the edge of stability, against the springs' frequency."""

import textwrap

import matplotlib.pyplot as plt
from matplotlib.ticker import FixedLocator, FuncFormatter

from charts import style
from charts.stability import count
from charts.tables import in_order

TITLES = {"0": "undamped: the energy stays within a factor of 2",
          "0.7": "damping ratio 0.7: the energy does not double"}
TOLD = "30"  # Hz, the stiffest spring that a region may have


def lines_of(rows, damping_ratio):
    """method -> [(frequency, evaluations)], without those that nothing survived."""
    lines = {}
    for row in rows:
        if row["damping_ratio"] == damping_ratio and row["evaluations"]:
            point = float(row["frequency_hz"]), int(row["evaluations"])
            lines.setdefault(row["method"], []).append(point)
    return lines


def evaluations_at(rows, damping_ratio, method):
    """Evaluations at the frequency that is told; infinite if no setting survived."""
    return next(float(row["evaluations"] or "inf") for row in rows if row["method"] == method and
                row["damping_ratio"] == damping_ratio and row["frequency_hz"] == TOLD)


def step_at(rows, damping_ratio, method):
    """The step there [ms], or nothing."""
    return next((f"{style.two_digits(1e3 * float(row['step_s']))} ms" for row in rows
                 if row["method"] == method and row["damping_ratio"] == damping_ratio and
                 row["frequency_hz"] == TOLD and row["step_s"]), "")


def best_of_families(rows, damping_ratio):
    """The cheapest method of each program at the frequency that is told, the cheapest first."""
    best = {}
    for method in in_order(row["method"] for row in rows):
        own = evaluations_at(rows, damping_ratio, method), method
        family = style.family(method)
        best[family] = min(best.get(family, own), own)
    return sorted(best.values())


def told(rows, damping_ratio):
    """In words: the cheapest of each program at the stiffest spring of a region."""
    return ", ".join(f"{style.in_sentence(method)} {count(evaluations)}"
                     for evaluations, method in best_of_families(rows, damping_ratio))


def draw_panel(axes, rows, damping_ratio):
    """One damping ratio; returns the labels of its lines."""
    labels = []
    for method, line in lines_of(rows, damping_ratio).items():
        name, colour, marker, dash = style.look(method)
        axes.plot(*zip(*line), color=colour, marker=marker, linestyle=dash, markersize=3.8,
                  markeredgecolor="white", markeredgewidth=0.4,
                  zorder=3 if style.family(method) == "hazumi" else 2)
        labels.append((name, colour, *line[-1]))
    axes.set(xscale="log", yscale="log", xlabel="frequency of the springs [Hz]")
    axes.set_title(TITLES[damping_ratio], loc="left")
    axes.xaxis.set_major_locator(FixedLocator([1, 2, 5, 10, 20, 50, 100]))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda x, _: f"{x:g}"))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda y, _: f"{y:,.0f}"))
    return labels


def sentence(rows):
    """For README.md: what is compared, and a row for each method."""
    text = ("What a second of an arm of 7 hinges, each on a spring, costs at the edge of stability: "
            "evaluations of the equations of motion at the coarsest setting tried (at most a step of 0.1 s, "
            "a tolerance of 1 rad, an accuracy of 0.1) with which the energy undamped stays within a factor "
            f"of 2, and with damping ratio 0.7 does not double. At {TOLD} Hz, the stiffest springs of a "
            "region; in brackets equal steps:")
    text = (textwrap.fill(f"*{text}*", 112) +
            "\n\n| | undamped | damping ratio 0.7 |\n|---|---|---|\n")
    for method in in_order(row["method"] for row in rows):
        cells = [style.look(method)[0]]
        for damping_ratio in in_order(row["damping_ratio"] for row in rows):
            cell = count(evaluations_at(rows, damping_ratio, method))
            step = step_at(rows, damping_ratio, method)
            cells.append(f"{cell} ({step})" if step else cell)
        text += f"| {' | '.join(cells)} |\n"
    return text


def draw(comment, rows, folder):
    """A panel for each damping ratio."""
    ratios = in_order(row["damping_ratio"] for row in rows)
    figure, panels = plt.subplots(1, len(ratios), figsize=(8, 4.4), sharey=True)
    figure.subplots_adjust(left=0.105, right=0.825, top=0.775, bottom=0.135, wspace=0.6)
    labels = [draw_panel(axes, rows, ratio) for axes, ratio in zip(panels, ratios)]
    panels[0].set_ylabel("evaluations in a second of motion")
    for axes, own in zip(panels, labels):
        style.label_right(axes, own, gap=0.055, size=6.5)
    style.headline(figure, f"Evaluations to survive a second at {TOLD} Hz, damped: "
                   f"{told(rows, ratios[-1])}",
                   f"Undamped: {told(rows, ratios[0])}. Hazumi's springs end at {TOLD} Hz.")
    style.second_line(figure, "An arm of 7 hinges on springs; evaluations of its equations of motion at "
                      "the coarsest setting that survives (0.1 s, 1 rad, accuracy 0.1 at most).")
    style.footnote(figure, comment)
    style.save(figure, folder, "spring_stability")
