# SPDX-License-Identifier: GPL-3.0-or-later
"""convex_hull_2 and its three siblings: strict vertices counter-clockwise from the smallest id.

All four report the same changes at the end of an instant: the points that leave, the points that enter, both
in the order of ids, and, if the remaining points have another order, the first place at which it differs
("turn"). The proof: every point is to the left of every hull edge, or identically on it between its ends.
"""

from log import Wrong
from predicates import normal_form
from proof import Proof
from replay_members import OfMembers
from static import hull, rotated

OWN = ("leave", "enter", "turn")


class Hull(OfMembers):
    bound = ["order_x", "order_y", "orientation_2", "slope_order_2"]

    def __init__(self, checker, structure):
        super().__init__(checker, structure)
        self.proof = Proof(self.world, self.label, checker.on[4])
        self.proofs = [self.proof]
        self.events = []

    @property
    def attribute(self):
        return list(self.cycle)

    def begin(self, x):
        self.cycle = self.current(x)
        self.claims(x)

    def current(self, x):
        return hull(self.world, self.members, x)

    def claims(self, x):
        wanted = {}
        n = len(self.cycle)
        for i, a in enumerate(self.cycle):
            b = self.cycle[(i + 1) % n]
            if a == b:
                continue
            for p in self.members:
                if p in (a, b):
                    continue
                query = ("orientation_2", (a, b, p))
                wanted[a, b, p] = query
                if self.world.is_zero(query):
                    self.between(a, b, p, x, wanted)
        for place in list(self.proof.claims):
            if place not in wanted:
                self.proof.drop(place, x)
        for place, query in wanted.items():
            self.proof.put(place, query, x)

    def between(self, a, b, p, x, wanted):
        for axis in ("order_x", "order_y"):
            sign = self.world.sign_after((axis, (a, b)), x)
            if sign:
                ends = ((a, p), (p, b)) if sign > 0 else ((p, a), (b, p))
                for i, pair in enumerate(ends):
                    wanted[a, b, p, i] = (axis, pair)
                return

    def record(self, r, x):
        if r.kind in ("settled", "rebuild"):
            return self.change(r, x)
        for i in r.ids:
            self.require(i in self.members, "%s: %s is not there", r.short(), self.world.scene.ids[i])
        if r.kind in OWN:
            self.require(r.external, "%s is external", r.short())
            self.events.append(self.told_by(r))
        else:
            self.require(not r.external, "%s is internal", r.short())
            self.require(not self.events, "%s: a failure after the change of the hull that it leads to", r.short())
            self.internal(r, x)

    def told_by(self, r):
        """(kind, ids, gone, came)."""
        if r.gone is None:
            return (r.kind, r.ids, None, None)
        number = self.world.scene.number
        for side in (r.gone, r.came):
            self.require(all(isinstance(i, str) and i in number for i in side),
                         "%s: gone and came are not lists of points", r.short())
        return (r.kind, r.ids, [number[i] for i in r.gone], [number[i] for i in r.came])

    def internal(self, r, x):
        raise Wrong("%s: this structure has no such events" % r.short())

    def change(self, r, x):
        fresh = self.current(x)
        self.checker.check_change(self, r, self.cycle, fresh)
        self.cycle = fresh
        self.look = True

    def settle(self, x):
        failing = self.look or self.events or self.proof.failing(x)
        self.look = False
        if not failing:
            return
        fresh = self.current(x)
        due = changes(self.cycle, fresh)
        if self.events != due:
            self.wrong(self.events, due, fresh, x)
        self.events = []
        self.cycle = fresh
        self.claims(x)

    def wrong(self, told, due, fresh, x):
        def said(events):
            return ", ".join("%s %s" % (kind, self.names(ids)) + (
                "" if gone is None else " from %s to %s" % (self.names(gone), self.names(came)))
                for kind, ids, gone, came in events) or "nothing"

        raise Wrong("%s: at %r it changes from %s to %s; due are %s; told are %s" % (
            self.label, x, self.names(self.cycle), self.names(fresh), said(due), said(told)))


