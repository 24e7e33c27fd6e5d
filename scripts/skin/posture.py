"""Where the human's bodies are while the skin is put on: between the limits of its joints, so that
no joint bends or stretches the skin more than it must. The pelvis's origin is the origin."""

import math

import numpy as np

from human_figure import joints

ANGLES = {
    "r_shoulder": (12, 0, 44), "r_elbow": (24, 0), "r_wrist": (0, 0),
    "r_hip": (14, 9, 0), "r_knee": (26,), "r_ankle": (12, 0), "r_toe": (0,),
}


def turn(axis, angle_deg):
    x, y, z = axis
    c, s = math.cos(math.radians(angle_deg)), math.sin(math.radians(angle_deg))
    return np.array([[c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s],
                     [y * x * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s],
                     [z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c)]])


def product(a, b):
    """Without a library that sums in another order elsewhere."""
    return np.array([[sum(a[i][k] * b[k][j] for k in range(a.shape[1]))
                      for j in range(b.shape[1])] for i in range(a.shape[0])])


class Body:
    """Takes a body's coordinates to the pelvis's: R p + origin."""

    def __init__(self, R, origin):
        self.R, self.origin = R, np.array(origin, float)

    def local(self, points):
        d = points - self.origin
        return np.stack([d[:, 0] * self.R[0][i] + d[:, 1] * self.R[1][i] + d[:, 2] * self.R[2][i]
                         for i in range(3)], 1)

    def placed(self, point):
        return product(self.R, np.array(point, float)[:, None])[:, 0] + self.origin

    def mirrored(self):
        flip = np.array([1.0, -1.0, 1.0])
        return Body(self.R * flip[:, None] * flip[None, :], self.origin * flip)


def bodies():
    """Every body of pelvis, trunk, head and the right limbs, by the name of its joint. A bone that
    takes a share of its joint's angles is called (joint or hinge, share)."""
    found = {"pelvis": Body(np.eye(3), (0, 0, 0))}
    for joint in joints():
        parent = found[joint["parent"]]
        origin = parent.placed(joint["offset_m"])
        angles = ANGLES.get(joint["name"], (0,) * len(joint["hinges"]))
        full, half = parent.R, parent.R
        for hinge, angle in zip(joint["hinges"], angles):
            name = "_".join([joint["name"], *([hinge["name"]] if "name" in hinge else [])])
            found[name, 0.5] = Body(product(full, turn(hinge["axis"], angle / 2)), origin)
            full = product(full, turn(hinge["axis"], angle))
            half = product(half, turn(hinge["axis"], angle / 2))
            found[name] = Body(full, origin)
        found[joint["name"]] = Body(full, origin)
        found[joint["name"], 0.5] = Body(half, origin)
    return found


BODIES = bodies()
