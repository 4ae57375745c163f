# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines y = a x + b, among themselves and against points: from scratch, right after every instant that may change
the attribute."""

from functools import cmp_to_key
from itertools import combinations

from replay_members import WithTies
from replay_pairs import BoxesThatMeet
from replay_scratch import ClosestPair, Scratch


def lines_and_points(members, scene):
    """Two ascending lists."""
    return ([o for o in sorted(members) if scene.objects[o].line],
            [o for o in sorted(members) if not scene.objects[o].line])


class PointsAboveLines(BoxesThatMeet):
    """The pairs of a line and a point above it. One event, "above" or "below", for each pair that an instant
    changes."""

    partly = "internal events: pairs that change twice at one instant are not followed"
    KINDS = ("above", "below")

    def current(self, x):
        lines, points = lines_and_points(self.members, self.world.scene)
        return sorted((min(line, point), max(line, point)) for line in lines for point in points
                      if self.world.sign_after(("line_side", (line, point)), x) > 0)


class PointsOfCells(PointsAboveLines):
    """The same, from the trapezoids of a sample: events "cell" name a line or a point that goes to others."""

    partly = "internal events: the trapezoids are not followed"

    def record(self, r, x):
        if r.kind != "cell":
            super().record(r, x)
            return
        self.look = True
        self.require(not r.external and r.gone is None, "%s says nothing of the attribute", r.short())
        self.require_members(r, 1)
        self.require(not self.events, "%s: a failure after the changes that it leads to", r.short())
        if self.query(r) is not None:
            self.require(r.ids[0] in self.query(r)[1], "%s is not a failure of its object", r.short())


def line_query(measure, front, back):
    """The claim that the first pair, of a line and a point, is at most as far apart as the second, as logs write it."""
    objects = list(dict.fromkeys((*front, *back)))
    places = "".join(str(objects.index(o)) for o in (*front, *back))
    name = "order_line_" + measure
    return (name if len(objects) == 4 else f"{name}/{places}", tuple(objects))


def measure_of(name):
    return "height" if name.endswith("_vertical") else "distance"


class ClosestPointLine(ClosestPair):
    """The line and the point that are closest to each other; of equally distant ones the smallest."""

    def __init__(self, checker, structure):
        super().__init__(checker, structure)
        self.measure = measure_of(structure.name)

    def pairs(self):
        lines, points = lines_and_points(self.members, self.world.scene)
        return sorted((min(line, point), max(line, point)) for line in lines for point in points)

    def claim(self, front, back):
        objects = self.world.scene.objects
        return line_query(self.measure, *(p if objects[p[0]].line else p[::-1] for p in (front, back)))


class Signs:
    """What the arrangement of lines is, right after an instant: of each two lines the order by slope, of each
    three the sign of their triangle. Lines are raised by infinitesimals, more so the smaller the number."""

    def __init__(self, world, lines, x):
        self.lines = lines
        self.side, self.first, self.triangle = {}, {}, {}
        for i, j in combinations(lines, 2):
            side = sign(world.sign_after(("order_x", (i, j)), x))
            self.side[i, j], self.side[j, i] = side, -side
            first = side or sign(world.sign_after(("order_y", (j, i)), x)) or 1
            self.first[i, j], self.first[j, i] = first, -first
        for i, j, k in combinations(lines, 3):
            self.triangle[i, j, k] = (sign(world.sign_after(("orientation_2", (i, j, k)), x)) or self.side[j, k]
                                      or self.side[k, i] or self.side[i, j])

    def orientation(self, *ids):
        turns = sum(a > b for a, b in combinations(ids, 2))
        return self.triangle[tuple(sorted(ids))] * (-1) ** turns

    def before(self, line, m, k):
        """-1: the line crosses m before k."""
        same = self.side[line, m] == self.side[line, k]
        return -self.orientation(line, k, m) if same else -self.orientation(line, m, k)

    def orders(self):
        """By slope from above, far to the left; then for every line its parallels, itself, what it crosses."""
        rows = [tuple(sorted(self.lines, key=cmp_to_key(lambda i, j: -self.first[i, j])))] if self.lines else []
        for line, crossed in self.crossings():
            parallel = [m for m in self.lines if m != line and not self.side[line, m]]
            rows.append(tuple(parallel + [line] + crossed))
        return rows

    def crossings(self):
        """For every line those that it crosses, from left to right."""
        for line in self.lines:
            yield line, sorted((m for m in self.lines if m != line and self.side[line, m]),
                               key=cmp_to_key(lambda m, k, line=line: self.before(line, m, k)))

    def events_since(self, old):
        """None: some two lines are parallel identically, and were not, or the reverse."""
        if any((self.side[p] == 0) != (old.side[p] == 0) for p in self.side):
            return None
        pairs = [p for p in combinations(self.lines, 2) if self.first[p] != old.first[p]]
        return ([("triple", list(t)) for t in sorted(self.triangle) if self.triangle[t] != old.triangle[t]]
                + [("parallel", list(p)) for p in pairs if self.side[p]]
                + [("equal", list(p)) for p in pairs if not self.side[p]])


def sign(value):
    return (value > 0) - (value < 0)


class ArrangementOfLines(WithTies, Scratch):
    """The orders of an arrangement. One event for each triangle that turned over, each two slopes that changed
    their order, and each two parallel lines that passed through each other."""

    partly = "internal events: the lists of crossings are not followed"
    KINDS = ("triple", "parallel", "equal")
    TIES = {"order_y": "order_x"}  # of parallel lines the higher one is first

    def current(self, x):
        self.fresh = Signs(self.world, lines_and_points(self.members, self.world.scene)[0], x)
        return self.fresh.orders()

    def begin(self, x):
        super().begin(x)
        self.signs, self.events, self.difference = self.fresh, [], None

    def record(self, r, x):
        self.look = True
        self.require_members(r, len(r.ids))
        if r.kind in self.KINDS:
            self.require(r.external and r.gone is None, "%s is a change that its lines tell", r.short())
            self.events.append((r.kind, list(r.ids)))
        elif r.external:
            self.require(self.difference is None and r.kind in ("settled", "rebuild"), "%s: one too many", r.short())
            self.difference = (r.gone, r.came)
        else:
            self.require(r.gone is None, "%s says nothing of the attribute", r.short())
            if self.query(r) is not None and r.kind != "tie":
                self.require(set(self.query(r)[1]) == set(r.ids), "%s is not a failure of its lines", r.short())

    def settle(self, x):
        if not self.look:
            return
        self.look = False
        before, after = self.told, self.current(x)
        due = self.fresh.events_since(self.signs)
        names = [[self.world.scene.ids[o] for row in rows for o in row] for rows in (before, after)]
        if self.difference is None and due is None:
            self.require(before == after, "%s: right after %r the orders are others", self.label, x)
        elif self.difference is None:
            self.require(self.events == due, "%s: at %r there are %s, not %s", self.label, x, self.events, due)
        else:
            self.require(due is None, "%s: at %r its events say all, and no difference is told", self.label, x)
            self.require(list(self.difference) == names and not self.events,
                         "%s: at %r the orders change from %s to %s", self.label, x, *names)
        self.told = after
        self.signs, self.events, self.difference = self.fresh, [], None