def changes(old, new):
    """The events that report a change of the hull: (kind, ids, gone, came). Points that leave and points that
    enter, both in the order of ids; an entering point with its two neighbours on the present cycle. If the
    result is not the new cycle, a turn names the first place at which the two differ, and has both cycles."""
    events = []
    cycle = [o for o in old if o in new]
    events += [("leave", (o,), None, None) for o in sorted(set(old) - set(new))]
    for o in sorted(set(new) - set(old)):
        i = new.index(o)
        behind = next((new[i - k] for k in range(1, len(new)) if new[i - k] in cycle), None)
        if behind is None:
            cycle = [o]
            events.append(("enter", (o,), None, None))
            continue
        place = cycle.index(behind)
        events.append(("enter", (o, behind, cycle[(place + 1) % len(cycle)]), None, None))
        cycle.insert(place + 1, o)
    cycle = rotated(cycle)
    if cycle != new:
        a = rotated([o for o in old if o in new])
        b = rotated([o for o in new if o in old])
        i = next(i for i in range(len(a) - 1) if a[i + 1] != b[i + 1])
        events.append(("turn", (a[i], a[i + 1], b[i + 1]), cycle, new))
    return events


class HullOfDelaunay(Hull):
    """Read off a triangulation: its only events are changes of the hull, and it has no certificates."""

    def between(self, a, b, p, x, wanted):
        """Without an axis: a side that turns through the upright has no event there."""
        wanted[a, b, p, 0] = ("edge_dot_2", (a, b, a, p))
        wanted[a, b, p, 1] = ("edge_dot_2", (a, b, p, b))


class HullBruteForce(Hull):
    """Certificates: the hull turns left at each vertex, and every other point is to the left of each edge. A
    failure changes the hull, and all certificates are made anew: one internal event an instant."""

    KINDS = {"reflex": 3, "outside": 3, "between": 2}
    fails_touching = ("orientation_2",)  # vertices that meet and part again leave every turn to the left

    def start(self, x):
        self.touching = set()  # places of the turns, whose claims fail where they touch zero
        super().start(x)
        self.failed = []

    def claims(self, x):
        super().claims(x)
        self.touches(x)

    def after_motion(self, objects, x):
        super().after_motion(objects, x)
        self.touches(x)

    def touches(self, x):
        """Turns fail at touches, too: hull vertices that meet and part leave no other trace. What is said of a vertex that
        has left the hull fails where it becomes negative."""
        turns = set(triples(self.cycle))
        for place in self.touching - turns:
            if place in self.proof.claims:
                claim = self.proof.claims[place]
                self.proof.judge(claim, x)
                claim[1] = self.world.first_negative(claim[0], x)
        for place in turns:
            claim = self.proof.claims.get(place)
            if claim is not None:
                self.proof.judge(claim, x)
                claim[1] = self.world.first_touch(claim[0], x)
        self.touching = turns

    def internal(self, r, x):
        self.require(not self.failed, "%s: the second failure of one instant", r.short())
        query = self.query(r)
        self.require(query is not None and query[1] == r.ids and len(r.ids) == self.KINDS[r.kind],
                     "%s is not a failure of its objects", r.short())
        corners = set(self.cycle)
        if r.kind == "reflex":
            live = [(a, b, c) for a, b, c in triples(self.cycle)]
        elif r.kind == "outside":
            live = [(a, b, p) for a, b, _ in triples(self.cycle) for p in [r.ids[2]] if p not in corners]
        else:
            live = [c[0][1] for place, c in self.proof.claims.items() if len(place) == 4]
        self.require(r.ids in live, "%s: the certificate is not part of the proof", r.short())
        self.failed.append((self.checker.rank[query[0]], sorted(query[1]), list(query[1]), r))

    def settle(self, x):
        failing = [self.proof.claims[p][0] for p in self.proof.failing(x)] if not self.look else None
        before = self.cycle
        super().settle(x)
        failed, self.failed = self.failed, []
        if failing is None:
            return
        if bool(failing) != bool(failed):
            raise Wrong("%s: at %r %s" % (self.label, x, "a certificate fails, and no event says so" if failing
                                          else "no certificate fails, but an event says so"))
        if failing and self.world.scene.dimension == 2:
            corners, turns = set(before), triples(before)

            def place(query):  # turns have a predicate of their own, declared after the other one
                return (self.checker.rank[query[0]], query[0] == "orientation_2" and query[1] in turns,
                        sorted(query[1]))

            first = min(place(q) for q in failing
                        if not (q[0] == "orientation_2" and set(q[1]) <= corners and len(before) > 3
                                and q[1] not in turns))
            rank, ids, _, record = failed[0]
            if (rank, record.kind == "reflex", ids) != first:
                raise Wrong("%s: of several failures at %r the first in order comes first" % (self.label, x))


def triples(cycle):
    n = len(cycle)
    return [(cycle[i], cycle[(i + 1) % n], cycle[(i + 2) % n]) for i in range(n)] if n > 2 else (
        [(cycle[0], cycle[1], cycle[0]), (cycle[1], cycle[0], cycle[1])] if n == 2 else [])
