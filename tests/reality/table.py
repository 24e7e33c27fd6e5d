"""The results as Markdown."""

import math

from . import cases, fills, springs


def cell(score, other, unit):
    """With the nearer one of two in bold."""
    value, rival = getattr(score, unit), getattr(other, unit)
    text = f"{value:.1f}"
    return f"**{text}**" if value < rival else text


def pair(scores, keys, units=("cm", "deg")):
    interpolated, dynamic = (scores[key] for key in keys)
    return [" / ".join(cell(a, b, unit) for unit in units)
            for a, b in ((interpolated, dynamic), (dynamic, interpolated))]


def row(cells):
    return "| " + " | ".join(cells) + " |\n"


def head(cells):
    return row(cells) + "|" + "---|" * len(cells) + "\n"


def keys_of(result):
    return result.get("label", f"every {result['gap']} frames")


def swings(results):
    text = ("Arms, each interval between two keys left to dynamics (cm / degrees, friction "
            f"{cases.FRICTION}):\n\n")
    text += head(["clip", "keys", "interpolation", "dynamics", "interpolation, captured rates",
                  "dynamics, captured rates", "best friction"])
    for result in results:
        scores, (friction, best) = result["scores"], result["best"]
        text += row([result["clip"], keys_of(result), *pair(scores, ["interpolated", "dynamic"]),
                     *pair(scores, ["interpolated+", "dynamic+"]),
                     f"{best.cm:.1f} / {best.deg:.1f} at {friction}"])
    return text + "\n"


def flights(results):
    text = ("Flights, placed by gravity (cm, all joints / CoM; angles are those of the keys), and "
            f"with the arms dynamic as well (cm / degrees, friction {cases.FRICTION}):\n\n")
    text += head(["clip", "keys", "interpolation", "gravity", "interpolation, captured rates",
                  "gravity, captured rates", "gravity, landing on its key", "arms: interpolation, captured rates",
                  "arms: dynamics, captured rates", "arms: best friction"])
    for result in results:
        scores, arms, (friction, best) = result["scores"], result["arms"], result["best"]
        text += row([result["clip"], keys_of(result),
                     *pair(scores, ["interpolated", "dynamic"], ["cm", "com_cm"]),
                     *pair(scores, ["interpolated+", "dynamic+"], ["cm", "com_cm"]),
                     pair(scores, ["interpolated", "landing"], ["cm", "com_cm"])[1],
                     *pair(arms, ["interpolated+", cases.FRICTION]),
                     f"{best.cm:.1f} / {best.deg:.1f} at {friction}"])
    return text + "\n"


def loose(results):
    text = ("Arms of walks, loose from two keys over the whole clip, the body as captured "
            f"(cm / degrees; friction {cases.FRICTION}, and the one that was best on the other "
            "walk):\n\n")
    text += head(["clip", "frames", "interpolation", "loose", "interpolation, captured rates",
                  "loose, captured rates", "friction of the other walk"])
    for result in results:
        scores, (first, last) = result["scores"], result["frames"]
        other = scores[f"{result['friction']}+"]
        text += row([result["clip"], f"{first} to {last}",
                     *pair(scores, ["interpolated", str(cases.FRICTION)]),
                     *pair(scores, ["interpolated+", f"{cases.FRICTION}+"]),
                     f"{other.cm:.1f} / {other.deg:.1f} at {result['friction']}"])
    return text + "\n"


def told(spring):
    on = "" if spring["on"] == "arm" else "shoulders: "
    return (f"{on}{spring['frequency_hz']:g} Hz, {spring['damping_ratio']:g}, "
            f"{spring['friction']:g}")


def on_springs(results):
    text = ("Arms on springs to their keys, with frequency, damping ratio and friction that were "
            "the best on other frames of the clip (cm / degrees; where it says shoulders the rest "
            "of the arm follows its keys):\n\n")
    text += head(["clip", "keys", "interpolation", "springs", "which",
                  *(f"{name}, body as captured" for name in ("interpolation", "springs")), "which"])
    for result in results:
        cells = [result["clip"], keys_of(result)]
        for body in springs.BODIES:
            own = result[body]
            cells += [*pair(own, ["interpolated", "dynamic"]), told(own["spring"])]
        text += row(cells)
    return text + "\n"


def springs_verdict(results):
    """Of the rows that are counted, and of those with fewer keys."""
    def wins(body, counted):
        rows = [r[body] for r in results if (r["gap"] in springs.GAPS) == counted]
        nearer = sum(r["dynamic"].cm <= springs.WIN * r["interpolated"].cm for r in rows)
        farther = sum(r["interpolated"].cm <= springs.WIN * r["dynamic"].cm for r in rows)
        return f"{nearer} of {len(rows)} (farther in {farther})"

    alike, captured = springs.BODIES
    return ("Springs to keys 10 to 40 frames apart are nearer (cm) by 5 % or more in "
            f"{wins(alike, True)}, with the body as captured in {wins(captured, True)}; to keys "
            f"80 frames apart, of walks, in {wins(alike, False)} and {wins(captured, False)}.\n\n")


