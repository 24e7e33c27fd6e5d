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

from human_body import (BODY_MASS, HINGES, SIZE, SOLE_RADIUS, SPINE, STATURE, spine_factor)
from human_shapes import (abdomen_links, chest_links, foot_links, forearm_links, hand_links,
                          head_links, pelvis_links, shank_links, thigh_links, toe_links,
                          upper_arm_links)
from human_strength import STRENGTH

OUTPUT = Path(__file__).resolve().parent.parent / "assets" / "figures" / "human.json"

# --- The figure ----------------------------------------------------------------------------------


def joint(name, parent, offset, links):
    hinges = [({"name": hinge.name} if hinge.name else {}) |
              {"axis": hinge.axis, "limits_deg": [hinge.lower, hinge.upper], "rest_deg": 0} |
              ({"strength": STRENGTH[name, hinge.name]} if (name, hinge.name) in STRENGTH else {})
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
        "Strength: hip, knee, ankle Anderson, Madigan, Nussbaum 2007; the others 0.65 (ours) of a "
        "gymnast's in rbdl's muscle add-on.",
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
