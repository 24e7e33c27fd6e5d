"""The shipped human's numbers: the tables they come from, its measures, its masses and inertias.

"Ours" marks each number that no source gives. Metres, kilograms, degrees; z up, x forward, y left.
"""

from typing import NamedTuple

STATURE = 1.70     # ours: a round adult height
BODY_MASS = 70.0   # ours: a round adult mass

# --- Sources -------------------------------------------------------------------------------------


class Segment(NamedTuple):
    mass: float          # fraction of the body's
    cm: float            # from the first landmark, fraction of the segment's length
    sagittal: float      # radii of gyration about the CM, fractions of the segment's length:
    transverse: float    # about the anteroposterior, the mediolateral
    longitudinal: float  # and the long axis


# Males, P. de Leva, "Adjustments to Zatsiorsky-Seluyanov's segment inertia parameters",
# J. Biomechanics 29(9), 1996, as in github BMClab/BMC data/BSPmale_ZdeLeva.txt (CC BY 4.0).
TABLE = {
    "head": Segment(0.0694, 0.5002, 0.303, 0.315, 0.261),         # VERT-CERV, with the neck
    "upper_trunk": Segment(0.1596, 0.5066, 0.505, 0.320, 0.465),  # CERV-XYPH
    "middle_trunk": Segment(0.1633, 0.4502, 0.482, 0.383, 0.468),  # XYPH-OMPH
    "lower_trunk": Segment(0.1117, 0.6115, 0.615, 0.551, 0.587),  # OMPH-MIDH
    "upper_arm": Segment(0.0271, 0.5772, 0.285, 0.269, 0.158),    # SJC-EJC
    "forearm": Segment(0.0162, 0.4574, 0.276, 0.265, 0.121),      # EJC-WJC
    "hand": Segment(0.0061, 0.7900, 0.628, 0.513, 0.401),         # WJC-MET3
    "thigh": Segment(0.1416, 0.4095, 0.329, 0.329, 0.149),        # HJC-KJC
    "shank": Segment(0.0433, 0.4395, 0.251, 0.246, 0.102),        # KJC-AJC
    "foot": Segment(0.0137, 0.4415, 0.257, 0.245, 0.124),         # HEEL-TTIP
}
# The same table gives the CM of two segments from a second landmark. One point, two descriptions:
TRUNK_CM_FROM_CERV, TRUNK_CM_FROM_MIDS = 0.5138, 0.4310  # so MIDS-MIDH follows from CERV-MIDH
HAND_CM_TO_DAC3 = 0.3624                                 # so WJC-DAC3 follows from WJC-MET3

# Lengths per stature of de Leva's sample (stature 1.741 m), as restated in two public files: rbdl's
# "HeiMan" Lua model and github GabrielEGC/review-sim-amber-robot Functions/Zatsiorsky_parameters.m.
LENGTH = {
    "thigh": 0.2425, "shank": 0.2493, "foot": 0.1482,
    "upper_arm": 0.1618, "forearm": 0.1544, "hand": 0.0495,
    "head": 0.1395, "upper_trunk": 0.2421 / 1.741, "middle_trunk": 0.2155 / 1.741,
    "lower_trunk": 0.1457 / 1.741,
    "shoulder_width": 0.2401, "hip_width": 0.0930,  # HeiMan: Dumas, Cheze, Verriest 2007
    "ankle_height": 0.039,                          # Winter 2009
}
SPINE = ("lower_trunk", "middle_trunk", "upper_trunk", "head")

# Ranges of motion [deg]: [1] AAOS (fadavispt.mhmedical.com, section 158980269); [2] Merck Manual;
# [3] Kurz (yoga-age.com); [4] ISRN 2012/751768 table 8; [5] exrx.net; [6] MuJoCo's humanoid.xml.
NOD, BEND_RIGHT, TURN_LEFT = (0, 1, 0), (1, 0, 0), (0, 0, 1)  # positive angles of trunk and neck
SWING_FORWARD, SWING_BACK = (0, -1, 0), (0, 1, 0)             # and of hanging right limbs
SWING_OUT, SWING_IN = (-1, 0, 0), (1, 0, 0)
TURN_OUT, TURN_IN = (0, 0, -1), (0, 0, 1)


