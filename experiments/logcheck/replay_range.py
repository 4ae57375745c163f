# SPDX-License-Identifier: GPL-3.0-or-later
"""Trees for range search: range_tree_2, trajectory_tree; kd-trees are in replay_kd.py.

range_tree_2: two orders, by x and by y; "swap_x" and "swap_y" exchange neighbours. trajectory_tree is its points, and
has no events.
"""

from predicates import Key
from proof import Proof
from replay_members import OfMembers
from static import sorted_by


class Orders(OfMembers):
    bound = []

    def __init__(self, checker, structure):
        super().__init__(checker, structure)
        self.keys = [Key(("axis", 0)), Key(("axis", 1))]
        self.proofs = [Proof(self.world, self.label, checker.on[4])]  # without claims

    def orders(self, x):
        return [sorted_by(self.world, key, self.members, x) for key in self.keys]


class RangeTree(Orders):
    @property
    def attribute(self):
        return self.told[0] + self.told[1]

    def begin(self, x):
        self.told, self.look = self.orders(x), False

    def record(self, r, x):
        self.look = True
        if r.kind in ("settled", "rebuild"):
            fresh = self.orders(x)
            self.checker.check_change(self, r, self.attribute, fresh[0] + fresh[1])
            self.told = fresh
            return
        self.require_members(r, 2)
        order, (a, b) = self.told[r.kind == "swap_y"], r.ids
        i = order.index(a)
        self.require(i + 1 < len(order) and order[i + 1] == b, "%s: the second does not follow the first", r.short())
        self.require(r.external and r.gone is None, "%s is external and says all by its ids", r.short())
        self.require(self.world.vanishes(self.keys[r.kind == "swap_y"].claim(a, b), x), "%s: the two do not meet",
                     r.short())
        order[i], order[i + 1] = b, a

    def settle(self, x):
        if self.look:
            self.look = False
            self.require(self.told == self.orders(x), "%s: right after %r the orders are others", self.label, x)

    def finish(self, end):
        super().finish(end)
        if end is not None:
            self.require(self.told == self.orders(end), "%s: right after the end the orders are others", self.label)


class TrajectoryTree(Orders):
    """Its points, ascending: nothing happens to them."""

    @property
    def attribute(self):
        return sorted(self.members)

    def begin(self, x):
        pass

    def record(self, r, x):
        self.require(r.kind == "rebuild" and r.gone is None and not r.external, "%s: the trajectories are static", r.short())

    def settle(self, x):
        pass
