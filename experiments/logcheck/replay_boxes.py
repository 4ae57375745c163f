# SPDX-License-Identifier: GPL-3.0-or-later
"""min_area_rectangle_directions and min_perimeter_rectangle_directions, from scratch right after every instant that
has a record: of k boxes with sides along fixed directions the smallest one, as the four objects that touch it. Of
boxes that are identically equal the one of the first direction; none if all objects are one.

An event "overtake" names the four objects of the box that was the smaller one and those of the box that is.
"""

from functools import lru_cache

from extremes import extreme
from log import Wrong
from predicates import places_of
from replay_directions import LooksAlong, half_directions, k_of, opposite
from replay_scratch import Scratch


@lru_cache(maxsize=None)
def boxes(k):
    """For each box the four directions in which objects touch it."""
    return [(u, opposite(u), (-u[1], u[0]), (u[1], -u[0])) for u in half_directions(k)[:k]]


def box_order(name, one, other):
    """The claim that the second box is at least as large as the first, each a direction and its four objects."""
    return ((name, one[0], other[0]), (*one[1], *other[1]))


class RectangleAlong(LooksAlong, Scratch):
    bound = ["order_direction"]
    partly = "internal events: the duels of its tournaments are not followed"

    @property
    def order(self):
        """The name of the order of two boxes."""
        return "order_box_area" if self.structure.name.startswith("min_area") else "order_box_perimeter"

    def meanings(self, name, ids):
        if name == "order_direction":
            yield from super().meanings(name, ids)
            return
        named = self.named(name, ids)
        if named is None:
            return
        first, second = named[:4], named[4:]
        sides = [box[0] for box in boxes(k_of(self.structure))]
        for i, u in enumerate(sides):
            for v in sides[i + 1:]:
                yield box_order(self.order, (u, first), (v, second))
                yield box_order(self.order, (v, second), (u, first))

    def named(self, name, ids):
        """The objects of both boxes, by a predicate of two boxes and the objects that it names, each once."""
        places = places_of(name, 8) if name.partition("/")[0] == self.order else None
        return tuple(ids[i] for i in places) if places and max(places) + 1 == len(ids) else None

    def current(self, x):
        best = None
        for box in boxes(k_of(self.structure)) if self.members else []:
            one = (box[0], tuple(extreme(self.world, self.members, u, x) for u in box))
            if best is None or self.world.sign_after(box_order(self.order, best, one), x) < 0:
                best = one
        return [] if best is None or len(set(best[1])) == 1 else list(best[1])

    def record(self, r, x):
        super().record(r, x)
        if r.kind == "rebuild":
            self.extremes.begin(x)

    def event(self, r, x):
        if r.kind == "replace" or (r.kind == "tie" and len(r.ids) == 2):
            self.require_members(r, 2)
            self.extremes.record(r, x)
            return
        self.require_members(r, 8)
        was, now = tuple(r.ids[:4]), tuple(r.ids[4:])
        query = self.query(r)
        all_boxes = list(enumerate(boxes(k_of(self.structure))))
        for i, one in all_boxes:
            for j, other in all_boxes:
                if i == j or not self.touch(one, was, x) or not self.touch(other, now, x):
                    continue
                claim = box_order(self.order, (one[0], was), (other[0], now))
                if r.kind == "tie":
                    if j < i and self.world.is_zero(claim):
                        return
                elif self.fails(claim, x) and (
                        query is None or self.named(*query) == (was + now if i < j else now + was)):
                    return
        raise Wrong("%s: no two boxes of these objects change their order" % r.short())

    def touch(self, box, objects, x):
        return all(self.extremes.may_be(u, o, x) for u, o in zip(box, objects))
