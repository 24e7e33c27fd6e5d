"""Positions of nodes in glTF and BVH files, by numpy: independent of what the program reads with."""

import base64
import json
import pathlib
import re
import struct

import numpy as np

FORMATS = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
MOST = {5120: 127.0, 5121: 255.0, 5122: 32767.0, 5123: 65535.0}  # of normalized numbers
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


def rotation(q):
    x, y, z, w = np.asarray(q, float) / np.linalg.norm(q)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def slerp(a, b, u):
    if np.dot(a, b) < 0.0:
        b = -b
    angle = np.arccos(np.clip(np.dot(a, b), -1.0, 1.0))
    if angle < 1e-6:
        return (1 - u) * a + u * b
    return (np.sin((1 - u) * angle) * a + np.sin(u * angle) * b) / np.sin(angle)


class Gltf:
    """A .glb, .vrm or .gltf file."""

    def __init__(self, path):
        path = pathlib.Path(path)
        data = path.read_bytes()
        self.binary = b""
        if data[:4] == b"glTF":
            at = 12
            while at < len(data):
                size, kind = struct.unpack("<I4s", data[at:at + 8])
                if kind == b"JSON":
                    self.json = json.loads(data[at + 8:at + 8 + size])
                else:
                    self.binary = data[at + 8:at + 8 + size]
                at += 8 + size
        else:
            self.json = json.loads(data)
        self.buffers = []
        for buffer in self.json.get("buffers", []):
            uri = buffer.get("uri")
            if uri is None:
                self.buffers.append(self.binary)
            elif uri.startswith("data:"):
                self.buffers.append(base64.b64decode(uri.split(",", 1)[1]))
            else:
                self.buffers.append((path.parent / uri).read_bytes())
        self.parents = {child: i for i, node in enumerate(self.json["nodes"]) for child in node.get("children", [])}

    def accessor_bytes(self, index):
        """The bytes of the view that an accessor reads, with what says how."""
        accessor = self.json["accessors"][index]
        if "bufferView" not in accessor:
            return accessor, b""
        view = self.json["bufferViews"][accessor["bufferView"]]
        start = view.get("byteOffset", 0)
        plain = {key: value for key, value in accessor.items() if key != "bufferView"}
        return plain, self.buffers[view["buffer"]][start:start + view["byteLength"]]

    def values(self, index):
        accessor = self.json["accessors"][index]
        kind, width = accessor["componentType"], WIDTHS[accessor["type"]]
        view = self.json["bufferViews"][accessor["bufferView"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        item = np.dtype(FORMATS[kind]).itemsize * width
        stride = view.get("byteStride", item)
        data = self.buffers[view["buffer"]]
        rows = [np.frombuffer(data, FORMATS[kind], width, start + stride * i) for i in range(accessor["count"])]
        numbers = np.array(rows, float)
        if accessor.get("normalized"):
            numbers = np.maximum(numbers / MOST[kind], -1.0)
        return numbers

    def animation(self, name):
        for i, animation in enumerate(self.json.get("animations", [])):
            if not name or animation.get("name", f"clip {i + 1}") == name:
                return i
        raise AssertionError(f"no animation {name}")

    def curves(self, animation):
        """{(node, path): (times, values, interpolation)}"""
        found = {}
        clip = self.json["animations"][animation]
        for channel in clip["channels"]:
            sampler = clip["samplers"][channel["sampler"]]
            if "node" not in channel["target"]:
                continue
            found[channel["target"]["node"], channel["target"]["path"]] = (
                self.values(sampler["input"])[:, 0], self.values(sampler["output"]),
                sampler.get("interpolation", "LINEAR"))
        return found

    @staticmethod
    def at(curve, t, turns):
        times, values, how = curve
        if how == "CUBICSPLINE":
            tangents_in, points, tangents_out = values[0::3], values[1::3], values[2::3]
        else:
            points = values
        if t <= times[0]:
            return points[0]
        if t >= times[-1]:
            return points[-1]
        k = int(np.searchsorted(times, t, side="right")) - 1
        span = times[k + 1] - times[k]
        u = (t - times[k]) / span
        if how == "STEP":
            return points[k]
        if how == "CUBICSPLINE":
            return ((2 * u**3 - 3 * u**2 + 1) * points[k] + span * (u**3 - 2 * u**2 + u) * tangents_out[k] +
                    (-2 * u**3 + 3 * u**2) * points[k + 1] + span * (u**3 - u**2) * tangents_in[k + 1])
        return slerp(points[k], points[k + 1], u) if turns else (1 - u) * points[k] + u * points[k + 1]

    def worlds(self, curves, t):
        """4 x 4 matrices of all nodes at a time."""
        done = {}

        def world(i):
            if i in done:
                return done[i]
            node = self.json["nodes"][i]
            parts = {"translation": np.zeros(3), "rotation": np.array([0, 0, 0, 1.0]), "scale": np.ones(3)}
            moved = [path for path in parts if (i, path) in curves]
            local = np.eye(4)
            if "matrix" in node and not moved:
                local = np.array(node["matrix"], float).reshape(4, 4).T
            else:
                for path in parts:
                    if path in node:
                        parts[path] = np.array(node[path], float)
                    if path in moved:
                        parts[path] = self.at(curves[i, path], t, path == "rotation")
                local[:3, :3] = rotation(parts["rotation"]) @ np.diag(parts["scale"])
                local[:3, 3] = parts["translation"]
            done[i] = (world(self.parents[i]) if i in self.parents else np.eye(4)) @ local
            return done[i]

        return [world(i) for i in range(len(self.json["nodes"]))]

    def places(self, animation, times):
        """[frame][node] positions, and names of the nodes."""
        curves = self.curves(animation)
        names = [node.get("name", f"node_{i}") for i, node in enumerate(self.json["nodes"])]
        return np.array([[m[:3, 3] for m in self.worlds(curves, t)] for t in times]), names

    def start(self, animation):
        return min(times[0] for times, _, _ in self.curves(animation).values())


class Bvh:
    def __init__(self, path):
        text = pathlib.Path(path).read_bytes().decode("utf-8", "replace").lstrip("\ufeff")
        head, self.motion = re.split(r"\bMOTION\b", text, maxsplit=1)
        self.head = head
        self.names, self.parents, self.offsets, self.channels = [], [], [], []
        open_joints, is_end, words = [], False, head.split()
        columns = 0
        for i, word in enumerate(words):
            if word in ("ROOT", "JOINT"):
                self.names.append(words[i + 1])
                self.parents.append(open_joints[-1] if open_joints else -1)
                self.offsets.append(None)
                self.channels.append([])
                pending = len(self.names) - 1
            elif word == "End":
                pending = None
            elif word == "{":
                open_joints.append(pending)
                is_end = pending is None
            elif word == "}":
                open_joints.pop()
                is_end = False
            elif word == "OFFSET" and not is_end:
                self.offsets[open_joints[-1]] = np.array([float(x) for x in words[i + 1:i + 4]])
            elif word == "CHANNELS":
                count = int(words[i + 1])
                self.channels[open_joints[-1]] = [(columns + k, name) for k, name in enumerate(words[i + 2:i + 2 + count])]
                columns += count
        self.width = columns
        self.words = re.split(r"Frame Time:\s*\S+", self.motion)[1].split()
        self.rows = np.array([float(word) for word in self.words]).reshape(-1, columns)

    def places(self):
        everything = []
        for row in self.rows:
            worlds, places = [], []
            for joint, parent in enumerate(self.parents):
                turn, place = np.eye(3), self.offsets[joint].copy()
                if any(name.endswith("position") for _, name in self.channels[joint]):
                    place = np.zeros(3)
                for column, name in self.channels[joint]:
                    axis = "XYZ".index(name[0].upper())
                    if name.lower().endswith("position"):
                        place[axis] = row[column]
                    else:
                        half = np.zeros(4)
                        half[axis], half[3] = np.sin(np.radians(row[column]) / 2), np.cos(np.radians(row[column]) / 2)
                        turn = turn @ rotation(half)
                above = worlds[parent] if parent >= 0 else (np.eye(3), np.zeros(3))
                worlds.append((above[0] @ turn, above[1] + above[0] @ place))
                places.append(worlds[-1][1])
            everything.append(places)
        return np.array(everything), self.names
