#!/usr/bin/env -S /usr/bin/python3
"""Compares joints of imported files, over all frames, with an evaluation of the same files that is
independent of Hazumi: glTF by its specification, Collada by its (sections in the functions). Lengths
are compared after a similarity fit. Prints the largest distances.
usage: reports_test.py HAZUMI"""

import base64
import json
import struct
import xml.etree.ElementTree

import numpy as np

from command_line import InFolder, main, run

MOST = 0.1  # [mm]
GLTF = ("g00_control.gltf", "g01_rotation_normalized_short.gltf", "g02_cubic_three_keys.gltf",
        "g03_first_key_at_1p5s.gltf", "g15_animation_pointer_channel.gltf",
        "g15b_pointer_channel_scalar.gltf", "g17_mesh_quantization.gltf", "g24_gltfpack_default.glb",
        "g24_gltfpack_noq.glb", "g25_no_skin_arm_and_leg_move.gltf", "g25_no_skin_only_arm_moves.gltf",
        "g28_channel_without_node.gltf", "g28b_scale_and_rotation_without_node.gltf",
        "g29_all_channels_are_pointers.gltf", "g32_rate_72.gltf", "g32_rate_90.gltf",
        "g38_no_skin_names_with_control.gltf", "g38_no_skin_names_with_ik.gltf")
COLLADA = ("c6_step_matrix.dae", "c11_ids_as_blender_writes.dae", "c12_ids_as_max_writes.dae",
           "c18_bezier_tangents.dae", "h1_blender341_clip.dae", "h2_blender341_armature.dae")
NUMBERS = {5120: ("<i1", 127), 5121: ("<u1", 255), 5122: ("<i2", 32767), 5123: ("<u2", 65535),
           5125: ("<u4", 1), 5126: ("<f4", 1)}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
PATHS = ("translation", "rotation", "scale")


class Gltf:
    """A document whose nodes have worlds at a time."""

    def __init__(self, path):
        data = path.read_bytes()
        chunk = b""
        if data[:4] == b"glTF":
            length = struct.unpack("<I", data[12:16])[0]
            text, chunk = data[20:20 + length], data[28 + length:]
        else:
            text = data
        self.json = json.loads(text)
        self.buffers = [base64.b64decode(b["uri"].split(",")[1]) if "uri" in b else chunk
                        for b in self.json["buffers"]]
        self.nodes = self.json["nodes"]
        self.parents = {c: i for i, n in enumerate(self.nodes) for c in n.get("children", [])}
        self.channels = list(self.read_channels(self.json["animations"][0]))

    def read_channels(self, animation):
        for channel in animation["channels"]:
            target, sampler = channel["target"], animation["samplers"][channel["sampler"]]
            node, path = target.get("node"), target["path"]
            if path == "pointer":
                words = target["extensions"]["KHR_animation_pointer"]["pointer"].split("/")
                node, path = (int(words[2]), words[3]) if words[1] == "nodes" else (None, "")
            if node is not None and path in PATHS:
                yield (node, path, self.values(sampler["input"])[:, 0], self.values(sampler["output"]),
                       sampler.get("interpolation", "LINEAR"))

    def values(self, index):
        """[3.6.2, 3.11]"""
        accessor = self.json["accessors"][index]
        view = self.json["bufferViews"][accessor["bufferView"]]
        name, one = NUMBERS[accessor["componentType"]]
        kind, width = np.dtype(name), WIDTHS[accessor["type"]]
        stride = view.get("byteStride", kind.itemsize * width)
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        rows = np.array([np.frombuffer(self.buffers[view["buffer"]], kind, width, start + i * stride)
                         for i in range(accessor["count"])], float)
        return np.maximum(rows / one, -1) if accessor.get("normalized") else rows

    def start(self):
        return min(times[0] for _, _, times, _, _ in self.channels if len(times) > 1)

    def places(self, t):
        """By name of the node."""
        parts = [{"translation": np.array(n.get("translation", [0, 0, 0]), float),
                  "rotation": np.array(n.get("rotation", [0, 0, 0, 1]), float),
                  "scale": np.array(n.get("scale", [1, 1, 1]), float)} for n in self.nodes]
        for node, path, times, values, how in self.channels:
            parts[node][path] = sample(times, values, how, path, t)

        def world(i):
            above = world(self.parents[i]) if i in self.parents else np.eye(4)
            return above @ placed(turn_of(parts[i]["rotation"]) * parts[i]["scale"], parts[i]["translation"])
        return {n.get("name"): world(i)[:3, 3] for i, n in enumerate(self.nodes)}


