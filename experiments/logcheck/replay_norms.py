# SPDX-License-Identifier: GPL-3.0-or-later
"""mst_maximum_norm_*, mst_polygon_*, bichromatic_pair_maximum_norm: the minimum spanning tree in the norm of a polygon,
and the nearest two points of two colours, from scratch right after every instant that has a record. Lengths that are
identically equal are compared after an infinitesimal turn, then as if the points had been moved by their numbers along
(2, 1)."""

from functools import cmp_to_key
from itertools import combinations

from octants import AXES, DIFFERENCE, SUM, X, Y, precedes_by
from polygons import all_vectors, cones, counted, opposite, precedes_along, turned, units
from replay_directions import Along, extent_query
from replay_members import ByTurnedOrders
from replay_octants import corners_of
from replay_scratch import ClosestPairOfOrders, TwoColours
from replay_trees import SpanningTree
from static import spanning_tree

AXIS = {X: (1, 0), Y: (0, 1)}
ALL = ((1, 0), (0, 1), (-1, 0), (0, -1))


class MaximumNorm(ByTurnedOrders):
    """Lengths of pairs of members."""

    def vectors(self):
        return ALL

    def directions(self):
        return AXES

    def meanings(self, name, ids):
        if name in ("order_x", "order_y"):
            return [(name, ids)]
        if name == "order_direction":
            return [(("order_direction", u), ids) for u in self.vectors()]
        found = []
        if name == Along.NAMES.get(len(ids)):
            for u in self.vectors():
                for v in self.vectors():
                    found += [extent_query(u, v, *(ids[i] for i in places)) for places in Along.PLACES[len(ids)]]
        return [q for q in found if q is not None]

    def precedes(self, x):
        return self.precedes_by_signs(lambda query: self.world.sign_after(query, x))

    def precedes_by_signs(self, sign):
        return precedes_by(lambda axis, a, b: sign(
            ("order_x" if axis == X else "order_y" if axis == Y else
             ("order_direction", (1, 1) if axis == SUM else (1, -1)), (a, b))))

    def form(self, pair, precedes):
        """(direction, from, to): the length is that of the step along the direction."""
        p, q = pair
        axis = X if precedes(SUM, p, q) == precedes(DIFFERENCE, p, q) else Y
        return (AXIS[axis], p, q) if precedes(axis, p, q) else (AXIS[axis], q, p)

    def compared(self, one, other, x):
        """Positive: the other form is the longer one; 0 if only numbers decide."""
        (u, a, b), (v, c, d) = one, other
        for turn in (lambda w: w, turned):
            query = extent_query(turn(v), turn(u), d, c, b, a)
            sign = 0 if query is None else self.world.sign_after(query, x)
            if sign:
                return sign
        return 0

    def goes_first(self, x):
        """A function: of two pairs, is the first one the shorter?"""
        precedes, forms = self.precedes(x), {}

        def form(pair):
            if pair not in forms:
                forms[pair] = self.form(pair, precedes)
            return forms[pair]

        def step(pair):
            u, a, b = form(pair)
            return (b - a) * (2 * u[0] + u[1])

        def first(one, other):
            sign = self.compared(form(one), form(other), x)
            return sign > 0 or sign == 0 and (step(one), one) < (step(other), other)

        return first

    def is_turned(self, r, x):
        """The claim compares the turned lengths of its two pairs, which are identically equal."""
        if len(r.ids) != 4:
            return False
        said = {self.world.polynomial(*q) for q in self.meanings(*self.query(r)) if self.world.sign_after(q, x) < 0}
        return any((query is None or self.world.is_zero(query)) and self.world.polynomial(*turn) in said
                   for query, turn in self.lengths_and_turns(tuple(r.ids[:2]), tuple(r.ids[2:]), x))

    def doubt(self, r, x, what):
        """New flight plans make two points level, or two lengths equal: what decides then may be negative since long."""
        self.require(self.is_level_by_motion(self.query(r)[1], x) or self.moved_at is x and self.is_turned(r, x), what)

    def lengths_and_turns(self, old, fresh, x):
        """Of all two lengths that the edges may have right before x or right after it, how much longer the second one
        is, and the same after the turn, if that is not zero by itself."""
        for u, a, b in self.forms_at(old, x):
            for v, c, d in self.forms_at(fresh, x):
                turn = extent_query(turned(v), turned(u), d, c, b, a)
                if turn is not None:
                    yield extent_query(v, u, d, c, b, a), turn

    def forms_at(self, pair, x):
        """As form(): the one right after x, and those of which the length is the same at x."""
        u, a, b = self.form(pair, self.precedes(x))
        for v in self.vectors():
            query = extent_query(u, v, b, a, b, a)
            if query is None or self.world.vanishes(query, x):
                yield v, a, b


