# SPDX-License-Identifier: GPL-3.0-or-later
"""calipers_2, diameter_2, width_2 and the smallest rectangles, from scratch: of every edge of the hull the vertices
that calipers flush with it touch, and the best of these. Which of their internal events there are is not followed."""

from fractions import Fraction

from parameters import value_of
from replay_scratch import FarthestPair, OnHull, Scratch
from static import hull


def folds_of(structure):
    return int(value_of(structure.name, structure.options, "folds", lambda v: Fraction(str(v))))


def edges_of(cycle):
    return set(zip(cycle, cycle[1:] + cycle[:1]))


class OnCalipers(OnHull):
    """Replays of what has calipers on a hull: their events, as far as the hull tells them."""

    folds = 2
    cycle = ()  # the hull right before the present instant, or right after the last object that came or went
    # Kinds of events by which calipers follow the hull, with their numbers of points.
    FOLLOWING = {"split": 3, "merge": 3, "renew": 0}

    def begin(self, x):
        self.cycle = hull(self.world, self.members, x)
        super().begin(x)

    def settle(self, x):
        if self.look:
            self.cycle = hull(self.world, self.members, x)
        super().settle(x)

    def is_of_calipers(self, r, x):
        """False: it is an event of something else."""
        if r.kind in self.FOLLOWING:
            self.require(r.predicate is None and not r.external and len(r.ids) == self.FOLLOWING[r.kind],
                         "%s is internal, without a certificate", r.short())
            if r.ids:
                self.follow(r, x)
        elif r.kind in ("antiparallel", "perpendicular"):
            self.exchange(r, x)
        else:
            return False
        return True

    def follow(self, r, x):
        """A vertex has come between two others, or has gone, before anything else happens to the hull then."""
        vertex, left, right = r.ids
        before, after = self.cycle, hull(self.world, self.members, x)
        with_it, without_it = (before, after) if r.kind == "merge" else (after, before)
        self.require(vertex in with_it and vertex not in without_it, "%s: the hull has no such change", r.short())
        around = [o for o in with_it if o in before or o == vertex]
        self.require({(left, vertex), (vertex, right)} <= edges_of(around), "%s: it is not between the two", r.short())

    def exchange(self, r, x):
        """Two edges, each by its ends, the first of which was in front until their certificate has failed."""
        self.require(self.query(r) is not None and len(r.ids) == 4, "%s names two edges and what has failed", r.short())
        self.require(r.kind == "antiparallel" or self.folds == 4, "%s: these calipers are parallel", r.short())
        after = hull(self.world, self.members, x)
        edges = edges_of(self.cycle) | edges_of(after)
        self.require(r.ids[:2] in edges and r.ids[2:] in edges, "%s does not name two edges of the hull", r.short())
        name, _, places = r.predicate.partition("/")
        ids = tuple(r.arguments[int(i)] for i in places) if places else r.arguments
        self.require((name, ids) in self.claims(r, after, x), "%s: its certificate is not that of these two edges",
                     r.short())

    def claims(self, r, after, x):
        """The ways to say that the first edge, turned until the two are nearly parallel, is not after the second."""
        if r.kind == "antiparallel":
            return self.opposite(*r.ids)
        if self.cycle != after:  # where a side has taken the place of another one, the list may say either
            return self.upright(*r.ids, (1, -1))
        left = "slope_order_2", r.ids
        return self.upright(*r.ids, {self.world.sign_before(left, x), self.world.sign_after(left, x)})

    @staticmethod
    def opposite(a, b, c, d):
        """From a to b, half a turn, and from c to d."""
        if b == c:
            return [("orientation_2", (c, a, d))]
        if d == a:
            return [("orientation_2", (c, a, b))]
        return [("slope_order_2", (c, d, a, b)), ("slope_order_2", (b, a, c, d))]

    @staticmethod
    def upright(a, b, c, d, signs):
        """The same, a quarter of a turn where the sign is positive: the second edge is to the left; else three."""
        claims = []
        for sign in signs:
            claims += [(b, a, c, d), (d, c, a, b)] if sign > 0 else [(a, b, c, d), (c, d, a, b)]
        return [("edge_dot_2", ids) for ids in claims]


