# SPDX-License-Identifier: GPL-3.0-or-later
"""Structures over a grid: an event "cell" moves a point to another cell of it. closest_pair_bins, disc_pairs_grid."""

from fractions import Fraction
from types import SimpleNamespace

from log import Wrong
from replay_pairs import DiscsThatMeet
from replay_scratch import ClosestPair


class OfCells:
    """With points that move to another cell of a grid; a line of it is named by its place."""

    LINES = 1 << 30  # the numbers of lines: those of objects are smaller

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
        lines = self.world.lines
        if name not in lines:
            try:
                at = Fraction(name[2:])
            except ValueError:
                raise Wrong("%s is no line" % name)
            lines[name] = self.LINES + len(lines)
            level = (at.numerator,) if at else ()
            axes = 2 * self.world.scene.dimension  # extents included
            self.world.set_motion(lines[name], SimpleNamespace(denominator=at.denominator,
                                                               polynomials=[level] * axes))
        return lines[name]

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


class DiscsOfCells(OfCells, DiscsThatMeet):
    """The same, among discs in neighbouring cells."""

    def record(self, r, x):
        if r.kind != "cell":
            super().record(r, x)
            return
        self.look = True
        self.moved(r)
        self.require(not r.external and r.gone is None, "%s says nothing of the attribute", r.short())
