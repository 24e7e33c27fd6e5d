"""Triangles on the zero surface of a distance: dual contouring on an octree.

A cell near the surface is halved until it is as small as `size_at` wants it. Each cell has a vertex
for each part of its corners that lies inside, and each edge between an inner and an outer corner
joins the vertices of the cells around it, so the mesh is closed whatever the cells' sizes.
"""

import numpy as np

CORNERS = np.array([[i, j, k] for i in (0, 1) for j in (0, 1) for k in (0, 1)])
EDGES = [(a, b) for a in range(8) for b in range(8)
         if a < b and np.abs(CORNERS[a] - CORNERS[b]).sum() == 1]
REACH = 1.3  # cells whose centre is farther away than so many half diagonals hold no surface


def cells_near(distance, size_at, low, high, finest, levels):
    """Corner nearest the origin and size of each cell, in units of `finest`."""
    size = 2 ** levels
    spans = [np.arange(int(np.floor(a / finest / size)), int(np.ceil(b / finest / size))) * size
             for a, b in zip(low, high)]
    cells = np.stack(np.meshgrid(*spans, indexing="ij"), -1).reshape(-1, 3)
    done_cells, done_sizes = [], []
    while len(cells):
        center = (cells + size / 2) * finest
        near = np.abs(distance(center)) < REACH * size * finest * 3 ** 0.5 / 2
        cells, center = cells[near], center[near]
        fine = size_at(center) >= size * finest if size > 1 else np.ones(len(cells), bool)
        done_cells.append(cells[fine])
        done_sizes.append(np.full(fine.sum(), size))
        size //= 2
        cells = (cells[~fine][:, None] + CORNERS * size).reshape(-1, 3)
    return np.concatenate(done_cells), np.concatenate(done_sizes)


def keys(points, extra=0):
    """A number for each integer point."""
    p = points.astype(np.int64) + (1 << 14)
    return ((p[..., 0] << 15 | p[..., 1]) << 15 | p[..., 2]) << 4 | extra


