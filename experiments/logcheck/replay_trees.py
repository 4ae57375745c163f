# SPDX-License-Identifier: GPL-3.0-or-later
"""Minimum spanning trees, from scratch right after every instant that may change them: of points, and of graphs."""

from functools import cmp_to_key
from itertools import combinations

from predicates import axis_order, distance_query
from replay_scratch import Scratch
from static import forest_edges, spanning_tree


class SpanningTree(Scratch):
    """The Euclidean minimum spanning tree; of equal lengths the smaller pair is the shorter one.

    When an instant is over there is one event "swap" for each edge that is gone, with one that came: the first with the
    first, and so on; or, if they are not equally many, one event "settled"."""

    claim = staticmethod(distance_query)
    width = 2  # of edges, as tuples of objects
    partly = "internal events: which certificates there are is not followed"

    def edges(self):
        return combinations(sorted(self.members), 2)

    def begin(self, x):
        super().begin(x)
        self.swaps = []

    def in_order(self, x):
        def order(one, other):
            return -self.world.sign_after(self.claim(one, other), x) or (-1 if one < other else 1)

        return sorted(self.edges(), key=cmp_to_key(order))

    def current(self, x):
        return spanning_tree(self.in_order(x))

    def tied(self, old, fresh, x):
        return self.world.is_zero(self.claim(old, fresh))

    def names_both(self, r):
        return set(self.query(r)[1]) == set(r.ids)

    def doubt(self, r, x, what):
        """Within an instant at which the triangulation changes it passes through graphs whose trees are no shortest
        ones at any time: edges that it has only then are shorter than those of the tree."""
        read = [one for one in self.checker.replays if one is not None and one.structure.name.startswith("delaunay_")]
        own = [one for one in read if one.label.startswith(self.label + ".")]
        changed = any(one in self.checker.touched.values() for one in own or read)
        self.require(changed and not r.external, what.replace("%", "%%"))

    def record(self, r, x):
        self.look = True
        old = fresh = None
        if r.kind not in ("settled", "rebuild"):
            self.require_members(r, 2 * self.width)
            old, fresh = tuple(r.ids[:self.width]), tuple(r.ids[self.width:])
            self.require(old == tuple(sorted(old)) and fresh == tuple(sorted(fresh)) and old != fresh,
                         "%s: no two edges", r.short())
            if r.kind == "tie":
                self.require(self.tied(old, fresh, x), "%s: the lengths are not identically equal", r.short())
            elif self.query(r) is not None and not r.external:
                self.require(self.names_both(r), "%s is not a failure of the two edges", r.short())
        if not r.external:
            self.require(r.gone is None, "%s says nothing of the attribute", r.short())
            self.require(not self.swaps, "%s: a failure after the changes that it leads to", r.short())
            return
        if r.kind == "swap":
            sides = [[[self.world.scene.ids[o] for o in edge]] for edge in (old, fresh)]
            self.require([r.gone, r.came] == sides, "%s: the tree changes from %s to %s", r.short(), *sides)
            self.swaps.append((old, fresh))
            return
        self.require(r.kind in ("settled", "rebuild"), "%s changes the tree", r.short())
        now = self.current(x)
        self.check_difference(r, self.told, now)
        self.require(r.kind == "rebuild" or len(now) != len(self.told), "%s: every edge that is gone has a swap",
                     r.short())
        self.require_due(x)
        self.told = now

    def settle(self, x):
        if not self.look:
            return
        self.look = False
        now = self.current(x)
        gone, came = sorted(set(self.told) - set(now)), sorted(set(now) - set(self.told))
        self.require(len(gone) == len(came) and self.swaps == list(zip(gone, came)),
                     "%s: right after %r the tree is another one: the swaps are %s; it loses %s and gains %s",
                     self.label, x, self.swaps, gone, came)
        if gone:
            self.require_due(x)
        self.told, self.swaps = now, []


class GraphTree(SpanningTree):
    """The minimum spanning forest of a graph whose edges are the objects; of equal weights the smaller object is the
    lighter one."""

    width = 1

    @staticmethod
    def claim(one, other):
        return (axis_order(0), (one[0], other[0]))

    def edges(self):
        return [(o,) for o in sorted(self.members)]

    def current(self, x):
        return sorted((o,) for o in forest_edges([o for (o,) in self.in_order(x)], self.world.scene))
