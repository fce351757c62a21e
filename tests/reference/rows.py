# SPDX-License-Identifier: MIT
"""What panels, their shape, stated limits and supports ask of points, as the documents state it: values alone, written
anew; first derivatives by complex steps (exact), second ones by differences of these.

Lengths are in mean edges. A row says slope * value + offset, which is 0, or at least 0 where it is a limit.
"""

import math

import numpy as np
import scipy.sparse as sp
from optimality import survey

KEEP = 0.05  # of a corner, [SHP-1]
STRAIGHT, STRAIGHT_TURN = 1e-3, 0.1 * math.sin(math.radians(1))  # [SHP-4]
TINY = 1e-30  # of a complex step
APART = 1e-7  # of a difference
COUNTS = 1e-6  # of a weight
DEGREE = math.radians(1)


def dot(a, b):
    return a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1] + a[..., 2] * b[..., 2]


def cross(a, b):
    """numpy's, which is slow for many small ones."""
    x, y, z = (a[..., k] for k in range(3))
    u, v, w = (b[..., k] for k in range(3))
    return np.stack([y * w - z * v, z * u - x * w, x * v - y * u], axis=-1)


def length(a):
    return np.sqrt(dot(a, a))  # analytic, unlike numpy's


class Rows:
    """Rows of one kind. `value` takes points (..., rows, k, 3) and the rows' data."""

    def __init__(self, value, index, data=(), slope=1.0, offset=0.0):
        self.value = value
        self.index = np.array(index, int)
        self.data = [np.array(one) for one in data]
        self.slope = np.broadcast_to(np.asarray(slope, float), len(self.index))
        self.offset = np.broadcast_to(np.asarray(offset, float), len(self.index))

    def values(self, points):
        return self.slope * self.value(points[self.index], *self.data) + self.offset

    def only(self, kept):
        return Rows(self.value, self.index[kept], [one[kept] for one in self.data], self.slope[kept], self.offset[kept])

    def local_gradients(self, corners):
        """(..., rows, 3k) at corners (..., rows, k, 3)."""
        size = 3 * self.index.shape[1]
        ways = 1j * TINY * np.eye(size).reshape(size, *([1] * (corners.ndim - 2)), -1, 3)
        found = self.value(corners + ways, *self.data).imag / TINY
        return np.moveaxis(self.slope * found, 0, -1)

    def columns(self):
        return (3 * self.index[:, :, None] + np.arange(3)).reshape(len(self.index), 3 * self.index.shape[1])

    def gradients(self, points):
        found, columns = self.local_gradients(points[self.index]), self.columns()
        rows = np.repeat(np.arange(len(columns)), columns.shape[1])
        return sp.csr_matrix((found.ravel(), (rows, columns.ravel())), (len(columns), points.size))

    def curvature(self, points, weights):
        """Of the sum of the rows times their weights, those that count."""
        counts = np.abs(weights) > COUNTS
        if not counts.all():
            return self.only(counts).curvature(points, weights[counts])
        size = 3 * self.index.shape[1]
        ways = APART * np.eye(size).reshape(size, 1, -1, 3)
        corners = points[self.index]
        change = self.local_gradients(corners + ways) - self.local_gradients(corners)
        blocks = np.moveaxis(change, 0, -1) * (weights / APART)[:, None, None]
        columns = self.columns()
        rows = np.repeat(columns, size, axis=1).ravel()
        return sp.csr_matrix((blocks.ravel(), (rows, np.tile(columns, size).ravel())), (points.size, points.size))


def volume(p):
    return dot(cross(p[..., 1, :] - p[..., 0, :], p[..., 2, :] - p[..., 0, :]), p[..., 3, :] - p[..., 0, :])


def flatness(base, faces):
    """The corners of each panel against the three of it that span most."""
    index, slope = [], []
    for face in faces:
        triples = [(a, b, c) for c in range(len(face)) for b in range(c) for a in range(b)]
        areas = [np.linalg.norm(np.cross(base[face[b]] - base[face[a]], base[face[c]] - base[face[a]]))
                 for a, b, c in triples]
        best = triples[int(np.argmax(areas))]
        for k in set(range(len(face))) - set(best):
            index.append([*(face[j] for j in best), face[k]])
            slope.append(1.0 / max(areas))
    return Rows(volume, np.reshape(index, (-1, 4)), slope=slope)


def corners_of(faces):
    return [(face, (face[k - 1], face[k], face[(k + 1) % len(face)])) for face in faces for k in range(len(face))]


def turn(p, normal):
    return dot(normal, cross(p[..., 1, :] - p[..., 0, :], p[..., 2, :] - p[..., 1, :]))


