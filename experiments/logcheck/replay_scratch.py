# SPDX-License-Identifier: GPL-3.0-or-later
"""Small attributes that are computed from scratch, right after every instant that may change them:
bounding_box, closest_pair_delaunay, the diameter. Sets of pairs and spanning trees are in replay_pairs.py and
replay_trees.py.

One external event an instant says what the attribute was and what it is. Internal events (another
winner of a duel inside a tournament) are checked at level 2, as certificates that fail; which duels
there are is not followed.
"""

from itertools import combinations

from predicates import axis_order, distance_query
from proof import Proof
from replay_members import ByTurnedOrders, OfMembers
from subsets import classes_of, query_of


HULLS = ("convex_hull_2", "directions_2")


class OnHull:
    """Replays of what is made on a hull."""

    def doubt(self, r, x, what):
        """A certificate that is negative, but not zero: of what is repaired because the hull has just changed, as where
        a new flight plan takes away a side that had no length at that instant."""
        hulls = [replay for replay in self.checker.touched.values() if replay.structure.name.startswith(HULLS)]
        self.require(hulls and not r.external, what.replace("%", "%%"))


class Scratch(OfMembers):
    bound = []
    partly = "internal events: the duels of its tournaments are not followed"

    def __init__(self, checker, structure):
        super().__init__(checker, structure)
        self.told, self.changed, self.look = [], 0, True
        self.begun_at = None  # the last instant at which objects came, went or got new motions
        self.proofs = [Proof(self.world, self.label, checker.on[4])]  # without claims
        if self.partly:
            checker.note_partly(self.label, self.partly)

    @property
    def attribute(self):
        return list(self.told)

    def begin(self, x):
        self.told, self.changed, self.look, self.begun_at = self.current(x), 0, False, x

    def after_motion(self, objects, x):
        super().after_motion(objects, x)
        self.begun_at = x

    def record(self, r, x):
        self.look = True
        if r.kind not in ("settled", "rebuild"):
            self.event(r, x)
            if not r.external:
                self.require(r.gone is None, "%s says nothing of the attribute", r.short())
                return
        fresh = self.current(x)
        self.check(r, self.told, fresh)
        if r.kind == "replace":
            self.replaced(r, self.told, fresh)
        self.require(fresh != self.told or not r.external or r.kind == "rebuild", "%s is external and changes nothing",
                     r.short())
        if fresh != self.told:
            self.require(not self.changed, "%s: the attribute changes a second time at one instant", r.short())
            self.changed += 1
            self.require_due(x)
        self.told = fresh

    def require_due(self, x):
        """The attribute changes at x, not before. Where motions change at x, those of before are not known any more."""
        self.require(self.begun_at is x or self.told == self.right_before(x),
                     "%s: right before %r the attribute was another one already", self.label, x)

    def right_before(self, x):
        """The attribute, by the motions that are in force right after x."""
        self.world.looks_back = True
        try:
            return self.current(x)
        finally:
            self.world.looks_back = False

    def check(self, r, before, after):
        self.checker.check_change(self, r, before, after)

    def check_difference(self, r, before, after):
        """As check, of a set of tuples: those that are gone, and those that came."""
        ids = self.world.scene.ids
        sides = [[[ids[o] for o in one] for one in sorted(set(here) - set(there))]
                 for here, there in ((before, after), (after, before))]
        if before == after:
            self.require(r.gone is None, "%s: nothing has changed", r.short())
        else:
            self.require([r.gone, r.came] == sides, "%s: what goes and comes is %s and %s", r.short(), *sides)

    def replaced(self, r, before, after):
        """An external duel names what was in the attribute, then what is."""

    def settle(self, x):
        self.changed = 0
        if not self.look:
            return
        self.look = False
        self.require(self.told == self.current(x), "%s: right after %r the attribute is another one", self.label, x)

    def finish(self, end):
        """A change whose record is missing is seen at the next instant, or here."""
        super().finish(end)
        if end is not None:
            self.require(self.told == self.current(end), "%s: right after the end the attribute is another one",
                         self.label)


class BoundingBox(Scratch):
    """The minimum and the maximum of every axis; equal coordinates: the smallest number."""

    def claim(self, axis, a, b):
        return (axis_order(axis), (a, b))

    def current(self, x):
        box = []
        for axis in range(self.world.scene.dimension):
            least = most = None
            for o in sorted(self.members):
                if least is None or self.world.sign_after(self.claim(axis, o, least), x) > 0:
                    least = o
                if most is None or self.world.sign_after(self.claim(axis, most, o), x) > 0:
                    most = o
            box += [] if least is None else [least, most]
        return box

    def event(self, r, x):
        self.require_members(r, 2)
        a, b = r.ids
        if r.kind == "tie":
            self.require(any(self.world.is_zero(self.claim(axis, a, b)) for axis in range(self.world.scene.dimension)),
                         "%s: the two are identically equal on no axis", r.short())
        elif self.query(r) is not None:
            self.require(set(self.query(r)[1]) == {a, b}, "%s is not a failure of the order of the two", r.short())

    def replaced(self, r, before, after):
        self.require(tuple(r.ids) in zip(before, after), "%s: no side changes from the first to the second", r.short())