class Flush(OnCalipers, Scratch):
    order = ""  # "the first is at most as large", of two candidates

    def current(self, x):
        cycle = hull(self.world, self.members, x)
        best = None
        if len(cycle) < 3:
            return []
        for i in sorted(range(len(cycle)), key=lambda i: cycle[i]):
            a, b = cycle[i], cycle[(i + 1) % len(cycle)]
            candidate = (a, b) + self.contacts(a, b, sorted(cycle), x)
            if best is None or self.world.sign_after((self.order, candidate + best), x) > 0:
                best = candidate
        return list(best)

    def farthest(self, predicate, a, b, points, x):
        """In the direction from a to b, or to its left; of equally far ones the smallest number."""
        best = points[0]
        for p in points[1:]:
            if self.world.sign_after((predicate, (a, b, best, p)), x) > 0:
                best = p
        return best

    def event(self, r, x):
        """Duels of edges: only what a record says of itself."""
        if self.is_of_calipers(r, x):
            return
        if r.kind == "replace":
            self.require(self.query(r) is not None, "%s has no certificate", r.short())
            places = [int(digit) for digit in r.predicate.partition("/")[2]] or list(range(len(r.arguments)))
            half = len(places) // 2
            edges = [r.arguments[i] for i in places[:2] + places[half:half + 2]]
            self.require(list(r.ids) == edges, "%s names other edges than its certificate", r.short())
        else:
            self.tie(r)

    def tie(self, r):
        """A winner that goes up the tournament may be level there with an edge that the certificate does not know.
        There is none where a new flight plan or a change of the hull makes the two level."""
        edges = r.ids[:2], r.ids[2:]
        self.require(not r.external and len(r.ids) == 4, "%s is internal and names two edges", r.short())
        self.require(set(r.ids) <= set(self.members) and edges[0] != edges[1] and all(a != b for a, b in edges),
                     "%s does not name two edges", r.short())

    def replaced(self, r, before, after):
        self.require(list(r.ids) == before[:2] + after[:2], "%s: the edge changes from %s to %s", r.short(),
                     self.names(before[:2]), self.names(after[:2]))


class Width(Flush):
    order = "order_strip"

    def contacts(self, a, b, points, x):
        return (self.farthest("slope_order_2", a, b, points, x),)


class Rectangle(Flush):
    folds = 4

    def contacts(self, a, b, points, x):
        return (self.farthest("edge_dot_2", a, b, points, x), self.farthest("slope_order_2", a, b, points, x),
                self.farthest("edge_dot_2", b, a, points, x))


class Area(Rectangle):
    order = "order_rectangle_area"


class Perimeter(Rectangle):
    order = "order_rectangle_perimeter"


class FarthestPairOfHull(OnCalipers, FarthestPair):
    def event(self, r, x):
        if not self.is_of_calipers(r, x):
            super().event(r, x)


class Calipers(OnCalipers, Scratch):
    """What calipers touch right after the direction of each edge: its head, and in each other fold the extreme
    vertex; of the two ends of an edge that is identically tangent the head, if its tail is the smaller one."""

    def __init__(self, checker, structure):
        self.folds = folds_of(structure)
        super().__init__(checker, structure)

    def current(self, x):
        cycle = hull(self.world, self.members, x)
        if len(cycle) < 2:
            return []
        if len(cycle) == 2:
            return [tuple(sorted(cycle * (self.folds // 2)))]
        following = dict(zip(cycle, cycle[1:] + cycle[:1]))
        touched = []
        for a, b in following.items():
            contacts = [b, self.contact("slope_order_2", a, b, a, following, x)]
            if self.folds == 4:
                contacts += [self.contact("edge_dot_2", *edge, a, following, x) for edge in ((a, b), (b, a))]
            touched.append(tuple(sorted(contacts)))
        return sorted(touched)

    def contact(self, predicate, a, b, edge, following, x):
        """The vertex farthest in the direction from a to b, or to its left, when calipers have passed `edge`."""
        best = []
        for p in following:
            sign = self.world.sign_after((predicate, (a, b, best[0], p)), x) if best else 1
            if sign >= 0:
                best = [p] if sign > 0 else best + [p]
        if len(best) == 1:
            return best[0]
        tail = best[0] if following[best[0]] == best[1] else best[1]
        return following[tail] if tail < edge else tail

    def check(self, r, before, after):
        ids = self.world.scene.ids
        gone, came = ([e for e in one if e not in other] for one, other in ((before, after), (after, before)))
        if before == after:
            self.require(r.gone is None, "%s: nothing has changed", r.short())
        else:
            named = [[[ids[o] for o in e] for e in side] for side in (gone, came)]
            self.require([r.gone, r.came] == named, "%s: what goes and comes is %s and %s", r.short(), *named)

    def event(self, r, x):
        self.require(self.is_of_calipers(r, x), "%s is no event of calipers", r.short())
