# SPDX-License-Identifier: GPL-3.0-or-later
"""The Delaunay triangulation in space: every event changes the cells as its ids say, and right after every
instant that has a record they are those of the definition."""

from log import Wrong
from replay_scratch import Scratch
from space import cells, change


class DelaunayInSpace(Scratch):
    partly = "blocked flips at degenerate instants: which there are is not followed"
    FLIPS = {"flip_2_3": 5, "flip_3_2": 5, "enter": 4, "leave": 4, "hull_2_3": 4, "hull_3_2": 4}

    def current(self, x):
        def sign(name):
            return lambda *ids: self.world.sign_after((name, ids), x)

        def identical(a, b):
            return not any(self.world.sign_after(("order_" + axis, (a, b)), x) for axis in "xyz")

        return cells(self.members, sign("orientation_3"), sign("in_sphere_3"), identical)

    def record(self, r, x):
        self.look = True
        if r.kind == "blocked":
            self.require(len(set(r.ids)) == len(r.ids) and r.gone is None, "%s: five points or four", r.short())
            return
        if r.kind in self.FLIPS:
            self.require_members(r, self.FLIPS[r.kind])
            query = self.query(r)
            self.require(query is not None and set(query[1]) == set(r.ids), "%s is not a failure of its points",
                         r.short())
            gone, came = change(r.kind, r.ids)
        elif r.gone is None:
            return
        else:
            number = {name: o for o, name in enumerate(self.world.scene.ids)}
            gone, came = ([tuple(number[name] for name in cell) for cell in side] for side in (r.gone, r.came))
        told = set(self.told)
        if not told.issuperset(gone) or not told.isdisjoint(came):
            raise Wrong("%s: a cell leaves that is not there, or joins that is" % r.short())
        self.told = sorted(told.difference(gone).union(came))
