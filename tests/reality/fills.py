"""Fills beside the capture: keys that are far apart, in between their automatic tangents, the
natural cubic through them, and what "Fill between keys" writes: README.md."""

import copy
import itertools
import json
import subprocess
import time

import numpy as np

from . import cases, motions, springs

WIN, LOSS, FAR = 0.95, 1.05, 1.25
GAPS = [10, 20, 40]
BODIES = springs.BODIES  # what is not the arms: keyed alike, or as captured
SWINGING, MEASURED = cases.MB_ARMS
METHODS = ["tangents", "natural", "fill"]
WHOLE = "whole figure"


def natural_rates(frames, values):
    """Rates [1/frame] of the natural cubic at its keys."""
    n = len(frames)
    if n < 3:
        return np.full(n, (values[-1] - values[0]) / max(frames[-1] - frames[0], 1) if n > 1 else 0.0)
    h, slope = np.diff(frames), np.diff(values) / np.diff(frames)
    matrix, right = np.zeros((n, n)), np.zeros(n)
    matrix[0, :2], right[0] = (2, 1), 3 * slope[0]
    matrix[-1, -2:], right[-1] = (1, 2), 3 * slope[-1]
    for i in range(1, n - 1):
        matrix[i, i - 1:i + 2] = h[i], 2 * (h[i - 1] + h[i]), h[i - 1]
        right[i] = 3 * (h[i] * slope[i - 1] + h[i - 1] * slope[i])
    return np.linalg.solve(matrix, right)


def with_natural_cubic(sparse, only):
    """Its keys, with the rates of the natural cubic; `only` these joints, or all and the root."""
    result = copy.deepcopy(sparse)
    for curve, value, joint in motions.curves(result):
        keys = curve["keys"]
        if (only is not None and joint not in only) or len(keys) < 2:
            continue
        rates = natural_rates(np.array([k["frame"] for k in keys], float),
                              np.array([k[value] for k in keys]))
        name = "rate_m_s" if value == "position_m" else "rate_deg_s"
        for key, rate in zip(keys, rates):
            key[name] = rate * motions.FPS
    return result


def with_fill(hazumi, sparse, joints, out, **fields):
    """As "Fill between keys" writes it, from the first to the last key."""
    path, script = out / "fill.kfa", out / "fill.json"
    path.write_text(json.dumps(sparse), encoding="utf-8")
    script.write_text(json.dumps([
        {"op": "fill.add", "joints": joints, "first": sparse["frames"]["first"],
         "last": sparse["frames"]["last"], "ends": "free", **fields}, {"op": "file.save"}]), encoding="utf-8")
    done = subprocess.run([hazumi, "--run", script, path], capture_output=True, check=False)
    if done.returncode != 0:
        raise motions.NotBaked(f"{path}: {done.stderr.decode()}")
    return json.loads(path.read_text(encoding="utf-8"))


def score(hazumi, out, truth, variant, stretch, measured, swinging):
    result = cases.Score()
    motion = motions.bake(hazumi, variant, out)
    result.add(motions.squares(motion, truth, measured, swinging, *stretch))
    return result


def judge(hazumi, out, clip, stretch, gap, body, **fields):
    """Scores of one row by method, and how many keys the fill wrote."""
    project, truth = clip
    whole = body == WHOLE
    only = SWINGING if body == BODIES[1] else None
    window = cases.window_of(*stretch, gap, project)
    keys = motions.with_keys(project, stretch[0], gap, window, only)
    root = project["figure"]["root"]["name"]
    filled = with_fill(hazumi, keys, [root + "+"] if whole else SWINGING, out, **fields)
    measured = truth.names if whole else MEASURED
    swinging = [n for n in truth.names if n != root] if whole else SWINGING
    variants = {"tangents": keys, "natural": with_natural_cubic(keys, None if whole else SWINGING),
                "fill": filled}
    scores = {name: score(hazumi, out, truth, variant, stretch, measured, swinging)
              for name, variant in variants.items()}
    scores["keys"] = sum(k.get("type") == "generated" for curve, _, _ in motions.curves(filled)
                         for k in curve["keys"])
    return scores


def judge_all(hazumi, data, out):
    """The clips of springs.py: arms, the body keyed alike and as captured, and whole figures."""
    rows = []
    for name, file, stretch, _, _, gaps in springs.CLIPS:
        clip = springs.load(hazumi, data, out, file)
        for gap, body in itertools.product(gaps, [*BODIES, WHOLE]):
            if gap > GAPS[-1] and body == WHOLE:
                continue
            row = {"clip": name, "gap": gap, "body": body,
                   **judge(hazumi, out, clip, stretch, gap, body)}
            if row["fill"].cm > FAR * row["tangents"].cm:  # are the limbs held with the body?
                row["held"] = judge(hazumi, out, clip, stretch, gap, body,
                                    relative_to="body")["fill"]
            rows.append(row)
    return rows


def times(hazumi, data, out, count=10):
    """Milliseconds that "Change fill" takes, as a script runs it: with the bake, the solve, the keys
    and the torques that it reports. By what is filled, in frames of a walk at 120 a second."""
    project, _ = springs.load(hazumi, data, out, springs.WALK_2)
    root = project["figure"]["root"]["name"]
    found = {}
    for name, joints, first, last in [("both arms, 300 frames", SWINGING, 20, 320),
                                      ("both arms, 60 frames", SWINGING, 100, 160),
                                      ("whole figure, 300 frames", [root + "+"], 20, 320)]:
        path, script = out / "timed.kfa", out / "timed.json"
        path.write_text(json.dumps(motions.with_keys(project, first, 20, (first, last))),
                        encoding="utf-8")

        def seconds(changes, joints=joints, first=first, last=last):
            script.write_text(json.dumps(
                [{"op": "fill.add", "joints": joints, "first": first, "last": last}] +
                [{"op": "fill.set", "fill": "fill", "snap": 0.001 * (i + 1)}
                 for i in range(changes)]), encoding="utf-8")
            begin = time.perf_counter()
            subprocess.run([hazumi, "--run", script, path], check=True, capture_output=True)
            return time.perf_counter() - begin

        found[name] = 1000.0 * min(seconds(count) - seconds(0) for _ in range(3)) / count
    return found
