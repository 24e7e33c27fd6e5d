#!/usr/bin/env -S /usr/bin/python3
"""Prints the skin of the shipped human, assets/skins/human.json.

  scripts/human_skin.py > assets/skins/human.json
  scripts/human_skin.py --check     exits 1 if the file differs from what would be printed

What the body looks like: skin/shape.py; how the skin follows the joints: skin/weights.py; its
colours: skin/paint.py. Metres; z up, x forward, y left, in the pelvis's coordinates.
"""

import base64
import json
import sys
from pathlib import Path

import numpy as np

from human_shapes import HAIR
from skin import paint, shape, weights
from skin.contour import contour, normals_of, relaxed, triangles_of
from skin.posture import BODIES, Body
from skin.sizes import hair_size_at, size_at

OUTPUT = Path(__file__).resolve().parent.parent / "assets" / "skins" / "human.json"
LOW, HIGH = (-0.4, -1.0, -1.0), (0.6, 1.0, 0.9)  # of the space that is looked at [m]
FINEST, LEVELS = 0.005, 4                        # the smallest cell [m]; doublings to the largest
STEP = 1e-5                                      # positions are rounded to [m]
DIGITS = 5                                       # of weights and places in the picture


def surface(distance, size):
    vertices, faces = contour(distance, size, LOW, HIGH, FINEST, LEVELS)
    vertices = relaxed(distance, vertices, faces, times=6)
    vertices = np.round(vertices / STEP) * STEP
    return vertices, triangles_of(vertices, faces)


# --- As the file has it ---------------------------------------------------------------------------


def packed(values, kind):
    return base64.b64encode(np.ascontiguousarray(values, kind).tobytes()).decode()


def body_of(bone):
    name = bone[0] if isinstance(bone, tuple) else bone
    if not name.startswith("l_"):
        return BODIES[bone]
    right = "r_" + name[2:]
    return BODIES[(right, bone[1]) if isinstance(bone, tuple) else right].mirrored()


def bind(bone, index):
    body: Body = body_of(bone)
    rows = []
    for i in range(3):
        axis = [float(body.R[k][i]) for k in range(3)]
        rows += [*axis, -sum(axis[k] * float(body.origin[k]) for k in range(3))]
    return {"bone": index, "inverse_bind": [round(value, 9) + 0.0 for value in rows]}


def mesh(name, material, vertices, triangles, table, places=None):
    """`table`: a row of weights of all bones for each vertex."""
    names = weights.bones()
    order = np.argsort(-table, axis=1, kind="stable")[:, :weights.MOST]
    shares = np.round(np.take_along_axis(table, order, 1), DIGITS)
    shares[:, 0] = 1 - shares[:, 1] - shares[:, 2] - shares[:, 3]
    if places is None:
        places = np.zeros((0, 2))
    return {"name": name, "material": material,
            "binds": [bind(bone, i) for i, bone in enumerate(names)],
            "positions": packed(vertices, "<f4"),
            "normals": packed(normals_of(vertices, triangles), "<f4"),
            "texture_coordinates": packed(np.round(places, DIGITS), "<f4"),
            "bind_indices": packed(order, "<u2"),
            "weights": packed(shares, "<f4"),
            "triangles": packed(triangles, "<u4")}


# --- The meshes -----------------------------------------------------------------------------------


def body_mesh():
    vertices, triangles = surface(shape.body, size_at)
    table = weights.weights(vertices, triangles)
    places = paint.body_places(vertices, weights.shares_at(vertices))
    # The head has a chart of its own, down to the chin and the hair of the nape: along its border
    # there are two vertices in one place.
    head = BODIES["neck"].local(vertices)
    is_head = head[:, 2] > 0.030 + 0.5 * np.clip(0.02 - head[:, 0], 0, 0.08)
    of_head = is_head[triangles].all(axis=1)
    number = np.full(len(vertices), -1)
    in_both = np.intersect1d(triangles[of_head], triangles[~of_head])
    only_head = np.setdiff1d(triangles[of_head], in_both)
    number[in_both] = len(vertices) + np.arange(len(in_both))
    number[only_head] = only_head
    split = np.where(of_head[:, None], number[triangles], triangles)
    origin = np.concatenate([np.arange(len(vertices)), in_both])
    places = places[origin]
    on_head = np.union1d(only_head, number[in_both])
    places[on_head] = paint.head_places(vertices[origin[on_head]])
    made = mesh("human", 0, vertices[origin], split, table[origin], places)
    made["normals"] = packed(normals_of(vertices, triangles)[origin], "<f4")
    return made


def hair_mesh():
    vertices, triangles = surface(shape.hair_on, hair_size_at)
    table = np.zeros((len(vertices), len(weights.bones())))
    table[:, weights.bones().index("neck")] = 1
    return mesh("hair", 1, vertices, triangles, table)


def linear(color):
    value = paint.rgb(color) / 255
    curve = np.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4)
    return [round(float(c), 5) for c in curve]


def bone_entry(bone):
    return {"joint": bone[0], "share": bone[1]} if isinstance(bone, tuple) else bone


def skin():
    image = base64.b64encode(paint.png(paint.picture())).decode()
    return {"notes": ["Written by scripts/human_skin.py; edit that."],
            "bones": [bone_entry(bone) for bone in weights.bones()],
            "meshes": [body_mesh(), hair_mesh()],
            "materials": [{"name": "body", "base_color": [1, 1, 1, 1], "texture": 0},
                          {"name": "hair", "base_color": [*linear(HAIR), 1], "texture": -1}],
            "textures": [{"name": "human.png", "image": image}]}


def main():
    printed = json.dumps(skin(), indent=1) + "\n"
    if "--check" in sys.argv[1:]:
        if OUTPUT.read_text() != printed:
            sys.exit(f"{OUTPUT.name} is not what scripts/human_skin.py prints")
        return
    sys.stdout.write(printed)


if __name__ == "__main__":
    main()
