#!/usr/bin/env -S /usr/bin/python3
"""Prints the shipped human, assets/figures/human.json: 1.70 m, 70 kg, male, 37 hinges.

  scripts/human_figure.py > assets/figures/human.json
  scripts/human_figure.py --check     exits 1 if the file differs from what would be printed

z up, x forward, y left; the zero pose stands with hanging arms, palms facing the thighs. Every
joint's frame is then aligned with the world. Metres, kilograms, degrees. Only the right limbs are
written; the reader of the file mirrors them. "Ours" marks each number that no source gives.
"""

import sys
from decimal import Decimal
from pathlib import Path
from typing import NamedTuple

OUTPUT = Path(__file__).resolve().parent.parent / "assets" / "figures" / "human.json"
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

# --- Shapes: all ours, drawn by eye after the lengths above ---------------------------------------

SHIRT, TROUSERS, SHOE, SOLE = "#4f7d8c", "#434b5c", "#6b4a3a", "#ddd6c8"
SKIN, HAIR, EYES = "#d8a47f", "#4b3629", "#2a2522"
RIGHT, LEFT = "#d9824a", "#e8c468"  # hems: amber on the right, straw on the left


def cone(start, end, radii, color, mirror_color=None):
    look = {"shape": "tapered_capsule", "from_m": start, "to_m": end, "radii_m": radii,
            "color": color}
    return look | ({"mirror_color": mirror_color} if mirror_color else {})


def ball(center, half_axes, color):
    return {"shape": "ellipsoid", "center_m": center, "half_axes_m": half_axes, "color": color}


def pair(look):
    """A shape of the trunk or head and its reflection."""
    return [look, {key: [value[0], -value[1], value[2]] if key in ("from_m", "to_m", "center_m")
                   else value for key, value in look.items()}]


def link(name, start, end, radius, mass, look=()):
    capsule = {"name": name, "from_m": start, "to_m": end, "radius_m": radius}
    return capsule | mass | ({"look": list(look)} if look else {})


def pelvis_links():
    look = [*pair(cone((0, -0.056, 0.095), (0, -0.068, 0.015), (0.086, 0.094), TROUSERS)),
            *pair(ball((-0.038, -0.068, -0.012), (0.070, 0.080, 0.088), TROUSERS)),
            cone((0, 0, 0.095), (0, 0, 0.045), (0.088, 0.090), TROUSERS)]
    mass = mass_of("lower_trunk", SIZE["lower_trunk"])
    return [link("pelvis", (0, -0.06, 0.03), (0, 0.06, 0.03), 0.105, mass, look)]


def abdomen_links():
    look = [*pair(cone((0, -0.051, 0.020), (0.002, -0.056, 0.180), (0.085, 0.091), SHIRT)),
            cone((0.002, 0, 0.020), (0.003, 0, 0.180), (0.087, 0.093), SHIRT)]
    mass = mass_of("middle_trunk", SIZE["middle_trunk"])
    return [link("abdomen", (0, -0.04, 0.1), (0, 0.04, 0.1), 0.100, mass, look)]


def chest_links():
    look = [*pair(cone((0.002, -0.056, -0.02), (0.004, -0.068, 0.085), (0.091, 0.103), SHIRT)),
            cone((0.003, 0, -0.02), (0.004, 0, 0.085), (0.093, 0.104), SHIRT),
            *pair(ball((0.040, -0.068, 0.085), (0.074, 0.088, 0.070), SHIRT)),
            *pair(ball((-0.040, -0.078, 0.085), (0.066, 0.090, 0.105), SHIRT)),
            *pair(cone((-0.010, -0.02, 0.168), (0, -0.175, 0.142), (0.062, 0.050), SHIRT)),
            cone((-0.010, 0, 0.170), (-0.008, 0, 0.212), (0.075, 0.061), SHIRT)]
    mass = mass_of("upper_trunk", SIZE["upper_trunk"])
    return [link("chest", (0, -0.055, 0.08), (0, 0.055, 0.08), 0.105, mass, look),
            link("shoulders", (0, -0.13, 0.146), (0, 0.13, 0.146), 0.054, NO_MASS)]


