# SPDX-License-Identifier: GPL-3.0-or-later
"""delaunay_2: edges are flipped; a point enters or leaves the hull (a flip with infinity).

The proof has one claim per edge, and one per bounded triangle, that it is positively oriented. At an instant
with a flip that was impossible ("blocked"), or with points taken out and put in again, the triangulation is
computed from scratch right after the instant, and must have the edges of the log.
"""

from math import inf

from log import Wrong
from predicates import normal_form
from proof import Proof
from replay import Replay
from triangulation import delaunay, edge_query, wants_other_diagonal


class Delaunay(Replay):
    bound = ["order_x", "order_y", "orientation_2", "in_circle_2", "obtuse_angle_2"]

    def __init__(self, checker, structure):
        super().__init__(checker, structure)
        self.proof = Proof(self.world, self.label, checker.on[4])
        self.proofs = [self.proof]
        self.infinity = len(self.world.scene.ids)
        self.loose = False  # the triangulation is not known until the instant is settled
        self.many = 0  # records at this instant

    @property
    def attribute(self):
        return sorted(self.edges)

    def start(self, x):
        self.members = self.alive()
        self.make(x)
        self.edges = self.true_edges()

    def make(self, x):
        """From scratch, with all claims."""
        self.t, self.line = delaunay(self.world, self.members, x)
        self.vertices = set(self.line) if self.t is None else {u for u, _ in self.t.apex} - {self.infinity}
        self.proof.clear(x)
        if self.t is None:
            self.axis = "order_x"
            if len(self.line) > 1 and self.world.is_zero(("order_x", (self.line[0], self.line[-1]))):
                self.axis = "order_y"
            self.line_claims(range(len(self.line) - 1), x)
            return
        for u, v in list(self.t.apex):
            if u < v:
                self.claim(u, v, x)
        for triangle in self.t.triangles():
            self.proof.put(triangle, ("orientation_2", triangle), x)

    def true_edges(self):
        if self.t is None:
            return {(min(p), max(p)) for p in zip(self.line, self.line[1:])}
        return self.t.edges()

    # ---- claims

    def line_claims(self, places, x):
        for i in places:
            if 0 <= i < len(self.line) - 1:
                self.proof.put(("line", i), (self.axis, (self.line[i], self.line[i + 1])), x)

    def claim(self, u, v, x):
        u, v = min(u, v), max(u, v)
        self.proof.put((u, v), edge_query(self.t, u, v), x)

    def upright(self, triangle, add, x):
        if self.infinity in triangle:
            return
        i = triangle.index(min(triangle))
        triangle = triangle[i:] + triangle[:i]
        if add:
            self.proof.put(triangle, ("orientation_2", triangle), x)
        else:
            self.proof.drop(triangle, x)

    # ---- records

    def record(self, r, x):
        if r.kind in ("settled", "rebuild"):
            return self.settled(r, x)
        self.many += 1
        for i in r.ids:
            self.require(i in self.members, "%s: %s is not there", r.short(), self.world.scene.ids[i])
        if r.kind in ("blocked", "reinsert"):
            return self.disturbed(r, x)
        self.require(r.gone is None, "%s says all by its ids", r.short())
        if r.kind == "pass":
            return self.passing(r, x)
        self.require(self.t is not None, "%s: all points are on one line", r.short())
        u, v, p, q = self.quad(r)
        if not r.external:
            # Reported together with earlier changes, at the end of the instant.
            self.require(self.loose or (min(p, q), max(p, q)) in self.edges, "%s is external", r.short())
            self.loose = True
            return
        if self.loose:
            return self.edge_change(r, u, v, p, q)
        for a, b in ((u, v), (v, u)):
            if (a, b) not in self.t.apex:
                raise Wrong("%s: there is no edge %s" % (r.short(), self.edge_name(u, v)))
        if {self.t.apex[u, v], self.t.apex[v, u]} != {p, q}:
            raise Wrong("%s: opposite of the edge %s are %s" % (r.short(), self.edge_name(u, v), self.edge_name(
                self.t.apex[u, v], self.t.apex[v, u])))
        if not self.t.flippable(u, v):
            raise Wrong("%s: the edge %s is there already" % (r.short(), self.edge_name(p, q)))
        query, claim = self.query(r), edge_query(self.t, u, v)
        if self.world.is_zero(claim):
            self.require(wants_other_diagonal(self.world, self.t, u, v),
                         "%s: the edge is right, the smallest id is on it", r.short())
        else:
            self.require(query is not None and query[0] == claim[0] and normal_form(*query) == normal_form(*claim),
                         "%s is not a failure of this edge", r.short())
            self.checker.failed(self, (claim[0], query[1]), self.proof.claims[min(u, v), max(u, v)][2], x)
        self.flip(u, v, x)
        self.edge_change(r, u, v, p, q)

    def edge_name(self, u, v):
        return "[" + ", ".join("infinity" if i == self.infinity else self.world.scene.ids[i]
                               for i in sorted((u, v))) + "]"

    def quad(self, r):
        """The edge that is removed and the one that is added."""
        size = 4 if r.kind == "flip" else 3
        self.require(len(r.ids) == size and len(set(r.ids)) == size, "%s names %d objects", r.short(), size)
        self.require(r.ids[-2] < r.ids[-1] and (size == 3 or r.ids[0] < r.ids[1]),
                     "%s: edges are written smaller id first", r.short())
        if r.kind == "flip":
            return r.ids
        if r.kind == "enter":
            return r.ids[1], r.ids[2], r.ids[0], self.infinity
        return r.ids[0], self.infinity, r.ids[1], r.ids[2]

    def flip(self, u, v, x):
        self.proof.step += 1
        p, q = self.t.apex[u, v], self.t.apex[v, u]
        self.upright((u, v, p), False, x)
        self.upright((v, u, q), False, x)
        self.proof.drop((min(u, v), max(u, v)), x)
        self.t.flip(u, v)
        self.upright((p, u, q), True, x)
        self.upright((q, v, p), True, x)
        for a, b in ((p, q), (u, p), (p, v), (v, q), (q, u)):
            self.claim(a, b, x)

    def edge_change(self, r, u, v, p, q):
        """The change of the attribute that the record reports."""
        if r.kind in ("flip", "enter"):
            edge = (min(u, v), max(u, v))
            self.require(edge in self.edges, "%s: there is no edge %s", r.short(), self.edge_name(u, v))
            self.edges.discard(edge)
        if r.kind in ("flip", "leave"):
            edge = (min(p, q), max(p, q))
            self.require(edge not in self.edges, "%s: the edge %s is there already", r.short(),
                         self.edge_name(p, q))
            self.edges.add(edge)

    def passing(self, r, x):
        self.require(self.t is None, "%s: the points are not on one line", r.short())
        self.require(len(r.ids) == 2 and r.ids[0] < r.ids[1], "%s names two objects, smaller id first", r.short())
        query = self.query(r)
        self.require(query is not None and query[0] == self.axis and set(query[1]) == set(r.ids),
                     "%s is not a failure of the order of the two", r.short())
        a, b = query[1]
        i = self.line.index(a)
        self.require(i + 1 < len(self.line) and self.line[i + 1] == b,
                     "%s: the two are not neighbours on the line", r.short())
        self.checker.failed(self, query, self.proof.claims["line", i][2], x)
        self.proof.step += 1
        self.line[i], self.line[i + 1] = b, a
        self.line_claims((i, i - 1, i + 1), x)
        before = self.edges
        self.edges = self.true_edges()
        self.require(r.external == (self.edges != before), "%s is %sexternal: the edges %s", r.short(),
                     "" if self.edges != before else "not ", "change" if self.edges != before else "stay")

    def disturbed(self, r, x):
        """A flip that was impossible, or a point that was taken out and put in again: the triangulation is
        unknown until the instant is over."""
        if r.kind == "blocked":
            self.require(len(r.ids) in (3, 4) and list(r.ids) == sorted(set(r.ids)),
                         "%s names three or four objects, in order", r.short())
            query = self.query(r)
            self.require(query is not None and set(query[1]) == set(r.ids),
                         "%s is not a failure of its objects", r.short())
            if not self.loose and self.t is not None:
                self.block(r, query, x)
        else:
            self.require(len(r.ids) == 1, "%s names one object", r.short())
        self.require(not r.external and r.gone is None, "%s is internal", r.short())
        self.loose = True

    def block(self, r, query, x):
        """The first one at an instant: the triangulation, and so the edge, is still known."""
        for place, claim in self.proof.claims.items():
            if len(place) == 2 and claim[0][0] == query[0] and normal_form(*claim[0]) == normal_form(*query):
                return self.checker.failed(self, query, claim[2], x)
        self.require(self.is_straight(query), "%s: the certificate is not part of the proof", r.short())
        self.checker.failed(self, query, self.proof.claims[query[1][1], self.infinity][2], x)

    def is_straight(self, query):
        """That a vertex of the hull is between its neighbours, where the three are identically on one line, or
        were until new motions came at this instant."""
        if query[0] != "obtuse_angle_2" or (query[1][1], self.infinity) not in self.proof.claims:
            return False
        claim = self.proof.claims[query[1][1], self.infinity][0]
        return set(claim[1]) == set(query[1]) and (self.moved or self.world.is_zero(claim))

    def difference(self, r):
        ids = self.world.scene.number
        sides = []
        for side in (r.gone, r.came):
            pairs = []
            for pair in side:
                self.require(isinstance(pair, list) and all(i in ids for i in pair),
                             "%s: gone and came are not edges", r.short())
                pairs.append((ids[pair[0]], ids[pair[1]]))
            self.require(all(a < b for a, b in pairs) and pairs == sorted(set(pairs)),
                         "%s: gone or came is not in order", r.short())
            sides.append(set(pairs))
        gone, came = sides
        self.require(gone <= self.edges, "%s: gone has an edge that was not there", r.short())
        self.require(not came & self.edges, "%s: came has an edge that was there", r.short())
        self.edges = (self.edges - gone) | came

    def settled(self, r, x):
        disturbed = self.loose or self.moved or r.kind == "rebuild" and (self.many or self.proof.failing(x))
        self.require(disturbed, "%s: nothing had to be settled", r.short())
        self.loose = True
        if r.gone is not None:
            self.difference(r)

    moved = False
    late = ()

    def before_motion(self, objects, x):
        """Hull vertices that are identically between their neighbours until now: that they turn left is claimed only
        when all other failures of the instant have been handled."""
        super().before_motion(objects, x)
        self.late = [claim for place, claim in self.proof.claims.items() if len(place) == 2 and self.infinity in place
                     and not objects.isdisjoint(claim[0][1]) and self.world.is_zero(claim[0])]
        for claim in self.late:
            claim[2] = inf

    def after_motion(self, objects, x):
        super().after_motion(objects, x)
        self.moved = True

    def insert(self, o, x):
        self.members.add(o)
        self.make(x)
        self.edges = self.true_edges()

    def erase(self, o, x):
        self.members.discard(o)
        self.make(x)
        self.edges = self.true_edges()

    # ---- at the end of an instant

    def settle(self, x):
        if self.moved and not self.loose:
            hidden = len(self.vertices) < len(self.members)
            self.loose = self.t is None or hidden or any(
                self.world.is_zero(c[0]) for p, c in self.proof.claims.items() if len(p) == 3)
            if not self.loose:
                self.loose = self.some_equal()
        if self.loose:
            self.make(x)
        elif self.many > 1 or self.moved:
            self.check_all(x)
        for claim in self.late:
            claim[2] = self.proof.step
        self.many, self.loose, self.moved, self.late = 0, False, False, ()
        true = self.true_edges()
        if self.edges != true:
            less, more = sorted(true - self.edges), sorted(self.edges - true)
            raise Wrong("%s: right after %r the edges are not those of the Delaunay triangulation: %s" % (
                self.label, x, ", ".join(["%s missing" % self.edge_name(*e) for e in less[:3]]
                                         + ["%s too many" % self.edge_name(*e) for e in more[:3]])))

    def some_equal(self):
        for o in self.members:
            for other in self.members:
                if o < other and self.world.is_zero(("order_x", (o, other))) \
                        and self.world.is_zero(("order_y", (o, other))):
                    return True
        return False

    def check_all(self, x):
        """After several events at one instant: every claim holds, every triangle is positively oriented, the
        hull turns once, and cocircular points are triangulated as fans."""
        for place in self.proof.failing(x):
            raise Wrong("%s: right after %r %s is negative" % (
                self.label, x, self.proof.tell(self.proof.claims[place][0])))
        if self.t is None:
            return
        for place, claim in self.proof.claims.items():
            if len(place) == 3 and self.world.is_zero(claim[0]):
                raise Wrong("%s: the triangle %s is identically flat" % (self.label, self.names(place)))
            if len(place) == 2 and wants_other_diagonal(self.world, self.t, *place):
                raise Wrong("%s: of four points on one circle the edge %s does not have the smallest id" % (
                    self.label, self.edge_name(*place)))
        hull = self.t.hull()
        forward = [(self.world.sign_after(("order_x", pair), x) or self.world.sign_after(("order_y", pair), x)) > 0
                   for pair in zip(hull, hull[1:] + hull[:1])]
        if sum(forward[i] and not forward[i - 1] for i in range(len(forward))) != 1:
            raise Wrong("%s: the hull winds around more than once" % self.label)
