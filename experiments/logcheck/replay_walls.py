# SPDX-License-Identifier: GPL-3.0-or-later
"""trapezoids_2: for every two lines that cross the next line above their crossing and the next one below it, from
scratch.

Events "wall_up" and "wall_down", at the end of an instant, name the two lines, the line that was next and the one that
is; the first line again where there is none. The proof that is followed, and that each event "wall_pass" is a failure
of: in a face, of two neighbouring crossings of which one has the face above it and the other one below it, which one is
to the left.
"""

from functools import cmp_to_key
from itertools import combinations

from proof import Proof
from replay_lines import Signs, lines_and_points, sign
from replay_scratch import Scratch


class Walls(Signs):
    """The same, and where walls from crossings end. A crossing is a pair of lines, the less steep one first."""

    def __init__(self, world, lines, x):
        super().__init__(world, lines, x)
        self.world, self.x, self.memo = world, x, {}
        self.rows = dict(self.crossings())

    def pairs(self):
        return [p for p in combinations(self.lines, 2) if self.side[p]]

    def by_slope(self, l, m):
        return (l, m) if self.side[l, m] > 0 else (m, l)

    def difference(self, a, b, c, d):
        """Of the heights of d and c where a and b cross: its sign; four different lines."""
        key = (a, b, c, d)
        if key not in self.memo:
            steep = self.side[c, d]  # if a is raised the crossing goes to the right
            parts = sorted([(a, steep), (b, -steep), (c, -1), (d, 1)])
            self.memo[key] = (sign(self.world.sign_after(("slope_order_2", key), self.x))
                              or next(part for _, part in parts if part))
        return self.memo[key]

    def next_lines(self, pair):
        """The lines next to a crossing, above and below; None: there is none."""
        a, b = self.by_slope(*pair)
        above = [h for h in self.lines if h not in pair and self.orientation(a, b, h) > 0]
        below = [h for h in self.lines if h not in pair and self.orientation(a, b, h) < 0]
        order = cmp_to_key(lambda c, d: -self.difference(a, b, c, d))
        return min(above, key=order, default=None), max(below, key=order, default=None)

    def is_left(self, v, w):
        """Crossing v of crossing w."""
        shared = set(v) & set(w)
        if shared:
            line = shared.pop()
            own, other = (next(m for m in pair if m != line) for pair in (v, w))
            return self.before(line, own, other) < 0
        (a, b), (c, d) = self.by_slope(*v), self.by_slope(*w)
        # At the crossing of c and d the steeper line b is above a, or that of a and b is to the right.
        return self.difference(c, d, a, b) > 0

    def links(self, ends):
        """{(crossing, is it below the face): the next crossing of its face}, if that is on the other side."""
        result = {}
        for pair, nexts in ends.items():
            v = self.by_slope(*pair)
            for lower, end in zip((True, False), nexts):
                if end is None:
                    continue
                steep = 1 if lower else -1
                first, last = v if lower else v[::-1]  # the lines of its own chain, from left to right
                across = next((m for m in self.rows[end] if self.is_left(v, (end, m))), None)
                if across is None or self.side[end, across] * steep > 0:
                    continue
                row = self.rows[last]
                own = next(iter(row[row.index(first) + 1:]), None)
                if own is not None and self.side[last, own] * steep > 0 and self.is_left((last, own), (end, across)):
                    continue
                result[pair, lower] = (end, across)
        return result

    def claim(self, v, w):
        """v is to the left of w."""
        return ("slope_order_2", self.by_slope(*w) + self.by_slope(*v))


class WallsOfLines(Scratch):
    bound = ["slope_order_2"]
    partly = None
    at_every_instant = True

    def __init__(self, checker, structure):
        super().__init__(checker, structure)
        self.proof = Proof(self.world, self.label, checker.on[4])
        self.proofs = [self.proof]
        self.events, self.failed = [], []

    @property
    def attribute(self):
        return [o for pair, nexts in self.told for o in (*pair, *(pair[0] if h is None else h for h in nexts))]

    def current(self, x):
        """[(two lines, (line above, line below))], None where there is no line."""
        self.walls = Walls(self.world, lines_and_points(self.members, self.world.scene)[0], x)
        return [(pair, self.walls.next_lines(pair)) for pair in self.walls.pairs()]

    def prove(self, x):
        claims = {place: self.walls.claim(place[0], following)
                  for place, following in self.walls.links(dict(self.told)).items()}
        for place in list(self.proof.claims):
            if place not in claims:
                self.proof.drop(place, x)
        for place, query in claims.items():
            self.proof.put(place, query, x)

    # ---- records

    def begin(self, x):
        super().begin(x)
        self.events, self.failed = [], []
        self.proof.step += 1
        self.prove(x)

    def record(self, r, x):
        if r.kind in ("settled", "rebuild"):
            fresh = self.current(x)
            before, self.told = self.attribute, fresh
            self.checker.check_change(self, r, before, self.attribute)
        elif r.kind == "wall_pass":
            self.passed(r, x)
        else:
            self.require(r.external and r.gone is None, "%s is a change that its objects tell", r.short())
            self.events.append((r.kind, tuple(r.ids)))

    def passed(self, r, x):
        self.require(not r.external and r.gone is None, "%s is internal", r.short())
        self.require(not self.events, "%s: a failure after the changes that it leads to", r.short())
        self.require_members(r, 4)
        query = self.query(r)
        places = [place for place, claim in self.proof.claims.items()
                  if claim[0] == query and place not in self.failed]
        self.require(places and set(places[0][0]) == set(r.ids[:2]) and set(query[1]) == set(r.ids),
                     "%s: its certificate is not part of the proof", r.short())
        self.failed.append(places[0])
        self.checker.failed(self, query, self.proof.claims[places[0]][2], x)

    def settle(self, x):
        failing = self.proof.failing(x)
        self.require(set(failing) == set(self.failed), "%s: at %r other claims fail than the events say", self.label, x)
        before, self.told = self.told, self.current(x)
        due = []
        if [pair for pair, _ in before] == [pair for pair, _ in self.told]:
            for (pair, was), (_, now) in zip(before, self.told):
                due += [(kind, (*pair, *(pair[0] if h is None else h for h in (old, new))))
                        for kind, old, new in zip(("wall_up", "wall_down"), was, now) if old != new]
        self.require(self.events == due, "%s: at %r there are %s, not %s", self.label, x, self.events, due)
        self.events, self.failed = [], []
        self.prove(x)
