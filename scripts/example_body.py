"""Where the bodies of a figure are in a frame of a baked motion, for check_examples: figure files with links of a given mass."""

import json
import math
import pathlib

AXES = {"x": [1, 0, 0], "y": [0, 1, 0], "z": [0, 0, 1],
        "-x": [-1, 0, 0], "-y": [0, -1, 0], "-z": [0, 0, -1]}


def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def turned(a, v):
    return [sum(a[i][k] * v[k] for k in range(3)) for i in range(3)]


def plus(a, b):
    return [x + y for x, y in zip(a, b)]


def about(axis, degrees):
    """The rotation about a unit axis [Rodrigues]."""
    x, y, z = axis
    s, c = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
    d = 1 - c
    return [[c + x * x * d, x * y * d - z * s, x * z * d + y * s],
            [y * x * d + z * s, c + y * y * d, y * z * d - x * s],
            [z * x * d - y * s, z * y * d + x * s, c + z * z * d]]


def of_quaternion(q):
    w, x, y, z = q
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]


class Body:
    """A figure file's joints, the mirrored ones too, parents first."""

    def __init__(self, file):
        figure = json.loads(pathlib.Path(file).read_text(encoding="utf-8"))
        self.root = figure["root"]
        mirror = figure.get("mirror")
        self.joints = list(figure["joints"])
        if mirror:
            self.joints += [self._twin(joint, mirror) for joint in figure["joints"]
                            if joint["name"].startswith(mirror["from"])]

    @staticmethod
    def _twin(joint, mirror):
        def name(text):
            begins = text.startswith(mirror["from"])
            return mirror["to"] + text[len(mirror["from"]):] if begins else text

        def place(v):
            return [v[0], -v[1], v[2]]

        def hinge(h):
            axis = AXES[h["axis"]] if isinstance(h["axis"], str) else h["axis"]
            return {**h, "axis": [-axis[0], axis[1], -axis[2]]}

        def link(part):
            i = part.get("inertia_kg_m2", [0] * 6)
            return {**part, "com_m": place(part.get("com_m", [0, 0, 0])),
                    "inertia_kg_m2": [i[0], i[1], i[2], -i[3], i[4], -i[5]]}
        return {"name": name(joint["name"]), "parent": name(joint["parent"]),
                "offset_m": place(joint["offset_m"]),
                "hinges": [hinge(h) for h in joint["hinges"]],
                "links": [link(part) for part in joint["links"]]}

    def frames(self, motion, index):
        """The place and rotation of every joint's body, by its name, in frame `index`."""
        frame = motion["frames"][index]
        angle = dict(zip(motion["joints"], frame["angles_deg"]))
        found = {self.root["name"]: (frame["root"]["position"],
                                     of_quaternion(frame["root"]["quaternion_wxyz"]))}
        left = list(self.joints)
        while left:
            joint = left.pop(0)
            if joint["parent"] not in found:
                left.append(joint)
                continue
            at, turn = found[joint["parent"]]
            at = plus(at, turned(turn, joint["offset_m"]))
            for hinge in joint["hinges"]:
                name = joint["name"] + (f"_{hinge['name']}" if "name" in hinge else "")
                axis = AXES[hinge["axis"]] if isinstance(hinge["axis"], str) else hinge["axis"]
                turn = times(turn, about(axis, angle[name]))
            found[joint["name"]] = (at, turn)
        return found

    def point(self, motion, index, joint, offset):
        at, turn = self.frames(motion, index)[joint]
        return plus(at, turned(turn, offset))

    def about_y(self, motion, index, x, z):
        """Mass [kg], distance of its centre and moment of inertia [kg m^2] about the line along y."""
        mass, moment, centre = 0.0, 0.0, [0.0, 0.0]
        found = self.frames(motion, index)
        for part in [self.root, *self.joints]:
            at, turn = found[part["name"]]
            for link in part["links"]:
                m = link.get("mass_kg", 0)
                if m == 0:
                    continue
                c = plus(at, turned(turn, link["com_m"]))
                i = link["inertia_kg_m2"]
                tensor = [[i[0], i[3], i[4]], [i[3], i[1], i[5]], [i[4], i[5], i[2]]]
                row = turn[1]
                moment += sum(row[j] * tensor[j][k] * row[k] for j in range(3) for k in range(3))
                moment += m * ((c[0] - x) ** 2 + (c[2] - z) ** 2)
                centre = [centre[0] + m * (c[0] - x), centre[1] + m * (c[2] - z)]
                mass += m
        return mass, math.hypot(*centre) / mass, moment
