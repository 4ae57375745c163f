# SPDX-License-Identifier: GPL-3.0-or-later
"""Sets of pairs: those of the boxes, or discs, that meet."""

from itertools import combinations

from replay_scratch import Scratch


def boxes_meet(world, pair, x):
    return all(world.sign_after(("meeting_" + "xyz"[axis], ends), x) >= 0
               for axis in range(world.scene.dimension) for ends in (pair, pair[::-1]))


def discs_meet(world, pair, x):
    return world.sign_after(("disc_overlap", pair), x) >= 0


class BoxesThatMeet(Scratch):
    """The pairs of boxes that meet, identical touches included. When the instant is over, one event for each pair that
    it changes: "part" for those that are gone, then "meet" for those that came, in ascending order."""

    partly = "internal events: the lists of ends are not followed"
    KINDS = ("meet", "part")
    meet = staticmethod(boxes_meet)

    def begin(self, x):
        super().begin(x)
        self.events = []

    def current(self, x):
        return [pair for pair in combinations(sorted(self.members), 2) if self.meet(self.world, pair, x)]

    def record(self, r, x):
        self.look = True
        if r.kind in self.KINDS:
            self.require_members(r, 2)
            self.require(r.external and r.ids[0] < r.ids[1], "%s: no pair that changes", r.short())
            pair = [[[self.world.scene.ids[o] for o in r.ids]], []]
            self.require([r.came, r.gone] == (pair if r.kind == self.KINDS[0] else pair[::-1]),
                         "%s: another pair changes than its own", r.short())
            self.events.append((r.kind, tuple(r.ids)))
        elif r.kind == "rebuild":
            fresh = self.current(x)
            self.check_difference(r, self.told, fresh)
            self.told = fresh
        else:
            self.require(not r.external and r.gone is None, "%s says nothing of the attribute", r.short())
            self.inside(r)

    def inside(self, r):
        self.require_members(r, len(r.ids))
        self.require(not self.events, "%s: a failure after the changes that it leads to", r.short())
        if self.query(r) is not None and r.kind != "tie":
            self.require(set(self.query(r)[1]) == set(r.ids), "%s is not a failure of its objects", r.short())

    def settle(self, x):
        if not self.look:
            return
        self.look = False
        fresh = self.current(x)
        due = [(self.KINDS[1], pair) for pair in sorted(set(self.told) - set(fresh))]
        due += [(self.KINDS[0], pair) for pair in sorted(set(fresh) - set(self.told))]
        self.require(self.events == due, "%s: at %r there are %s, not %s", self.label, x, self.events, due)
        if due:
            self.require_due(x)
        self.told, self.events = fresh, []


class DiscsThatMeet(BoxesThatMeet):
    meet = staticmethod(discs_meet)