def head_links():
    top = SIZE["head"]
    look = [ball((0.016, 0, 0.128), (0.092, 0.074, 0.088), SKIN),
            ball((0.037, 0, 0.088), (0.065, 0.056, 0.067), SKIN),
            cone((0.105, 0, 0.123), (0.114, 0, 0.098), (0.008, 0.0115), SKIN),
            *pair(ball((0.098, -0.029, 0.127), (0.007, 0.008, 0.010), EYES)),
            *pair(ball((0.010, -0.074, 0.112), (0.018, 0.010, 0.028), SKIN)),
            ball((0.003, 0, top - 0.076), (0.097, 0.081, 0.076), HAIR)]
    neck_look = [cone((-0.012, 0, -0.01), (0.006, 0, 0.085), (0.056, 0.053), SKIN)]
    skull = link("head", (0.016, 0, 0.09), (0.016, 0, top - 0.085), 0.085,
                 mass_of("head", top), look)
    return [skull, link("neck", (0, 0, 0), (0.010, 0, 0.06), 0.055, NO_MASS, neck_look)]


def upper_arm_links():
    elbow = (0, 0, -SIZE["upper_arm"])
    look = [ball((0, -0.001, -0.022), (0.055, 0.048, 0.078), SHIRT),
            cone((0, 0, -0.03), (0, 0, -0.125), (0.048, 0.0455), SHIRT),
            cone((0, 0, -0.128), (0, 0, -0.133), (0.0465, 0.0465), RIGHT, LEFT),
            cone((0.004, 0, -0.12), elbow, (0.042, 0.036), SKIN)]
    return [link("r_upper_arm", (0, 0, 0), elbow, 0.045, mass_of("upper_arm"), look)]


def forearm_links():
    wrist = (0, 0, -SIZE["forearm"])
    look = [cone((0, 0, 0), (0.002, 0, -0.075), (0.036, 0.041), SKIN),
            cone((0.002, 0, -0.075), wrist, (0.041, 0.026), SKIN)]
    return [link("r_forearm", (0, 0, 0), wrist, 0.038, mass_of("forearm"), look)]


def hand_links():
    """The palm faces left, so the table's sagittal axis, across the palm, lies along y."""
    tip = SIZE["fingers"]
    look = [ball((0, 0, -0.050), (0.036, 0.0175, 0.062), SKIN),
            ball((0.001, 0.003, 0.068 - tip), (0.029, 0.0145, 0.066), SKIN),
            cone((0.015, 0, -0.020), (0.021, 0.001, -0.085), (0.018, 0.0175), SKIN),
            cone((-0.015, 0, -0.020), (-0.020, 0.001, -0.085), (0.018, 0.0165), SKIN),
            cone((0.021, 0.001, -0.085), (0.011, 0.006, 0.013 - tip), (0.0175, 0.013), SKIN),
            cone((-0.020, 0.001, -0.085), (-0.010, 0.006, 0.018 - tip), (0.0165, 0.012), SKIN),
            cone((0.022, 0.003, -0.030), (0.050, 0.012, -0.082), (0.016, 0.011), SKIN)]
    return [link("r_hand", (0, 0, -0.03), (0, 0, 0.03 - tip), 0.030, mass_of("hand", axes="tsl"),
                 look)]


def thigh_links():
    knee = (0, 0, -SIZE["thigh"])
    look = [cone((0, 0, -0.02), (0.010, 0, -0.19), (0.084, 0.076), TROUSERS),
            cone((0.010, 0, -0.19), knee, (0.076, 0.056), TROUSERS)]
    return [link("r_thigh", (0, 0, 0), knee, 0.070, mass_of("thigh"), look)]