class Hinge(NamedTuple):
    name: str
    axis: tuple
    lower: float
    upper: float


# The first hinge is nearest the parent.
HINGES = {
    # The trunk's 75 forward, 30 back [3], 35 sideways [3, 4] and 45 turned [6], shared between two
    # joints. The shares are ours: the loins bend forward more, the ribs turn more.
    "waist": (Hinge("flexion", NOD, -20, 45), Hinge("bend", BEND_RIGHT, -20, 20),
              Hinge("rotation", TURN_LEFT, -15, 15)),
    "chest": (Hinge("flexion", NOD, -10, 30), Hinge("bend", BEND_RIGHT, -15, 15),
              Hinge("rotation", TURN_LEFT, -30, 30)),
    # [4]; rotation: the middle of the 60 to 80 of [5].
    "neck": (Hinge("flexion", NOD, -45, 45), Hinge("bend", BEND_RIGHT, -45, 45),
             Hinge("rotation", TURN_LEFT, -70, 70)),
    # In the order y z x the chain is singular only where the middle hinge is at +-90, that is,
    # where a bent forearm would point straight to the side. The T pose, reaching forward, overhead
    # and the cocked throwing arm all have the middle hinge near 0.
    # [1]: flexion 180, extension 60, abduction 180, medial 70, lateral 90. Ours: -70, because with
    # the arm out to the side this hinge turns it medially; 80, to stay clear of the singular pose;
    # 45 across the body, which no source gives.
    "r_shoulder": (Hinge("flexion", SWING_FORWARD, -70, 180), Hinge("rotation", TURN_OUT, -70, 80),
                   Hinge("abduction", SWING_OUT, -45, 180)),
    "r_elbow": (Hinge("flexion", SWING_FORWARD, 0, 150), Hinge("pronation", TURN_IN, -80, 80)),
    # [1]. The thumb points forward: flexion swings the fingers in, radial deviation forward.
    "r_wrist": (Hinge("flexion", SWING_IN, -70, 80), Hinge("deviation", SWING_FORWARD, -30, 20)),
    # [2], down to the ankle. Hip and shoulder turn outward, the ankle turns the sole inward.
    "r_hip": (Hinge("flexion", SWING_FORWARD, -15, 125), Hinge("abduction", SWING_OUT, -45, 45),
              Hinge("rotation", TURN_OUT, -45, 45)),
    "r_knee": (Hinge("", SWING_BACK, 0, 130),),
    "r_ankle": (Hinge("flexion", SWING_FORWARD, -50, 20), Hinge("inversion", SWING_IN, -25, 35)),
    # Ours: walking bends the toes up by 50 to 60.
    "r_toe": (Hinge("", SWING_FORWARD, -30, 60),),
}

# --- Measures of this figure ---------------------------------------------------------------------

# Ours: what the tables do not say about the foot.
TOE_SHARE = 0.2              # of the foot's mass beyond the ball
HEEL_BEHIND_ANKLE = 0.060    # about a quarter of the foot
BALL_AT = 0.72               # of the foot's length from the heel, where shoes bend
SOLE_RADIUS = 0.025          # one for heel, ball and toes: the sole is flat, and rolls on the ball
TOE_WIDTH, TOE_HEIGHT = 0.090, 2 * SOLE_RADIUS  # of the box that lends the toes its inertia


def spine_factor():
    """Shortens trunk and head: de Leva's lengths, stacked, come to 1.017 statures.

    Ours: their CMs and radii of gyration are taken as shares of the shortened lengths.
    """
    legs = sum(LENGTH[part] for part in ("ankle_height", "shank", "thigh"))
    return (1 - legs) / sum(LENGTH[part] for part in SPINE)


