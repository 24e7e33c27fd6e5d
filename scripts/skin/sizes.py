"""How small the triangles are where: finer at the face, the hands, and where the skin bends."""

import numpy as np

from skin.posture import BODIES
from skin.shape import GROUND, HEM, right
from skin.solids import length


def size_at(points):
    p = right(points)
    hand, head = BODIES["r_wrist"].local(p), BODIES["neck"].local(p)
    size = np.full(len(p), 0.020)
    is_hand = (hand[:, 2] < 0.03) & (length(hand) < 0.25)
    size = np.where(is_hand, 0.010, size)
    fingers = is_hand & ((hand[:, 2] < -0.070) | (hand[:, 0] > 0.036)) & (hand[:, 2] < -0.03)
    size = np.where(fingers, 0.005, size)
    is_head = (head[:, 2] > 0.0) & (np.abs(head[:, 1]) < 0.12)
    size = np.where(is_head, 0.010, size)
    face = is_head & (head[:, 0] > 0.070) & (head[:, 2] > 0.04) & (head[:, 2] < 0.142)
    ear = is_head & (np.abs(head[:, 0]) < 0.03) & (head[:, 1] < -0.068) & (head[:, 2] > 0.06)
    size = np.where(face | ear, 0.005, size)
    arm, shank = BODIES["r_shoulder"].local(p), BODIES["r_knee"].local(p)
    sleeve = (np.abs(arm[:, 2] + HEM["sleeve"]) < 0.012) & (np.abs(arm[:, 1]) < 0.1)
    trousers = (np.abs(shank[:, 2] + HEM["trousers"]) < 0.015) & (length(shank) < 0.45)
    foot = BODIES["r_ankle"].local(p)
    sole = (foot[:, 2] < GROUND + 0.022) & (length(foot) < 0.3)
    return np.where(sleeve | trousers | sole, np.minimum(size, 0.010), size)


def hair_size_at(points):
    return np.full(len(points), 0.010)
