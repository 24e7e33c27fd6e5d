"""Cost of the forward dynamics against the number of joints."""

import math

import matplotlib.pyplot as plt
from matplotlib.ticker import FuncFormatter

from charts import style
from charts.tables import in_order

PANELS = {"chain": "a chain", "tree": "a binary tree"}
FIGURES = {"tree": "human37"}  # a figure to mark in a panel


def exponent(line):
    """Slope in logarithms of the least-squares line through the upper decade of joints."""
    top = max(joints for joints, _ in line)
    logs = [(math.log(joints), math.log(us)) for joints, us in line if joints >= top / 10]
    mean_x = sum(x for x, _ in logs) / len(logs)
    mean_y = sum(y for _, y in logs) / len(logs)
    return (sum((x - mean_x) * (y - mean_y) for x, y in logs) /
            sum((x - mean_x) ** 2 for x, _ in logs))


def lines_of(rows, shape):
    """method -> [(joints, microseconds)]."""
    lines = {}
    for row in rows:
        if row["shape"] == shape:
            point = int(row["joints"]), float(row["microseconds"])
            lines.setdefault(row["method"], []).append(point)
    return lines


def draw_panel(axes, rows, shape):
    """One shape of figure, with the exponents in the labels."""
    labels = []
    for method, line in lines_of(rows, shape).items():
        name, colour, marker, dash = style.look(method)
        axes.plot(*zip(*line), color=colour, marker=marker, linestyle=dash, markersize=3.8,
                  markeredgecolor="white", markeredgewidth=0.4,
                  zorder=3 if style.family(method) == "hazumi" else 2)
        labels.append((f"{name}  $N^{{{exponent(line):.1f}}}$", colour, *line[-1]))
    for method, line in lines_of(rows, FIGURES.get(shape)).items():
        axes.plot(*line[0], color=style.look(method)[1], marker="o", markersize=6,
                  markerfacecolor="none", markeredgewidth=0.9)
    axes.set(xscale="log", yscale="log", xlabel="joints")
    axes.set_title(PANELS[shape], loc="left")
    return labels


def finding(rows):
    """The title: what articulated bodies save against the paper's way and against the peers."""
    lines = {method: dict(line) for method, line in lines_of(rows, "chain").items()}
    paper, ours = lines["hazumi_paper_way"], lines["hazumi_articulated"]
    most = max(paper)
    top = max(ours)
    peers = {method: line[top] for method, line in lines.items()
             if style.family(method) != "hazumi" and top in line}
    peer = min(peers, key=peers.get)
    over_paper = style.two_digits(paper[most] / ours[most])
    over_peer = style.two_digits(peers[peer] / ours[top])
    return (f"A chain of {most} joints: {over_paper}× less time than the paper's way; of {top:,}: "
            f"{over_peer}× less than {style.look(peer)[0]}")


def draw(comment, rows, folder):
    """A panel for each shape."""
    shapes = [shape for shape in in_order(row["shape"] for row in rows) if shape in PANELS]
    figure, panels = plt.subplots(1, len(shapes), figsize=(8, 4.6), sharey=True, sharex=True)
    figure.subplots_adjust(left=0.09, right=0.815, top=0.815, bottom=0.13, wspace=0.68)
    labels = [draw_panel(axes, rows, shape) for axes, shape in zip(panels, shapes)]
    panels[0].set_ylabel("one forward dynamics")
    for axes, own in zip(panels, labels):
        axes.xaxis.set_major_formatter(FuncFormatter(lambda x, _: f"{x:,.0f}"))
        axes.yaxis.set_major_formatter(FuncFormatter(style.duration))
        style.label_right(axes, own, gap=0.06, size=7)
    style.headline(figure, finding(rows),
                   "Time from state and torques to accelerations. Exponents: fitted over each line's "
                   "upper decade. Rings: the human of 37 hinges.")
    style.footnote(figure, comment)
    style.save(figure, folder, "scaling")
