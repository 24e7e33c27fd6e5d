"""Which bones move each vertex, and how much: by where it is beside each joint.

Between a joint's two bodies lies a bone that turns half as far, so that skin which is bent far is
drawn over a round joint, and not through it.
"""

import numpy as np

from human_body import SIZE
from skin.contour import averaged, neighbours
from skin.posture import BODIES
from skin.shape import parts, right
from skin.solids import smooth_step

SMOOTHING = 3
MOST = 4  # bones of a vertex


def half(joint):
    return (joint, 0.5)


def ramp(value, middle, width):
    return smooth_step((value - middle) / width + 0.5)


class Shares:
    """The bones' weights, each an array over the vertices."""

    def __init__(self, count):
        self.of = {"pelvis": np.ones(count)}

    def pass_on(self, givers, t, *takers):
        """Of what the givers have, the share t goes to the taker; of two, over the first."""
        parts = (1 - t, t) if len(takers) == 1 else ((1 - t) ** 2, 2 * t * (1 - t), t * t)
        given = sum(self.of[giver] for giver in givers)
        for giver in givers:
            self.of[giver] = self.of[giver] * parts[0]
        for taker, part in zip(takers, parts[1:]):
            self.of[taker] = given * part


def shares_at(points):
    p = right(points)
    d = parts(points)
    at = {name: BODIES[name].local(p) for name in ("r_elbow_flexion", "r_wrist", "r_knee",
                                                   "r_ankle", "r_shoulder", "r_hip", "neck")}
    shares = Shares(len(p))
    shares.pass_on(["pelvis"], ramp(p[:, 2], 0.150, 0.19), "waist")
    shares.pass_on(["waist"], ramp(p[:, 2], 0.330, 0.19), "chest")
    head = at["neck"]
    shares.pass_on(["chest"], ramp(head[:, 2] - 0.3 * head[:, 0], 0.012, 0.11), half("neck"),
                   "neck")
    add_arm(shares, d, at)
    add_leg(shares, p, d, at)
    return shares.of


def add_arm(shares, d, at):
    trunk, legs = np.minimum(d["trunk"], d["head"]), np.minimum(d["leg"], d["foot"])
    on_arm = ramp(trunk - d["arm"], 0.010, 0.11) * ramp(legs - d["arm"], 0.03, 0.06)
    shares.pass_on(["pelvis", "waist", "chest", half("neck"), "neck"], on_arm, half("r_shoulder"),
                   "r_shoulder")
    # Along the limb, halfway between both its bones.
    forearm, upper = at["r_elbow_flexion"], at["r_shoulder"]
    along = -(forearm[:, 2] + upper[:, 2] + SIZE["upper_arm"]) / 2
    shares.pass_on(["r_shoulder"], ramp(along, 0.0, 0.12), half("r_elbow_flexion"),
                   "r_elbow_flexion")
    shares.pass_on(["r_elbow_flexion"], ramp(-forearm[:, 2], 0.14, 0.22), half("r_elbow_pronation"),
                   "r_elbow")
    shares.pass_on(["r_elbow"], ramp(-at["r_wrist"][:, 2], 0.0, 0.075), half("r_wrist"), "r_wrist")


def add_leg(shares, p, d, at):
    leg = np.minimum(d["leg"], d["foot"])
    on_leg = ramp(d["trunk"] - leg, 0.000, 0.11) * ramp(d["arm"] - leg, 0.03, 0.06)
    # Between the legs the skin is the pelvis's, so that it does not part when they do.
    one_side = np.maximum(ramp(-p[:, 1], 0.022, 0.055), ramp(-p[:, 2], 0.140, 0.06))
    shares.pass_on(["pelvis", "waist"], on_leg * one_side, half("r_hip"), "r_hip")
    thigh, shank, foot = at["r_hip"], at["r_knee"], at["r_ankle"]
    along = -(shank[:, 2] + thigh[:, 2] + SIZE["thigh"]) / 2
    shares.pass_on(["r_hip"], ramp(along, 0.0, 0.16), half("r_knee"), "r_knee")
    below = -foot[:, 2] + 0.6 * np.maximum(foot[:, 0] - 0.03, 0)  # the instep is the foot's
    shares.pass_on(["r_knee"], ramp(below, 0.000, 0.075), half("r_ankle"), "r_ankle")
    shares.pass_on(["r_ankle"], ramp(foot[:, 0], SIZE["ball_x"], 0.050), "r_toe")


def other_side(bone):
    name, *share = bone if isinstance(bone, tuple) else (bone,)
    name = "l_" + name[2:] if name.startswith("r_") else name
    return (name, *share) if share else name


def bones():
    of_right = list(shares_at(np.zeros((1, 3))))
    return of_right + [other_side(bone) for bone in of_right if other_side(bone) != bone]


def weights(vertices, triangles):
    """A column for each bone of `bones()`; at most MOST in a row are not 0, and they add up to 1."""
    names = bones()
    table = np.zeros((len(vertices), len(names)))
    is_left = vertices[:, 1] > 0
    for bone, share in shares_at(vertices).items():
        table[~is_left, names.index(bone)] = share[~is_left]
        table[is_left, names.index(other_side(bone))] = share[is_left]
    edges = neighbours(triangles)
    for _ in range(SMOOTHING):
        table = 0.5 * (table + averaged(table, edges))
    least = np.sort(table, axis=1)[:, -MOST][:, None]
    table = np.where((table >= least) & (table > 1e-3), table, 0)
    total = np.zeros(len(table))
    for column in range(table.shape[1]):
        total = total + table[:, column]
    return table / total[:, None]