def placed(turn, place):
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = turn, place
    return matrix


def turn_of(q):
    x, y, z, w = q / np.linalg.norm(q)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def slerp(a, b, s):
    b = b if a @ b >= 0 else -b
    angle = np.arccos(min(a @ b, 1.0))
    return a + s * (b - a) if angle < 1e-6 else (np.sin((1 - s) * angle) * a + np.sin(s * angle) * b) / np.sin(angle)


def sample(times, values, how, path, t):
    """[appendix C]"""
    is_spline = how == "CUBICSPLINE"
    keys = values.reshape(len(times), 3, -1) if is_spline else values[:, None, :]
    if path == "rotation" and not is_spline:
        keys = keys / np.linalg.norm(keys, axis=2, keepdims=True)
    middle = keys[:, keys.shape[1] // 2]
    k = int(np.searchsorted(times, t + 1e-5, side="right")) - 1
    if k < 0 or k + 1 == len(times) or how == "STEP":
        return middle[max(k, 0)]
    d = times[k + 1] - times[k]
    s = (t - times[k]) / d
    if not is_spline:
        between = slerp if path == "rotation" else lambda a, b, part: a + part * (b - a)
        return between(middle[k], middle[k + 1], s)
    return ((2 * s**3 - 3 * s**2 + 1) * keys[k, 1] + d * (s**3 - 2 * s**2 + s) * keys[k, 2]
            + (3 * s**2 - 2 * s**3) * keys[k + 1, 1] + d * (s**3 - s**2) * keys[k + 1, 0])


class Collada:
    NS = "{http://www.collada.org/2005/11/COLLADASchema}"

    def __init__(self, path):
        self.root = xml.etree.ElementTree.parse(path).getroot()
        self.channels = {}
        for animation in self.root.iter(self.NS + "animation"):
            sources = {"#" + s.get("id"): s for s in animation.findall(self.NS + "source")}
            samplers = {"#" + s.get("id"): s for s in animation.findall(self.NS + "sampler")}
            for channel in animation.findall(self.NS + "channel"):
                inputs = {i.get("semantic"): sources[i.get("source")]
                          for i in samplers[channel.get("source")].findall(self.NS + "input")}
                numbers = {name: self.numbers(source.find(self.NS + "float_array"))
                           for name, source in inputs.items() if name != "INTERPOLATION"}
                words = inputs["INTERPOLATION"].find(self.NS + "Name_array").text.split()
                self.channels[channel.get("target")] = (numbers, words)

    @staticmethod
    def numbers(element):
        return [float(word) for word in element.text.split()]

    def start(self):
        return min(numbers["INPUT"][0] for numbers, _ in self.channels.values())

    def value(self, channel, t):
        """["Curve interpolation"]; matrices have a key on each frame, or step."""
        numbers, words = channel
        times, values = numbers["INPUT"], np.array(numbers["OUTPUT"]).reshape(len(numbers["INPUT"]), -1)
        k = max([i for i, time in enumerate(times) if time <= t + 1e-5], default=0)
        if k + 1 == len(times) or words[k] == "STEP":
            return values[k]
        if values.shape[1] == 16:
            return values[int(np.argmin(np.abs(np.array(times) - t)))]
        if words[k] == "LINEAR":
            return values[k] + (t - times[k]) / (times[k + 1] - times[k]) * (values[k + 1] - values[k])
        x = times[k], numbers["OUT_TANGENT"][2 * k], numbers["IN_TANGENT"][2 * k + 2], times[k + 1]
        y = values[k, 0], numbers["OUT_TANGENT"][2 * k + 1], numbers["IN_TANGENT"][2 * k + 3], values[k + 1, 0]
        cubic = [x[3] - 3 * x[2] + 3 * x[1] - x[0], 3 * (x[2] - 2 * x[1] + x[0]), 3 * (x[1] - x[0]), x[0] - t]
        [s] = [r.real for r in np.roots(cubic) if abs(r.imag) < 1e-9 and -1e-9 < r.real < 1 + 1e-9][:1]
        r = 1 - s
        return np.array([r**3 * y[0] + 3 * r * r * s * y[1] + 3 * r * s * s * y[2] + s**3 * y[3]])

    def places(self, t):
        places = {}

        def walk(node, above):
            world = above
            for element in node:
                kind = element.tag[len(self.NS):]
                if kind in ("translate", "rotate", "matrix"):
                    world = world @ self.transform(node.get("id"), kind, element, t)
            places[node.get("name")] = world[:3, 3]
            for child in node.findall(self.NS + "node"):
                walk(child, world)
        for scene in self.root.iter(self.NS + "visual_scene"):
            for node in scene.findall(self.NS + "node"):
                walk(node, np.eye(4))
        return places

    def transform(self, node, kind, element, t):
        numbers, target = np.array(self.numbers(element)), f"{node}/{element.get('sid')}"
        if target in self.channels:
            numbers = self.value(self.channels[target], t)
        if target + ".ANGLE" in self.channels:
            numbers[3] = self.value(self.channels[target + ".ANGLE"], t)[0]
        if kind == "matrix":
            return numbers.reshape(4, 4)
        if kind == "translate":
            return placed(np.eye(3), numbers)
        half = np.radians(numbers[3]) / 2
        axis = numbers[:3] / np.linalg.norm(numbers[:3])
        return placed(turn_of(np.append(np.sin(half) * axis, np.cos(half))), np.zeros(3))


def largest_distance(a, b):
    """After the similarity that takes a nearest to b."""
    a, b = np.array(a), np.array(b)
    a, b = a - a.mean(0), b - b.mean(0)
    u, s, vt = np.linalg.svd(a.T @ b)
    sign = np.diag([1, 1, np.sign(np.linalg.det(u @ vt))])
    scale = np.trace(np.diag(s) @ sign) / (a * a).sum()
    return np.linalg.norm(scale * a @ (u @ sign @ vt) - b, axis=1).max()


class Reports(InFolder):
    def compare(self, path, truth, num_joints):
        done = run("--bake", "-", path)
        self.assertEqual(done.returncode, 0, done.stderr)
        motion = json.loads(done.stdout)
        joints = motion["joint_groups"]
        ours, theirs = [], []
        for k, frame in enumerate(motion["frames"]):
            places = truth.places(truth.start() + k / motion["fps"])
            for joint in dict.fromkeys(joints):
                ours.append(frame["joint_positions_m"][joints.index(joint)])
                theirs.append(places[joint])
        self.assertEqual(len(set(joints)), num_joints, path.name)
        off = 1000 * largest_distance(ours, theirs)
        print(f"{path.name}: {len(motion['frames'])} frames, {num_joints} joints, off {off:.4f} mm", flush=True)
        self.assertLess(off, MOST, path.name)

    def test_gltf_is_as_its_specification_has_it(self):
        for name in GLTF:
            [path] = self.data_files("reports", name)
            self.compare(path, Gltf(path), 16)

    def test_collada_is_as_its_specification_has_it(self):
        for name in COLLADA:
            [path] = self.data_files("reports", name)
            self.compare(path, Collada(path), 2 if name.startswith("c6") else 16)


if __name__ == "__main__":
    main()
