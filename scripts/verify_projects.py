"""Projects at random for scripts/verify_builds: both examples with other numbers, and new ones with
keys of every kind, regions of both methods, placements, holds and held objects. The same number
makes the same project."""

import json
import pathlib
import random

ROOT = pathlib.Path(__file__).resolve().parent.parent
FIGURE = ROOT / "assets" / "figures" / "human.json"
EXAMPLES = [ROOT / "assets" / "examples" / f"{name}.kfa" for name in ("throw", "jump")]
INTERPOLATIONS = ["hold", "linear", "quadratic", "cubic", "sine", "quintic", "exponential", "back",
                  "bounce", "elastic"]
EASED = INTERPOLATIONS[4:]
LIMBS = ["r_shoulder", "l_shoulder", "r_elbow", "l_elbow", "r_hip", "l_hip", "r_knee", "neck",
         "waist"]
HANDS = ["r_wrist", "l_wrist"]
FEET = ["r_ankle", "l_ankle", "r_toe", "l_toe"]


def hinges():
    """Names and limits [degrees] of the human's hinges, right and left."""
    found = {}
    for joint in json.loads(FIGURE.read_text())["joints"]:
        for hinge in joint["hinges"]:
            name = joint["name"] + ("_" + hinge["name"] if "name" in hinge else "")
            found[name] = hinge["limits_deg"]
            if name.startswith("r_"):
                found["l_" + name[2:]] = hinge["limits_deg"]
    return found


HINGES = hinges()


def key(rng, frame, field, value):
    made = {"frame": frame, field: round(value, 3)}
    if rng.random() < 0.4:
        made["interpolation"] = rng.choice(INTERPOLATIONS)
        if made["interpolation"] in EASED and rng.random() < 0.7:
            made["easing"] = rng.choice(["in", "out", "in_out"])
    elif rng.random() < 0.2:
        rate = "rate_deg_s" if field == "angle_deg" else "rate_m_s"
        made[rate] = round(rng.uniform(-200, 200) if field == "angle_deg" else rng.uniform(-1, 1), 2)
    return made


def curve(rng, last, field, low, high):
    frames = sorted({0, *(rng.randint(1, last) for _ in range(rng.randint(1, 4)))})
    middle = rng.uniform(low, high)
    spread = 0.4 * (high - low)
    return {"keys": [key(rng, f, field, min(max(middle + rng.uniform(-spread, spread), low), high))
                     for f in frames]}


def solver(rng):
    if rng.random() < 0.3:
        return {"method": "paper", "step_s": rng.choice([1 / 30, 0.01, 0.004]), "version": 1}
    made = {"method": "exact", "version": 1}
    if rng.random() < 0.5:
        made["tolerance_deg"] = 10 ** rng.uniform(-5, 0)
    return made


def friction(rng):
    return {"default": rng.choice([1, 0.8, round(rng.uniform(0.05, 1), 3)])}


