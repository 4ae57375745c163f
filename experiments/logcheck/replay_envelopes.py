# SPDX-License-Identifier: GPL-3.0-or-later
"""convex_hull_2 and convex_hull_2_naive: their internal events, failures inside the tree of envelopes.

The claims of a node are a function of its state. After an instant, the nodes with a failure and those above
whose children's chains have changed are merged from scratch. Claims of one node, in both halves, about the
slopes of the same two lines count as one failure, since one repair serves them all. If there is one failure
at an instant, it has exactly one record; where two of its points meet, what its repair claims may fail, too. If
there are several, each has a record, with two exceptions: a repair of the same half, in the same node or below, with
two points in common may have removed a failure; and with three or more failures a node may have been merged anew.
There may also be records of claims that were made at the instant itself; with three or more failures also of corners
that belong to no time: where many points are on one line for an instant, chains pass through orders of their corners
that are none.
"""

from itertools import combinations

from envelopes import Tied, Tree
from log import Wrong
from predicates import normal_form
from proof import Proof
from replay_hull import Hull


class Envelopes(Hull):
    def __init__(self, checker, structure):
        super().__init__(checker, structure)
        self.inside = Proof(self.world, self.label, checker.on[4])
        self.proofs = [self.proof, self.inside]
        self.records, self.tied = [], False
        self.doubts = []  # what is wrong, unless a sign is identically zero
        self.no_corners = []  # what is wrong, unless there are three failures besides
        self.crowded = False
        self.moved = False

    def start(self, x):
        super().start(x)
        self.tree = Tree(self.world, self.structure.name.endswith("_naive"))
        self.tree.root = self.tree.build(sorted(self.members))
        self.merge_all(x)

    def insert(self, o, x):
        super().insert(o, x)
        if not self.tied:
            self.tree.insert(o)
            self.merge_all(x)

    def erase(self, o, x):
        super().erase(o, x)
        if not self.tied:
            self.tree.erase(o)
            self.merge_all(x)

    def merge_all(self, x):
        try:
            for t in self.tree.nodes():
                for half in (0, 1):
                    self.tree.merge(t, half, x)
        except Tied:
            return self.give_up()
        wanted = {}
        for t in self.tree.nodes():
            wanted.update(self.places(t))
        for place in list(self.inside.claims):
            if place not in wanted:
                self.inside.drop(place, x)
        for place, query in wanted.items():
            self.inside.put(place, query, x)

    @staticmethod
    def places(t):
        return {(t, half) + place: claim[0] for half in (0, 1) for place, claim in t.claimed[half].items()}

    def give_up(self):
        """From now on only changes of the hull are checked."""
        if not self.tied:
            self.tied = True
            self.checker.note_partly(self.label, "internal events, as some signs are identically zero")
        self.proofs = [self.proof]

    def internal(self, r, x):
        query = self.query(r)
        self.require(query is not None, "%s has no certificate", r.short())
        self.records.append(r)
        if not self.about(r, query[1]):
            self.doubt(r, x, "%s: its certificate is about something else" % r.short())
        elif r.kind[0] == "y" or r.kind == "x":
            # The lines of a corner, in the order of their slopes.
            for a, b in (r.ids[:2], r.ids[2:]) if r.kind == "x" else (r.ids[:2],):
                order = ("order_x", (a, b))
                if self.world.sign_after(order, x) < 0 and not self.world.vanishes(order, x):
                    self.no_corners.append(Wrong("%s: %s is no corner" % (r.short(), self.names((a, b))), r.line))

    def doubt(self, r, x, what):
        self.doubts.append(Wrong(what, r.line))

    def after_motion(self, objects, x):
        super().after_motion(objects, x)
        self.moved = True

    @staticmethod
    def about(r, arguments):
        """The event's ids are those of the certificate: two corners, a corner and a line, or two lines."""
        ids = r.ids
        if r.kind == "x":
            return len(ids) == 4 and {frozenset(ids[:2]), frozenset(ids[2:])} == {
                frozenset(arguments[:2]), frozenset(arguments[2:])}
        if r.kind[0] == "y":
            return len(ids) == 3 and len(arguments) == 3 and ids[2] == arguments[2] and set(ids) == set(arguments)
        return len(ids) == 2 and ids == arguments

    def change(self, r, x):
        super().change(r, x)
        if not self.tied:
            self.tree.root = self.tree.build(sorted(self.members))
            self.rebuilt = True

    rebuilt = False

    def settle(self, x):
        super().settle(x)
        records, self.records = self.records, []
        self.crowded = False
        if not self.tied:
            self.follow(records, x)
        doubts = self.doubts if self.crowded else self.doubts + self.no_corners
        self.doubts, self.no_corners = [], []
        if doubts and not self.tied:
            raise doubts[0]

    def follow(self, records, x):
        if self.rebuilt:
            self.rebuilt = False
            return self.merge_all(x)
        # The failures, as they were claimed; then the nodes are merged anew, which may reveal ties.
        failing = [(p, p[0].claimed[p[1]][p[2:]]) for p in self.inside.failing(x)]
        nodes = {place[0] for place, _ in failing}
        if self.moved:
            nodes = set(self.tree.nodes())
            self.moved = False
        self.renew(nodes, x)
        if not self.tied:
            self.match(records, failing, x)

    def renew(self, nodes, x):
        """Merges these nodes, and every node above them whose children's chains have changed."""
        try:
            for t in self.tree.nodes():
                if t not in nodes:
                    continue
                before = [list(c) for c in t.chains]
                old = self.places(t)
                for half in (0, 1):
                    self.tree.merge(t, half, x)
                new = self.places(t)
                for place in old:
                    if place not in new:
                        self.inside.drop(place, x)
                for place, query in new.items():
                    self.inside.put(place, query, x)
                if t.chains != before and t.parent is not None:
                    nodes.add(t.parent)
        except Tied:
            self.give_up()

    def match(self, records, failing, x):
        groups = {}  # what one repair serves: its claims
        for place, (query, kind, ids) in failing:
            name = (place[0], "slopes", frozenset(ids)) if query[0] == "order_x" else place
            groups.setdefault(name, []).append((query, kind, ids))
        self.inside.step += 1
        due = dict(groups)
        self.crowded = len(groups) > 2  # a node may have been merged anew, with all that it claimed
        matched, strange, last = [], [], (-1,)
        for r in records:
            name = self.group_of(r, due)
            if name is None:
                strange.append(r)
                continue
            matched.append((name, claims_ids(due[name])))
            predicate, ids = self.query(r)
            key = (self.checker.rank[predicate], sorted(ids), list(ids))
            if key < last and not self.crowded:
                raise Wrong("%s: of failures at one instant it comes before that of the record before it"
                            % r.short(), r.line)
            last = key
            del due[name]
        for r in strange if len(groups) <= 1 else ():
            if not any(self.have_met(ids.intersection(r.ids), x) for _, ids in matched):
                raise Wrong("%s: the certificate is not one that fails at this instant" % r.short(), r.line)
        for before, r in zip(records, records[1:]):
            if (r.kind, r.ids, self.query(r)) == (before.kind, before.ids, self.query(before)):
                raise Wrong("%s: one failure, told twice" % r.short(), r.line)
        for name, claims in due.items():
            if not strange and not any(self.takes_away(other, ids, name, claims) for other, ids in matched):
                raise Wrong("%s: %s fails at %r, and no event says so" % (
                    self.label, self.inside.tell(claims[0][0]), x))

    def have_met(self, points, x):
        """Two of them are at one place: a claim that the repair of another one makes may fail at once."""
        return any(all(self.world.vanishes((axis, pair), x) for axis in ("order_x", "order_y"))
                   for pair in combinations(sorted(points), 2))

    def takes_away(self, other, ids, name, claims):
        same_half = "slopes" in (other[1], name[1]) or other[1] == name[1]
        if not same_half or not self.below(other[0], name[0]):
            return False
        return self.crowded or len(ids & claims_ids(claims)) >= 2

    def group_of(self, r, due):
        query = self.query(r)
        for name, claims in due.items():
            for claim in claims:
                if claim[1] == r.kind and claim[2] == r.ids and self.same_query(query, claim[0]):
                    return name
        return None

    @staticmethod
    def same_query(a, b):
        return a[0] == b[0] and normal_form(*a) == normal_form(*b)

    @staticmethod
    def below(node, t):
        while node is not None:
            if node is t:
                return True
            node = node.parent
        return False


def claims_ids(claims):
    return set().union(*(claim[2] for claim in claims))
