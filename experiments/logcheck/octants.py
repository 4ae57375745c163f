# SPDX-License-Identifier: GPL-3.0-or-later
"""Which point is next in which cone: four octants and two quadrants around every point, by definition.

The orders are along x, y, x + y, x - y, right after an infinitesimal turn: points that are level by the first key
are in the order of the second one, equal points in that of their numbers.
"""

from functools import cmp_to_key

AXES = ("order_x", "order_y", ("order_direction", (1, 1)), ("order_direction", (1, -1)))
X, Y, SUM, DIFFERENCE = range(4)
# The second key of an axis: another axis, and whether it ascends.
SECOND = {X: (Y, -1), Y: (X, 1), SUM: (DIFFERENCE, 1), DIFFERENCE: (SUM, -1)}
# A cone: the signs of two orders, and the order by which the first point is the next one.
CONES = (((X, -1), (DIFFERENCE, 1), (Y, -1)), ((Y, 1), (DIFFERENCE, 1), (X, 1)), ((Y, 1), (X, -1), (DIFFERENCE, -1)),
         ((Y, -1), (SUM, 1), (X, 1)), ((X, -1), (SUM, 1), (Y, 1)), ((X, -1), (Y, -1), (SUM, -1)))
OCTANTS = (0, 1, 3, 4)


def precedes_by(sign):
    """From sign(axis, a, b), positive if b is farther along: is a before b along the axis?"""
    def precedes(axis, a, b):
        second, factor = SECOND[axis]
        value = sign(axis, a, b) or factor * sign(second, a, b)
        return value > 0 or (value == 0 and a < b)

    return precedes


def places_along(members, precedes):
    """A function of an axis and of 1 or -1, the way along it: {member: its place in that order}."""
    known = {}

    def places(axis, way):
        if (axis, way) not in known:
            order = sorted(members, key=cmp_to_key(lambda a, b: -1 if precedes(axis, a, b) else 1))
            known[axis, 1] = {p: place for place, p in enumerate(order)}
            known[axis, -1] = {p: -place for place, p in enumerate(order)}
        return known[axis, way]

    return places


def pointers_of(members, precedes, cones=CONES):
    """{(p, cone): the next point}, without those that have none."""
    places = places_along(members, precedes)
    result = {}
    for cone, axes in enumerate(cones):
        one, other, by = (places(*axis) for axis in axes)
        for p in members:
            within = [q for q in members if one[p] < one[q] and other[p] < other[q]]
            if within:
                result[p, cone] = min(within, key=by.get)
    return result


def pairs_of_pointers(pointers, counted=OCTANTS):
    return sorted({tuple(sorted((p, q))) for (p, cone), q in pointers.items() if cone in counted})


def pairs_of_positions(positions):
    def sign(axis, a, b):
        u = ((1, 0), (0, 1), (1, 1), (1, -1))[axis]
        value = sum(c * (y - x) for c, x, y in zip(u, positions[a], positions[b]))
        return (value > 0) - (value < 0)

    return pairs_of_pointers(pointers_of(sorted(positions), precedes_by(sign)))
