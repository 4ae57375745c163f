# SPDX-License-Identifier: GPL-3.0-or-later
"""sorted_list: neighbours change places. Equal keys: by number."""

from proof import Proof
from predicates import Key
from replay import Replay
from static import insertion_place, sorted_by


class SortedList(Replay):
    predicates = None

    def __init__(self, checker, structure):
        super().__init__(checker, structure)
        self.key = Key(checker.key_of(structure))
        self.bound = [self.key.predicate]
        self.proof = Proof(self.world, self.label, checker.on[4])
        self.proofs = [self.proof]
        self.pending = False
        self.watchers = []  # (replay, axis): trees that read the list

    @property
    def attribute(self):
        return list(self.order)

    def claims(self, first, last, x):
        """Makes the claims of the places first .. last anew."""
        for i in range(max(first, 0), min(last, len(self.order) - 2) + 1):
            self.proof.put(i, self.key.claim(self.order[i], self.order[i + 1]), x)

    def start(self, x):
        self.members = {o for o in self.alive() if o != self.key.reference}
        self.order = sorted_by(self.world, self.key, self.members, x)
        self.at = {o: i for i, o in enumerate(self.order)}
        self.claims(0, len(self.order), x)

    def record(self, r, x):
        if r.kind in ("settled", "rebuild"):
            return self.rebuild(r, x)
        self.require_members(r, 2)
        a, b = r.ids
        i = self.at[a]
        self.require(i + 1 < len(self.order) and self.order[i + 1] == b,
                     "%s: the second does not follow the first in the list", r.short())
        self.require(r.external, "%s is external", r.short())
        self.require(r.gone is None, "%s says all by its ids", r.short())
        claim = self.key.claim(a, b)
        if r.kind == "swap":
            self.require(self.query(r) == claim, "%s is not a failure of the order of the two", r.short())
            self.checker.failed(self, claim, self.proof.claims[i][2], x)
        else:
            self.require(self.world.is_zero(claim), "%s: the two keys are not identically equal", r.short())
            self.require(b < a, "%s: the two stand in the order of their ids", r.short())
        self.proof.step += 1
        self.order[i], self.order[i + 1] = b, a
        self.at[a], self.at[b] = i + 1, i
        self.claims(i, i, x)
        self.claims(i - 1, i - 1, x)
        self.claims(i + 1, i + 1, x)
        self.checker.touch(self)
        self.tell((a, b))

    def tell(self, swap):
        for tree, axis in self.watchers:
            tree.list_changed(axis, swap)

    def rebuild(self, r, x):
        """A rebuild: the difference is the whole list before and after."""
        fresh = sorted_by(self.world, self.key, self.members, x)
        self.checker.check_change(self, r, self.order, fresh)
        self.replace(fresh, x)
        self.tell(None)

    def replace(self, fresh, x):
        self.proof.clear(x)
        self.order = fresh
        self.at = {o: i for i, o in enumerate(fresh)}
        self.claims(0, len(fresh), x)

    def insert(self, o, x):
        self.members.add(o)
        fresh = list(self.order)
        fresh.insert(insertion_place(self.world, self.key, self.order, o, x), o)
        self.replace_around(fresh, x)

    def erase(self, o, x):
        self.members.discard(o)
        self.replace_around([i for i in self.order if i != o], x)

    def replace_around(self, fresh, x):
        self.proof.step += 1
        if len(fresh) < len(self.order) and fresh is not None and len(self.order) > 1:
            self.proof.drop(len(self.order) - 2, x)
        self.order = fresh
        self.at = {o: i for i, o in enumerate(fresh)}
        self.claims(0, len(fresh), x)

    def settle(self, x):
        for i in range(len(self.order) - 1):
            a, b = self.order[i], self.order[i + 1]
            if b < a and self.world.is_zero(self.key.claim(a, b)):
                self.require(False, "%s: %s, whose keys are identically equal, are not in the order of "
                             "their ids", self.label, self.names((a, b)))
