"""The shape of the human: rounded solids on the figure's bodies, smoothly joined. All by eye.

Only the right half is said; the left is its reflection. Profiles run along each limb's z, which
points up the limb; x is forward, y to the left, that is, inwards.
"""

import numpy as np

from human_body import SIZE
from skin.posture import BODIES
from skin.solids import Profile, ball, cone, cut, join, join_all

GROUND = -SIZE["ankle_height"]  # under the ankle
# Where clothes end: down the arm, down the shank, above the hips (belt, collar) [m].
HEM = {"sleeve": 0.165, "trousers": 0.396, "belt": 0.085, "collar": 0.566}
TRUNK = SIZE["lower_trunk"] + SIZE["middle_trunk"]  # where the chest begins, above the hips

TORSO = Profile([
    (-0.115, 0.050, 0.045, 0.050, -0.004), (-0.080, 0.105, 0.080, 0.098, -0.006),
    (-0.040, 0.150, 0.098, 0.122, -0.006), (0.010, 0.163, 0.104, 0.126, -0.006),
    (0.060, 0.157, 0.106, 0.112, -0.004), (0.137, 0.145, 0.105, 0.094, 0.000),
    (0.210, 0.139, 0.104, 0.088, 0.002), (0.280, 0.145, 0.107, 0.094, 0.003),
    (0.340, 0.155, 0.113, 0.103, 0.002), (0.400, 0.163, 0.116, 0.110, 0.002),
    (0.450, 0.160, 0.106, 0.110, 0.000), (0.490, 0.136, 0.086, 0.098, -0.004),
    (0.525, 0.092, 0.068, 0.080, -0.008), (0.560, 0.072, 0.060, 0.064, -0.008),
    (0.600, 0.055, 0.053, 0.056, -0.002)], 0.04)
UPPER_ARM = Profile([
    (0.030, 0.028, 0.030, 0.030), (0.000, 0.038, 0.042, 0.042), (-0.040, 0.043, 0.047, 0.047),
    (-0.100, 0.043, 0.048, 0.046), (-0.150, 0.042, 0.046, 0.044), (-0.200, 0.039, 0.042, 0.042),
    (-0.250, 0.037, 0.037, 0.039), (-0.300, 0.035, 0.034, 0.036)], 0.035)
FOREARM = Profile([
    (0.030, 0.034, 0.034, 0.036), (0.000, 0.037, 0.037, 0.038), (-0.050, 0.040, 0.043, 0.041),
    (-0.090, 0.039, 0.043, 0.040), (-0.150, 0.032, 0.036, 0.035), (-0.210, 0.024, 0.029, 0.029),
    (-0.255, 0.0205, 0.0275, 0.0275), (-0.290, 0.018, 0.029, 0.029)], 0.015)
THIGH = Profile([
    (0.070, 0.060, 0.060, 0.060), (0.020, 0.082, 0.080, 0.088), (-0.050, 0.090, 0.090, 0.096),
    (-0.120, 0.085, 0.092, 0.090, 0.002, -0.002), (-0.200, 0.077, 0.087, 0.078, 0.003, -0.001),
    (-0.290, 0.068, 0.076, 0.066, 0.002), (-0.370, 0.060, 0.065, 0.060, 0.002),
    (-0.412, 0.058, 0.062, 0.058, 0.002), (-0.460, 0.054, 0.056, 0.052)], 0.05)
SHANK = Profile([
    (0.050, 0.054, 0.052, 0.050), (0.000, 0.057, 0.060, 0.056, 0.002), (-0.060, 0.056, 0.053, 0.061),
    (-0.120, 0.055, 0.049, 0.067), (-0.190, 0.052, 0.047, 0.064), (-0.270, 0.048, 0.046, 0.055),
    (-0.350, 0.046, 0.046, 0.052, -0.002), (-0.396, 0.046, 0.047, 0.052, -0.004)], 0.004)

FINGERS = {  # knuckle x, y, z; lengths; spread and curl of the phalanges [rad]; radii
    "index": ((0.0310, 0.000, -0.0880), (0.040, 0.025, 0.018), 0.07, (0.20, 0.52, 0.80), 0.0082),
    "middle": ((0.0103, -0.001, -0.0920), (0.044, 0.028, 0.019), 0.01, (0.26, 0.64, 0.95), 0.0085),
    "ring": ((-0.0105, 0.000, -0.0890), (0.040, 0.026, 0.018), -0.06, (0.34, 0.76, 1.08), 0.0080),
    "little": ((-0.0300, 0.002, -0.0820), (0.031, 0.019, 0.016), -0.14, (0.40, 0.84, 1.16), 0.0070),
}


