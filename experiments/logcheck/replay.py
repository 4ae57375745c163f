# SPDX-License-Identifier: GPL-3.0-or-later
"""What every replay of a structure has in common (level 3)."""

from log import Wrong
from subsets import own_objects


class Replay:
    """The state of one structure, advanced by the records of its log. Subclasses keep `attribute`."""

    fails_touching = ()  # predicates whose certificates fail where they touch zero, too
    partial_hull = False  # a hull of some of the points: what is read off it is not an attribute of all
    at_every_instant = False  # to be settled at all instants of the log, with or without a record of its own

    def __init__(self, checker, structure):
        self.checker, self.structure = checker, structure
        self.world = checker.world
        self.label = structure.label
        self.own = own_objects(structure.name, structure.options, self.world.scene)
        self.proofs = []
        self.begun = 0  # the step of the first proof at which the present instant began

    # Called by the checker. x: the present instant.
    def start(self, x):
        raise NotImplementedError

    def record(self, r, x):
        """An event of the structure's own, a settled or a rebuild."""
        raise NotImplementedError

    def insert(self, o, x):
        raise NotImplementedError

    def erase(self, o, x):
        raise NotImplementedError

    def settle(self, x):
        """All records of the instant x have been read: the attribute is that right after x."""

    def before_motion(self, objects, x):
        for proof in self.proofs:
            proof.before_motion(objects, x)

    def after_motion(self, objects, x):
        for proof in self.proofs:
            proof.after_motion(x)

    def finish(self, end):
        for proof in self.proofs:
            proof.finish(end)

    # For subclasses.
    def alive(self):
        """The objects that are there, of those that the structure is built from."""
        return set(self.world.alive) if self.own is None else self.world.alive & self.own

    def names(self, ids):
        return "[" + ", ".join(str(self.world.scene.ids[i]) for i in ids) + "]"

    def require(self, condition, what, *arguments):
        if not condition:
            raise Wrong(what % arguments if arguments else what)

    def require_members(self, r, count):
        self.require(len(r.ids) == count, "%s names %d objects, not %d", r.short(), len(r.ids), count)
        for i in r.ids:
            self.require(i in self.members, "%s: %s is not there", r.short(), i if isinstance(i, str)
                         else self.world.scene.ids[i])

    def query(self, r):
        """The certificate of the record, as a query; None: it has none."""
        return self.checker.query(r)

    def fails(self, query, x):
        """The claim is negative from x on; and was not before, unless its structure makes claims that fail at once."""
        return self.world.sign_after(query, x) < 0 and (
            self.structure.index in self.checker.unsettled or self.world.vanishes(query, x))
