"""Rigs as others build them, made from characters of the data: other names, feet and hands that hang
beside their limbs, a scaled or turned node above the skeleton, a root without weights, no clip."""

import copy
import json
import struct

import numpy as np

from foreign_reader import Gltf

KNIGHT = {"hips": ("hips", ""), "spine": ("spine", ""), "chest": ("chest", ""), "head": ("head", ""),
          "upperarm.l": ("upperarm", "l"), "lowerarm.l": ("lowerarm", "l"), "wrist.l": ("wrist", "l"), "hand.l": ("hand", "l"),
          "upperleg.l": ("thigh", "l"), "lowerleg.l": ("shin", "l"), "foot.l": ("foot", "l"), "toes.l": ("toe", "l"),
          "handslot.l": ("slot", "l")}
KNIGHT |= {name[:-1] + "r": (part, "r") for name, (part, side) in KNIGHT.items() if side}
NAMES = {
    "mixamo": {"hips": "Hips", "spine": "Spine", "chest": "Spine1", "head": "Head", "upperarm": "Arm", "lowerarm": "ForeArm",
               "wrist": "ForeArmTwist", "hand": "Hand", "thigh": "UpLeg", "shin": "Leg", "foot": "Foot", "toe": "ToeBase", "slot": "HandProp"},
    "unreal": {"hips": "pelvis", "spine": "spine_01", "chest": "spine_02", "head": "head", "upperarm": "upperarm",
               "lowerarm": "lowerarm", "wrist": "lowerarm_twist_01", "hand": "hand", "thigh": "thigh", "shin": "calf", "foot": "foot",
               "toe": "ball", "slot": "weapon"},
    "rigify": {"hips": "DEF-spine", "spine": "DEF-spine.001", "chest": "DEF-spine.002", "head": "DEF-head", "upperarm": "DEF-upper_arm",
               "lowerarm": "DEF-forearm", "wrist": "DEF-forearm.001", "hand": "DEF-hand", "thigh": "DEF-thigh", "shin": "DEF-shin",
               "foot": "DEF-foot", "toe": "DEF-toe", "slot": "DEF-prop"},
    "nonsense": {},
}
VRM = {"hips": "hips", "spine": "spine", "chest": "chest", "head": "head", "upperarm": "UpperArm", "lowerarm": "LowerArm",
       "hand": "Hand", "thigh": "UpperLeg", "shin": "LowerLeg", "foot": "Foot", "toe": "Toes"}


def manner(style, part, side):
    name = NAMES[style][part]
    if style == "mixamo":
        return "mixamorig:" + {"l": "Left", "r": "Right", "": ""}[side] + name
    if style == "unreal":
        return name + (f"_{side}" if side else "")
    return name + (f".{side.upper()}" if side else "")


