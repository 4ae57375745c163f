# SPDX-License-Identifier: GPL-3.0-or-later
"""The box on a hull, the farthest-point Delaunay triangulation, and the smallest circle: computed from scratch
by signs, right after every instant that has a record."""

from itertools import combinations

from predicates import axis_order
from replay_scratch import OnHull, Scratch
from static import hull


class OfHull(OnHull, Scratch):
    """Of strict vertices of the hull."""

    def cycle(self, x):
        return hull(self.world, self.members, x)

    def sign(self, name, *ids):
        return self.world.sign_after((name, ids), self.now)

    def current(self, x):
        self.now = x
        return self.value(x)

    def event(self, r, x):
        self.require(len(set(r.ids)) == len(r.ids), "%s: a point is named twice", r.short())


class BoxOfHull(OfHull):
    """The extreme vertices; equal coordinates: the smallest number."""

    def value(self, x):
        box = []
        for axis in range(2):
            least = most = None
            for o in sorted(self.cycle(x)):
                if least is None or self.sign(axis_order(axis), o, least) > 0:
                    least = o
                if most is None or self.sign(axis_order(axis), most, o) > 0:
                    most = o
            box += [] if least is None else [least, most]
        return box

    def event(self, r, x):
        super().event(r, x)
        self.require_members(r, 2)
        if self.query(r) is not None:
            self.require(r.ids[0] in self.query(r)[1], "%s is not a failure of the first", r.short())

    def replaced(self, r, before, after):
        """From one vertex to the next: a side of the box goes along."""
        self.require(tuple(r.ids) in zip(before, after), "%s: no side changes from the first to the second", r.short())


class FarthestDelaunay(OfHull):
    """The edges; vertices on one circle: the fan of the smallest number."""

    def value(self, x):
        cycle = self.cycle(x)
        edges = {(min(e), max(e)) for e in zip(cycle, cycle[1:] + cycle[:1]) if e[0] != e[1]}
        for a, b, c in combinations(cycle, 3):
            signs = {d: self.sign("in_circle_2", a, b, c, d) for d in cycle if d not in (a, b, c)}
            if any(s < 0 for s in signs.values()):
                continue
            circle = {a, b, c} | {d for d, s in signs.items() if s == 0}
            polygon = [o for o in cycle if o in circle]
            edges.update((min(e), max(e)) for e in zip(polygon, polygon[1:] + polygon[:1]))
            edges.update((min(polygon), o) for o in polygon if o != min(polygon))
        return sorted(edges)

    def check(self, r, before, after):
        ids = self.world.scene.ids
        gone, came = ([e for e in one if e not in other] for one, other in ((before, after), (after, before)))
        if r.kind == "flip":
            self.require([tuple(r.ids[:2])] == gone and [tuple(r.ids[2:])] == came,
                         "%s: the edges that go and come are %s and %s", r.short(), gone, came)
        elif before == after:
            self.require(r.gone is None, "%s: nothing has changed", r.short())
        else:
            named = [[[ids[a], ids[b]] for a, b in side] for side in (gone, came)]
            self.require([r.gone, r.came] == named, "%s: what goes and comes is %s and %s", r.short(), *named)


class MinCircle(OfHull):
    """All vertices on the circle: that of two or three vertices which holds all."""

    def event(self, r, x):
        """An external one names two or three points, ascending, that determine the circle."""
        super().event(r, x)
        if not r.external or r.kind in ("settled", "rebuild") or not r.ids:
            return
        self.now, ids = x, tuple(r.ids)
        self.require(list(ids) == sorted(ids) and all(i in self.members for i in ids),
                     "%s: the points are not in order", r.short())
        self.require(len(ids) == {"to_two": 2, "to_three": 3}.get(r.kind), "%s: so many points", r.short())
        others = [p for p in self.cycle(x) if p not in ids]
        if len(ids) == 2:
            holds = all(self.sign("obtuse_angle_2", ids[0], p, ids[1]) >= 0 for p in others)
        else:
            a, b, c = ids if self.sign("orientation_2", *ids) > 0 else (ids[0], ids[2], ids[1])
            holds = (min(self.sign("acute_angle_2", *t) for t in ((a, b, c), (b, c, a), (c, a, b))) >= 0
                     and all(self.sign("in_circle_2", a, b, c, p) >= 0 for p in others))
        self.require(holds, "%s: these do not determine the circle", r.short())

    def value(self, x):
        cycle = self.cycle(x)
        if len(cycle) < 3:
            return sorted(cycle)
        for a, b in combinations(sorted(cycle), 2):
            signs = {p: self.sign("obtuse_angle_2", a, p, b) for p in cycle if p not in (a, b)}
            if all(s >= 0 for s in signs.values()):
                return sorted([a, b] + [p for p, s in signs.items() if s == 0])
        for a, b, c in combinations(cycle, 3):
            if min(self.sign("acute_angle_2", *t) for t in ((a, b, c), (b, c, a), (c, a, b))) < 0:
                continue
            signs = {p: self.sign("in_circle_2", a, b, c, p) for p in cycle if p not in (a, b, c)}
            if all(s >= 0 for s in signs.values()):
                return sorted([a, b, c] + [p for p, s in signs.items() if s == 0])
        raise AssertionError("a hull without a smallest circle")
