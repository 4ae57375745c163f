# SPDX-License-Identifier: GPL-3.0-or-later
"""The structures that look along 4k directions, from scratch right after every instant that has a record:
directions_2, its sibling by tournaments, diameter_directions, also in space, and width_directions.

Internal events are claims about one direction or two that fail at the instant. What is extreme along each direction
is followed in extremes.py.
"""

from fractions import Fraction
from functools import lru_cache
from itertools import combinations

from extremes import Extremes, extreme
from log import Wrong
from parameters import value_of
from replay_hull import Hull
from replay_scratch import Scratch
from static import hull

NEARLY = 1e-9  # of the largest coordinate


@lru_cache(maxsize=None)
def half_directions(k, dimension=2):
    """One of each pair of opposite directions."""
    if dimension == 3:
        return half_directions_3(k)
    first = []
    for i in range(k):
        q = Fraction(i, k)
        first.append(((1 - q * q) / (1 + q * q), 2 * q / (1 + q * q)))
    return first + [(-y, x) for x, y in first]


def half_directions_3(k):
    """Stereographic projections of grids in the three axes' directions, z first."""
    k = min(k, 6)
    r = round((2 ** 0.5 - 1) * k)  # nowhere near a half
    found = []
    for last in (2, 1, 0):
        for i in range(-r, r + 1):
            for j in range(-r, r + 1):
                a, b = Fraction(i, k), Fraction(j, k)
                u = [None] * 3
                u[(last + 1) % 3], u[(last + 2) % 3], u[last] = (x / (1 + a * a + b * b)
                                                                 for x in (2 * a, 2 * b, 1 - a * a - b * b))
                if tuple(u) not in found and opposite(u) not in found:
                    found.append(tuple(u))
    return found


def opposite(u):
    return tuple(-x for x in u)


@lru_cache(maxsize=None)
def all_directions(k, dimension=2):
    half = half_directions(k, dimension)
    return half + [opposite(u) for u in half]


def k_of(structure):
    return int(value_of(structure.name, structure.options, "k", lambda x: Fraction(str(x))))


def extent_query(u, v, a, b, c, d):
    """u.(a - b) - v.(c - d) as a query, or None if it is zero for all motions."""
    weights = {}
    for o, w in ((a, u), (b, opposite(u)), (c, opposite(v)), (d, v)):
        before = weights.get(o, (0,) * len(u))
        weights[o] = tuple(x + y for x, y in zip(before, w))
    weights = {o: w for o, w in weights.items() if any(w)}
    if not weights:
        return None
    return (("order_extent", tuple(weights.values())), tuple(weights))


class Along:
    """The predicates that a certificate of the log can mean: one for each direction, or two of them."""

    PLACES = {2: ((0, 1, 0, 1), (0, 1, 1, 0)),
              3: ((0, 1, 0, 2), (0, 1, 2, 0), (0, 1, 1, 2), (0, 1, 2, 1)), 4: ((0, 1, 2, 3),)}

    NAMES = {4: "order_extent", 3: "order_extent_3", 2: "order_extent_2"}

    def meanings(self, name, ids):
        k, dimension = k_of(self.structure), self.world.scene.dimension
        if name == "order_direction" and len(ids) == 2:
            for u in all_directions(k, dimension):
                yield (("order_direction", u), ids)
        if name == self.NAMES.get(len(ids)):
            for u, v in combinations(half_directions(k, dimension), 2):
                for places in self.PLACES[len(ids)]:
                    yield extent_query(u, v, *(ids[i] for i in places))
                    yield extent_query(opposite(u), opposite(v), *(ids[i] for i in places))


    def likely(self, name, ids, x):
        """Those of the meanings that are nearly zero at x, as far as doubles tell: none, or some of them, or others."""
        if name != self.NAMES.get(len(ids)):
            return
        half = half_directions(k_of(self.structure), self.world.scene.dimension)
        try:
            points = [self.world.approximate_position(i, x) for i in ids]
            near = max(abs(c) for point in points for c in point) * NEARLY
        except OverflowError:
            return
        floats = [tuple(map(float, u)) for u in half]
        along = [[sum(w * c for w, c in zip(u, point)) for point in points] for u in floats]
        for (i, first), (j, second) in combinations(enumerate(along), 2):
            for places in self.PLACES[len(ids)]:
                a, b, c, d = places
                if abs(first[a] - first[b] - second[c] + second[d]) <= near:
                    four = [ids[place] for place in places]
                    yield extent_query(half[i], half[j], *four)
                    yield extent_query(opposite(half[i]), opposite(half[j]), *four)


