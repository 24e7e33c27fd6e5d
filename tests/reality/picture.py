"""The results as a picture."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

# Okabe and Ito's palette, told apart with any colour vision.
SERIES = [("interpolated", "interpolation", "#9ecae1"),
          ("interpolated+", "interpolation, captured rates", "#0072B2"),
          ("dynamic", "dynamics", "#f4b183"),
          ("dynamic+", "dynamics, captured rates", "#D55E00")]
LANDING = ("landing", "gravity, landing on its key", "#009E73")


def bars(axes, results, title, series):
    """A group of bars for each clip and spacing of keys."""
    places, labels, place = [], [], 0.0
    for i, result in enumerate(results):
        if i and result["clip"] != results[i - 1]["clip"]:
            place += 0.8
        places.append(place)
        labels.append(result.get("short", str(result["gap"])))
        place += 1.0
    width = 0.8 / len(series)
    for s, (key, label, color) in enumerate(series):
        axes.bar(np.array(places) + width * (s - (len(series) - 1) / 2),
                 [r["scores"][key].cm for r in results], width, color=color, label=label)
    axes.set_xticks(places, labels)
    for clip in dict.fromkeys(r["clip"] for r in results):
        own = [p for p, r in zip(places, results) if r["clip"] == clip]
        axes.annotate(clip, (np.mean(own), 0), xytext=(0, -32), textcoords="offset points",
                      ha="center", annotation_clip=False)
    axes.set_title(title, loc="left")
    axes.set_ylabel("RMS distance to the capture [cm]")
    axes.spines[["top", "right"]].set_visible(False)
    axes.grid(axis="y", color="#dddddd")
    axes.set_axisbelow(True)


def heights(axes, result):
    """The centre of mass in one flight."""
    first, last = result["frames"]
    frames = np.arange(first, last + 1)
    lines = [("truth", "capture", "black", 3.0)]
    lines += [(key, label, color, 1.8) for key, label, color in [*SERIES, LANDING]]
    for key, label, color, width in lines:
        motion = result["truth"] if key == "truth" else result["baked"][key]
        label = label.replace("dynamics", "gravity")
        axes.plot((frames - first) / 120.0, motion.com[frames - motion.first, 2], color=color,
                  linewidth=width, label=label)
    axes.set_title(f"{result['clip']}, keys at its ends: height of the CoM [m]", loc="left")
    axes.set_xlabel("time since take-off [s]")
    axes.spines[["top", "right"]].set_visible(False)
    axes.grid(color="#dddddd")
    axes.legend(frameon=False, fontsize=9)


def draw(results, path):
    figure, ((swings, curve), (flights, blank)) = plt.subplots(
        2, 2, figsize=(13, 8.4), gridspec_kw={"width_ratios": [1.5, 1.0]})
    bars(swings, results["swings"], "Arms: each interval between two keys by dynamics", SERIES)
    bars(flights, results["flights"], "Flights: all joints, placed by gravity",
         [*SERIES, LANDING])
    flights.set_xlabel("frames between keys (120 a second); ends: take-off and landing only",
                       labelpad=24)
    swings.legend(frameon=False, fontsize=9)
    examples = [r for r in results["flights"] if r.get("short") == "ends"]
    heights(curve, examples[1])
    heights(blank, examples[0])
    figure.tight_layout(h_pad=2.0)
    figure.savefig(path, dpi=90)
