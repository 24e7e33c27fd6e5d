"""How strong the shipped human's joints are: the tables, and which muscles turn which hinge.

"Ours" marks each number that no source gives. Newton metres, radians, radians a second.
"""

from math import pi
from typing import NamedTuple

from human_body import BODY_MASS, STATURE

GRAVITY = 9.81

# --- Sources -------------------------------------------------------------------------------------


class Anderson(NamedTuple):
    """Torque = mass g stature c1 cos(c2 (q - c3)) V(w): engine/figure/strength.cpp has V."""
    c1: float
    c2: float
    c3: float
    c4: float
    c5: float
    c6: float


# D. E. Anderson, M. L. Madigan, M. A. Nussbaum, "Maximum voluntary joint torque as a function of
# joint angle and angular velocity", J. Biomechanics 40(14), 2007, table 3: men of 18 to 25 years.
# Angles from standing; hip and knee flexion and ankle dorsiflexion are positive. The torques of
# stretched tissue in the same table are left out: they are no muscle's.
ANDERSON = {
    "hip extension": Anderson(0.161, 0.958, 0.932, 1.578, 3.190, 0.242),
    "hip flexion": Anderson(0.113, 0.738, -0.214, 2.095, 4.267, 0.218),
    "knee extension": Anderson(0.163, 1.258, 1.133, 1.517, 3.952, 0.095),
    "knee flexion": Anderson(0.087, 0.869, 0.522, 2.008, 5.233, 0.304),
    "ankle extension": Anderson(0.095, 1.391, 0.408, 0.987, 3.558, 0.295),
    "ankle flexion": Anderson(0.033, 1.510, -0.187, 0.699, 1.940, 0.828),
}


class Gymnast(NamedTuple):
    torque: float   # the largest at rest
    fastest: float  # rate at which nothing is left
    angle: float    # of the largest torque
    width: float    # standard deviation of the torque over the angle


# A male gymnast, from rbdl's add-on for torques of muscles (zlib licence), data set "Gymnast".
GYMNAST = {
    "shoulder extension": Gymnast(127.401, 16.249, 2.14675, 1.83085),
    "shoulder flexion": Gymnast(91.1388, 19.0764, 0.890118, 1.2898),
    "shoulder external rotation": Gymnast(43.5837, 18.0, -0.670796, 1.98361),
    "shoulder internal rotation": Gymnast(50.522, 19.47, -1.18761, 2.80524),
    "elbow flexion": Gymnast(101.384, 18.1, 0.33, 3.62155),
    "elbow extension": Gymnast(69.8728, 18.45, 1.64319, 1.30795),
    "wrist extension": Gymnast(15.5653, 36.5472, 1.55334, 1.38928),
    "wrist flexion": Gymnast(39.2252, 36.3901, 0.663225, 1.71042),
    "forearm supination": Gymnast(13.5361, 35.45, -0.209204, 1.33735),
    "forearm pronation": Gymnast(12.976, 27.88, -0.212389, 0.991803),
    "wrist ulnar deviation": Gymnast(31.4217, 18.02, 0.43, 1.47849),
    "wrist radial deviation": Gymnast(23.8345, 21.77, -1.14319, 2.56082),
    "lumbar extension": Gymnast(687.864, 1.0472, 1.5506, 1.14543),
    "lumbar flexion": Gymnast(211.65, 0.523599, 0.0, 2 * pi),
}
# Ours: an ordinary man has about this much of a gymnast's torque.
ORDINARY = 0.65

# --- Hinges --------------------------------------------------------------------------------------

# Ours: the trunk's bending is shared between waist and chest as their limits are (45 : 30 forward);
# both carry the whole torque.
WAIST, CHEST = 0.6, 0.4
# Ours: the arm is as strong outward as forward and inward as backward, at any angle.
ANY_ANGLE = 2 * pi


def cosine(muscles):
    row = ANDERSON[muscles]
    degrees = lambda value: value * 180 / pi
    return {"curve": "cosine", "torque_n_m": BODY_MASS * GRAVITY * STATURE * row.c1,
            "best_angle_deg": degrees(row.c3), "width_deg": degrees(1 / row.c2),
            "rate_75_deg_s": degrees(row.c4), "rate_50_deg_s": degrees(row.c5),
            "lengthening_s": row.c6}


def bell(muscles, share=1.0, width=None):
    """`share`: of the angle and of its rate that this hinge takes."""
    row = GYMNAST[muscles]
    degrees = lambda value: value * 180 / pi
    return {"curve": "bell", "torque_n_m": ORDINARY * row.torque,
            "best_angle_deg": degrees(row.angle * share),
            "width_deg": degrees((width or row.width) * share),
            "fastest_deg_s": degrees(row.fastest * share)}


def both(positive, negative):
    return {"positive": positive, "negative": negative}


# By joint and hinge; towards greater angles, then towards lesser ones. Of others no table says how
# strong they are: hips outward and round, neck, trunk sideways and round, ankle sideways, toes.
STRENGTH = {
    ("waist", "flexion"): both(bell("lumbar flexion", WAIST), bell("lumbar extension", WAIST)),
    ("chest", "flexion"): both(bell("lumbar flexion", CHEST), bell("lumbar extension", CHEST)),
    ("r_shoulder", "flexion"): both(bell("shoulder flexion"), bell("shoulder extension")),
    ("r_shoulder", "rotation"): both(bell("shoulder external rotation"),
                                     bell("shoulder internal rotation")),
    ("r_shoulder", "abduction"): both(bell("shoulder flexion", width=ANY_ANGLE),
                                      bell("shoulder extension", width=ANY_ANGLE)),
    ("r_elbow", "flexion"): both(bell("elbow flexion"), bell("elbow extension")),
    ("r_elbow", "pronation"): both(bell("forearm pronation"), bell("forearm supination")),
    ("r_wrist", "flexion"): both(bell("wrist flexion"), bell("wrist extension")),
    ("r_wrist", "deviation"): both(bell("wrist radial deviation"), bell("wrist ulnar deviation")),
    ("r_hip", "flexion"): both(cosine("hip flexion"), cosine("hip extension")),
    ("r_knee", ""): both(cosine("knee flexion"), cosine("knee extension")),
    ("r_ankle", "flexion"): both(cosine("ankle flexion"), cosine("ankle extension")),
}
