# SPDX-License-Identifier: GPL-3.0-or-later
"""The pair of discs of the smallest gap, while no two meet."""

from functools import cmp_to_key
from itertools import combinations

from replay_pairs import discs_meet
from replay_scratch import ClosestPair

# Of two pairs of discs; each vanishes where the order of their gaps can change.
GAP_TERMS = ("radius_order", "gap_left", "gap_right", "gap_product")


def gap_query(term, front, back):
    """The claim about two pairs that may share a disc, as logs write it."""
    objects = list(dict.fromkeys((*front, *back)))
    places = "".join(str(objects.index(o)) for o in (*front, *back))
    return (term if len(objects) == 4 else f"{term}/{places}", tuple(objects))


def gap_order(sign):
    """The sign of sqrt(B) + s - sqrt(A), by those of s, B + s^2 - A, B - s^2 - A and (A - B - s^2)^2 - 4 s^2 B."""
    if sign("radius_order") >= 0:
        # A - B - s^2 against 2 s sqrt(B).
        return 1 if sign("gap_left") > 0 else -sign("gap_product")
    # 2 |s| sqrt(A) against B - s^2 - A.
    return -1 if sign("gap_right") < 0 else sign("gap_product")


class ClosestDiscs(ClosestPair):
    """None while two discs meet. Of pairs of equal gaps the smallest."""

    def order(self, front, back, x):
        return gap_order(lambda term: self.world.sign_after(gap_query(term, front, back), x))

    def current(self, x):
        pairs = list(combinations(sorted(self.members), 2))
        if not pairs or any(discs_meet(self.world, pair, x) for pair in pairs):
            return []
        best = pairs[0]
        for pair in pairs[1:]:
            if self.order(pair, best, x) > 0:
                best = pair
        return [best]

    def event(self, r, x):
        if r.kind in ("contact", "apart"):
            self.require_members(r, 2)
            pair = [[self.world.scene.ids[o] for o in r.ids]]
            self.require([r.gone, r.came] == ([pair, []] if r.kind == "contact" else [[], pair]),
                         "%s: another pair comes or goes than its own", r.short())
        elif r.kind in ("case", "touch"):
            self.require_members(r, 2)
            self.require(not r.external, "%s changes nothing", r.short())
            if self.query(r) is not None:
                self.require(set(r.ids) <= set(self.query(r)[1]), "%s is not a failure of a claim about the pair",
                             r.short())
        elif r.kind == "tie":
            self.require_members(r, 4)
            order = self.order(tuple(r.ids[:2]), tuple(r.ids[2:]), x)
            self.require(order == 0, "%s: the gaps are not identically equal", r.short())
        else:
            super().event(r, x)


def closest_discs(positions):
    """At rational positions, whose half(0) is the radius."""
    pairs = list(combinations(sorted(positions), 2))

    def measures(pair):
        p, q = (positions[o] for o in pair)
        return sum((a - b) ** 2 for a, b in zip(p, q)), p.half(0) + q.half(0)

    def order(one, other):
        (square, reach), (other_square, other_reach) = measures(one), measures(other)
        s = reach - other_reach
        values = {"radius_order": s, "gap_left": other_square + s * s - square,
                  "gap_right": other_square - s * s - square,
                  "gap_product": (square - other_square - s * s) ** 2 - 4 * s * s * other_square}
        return -gap_order(lambda term: (values[term] > 0) - (values[term] < 0))

    if not pairs or any(square <= reach * reach for square, reach in map(measures, pairs)):
        return []
    return [min(pairs, key=cmp_to_key(order))]
