# SPDX-License-Identifier: GPL-3.0-or-later
"""Level 5, width_2 and the smallest rectangles: of every edge of the hull the vertices that calipers flush with it
touch, from positions. Of equally far vertices the smallest number; of equal strips or rectangles that of the smallest
tail."""

from fractions import Fraction

# The order of two strips or rectangles by the objects that touch them: the first is at most as large.
ORDERS = {"width_2": "order_strip", "min_area_rectangle_2": "order_rectangle_area",
          "min_perimeter_rectangle_2": "order_rectangle_perimeter"}


def candidates_of(name, cycle, positions):
    """Of every edge (a, b) of the hull: a, b, and the vertices to the right, opposite and to the left; of a strip the
    opposite one alone."""
    found = []
    for i in sorted(range(len(cycle)), key=lambda i: cycle[i]):
        a, b = cycle[i], cycle[(i + 1) % len(cycle)]
        u = tuple(q - p for p, q in zip(positions[a], positions[b]))
        ways = [(-u[1], u[0])] if name == "width_2" else [u, (-u[1], u[0]), (-u[0], -u[1])]
        found.append((a, b) + tuple(max(sorted(cycle), key=lambda o: along(way, positions[o])) for way in ways))
    return found


def along(u, p):
    return u[0] * p[0] + u[1] * p[1]


def size_of(name, touched, positions):
    """The squared width; the area; the square of half the perimeter."""
    a, b, *others = (positions[o] for o in touched)
    u = tuple(q - p for p, q in zip(a, b))
    normal, square = (-u[1], u[0]), along(u, u)
    if name == "width_2":
        return Fraction((along(normal, others[0]) - along(normal, a)) ** 2) / square
    right, opposite, left = others
    height, width = along(normal, opposite) - along(normal, a), along(u, right) - along(u, left)
    return Fraction(height * width if "area" in name else (height + width) ** 2) / square


def smallest_flush(name, cycle, positions):
    if len(cycle) < 3:
        return []
    return list(min(candidates_of(name, cycle, positions), key=lambda touched: size_of(name, touched, positions)))
