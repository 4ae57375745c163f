# SPDX-License-Identifier: GPL-3.0-or-later
"""calipers_2, width_2 and the smallest rectangles, from scratch: of every edge of the hull the vertices that
calipers flush with it touch, and the best of these. Their own events are checked at level 2 only."""

from fractions import Fraction

from parameters import value_of
from replay_scratch import OnHull, Scratch
from static import hull


def folds_of(structure):
    return int(value_of(structure.name, structure.options, "folds", lambda v: Fraction(str(v))))


class Flush(OnHull, Scratch):
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

    # Kinds of events, with their numbers of points, without a certificate and internal; all others fail a certificate.
    PLAIN = {"split": 3, "merge": 3, "renew": 0, "motion": 1, "insert": 1, "erase": 1}

    def event(self, r, x):
        """The proof is not followed: only what a record says of itself."""
        if r.kind in self.PLAIN:
            self.require(r.predicate is None and not r.external and len(r.ids) == self.PLAIN[r.kind],
                         "%s is internal, without a certificate", r.short())
            return
        self.require(r.predicate is not None and len(r.ids) == 4, "%s names two edges and what has failed", r.short())
        name, ids = r.predicate, r.arguments
        places = [int(digit) for digit in name.partition("/")[2]] or list(range(len(ids)))
        if r.kind == "replace":
            half = len(places) // 2
            edges = [ids[i] for i in places[:2] + places[half:half + 2]]
            self.require(list(r.ids) == edges, "%s names other edges than its certificate", r.short())
        elif r.kind == "tie":
            # A winner that goes up the tournament may be level there with an edge that the certificate does not know.
            edges = r.ids[:2], r.ids[2:]
            self.require(set(r.ids) <= set(self.members) and edges[0] != edges[1] and all(a != b for a, b in edges),
                         "%s does not name two edges", r.short())
        else:
            self.require(set(r.ids) == set(ids), "%s names other points than its certificate", r.short())


class Width(Flush):
    order = "order_strip"

    def contacts(self, a, b, points, x):
        return (self.farthest("slope_order_2", a, b, points, x),)


class Rectangle(Flush):
    def contacts(self, a, b, points, x):
        return (self.farthest("edge_dot_2", a, b, points, x), self.farthest("slope_order_2", a, b, points, x),
                self.farthest("edge_dot_2", b, a, points, x))


class Area(Rectangle):
    order = "order_rectangle_area"


class Perimeter(Rectangle):
    order = "order_rectangle_perimeter"


class Calipers(OnHull, Scratch):
    """What calipers touch right after the direction of each edge: its head, and in each other fold the extreme
    vertex; of the two ends of an edge that is identically tangent the head, if its tail is the smaller one."""

    def current(self, x):
        folds = folds_of(self.structure)
        cycle = hull(self.world, self.members, x)
        if len(cycle) < 2:
            return []
        if len(cycle) == 2:
            return [tuple(sorted(cycle * (folds // 2)))]
        following = dict(zip(cycle, cycle[1:] + cycle[:1]))
        touched = []
        for a, b in following.items():
            contacts = [b, self.contact("slope_order_2", a, b, a, following, x)]
            if folds == 4:
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
        """The proof is not followed."""
