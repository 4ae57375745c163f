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
    if len(rows) == 1:
        return rows[0][0]
    return sum((-1) ** i * row[0] * determinant([other[1:] for j, other in enumerate(rows) if j != i])
               for i, row in enumerate(rows) if row[0])


def sign(value):
    return (value > 0) - (value < 0)


def regular_of(positions, size, radii):
    """Simplices of this size. Without weights they are 0; discs have the squares of their radii."""
    def height(p):
        extent = p.extents[0] if getattr(p, "extents", None) else 0
        return sum(x * x for x in p) - (extent ** 2 if radii else extent)

    def from_last(ids):
        last = positions[ids[-1]]
        return [[x - y for x, y in zip(positions[i], last)] for i in ids[:-1]]

    def orientation(*ids):
        return sign(determinant(from_last(ids)))

    def below(*ids):
        last = positions[ids[-1]]
        rows = []
        for i, row in zip(ids, from_last(ids)):  # lifted, from the last one: x^2 + y^2 - 2 (x x' + y y') + ..
            shift = sum(x * y for x, y in zip(row, last))
            rows.append(row + [height(positions[i]) - height(last) - 2 * shift])
        return sign(determinant(rows))

    return simplices(positions, size, orientation, below)


def cells_of(positions):
    def from_last(*ids):
        last = positions[ids[-1]]
        return [[x - y for x, y in zip(positions[i], last)] for i in ids[:-1]]

    def orientation(*ids):
        return -sign(determinant(from_last(*ids)))

    def in_sphere(*ids):
        return -sign(determinant([row + [sum(x * x for x in row)] for row in from_last(*ids)]))

    return cells(positions, orientation, in_sphere, lambda a, b: tuple(positions[a]) == tuple(positions[b]))
