# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangulations as sets of cells: every event changes the cells as its ids say, and right after every instant that has
a record they are those of the definition."""

from log import Wrong
from replay_scratch import Scratch


class Cells(Scratch):
    SIZES = {}   # of each kind of flip, the numbers of points that it may name
    OTHERS = {}  # the same of events that change no cell

    def record(self, r, x):
        self.look = True
        if r.kind in self.OTHERS:
            self.require(len(set(r.ids)) == len(r.ids) in self.OTHERS[r.kind] and r.gone is None,
                         "%s: not the points of such an event", r.short())
            return
        if r.kind in self.SIZES:
            self.require(len(r.ids) in self.SIZES[r.kind], "%s: not the points of such an event", r.short())
            self.require_members(r, len(r.ids))
            query = self.query(r)
            self.require(query is not None and self.is_failure(query, r.kind, r.ids),
                         "%s is not a failure of its points", r.short())
            gone, came = self.change(r.kind, r.ids)
        elif r.gone is None:
            return
        else:
            number = {name: o for o, name in enumerate(self.world.scene.ids)}
            gone, came = ([tuple(number[name] for name in cell) for cell in side] for side in (r.gone, r.came))
        told = set(self.told)
        if not told.issuperset(gone) or not told.isdisjoint(came):
            raise Wrong("%s: a cell leaves that is not there, or joins that is" % r.short())
        self.told = sorted(told.difference(gone).union(came))

    def is_failure(self, query, kind, ids):
        return set(query[1]) == set(ids)
