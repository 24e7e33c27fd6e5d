"""The skin's colours, as one picture, and where in it each vertex lies.

The picture has two charts. The body's: across, the metres from the sole up to the neck, or from
the shoulder to the hand as if the arm began at the shoulder's height; down, the rows of right side,
middle and left side. The head's, below it: the head seen from the front.
"""

import struct
import zlib

import numpy as np

from human_body import SIZE
from human_shapes import EYES, HAIR, LEFT, RIGHT, SHIRT, SHOE, SKIN, SOLE, TROUSERS
from skin.posture import BODIES
from skin.shape import HEM

WIDTH, ROW, HEAD = 1024, 16, 288  # [px]
HEIGHT = 3 * ROW + HEAD
SPAN = 1.60                       # of the body's chart across [m]
HEAD_SPAN = 0.27                  # of the head's chart, both ways [m]
ARM = 1.22                        # where an arm begins in its row [m]
STANDS = SIZE["hip_height"]

SOCK, BELT, BUCKLE, LIPS, BLUSH, WHITE, IRIS = ("#3a3f4a", "#33291f", "#a39a86", "#b8735f",
                                                "#d39573", "#f1ede6", "#4a6670")


def rgb(text):
    return np.array([int(text[i:i + 2], 16) for i in (1, 3, 5)], float)


def mixed(text, other, share):
    return rgb(text) * (1 - share) + rgb(other) * share


# --- The body's rows ------------------------------------------------------------------------------


def stripes(marks):
    """A row: `marks` are (from here on [m], colour)."""
    fine = 8
    at = (np.arange(WIDTH * fine) + 0.5) / (WIDTH * fine) * SPAN
    row = np.zeros((len(at), 3))
    for begin, color in marks:
        row[at >= begin] = color if isinstance(color, np.ndarray) else rgb(color)
    return row.reshape(WIDTH, fine, 3).sum(1) / fine


def rows():
    hem = SIZE["ankle_height"] + SIZE["shank"] - HEM["trousers"]
    trousers = [(0, SOLE), (0.014, mixed(SHOE, "#000000", 0.25)), (0.018, SHOE),
                (SIZE["ankle_height"] + 0.022, SOCK)]
    waist = STANDS + HEM["belt"]
    shirt = [(waist, BELT), (waist + 0.032, SHIRT)]
    middle = [(hem, TROUSERS), *shirt,
              (STANDS + HEM["collar"] - 0.012, mixed(SHIRT, "#000000", 0.18)),
              (STANDS + HEM["collar"], SKIN)]
    cuff = ARM + HEM["sleeve"]
    sides = [[(hem, color), (hem + 0.010, TROUSERS), *shirt, (cuff - 0.010, color), (cuff, SKIN)]
             for color in (RIGHT, LEFT)]
    return [stripes(trousers + marks) for marks in (sides[0], middle, sides[1])]


# --- The head from the front ----------------------------------------------------------------------


def in_ellipse(y, z, center, half_axes):
    return ((y - center[0]) / half_axes[0]) ** 2 + ((z - center[1]) / half_axes[1]) ** 2 < 1


def soft(y, z, center, half_axes):
    r2 = ((y - center[0]) / half_axes[0]) ** 2 + ((z - center[1]) / half_axes[1]) ** 2
    return np.clip(1 - r2, 0, 1)[..., None] ** 2


