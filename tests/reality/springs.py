"""Muscle and no muscle beside the capture: arms of walks let go altogether, and arms on springs to a
few keys. What a spring is like is searched on other frames than those judged: README.md."""

import itertools
import json
import pathlib

from . import cases, motions

FOUND = pathlib.Path(__file__).resolve().parent / "springs.json"
UNIT = 0.056444
WIN = 0.95  # nearer than interpolation: by 5 % at least
BODIES = ["keyed alike", "as captured"]  # what is not the arms

PITCH = "throw/cmu_mb_124_01_baseball_pitch"
SHOT = "throw/cmu_mb_06_14_basketball_shoot"
WALK_2, WALK_7 = "other/cmu_mb_02_01_walk", "wild/cmu_mb_07_01_walk"
# clip, file, judged frames, file and frames to search on, frames between keys
CLIPS = [
    ("baseball pitch", PITCH, (400, 480), PITCH, [(300, 380), (500, 580)], [10, 20, 40]),
    ("basketball shot", SHOT, (230, 310), SHOT, [(130, 210), (330, 410)], [10, 20, 40]),
    ("walk 02_01", WALK_2, (70, 310), WALK_7, [(70, 310)], [10, 20, 40, 80]),
    ("walk 07_01", WALK_7, (70, 310), WALK_2, [(70, 310)], [10, 20, 40, 80]),
]
GAPS = [10, 20, 40]  # of the comparison that is counted
LOOSE_FRICTIONS = [*cases.GRID[:-1], 0.95, 0.98, 0.99, 1.0]
# Searched one after the other, in turn, until none of them brings anything.
CHOICES = {"on": ["arm", "shoulder"], "frequency_hz": [0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0],
           "damping_ratio": [0.1, 0.3, 0.5, 1.0, 2.0, 5.0, 15.0], "friction": [0.6, 0.8, 0.9, 1.0]}
START = {"on": "arm", "frequency_hz": 3.0, "damping_ratio": 1.0, "friction": 1.0}
SWINGING, MEASURED = cases.MB_ARMS


def load(hazumi, data, out, file):
    project = motions.import_clip(hazumi, data / (file + ".bvh"), UNIT, out)
    return project, motions.bake(hazumi, project, out)


def score_of(hazumi, out, truth, stretches):
    """Of (project, first, last), together."""
    score = cases.Score()
    for variant, first, last in stretches:
        motion = motions.bake(hazumi, variant, out)
        score.add(motions.squares(motion, truth, MEASURED, SWINGING, first, last))
    return score


class Row:
    """One clip, spacing of keys and body: with springs, or none, in some of its frames."""

    def __init__(self, hazumi, out, clip, gap, body):
        self.hazumi, self.out, self.gap = hazumi, out, gap
        self.project, self.truth = clip
        self.only = None if body == BODIES[0] else SWINGING

    def score(self, stretches, spring=None):
        variants = []
        for first, last in stretches:
            window = cases.window_of(first, last, self.gap, self.project)
            keys = motions.with_keys(self.project, first, self.gap, window, self.only)
            if spring:
                keys = motions.with_springs(keys, SWINGING, first, last, spring)
            variants.append((keys, first, last))
        return score_of(self.hazumi, self.out, self.truth, variants)

    def search(self, stretches):
        best = dict(START)
        least, tried = self.score(stretches, best).cm, {tuple(best.values())}
        for name in itertools.cycle(CHOICES):
            if name == "on":
                before = dict(best)
            for value in CHOICES[name]:
                other = best | {name: value}
                if tuple(other.values()) in tried:
                    continue
                tried.add(tuple(other.values()))
                try:
                    found = self.score(stretches, other).cm
                except motions.NotBaked:
                    continue
                if found < least:
                    least, best = found, other
            if name == "friction" and best == before:
                return best


def each_row(hazumi, data, out, is_search):
    """Names of rows, they themselves, and the frames to search or to judge."""
    for name, file, judged, other, others, gaps in CLIPS:
        clip = load(hazumi, data, out, other if is_search else file)
        for gap, body in itertools.product(gaps, BODIES):
            row = Row(hazumi, out, clip, gap, body)
            yield f"{name}, {gap}, {body}", row, others if is_search else [judged]


def search_all(hazumi, data, out):
    """Finds what springs are best on other frames, and writes it down."""
    found = {}
    for name, row, stretches in each_row(hazumi, data, out, True):
        found[name] = row.search(stretches)
        print(name, found[name], flush=True)
    lines = [f"  {json.dumps(name)}: {json.dumps(spring)}" for name, spring in found.items()]
    FOUND.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")


def judge_all(hazumi, data, out):
    found = json.loads(FOUND.read_text(encoding="utf-8"))
    results = {}
    for name, row, stretches in each_row(hazumi, data, out, False):
        clip, gap, body = name.split(", ")
        result = results.setdefault((clip, int(gap)), {"clip": clip, "gap": int(gap)})
        result[body] = {"interpolated": row.score(stretches), "spring": found[name],
                        "dynamic": row.score(stretches, found[name])}
    return list(results.values())


def loose_walk(hazumi, data, out, file, frictions=LOOSE_FRICTIONS):
    """Arms with keys on two frames, the body as captured: by friction, and with rates of the keys
    or captured ones."""
    project, truth = load(hazumi, data, out, file)
    first, last = 5, project["frames"]["last"] - 2
    keys = motions.with_keys(project, first, last - first, (first - 2, last + 2), SWINGING)
    captured = motions.with_captured_rates(keys, project, first, SWINGING)
    scores = {}
    for mark, variant in (("", keys), ("+", captured)):
        scores["interpolated" + mark] = score_of(hazumi, out, truth, [(variant, first, last)])
        for friction in frictions:
            loose = motions.with_region(variant, SWINGING, first, last, friction)
            scores[f"{friction}{mark}"] = score_of(hazumi, out, truth, [(loose, first, last)])
    return {"frames": (first, last), "scores": scores}


def loose_walks(hazumi, data, out):
    """Of each walk, and what friction was the best of the others."""
    walks = [{"clip": f"walk {file[-10:-5]}"} | loose_walk(hazumi, data, out, file)
             for file in (WALK_2, WALK_7)]
    for walk in walks:
        others = [other["scores"] for other in walks if other is not walk]
        walk["friction"] = min(LOOSE_FRICTIONS, key=lambda f: sum(s[f"{f}+"].cm for s in others))
    return walks
