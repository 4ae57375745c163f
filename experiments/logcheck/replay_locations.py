# SPDX-License-Identifier: GPL-3.0-or-later
"""points_in_arrangement: for every point the next line above it and the next one below it, from scratch.

Events "above" and "below", at the end of an instant, name a point, the line that was next to it and the one that is;
the point itself where there is none. The proof that is followed, and that each event "move" is a failure of: a point
is below the line above it, or above the one below it, and between two crossings of it that are neighbours.

A point that is on a line identically is below it; of two lines that are at one height above it identically the one
with the smaller number is the higher one.
"""

from proof import Proof
from replay_lines import Signs, lines_and_points
from replay_scratch import Scratch


class LinesNextToPoints(Scratch):
    bound = ["line_side", "line_under", "line_order"]
    partly = None
    at_every_instant = True

    def __init__(self, checker, structure):
        super().__init__(checker, structure)
        self.proof = Proof(self.world, self.label, checker.on[4])
        self.proofs = [self.proof]
        self.events, self.failed = [], []

    @property
    def attribute(self):
        return [o for p, *next_to in self.told for o in (p, *(p if line is None else line for line in next_to))]

    # ---- from scratch

    def is_higher(self, l, m, p, x):
        """m than l, above p."""
        sign = self.world.sign_after(("line_order", (l, m, p)), x)
        return sign > 0 or (sign == 0 and m < l)

    def current(self, x):
        """[(point, line above, line below)], None where there is no line."""
        lines, points = lines_and_points(self.members, self.world.scene)
        result = []
        for p in points:
            above = below = None
            for l in lines:
                if self.world.sign_after(("line_side", (l, p)), x) > 0:
                    if below is None or self.is_higher(below, l, p, x):
                        below = l
                elif above is None or self.is_higher(l, above, p, x):
                    above = l
            result.append((p, above, below))
        return result

    def claims(self, x):
        """{place: query} of the proof for `told`."""
        lines, _ = lines_and_points(self.members, self.world.scene)
        signs = Signs(self.world, lines, x)
        crossings = dict(signs.crossings())
        result = {}
        for p, *next_to in self.told:
            for place, line in enumerate(next_to):
                if line is None:
                    continue
                result[p, place, "side"] = ("line_side" if place else "line_under", (line, p))
                before = after = None
                for m in crossings[line]:
                    if self.is_higher(line, m, p, x) == (signs.side[line, m] > 0):
                        before = m
                    elif after is None:
                        after = m
                for m, is_before in ((before, True), (after, False)):
                    if m is not None:
                        pair = (line, m) if is_before == (signs.side[line, m] > 0) else (m, line)
                        result[p, place, is_before] = ("line_order", (*pair, p))
        return result

    def prove(self, x):
        claims = self.claims(x)
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
        elif r.kind == "move":
            self.move(r, x)
        else:
            self.require(r.external and r.gone is None, "%s is a change that its objects tell", r.short())
            self.events.append((r.kind, r.ids))

    def move(self, r, x):
        self.require(not r.external and r.gone is None, "%s is internal", r.short())
        self.require(not self.events, "%s: a failure after the changes that it leads to", r.short())
        self.require_members(r, 1)
        query = self.query(r)
        places = [place for place, claim in self.proof.claims.items()
                  if place[0] == r.ids[0] and claim[0] == query and place not in self.failed]
        self.require(places, "%s: its certificate is not part of the proof", r.short())
        self.failed.append(places[0])
        self.checker.failed(self, query, self.proof.claims[places[0]][2], x)

    def settle(self, x):
        failing = self.proof.failing(x)
        self.require(set(failing) == set(self.failed), "%s: at %r other claims fail than the events say", self.label, x)
        before, self.told = self.told, self.current(x)
        due = []
        for (p, *was), (_, *now) in zip(before, self.told):
            due += [(kind, tuple(p if line is None else line for line in (p, old, new)))
                    for kind, old, new in zip(("above", "below"), was, now) if old != new]
        self.require([(kind, tuple(ids)) for kind, ids in self.events] == due,
                     "%s: at %r there are %s, not %s", self.label, x, self.events, due)
        self.events, self.failed = [], []
        self.prove(x)
