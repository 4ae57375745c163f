# SPDX-License-Identifier: GPL-3.0-or-later
"""Small attributes that are computed from scratch, right after every instant that may change them:
bounding_box, closest_pair_delaunay, the diameter and the spanning trees.

One external event an instant says what the attribute was and what it is. Internal events (another
winner of a duel inside a tournament) are checked at level 2, as certificates that fail; which duels
there are is not followed.
"""

from fractions import Fraction
from functools import cmp_to_key
from itertools import combinations
from types import SimpleNamespace

from log import Wrong
from predicates import axis_order, distance_query
from proof import Proof
from replay_members import OfMembers
from static import forest_edges, spanning_tree
from subsets import classes_of, query_of


class Scratch(OfMembers):
    bound = []
    partly = "internal events: the duels of its tournaments are not followed"

    def __init__(self, checker, structure):
        super().__init__(checker, structure)
        self.told, self.changed, self.look = [], 0, True
        self.proofs = [Proof(self.world, self.label, checker.on[4])]  # without claims
        checker.note_partly(self.label, self.partly)

    @property
    def attribute(self):
        return list(self.told)

    def begin(self, x):
        self.told, self.changed, self.look = self.current(x), 0, False

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
        if fresh != self.told:
            self.require(not self.changed, "%s: the attribute changes a second time at one instant", r.short())
            self.changed += 1
        self.told = fresh

    def check(self, r, before, after):
        self.checker.check_change(self, r, before, after)

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


class ClosestPairOfOrders(ClosestPair):
    """The same, with the exchanges of two neighbours along x, y, x + y or x - y."""

    DIRECTIONS = ((1, 1), (1, -1))

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
        if self.query(r) is not None:
            self.require(set(self.query(r)[1]) == set(r.ids), "%s is not a failure of the two points", r.short())


class OfCells:
    """With points that move to another cell of a grid; a line of it is named by its place."""

    LINES = 1 << 30  # the numbers of lines: those of objects are smaller

    def __init__(self, checker, structure):
        super().__init__(checker, structure)
        self.lines = {}

    def own_query(self, r):
        """The order of a point and a line; None: it is another claim."""
        names = [a for a in r.arguments if isinstance(a, str)]
        if not names:
            return None
        ids = tuple(self.line(a, r.predicate) if isinstance(a, str) else a for a in r.arguments)
        self.require(r.kind == "cell" and len(ids) == 2 and len(names) == 1, "%s: no claim of a cell", r.short())
        self.require(self.members & set(ids), "%s: the certificate names no point that is there", r.short())
        return (r.predicate, ids)

    def line(self, name, order):
        self.require(order in ("order_x", "order_y", "order_z") and name[:2] == order[-1] + "=",
                     "%s is no line for an %s", name, order)
        if name not in self.lines:
            try:
                at = Fraction(name[2:])
            except ValueError:
                raise Wrong("%s is no line" % name)
            self.lines[name] = self.LINES + len(self.lines)
            level = (at.numerator,) if at else ()
            axes = 2 * self.world.scene.dimension  # extents included
            self.world.set_motion(self.lines[name], SimpleNamespace(denominator=at.denominator,
                                                                    polynomials=[level] * axes))
        return self.lines[name]

    def moved(self, r):
        self.require_members(r, 1)
        if self.query(r) is not None:
            self.require(r.ids[0] in self.query(r)[1], "%s is not a failure of the point", r.short())


class ClosestPairOfCells(OfCells, ClosestPair):
    """The same, among points in near cells."""

    def replaced(self, r, before, after):
        if r.kind == "replace":
            super().replaced(r, before, after)

    def event(self, r, x):
        if r.kind != "cell":
            super().event(r, x)
        else:
            self.moved(r)


class SpanningTree(Scratch):
    """The Euclidean minimum spanning tree; of equal lengths the smaller pair is the shorter one.

    An instant may have several events "swap", each with one edge that is gone and one that came."""

    claim = staticmethod(distance_query)
    width = 2  # of edges, as tuples of objects

    def edges(self):
        return combinations(sorted(self.members), 2)

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

    def record(self, r, x):
        self.look = True
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
            return
        ids = self.world.scene.ids
        self.require(r.kind in ("swap", "settled", "rebuild"), "%s changes the tree", r.short())
        if r.kind == "swap":
            sides = [[[ids[o] for o in edge]] for edge in (old, fresh)]
            self.require([r.gone, r.came] == sides, "%s: the tree changes from %s to %s", r.short(), *sides)
        number = {name: o for o, name in enumerate(ids)}
        gone, came = ({tuple(number[name] for name in edge) for edge in side} for side in (r.gone, r.came))
        self.require(gone <= set(self.told), "%s: an edge is gone that was not there", r.short())
        self.require(not came & set(self.told), "%s: an edge came that was there", r.short())
        self.told = sorted(set(self.told) - gone | came)


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


def boxes_meet(world, pair, x):
    return all(world.sign_after(("meeting_" + "xyz"[axis], ends), x) >= 0
               for axis in range(world.scene.dimension) for ends in (pair, pair[::-1]))


def discs_meet(world, pair, x):
    return world.sign_after(("disc_overlap", pair), x) >= 0


class BoxesThatMeet(Scratch):
    """The pairs of boxes that meet, identical touches included. One event, "meet" or "part", for each pair that
    an instant changes."""

    partly = "internal events: the lists of ends are not followed"
    KINDS = ("meet", "part")
    meet = staticmethod(boxes_meet)

    def current(self, x):
        return [pair for pair in combinations(sorted(self.members), 2) if self.meet(self.world, pair, x)]

    def record(self, r, x):
        self.look = True
        ids = self.world.scene.ids
        if r.kind in self.KINDS:
            self.require_members(r, 2)
            self.require(r.external and r.ids[0] < r.ids[1], "%s: no pair that changes", r.short())
            pair = [[[ids[o] for o in r.ids]], []]
            self.require([r.came, r.gone] == (pair if r.kind == self.KINDS[0] else pair[::-1]),
                         "%s: another pair changes than its own", r.short())
        elif r.kind not in ("settled", "rebuild"):
            self.require_members(r, len(r.ids))
            if self.query(r) is not None and r.kind != "tie":
                self.require(set(self.query(r)[1]) == set(r.ids), "%s is not a failure of its objects", r.short())
        if not r.external:
            self.require(r.gone is None, "%s says nothing of the attribute", r.short())
            return
        number = {name: o for o, name in enumerate(ids)}
        gone, came = ({tuple(number[name] for name in pair) for pair in side} for side in (r.gone, r.came))
        self.require(gone <= set(self.told), "%s: a pair parts that did not meet", r.short())
        self.require(not came & set(self.told), "%s: a pair meets that did already", r.short())
        self.told = sorted(set(self.told) - gone | came)


class DiscsThatMeet(BoxesThatMeet):
    meet = staticmethod(discs_meet)


class DiscsOfCells(OfCells, DiscsThatMeet):
    """The same, among discs in neighbouring cells."""

    def record(self, r, x):
        if r.kind != "cell":
            super().record(r, x)
            return
        self.look = True
        self.moved(r)
        self.require(not r.external and r.gone is None, "%s says nothing of the attribute", r.short())


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
    """Of equally distant pairs the smallest. The events of calipers are checked as failures only."""

    CALIPERS = ("antiparallel", "perpendicular", "split", "merge", "renew")

    @staticmethod
    def claim(a, b):
        return distance_query(b, a)

    def event(self, r, x):
        if r.kind not in self.CALIPERS:
            super().event(r, x)
