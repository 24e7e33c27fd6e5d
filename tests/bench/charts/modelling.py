"""What each level of modelling costs on the examples, as bars."""

import matplotlib.pyplot as plt

from charts import style
from charts.tables import in_order


def draw_panel(axes, bars):
    """One case: bars from top to bottom in the order of the table."""
    heights = range(len(bars))[::-1]
    most = max(us for _, us in bars)
    axes.barh(heights, [us for _, us in bars], height=0.62, color=style.VERMILION)
    for height, (_, us) in zip(heights, bars):
        ratio = style.two_digits(us / bars[0][1])
        axes.text(us + 0.015 * most, height, f"{us:,.0f} µs  (×{ratio})", va="center",
                  fontsize=7.5)
    axes.set_yticks(heights, [level for level, _ in bars])
    axes.set(xlabel="all evaluations of the bake [µs]", xlim=(0, 1.45 * most))
    axes.tick_params(axis="y", length=0)
    axes.grid(axis="y", visible=False)


def draw(comment, rows, folder):
    """A panel for each case."""
    cases = in_order(row["case"] for row in rows)
    levels = in_order(row["level"] for row in rows)
    height = 1.5 + 0.34 * len(levels)
    figure, panels = plt.subplots(1, len(cases), figsize=(8, height), sharey=True, squeeze=False)
    left = min(0.35, 0.03 + 0.0085 * max(map(len, levels)))
    figure.subplots_adjust(left=left, right=0.985, top=1 - 0.82 / height, bottom=0.58 / height,
                           wspace=0.07)
    spans = []
    for axes, case in zip(panels[0], cases):
        bars = [(row["level"], float(row["microseconds"])) for row in rows if row["case"] == case]
        draw_panel(axes, bars)
        axes.set_title(case, loc="left", fontweight="bold")
        span = max(us for _, us in bars) / min(us for _, us in bars)
        spans.append(f"{case} ×{style.two_digits(span)}")
    style.headline(figure, f"From the least to the most that is modelled: {', '.join(spans)}",
                   "Time of all evaluations of the bake at each level of modelling; in brackets "
                   "the ratio to the first.")
    style.footnote(figure, comment)
    style.save(figure, folder, "modelling")