class Rig:
    """A glTF document that is changed and written as .glb; all buffers become one."""

    def __init__(self, path, clips=None):
        source = Gltf(path)
        self.json = copy.deepcopy(source.json)
        starts, self.binary = [], b""
        for data in source.buffers:
            self.binary += b"\0" * (-len(self.binary) % 4)
            starts.append(len(self.binary))
            self.binary += data
        for view in self.json["bufferViews"]:
            view["byteOffset"] = view.get("byteOffset", 0) + starts[view["buffer"]]
            view["buffer"] = 0
        if clips is not None:
            self.json["animations"] = [a for a in self.json.get("animations", []) if a.get("name") in clips]
            if not self.json["animations"]:
                del self.json["animations"]

    def node(self, name):
        return next(i for i, node in enumerate(self.json["nodes"]) if node.get("name") == name)

    def add_floats(self, values, kind):
        values = np.asarray(values, "<f4")
        self.binary += b"\0" * (-len(self.binary) % 4)
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.binary), "byteLength": values.nbytes})
        self.binary += values.tobytes()
        accessor = {"bufferView": len(self.json["bufferViews"]) - 1, "componentType": 5126,
                    "count": len(values), "type": kind}
        if kind == "SCALAR":
            accessor |= {"min": [float(values.min())], "max": [float(values.max())]}
        self.json["accessors"].append(accessor)
        return len(self.json["accessors"]) - 1

    def write(self, path):
        self.json["buffers"] = [{"byteLength": len(self.binary)}]
        text = json.dumps(self.json).encode()
        text += b" " * (-len(text) % 4)
        binary = self.binary + b"\0" * (-len(self.binary) % 4)
        path.write_bytes(b"glTF" + struct.pack("<II", 2, 28 + len(text) + len(binary)) +
                         struct.pack("<I", len(text)) + b"JSON" + text + struct.pack("<I", len(binary)) + b"BIN\0" + binary)

    def rename(self, style):
        for i, node in enumerate(self.json["nodes"]):
            part = KNIGHT.get(node.get("name"))
            if style == "nonsense":
                node["name"] = f"b{i}"
            elif part:
                node["name"] = manner(style, *part)

    def add_vrm(self):
        """Names without meaning, roles as avatars say them."""
        bones = []
        for i, node in enumerate(self.json["nodes"]):
            part, side = KNIGHT.get(node.get("name"), ("", ""))
            if part in VRM:
                bones.append({"bone": {"l": "left", "r": "right", "": ""}[side] + VRM[part], "node": i})
            node["name"] = f"b{i}"
        self.json["extensionsUsed"] = [*self.json.get("extensionsUsed", []), "VRM"]
        self.json["extensions"] = {"VRM": {"humanoid": {"humanBones": bones}}}

    def put_above(self, **transform):
        """A node above all others of the scene."""
        scene = self.json["scenes"][self.json.get("scene", 0)]
        self.json["nodes"].append({"name": "above", "children": scene["nodes"], **transform})
        scene["nodes"] = [len(self.json["nodes"]) - 1]

    def scale_inside(self, factor):
        """Everything `factor` times as large, below a node that makes it as large as it was."""
        animated = {}
        for animation in self.json.get("animations", []):
            for channel in animation["channels"]:
                if channel["target"].get("path") == "translation":
                    animated[animation["samplers"][channel["sampler"]]["output"]] = True
        self.rewrite(animated, lambda values: factor * values)
        for node in self.json["nodes"]:
            if "translation" in node:
                node["translation"] = [factor * x for x in node["translation"]]
            if "mesh" in node and "skin" not in node:
                node["scale"] = [factor * x for x in node.get("scale", [1.0, 1.0, 1.0])]
        binds = {skin["inverseBindMatrices"]: True for skin in self.json.get("skins", [])}

        def bound(matrices):
            m = matrices.reshape(-1, 4, 4)
            m[:, :, :3] = factor * m[:, :, :3]  # columns are rows here: of v' = factor B v
            return m.reshape(-1, 16)

        self.rewrite(binds, bound)
        self.put_above(scale=[1.0 / factor] * 3)

    def rewrite(self, accessors, change):
        source = Gltf.__new__(Gltf)
        source.json, source.buffers = self.json, [self.binary]
        for index in accessors:
            values = change(source.values(index))
            kind = self.json["accessors"][index]["type"]
            self.json["accessors"][index] = self.json["accessors"][self.add_floats(values, kind)]
            source.buffers = [self.binary]

    def take_off(self, names, clip, fps=30.0):
        """Hangs nodes beside their limbs, on the top of the scene, with their ways as keys."""
        source = Gltf.__new__(Gltf)
        source.json, source.buffers = self.json, [self.binary]
        source.parents = {c: i for i, n in enumerate(self.json["nodes"]) for c in n.get("children", [])}
        animation = next(i for i, a in enumerate(self.json["animations"]) if a.get("name") == clip)
        curves = source.curves(animation)
        end = max(times[-1] for times, _, _ in curves.values())
        times = np.arange(0.0, end + 0.5 / fps, 1.0 / fps)
        worlds = [source.worlds(curves, t) for t in times]
        rest = source.worlds({}, 0.0)
        top = self.node(names[0])
        while top in source.parents:
            top = source.parents[top]
        clip_json = self.json["animations"][animation]
        time_accessor = self.add_floats(times, "SCALAR")
        for name in names:
            i = self.node(name)
            above = self.json["nodes"][source.parents[i]]
            above["children"].remove(i)
            if not above["children"]:
                del above["children"]
            self.json["nodes"][top].setdefault("children", []).append(i)
            below = [np.linalg.inv(w[top]) @ w[i] for w in worlds]
            clip_json["channels"] = [c for c in clip_json["channels"] if c["target"].get("node") != i]
            rotations = [quaternion(m) for m in below]
            for a, b in zip(rotations, rotations[1:]):
                if np.dot(a, b) < 0.0:
                    b *= -1.0
            for path, values, kind in (("translation", [m[:3, 3] for m in below], "VEC3"), ("rotation", rotations, "VEC4")):
                clip_json["samplers"].append({"input": time_accessor, "output": self.add_floats(values, kind)})
                clip_json["channels"].append({"sampler": len(clip_json["samplers"]) - 1, "target": {"node": i, "path": path}})
            own = np.linalg.inv(rest[top]) @ rest[i]
            node = self.json["nodes"][i]
            node.pop("matrix", None)
            node["translation"], node["rotation"] = own[:3, 3].tolist(), quaternion(own).tolist()


def quaternion(m):
    """x, y, z, w of a matrix with an even scale."""
    r = m[:3, :3] / np.cbrt(np.linalg.det(m[:3, :3]))
    k = np.array([[r[0, 0] - r[1, 1] - r[2, 2], 0, 0, 0], [r[0, 1] + r[1, 0], r[1, 1] - r[0, 0] - r[2, 2], 0, 0],
                  [r[0, 2] + r[2, 0], r[1, 2] + r[2, 1], r[2, 2] - r[0, 0] - r[1, 1], 0],
                  [r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1], r[0, 0] + r[1, 1] + r[2, 2]]]) / 3.0
    return np.linalg.eigh(k)[1][:, -1]


def make_rigs(data, out):
    """Ten rigs in a folder. {name: path}"""
    knight, cesium, boxman = data / "characters/kaykit_Knight.glb", data / "characters/khronos_cesium_man.gltf", data / "own/boxman.glb"
    made = {}

    def add(name, source, *changes, clips=("Walking_A",)):
        rig = Rig(source, clips)
        for change in changes:
            change(rig)
        made[name] = out / (name + (".vrm" if "vrm" in name else ".glb"))
        rig.write(made[name])

    add("no_clip", knight, clips=())
    add("feet_apart", knight, lambda r: r.take_off(["foot.l", "foot.r"], "Walking_A"))
    add("hands_apart", knight, lambda r: r.take_off(["hand.l", "hand.r"], "Walking_A"))
    for style in ("mixamo", "unreal", "rigify"):
        add(style, knight, lambda r, style=style: r.rename(style))
    add("vrm", knight, lambda r: r.add_vrm())
    add("node_of_scale_0_01", knight, lambda r: r.scale_inside(100.0))
    add("root_without_weights", boxman, lambda r: r.put_above(), clips=("run",))
    add("faces_sideways", cesium, lambda r: r.put_above(rotation=[0.0, np.sqrt(0.5), 0.0, np.sqrt(0.5)]), clips=None)
    return made