def torso(p):
    chest = p - np.array([0, 0, TRUNK])
    d = TORSO(p)
    trapezius = cone(chest, (-0.022, -0.024, 0.206), (-0.012, -0.184, 0.132), 0.053, 0.040)
    pectoral = cone(chest, (0.048, -0.062, 0.078), (0.028, -0.150, 0.112), 0.064, 0.046)
    back = cone(chest, (-0.045, -0.080, 0.060), (-0.028, -0.160, 0.105), 0.066, 0.050)
    d = join(d, join(trapezius, join(pectoral, back, 0.04), 0.05), 0.05)
    seat = ball(p, (-0.052, -0.070, -0.030), (0.075, 0.076, 0.082))
    return join(d, seat, 0.045)


def upper_arm(p):
    deltoid = ball(p, (0.000, 0.003, -0.054), (0.048, 0.043, 0.072))
    bare = UPPER_ARM(p)
    sleeve = cut(join(bare, deltoid, 0.03) - 0.005, -HEM["sleeve"] - p[:, 2], 0.004)
    return join(bare, sleeve, 0.002)


def finger(p, knuckle, lengths, spread, curls, radius):
    parts, at = [], np.array(knuckle, float)
    for i, (size, curl) in enumerate(zip(lengths, curls)):
        s, c = _sine(curl)
        way = np.array([spread * c, s, -c])
        end = at + size * way / float((way * way).sum()) ** 0.5
        parts.append(cone(p, at, end, radius * (1 - 0.06 * i), radius * (0.94 - 0.06 * i)))
        at = end
    return join_all(parts, 0.0015)


def _sine(angle):
    """Sine and cosine by their series: the same everywhere."""
    a2 = angle * angle
    return (angle * (1 - a2 / 6 * (1 - a2 / 20 * (1 - a2 / 42))),
            1 - a2 / 2 * (1 - a2 / 12 * (1 - a2 / 30 * (1 - a2 / 56))))


def hand(p):
    palm = join_all([cone(p, (0.014, 0, -0.010), (0.028, 0, -0.084), 0.0165, 0.0125),
                     cone(p, (0.004, 0, -0.010), (0.009, -0.002, -0.086), 0.017, 0.013),
                     cone(p, (-0.006, 0, -0.010), (-0.010, -0.001, -0.083), 0.017, 0.013),
                     cone(p, (-0.014, 0, -0.012), (-0.027, 0.001, -0.076), 0.0155, 0.0125)], 0.012)
    fingers = join_all([finger(p, *FINGERS[name]) for name in FINGERS], 0.0015)
    thumb = join_all([cone(p, (0.016, 0.006, -0.018), (0.044, 0.020, -0.060), 0.0165, 0.0125),
                      cone(p, (0.044, 0.020, -0.060), (0.055, 0.027, -0.088), 0.0115, 0.0095),
                      cone(p, (0.055, 0.027, -0.088), (0.059, 0.033, -0.110), 0.0095, 0.0078)],
                     0.006)
    return join(join(palm, fingers, 0.007), thumb, 0.012)


def forearm(p, in_hand):
    return join(FOREARM(p), hand(in_hand), 0.012)


def foot(p, toe):
    shoe = join_all([cone(p, (-0.026, 0, -0.030), (0.055, 0, -0.034), 0.036, 0.034),
                     cone(p, (-0.004, 0, 0.012), (-0.008, 0, -0.030), 0.041, 0.038),
                     cone(p, (0.012, 0, -0.004), (0.095, -0.003, -0.038), 0.037, 0.030),
                     ball(p, (0.100, -0.003, -0.046), (0.072, 0.046, 0.032)),
                     ball(toe, (0.012, -0.003, -0.004), (0.062, 0.044, 0.030))], 0.022)
    sole = join(ball(p, (0.036, -0.002, -0.062), (0.104, 0.043, 0.024)),
                ball(toe, (0.004, -0.003, -0.021), (0.068, 0.045, 0.024)), 0.02)
    return cut(join(shoe, sole, 0.008), np.maximum(GROUND - p[:, 2], -1), 0.006)