def regions(rng, last):
    """One after the other, so that none overlaps."""
    made, frame = [], rng.randint(0, last // 3)
    while frame + 4 < last and len(made) < 3:
        end = min(last, frame + rng.randint(4, 20))
        joints = rng.sample(LIMBS, rng.randint(1, 3))
        region = {"name": f"region {len(made)}", "first_frame": frame, "last_frame": end,
                  "joints": [{"beyond": joint} for joint in joints], "friction": friction(rng)}
        if rng.random() < 0.3:
            region["blend_frames"] = rng.randint(1, 5)
        if rng.random() < 0.3:
            region["limit_tangents"] = True
        made.append(region)
        frame = end + rng.randint(0, 6)
    return made


def placements(rng, last):
    kind = rng.choice(["keyed", "pinned", "gravity", "both"])
    if kind == "keyed":
        return []
    foot = rng.choice(FEET)
    middle = last if kind != "both" else rng.randint(3, last - 3)
    made = [{"kind": "pinned", "joint": foot, "first_frame": 0, "last_frame": middle}]
    if kind == "gravity":
        made = [{"kind": "gravity", "pin": foot, "first_frame": 0, "last_frame": last}]
    if kind == "both":
        made.append({"kind": "gravity", "pin": foot, "first_frame": middle, "last_frame": last})
    return made


def scene(rng):
    objects = [{"name": "floor", "plane": {"normal": [0, 0, 1], "offset_m": 0}, "color": "#9aa0a6"}]
    for i in range(rng.randint(0, 2)):
        objects.append({"name": f"box {i}", "color": "#c08a52", "box": {
            "center_m": [round(rng.uniform(-2, 2), 2), round(rng.uniform(-2, 2), 2), 0.1],
            "size_m": [round(rng.uniform(0.2, 1), 2) for _ in range(3)],
            "rotation_deg": [round(rng.uniform(-90, 90), 1), 0, 0]}})
    return {"gravity_m_s2": rng.choice([9.81, 9.81, 1.62]), "objects": objects}


def held(rng, last):
    if rng.random() < 0.5:
        return []
    shape = {"sphere": {"radius_m": 0.04}}
    if rng.random() < 0.5:
        shape = {"box": {"size_m": [0.1, 0.05, 0.2]}}
    return [{"name": "thing", **shape, "mass_kg": round(rng.uniform(0.05, 3), 3),
             "joint": rng.choice(HANDS), "offset_m": [0, 0.03, -0.1], "color": "#d9482b",
             "rotation_deg": [round(rng.uniform(-180, 180), 1), 0, 20],
             "release_frame": rng.randint(1, last)}]


def new_project(rng):
    last = rng.randint(12, 50)
    keyed = rng.sample(sorted(HINGES), rng.randint(5, len(HINGES)))
    root = {axis: curve(rng, last, "position_m", *span)
            for axis, span in (("x", (-1, 1)), ("y", (-1, 1)), ("z", (0.85, 1.2)))}
    root.update({axis: curve(rng, last, "angle_deg", -span, span)
                 for axis, span in (("angle_z", 180), ("angle_y", 40), ("angle_x", 40))})
    project = {"format": "hazumi-project", "version": 2,
               "fps": rng.choice([{"num": 30, "den": 1}, {"num": 24, "den": 1},
                                  {"num": 60, "den": 1}, {"num": 30000, "den": 1001}]),
               "frames": {"first": 0, "last": last}, "solver": solver(rng),
               "figure": {"file": str(FIGURE)}, "scene": scene(rng), "root": root,
               "joints": {name: curve(rng, last, "angle_deg", *HINGES[name]) for name in keyed},
               "regions": regions(rng, last), "placements": placements(rng, last),
               "held_objects": held(rng, last)}
    if not project["placements"] and rng.random() < 0.5:
        project["holds"] = [{"joint": rng.choice(["r_wrist", "l_ankle"]), "first_frame": 0,
                             "orientation": rng.random() < 0.3, "last_frame": rng.randint(2, last)}]
    return project


def varied_example(rng):
    project = json.loads(rng.choice(EXAMPLES).read_text())
    project["figure"] = {"file": str(FIGURE)}
    project["version"] = 2
    for name, curve_of_joint in project["joints"].items():
        low, high = HINGES[name]
        for each in curve_of_joint["keys"]:
            each["angle_deg"] = min(max(round(each["angle_deg"] + rng.gauss(0, 3), 3), low), high)
    for region in project.get("regions", []):
        region["friction"] = friction(rng)
        region["last_frame"] += rng.randint(-4, 8)
    for thing in project.get("held_objects", []):
        thing["release_frame"] = rng.randint(6, 18)
    if rng.random() < 0.3:
        project["solver"]["method"] = "paper"
    return project


def project_of(number):
    """The document of this number: 0 and 1 are the examples themselves."""
    rng = random.Random(f"hazumi {number}")
    if number < len(EXAMPLES):
        project = json.loads(EXAMPLES[number].read_text())
        return {**project, "figure": {"file": str(FIGURE)}}
    return varied_example(rng) if number % 3 == 0 else new_project(rng)


def write_projects(folder, count):
    """Writes projects 0 to count - 1; returns their paths."""
    folder.mkdir(parents=True, exist_ok=True)
    paths = []
    for number in range(count):
        path = folder / f"{number:04d}.kfa"
        path.write_text(json.dumps(project_of(number), indent=1))
        paths.append(path)
    return paths
