# SPDX-License-Identifier: GPL-3.0-or-later
"""octants_listed, octants_local, cones_local: the pairs of a point and the next one in a cone, from scratch right after every
instant. Every event "point" names a point, the one that was next in a cone of it and the one that is (itself: none),
and the pairs that left or joined the attribute, if any. Each pointer that differs has one event, and no other has."""

from fractions import Fraction

from octants import AXES, OCTANTS, pairs_of_pointers, pointers_of, precedes_by
from parameters import value_of
from polygons import all_vectors, cones, counted, precedes_along
from proof import Proof
from replay_members import ByTurnedOrders


def corners_of(structure):
    """Of cones_local, or of a tree that reads it."""
    options = structure.options or {}
    if structure.name != "cones_local":
        over = options.get("over")
        options = over if isinstance(over, dict) else {}
    return int(value_of("cones_local", options, "corners", lambda x: Fraction(str(x))))


class Octants(ByTurnedOrders):
    bound = []

    def __init__(self, checker, structure):
        super().__init__(checker, structure)
        self.lists = structure.name == "octants_listed"
        self.pointers, self.pairs, self.missing = {}, [], None
        self.proofs = [Proof(self.world, self.label, checker.on[4])]  # without claims
        checker.note_partly(self.label, "internal events: lists and certificates are not followed")

    def directions(self):
        return AXES

    def meanings(self, name, ids):
        if name == "order_direction":
            return [(axis, ids) for axis in AXES[2:]]
        return [(name, ids)]

    @property
    def attribute(self):
        return list(self.pairs)

    def current(self, x):
        def sign(axis, a, b):
            return self.world.sign_after((AXES[axis], (a, b)), x)

        return pointers_of(sorted(self.members), precedes_by(sign))

    def pairs_of(self, pointers):
        return pairs_of_pointers(pointers, OCTANTS)

    def begin(self, x):
        self.pointers, self.look, self.missing = self.current(x), False, None
        self.pairs = self.pairs_of(self.pointers)

    def differing(self, fresh):
        """The events "point" of an instant, in their order."""
        result = []
        for p, cone in sorted(set(self.pointers) | set(fresh)):
            old, new = self.pointers.get((p, cone), p), fresh.get((p, cone), p)
            if old != new:
                result.append([p, old, new])
        return result

    def record(self, r, x):
        self.look = True
        if r.kind == "rebuild":
            fresh = self.current(x)
            pairs = self.pairs_of(fresh)
            self.sides(r, sorted(set(self.pairs) - set(pairs)), sorted(set(pairs) - set(self.pairs)))
            self.pointers, self.pairs, self.missing = fresh, pairs, None
            return
        if r.kind != "point":
            self.require_members(r, 2)
            self.require(not r.external and r.gone is None, "%s says nothing of the attribute", r.short())
            self.require_order(r)
            return
        self.require_members(r, 3)
        if self.missing is None:
            self.fresh = self.current(x)
            self.missing = self.differing(self.fresh)
            pairs = self.pairs_of(self.fresh)
            self.leaving, self.joining = set(self.pairs) - set(pairs), set(pairs) - set(self.pairs)
        self.require(self.missing and self.missing[0] == list(r.ids), "%s: the next change is %s", r.short(),
                     self.names(self.missing[0]) if self.missing else "none")
        p, old, new = self.missing.pop(0)
        gone, came = tuple(sorted((p, old))), tuple(sorted((p, new)))
        if not r.external:
            self.require(r.gone is None, "%s says nothing of the attribute", r.short())
            return
        self.require(r.gone is not None and r.came is not None, "%s: what has changed?", r.short())
        ids = self.world.scene.ids
        said = [[tuple(ids.index(name) for name in pair) for pair in side] for side in (r.gone, r.came)]
        self.require(said[0] in ([], [gone]) and said[1] in ([], [came]) and said != [[], []],
                     "%s: other pairs than the ones of its pointers", r.short())
        self.require(set(said[0]) <= self.leaving and set(said[1]) <= self.joining,
                     "%s: a pair that does not change", r.short())
        self.leaving -= set(said[0])
        self.joining -= set(said[1])
        self.pairs = sorted(set(self.pairs) - set(said[0]) | set(said[1]))

    def sides(self, r, gone, came):
        ids = self.world.scene.ids
        sides = [[[ids[a], ids[b]] for a, b in side] for side in (gone, came)]
        if gone or came:
            self.require([r.gone, r.came] == sides, "%s: the pairs change by %s and %s", r.short(), *sides)
        else:
            self.require(r.gone is None, "%s: nothing has changed", r.short())

    def settle(self, x):
        if not self.look:
            return
        self.look = False
        fresh = self.current(x)
        if self.missing is not None:
            self.require(not self.missing, "%s: right after %r a change is missing", self.label, x)
            self.pointers, self.missing = self.fresh, None
        self.require(self.pointers == fresh, "%s: right after %r other points are next", self.label, x)
        self.require(self.pairs == self.pairs_of(fresh), "%s: right after %r the pairs are others", self.label, x)

    def finish(self, end):
        super().finish(end)
        if end is not None:
            self.require(self.pointers == self.current(end), "%s: right after the end other points are next",
                         self.label)


class Cones(Octants):
    """cones_local: the cones of a polygon."""

    def directions(self):
        return [("order_direction", u) for u in all_vectors(corners_of(self.structure))]

    def meanings(self, name, ids):
        if name == "order_direction":
            return [(direction, ids) for direction in self.directions()]
        return [(name, ids)]

    def current(self, x):
        def sign(u, a, b):
            return self.world.sign_after((("order_direction", u), (a, b)), x)

        return pointers_of(sorted(self.members), precedes_along(sign), cones(corners_of(self.structure)))

    def pairs_of(self, pointers):
        return pairs_of_pointers(pointers, counted(corners_of(self.structure)))
