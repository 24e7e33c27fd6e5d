"""The shipped human's shapes: collision capsules and what is drawn. All ours, by eye after the
lengths of human_body.py.
"""

from human_body import (HEEL_BEHIND_ANKLE, NO_MASS, SIZE, SOLE_RADIUS, foot_and_toe, mass_of)

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
