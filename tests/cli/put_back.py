"""Puts a changed arm back into the file it was imported from, and looks by an independent reader."""

import json
import math
import re

import numpy as np

from command_line import InFolder, run
from foreign_reader import Bvh, Gltf

FRAMES = 30
SAME_M = 1e-4


def plain(name):
    return re.sub(r"\W+", "_", name).strip("_").lower()


def curve_names(joint):
    """Of its hinges."""
    return [f"{joint['name']}_{hinge['name']}" if "name" in hinge else joint["name"] for hinge in joint.get("hinges", [])]


def chosen_joint(project):
    """An upper arm that turns, else a joint in the middle of a chain."""
    joints = project["figure"]["joints"]
    curves = project.get("joints", {})
    turning = [j for j in joints if any(name in curves for name in curve_names(j))]
    for joint in turning:
        if joint.get("role") == "upper_arm":
            return joint
    depth = {}
    for joint in joints:
        depth[joint["name"]] = 1 + depth.get(joint["parent"], 0)
    inner = [j for j in turning if any(k["parent"] == j["name"] for k in joints)] or turning
    return sorted(inner, key=lambda j: depth[j["name"]])[len(inner) // 2]


def change(project):
    """Turns one hinge by up to 20 degrees in at most 30 frames. The name of its joint."""
    joint = chosen_joint(project)
    name = next(name for name in curve_names(joint) if name in project["joints"])
    keys = project["joints"][name]["keys"]
    last = project["frames"]["last"]
    if len(keys) == 1:
        keys = [{"frame": f, "angle_deg": keys[0]["angle_deg"]} for f in range(last + 1)]
        project["joints"][name]["keys"] = keys
    first = min(3, last // 4)
    count = min(FRAMES, last - 2 * first)
    for key in keys:
        u = (key["frame"] - first) / count
        if 0.0 < u < 1.0:
            key["angle_deg"] += 20.0 * math.sin(math.pi * u)
    return joint["name"]


def fit(there, here):
    """Scale, rotation and shift that take points `there` nearest to `here`: least squares."""
    a, b = there.reshape(-1, 3), here.reshape(-1, 3)
    mean_a, mean_b = a.mean(0), b.mean(0)
    u, d, v = np.linalg.svd((b - mean_b).T @ (a - mean_a) / len(a))
    s = np.diag([1.0, 1.0, np.sign(np.linalg.det(u @ v))])
    turn = u @ s @ v
    scale = np.trace(np.diag(d) @ s) / max(((a - mean_a) ** 2).sum(1).mean(), 1e-12)
    return lambda points: scale * points @ turn.T + mean_b - scale * turn @ mean_a


def fit_most(there, here):
    """The same of the half of the joints that it suits best: a few may be somewhere else."""
    best = range(there.shape[1])
    for _ in range(5):
        move = fit(there[:, best], here[:, best])
        off = np.linalg.norm(move(there) - here, axis=2).max(axis=0)
        best = np.argsort(off)[:max(4, len(off) // 2)]
    return move


class PutsBack(InFolder):
    """What tests of files that motion is put back into share."""

    def ok(self, *arguments):
        done = run(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def baked(self, project):
        """Positions [m], [frame][joint] of the last hinge of each, their names, angles [deg], frames a second."""
        out = self.folder / (project.stem + "_motion.json")
        self.ok("--bake", out, project)
        motion = json.loads(out.read_text())
        last = {group: i for i, group in enumerate(motion["joint_groups"])}
        places = np.array([frame["joint_positions_m"] for frame in motion["frames"]])
        angles = np.array([frame["angles_deg"] for frame in motion["frames"]])
        return places[:, list(last.values())], list(last), angles, motion["fps"]

    def file_places(self, path, clip, count, fps):
        if path.suffix == ".bvh":
            places, names = Bvh(path).places()
            return places, names
        gltf = Gltf(path)
        animation = gltf.animation(clip)
        start = gltf.start(animation)
        return gltf.places(animation, [start + f / fps for f in range(count)])

    def compare_gltf(self, before, after, clip, changed):
        a, b = Gltf(before), Gltf(after)
        for key in a.json:
            if key not in ("nodes", "animations", "accessors", "bufferViews", "buffers"):
                self.assertEqual(a.json[key], b.json[key], key)
        for key in ("accessors", "bufferViews"):
            self.assertEqual(a.json[key], b.json[key][:len(a.json[key])], key)
        for i, data in enumerate(a.buffers):
            self.assertEqual(data[:a.json["buffers"][i]["byteLength"]],
                             b.buffers[i][:a.json["buffers"][i]["byteLength"]])
        names = [node.get("name", f"node_{i}") for i, node in enumerate(a.json["nodes"])]
        self.assertEqual(len(a.json["nodes"]), len(b.json["nodes"]))
        for name, x, y in zip(names, a.json["nodes"], b.json["nodes"]):
            if name not in changed or "matrix" not in x:
                self.assertEqual(x, y, name)
        chosen = a.animation(clip)
        self.assertEqual(len(a.json["animations"]), len(b.json["animations"]))
        for i, (x, y) in enumerate(zip(a.json["animations"], b.json["animations"])):
            if i != chosen:
                self.assertEqual(x, y)
                continue
            for channel in x["channels"]:
                target = channel["target"]
                name = names[target["node"]] if "node" in target else ""
                if name in changed and (target["path"] == "rotation" or name != changed[0]):
                    continue
                same = [c for c in y["channels"] if c["target"] == target]
                self.assertEqual(len(same), 1)
                old, new = x["samplers"][channel["sampler"]], y["samplers"][same[0]["sampler"]]
                for part in ("input", "output"):
                    self.assertEqual(a.accessor_bytes(old[part]), b.accessor_bytes(new[part]))

    def compare_bvh(self, before, after, changed):
        a, b = Bvh(before), Bvh(after)
        self.assertEqual(a.head, b.head)
        self.assertEqual(len(a.words), len(b.words))
        free = {column for name, channels in zip(a.names, a.channels) if name in changed for column, _ in channels}
        for i, (x, y) in enumerate(zip(a.words, b.words)):
            if i % a.width not in free:
                self.assertEqual(x, y)

    def put_back(self, path, clip="", ends=0):
        """One file there and back. (bones changed, joints that the import holds, their error in the file
        and that of what is read again [m]) `ends`: bones of the changed limb that the file has elsewhere."""
        project = self.folder / "a.kfa"
        options = ["--clip", clip] if clip else []
        self.ok("--import", path, "--save", project, *options)
        before, joints, angles, fps = self.baked(project)
        content = json.loads(project.read_text())
        clip = content["source"].get("clip", "")
        change(content)
        edited = self.folder / "b.kfa"
        edited.write_text(json.dumps(content))
        wanted, _, wanted_angles, _ = self.baked(edited)
        self.assertGreater(np.abs(wanted_angles - angles).max(), 10.0)
        written = self.folder / ("c" + path.suffix)
        said = self.ok("--export", written, "--onto", path, edited)
        changed = said.strip().removeprefix("changed: ").split(", ")
        # `ends`: those that the file keeps beside the limb move, too.
        self.assertEqual(len(changed), 1 + ends, said)
        if path.suffix == ".bvh":
            self.compare_bvh(path, written, changed)
        else:
            self.compare_gltf(path, written, clip, changed)
        there, names = self.file_places(path, clip, len(before), fps)
        numbers = {plain(name): i for i, name in enumerate(names)}
        both = [(k, numbers[plain(joint)]) for k, joint in enumerate(joints) if plain(joint) in numbers]
        self.assertGreaterEqual(len(both), min(len(joints), 2), (joints, names))
        mine, theirs = [k for k, _ in both], [i for _, i in both]
        move = fit_most(there[:, theirs], before[:, mine])
        now, _ = self.file_places(written, clip, len(before), fps)
        # What the import cannot hold, such as bones that are stretched, is off before and after.
        off_before = np.linalg.norm(move(there[:, theirs]) - before[:, mine], axis=2).max(axis=0)
        held = off_before <= SAME_M
        off = np.linalg.norm(move(now[:, theirs]) - wanted[:, mine], axis=2).max(axis=0)
        self.assertLessEqual(off[held].max(initial=0.0), SAME_M)
        again = self.folder / "d.kfa"
        self.ok("--import", written, "--save", again, *options)
        read_again, joints_again, _, _ = self.baked(again)
        self.assertEqual(joints, joints_again)
        off_again = np.linalg.norm(read_again - wanted, axis=2).max()
        self.assertLessEqual(off_again, SAME_M)
        return changed, f"{held.sum()} of {len(held)} joints", off[held].max(initial=0.0), off_again
