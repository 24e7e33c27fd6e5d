"""Calls of the dynamics beside the peers', as dots on a logarithmic axis."""

import matplotlib.pyplot as plt
from matplotlib.ticker import FixedLocator, FuncFormatter

from charts import style
from charts.tables import in_order

TITLES = {"inverse_dynamics": "inverse dynamics", "bias": "bias vector",
          "inertia_matrix": "inertia matrix", "forward_dynamics": "forward dynamics"}
MODELS = {"human37": "human, 37 hinges", "arm7": "arm, 7 hinges"}


def draw_panel(axes, rows, model, calls):
    """A line of dots for each call."""
    for height, call in enumerate(reversed(calls)):
        own = [(float(row["microseconds"]), row["subject"]) for row in rows
               if row["model"] == model and row["call"] == call]
        axes.plot([min(own)[0], max(own)[0]], [height, height], color="#CCCCCC", linewidth=1,
                  zorder=1)
        for us, subject in own:
            _, colour, marker, _ = style.look(subject)
            axes.plot(us, height, color=colour, marker=marker, linestyle="none", markersize=8,
                      markeredgecolor="white", markeredgewidth=0.6,
                      zorder=3 if subject == "hazumi" else 2)
            if subject in ("hazumi", "mujoco"):
                axes.annotate(f"{us:.2g}", (us, height), (0, 7), textcoords="offset points",
                              ha="center", fontsize=7, color=colour)
    axes.set(xscale="log", xlabel="one call [µs]", ylim=(-0.5, len(calls) - 0.4))
    axes.set_yticks(range(len(calls)), [TITLES[call] for call in reversed(calls)])
    low, high = axes.get_xlim()
    ticks = [t * 10**e for e in range(-2, 3) for t in (1, 2, 5) if low <= t * 10**e <= high]
    axes.xaxis.set_major_locator(FixedLocator(ticks))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda x, _: f"{x:g}"))
    axes.grid(axis="y", visible=False)
    axes.set_title(MODELS.get(model, model), loc="left")


def finding(rows):
    """The title: the range of our ratio to MuJoCo."""
    ratios = [float(row["ratio_to_mujoco"]) for row in rows if row["subject"] == "hazumi"]
    if max(ratios) < 1:
        return (f"Hazumi's calls take {100 * min(ratios):.0f} to {100 * max(ratios):.0f} % of "
                "MuJoCo's time")
    return f"Hazumi's calls take {min(ratios):.2f} to {max(ratios):.2f} times MuJoCo's time"


def draw(comment, rows, folder):
    """A panel for each model."""
    models = in_order(row["model"] for row in rows)
    calls = in_order(row["call"] for row in rows)
    figure, panels = plt.subplots(1, len(models), figsize=(8, 3.4), sharey=True)
    figure.subplots_adjust(left=0.15, right=0.985, top=0.70, bottom=0.19, wspace=0.08)
    for axes, model in zip(panels, models):
        draw_panel(axes, rows, model, calls)
    handles = []
    for subject in in_order(row["subject"] for row in rows):
        name, colour, marker, _ = style.look(subject)
        handles.append(plt.Line2D([], [], color=colour, marker=marker, linestyle="none",
                                  markersize=7, markeredgecolor="white", label=name))
    figure.legend(handles=handles, loc="upper left", bbox_to_anchor=(0.0, 0.865),
                  ncol=len(handles), handletextpad=0.1, columnspacing=1.6)
    style.headline(figure, finding(rows),
                   "Time of one call with a new state, the same models in the same run. "
                   "(Debian's Bullet has forward dynamics only.)")
    style.footnote(figure, comment)
    style.save(figure, folder, "calls")