def shape(base, faces):
    """[SHP-1] and [SHP-4]; no mesh here has reflex corners in panels of more than four."""
    index, normals, slope, offset = [], [], [], []
    for face, (a, b, c) in corners_of(faces):
        area = survey.area_vector(base[face])
        normal = area / np.linalg.norm(area)
        now = normal @ np.cross(base[b] - base[a], base[c] - base[b])
        lengths = np.linalg.norm(base[b] - base[a]) * np.linalg.norm(base[c] - base[b])
        index.append([a, b, c])
        normals.append(normal)
        if abs(now) > STRAIGHT * lengths:
            slope.append(1 / (now * (1 - KEEP)))
            offset.append(-KEEP / (1 - KEEP))
        else:
            slope.append(10 / lengths)
            offset.append(10 * STRAIGHT_TURN)
    return Rows(turn, index, [normals], slope, offset)


def at_most(value, index, data, now, asked, allowed, width):
    """value <= asked, or what the base has and a little."""
    width = np.broadcast_to(width, len(index))
    return Rows(value, index, data, -1 / width, np.maximum(asked, now + allowed) / width)


def at_least(value, index, data, now, asked, allowed, width):
    width = np.broadcast_to(width, len(index))
    return Rows(value, index, data, 1 / width, -np.minimum(asked, now - allowed) / width)


def cosine_of_fold(p, way):
    edge = p[..., 1, :] - p[..., 0, :]
    here, there = cross(edge, p[..., 2, :] - p[..., 0, :]), cross(p[..., 3, :] - p[..., 0, :], edge)
    return way * dot(here, there) / (length(here) * length(there))


def fold(base, faces, most, relative):
    """Degrees; `relative`: beyond what it was."""
    index, ways = [], []
    for (a, b), ((f, way_f), (g, way_g)) in sides_between(faces):
        ends = [max(faces[k], key=lambda v: np.linalg.norm(np.cross(base[b] - base[a], base[v] - base[a])))
                for k in (f, g)]
        # Each triangle may run round like its panel or against it.
        senses = [np.sign(np.cross(base[b] - base[a], base[v] - base[a]) @ survey.area_vector(base[faces[k]]))
                  for k, v in ((f, ends[0]), (g, ends[1]))]
        index.append([a, b, *ends])
        ways.append(-senses[0] * senses[1] * (-1.0 if way_f == way_g else 1.0))
    rows = Rows(cosine_of_fold, index, [ways])
    now = np.arccos(np.clip(rows.values(base), -1, 1))
    bound = np.maximum(most * DEGREE + (now if relative else 0.0), now + 0.1 * DEGREE)
    kept = bound < math.pi
    least = np.cos(bound)
    return Rows(cosine_of_fold, rows.index[kept], [np.array(ways)[kept]], (2 / (1 - least))[kept],
                (-2 * least / (1 - least))[kept])


def sides_between(faces):
    sides = {}
    for f, face in enumerate(faces):
        for k, v in enumerate(face):
            w = face[(k + 1) % len(face)]
            sides.setdefault((min(v, w), max(v, w)), []).append((f, v < w))
    return [(edge, uses) for edge, uses in sides.items() if len(uses) == 2]


def cosine_of_corner(p):
    u, v = p[..., 0, :] - p[..., 1, :], p[..., 2, :] - p[..., 1, :]
    return dot(u, v) / (length(u) * length(v))


def angle(base, faces, least, most):
    index = [corner for face, corner in corners_of(faces)
             if survey.area_vector(base[face]) @ np.cross(base[corner[1]] - base[corner[0]],
                                                          base[corner[2]] - base[corner[1]]) >= 0]
    now = np.arccos(np.clip(cosine_of_corner(base[np.array(index)]), -1, 1))
    low, high = np.minimum(least * DEGREE, now - 0.1 * DEGREE), np.maximum(most * DEGREE, now + 0.1 * DEGREE)
    width = 0.25 * (math.cos(least * DEGREE) - math.cos(most * DEGREE))
    return [Rows(cosine_of_corner, index, (), -1 / width, np.cos(low) / width),
            Rows(cosine_of_corner, index, (), 1 / width, -np.cos(np.minimum(high, math.pi)) / width)]


def square(p):
    return dot(p[..., 1, :] - p[..., 0, :], p[..., 1, :] - p[..., 0, :])


def edge(base, faces, least, most):
    index = np.array(sorted({tuple(sorted((f[k - 1], f[k]))) for f in faces for k in range(len(f))}))
    now, width = square(base[index]), 0.25 * (most**2 - least**2)
    return [at_least(square, index, (), now, least**2, 2e-3 * now, width),
            at_most(square, index, (), now, most**2, 2e-3 * now, width)]


def size(p):
    arms = p - p[..., :1, :]
    return 0.5 * length(sum(cross(arms[..., k, :], arms[..., k + 1, :]) for k in range(1, p.shape[-2] - 1)))


def area(base, faces, most):
    found = []
    for count in {len(f) for f in faces}:
        index = np.array([f for f in faces if len(f) == count])
        now = size(base[index])
        found.append(at_most(size, index, (), now, most, 1e-3 * now, 0.5 * most))
    return found


def along(p):
    u, v = p[..., 1, :] - p[..., 0, :], p[..., 3, :] - p[..., 2, :]
    return dot(u, v) ** 2 / dot(v, v)


