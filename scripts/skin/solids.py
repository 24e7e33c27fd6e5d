"""Distances to rounded solids, and how they are joined smoothly.

A function takes points, an array (n, 3), and returns about how far each is outside, negative inside
[m]. Only + - * / and square roots are used, which give the same bits on every machine.
"""

import numpy as np


def length(v):
    return np.sqrt(v[:, 0] * v[:, 0] + v[:, 1] * v[:, 1] + v[:, 2] * v[:, 2])


def dot(v, w):
    return v[:, 0] * w[0] + v[:, 1] * w[1] + v[:, 2] * w[2]


def join(a, b, k):
    """The union, rounded where the two are within k of each other."""
    h = np.maximum(k - np.abs(a - b), 0) / k
    return np.minimum(a, b) - h * h * k / 4


def cut(a, b, k):
    """What is in both, rounded likewise."""
    return -join(-a, -b, k)


def join_all(distances, k):
    total = distances[0]
    for d in distances[1:]:
        total = join(total, d, k)
    return total


def smooth_step(t):
    t = np.clip(t, 0, 1)
    return t * t * (3 - 2 * t)


def cone(points, start, end, radius_start, radius_end):
    """A round cone: the hull of two balls."""
    start, end = np.array(start, float), np.array(end, float)
    axis = end - start
    size2 = float(axis[0] ** 2 + axis[1] ** 2 + axis[2] ** 2)
    p = points - start
    along = dot(p, axis) / size2
    across = p - along[:, None] * axis
    r = length(across)
    size = size2 ** 0.5
    lean = (radius_start - radius_end) / size
    t = np.clip(along + r * lean / (1 - lean * lean) ** 0.5 / size, 0, 1)
    return length(p - t[:, None] * axis) - (radius_start + t * (radius_end - radius_start))


def ball(points, center, half_axes):
    """An ellipsoid, to first order."""
    p, a = points - np.array(center, float), np.array(half_axes, float)
    k0, k1 = length(p / a), length(p / (a * a))
    return k0 * (k0 - 1) / np.maximum(k1, 1e-9)


class Profile:
    """A tube along z of elliptic sections: rows of z, half width (y), front, back (x), x, y."""

    def __init__(self, rows, cap=0.03):
        table = np.array(sorted(row + (0,) * (6 - len(row)) for row in rows), float)
        self.z, self.values, self.cap = table[:, 0], table[:, 1:], cap
        self.slopes = self._slopes()

    def _slopes(self):
        """Monotone between rows, so that the tube has no bulge that no row has."""
        steps = np.diff(self.values, axis=0) / np.diff(self.z)[:, None]
        slopes = np.zeros_like(self.values)
        a, b = steps[:-1], steps[1:]
        same = a * b > 0
        slopes[1:-1] = np.where(same, 2 * a * b / np.where(same, a + b, 1), 0)
        slopes[0], slopes[-1] = steps[0], steps[-1]
        return slopes

    def at(self, z):
        z = np.clip(z, self.z[0], self.z[-1])
        i = np.clip(np.searchsorted(self.z, z, side="right") - 1, 0, len(self.z) - 2)
        step = (self.z[i + 1] - self.z[i])[:, None]
        t = (z - self.z[i])[:, None] / step
        s = 1 - t
        return (s * s * (1 + 2 * t) * self.values[i] + t * t * (3 - 2 * t) * self.values[i + 1]
                + s * t * step * (s * self.slopes[i] - t * self.slopes[i + 1]))

    def __call__(self, points):
        value = self.at(points[:, 2])
        x, y = points[:, 0] - value[:, 3], points[:, 1] - value[:, 4]
        a, b = value[:, 0], np.where(x > 0, value[:, 1], value[:, 2])
        k0 = np.sqrt(x * x / (b * b) + y * y / (a * a))
        k1 = np.sqrt(x * x / (b * b * b * b) + y * y / (a * a * a * a))
        beside = np.where(k1 > 1e-6, k0 * (k0 - 1) / np.maximum(k1, 1e-6), -np.minimum(a, b))
        beyond = np.abs(points[:, 2] - (self.z[0] + self.z[-1]) / 2) - (self.z[-1] - self.z[0]) / 2
        return cut(beside, beyond, self.cap)