class ClosestPair(Scratch):
    """Of equally distant pairs the smallest."""

    claim = staticmethod(distance_query)

    def pairs(self):
        return combinations(sorted(self.members), 2)

    def current(self, x):
        best = None
        for pair in self.pairs():
            if best is None or self.world.sign_after(self.claim(pair, best), x) > 0:
                best = pair
        return [] if best is None else [best]

    def check(self, r, before, after):
        ids = self.world.scene.ids
        sides = [[[ids[a], ids[b]] for a, b in side] for side in (before, after)]
        if before == after:
            self.require(r.gone is None, "%s: nothing has changed", r.short())
        else:
            self.require([r.gone, r.came] == sides, "%s: the pair was %s and is %s", r.short(), *sides)

    def replaced(self, r, before, after):
        self.require([tuple(r.ids[:2])] == before and [tuple(r.ids[2:])] == after,
                     "%s: the pair changes from %s to %s", r.short(), before, after)

    def event(self, r, x):
        self.require_members(r, 4)
        old, fresh = tuple(r.ids[:2]), tuple(r.ids[2:])
        self.require(old[0] < old[1] and fresh[0] < fresh[1] and old != fresh, "%s: no two pairs", r.short())
        if r.kind == "tie":
            self.require(self.world.is_zero(self.claim(old, fresh)), "%s: the distances are not identically equal",
                         r.short())
        elif self.query(r) is not None:
            self.require(set(self.query(r)[1]) == set(r.ids), "%s is not a failure of the two pairs", r.short())


class ClosestPairOfOrders(ClosestPair, ByTurnedOrders):
    """The same, with the exchanges of two neighbours along x, y, x + y or x - y."""

    DIRECTIONS = ((1, 1), (1, -1))

    def directions(self):
        return ["order_x", "order_y"] + [("order_direction", u) for u in self.DIRECTIONS]

    def meanings(self, name, ids):
        if name == "order_direction":
            return [(("order_direction", u), ids) for u in self.DIRECTIONS]
        return [(name, ids)]

    def replaced(self, r, before, after):
        if r.kind == "replace":
            super().replaced(r, before, after)

    def event(self, r, x):
        if r.kind != "order":
            super().event(r, x)
            return
        self.require_members(r, 2)
        self.require_order(r)


class TwoColours(ClosestPair):
    """The closest two points of different classes."""

    def __init__(self, checker, structure):
        super().__init__(checker, structure)
        self.red, self.blue = classes_of(structure.options, self.world.scene)

    def pairs(self):
        return [(a, b) for a, b in super().pairs()
                if (a in self.red and b in self.blue) or (a in self.blue and b in self.red)]


class NearestSite(Scratch):
    """The site nearest to the query; of equally distant ones the smallest."""

    def __init__(self, checker, structure):
        super().__init__(checker, structure)
        self.asked = query_of(structure.options, self.world.scene)

    def claim(self, near, far):
        return ("order_squared_distance", (near, far, self.asked))

    def current(self, x):
        best = None
        if self.asked not in self.members:
            return []
        for o in sorted(self.members - {self.asked}):
            if best is None or self.world.sign_after(self.claim(o, best), x) > 0:
                best = o
        return [] if best is None else [best]

    def check(self, r, before, after):
        if r.kind == "settled" or not r.external:
            self.checker.check_change(self, r, before, after)

    def replaced(self, r, before, after):
        if before != after:
            self.require([[r.ids[0]], [r.ids[1]]] == [before, after], "%s: the nearest site changes from %s to %s",
                         r.short(), before, after)

    def event(self, r, x):
        self.require_members(r, 2)
        old, fresh = r.ids
        if r.kind == "tie":
            self.require(self.world.is_zero(self.claim(old, fresh)), "%s: the distances are not identically equal",
                         r.short())
        elif self.query(r) is not None:
            self.require(set(self.query(r)[1]) == {old, fresh, self.asked}, "%s is not a failure of the two sites",
                         r.short())


class FarthestPair(ClosestPair):
    """Of equally distant pairs the smallest."""

    @staticmethod
    def claim(a, b):
        return distance_query(b, a)
