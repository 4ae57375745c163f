# SPDX-License-Identifier: GPL-3.0-or-later
"""The gaps between instants, and a rational time in each: for level 5."""

from fractions import Fraction
from functools import cmp_to_key
from math import lcm

from roots import all_roots, compare
from scene import Extended


def low_end(x):
    return Fraction(*x.value) if x.value is not None else Fraction(x.a, 1 << x.k)


def high_end(x):
    return Fraction(*x.value) if x.value is not None else Fraction(x.b, 1 << x.k)


def rational_between(x, y):
    """x < y."""
    while True:
        a, b = high_end(x), low_end(y)
        if a < b or (a == b and x.value is None and y.value is None):
            return simplest((a + b) / 2, a, b)
        x.refine(8)
        y.refine(8)


def simplest(t, a, b):
    """A number of few bits near t, between a and b."""
    if a == b:
        return t
    k = 1
    while True:
        rounded = Fraction(round(t * k), k)
        if a < rounded < b:
            return rounded
        k *= 16


def merged(instants):
    """Sorted, each once."""
    instants.sort(key=cmp_to_key(compare))
    result = []
    for x in instants:
        if not result or compare(result[-1], x) != 0:
            result.append(x)
    return result


def whole(position, common, has_weight):
    """All times `common`, a weight times its square."""
    result = [c.numerator * (common // c.denominator) for c in position]
    if has_weight:
        result[-1] *= common
    return result


class Period:
    """A time during which no motion changes. `until`: None is for ever. `roots`: of the
    polynomials so far."""

    def __init__(self, world, begin, until, roots):
        self.world, self.begin, self.until, self.roots = world, begin, until, roots

    def samples(self, queries):
        """[(a gap between two roots of queries, a time in it)], each gap a period of its own."""
        instants = [self.begin]
        for query in queries:
            p = self.world.changes(*query)[0].p
            if p not in self.roots:
                self.roots[p] = all_roots(p, self.world.window)
            instants += [r for r in self.roots[p]
                         if compare(r, self.begin) > 0 and (self.until is None or compare(r, self.until) < 0)]
        instants = merged(instants)
        instants.append(self.until)
        return [(Period(self.world, x, y, self.roots), high_end(x) + 1 if y is None else rational_between(x, y))
                for x, y in zip(instants, instants[1:]) if y is None or compare(x, y) < 0]

    def positions_of(self, objects, t):
        """In whole numbers, which are faster: times a positive number, but for lines, which have no unit of length."""
        piece, scene = self.world.piece, self.world.scene
        axes = {o: [piece[o].position(axis, t) for axis in range(len(piece[o].axes))] for o in objects}
        if not any(scene.objects[o].line for o in objects):
            common = lcm(*(c.denominator for position in axes.values() for c in position))
            axes = {o: whole(position, common, scene.extents == "weight") for o, position in axes.items()}
        return {o: Extended(position, scene.dimension) for o, position in axes.items()}
