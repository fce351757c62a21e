# SPDX-License-Identifier: MIT
"""Points on the boundary's polygon, or on another line of edges: each on a side of it, until it turns to the next."""

import math

import numpy as np
import rows

CORNER = math.cos(math.radians(30))
AT_END = 1e-4  # mean edges


def before_end(p, place, way):
    return ((p[..., 0, :] - place) * way).sum(axis=-1)


class MeshLines:
    def __init__(self, base, lines):
        self.base = base
        self.ways = {}  # of a point: the line through it as far as its corners, and its place in that
        self.still = set()
        for line in lines:
            closed = line[0] == line[-1]
            loop = line[:-1] if closed else line
            for k, v in enumerate(loop):
                if self.is_corner(loop, k, closed):
                    self.still.add(v)
                    continue
                back, on = (self.until_corner(loop, k, step, closed) for step in (-1, 1))
                self.ways[v] = ([*reversed(back), v, *on], len(back))

    @classmethod
    def of_boundary(cls, base, faces):
        following = {}
        sides = {(face[k - 1], face[k]) for face in faces for k in range(len(face))}
        for a, b in sides:
            if (b, a) not in sides:
                following.setdefault(a, b)
        loops = []
        while following:
            loop = [next(iter(following))]
            while loop[-1] in following:
                loop.append(following.pop(loop[-1]))
            loops.append(loop)
        return cls(base, loops)

    @staticmethod
    def straight_on(base, faces, vertex, random):
        """A line of edges through a point, turning by less than 30 degrees."""
        beside = {}
        for face in faces:
            for k, v in enumerate(face):
                beside.setdefault(v, set()).update((face[k - 1], face[(k + 1) % len(face)]))
        line = [vertex, int(random.choice(sorted(beside[vertex])))]
        for _ in range(2):
            while True:
                way = base[line[-1]] - base[line[-2]]
                next_way = {w: base[w] - base[line[-1]] for w in beside[line[-1]] if w not in line}
                on = [w for w, e in next_way.items() if e @ way > 0.9 * np.linalg.norm(e) * np.linalg.norm(way)]
                if not on or len(line) > 12:
                    break
                line.append(max(on, key=lambda w: next_way[w] @ way / np.linalg.norm(next_way[w])))
            line.reverse()
        return line

    def is_corner(self, loop, k, closed):
        if not closed and k in (0, len(loop) - 1):
            return True
        into = self.base[loop[k]] - self.base[loop[k - 1]]
        out = self.base[loop[(k + 1) % len(loop)]] - self.base[loop[k]]
        return not into @ out > CORNER * np.linalg.norm(into) * np.linalg.norm(out)

    def until_corner(self, loop, k, step, closed):
        found = []
        for count in range(1, len(loop) // 2):
            at = (k + step * count) % len(loop)
            found.append(loop[at])
            if self.is_corner(loop, at, closed):
                break
        return found

    def sides_at(self, points):
        """Of each point the side of its line that is nearest; of two that are, the later one."""
        sides = {}
        for v, (line, _) in self.ways.items():
            away = []
            for a, b in zip(line, line[1:]):
                way = self.base[b] - self.base[a]
                share = np.clip((points[v] - self.base[a]) @ way / (way @ way), 0, 1)
                away.append(np.linalg.norm(points[v] - self.base[a] - share * way))
            sides[v] = int(len(away) - 1 - np.argmin(away[::-1]))
        return sides

    def lay(self, sides, tracks):
        """Points on their sides, in `tracks`; the rows of the ends."""
        index, places, ways = [], [], []
        for v in self.still & set(tracks):
            tracks[v] = (self.base[v], np.zeros((3, 0)))
        for v in set(self.ways) & set(tracks):
            a, b = (self.base[self.ways[v][0][sides[v] + k]] for k in range(2))
            way = (b - a) / np.linalg.norm(b - a)
            tracks[v] = (a, way[:, None])
            index += [[v], [v]]
            places += [a, b]
            ways += [way, -way]
        return [rows.Rows(before_end, index, [places, ways])] if index else []

    def turn(self, sides, points):
        """Goes on where a point is at an end of its side; whether any does."""
        turned = False
        for v, (line, _) in self.ways.items():
            for step, end in ((-1, sides[v]), (1, sides[v] + 1)):
                if np.linalg.norm(points[v] - self.base[line[end]]) < AT_END and 0 <= sides[v] + step < len(line) - 1:
                    sides[v] += step
                    turned = True
                    break
        return turned
