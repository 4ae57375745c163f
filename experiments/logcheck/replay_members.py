# SPDX-License-Identifier: GPL-3.0-or-later
"""What replays have in common whose attribute is made anew whenever an object comes or goes."""

from replay import Replay


class OfMembers(Replay):
    """Subclasses have begin(x): the attribute of the present members, right after x."""

    look = False  # is there anything to be settled at the present instant?

    def everyone(self):
        """The objects that it is about."""
        return self.alive()

    def start(self, x):
        self.members = self.everyone()
        self.begin(x)

    def begin(self, x):
        raise NotImplementedError

    def insert(self, o, x):
        self.members.add(o)
        self.begin(x)

    def erase(self, o, x):
        self.members.discard(o)
        self.begin(x)

    def after_motion(self, objects, x):
        super().after_motion(objects, x)
        self.look = True


class OfPlans(OfMembers):
    """Replays that ask when a new flight plan has come."""

    moved_at = None  # the last instant with one

    def after_motion(self, objects, x):
        super().after_motion(objects, x)
        self.moved_at = x


class WithTies(OfPlans):
    """Replays whose claims about ties are made when another claim becomes identically zero."""

    TIES = {}  # their predicates, and the one that is identically zero of the same objects

    def doubt(self, r, x, what):
        """Where a new flight plan has made the other claim zero, that of the tie may be negative since long."""
        predicate, ids = self.checker.query(r)
        zero = self.TIES.get(predicate)
        known = zero is not None and self.moved_at is x and self.world.is_zero((zero, ids))
        self.require(known, what.replace("%", "%%"))


class ByTurnedOrders(OfPlans):
    """Replays whose certificates compare two points along directions; of points that are level along one for a while a
    second direction decides. Subclasses have directions(): the predicates."""

    lists = True  # they are kept in lists

    def is_level_by_motion(self, ids, x):
        """A new flight plan at x has made two points level along a direction for a while: the claim along the second
        direction is made then, and may be negative before."""
        return self.moved_at is x and len(ids) == 2 and any(
            self.world.is_zero((direction, ids)) for direction in self.directions())

    def require_order(self, r):
        """Two points change their order by a failure of theirs, by none, or where a failure of others has made them
        neighbours: then they are level along its direction. In lists the one in front is named first, where the two
        are level for ever along none."""
        query = self.query(r)
        if query is None:
            return
        if set(query[1]) == set(r.ids):
            in_order = not self.lists or tuple(query[1]) == tuple(r.ids)
            self.require(in_order or any(self.world.is_zero((direction, r.ids)) for direction in self.directions()),
                         "%s: the first one was behind the other", r.short())
            return
        self.require(any(self.world.is_zero((name, r.ids)) for name, _ in self.meanings(*query)),
                     "%s is not a failure of the two points", r.short())

    def doubt(self, r, x, what):
        self.require(self.is_level_by_motion(self.checker.query(r)[1], x), what.replace("%", "%%"))