def shank_links():
    ankle = (0, 0, -SIZE["shank"])
    look = [cone((0, 0, 0), (-0.012, -0.002, -0.13), (0.055, 0.057), TROUSERS),
            cone((-0.012, -0.002, -0.13), (-0.002, 0, -0.365), (0.057, 0.042), TROUSERS),
            cone((-0.002, 0, -0.370), (-0.002, 0, -0.376), (0.043, 0.043), RIGHT, LEFT),
            cone((0, 0, -0.36), ankle, (0.036, 0.034), SKIN)]
    return [link("r_shank", (0, 0, 0), ankle, 0.048, mass_of("shank"), look)]


def foot_links():
    ground, axis = -SIZE["ankle_height"], SOLE_RADIUS - SIZE["ankle_height"]
    heel_x, ball_x = SOLE_RADIUS - HEEL_BEHIND_ANKLE, SIZE["ball_x"]
    look = [cone((-0.021, 0, ground + 0.039), (0.075, 0, ground + 0.037), (0.037, 0.035), SHOE),
            cone((0.005, 0, -0.012), (0.095, 0, ground + 0.040), (0.041, 0.032), SHOE),
            ball((0.092, -0.003, ground + 0.031), (0.070, 0.045, 0.030), SHOE),
            ball((0.036, -0.002, ground + 0.011), (0.096, 0.044, 0.011), SOLE)]
    return [link("r_foot", (heel_x, 0, axis), (ball_x, 0, axis), SOLE_RADIUS, foot_and_toe()[0],
                 look)]


def toe_links():
    length = SIZE["toe"] - 0.012
    look = [ball((0.010, -0.003, 0.001), (length, 0.042, 0.025), SHOE),
            ball((0.012, -0.003, 0.009 - SOLE_RADIUS), (length, 0.044, 0.009), SOLE)]
    return [link("r_toes", (0, 0, 0), (SIZE["toe"] - SOLE_RADIUS, 0, 0), SOLE_RADIUS,
                 foot_and_toe()[1], look)]


# --- The figure ----------------------------------------------------------------------------------


def joint(name, parent, offset, links):
    hinges = [({"name": hinge.name} if hinge.name else {}) |
              {"axis": hinge.axis, "limits_deg": [hinge.lower, hinge.upper], "rest_deg": 0}
              for hinge in HINGES[name]]
    return {"name": name, "parent": parent, "offset_m": offset, "hinges": hinges, "links": links}


def joints():
    shoulder = (0, -SIZE["shoulder_width"] / 2, SIZE["shoulder_above_chest"])
    ball_of_foot = (SIZE["ball_x"], 0, SOLE_RADIUS - SIZE["ankle_height"])
    return [
        joint("waist", "pelvis", (0, 0, SIZE["lower_trunk"]), abdomen_links()),
        joint("chest", "waist", (0, 0, SIZE["middle_trunk"]), chest_links()),
        joint("neck", "chest", (0, 0, SIZE["upper_trunk"]), head_links()),
        joint("r_shoulder", "chest", shoulder, upper_arm_links()),
        joint("r_elbow", "r_shoulder", (0, 0, -SIZE["upper_arm"]), forearm_links()),
        joint("r_wrist", "r_elbow", (0, 0, -SIZE["forearm"]), hand_links()),
        joint("r_hip", "pelvis", (0, -SIZE["hip_width"] / 2, 0), thigh_links()),
        joint("r_knee", "r_hip", (0, 0, -SIZE["thigh"]), shank_links()),
        joint("r_ankle", "r_knee", (0, 0, -SIZE["shank"]), foot_links()),
        joint("r_toe", "r_ankle", ball_of_foot, toe_links()),
    ]


def notes():
    return [
        "Written by scripts/human_figure.py, which says where each number comes from; edit that.",
        f"Male, {number(STATURE)} m, {number(BODY_MASS)} kg. In the zero pose the pelvis's origin, "
        f"midway between the hips, is {number(SIZE['hip_height'])} m above the soles.",
        "Masses, centres of mass, radii of gyration: de Leva 1996 after Zatsiorsky and Seluyanov, "
        "from BMClab's BMC data (CC BY 4.0).",
        f"Lengths: as a share of stature; trunk and head times {spine_factor():.5f}, because the "
        "shares add up to 1.017 statures.",
        "Limits: AAOS, Merck Manual, Kurz, ISRN 2012/751768, exrx.net, MuJoCo's humanoid.",
        "Ours: the split of foot and toes, of the trunk's bending, the toe's limits, all shapes.",
        "Signs: flexion forward (knee: heel to buttock; ankle, toe: up), abduction and limb "
        "rotation outward, pronation, radial deviation, inversion, bend right, turn left.",
    ]