def filled(results):
    text = ("Fills of keys beside their automatic tangents and the natural cubic through them (cm / "
            "degrees; bold: the nearest of the three):\n\n")
    text += head(["clip", "keys", "filled", "tangents", "natural cubic", "fill", "keys written"])
    for row_ in results:
        scores = [row_[name] for name in fills.METHODS]
        best = [min(getattr(s, unit) for s in scores) for unit in ("cm", "deg")]
        cells = [" / ".join(f"**{value:.2f}**" if value == least else f"{value:.2f}"
                            for value, least in zip((s.cm, s.deg), best)) for s in scores]
        if "held" in row_:
            cells[-1] += f"; relative to the body {row_['held'].cm:.2f} / {row_['held'].deg:.2f}"
        what = row_["body"] if row_["body"] == fills.WHOLE else f"arms, body {row_['body']}"
        text += row([row_["clip"], keys_of(row_), what, *cells, str(row_["keys"])])
    return text + "\n"


def filled_verdict(results):
    """Wins, losses and means of the fill against both curves, by what is filled."""
    def against(rows, base, unit):
        ratios = [getattr(r["fill"], unit) / getattr(r[base], unit) for r in rows]
        mean = math.exp(sum(map(math.log, ratios)) / len(ratios))
        return (f"{sum(r <= fills.WIN for r in ratios)} nearer, "
                f"{sum(r >= fills.LOSS for r in ratios)} farther, {mean:.2f} times")

    text = ("Fills in cm (degrees), each against both curves; a difference counts from 5 % on, and "
            "times is the geometric mean of the errors' ratios:\n\n")
    text += head(["rows", "against tangents", "against natural cubic", "degrees against tangents"])
    sparse = [r for r in results if r["gap"] <= fills.GAPS[-1]]
    for name, rows in [*((f"arms, body {body}", [r for r in sparse if r["body"] == body])
                         for body in fills.BODIES),
                       (fills.WHOLE, [r for r in sparse if r["body"] == fills.WHOLE]),
                       ("arms of walks, keys every 80 frames",
                        [r for r in results if r["gap"] > fills.GAPS[-1]])]:
        text += row([f"{name} ({len(rows)})", against(rows, "tangents", "cm"),
                     against(rows, "natural", "cm"), against(rows, "tangents", "deg")])
    return text + "\n"


def verdict(results):
    """In how many comparisons dynamics is nearer, by cm."""
    swings_, flights_ = results["swings"], results["flights"]
    sets = [
        ("arms, rates of the keys", [(r["scores"]["interpolated"], r["scores"]["dynamic"])
                                     for r in swings_]),
        ("arms, captured rates", [(r["scores"]["interpolated+"], r["scores"]["dynamic+"])
                                  for r in swings_]),
        ("flights, rates of the keys", [(r["scores"]["interpolated"], r["scores"]["dynamic"])
                                        for r in flights_]),
        ("flights, captured rates", [(r["scores"]["interpolated+"], r["scores"]["dynamic+"])
                                     for r in flights_]),
        ("flights that land on their keys", [(r["scores"]["interpolated"], r["scores"]["landing"])
                                             for r in flights_]),
        ("arms in flight", [(r["arms"]["interpolated+"], r["arms"][cases.FRICTION])
                            for r in flights_]),
        ("loose arms of walks", [(r["scores"]["interpolated"], r["scores"][str(cases.FRICTION)])
                                 for r in results["loose"]]),
    ]
    counts = [f"{name}: {sum(d.cm < i.cm for i, d in pairs)} of {len(pairs)}"
              for name, pairs in sets]
    return "Dynamics is nearer to the capture (cm) in: " + "; ".join(counts) + ".\n\n"


def span(values):
    return f"{min(values):.1f} to {max(values):.1f} cm"


def landings(results):
    """How far the CoM is off where a flight lands on its key, without and with keys between."""
    def told(flights_):
        landing = [r["scores"]["landing"] for r in flights_]
        return (span([s.com_cm for s in landing]) + " (in the worst frame "
                f"{max(s.worst_com_cm for s in landing):.1f} cm), that of the interpolation by "
                + span([r["scores"]["interpolated"].com_cm for r in flights_]))

    bare = [r for r in results["flights"] if "label" in r]
    keyed = [r for r in results["flights"] if "label" not in r]
    return (f"Flights that land on their keys ({len(bare)} jumps, RMS over the frames of each "
            "flight): with keys at take-off and landing only their CoM is off the capture's by " +
            told(bare) + "; with keys between, by " + told(keyed) + ".\n\n")


def markdown(results):
    return ("\n" + filled_verdict(results["fills"]) + filled(results["fills"]) +
            verdict(results) + springs_verdict(results["springs"]) + landings(results) +
            swings(results["swings"]) + on_springs(results["springs"]) + loose(results["loose"]) +
            flights(results["flights"]))