class LooksAlong(Along):
    """What is extreme along each direction is followed."""

    def directions(self):
        return all_directions(k_of(self.structure), self.world.scene.dimension)

    def by_tournaments(self):
        return self.world.scene.degree() > 1

    def begin(self, x):
        self.extremes = Extremes(self, self.directions(), self.by_tournaments(), x)
        super().begin(x)

    def settle(self, x):
        super().settle(x)
        self.extremes.settle(x)

    def finish(self, end):
        super().finish(end)
        if end is not None:
            self.extremes.settle(end)


class Directions(LooksAlong, Hull):
    partial_hull = True
    bound = ["order_direction"]

    def start(self, x):
        if self.by_tournaments():
            self.checker.note_partly(self.label, "internal events: the duels of its tournaments are not followed")
        super().start(x)

    def claims(self, x):
        """None of a hull."""

    def current(self, x):
        if not self.members:
            return []
        return hull(self.world, {extreme(self.world, self.members, u, x) for u in self.directions()}, x)

    def internal(self, r, x):
        self.require_members(r, 2)
        self.extremes.record(r, x)

    def record(self, r, x):
        self.look = True
        super().record(r, x)
        if r.kind == "rebuild":
            self.extremes.begin(x)

    def finish(self, end):
        super().finish(end)
        if end is not None:
            self.require(self.cycle == self.current(end), "%s: right after the end the polygon is another one",
                         self.label)


class DirectionsByTournaments(Directions):
    def by_tournaments(self):
        return True


class Extent(LooksAlong, Scratch):
    bound = ["order_direction", "order_extent", "order_extent_3", "order_extent_2"]
    partly = "internal events: the duels of its tournaments are not followed"

    def larger(self, u, a, v, b, x):
        query = extent_query(u, v, *a, *b)
        return 0 if query is None else self.world.sign_after(query, x)

    def ends(self, u, x):
        return (extreme(self.world, self.members, u, x), extreme(self.world, self.members, opposite(u), x))

    def current(self, x):
        best = None
        sign = -1 if self.structure.name == "width_directions" else 1
        for u in half_directions(k_of(self.structure), self.world.scene.dimension) if self.members else []:
            ends = self.ends(u, x)
            if best is None or sign * self.larger(u, ends, *best, x) > 0:
                best = (u, ends)
        return [] if best is None or best[1][0] == best[1][1] else [tuple(sorted(best[1]))]

    def check(self, r, before, after):
        ids = self.world.scene.ids
        sides = [[[ids[a], ids[b]] for a, b in side] for side in (before, after)]
        if before == after:
            self.require(r.gone is None, "%s: nothing has changed", r.short())
        else:
            self.require([r.gone, r.came] == sides, "%s: the pair was %s and is %s", r.short(), *sides)

    def record(self, r, x):
        super().record(r, x)
        if r.kind == "rebuild":
            self.extremes.begin(x)

    def event(self, r, x):
        if r.kind == "replace" or (r.kind == "tie" and len(r.ids) == 2):
            self.require_members(r, 2)
            self.extremes.record(r, x)
        else:
            self.duel(r, x)

    def duel(self, r, x):
        """The four ends of two extents, the first of which was ahead until now."""
        self.require_members(r, 4)
        half = half_directions(k_of(self.structure), self.world.scene.dimension)
        first, second = ([i for i, u in enumerate(half) if self.are_ends(u, pair, x)] for pair in (r.ids[:2], r.ids[2:]))
        query, is_width = self.query(r), self.structure.name == "width_directions"
        for i in first:
            for j in second:
                if i == j:
                    continue
                was, now = (half[i], *r.ids[:2]), (half[j], *r.ids[2:])
                larger, smaller = (now, was) if is_width else (was, now)
                claim = extent_query(larger[0], smaller[0], *larger[1:], *smaller[1:])
                if r.kind == "tie":
                    if j < i and (claim is None or self.world.is_zero(claim)):
                        return
                elif claim is not None and self.fails(claim, x) and (query is None or set(query[1]) == set(r.ids)):
                    return
        raise Wrong("%s: no two extents of these ends change their order" % r.short())

    def are_ends(self, u, ends, x):
        return all(self.extremes.may_be(v, o, x) for v, o in zip((u, opposite(u)), ends))
