# SPDX-License-Identifier: GPL-3.0-or-later
"""The predicates' formulas for points, from their definitions. A certificate says: value >= 0.

Each takes the coordinates of its arguments, integer polynomials over one common denominator, as
points[i][axis]. ALTERNATING is the number of leading arguments whose exchange changes the sign.
"""

from math import gcd, lcm

from plane_predicates import difference_3, obtuse_angle_3, of_planes, unfolded_3
from polynomials import add, multiply, scaled, subtract


def order(axis):
    """a comes before b on the axis."""
    return lambda points: subtract(points[1][axis], points[0][axis])


def order_direction(direction):
    """a comes before b in the direction."""
    common = lcm(*(c.denominator for c in direction))
    whole = [int(c * common) for c in direction]
    divisor = gcd(*whole)

    def value(points):
        result = ()
        for axis, factor in enumerate(whole):
            if factor:
                step = subtract(points[1][axis], points[0][axis])
                result = add(result, scaled(step, factor // divisor))
        return result

    return value


def order_extent(weights):
    """The sum of w.x over the arguments x and their vectors w, which add up to zero."""
    common = lcm(*(c.denominator for w in weights for c in w))
    whole = [[int(c * common) for c in w] for w in weights]

    def value(points):
        result = ()
        for point, w in zip(points, whole):
            for axis, factor in enumerate(w):
                if factor:
                    result = add(result, scaled(point[axis], factor))
        return result

    return value


def order_boxes(measure, u, v):
    """Of two boxes with a side along the unit vectors u and v, each by the four objects that are farthest along it,
    against it, along it turned by a right angle and against that: the second is at least as large as the first."""
    common = lcm(*(c.denominator for c in (*u, *v)))

    def extent(w, far, near):
        result = ()
        for axis, factor in enumerate(w):
            result = add(result, scaled(subtract(far[axis], near[axis]), int(factor * common)))
        return result

    def size(w, points):
        along, across = extent(w, *points[:2]), extent((-w[1], w[0]), *points[2:])
        return multiply(along, across) if measure == "area" else add(along, across)

    return lambda points: subtract(size(v, points[4:]), size(u, points[:4]))


def squared_distance(a, b):
    result = ()
    for x, y in zip(a, b):
        d = subtract(x, y)
        result = add(result, multiply(d, d))
    return result


def order_squared_distance(points):
    """a is nearer than b to the third point."""
    return subtract(squared_distance(points[1], points[2]), squared_distance(points[0], points[2]))


def order_pair_distance(points):
    """The first two are closer to each other than the other two."""
    a, b, c, d = points
    return subtract(squared_distance(c, d), squared_distance(a, b))


def cross(u, v):
    return subtract(multiply(u[0], v[1]), multiply(u[1], v[0]))


def difference(a, b):
    return (subtract(a[0], b[0]), subtract(a[1], b[1]))


def orientation_2(points):
    """a, b, c turn counter-clockwise."""
    a, b, c = points
    return cross(difference(b, a), difference(c, a))


def slope_order_2(points):
    """The direction from c to d is counter-clockwise from that from a to b, by less than half a turn."""
    a, b, c, d = points
    return cross(difference(b, a), difference(d, c))


def in_circle_2(points):
    """d is inside the circle through a, b, c, for a, b, c counter-clockwise."""
    d = points[3]
    u, v, w = (difference(p, d) for p in points[:3])

    def lifted(p):
        return add(multiply(p[0], p[0]), multiply(p[1], p[1]))

    return add(add(multiply(lifted(u), cross(v, w)), multiply(lifted(v), cross(w, u))),
               multiply(lifted(w), cross(u, v)))


def triple_product(u, v, w):
    """The determinant of three rows."""
    return add(add(multiply(cross(u, v), w[2]), multiply(cross(v, w), u[2])), multiply(cross(w, u), v[2]))


def orientation_3(points):
    """d is on the side of a, b, c that makes the tetrahedron positive."""
    a, b, c, d = points
    return triple_product(*(difference_3(p, a) for p in (b, c, d)))


def power_in_space(points, heights):
    """The last point is below the plane of the others, lifted to x^2 + y^2 + z^2 - height, for a positive tetrahedron."""
    rows = [difference_3(p, points[4]) for p in points[:4]]
    result = ()
    for i, row in enumerate(rows):
        square = add(add(multiply(row[0], row[0]), multiply(row[1], row[1])), multiply(row[2], row[2]))
        lift = add(square, subtract(heights[4], heights[i]))
        minor = triple_product(*(other for j, other in enumerate(rows) if j != i))
        # Along the last column the signs are - + - +, and the determinant is negated.
        result = add(result, scaled(multiply(lift, minor), 1 if i % 2 == 0 else -1))
    return result


def in_sphere_3(points):
    """e is inside the sphere through a, b, c, d, for a positive tetrahedron."""
    return power_in_space(points, [()] * 5)


def acute_angle_2(points):
    """The angle at b between a and c is acute."""
    a, b, c = points
    return dot(difference(a, b), difference(c, b))


def obtuse_angle_2(points):
    return scaled(acute_angle_2(points), -1)


def dot(u, v):
    return add(multiply(u[0], v[0]), multiply(u[1], v[1]))


def edge_dot_2(points):
    """The directions from a to b and from c to d form an acute angle."""
    a, b, c, d = points
    return dot(difference(b, a), difference(d, c))


def fraction_order(extent):
    """The order of two figures by extent / |b - a|^2, the smaller first."""

    def value(points):
        half = len(points) // 2
        (n, d), (other_n, other_d) = (
            (extent(p), squared_distance(p[0], p[1])) for p in (points[:half], points[half:]))
        return subtract(multiply(other_n, d), multiply(n, other_d))

    return value


def height(points, c):
    return cross(difference(points[1], points[0]), difference(points[c], points[0]))


def width(points):
    return dot(difference(points[1], points[0]), difference(points[2], points[4]))


def strip(points):
    """a, b, and c opposite."""
    return multiply(height(points, 2), height(points, 2))


def area(points):
    """a, b, then right, opposite, left."""
    return multiply(height(points, 3), width(points))


def perimeter(points):
    half = add(height(points, 3), width(points))
    return multiply(half, half)


def low(point, axis):
    """The lower end of a box, or of a disc's box."""
    return subtract(point[axis], point.half(axis))


def high(point, axis):
    return add(point[axis], point.half(axis))


def end_orders(axis):
    """One end is not beyond another: {name: (formula, arguments, alternating arguments)}."""
    letter = "xyz"[axis]
    return {
        "lower_ends_" + letter: (lambda p: subtract(low(p[1], axis), low(p[0], axis)), 2, 2),
        "upper_ends_" + letter: (lambda p: subtract(high(p[1], axis), high(p[0], axis)), 2, 2),
        "meeting_" + letter: (lambda p: subtract(high(p[1], axis), low(p[0], axis)), 2, 1),
        "apart_" + letter: (lambda p: subtract(low(p[0], axis), high(p[1], axis)), 2, 1),
        "half_width_" + letter: (lambda p: p[0].half(axis), 1, 1),
        "no_width_" + letter: (lambda p: scaled(p[0].half(axis), -1), 1, 1),
    }


def disc_overlap(points):
    """The discs meet."""
    reach = add(points[0].half(0), points[1].half(0))
    return subtract(multiply(reach, reach), squared_distance(points[0], points[1]))


def disc_apart(points):
    return scaled(disc_overlap(points), -1)


def gap_terms():
    """The order of the gaps of two pairs of discs, by claims about four discs: {name: (formula, arguments, alternating
    arguments)}."""

    def measures(points):
        a, b, p, q = points
        radii = [add(one.half(0), other.half(0)) for one, other in ((a, b), (p, q))]
        s = subtract(*radii)
        return s, multiply(s, s), squared_distance(a, b), squared_distance(p, q)

    def left(points):
        _, square, one, other = measures(points)
        return subtract(add(other, square), one)

    def right(points):
        _, square, one, other = measures(points)
        return subtract(subtract(other, square), one)

    def product(points):
        _, square, one, other = measures(points)
        difference = subtract(one, other)
        mixed = scaled(multiply(square, add(one, other)), -2)
        return add(add(multiply(difference, difference), mixed), multiply(square, square))

    terms = {"radius_order": lambda points: measures(points)[0], "gap_left": left, "gap_right": right,
             "gap_product": product}
    result = {}
    for name, value in terms.items():
        result[name] = (value, 4, 1)
        result[name + "_negated"] = (lambda points, value=value: scaled(value(points), -1), 4, 1)
    return result


def power(points, heights):
    """The last point is below the plane of the others, lifted to x^2 + y^2 - height."""
    x, y, lift = [], [], []
    for p, h in zip(points[:3], heights[:3]):
        x.append(subtract(p[0], points[3][0]))
        y.append(subtract(p[1], points[3][1]))
        square = add(multiply(x[-1], x[-1]), multiply(y[-1], y[-1]))
        lift.append(add(square, subtract(heights[3], h)))
    total = ()
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        total = add(total, multiply(lift[i], subtract(multiply(x[j], y[k]), multiply(x[k], y[j]))))
    return total


def power_2(points):
    return power(points, [p.extents[0] if getattr(p, "extents", None) else () for p in points])


def disc_power_2(points):
    return power(points, [multiply(p.extents[0], p.extents[0]) for p in points])


def power_3(points):
    return power_in_space(points, [p.extents[0] if getattr(p, "extents", None) else () for p in points])


def disc_power_3(points):
    return power_in_space(points, [multiply(p.extents[0], p.extents[0]) for p in points])


def line_side(points):
    """The point is above the line y = a x + b, a and b its axes; the third argument is the unit."""
    (a, b), (x, y), unit = points
    return subtract(multiply(subtract(y, b), unit), multiply(a, x))


def line_under(points):
    return scaled(line_side(points), -1)


def line_order(points):
    """At the x of the point the second line is above the first; the fourth argument is the unit."""
    (a, b), (c, d), (x, _), unit = points
    return add(multiply(subtract(c, a), x), multiply(subtract(d, b), unit))


def order_line_height(points):
    """The first point is no farther above or below the first line than the second point is from the second line; the
    fifth argument is the unit."""
    l, p, m, q, unit = points
    near, far = line_side((l, p, unit)), line_side((m, q, unit))
    return subtract(multiply(far, far), multiply(near, near))


def order_line_distance(points):
    """The same, at right angles to the lines."""
    l, p, m, q, unit = points
    near, far = line_side((l, p, unit)), line_side((m, q, unit))
    one = multiply(unit, unit)
    return subtract(multiply(multiply(far, far), add(one, multiply(l[0], l[0]))),
                    multiply(multiply(near, near), add(one, multiply(m[0], m[0]))))


# Formulas that are not homogeneous: behind the arguments they get the common denominator.
NEED_UNIT = ("line_side", "line_under", "line_order", "order_line_height", "order_line_distance")


def needs_unit(predicate):
    return isinstance(predicate, str) and predicate.partition("/")[0] in NEED_UNIT


FORMULAS = {
    "power_2": (power_2, 4, 4),
    "disc_power_2": (disc_power_2, 4, 4),
    "power_3": (power_3, 5, 5),
    "disc_power_3": (disc_power_3, 5, 5),
    "unfolded_3": (unfolded_3, 4, 1),
    "obtuse_angle_3": (obtuse_angle_3, 3, 1),
    **of_planes(),
    "line_side": (line_side, 2, 1),
    "line_under": (line_under, 2, 1),
    "line_order": (line_order, 3, 2),
    "order_line_height": (order_line_height, 4, 1),
    "order_line_distance": (order_line_distance, 4, 1),
    "disc_overlap": (disc_overlap, 2, 1),
    "disc_apart": (disc_apart, 2, 1),
    **gap_terms(),
    **end_orders(0), **end_orders(1), **end_orders(2),
    "edge_dot_2": (edge_dot_2, 4, 2),
    "order_strip": (fraction_order(strip), 6, 1),
    "order_rectangle_area": (fraction_order(area), 10, 1),
    "order_rectangle_perimeter": (fraction_order(perimeter), 10, 1),
    "order_x": (order(0), 2, 2),
    "order_y": (order(1), 2, 2),
    "order_z": (order(2), 2, 2),
    "order_squared_distance": (order_squared_distance, 3, 2),
    "order_pair_distance": (order_pair_distance, 4, 0),
    "orientation_2": (orientation_2, 3, 3),
    "slope_order_2": (slope_order_2, 4, 0),
    "in_circle_2": (in_circle_2, 4, 4),
    "orientation_3": (orientation_3, 4, 4),
    "in_sphere_3": (in_sphere_3, 5, 5),
    "acute_angle_2": (acute_angle_2, 3, 1),
    "obtuse_angle_2": (obtuse_angle_2, 3, 1),
}
# Orders of boxes along two directions, and what is compared.
BOX_ORDERS = {"order_box_area": "area", "order_box_perimeter": "perimeter"}
# Axes that an argument must have.
LEAST_AXES = {"order_y": 2, "order_z": 3, "orientation_2": 2, "slope_order_2": 2, "in_circle_2": 2, "power_2": 2, "disc_power_2": 2,
              "orientation_3": 3, "in_sphere_3": 3, "power_3": 3, "disc_power_3": 3, "unfolded_3": 3,
              "obtuse_angle_3": 3, **{name: 3 for name in of_planes()},
              "acute_angle_2": 2, "obtuse_angle_2": 2, "line_side": 2, "line_under": 2, "line_order": 2,
              "order_line_height": 2, "order_line_distance": 2,
              **{name: axis + 1 for axis in (1, 2) for name in end_orders(axis)}}


def axis_order(axis):
    """The name of the order on an axis, as logs write it."""
    return "order_" + "xyz"[axis]


def distance_query(front, back):
    """The first pair is at most as far apart as the second; they may share an object, not both."""
    for u, v in (front, front[::-1]):
        for w, z in (back, back[::-1]):
            if u == w:
                return ("order_squared_distance", (v, z, u))
    return ("order_pair_distance", (*front, *back))


class Key:
    """The key of a one-dimensional structure."""

    def __init__(self, key):
        self.reference = key[1] if key[0] == "distance" else None
        if key[0] == "axis":
            self.predicate = axis_order(key[1])
        elif key[0] == "direction":
            self.predicate = ("order_direction", tuple(key[1]))
        else:
            self.predicate = "order_squared_distance"

    @property
    def name(self):
        """In the form of a log."""
        return self.predicate if isinstance(self.predicate, str) else self.predicate[0]

    def claim(self, a, b):
        """key(a) <= key(b)."""
        return (self.predicate, (a, b) if self.reference is None else (a, b, self.reference))


def formula_of(predicate):
    """(value, number of arguments, alternating arguments) of a name, or of ("order_direction", v)."""
    if isinstance(predicate, tuple) and predicate[0] == "order_extent":
        return order_extent(predicate[1]), len(predicate[1]), 0
    if isinstance(predicate, tuple) and predicate[0] in BOX_ORDERS:
        return order_boxes(BOX_ORDERS[predicate[0]], *predicate[1:]), 8, 0
    if isinstance(predicate, tuple):
        return order_direction(predicate[1]), 2, 2
    if "/" in predicate:
        # Of fewer objects: digit i says which of them is argument i.
        whole, pattern = predicate.split("/")
        value, arity = FORMULAS[whole][0], int(max(pattern)) + 1
        return lambda points: value([points[int(i)] for i in pattern] + points[arity:]), arity, 1
    return FORMULAS[predicate]


def places_of(name, arity):
    """Of a predicate that takes `arity` arguments, or fewer objects at these places ("whole/pattern"): the places;
    None: the name says something else."""
    pattern = name.partition("/")[2] if "/" in name else None
    if pattern is None:
        return list(range(arity))
    digits = sorted(set(pattern))
    good = len(pattern) == arity and digits == [str(i) for i in range(len(digits))]
    return [int(i) for i in pattern] if good else None


def known(name):
    """True for a name of a log that has a formula."""
    whole, slash, pattern = name.partition("/")
    if whole not in FORMULAS or not slash:
        return name in FORMULAS
    return places_of(name, FORMULAS[whole][1]) is not None


def normal_form(predicate, ids):
    """The ids of a query in the order in which its polynomial is stored, and the sign of that permutation."""
    if isinstance(predicate, tuple) and predicate[0] != "order_direction":
        return tuple(ids), 1
    alternating = formula_of(predicate)[2]
    if predicate == "order_pair_distance":
        # Either pair in ascending order, the smaller pair first.
        first, second = tuple(sorted(ids[:2])), tuple(sorted(ids[2:]))
        if second < first:
            return second + first, -1
        return first + second, 1
    if alternating == 0:
        # (b - a) x (d - c), each pair in ascending order, the smaller pair first.
        a, b, c, d = ids
        sign = 1
        if a > b:
            a, b, sign = b, a, -sign
        if c > d:
            c, d, sign = d, c, -sign
        if (c, d) < (a, b):
            a, b, c, d, sign = c, d, a, b, -sign
        return (a, b, c, d), sign
    head = list(ids[:alternating])
    sign = 1
    for i in range(1, alternating):
        j = i
        while j and head[j - 1] > head[j]:
            head[j - 1], head[j] = head[j], head[j - 1]
            sign = -sign
            j -= 1
    return tuple(head) + tuple(ids[alternating:]), sign
