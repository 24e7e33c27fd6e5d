"""What a second of swing costs at the edge of stability, over a slice of the problems: a heat map
for each method."""

import math

import matplotlib.pyplot as plt
from matplotlib.colors import LogNorm
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

from charts import style
from charts.tables import in_order


def edges(values):
    """Borders of the cells around sorted values: halfway, in logarithms if all are positive and
    spaced so."""
    if len(values) == 1:
        return [values[0] * 0.9, values[0] * 1.1], False
    logarithmic = values[0] > 0 and values[-1] / values[0] > 5 * len(values) ** 0.5
    x = [math.log(v) for v in values] if logarithmic else list(values)
    middle = [(a + b) / 2 for a, b in zip(x, x[1:])]
    ends = [2 * x[0] - middle[0], *middle, 2 * x[-1] - middle[-1]]
    return ([math.exp(e) for e in ends] if logarithmic else ends), logarithmic


def set_axis(axis, values, logarithmic):
    """Ticks at no more than six of the values."""
    if logarithmic:
        axis.axes.set(**{f"{axis.axis_name}scale": "log"})
    step = math.ceil(len(values) / 6)
    axis.set_major_locator(FixedLocator(values[::step]))
    axis.set_minor_locator(NullLocator())
    axis.set_major_formatter(FuncFormatter(lambda x, _: f"{x:g}"))


def draw_method(axes, rows, norm):
    """One heat map. A cell where no setting survived is hatched."""
    xs = sorted({float(row["x"]) for row in rows})
    ys = sorted({float(row["y"]) for row in rows})
    cost = {(float(row["x"]), float(row["y"])): float(row["evaluations"] or "nan")
            for row in rows}
    grid = [[cost.get((x, y), math.nan) for x in xs] for y in ys]
    x_edges, x_log = edges(xs)
    y_edges, y_log = edges(ys)
    axes.set_facecolor("white")
    axes.fill_between([x_edges[0], x_edges[-1]], y_edges[0], y_edges[-1], facecolor="#F4F4F4",
                      hatch="////", edgecolor="#BBBBBB", linewidth=0)
    mesh = axes.pcolormesh(x_edges, y_edges, grid, norm=norm, cmap="cividis_r", edgecolor="white",
                           linewidth=0.4)
    set_axis(axes.xaxis, xs, x_log)
    set_axis(axes.yaxis, ys, y_log)
    axes.set(xlim=(x_edges[0], x_edges[-1]), ylim=(y_edges[0], y_edges[-1]))
    axes.grid(visible=False)
    axes.set_title(style.look(rows[0]["method"])[0], loc="left", fontweight="bold",
                   color=style.look(rows[0]["method"])[1])
    return mesh


def costs(rows, method):
    """Evaluations in each cell, the least first; infinite where no setting survived."""
    return sorted(float(row["evaluations"] or "inf") for row in rows if row["method"] == method)


def median(rows, method):
    """Over all cells."""
    own = costs(rows, method)
    return (own[(len(own) - 1) // 2] + own[len(own) // 2]) / 2


def count(value):
    """Evaluations, two digits, with commas."""
    return f"{float(f'{value:.2g}'):,.0f}" if math.isfinite(value) else "none of the settings"


def finding(rows, methods):
    """The title: of each program's methods the cheapest, from the cheapest on."""
    best = {}
    for method in sorted(methods, key=lambda method: median(rows, method), reverse=True):
        best["paper" if method == "hazumi_paper" else style.family(method)] = method
    ranking = sorted(best.values(), key=lambda method: median(rows, method))
    told = [f"{style.in_sentence(method)} {count(median(rows, method))}" for method in ranking]
    return f"Evaluations to survive a second, median: {', '.join(told)}"


def sentence(rows):
    """For README.md: what is shown, and a row for each method over all slices."""
    cells = len(rows) // len(in_order(row["method"] for row in rows))
    text = ("*What a second of swing without friction costs at the edge of stability: evaluations of "
            "the equations of\nmotion at the coarsest setting, a step or for `exact` a tolerance, with "
            "which the energy stays within a\nfactor of 2. Of all "
            f"{cells} cells of both charts:*\n\n"
            "| | median | most | cells in which no setting tried survives |\n|---|---|---|---|\n")
    for method in in_order(row["method"] for row in rows):
        own = costs(rows, method)
        finite = [cost for cost in own if math.isfinite(cost)]
        numbers = [count(median(rows, method)), count(max(finite)), str(len(own) - len(finite))]
        text += f"| {' | '.join([style.look(method)[0], *numbers])} |\n"
    return text


def draw_slice(rows, name, comment, folder):
    """The heat maps of all methods over one slice."""
    methods = in_order(row["method"] for row in rows)
    finite = [float(row["evaluations"]) for row in rows if row["evaluations"]]
    norm = LogNorm(min(finite), max(finite))
    columns = 2 if len(methods) in (2, 4) else min(3, len(methods))
    lines = math.ceil(len(methods) / columns)
    figure, panels = plt.subplots(lines, columns, figsize=(8, 1.5 + 2.4 * lines), sharex=True,
                                  sharey=True, squeeze=False)
    height = figure.get_size_inches()[1]
    figure.subplots_adjust(left=0.085, right=0.865, top=1 - 0.86 / height, bottom=0.62 / height,
                           wspace=0.08, hspace=0.22)
    for axes, method in zip(panels.flat, methods):
        mesh = draw_method(axes, [row for row in rows if row["method"] == method], norm)
    for i, axes in enumerate(panels.flat):
        axes.set_visible(i < len(methods))
        axes.tick_params(labelbottom=i + columns >= len(methods))
    x_name, y_name = name.split(" x ")
    figure.supxlabel(x_name, x=0.475, y=0.27 / height, fontsize=8.5)
    figure.supylabel(y_name, y=0.5 - 0.12 / height, fontsize=8.5)
    bar = figure.colorbar(mesh, cax=figure.add_axes([0.885, 0.62 / height, 0.018,
                                                     1 - 1.48 / height]))
    bar.set_label("evaluations in a second of motion")
    style.headline(figure, finding(rows, methods),
                   "Of the equations of motion, at the coarsest setting that survives; “as a new "
                   "file”: at its 0.01°. Hatched: none does.")
    style.footnote(figure, comment)
    style.save(figure, folder, "stability_" + name.replace(" ", "_"))


def draw(comment, rows, folder):
    """A chart for each slice."""
    for name in in_order(row["slice"] for row in rows):
        draw_slice([row for row in rows if row["slice"] == name], name, comment, folder)
