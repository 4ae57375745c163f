# SPDX-License-Identifier: GPL-3.0-or-later
"""The cones between neighbouring corners of a polygon around every point, by definition, and the norm of the polygon.

The orders are along vectors, right after an infinitesimal turn: points that are level by the first key are in the
order of the second one, equal points in that of their numbers along (2, 1).
"""

from fractions import Fraction
from functools import lru_cache
from math import gcd, lcm

DOUBLE = {12: ((0, 1), (1, 3), (1, 2)), 20: ((0, 1), (1, 5), (1, 3), (1, 2), (2, 3))}  # tangents of half the angles


def turned(u):
    return (u[1], -u[0])


def opposite(u):
    return (-u[0], -u[1])


@lru_cache(maxsize=None)
def half_circle(corners):
    """The corners of half the unit circle and the next one, counter-clockwise."""
    half = []
    for over, under in DOUBLE[corners]:
        q = Fraction(over, under)
        half.append(((1 - q * q) / (1 + q * q), 2 * q / (1 + q * q)))
    half += [(-y, x) for x, y in half]
    return half + [opposite(half[0])]


def whole(vectors):
    """Multiples of vectors by one number, all of them of whole numbers."""
    common = lcm(*(x.denominator for v in vectors for x in v))
    return [tuple(int(x * common) for x in v) for v in vectors]


@lru_cache(maxsize=None)
def units(corners):
    """Multiples of the linear functions that are 1 at two neighbouring corners."""
    half, result = half_circle(corners), []
    for b, c in zip(half, half[1:]):
        determinant = b[0] * c[1] - b[1] * c[0]
        result.append(((c[1] - b[1]) / determinant, (b[0] - c[0]) / determinant))
    return whole(result)


def direction(v):
    (x, y), = whole([v])
    return (x // gcd(x, y), y // gcd(x, y))


@lru_cache(maxsize=None)
def cones(corners):
    """Those between two corners, each followed by two wide ones; as octants.CONES."""
    half, result = half_circle(corners), []
    for b, c, u in zip(half, half[1:], units(corners)):
        left, right, u = direction((b[1], -b[0])), direction((-c[1], c[0])), direction(u)  # two descend into the cone
        for one, other, by in ((left, right, u), (right, u, left), (u, left, right)):
            result.append(((one, -1), (other, -1), (by, 1)))
    return result


def counted(corners):
    """The cones between two corners."""
    return range(0, len(cones(corners)), 3)


@lru_cache(maxsize=None)
def all_vectors(corners):
    """Those of first and second keys, and their opposites."""
    axes = {u for cone in cones(corners) for u, _ in cone}
    axes |= {turned(u) for u in axes}
    return sorted(axes | {opposite(u) for u in axes})


def precedes_along(sign):
    """From sign(u, a, b), positive if b is farther along: is a before b along u? Every sign is taken once."""
    known = {}

    def precedes(u, a, b):
        if (u, a, b) not in known:
            value = sign(u, a, b) or sign(turned(u), a, b) or (2 * u[0] + u[1]) * (b - a)
            known[u, a, b] = value > 0
            known[u, b, a] = value < 0
        return known[u, a, b]

    return precedes


def sign_at(positions):
    def sign(u, a, b):
        value = sum(c * (y - x) for c, x, y in zip(u, positions[a], positions[b]))
        return (value > 0) - (value < 0)

    return sign
