"""What is compared, and how: README.md."""

import numpy as np

from . import motions

GAPS = [10, 20, 40]  # frames between keys
FRICTION = 0.8  # the one rule for all joints of all clips
GRID = [0.2, 0.4, 0.6, 0.8, 0.9, 1.0]

MB_ARM = [["Arm", "ForeArm", "Hand"], ["ForeArm", "Hand", "FingerBase"]]
MB_ARMS = [[side + name for side in ("Left", "Right") for name in names] for names in MB_ARM]
DAZ_ARMS = [[side + name for side in "lr" for name in names]
            for names in (["Shldr", "ForeArm", "Hand"], ["ForeArm", "Hand", "Mid1"])]
AMC_ARMS = [[side + name for side in "lr" for name in names]
            for names in (["humerus", "radius", "wrist"], ["radius", "wrist", "hand"])]

# clip, file, metres a unit, first and last frame, (joints that swing, joints measured)
SWINGS = [
    ("baseball pitch", "throw/cmu_mb_124_01_baseball_pitch", 0.056444, 400, 480, MB_ARMS),
    ("basketball shot", "throw/cmu_mb_06_14_basketball_shoot", 0.056444, 230, 310, MB_ARMS),
]
FLIGHTS = [
    ("jump 02_04", "jump/cmu_mb_02_04_jump_balance", 0.056444, 109, 178, MB_ARMS),
    ("jump 13_39", "jump/cmu_daz_13_39_jump", 0.01035, 159, 225, DAZ_ARMS),
    ("jump 16_01", "jump/cmu_amc2bvh_16_01_jump_WRONGFPS", 0.056444, 124, 177, AMC_ARMS),
]


class Score:
    """Root mean squares over everything added, in cm and degrees."""

    def __init__(self):
        self.distances, self.angles, self.com = [], [], []

    def add(self, squares):
        self.distances.append(squares[0])
        self.angles.append(squares[1])

    @property
    def cm(self):
        return 100.0 * np.sqrt(np.mean(np.concatenate(self.distances)))

    @property
    def com_cm(self):
        return 100.0 * np.sqrt(np.mean(np.concatenate(self.com)))

    @property
    def worst_com_cm(self):
        """The greatest of any frame."""
        return 100.0 * np.sqrt(np.max(np.concatenate(self.com)))

    @property
    def deg(self):
        return np.degrees(np.sqrt(np.mean(np.concatenate(self.angles))))


def window_of(first, last, gap, project):
    """Keys enough on both sides, within the clip."""
    before = min(first // gap, -(-60 // gap))
    end = project["frames"]["last"]
    after = min((end - last) // gap, -(-40 // gap)) + (last - first + gap - 1) // gap
    return first - before * gap, min(first + after * gap, end)


def swing(hazumi, out, clip, gap):
    """Each interval between two keys of the stretch, one at a time."""
    name, project, truth, first, last, (swinging, measured) = clip
    scores = {key: Score() for key in ["interpolated", "dynamic", "interpolated+", "dynamic+"]}
    grid = {friction: Score() for friction in GRID}
    for start in range(first, last, gap):
        keys = motions.with_keys(project, start, gap, window_of(start, start + gap, gap, project))
        captured = motions.with_captured_rates(keys, project, start)

        def compare(score, variant, start=start):
            motion = motions.bake(hazumi, variant, out)
            score.add(motions.squares(motion, truth, measured, swinging, start, start + gap))

        compare(scores["interpolated"], keys)
        compare(scores["interpolated+"], captured)
        region = (swinging, start, start + gap)
        compare(scores["dynamic"], motions.with_region(keys, *region, FRICTION))
        for friction, score in grid.items():
            compare(score, motions.with_region(captured, *region, friction))
    scores["dynamic+"] = grid[FRICTION]
    best = min(grid, key=lambda friction: grid[friction].cm)
    return {"clip": name, "gap": gap, "scores": scores, "best": (best, grid[best])}


def flight(hazumi, out, clip, gap):
    """The flight as a whole: gravity places the figure, then the arms swing as well."""
    name, project, truth, first, last, (swinging, measured) = clip
    keys = motions.with_keys(project, first, gap, window_of(first, last, gap, project))
    captured = motions.with_captured_rates(keys, project, first)
    flying = motions.with_gravity(captured, first, last)
    variants = {"interpolated": keys, "dynamic": motions.with_gravity(keys, first, last),
                "interpolated+": captured, "dynamic+": flying,
                "landing": motions.with_flight(hazumi, keys, first, last, out)}
    variants |= {f: motions.with_region(flying, swinging, first, last, f) for f in GRID}
    body, arms, baked = {}, {}, {}
    for key, variant in variants.items():
        baked[key] = motions.bake(hazumi, variant, out)
        body[key], arms[key] = Score(), Score()
        body[key].add(motions.squares(baked[key], truth, truth.names, truth.names, first, last))
        body[key].com.append(motions.com_squares(baked[key], truth, first, last))
        arms[key].add(motions.squares(baked[key], truth, measured, swinging, first, last))
    best = min(GRID, key=lambda f: arms[f].cm)
    return {"clip": name, "gap": gap, "scores": body, "arms": arms, "best": (best, arms[best]),
            "baked": baked, "truth": truth, "frames": (first, last)}


def run_all(hazumi, data, out):
    results = {"swings": [], "flights": []}
    for kind, clips, compare in (("swings", SWINGS, swing), ("flights", FLIGHTS, flight)):
        for name, file, unit, first, last, arms in clips:
            project = motions.import_clip(hazumi, data / (file + ".bvh"), unit, out)
            truth = motions.bake(hazumi, project, out)
            clip = (name, project, truth, first, last, arms)
            results[kind] += [compare(hazumi, out, clip, gap) for gap in GAPS]
            if kind == "flights":
                ends = flight(hazumi, out, clip, last - first)
                results[kind].append(ends | {"label": "take-off, landing", "short": "ends"})
    return results
