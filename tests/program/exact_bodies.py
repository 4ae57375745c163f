# SPDX-License-Identifier: GPL-3.0-or-later
"""Rigid polygons in exact rationals, from a scene's own text: where they are, what the certificates of
a proof are worth, and which features are the closest. It shares nothing with kinex but the definitions.
"""
import json
import re
from fractions import Fraction


def value(coefficients, t):
    return sum(Fraction(str(c)) * t**i for i, c in enumerate(coefficients))


class Body:
    def __init__(self, entry):
        self.name = entry["id"]
        self.polygon = [tuple(Fraction(str(x)) for x in v) for v in entry["polygon"]]
        pieces = entry["motion"]
        if not isinstance(pieces[0], dict):
            pieces = [{"coordinates": pieces, "rotor": entry.get("rotor", [[1], [0]])}]
        self.pieces = pieces

    def at(self, t):
        """The position and the rotation c + is."""
        for piece in self.pieces:
            if t < Fraction(str(piece.get("to", t + 1))):
                break
        x, y = (value(c, t) for c in piece["coordinates"])
        p, q = (value(c, t) for c in piece.get("rotor", [[1], [0]]))
        n = p * p + q * q
        return (x, y), ((p * p - q * q) / n, 2 * p * q / n)

    def vertices(self, t):
        (x, y), r = self.at(t)
        return [(x + a, y + b) for a, b in (turn(r, v) for v in self.polygon)]


def turn(r, v):
    return r[0] * v[0] - r[1] * v[1], r[1] * v[0] + r[0] * v[1]


def back(r, v):
    return turn((r[0], -r[1]), v)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def minus(a, b):
    return a[0] - b[0], a[1] - b[1]


def bodies_of(path):
    scene = json.loads(path.read_text(encoding="utf-8"), parse_float=Fraction)
    return {entry["id"]: Body(entry) for entry in scene["objects"]}


class Claim:
    """A certificate "name(pose, line, point)" with its numbers, or None where it is on no pose."""

    def __init__(self, text):
        self.name, arguments = re.fullmatch(r"(\w+)\((.*)\)", text).groups()
        numbers = lambda part: tuple(Fraction(x) for x in re.split(r"[,|]", part))
        self.lines = [numbers(x) for x in re.findall(r"\[([^\]]*)\]", arguments)]
        self.points = [numbers(x) for x in re.findall(r"\(([^)]*)\)", arguments)]

    def value(self, a, b, t):
        """Of B as seen from A: what the certificate says is non-negative."""
        (ca, ra), (cb, rb) = a.at(t), b.at(t)
        where, r = back(ra, minus(cb, ca)), back(ra, rb)
        if self.name in ("side_a", "inside_a"):
            (mx, my, h), = self.lines
            result = dot((mx, my), minus(where, turn(r, self.points[0]))) - h
        elif self.name in ("side_b", "inside_b"):
            (gx, gy, h), = self.lines
            result = dot(turn(r, (gx, gy)), minus(where, self.points[0])) - h
        elif self.name.startswith("normal_order"):
            m, g = self.lines
            result = cross(turn(r, g[:2]), m[:2])
        elif self.name.endswith("_of_ray"):
            a0, b0, a1, b1 = self.points
            plus = lambda p, q: minus(p, (-q[0], -q[1]))
            centre, end = plus(a0, turn(r, b0)), plus(a1, turn(r, b1))
            result = cross(minus(end, centre), minus(where, centre))
        else:
            return None
        negated = self.name.startswith(("inside", "right")) or self.name.endswith("reversed")
        return -result if negated else result


def check_line(polygon, line, feature):
    """None if the displayed feature is where this line touches the polygon, or what is wrong."""
    n, h = line[:2], line[2]
    heights = [dot(v, n) - h for v in polygon]
    kind, first = feature[0], int(re.match(r"\d+", feature[1:]).group())
    following = (first + 1) % len(polygon)
    if " at v" in feature:
        end = int(feature.split(" at v")[1])
        along = minus(polygon[following], polygon[first])
        good = heights[end] == 0 and cross(n, along) == 0 and end in (first, following)
    elif kind == "e":
        good = heights[first] == 0 == heights[following] and max(heights) == 0
    else:
        good = heights[first] == 0 and sorted(heights)[-2] < 0
    return None if good else f"{feature} is not where the line {line} touches"


def check_point(polygon, point, feature):
    """The same for a point: a vertex, or a corner over vertices."""
    if ".." not in feature:
        return None if polygon[int(feature[1:])] == point else f"{feature} is not at {point}"
    first, last = (int(x) for x in feature[1:].split("..v"))
    left = all(cross(minus(v, point), minus(polygon[first], point)) >= 0 for v in polygon)
    right = all(cross(minus(v, point), minus(polygon[last], point)) <= 0 for v in polygon)
    if not left and not right:
        left = all(cross(minus(v, point), minus(polygon[first], point)) <= 0 for v in polygon)
        right = all(cross(minus(v, point), minus(polygon[last], point)) >= 0 for v in polygon)
    return None if left and right else f"{feature} is not the corner at {point}"


def squared_distance(p, q):
    """Of two features: one vertex, or a vertex and the two ends of an edge."""
    if len(p) == 2:
        p, q = q, p
    if len(q) == 1:
        return dot(minus(p[0], q[0]), minus(p[0], q[0]))
    d = minus(q[1], q[0])
    f = max(Fraction(0), min(Fraction(1), dot(minus(p[0], q[0]), d) / dot(d, d)))
    foot = q[0][0] + f * d[0], q[0][1] + f * d[1]
    return dot(minus(p[0], foot), minus(p[0], foot))


def closest(a, b):
    """The squared distance of two polygons that are apart."""
    pairs = lambda p, q: (squared_distance([v], [q[i - 1], q[i]]) for v in p for i in range(len(q)))
    return min(min(pairs(a, b)), min(pairs(b, a)))


def overlap(a, b):
    """Whether two convex polygons have inner points in common: no edge's line is between them."""
    for p, q in ((a, b), (b, a)):
        for i, v in enumerate(p):
            along = minus(v, p[i - 1])
            if all(cross(along, minus(w, v)) <= 0 for w in q):
                return False
    return True


def feature_points(vertices, feature):
    i = int(feature[1:])
    return [vertices[i]] if feature[0] == "v" else [vertices[i], vertices[(i + 1) % len(vertices)]]
