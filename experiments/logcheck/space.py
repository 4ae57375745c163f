# SPDX-License-Identifier: GPL-3.0-or-later
"""The Delaunay triangulation in space, and regular ones in the plane and in space, from their definitions, over any source of
signs: a cell is four points whose sphere has no other point inside, a triangle three points whose plane, all lifted,
has no other point below. Heights are lowered by id: the smaller the number the more."""

from itertools import combinations


def cells(points, orientation, in_sphere, identical):
    """orientation(a, b, c, d) and in_sphere(a, b, c, d, e) are signs; equal points: the smallest number."""
    points = sorted(points)
    points = [p for i, p in enumerate(points) if not any(identical(q, p) for q in points[:i])]
    return simplices(points, 4, orientation, in_sphere)


def simplices(points, size, orientation, below):
    """below(simplex, v) is the sign of v below the plane of an upright simplex, all lifted."""
    result = []
    for simplex in combinations(sorted(points), size):
        side = orientation(*simplex)
        if side and not any(inside(simplex, side, v, orientation, below) for v in points if v not in simplex):
            result.append(simplex)
    return result


def inside(quad, side, v, orientation, in_sphere):
    sign = in_sphere(*quad, v) * side
    if sign:
        return sign > 0
    for lowered in sorted((*quad, v)):
        if lowered == v:
            return True
        turned = orientation(*(v if u == lowered else u for u in quad)) * side
        if turned:
            return turned < 0
    return True


def change(kind, ids):
    """The cells that leave and that join by an event of this kind."""
    if kind in ("show", "hide") and len(ids) == 5:
        point, *link = ids
        one, more = [tuple(sorted(link))], [tuple(sorted((point, *facet))) for facet in combinations(link, 3)]
        return (one, more) if kind == "show" else (more, one)
    if kind not in ("flip_2_3", "flip_3_2"):
        cell = tuple(sorted(ids))
        return ([], [cell]) if kind in ("leave", "hull_2_3", "show") else ([cell], [])
    p, q, a, b, c = ids
    two = [tuple(sorted((end, a, b, c))) for end in (p, q)]
    three = [tuple(sorted((p, q, *edge))) for edge in ((a, b), (b, c), (a, c))]
    return (two, three) if kind == "flip_2_3" else (three, two)


def change_in_plane(kind, ids):
    """The triangles that leave and that join by an event of this kind."""
    if kind == "flip":
        u, v, p, q = ids
        return ([tuple(sorted((u, v, end))) for end in (p, q)], [tuple(sorted((p, q, end))) for end in (u, v)])
    if len(ids) == 3:
        one, more = [], [tuple(sorted(ids))]
    else:
        point, *link = ids
        one, more = [tuple(sorted(link))], [tuple(sorted((point, *edge))) for edge in combinations(link, 2)]
    return (one, more) if kind in ("leave", "show") else (more, one)


# ---- from positions


def determinant(rows):
    """Of two or three rows."""
    if len(rows) == 2:
        (a, b), (c, d) = rows
        return a * d - b * c
    (a, b, c), (d, e, f), (g, h, i) = rows
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)


def sign(value):
    return (value > 0) - (value < 0)


class Lifted:
    """Points in the plane or in space, lifted to heights. The plane through a simplex is computed once."""

    def __init__(self, positions, height):
        self.points = {o: [*p, height(p)] for o, p in positions.items()}
        self.planes = {}

    def from_last(self, ids):
        last = self.points[ids[-1]]
        return [[x - y for x, y in zip(self.points[i], last)] for i in ids[:-1]]

    def orientation(self, *ids):
        return sign(determinant([row[:-1] for row in self.from_last(ids)]))

    def plane(self, ids):
        """A normal, the cofactors of another row, and its product with the points of the plane."""
        rows = self.from_last(ids)
        normal = [(-1) ** (len(rows) + j) * determinant([row[:j] + row[j + 1:] for row in rows])
                  for j in range(len(ids))]
        return normal, dot(normal, self.points[ids[-1]])

    def below(self, *ids):
        """The sign of the determinant of the first points, lifted, from the last one."""
        simplex = ids[:-1]
        if simplex not in self.planes:
            self.planes[simplex] = self.plane(simplex)
        normal, offset = self.planes[simplex]
        return sign(offset - dot(normal, self.points[ids[-1]]))


def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def regular_of(positions, size, radii):
    """Simplices of this size. Without weights they are 0; discs have the squares of their radii."""
    def height(p):
        extent = p.extents[0] if getattr(p, "extents", None) else 0
        return dot(p, p) - (extent ** 2 if radii else extent)

    lifted = Lifted(positions, height)
    return simplices(positions, size, lifted.orientation, lifted.below)


def cells_of(positions):
    lifted = Lifted(positions, lambda p: dot(p, p))
    return cells(positions, lambda *ids: -lifted.orientation(*ids), lambda *ids: -lifted.below(*ids),
                 lambda a, b: tuple(positions[a]) == tuple(positions[b]))