class Grid:
    def __init__(self, cells, sizes):
        number = np.log2(sizes).round().astype(np.int64)
        self.cells, self.sizes = cells, sizes
        all_keys = keys(cells, number)
        self.order = np.argsort(all_keys)
        self.keys = all_keys[self.order]
        self.numbers = np.unique(number)

    def cell_at(self, units):
        """The number of the cell that holds each unit cube; -1: none."""
        found = np.full(len(units), -1)
        for n in self.numbers:
            wanted = keys(units >> n << n, n)
            i = np.minimum(np.searchsorted(self.keys, wanted), len(self.keys) - 1)
            found = np.where(self.keys[i] == wanted, self.order[i], found)
        return found

    def least_edges(self):
        """Start, axis and length of every edge that has no shorter ones on it."""
        rows = [[], [], []]
        for a, b in EDGES:
            axis = int(np.argmax(np.abs(CORNERS[a] - CORNERS[b])))
            rows[0].append(self.cells + CORNERS[a] * self.sizes[:, None])
            rows[1].append(np.full(len(self.cells), axis))
            rows[2].append(self.sizes)
        start, axis, size = (np.concatenate(row) for row in rows)
        number = np.log2(size).round().astype(np.int64) * 3 + axis
        all_keys, first = np.unique(keys(start, number), return_index=True)
        start, axis, size = start[first], axis[first], size[first]
        least = np.ones(len(start), bool)
        for part in (2, 4):
            for i in range(part):
                step = np.eye(3, dtype=int)[axis] * (i * size // part)[:, None]
                number = np.maximum(np.log2(size / part).round(), 0).astype(np.int64) * 3 + axis
                least &= ~(np.isin(keys(start + step, number), all_keys) & (size >= part))
        return start[least], axis[least], size[least]


def inner_parts(inside):
    """For each cell, the part of the inside that each of its corners is in: a corner of it."""
    part = np.where(inside, np.arange(8), 9)
    for _ in range(4):
        for a, b in EDGES:
            both = inside[:, a] & inside[:, b]
            lowest = np.minimum(part[:, a], part[:, b])
            part[:, a] = np.where(both, lowest, part[:, a])
            part[:, b] = np.where(both, lowest, part[:, b])
    return part


def part_of(grid, parts, cell, inner):
    """Which part of its cell the inner end of an edge belongs to: that of the nearest corner."""
    corner = grid.cells[cell][:, None] + CORNERS * grid.sizes[cell][:, None, None]
    away = np.abs(corner - inner[:, None]).sum(-1) + 10000 * (parts[cell] == 9)
    return parts[cell, np.argmin(away, axis=1)]


def contour(distance, size_at, low, high, finest, levels):
    """Vertices (n, 3) and faces: quadrilaterals, in triangles the last vertex is the third."""
    grid = Grid(*cells_near(distance, size_at, low, high, finest, levels))
    start, axis, size = grid.least_edges()
    end = start + np.eye(3, dtype=int)[axis] * size[:, None]
    d0, d1 = distance(start * finest), distance(end * finest)
    crossing = (d0 < 0) != (d1 < 0)
    start, end, axis, d0, d1 = (v[crossing] for v in (start, end, axis, d0, d1))
    place = (start + (end - start) * (d0 / (d0 - d1))[:, None]) * finest

    corner = (grid.cells[:, None] + CORNERS * grid.sizes[:, None, None]).reshape(-1, 3)
    parts = inner_parts((distance(corner * finest) < 0).reshape(-1, 8))
    unit = np.eye(3, dtype=int)
    u, v = unit[(axis + 1) % 3], unit[(axis + 2) % 3]
    around = []  # the cells about each edge, counter-clockwise seen from its end
    for a, b in ((0, 0), (-1, 0), (-1, -1), (0, -1)):
        cell = grid.cell_at(start + a * u + b * v)
        assert (cell >= 0).all(), "the surface leaves the cells near it"
        around.append(cell * 16 + part_of(grid, parts, cell, np.where((d0 < 0)[:, None], start, end)))
    around = np.stack(around, 1)
    used, faces = np.unique(around, return_inverse=True)
    faces = faces.reshape(-1, 4)
    vertices, count = np.zeros((len(used), 3)), np.zeros(len(used))
    for i in range(4):
        np.add.at(vertices, faces[:, i], place)
        np.add.at(count, faces[:, i], 1)
    faces = np.where((d0 < 0)[:, None], faces, faces[:, ::-1])
    return vertices / count[:, None], faces


def triangles_of(vertices, faces):
    """Quadrilaterals are cut along the shorter diagonal."""
    def gap(i, j):
        d = vertices[faces[:, i]] - vertices[faces[:, j]]
        return d[:, 0] ** 2 + d[:, 1] ** 2 + d[:, 2] ** 2
    f = np.where((gap(0, 2) <= gap(1, 3))[:, None], faces, np.roll(faces, -1, axis=1))
    both = np.stack([f[:, [0, 1, 2]], f[:, [0, 2, 3]]], 1).reshape(-1, 3)
    return both[(both[:, 0] != both[:, 1]) & (both[:, 1] != both[:, 2]) & (both[:, 2] != both[:, 0])]


def gradient(distance, points, step=1e-4):
    """The unit direction in which the distance grows."""
    g = np.stack([distance(points + step * e) - distance(points - step * e) for e in np.eye(3)], 1)
    size = np.sqrt(g[:, 0] ** 2 + g[:, 1] ** 2 + g[:, 2] ** 2)
    return g / np.maximum(size, 1e-12)[:, None], size / (2 * step)


def onto_surface(distance, vertices, times=3):
    for _ in range(times):
        normal, slope = gradient(distance, vertices)
        step = distance(vertices) / np.maximum(slope, 0.3)
        vertices = vertices - np.clip(step, -0.004, 0.004)[:, None] * normal
    return vertices


def neighbours(triangles):
    """Every edge, from either end."""
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    return np.unique(np.concatenate([edges, edges[:, ::-1]]), axis=0)


def averaged(values, edges):
    """The mean over the neighbours of each vertex."""
    total, count = np.zeros_like(values), np.zeros(len(values))
    np.add.at(total, edges[:, 0], values[edges[:, 1]])
    np.add.at(count, edges[:, 0], 1)
    return total / count[:, None]


def relaxed(distance, vertices, faces, times):
    """Vertices slide along the surface until their neighbours lie evenly around them."""
    vertices = onto_surface(distance, vertices)
    for _ in range(times):
        edges = neighbours(triangles_of(vertices, faces))
        step = 0.5 * (averaged(vertices, edges) - vertices)
        normal, _ = gradient(distance, vertices)
        along = (step * normal)[:, 0] + (step * normal)[:, 1] + (step * normal)[:, 2]
        vertices = onto_surface(distance, vertices + step - along[:, None] * normal, 1)
    return onto_surface(distance, vertices)


def normals_of(vertices, triangles):
    a, b, c = (vertices[triangles[:, i]] for i in range(3))
    facet = np.cross(b - a, c - a)
    normal = np.zeros_like(vertices)
    for i in range(3):
        np.add.at(normal, triangles[:, i], facet)
    size = np.sqrt(normal[:, 0] ** 2 + normal[:, 1] ** 2 + normal[:, 2] ** 2)
    return normal / size[:, None]
