# SPDX-License-Identifier: GPL-3.0-or-later
"""The predicates' formulas for points of one plane in space: see predicates.py."""

from polynomials import add, multiply, scaled, subtract


def difference_3(a, b):
    return tuple(subtract(x, y) for x, y in zip(a[:3], b[:3]))


def dot_3(u, v):
    total = ()
    for x, y in zip(u, v):
        total = add(total, multiply(x, y))
    return total


def minor(u, v, first, second):
    return subtract(multiply(u[first], v[second]), multiply(u[second], v[first]))


def unfolded_3(points):
    """The half-planes of the first and of the last point, at the line of the others, make an obtuse angle."""
    p, u, v, q = points
    edge, one, other = ([subtract(w[axis], u[axis]) for axis in range(3)] for w in (v, p, q))
    return subtract(multiply(dot_3(edge, one), dot_3(edge, other)), multiply(dot_3(edge, edge), dot_3(one, other)))


def obtuse_angle_3(points):
    """The angle at b between a and c is obtuse."""
    a, b, c = points
    return dot_3(difference_3(a, b), difference_3(b, c))


def projected_orientation(first, second):
    """In projection on two axes of space a, b, c turn counter-clockwise."""

    def value(points):
        u, v = (difference_3(p, points[0]) for p in points[1:])
        return minor(u, v, first, second)

    return value


def no_weight(_):
    return ()


def own_weight(point):
    return point.extents[0] if getattr(point, "extents", None) else ()


def squared_radius(point):
    return multiply(point.extents[0], point.extents[0])


def power_lifted(first, second, weight):
    """Twice the power, of points of one plane in space: d, lifted, is below the plane of a, b, c, which turn
    counter-clockwise in projection. Without weights: d is inside their circle."""

    def value(points):
        rows = [difference_3(p, points[3]) for p in points[:3]]
        result, third = (), 3 - first - second
        total = add(add(rows[0][third], rows[1][third]), rows[2][third])
        for i in range(3):
            above = subtract(weight(points[3]), weight(points[i]))
            height = subtract(scaled(add(dot_3(rows[i], rows[i]), above), 2), multiply(total, rows[i][third]))
            rest = minor(rows[(i + 1) % 3], rows[(i + 2) % 3], first, second)
            result = add(result, multiply(height, rest))
        return result

    return value


def of_planes():
    pairs = {"xy": (0, 1), "xz": (0, 2), "yz": (1, 2)}
    heights = {"in_circle_": no_weight, "power_": own_weight, "disc_power_": squared_radius}
    return {**{"orientation_" + name: (projected_orientation(*pair), 3, 3) for name, pair in pairs.items()},
            **{kind + name: (power_lifted(*pair, weight), 4, 4)
               for kind, weight in heights.items() for name, pair in pairs.items()}}
