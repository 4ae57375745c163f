# SPDX-License-Identifier: GPL-3.0-or-later
"""maximum_* and minimum_*: the object with the largest, or smallest, key; of equal ones the smallest.

All six report the same changes: if the winners right before and right after an instant differ, there is one
external event. Changes inside a heap, a tree or a tournament are internal; these structures are replayed here
too, so that every internal event is checked.
"""

from log import Wrong
from predicates import Key
from proof import Proof
from replay_members import OfMembers
from roots import compare


class Maximum(OfMembers):
    """The winner as reported so far, and a proof that it is the best: a claim against every other object."""

    ties = False  # may report a change of the winner as a tie

    def __init__(self, checker, structure):
        super().__init__(checker, structure)
        self.largest = structure.name.startswith("maximum_")
        self.key = Key(checker.key_of(structure))
        self.bound = [self.key.predicate]
        self.proof = Proof(self.world, self.label, checker.on[4])
        self.proofs = [self.proof]
        self.changed = 0  # changes of the winner reported since the instant was settled
        self.told = None
        self.look = True

    @property
    def attribute(self):
        return [] if self.told is None else [self.told]

    def claim(self, winner, loser):
        return self.key.claim(loser, winner) if self.largest else self.key.claim(winner, loser)

    def beats(self, a, b, x):
        sign = self.world.sign_after(self.claim(a, b), x)
        return sign > 0 or (sign == 0 and a < b)

    def best(self, x):
        winner = None
        for o in sorted(self.members):
            if winner is None or self.beats(o, winner, x):
                winner = o
        return winner

    def everyone(self):
        return {o for o in self.alive() if o != self.key.reference}

    def begin(self, x):
        self.told = self.best(x)
        self.changed = 0
        self.look = True

    def tell(self, r):
        """The record reports another winner."""
        old, fresh = r.ids
        self.require(old == self.told and old != fresh, "%s: the winner so far was %s", r.short(),
                     self.names(self.attribute))
        self.require(not self.changed, "%s: the winner changes a second time at one instant", r.short())
        self.told = fresh
        self.changed += 1
        self.look = True

    def change(self, r, x):
        """A settled or rebuild record."""
        fresh = self.best(x)
        self.checker.check_change(self, r, self.attribute, [] if fresh is None else [fresh])
        if fresh != self.told:
            self.told = fresh
            self.changed += 1
        self.look = True

    def record(self, r, x):
        if r.kind in ("settled", "rebuild"):
            return self.change(r, x)
        self.require_members(r, 2)
        self.require(r.gone is None, "%s says all by its ids", r.short())
        self.event(r, x)

    def event(self, r, x):
        """Structures whose only events are changes of the winner."""
        self.require(r.external, "%s is external", r.short())
        claim = self.claim(r.ids[0], r.ids[1])
        if r.kind == "tie":
            self.require(self.world.is_zero(claim), "%s: the two keys are not identically equal", r.short())
            self.require(r.predicate is None, "%s is no failure", r.short())
        elif self.certain:
            self.require(self.query(r) == claim, "%s is not a failure of the order of the two", r.short())
        else:
            self.require(r.predicate is None, "%s has no certificate of its own", r.short())
        self.tell(r)

    certain = True  # its events have certificates

    def settle(self, x):
        self.changed = 0
        if not self.look:
            return
        self.look = False
        winner = self.told
        if winner is None:
            self.require(not self.members, "%s: there are objects, but no winner", self.label)
            self.proof.clear(x)
            return
        for o in list(self.proof.claims):
            if o == winner or o not in self.members:
                self.proof.drop(o, x)
        for o in sorted(self.members):
            if o == winner:
                continue
            claim = self.claim(winner, o)
            self.proof.put(o, claim, x)
            failure = self.proof.claims[o][1]
            if failure is not None and compare(failure, x) <= 0:
                raise Wrong("%s: the winner right after %r is said to be %s, but %s is better" % (
                    self.label, x, self.names([winner]), self.names([o])))
            if o < winner and self.world.is_zero(claim):
                raise Wrong("%s: the winner is said to be %s, but the key of %s is identically equal" % (
                    self.label, self.names([winner]), self.names([o])))


class OfList(Maximum):
    """Read off a sorted list: it has no certificates of its own."""

    certain = False


class Tree(Maximum):
    """Structures with a proof of their own; its failures are internal events, unless one reports the change."""

    ties = True

    def __init__(self, checker, structure):
        super().__init__(checker, structure)
        self.inside = Proof(self.world, self.label, checker.on[4])
        self.proofs = [self.inside, self.proof]
        self.pending = None  # (kind, ids, query) of the failure that is being repaired

    def place_of(self, query):
        """The place of the live claim, or None."""
        for place, claim in self.inside.claims.items():
            if claim[0] == query:
                return place
        return None

    def event(self, r, x):
        query = self.query(r)
        if query is not None and r.kind != "tie" and self.pending is None and not self.told_by(r, query):
            self.fail(query, r, x)
        elif query is not None and r.kind == "tie" and self.pending is None:
            self.fail(query, r, x)
        if r.kind == "tie":
            self.require(not r.external, "%s is internal", r.short())
            self.tie(r, query, x)
            return
        if self.pending is not None and r.kind == self.pending[0]:
            self.require(r.ids == self.pending[1] and query == self.pending[2],
                         "%s: due was %s %s", r.short(), self.pending[0], self.names(self.pending[1]))
            self.finished = self.pending[2]
            self.pending = None
            if r.external:
                self.tell(r)
                self.require(self.winner() == self.told, "%s: %s is not the winner inside", r.short(),
                             self.names([self.told]))
            return
        self.require(r.kind == "replace" and self.pending is None, "%s: no repair leads to it", r.short())
        self.require(r.external, "%s is external", r.short())
        self.tell(r)

    def told_by(self, r, query):
        """A replace that reports the outcome of the failure just repaired, with the same certificate."""
        return r.kind == "replace" and query == self.finished and self.place_of(query) is None

    finished = None

    def fail(self, query, r, x):
        place = self.place_of(query)
        self.require(not self.changed, "%s: a failure after the change of the winner that ends the instant",
                     r.short())
        self.require(place is not None, "%s: the certificate is not part of the proof", r.short())
        self.checker.failed(self, query, self.inside.claims[place][2], x)
        self.inside.step += 1
        self.finished = None
        self.repair(place, query, x)

    def settle(self, x):
        self.require(self.pending is None, "%s: a failure was repaired, and no event says so", self.label)
        self.finished = None
        self.require(self.winner() == self.told, "%s: the winner is said to be %s; inside it is %s", self.label,
                     self.names(self.attribute), "none" if self.winner() is None else self.names([self.winner()]))
        self.check_ties()
        super().settle(x)

    def check_ties(self):
        for query, first, second in self.pairs():
            if second < first and self.world.is_zero(query):
                raise Wrong("%s: the keys of %s are identically equal, and the larger id wins" % (
                    self.label, self.names((first, second))))