class MaximumNormTree(MaximumNorm, SpanningTree):
    def in_order(self, x):
        first = self.goes_first(x)
        return sorted(self.edges(), key=cmp_to_key(lambda one, other: -1 if first(one, other) else 1))

    def tied(self, old, fresh, x):
        precedes = self.precedes(x)
        return self.compared(self.form(old, precedes), self.form(fresh, precedes), x) == 0

    def begin(self, x):
        super().begin(x)
        self.moved = False  # edges have taken the places of others at the present instant: the cycles are other ones
        self.cause = None  # the certificate of the record before, at the present instant

    def record(self, r, x):
        super().record(r, x)
        self.cause = (r.predicate, r.arguments)
        if r.kind not in ("settled", "rebuild"):
            self.moved = True

    def settle(self, x):
        super().settle(x)
        self.moved = False
        self.cause = None

    def doubt(self, r, x, what):
        """Of two lengths that are identically equal the turned ones are compared, which may be negative since long. That
        is a failure only where the two are compared from this instant on: edges have taken the places of others in the
        cycles, or one of the two lengths is along another axis now. A tie in the repair of a failure names that one."""
        if r.kind == "tie" and self.cause == (r.predicate, r.arguments):
            return
        fresh = self.moved or any(self.has_turned(tuple(r.ids[at:at + 2]), x) for at in (0, 2) if len(r.ids) == 4)
        if fresh and self.is_turned(r, x):
            return
        super().doubt(r, x, what)

    def has_turned(self, pair, x):
        """The length is along one axis right before x, and along another one right after it."""
        before = self.precedes_by_signs(lambda query: self.world.sign_before(query, x))
        return self.form(pair, before) != self.form(pair, self.precedes(x))

    def names_both(self, r):
        """Of two lengths along one axis with an end in common only the other ends are named."""
        return set(self.query(r)[1]) <= set(r.ids)


class NearestInMaximumNorm(MaximumNorm, TwoColours):
    """The nearest two points of different classes, with the exchanges of two neighbours along x, y, x + y or x - y."""

    def meanings(self, name, ids):
        if name == "order_direction":
            return [(("order_direction", u), ids) for u in ClosestPairOfOrders.DIRECTIONS]
        return super().meanings(name, ids)

    def current(self, x):
        first, best = self.goes_first(x), None
        for pair in self.pairs():
            if best is None or first(pair, best):
                best = pair
        return [] if best is None else [best]

    def replaced(self, r, before, after):
        if r.kind == "replace":
            super().replaced(r, before, after)

    def event(self, r, x):
        """Of two lengths along one axis with an end in common only the other ends are named."""
        self.require_members(r, 2 if r.kind == "order" else 4)
        objects = set(r.ids)
        if r.kind == "order":
            self.require_order(r)
            return
        old, fresh = tuple(r.ids[:2]), tuple(r.ids[2:])
        self.require(old[0] < old[1] and fresh[0] < fresh[1], "%s: no two pairs", r.short())
        self.require({old, fresh} <= set(self.pairs()), "%s: not two pairs of two colours", r.short())
        if r.kind == "replace" and self.query(r) is not None:
            self.require(set(self.query(r)[1]) <= objects, "%s is not a failure of the two pairs", r.short())


class PolygonTree(MaximumNormTree):
    def vectors(self):
        return signed_units(corners_of(self.structure))

    def directions(self):
        return [("order_direction", u) for u in all_vectors(corners_of(self.structure))]

    def precedes_by_signs(self, sign):
        return precedes_along(lambda u, a, b: sign((("order_direction", u), (a, b))))

    def form(self, pair, precedes):
        corners = corners_of(self.structure)
        for cone, u in zip(counted(corners), units(corners)):
            (one, _), (other, _), _ = cones(corners)[cone]
            for p, q in (pair, pair[::-1]):
                if precedes(one, q, p) and precedes(other, q, p):
                    return (u, p, q)
        raise AssertionError("a point in no cone of another")


def signed_units(corners):
    """Those that lengths compare, and what a turn makes of them."""
    both = units(corners) + [turned(u) for u in units(corners)]
    return both + [opposite(u) for u in both]


def norm_length(p, q, i, j, vectors):
    """The length of the pair i < j at these positions, for comparisons: as it is, what an infinitesimal turn adds, and
    what a step by the numbers along (2, 1) adds."""
    x, y, step = q[0] - p[0], q[1] - p[1], j - i

    def size(parts):
        return max(parts, tuple(-v for v in parts))

    return max(size((u * x + v * y, v * x - u * y, (2 * u + v) * step)) for u, v in vectors)


def nearest_in_norm(pairs, positions, vectors=ALL[:2]):
    return [min(pairs, key=lambda e: (norm_length(positions[e[0]], positions[e[1]], *e, vectors), e))] if pairs else []


def norm_tree_of(positions, vectors=ALL[:2]):
    pairs = combinations(sorted(positions), 2)
    return spanning_tree(sorted(pairs, key=lambda e: (norm_length(positions[e[0]], positions[e[1]], *e, vectors), e)))


def norm_queries(members, pairs=None):
    """All equalities of two differences of coordinates of the pairs (all pairs), up to their signs; the octants."""
    pairs = list(combinations(sorted(members), 2)) if pairs is None else pairs
    for pair in pairs:
        yield ("order_x", pair)
        yield ("order_y", pair)
        for u in ((1, 1), (1, -1)):
            yield (("order_direction", u), pair)
    for (a, b), (c, d) in combinations(pairs, 2):
        for u in ALL[:2]:
            for v in ALL:
                query = extent_query(u, v, a, b, c, d)
                if query is not None:
                    yield query


MOST_MEMBERS = 9  # of a structure whose polynomials are examined