def across(p):
    u = p[..., 1, :] - p[..., 0, :]
    return dot(u, u) - along(p)


def filled(p, room):
    return max(math.sqrt(measure(p).max()) / size for measure, size in zip((along, across), room))


def sheet(base, faces, shorter, longer, after):
    """Two corners of a panel, and the side that lies along the sheet such that most room is left in the base; where
    several leave as much, which rounding chooses between, the one with most room in the product's answer."""
    chosen = []
    for face in faces:
        pairs = [(face[l], face[k]) for k in range(len(face)) for l in range(k)]
        placings = []
        for k in range(len(face)):
            with_side = np.array([[*pair, face[k], face[(k + 1) % len(face)]] for pair in pairs])
            for room in ((longer, shorter), (shorter, longer)):
                placings.append((filled(base[with_side], room), with_side, room))
        least = min(placing[0] for placing in placings)
        held = [placed(base, *placing[1:]) for placing in placings if placing[0] < least + 1e-9]
        chosen += max(held, key=lambda kinds: min(kind.values(after).min(initial=1) for kind in kinds))
    return [joined([kind for kind in chosen if kind.value is measure]) for measure in (along, across)]


def joined(kinds):
    parts = [np.concatenate([getattr(kind, name) for kind in kinds]) for name in ("index", "slope", "offset")]
    return Rows(kinds[0].value, parts[0], (), parts[1], parts[2])


def placed(base, index, room):
    found = []
    for measure, most in zip((along, across), np.square(room)):
        now = measure(base[index])
        kept = now > 1e-12 * most
        allowed = 2e-3 * np.maximum(now, 1e-3 * most)[kept]
        found.append(at_most(measure, index[kept].reshape(-1, 4), (), now[kept], most, allowed, 0.5 * most))
    return found


def slid(p, place, normal):
    way = p[..., 0, :] - place
    way = way - dot(way, normal)[..., None] * normal
    return dot(way, way)


def slide(base, faces, most):
    points = sorted({v for face in faces for v in face})
    normals = np.zeros_like(base)
    for face in faces:
        normals[face] += survey.area_vector(base[face])
    normals = normals[points] / np.linalg.norm(normals[points], axis=1)[:, None]
    return Rows(slid, [[v] for v in points], [base[points], normals], -1 / most**2, 1.0)


def off(p, place, normal):
    return dot(p[..., 0, :] - place, normal)


def beyond(base, points, normal, bound):
    """No point goes beyond normal . p = bound; one that is there goes no deeper."""
    normal = np.asarray(normal) / np.linalg.norm(normal)
    places = base[points] + np.maximum(0, bound - base[points] @ normal)[:, None] * normal
    return Rows(off, [[v] for v in points], [places, np.tile(normal, (len(points), 1))], -2.0)


class Surface:
    """[SUP-4] of a mesh whose panels are one side: all meet at less than 30 degrees."""

    def __init__(self, base, faces):
        self.places = base
        beside = {}
        normals = np.zeros_like(base)
        for face in faces:
            normals[face] += survey.area_vector(base[face])
            for v in face:
                beside.setdefault(v, set()).update(set(face) - {v})
        sites = sorted(beside)
        count = len(sites)
        self.base = base[sites]
        self.slope, self.bend, self.reach = np.zeros((count, 3)), np.zeros((count, 3, 3)), np.ones(count)
        for at, v in enumerate(sites):
            ring = sorted(beside[v])
            mean = np.linalg.norm(base[ring] - base[v], axis=1).mean()
            around = sorted(set(ring).union(*(beside[w] for w in ring)) - {v})
            self.fit(at, normals[v] / np.linalg.norm(normals[v]), (base[around] - base[v]) / mean, mean)

    def fit(self, v, normal, ways, mean):
        frame = np.linalg.svd(normal[None])[2][1:]
        x, y = ways @ frame[0], ways @ frame[1]
        terms = np.stack([x, y, 0.5 * x * x, x * y, 0.5 * y * y], axis=1)
        z = np.linalg.solve(terms.T @ terms + 1e-6 * np.eye(5), terms.T @ (ways @ normal))
        scale = math.sqrt(1 + z[0] ** 2 + z[1] ** 2)
        self.slope[v] = (normal - z[:2] @ frame) / scale
        self.bend[v] = -frame.T @ np.array([[z[2], z[3]], [z[3], z[4]]]) @ frame / (scale * mean)
        self.reach[v] = 2.5 * mean

    def height(self, p):
        way = p[..., 0, None, :] - self.base
        left = 1 - dot(way, way) / self.reach**2
        weight = np.where(left.real > 0, left, 0) ** 3
        value = dot(way, self.slope) + 0.5 * np.einsum("...si,sij,...sj->...s", way, self.bend, way)
        return (weight * value).sum(axis=-1) / weight.sum(axis=-1)

    def rows(self, points):
        index = [[v] for v in points]
        return Rows(self.height, index, (), 1.0, -self.height(self.places[np.array(index)]))
