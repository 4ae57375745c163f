# SPDX-License-Identifier: GPL-3.0-or-later
"""What is in force: the motions right after now, and the polynomials of queries under them."""

from math import lcm

from polynomials import negated, primitive, scaled
from predicates import formula_of, needs_unit, normal_form
from roots import SignChanges, compare, window_of
from scene import Extended


class World:
    def __init__(self, scene):
        self.scene = scene
        self.window = window_of(scene.start, scene.end)
        self.alive = set(scene.first)
        self.piece = dict(scene.first)  # per object: the flight plan in force
        self.version = {number: 0 for number in scene.first}
        self.cache = {}
        self.lines = {}  # the numbers of the lines of grids, by name, of all structures
        self.looks_back = False  # sign_after is sign_before: for an attribute right before an instant
        self.in_force = {}  # of queries under the motions in force: what changes() returns

    def set_motion(self, number, piece):
        self.in_force.clear()
        self.piece[number] = piece
        self.version[number] = self.version.get(number, -1) + 1

    def polynomial(self, predicate, ids):
        """The value of predicate(ids) in t, times a positive number."""
        pieces = [self.piece[i] for i in ids]
        common = lcm(*(p.denominator for p in pieces))
        points = [[scaled(axis, common // p.denominator) for axis in p.polynomials] for p in pieces]
        if self.scene.extents == "weight":  # has the units of a square
            points = [p[:-1] + [scaled(p[-1], common)] for p in points]
        if needs_unit(predicate):
            points.append((common,))
        if self.scene.extents:
            points = [Extended(p, self.scene.dimension) for p in points]
        return primitive(formula_of(predicate)[0](points))

    def approximate_position(self, number, x):
        """In doubles; OverflowError where they are too small for it."""
        piece, t = self.piece[number], x.approximate()
        position = []
        for p in piece.polynomials:
            value = 0.0
            for c in reversed(p):
                value = value * t + c / piece.denominator
            position.append(value)
        return position

    def changes(self, predicate, ids):
        """Where the value changes its sign: (SignChanges of its normal form, +1 or -1)."""
        query = (predicate, tuple(ids))
        found = self.in_force.get(query)
        if found is None:
            ids, sign = normal_form(predicate, ids)
            key = (predicate, ids, tuple([self.version[i] for i in ids]))
            changes = self.cache.get(key)
            if changes is None:
                changes = self.cache[key] = SignChanges(self.polynomial(predicate, ids), self.window)
            found = self.in_force[query] = changes, sign
        return found

    def sign_after(self, query, x):
        """On (x, x + eps); 0 only where the value is zero identically."""
        changes, sign = self.changes(*query)
        return sign * (changes.before(x) if self.looks_back else changes.after(x))

    def sign_before(self, query, x):
        """As sign_after, on (x - eps, x), by the motions that are in force right after x."""
        changes, sign = self.changes(*query)
        return sign * changes.before(x)

    def is_zero(self, query):
        return not self.changes(*query)[0].p

    def first_negative(self, query, x):
        """The first instant >= x right after which the value is negative, or None."""
        changes, sign = self.changes(*query)
        if not changes.p:
            return None
        if sign > 0:
            return changes.first_negative(x)
        i = changes.first_after(x)
        if (changes.sign if i % 2 == 0 else -changes.sign) > 0:
            return x
        return changes.roots[i] if i < len(changes.roots) else None

    def first_touch(self, query, x):
        """Where the value, which is not negative right after x, is zero first after x; None: nowhere."""
        changes, _ = self.changes(*query)
        touch = next((r for r in changes.touches if compare(x, r) < 0), None)
        negative = self.first_negative(query, x)
        if touch is None or (negative is not None and compare(negative, touch) < 0):
            return negative
        return touch

    def vanishes(self, query, x):
        """The value is zero at x, by whatever multiplicity."""
        changes, _ = self.changes(*query)
        if any(compare(r, x) == 0 for r in changes.roots + changes.touches):
            return True
        return not changes.p or vanishes_at(changes.p, x)


def vanishes_at(p, x):
    """p(x) = 0."""
    from polynomials import common_divisor, sign_at
    from roots import changes_sign_between

    if x.value is not None:
        return sign_at(p, *x.value) == 0
    g = common_divisor(p, x.p)
    return len(g) > 1 and changes_sign_between(g, (x.a, x.k), (x.b, x.k))