def head_picture():
    fine = 4
    at = (np.arange(HEAD * fine) + 0.5) / (HEAD * fine) * HEAD_SPAN
    z, y = np.meshgrid(HEAD_SPAN - 0.02 - at, at - HEAD_SPAN / 2, indexing="ij")
    y = np.abs(y)
    picture = np.broadcast_to(rgb(SKIN), (*y.shape, 3)).copy()
    for center, half_axes, color, most in (((0.043, 0.082), (0.026, 0.022), BLUSH, 0.55),
                                           ((0, 0.088), (0.016, 0.016), BLUSH, 0.45),
                                           ((0.031, 0.116), (0.024, 0.017), "#b98763", 0.40)):
        share = most * soft(y, z, center, half_axes)
        picture = picture * (1 - share) + rgb(color) * share
    lift = 0.06 * np.clip(y - 0.031, -0.02, 0.02)
    lid = in_ellipse(y, z - lift, (0.031, 0.1120), (0.0158, 0.0088)) & (z - lift > 0.1115)
    white = in_ellipse(y, z - lift, (0.031, 0.1120), (0.0146, 0.0072)) & (z - lift > 0.1078)
    brow = (np.abs(z - (0.1325 - 9.0 * (y - 0.033) ** 2)) < 0.0030 - 0.045 * np.clip(
        y - 0.030, 0, 1)) & (np.abs(y - 0.0325) < 0.0175)
    mouth_line = 0.0592 + 1.6 * y * y
    upper = (z > mouth_line) & (z < mouth_line + 0.0052 * (1 - (y / 0.0235) ** 2)
                                - 0.0014 * np.clip(1 - y / 0.005, 0, 1))
    lower = (z <= mouth_line) & (z > mouth_line - 0.0068 * (1 - (y / 0.0215) ** 2))
    between = (np.abs(z - mouth_line) < 0.0008) & (y < 0.0235)
    nostril = in_ellipse(y, z, (0.0072, 0.0845), (0.0036, 0.0020))
    eye = np.array([0.0302, 0.1120])
    for mask, color in ((lid, rgb(EYES)), (white, rgb(WHITE)),
                        (white & in_ellipse(y, z, eye, (0.0066, 0.0066)), mixed(IRIS, EYES, 0.5)),
                        (white & in_ellipse(y, z, eye, (0.0055, 0.0055)), rgb(IRIS)),
                        (white & in_ellipse(y, z, eye, (0.0029, 0.0029)), rgb("#14110f")),
                        (white & in_ellipse(y, z, eye + (0.0018, 0.0022), (0.0012, 0.0012)),
                         rgb("#ffffff")),
                        (brow, mixed(HAIR, SKIN, 0.10)), (upper, mixed(LIPS, SKIN, 0.25)),
                        (lower, mixed(LIPS, SKIN, 0.45)), (between, mixed(LIPS, EYES, 0.55)),
                        (nostril, mixed(SKIN, EYES, 0.45))):
        picture[mask] = color
    return picture.reshape(HEAD, fine, HEAD, fine, 3).sum((1, 3)) / fine ** 2


def picture():
    image = np.broadcast_to(rgb(SKIN), (HEIGHT, WIDTH, 3)).copy()
    for i, row in enumerate(rows()):
        image[i * ROW:(i + 1) * ROW] = row
    image[3 * ROW:, :HEAD] = head_picture()
    return np.floor(image + 0.5).astype(np.uint8)


def png(image):
    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))
    height, width, _ = image.shape
    lines = b"".join(b"\0" + image[y].tobytes() for y in range(height))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">2I5B", width, height, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(lines, 9)) + chunk(b"IEND", b""))


# --- Places ---------------------------------------------------------------------------------------


def body_places(vertices, shares):
    """`shares`: the weights of the bones by name, of the right side (skin.weights.shares_at)."""
    p = np.stack([vertices[:, 0], -np.abs(vertices[:, 1]), vertices[:, 2]], 1)
    name_of = lambda bone: bone[0] if isinstance(bone, tuple) else bone
    of_joint = {}
    for bone, share in shares.items():
        of_joint[name_of(bone)] = of_joint.get(name_of(bone), 0) + share
    def z(body):
        return BODIES[body].local(p)[:, 2]
    ankle = SIZE["ankle_height"]
    thigh = z("r_hip") + STANDS
    shank = z("r_knee") + ankle + SIZE["shank"]
    foot = z("r_ankle") + ankle
    on = lambda *names: sum(of_joint[name] for name in names)
    arm = on("r_shoulder", "r_elbow_flexion", "r_elbow_pronation", "r_elbow", "r_wrist")
    leg = on("r_hip", "r_knee", "r_ankle", "r_toe")
    along = (1 - arm - leg) * (p[:, 2] + STANDS) + on("r_hip") * thigh + on("r_knee") * shank
    along = along + on("r_ankle", "r_toe") * foot + arm * (ARM - z("r_shoulder"))
    row = 1.5 + np.where(vertices[:, 1] > 0, 1, -1) * (arm + leg)
    return np.stack([np.clip(along, 0.002, SPAN - 0.02) / SPAN, row * ROW / HEIGHT], 1)


def head_places(vertices):
    p = BODIES["neck"].local(vertices)
    across = (p[:, 1] + HEAD_SPAN / 2) / HEAD_SPAN * HEAD / WIDTH
    down = (3 * ROW + (HEAD_SPAN - 0.02 - p[:, 2]) / HEAD_SPAN * HEAD) / HEIGHT
    return np.stack([across, down], 1)
