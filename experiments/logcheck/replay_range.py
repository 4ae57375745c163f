# SPDX-License-Identifier: GPL-3.0-or-later
"""Trees for range search: range_tree_2, rank_kd_tree_2, pseudo_kd_tree_2, trajectory_tree.

range_tree_2: two orders, by x and by y; "swap_x" and "swap_y" exchange neighbours. The leaves of rank_kd_tree_2
are computed from the two orders as long as no object has come or gone, since labels depend on that. The leaves of
pseudo_kd_tree_2 depend on all that has happened: it is checked that its records fit each other. trajectory_tree is
its points, and has no events.
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
        order[i], order[i + 1] = b, a

    def settle(self, x):
        if self.look:
            self.look = False
            self.require(self.told == self.orders(x), "%s: right after %r the orders are others", self.label, x)

    def finish(self, end):
        super().finish(end)
        if end is not None:
            self.require(self.told == self.orders(end), "%s: right after the end the orders are others", self.label)


def spread(label):
    """The bits of a label, each followed by a zero."""
    return int("0".join(format(label, "b")) + "0", 2) if label else 0


class KdTree(Orders):
    """The order of the leaves as told; `computed`: what it must be, or None if that is not followed."""

    def __init__(self, checker, structure):
        super().__init__(checker, structure)
        self.is_first = True

    @property
    def attribute(self):
        return list(self.told) if self.told is not None else None

    def begin(self, x):
        self.told = self.computed(x) if self.is_first else None
        self.is_first, self.look = False, False
        if self.told is None:
            self.checker.note_partly(self.label, "leaves, which depend on what happened before")

    def record(self, r, x):
        self.look = True
        ids = self.world.scene.ids
        self.require(r.kind in ("settled", "rebuild"), "%s is no event of a kd-tree", r.short())
        if r.gone is None:
            return
        self.require(sorted(r.gone) == sorted(r.came) == sorted(ids[o] for o in self.members),
                     "%s: the leaves are not its points", r.short())
        self.require(self.told is None or r.gone == [ids[o] for o in self.told],
                     "%s: the leaves were others", r.short())
        self.told = [self.world.scene.number[name] for name in r.came]

    def settle(self, x):
        if self.look:
            self.look = False
            self.compare(x)

    def finish(self, end):
        super().finish(end)
        if end is not None:
            self.compare(end)

    def compare(self, x):
        fresh = self.computed(x) if not self.checker.partly.get(self.label) else None
        self.require(fresh is None or self.told == fresh, "%s: right after %r the leaves are others", self.label, x)


class RankKdTree(KdTree):
    def computed(self, x):
        """Labels spread evenly over the next power of two, and halved in x, y, x, .."""
        n = len(self.members)
        size = 1
        while size < n:
            size *= 2
        code = {}
        for axis, order in enumerate(self.orders(x)):
            for rank, o in enumerate(order):
                code[o] = code.get(o, 0) + (spread(rank * size // n) >> axis)
        return sorted(self.members, key=code.get)


class PseudoKdTree(KdTree):
    def computed(self, x):
        return None


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