def measures():
    """Lengths [m], to 0.1 mm. The head takes up the rounding, so that the stature is exact."""
    scale = {part: STATURE * (spine_factor() if part in SPINE else 1) for part in LENGTH}
    size = {part: round(LENGTH[part] * scale[part], 4) for part in LENGTH}
    size["hip_height"] = size["ankle_height"] + size["shank"] + size["thigh"]
    size["trunk"] = sum(size[part] for part in SPINE if part != "head")
    size["head"] = round(STATURE - size["hip_height"] - size["trunk"], 4)
    mids_over_cerv = (1 - TRUNK_CM_FROM_CERV) / (1 - TRUNK_CM_FROM_MIDS)
    below_chest = size["lower_trunk"] + size["middle_trunk"]
    size["shoulder_above_chest"] = round(mids_over_cerv * size["trunk"] - below_chest, 4)
    size["fingers"] = round(TABLE["hand"].cm / HAND_CM_TO_DAC3 * size["hand"], 4)
    size["ball_x"] = round(BALL_AT * size["foot"] - HEEL_BEHIND_ANKLE, 4)
    size["toe"] = round(size["foot"] - HEEL_BEHIND_ANKLE - size["ball_x"], 4)
    return size


SIZE = measures()

# --- Masses --------------------------------------------------------------------------------------


def moments(part, axes="stl"):
    """Ixx, Iyy, Izz [kg m2] about the CM; `axes` tells which table axis lies along x, y and z."""
    row = TABLE[part]
    radius = {"s": row.sagittal, "t": row.transverse, "l": row.longitudinal}
    return [row.mass * BODY_MASS * (radius[axis] * SIZE[part]) ** 2 for axis in axes]


def mass_of(part, top=0.0, axes="stl"):
    """Mass properties of an upright segment whose first landmark is at height `top`."""
    row = TABLE[part]
    return mass_properties(row.mass * BODY_MASS, [0, 0, top - row.cm * SIZE[part]],
                           moments(part, axes))


def mass_properties(mass, com, diagonal):
    return {"mass_kg": mass, "com_m": com, "inertia_kg_m2": [*diagonal, 0, 0, 0]}


def foot_and_toe():
    """Splits the foot so that both parts together have the table's mass, CM and inertia.

    The table's long axis of the foot runs from heel to toes (x), its sagittal axis stands upright.
    Ours: both CMs lie on the axis of the collision capsules; the toes are a uniform box; the rest
    of the foot is what remains.
    """
    row = TABLE["foot"]
    mass = row.mass * BODY_MASS
    toe_mass, foot_mass = TOE_SHARE * mass, (1 - TOE_SHARE) * mass
    whole_x = row.cm * SIZE["foot"] - HEEL_BEHIND_ANKLE
    toe_x = SIZE["ball_x"] + SIZE["toe"] / 2
    foot_x = (whole_x - TOE_SHARE * toe_x) / (1 - TOE_SHARE)
    apart = toe_mass * foot_mass / mass * (toe_x - foot_x) ** 2
    toe = box_moments(toe_mass, SIZE["toe"], TOE_WIDTH, TOE_HEIGHT)
    whole = moments("foot", "lts")
    foot = [w - t - a for w, t, a in zip(whole, toe, (0, apart, apart))]
    return (mass_properties(foot_mass, [foot_x, 0, SOLE_RADIUS - SIZE["ankle_height"]], foot),
            mass_properties(toe_mass, [SIZE["toe"] / 2, 0, 0], toe))


def box_moments(mass, x, y, z):
    return [mass / 12 * (y * y + z * z), mass / 12 * (x * x + z * z), mass / 12 * (x * x + y * y)]


NO_MASS = mass_properties(0, [0, 0, 0], [0, 0, 0])
