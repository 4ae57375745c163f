# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangulations as sets of cells: every event changes the cells as its ids say, and right after every instant that has
a record they are those of the definition.

The proof: every cell is upright; no point beyond a facet between two cells is inside the sphere of the other one (below
its plane); at every ridge of the hull the next facet is on the inner side. A point that is in no cell is inside no
sphere, and not beyond the hull. Locally Delaunay, or regular, everywhere is so globally.
"""

from itertools import combinations

from log import Wrong
from replay_members import WithTies
from replay_scratch import Scratch

# Kinds of events by which one cell joins or leaves at the hull: whether it joins, and of its facets those on the hull
# until then: without a point of the first group of ids, or of the second one.
AT_HULL = {"enter": (False, 0), "leave": (True, 1), "hull_2_3": (True, 0), "hull_3_2": (False, 1),
           "show": (True, 0), "hide": (False, 1)}
# Kinds whose first group has two points; of all others it has one. Both groups ascend.
TWO_FIRST = ("flip", "flip_2_3", "flip_3_2", "hull_2_3", "hull_3_2")


def groups_of(kind, ids):
    first = 2 if kind in TWO_FIRST else 1
    return ids[:first], ids[first:]


class Cells(WithTies, Scratch):
    SIZES = {}   # of each kind of flip, the numbers of points that it may name
    OTHERS = {}  # the same of events that change no cell
    CORNERS = 4  # of a cell

    def signs(self):
        """The predicates of an upright cell, and of a point inside its sphere, or below its plane."""
        raise NotImplementedError

    def doubt(self, r, x, what):
        """The claim of a tie is an orientation of some of the points; a new flight plan has put them all on one sphere."""
        upright, inside = self.signs()
        if (self.moved_at is x and self.query(r)[0] == upright and len(r.ids) == self.CORNERS + 1
                and self.world.is_zero((inside, r.ids))):
            return
        super().doubt(r, x, what)

    # ---- the proof

    def begin(self, x):
        super().begin(x)
        self.proofs[0].step += 1
        self.prove(x)

    def settle(self, x):
        look = self.look
        super().settle(x)
        if look:
            self.prove(x)

    def prove(self, x):
        proof, claims = self.proofs[0], self.claims(x)
        for place in list(proof.claims):
            if place not in claims:
                proof.drop(place, x)
        for place, query in claims.items():
            proof.put(place, query, x)

    def claims(self, x):
        """{place: query} for the cells told, which are those right after x."""
        upright, inside = self.signs()
        result, hull = {}, {}
        side = {cell: self.world.sign_after((upright, cell), x) for cell in self.told}
        cells_at = self.by_facet(self.told, self.CORNERS - 1)
        for cell in self.told:
            result[cell] = self.claim(upright, cell, side[cell])
        for facet, cells in cells_at.items():
            apexes = [next(o for o in cell if o not in facet) for cell in cells]
            if len(cells) == 1:
                hull[facet] = self.world.sign_after((upright, (*facet, *apexes)), x)
                continue
            for cell, apex in zip(cells, apexes[::-1]):
                result[cell, apex] = self.claim(inside, (*cell, apex), -side[cell])
        for facets in self.by_facet(hull, self.CORNERS - 2).values():
            for facet, other in zip(facets, facets[::-1]):
                apex = next(o for o in other if o not in facet)
                result[facet, apex] = self.claim(upright, (*facet, apex), hull[facet])
        for o in self.members.difference(*map(set, self.told)):
            result.update(((cell, o), self.claim(inside, (*cell, o), -side[cell])) for cell in self.told)
            result.update(((facet, o), self.claim(upright, (*facet, o), sign)) for facet, sign in hull.items())
        return result

    @staticmethod
    def by_facet(cells, size):
        """{facet of this size: the cells, or facets, that have it}."""
        result = {}
        for cell in cells:
            for facet in combinations(cell, size):
                result.setdefault(facet, []).append(cell)
        return result

    @staticmethod
    def claim(name, ids, sign):
        """That name(ids) has this sign: an exchange of two ids changes it."""
        return (name, ids if sign > 0 else (ids[1], ids[0], *ids[2:]))

    def record(self, r, x):
        self.look = True
        if r.kind in self.OTHERS:
            self.require(len(set(r.ids)) == len(r.ids) in self.OTHERS[r.kind] and r.gone is None,
                         "%s: not the points of such an event", r.short())
            self.require(not r.external, "%s is internal", r.short())
            return
        if r.kind in self.SIZES:
            self.require(len(r.ids) in self.SIZES[r.kind], "%s: not the points of such an event", r.short())
            self.require_members(r, len(r.ids))
            self.require(r.external and r.gone is None, "%s is external and says all by its ids", r.short())
            self.require(all(list(group) == sorted(group) for group in groups_of(r.kind, r.ids)),
                         "%s: its points are not in the prescribed order", r.short())
            if r.kind in AT_HULL and len(r.ids) == self.CORNERS:
                self.at_hull(r)
            query = self.query(r)
            self.require(query is not None and self.is_failure(query, r.kind, r.ids),
                         "%s is not a failure of its points", r.short())
            gone, came = self.change(r.kind, r.ids)
        elif r.gone is None:
            self.require(not r.external, "%s is external and changes nothing", r.short())
            return
        else:
            number = {name: o for o, name in enumerate(self.world.scene.ids)}
            gone, came = ([tuple(number[name] for name in cell) for cell in side] for side in (r.gone, r.came))
        told = set(self.told)
        if not told.issuperset(gone) or not told.isdisjoint(came):
            raise Wrong("%s: a cell leaves that is not there, or joins that is" % r.short())
        self.told = sorted(told.difference(gone).union(came))

    def at_hull(self, r):
        joins, side = AT_HULL[r.kind]
        for i, group in enumerate(groups_of(r.kind, r.ids)):
            for o in group:
                facet = set(r.ids) - {o}
                cells = sum(facet.issubset(cell) for cell in self.told)
                due = 1 if i == side else 0 if joins else 2
                self.require(cells == due, "%s: %s has %d cells until then, not %d", r.short(),
                             self.names(sorted(facet)), cells, due)

    def is_failure(self, query, kind, ids):
        return set(query[1]) == set(ids)