def figure():
    return {"format": "hazumi-figure", "version": 1, "name": "human", "notes": notes(),
            "root": {"name": "pelvis", "links": pelvis_links()}, "joints": joints(),
            "mirror": {"from": "r_", "to": "l_"}}


def demand_exact(built):
    """The written decimals, not only the numbers behind them, must stand on the floor."""
    exact = lambda value: Decimal(number(value))
    links = built["root"]["links"] + [item for joint in built["joints"] for item in joint["links"]]
    mass = sum(exact(item["mass_kg"]) * (2 if item["name"].startswith("r_") else 1)
               for item in links)
    drop = sum(exact(SIZE[part]) for part in ("thigh", "shank", "ankle_height"))
    rise = sum(exact(SIZE[part]) for part in SPINE)
    assert mass == exact(BODY_MASS) and drop + rise == exact(STATURE)
    for item in links:
        if item["name"] in ("r_foot", "r_toes"):
            above = 0 if item["name"] == "r_foot" else SOLE_RADIUS - SIZE["ankle_height"]
            height = exact(SIZE["ankle_height"]) + exact(above) - exact(item["radius_m"])
            assert height + exact(item["from_m"][2]) == height + exact(item["to_m"][2]) == 0


# --- JSON, one thing a line where it fits ---------------------------------------------------------

WIDTH = 100


def number(value):
    """The shortest decimal within six significant digits, never in exponent form."""
    text = format(Decimal(f"{value:.6g}"), "f")
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return "0" if text == "-0" else text


def inline(value):
    if isinstance(value, dict):
        return "{" + ", ".join(f'"{key}": {inline(item)}' for key, item in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(inline(item) for item in value) + "]"
    return f'"{value}"' if isinstance(value, str) else number(value)


def is_rows(value):
    """A list whose entries stand on lines of their own."""
    return isinstance(value, list) and bool(value) and isinstance(value[0], (dict, str))


def layout(value, indent=0, used=0):
    """`value` as text whose first line begins at column `used`."""
    if isinstance(value, dict):
        fits = not any(is_rows(item) for item in value.values())
        if fits and used + len(inline(value)) < WIDTH:
            return inline(value)
        return wrap(members(value, indent + 2), "{}", indent)
    if is_rows(value):
        rows = [" " * (indent + 2) + layout(item, indent + 2, indent + 2) for item in value]
        return wrap(rows, "[]", indent)
    return inline(value)


def wrap(lines, brackets, indent):
    return brackets[0] + "\n" + ",\n".join(lines) + "\n" + " " * indent + brackets[1]


def members(value, indent):
    """A dictionary's members as lines: short ones share a line, rows and objects have their own."""
    lines, shared = [], False
    for key, item in value.items():
        alone = isinstance(item, dict) or is_rows(item)
        text = f'"{key}": ' + layout(item, indent, indent + len(key) + 4)
        if shared and not alone and len(lines[-1]) + len(text) + 3 <= WIDTH:
            lines[-1] += ", " + text
        else:
            lines.append(" " * indent + text)
        shared = not alone
    return lines


def main():
    built = figure()
    demand_exact(built)
    text = layout(built) + "\n"
    if sys.argv[1:] == ["--check"]:
        if not OUTPUT.exists() or OUTPUT.read_text() != text:
            sys.exit(f"{OUTPUT.name} is not what scripts/human_figure.py prints")
        return
    if sys.argv[1:]:
        sys.exit(__doc__)
    sys.stdout.write(text)


if __name__ == "__main__":
    main()