def ankle(p):
    return cone(p, (-0.004, 0, -0.01), (-0.004, 0, 0.06), 0.036, 0.037)


def head(p):
    skull = ball(p, (0.010, 0, 0.137), (0.098, 0.076, 0.092))
    face = ball(p, (0.042, 0, 0.086), (0.061, 0.056, 0.068))
    jaw = join(ball(p, (0.042, 0, 0.056), (0.050, 0.043, 0.036)),
               ball(p, (0.076, 0, 0.036), (0.022, 0.024, 0.017)), 0.03)
    cheek = ball(p, (0.068, -0.034, 0.088), (0.030, 0.026, 0.026))
    d = join(join(join(skull, face, 0.03), jaw, 0.025), cheek, 0.02)
    brow = cone(p, (0.084, -0.046, 0.130), (0.098, -0.012, 0.131), 0.009, 0.010)
    d = join(d, brow, 0.018)
    socket = ball(p, (0.110, -0.032, 0.114), (0.017, 0.019, 0.013))
    d = -join(-d, socket, 0.012)
    eye = ball(p, (0.086, -0.031, 0.114), (0.0140, 0.0150, 0.0135))
    d = join(d, eye, 0.003)
    nose = join(cone(p, (0.101, 0, 0.126), (0.119, 0, 0.094), 0.0070, 0.0095),
                ball(p, (0.109, -0.009, 0.090), (0.010, 0.008, 0.0075)), 0.008)
    d = join(d, nose, 0.011)
    lips = join(ball(p, (0.094, 0, 0.0640), (0.0120, 0.0230, 0.0052)),
                ball(p, (0.092, 0, 0.0545), (0.0125, 0.0200, 0.0060)), 0.002)
    d = join(d, lips, 0.007)
    ear = ball(p, (-0.002, -0.0790, 0.105), (0.0190, 0.0085, 0.0300))
    hollow = ball(p, (0.002, -0.0900, 0.107), (0.0100, 0.0075, 0.0180))
    return join(d, -join(-ear, hollow, 0.006), 0.006)


def neck(p):
    return cone(p, (-0.014, 0, -0.04), (0.000, 0, 0.085), 0.054, 0.049)


def hair(p):
    """In the head's frame: a cap with a hair line, and what lies over the forehead."""
    cap = ball(p, (0.004, 0, 0.140), (0.103, 0.0835, 0.0975))
    top = ball(p, (0.052, 0, 0.205), (0.055, 0.060, 0.032))
    grown = join(cap, top, 0.03)
    line = 0.098 + 0.80 * (p[:, 0] - 0.010) - p[:, 2]
    temple = 0.165 - 0.9 * p[:, 0] - p[:, 2]
    behind = 0.062 - 0.30 * (p[:, 0] + 0.08) - p[:, 2]
    edge = cut(np.minimum(line, temple) * 0.75, behind, 0.02)
    return cut(grown, np.maximum(line * 0.78, behind), 0.012)


def right(points):
    """The points' reflection on the right side."""
    return np.stack([points[:, 0], -np.abs(points[:, 1]), points[:, 2]], 1)


def parts(points):
    """Distances to trunk, arm, thigh, shank, foot and head, in the posture; of the right side."""
    p = right(points)
    at = {name: BODIES[name].local(p)
          for name in ("r_shoulder", "r_elbow", "r_wrist", "r_hip", "r_knee", "r_ankle", "r_toe",
                       "neck")}
    return {
        "trunk": torso(p),
        "arm": join(upper_arm(at["r_shoulder"]), forearm(at["r_elbow"], at["r_wrist"]), 0.018),
        "leg": join(THIGH(at["r_hip"]), SHANK(at["r_knee"]), 0.02),
        "foot": join(foot(at["r_ankle"], at["r_toe"]), ankle(at["r_ankle"]), 0.012),
        "head": join(neck(at["neck"]), head(at["neck"]), 0.02),
    }


def body(points):
    d = parts(points)
    total = join(d["trunk"], d["arm"], 0.045)
    total = join(total, d["leg"], 0.035)
    total = join(total, d["head"], 0.012)
    return join(total, d["foot"], 0.003)


def hair_on(points):
    return hair(BODIES["neck"].local(right(points)))
