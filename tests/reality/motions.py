"""Projects and their motions, as arrays. Frames, metres and degrees."""

import copy
import json
import subprocess

import numpy as np

FPS = 120.0


def import_clip(hazumi, bvh, unit_m, out):
    """The clip as a project with a key on every frame, at 120 frames a second, without a scene."""
    path = out / (bvh.stem + ".kfa")
    subprocess.run([hazumi, "--import", bvh, "--save", path, "--unit", str(unit_m), "--no-skin"],
                   check=True, stdout=subprocess.DEVNULL)
    project = json.loads(path.read_text(encoding="utf-8"))
    project["fps"] = {"num": 120, "den": 1}
    project["scene"]["objects"] = []
    return project


def curves(project):
    """(curve, name of its value, the joint that it turns or none) of all joints and the root."""
    for name, curve in project["joints"].items():
        yield curve, "angle_deg", name.rpartition("_")[0]
    for name, curve in project["root"].items():
        yield curve, "position_m" if name in "xyz" else "angle_deg", None


def with_keys(project, first, gap, window, only=None):
    """Its keys at first + k gap inside the window, of some joints or else of all that is; what else
    there is keeps all of its own. A curve that never moves keeps its value."""
    sparse = copy.deepcopy(project)
    sparse["frames"] = {"first": window[0], "last": window[1]}
    for curve, _, joint in curves(sparse):
        keys = curve["keys"]
        if len(keys) == 1:
            keys[0]["frame"] = window[0]
        else:
            step = gap if only is None or joint in only else 1
            curve["keys"] = [k for k in keys if window[0] <= k["frame"] <= window[1]
                             and (k["frame"] - first) % step == 0]
    return sparse


def with_captured_rates(sparse, project, frame, only=None):
    """Gives the keys on a frame the rates of the capture: central differences over 2 frames."""
    result = copy.deepcopy(sparse)
    for (curve, value, joint), (full, _, _) in zip(curves(result), curves(project)):
        if only is not None and joint not in only:
            continue
        at = {k["frame"]: k[value] for k in full["keys"]}
        rate = "rate_m_s" if value == "position_m" else "rate_deg_s"
        for key in curve["keys"]:
            if key["frame"] == frame and frame - 2 in at and frame + 2 in at:
                key[rate] = (at[frame + 2] - at[frame - 2]) * FPS / 4.0
    return result


def with_region(sparse, joints, first, last, friction):
    result = copy.deepcopy(sparse)
    result.setdefault("regions", []).append(
        {"name": "dynamics", "first_frame": first, "last_frame": last, "joints": joints,
         "friction": {"default": friction}})
    return result


def with_springs(sparse, joints, first, last, spring):
    """A region in which springs pull some of its joints to their keys, and the others follow theirs."""
    result = with_region(sparse, joints, first, last, spring["friction"])
    pulled = joints if spring["on"] == "arm" else [j for j in joints if j.endswith("Arm")
                                                   and not j.endswith("ForeArm")]
    drives = [{"joints": pulled, "kind": "spring", "frequency_hz": spring["frequency_hz"],
               "damping_ratio": spring["damping_ratio"]}]
    if len(pulled) < len(joints):
        drives.append({"joints": [j for j in joints if j not in pulled], "kind": "keys"})
    result["version"] = 2
    result["regions"][-1]["drives"] = drives
    return result


def with_gravity(sparse, first, last):
    result = copy.deepcopy(sparse)
    result["placements"] = [{"kind": "gravity", "first_frame": first, "last_frame": last}]
    return result


def with_flight(hazumi, sparse, first, last, out):
    """Placed by gravity, with the rate of the root at take-off that leads to the landing's key."""
    path, script = out / "flight.kfa", out / "flight.json"
    path.write_text(json.dumps(sparse), encoding="utf-8")
    script.write_text(json.dumps([{"op": "placement.flight", "first": first, "last": last},
                                  {"op": "file.save"}]), encoding="utf-8")
    subprocess.run([hazumi, "--run", script, path], check=True, stdout=subprocess.DEVNULL)
    return json.loads(path.read_text(encoding="utf-8"))


class Motion:
    """positions[frame, joint] and rotations[frame, joint] (of each joint against its parent)."""

    def __init__(self, project, baked):
        self.first = baked["frames"][0]["frame"]
        groups = baked["joint_groups"]
        self.names = list(dict.fromkeys(groups))
        origin = [groups.index(name) for name in self.names]
        frames = baked["frames"]
        self.positions = np.array([f["joint_positions_m"] for f in frames])[:, origin]
        self.com = np.array([f["com"] for f in frames])
        angles = np.radians([f["angles_deg"] for f in frames])
        axes = {j["name"]: [h["axis"] for h in j["hinges"]] for j in project["figure"]["joints"]}
        self.rotations = np.empty((len(frames), len(self.names), 3, 3))
        for i, name in enumerate(self.names):
            turn = np.broadcast_to(np.eye(3), (len(frames), 3, 3))
            for h, axis in enumerate(axes[name]):
                turn = turn @ about(np.array(axis, float), angles[:, origin[i] + h])
            self.rotations[:, i] = turn


def about(axis, angle):
    """Rotations about an axis by each of some angles [rad]."""
    cross = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    s, c = np.sin(angle)[:, None, None], np.cos(angle)[:, None, None]
    return np.eye(3) + s * cross + (1.0 - c) * (cross @ cross)


class NotBaked(SystemExit):
    """Hazumi refused it; says why."""


def bake(hazumi, project, out):
    path = out / "case.kfa"
    path.write_text(json.dumps(project), encoding="utf-8")
    done = subprocess.run([hazumi, "--bake", "-", path], capture_output=True, check=False)
    if done.returncode != 0:
        raise NotBaked(f"{path}: {done.stderr.decode()}")
    return Motion(project, json.loads(done.stdout))


def com_squares(motion, truth, first, last):
    """Squared distances of the centres of mass [m^2] at the frames after first, up to last."""
    a = motion.com[first + 1 - motion.first:last + 1 - motion.first]
    b = truth.com[first + 1 - truth.first:last + 1 - truth.first]
    return np.sum((a - b) ** 2, axis=-1)


def squares(motion, truth, joints, turning, first, last):
    """Squared distances [m^2] of the origins of joints and squared angles [rad^2] between the
    rotations of others, at the frames after first, up to last."""
    a, b = slice(first + 1 - motion.first, last + 1 - motion.first), slice(
        first + 1 - truth.first, last + 1 - truth.first)
    at = [truth.names.index(name) for name in joints]
    distance = np.sum((motion.positions[a][:, at] - truth.positions[b][:, at]) ** 2, axis=-1)
    at = [truth.names.index(name) for name in turning]
    between = np.swapaxes(truth.rotations[b][:, at], -1, -2) @ motion.rotations[a][:, at]
    cosine = (np.trace(between, axis1=-2, axis2=-1) - 1.0) / 2.0
    return distance.ravel(), np.arccos(np.clip(cosine, -1.0, 1.0)).ravel() ** 2
