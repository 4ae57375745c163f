# SPDX-License-Identifier: GPL-3.0-or-later
"""width_2 and the smallest rectangles, from scratch: of every edge of the hull the vertices that calipers
flush with it touch, and the best of these. Their own events are checked at level 2 only."""

from replay_scratch import Scratch
from static import hull


class Flush(Scratch):
    order = ""  # "the first is at most as large", of two candidates

    def current(self, x):
        cycle = hull(self.world, self.members, x)
        best = None
        if len(cycle) < 3:
            return []
        for i in sorted(range(len(cycle)), key=lambda i: cycle[i]):
            a, b = cycle[i], cycle[(i + 1) % len(cycle)]
            candidate = (a, b) + self.contacts(a, b, sorted(cycle), x)
            if best is None or self.world.sign_after((self.order, candidate + best), x) > 0:
                best = candidate
        return list(best)

    def farthest(self, predicate, a, b, points, x):
        """In the direction from a to b, or to its left; of equally far ones the smallest number."""
        best = points[0]
        for p in points[1:]:
            if self.world.sign_after((predicate, (a, b, best, p)), x) > 0:
                best = p
        return best

    def event(self, r, x):
        """The proof is not followed."""


class Width(Flush):
    order = "order_strip"

    def contacts(self, a, b, points, x):
        return (self.farthest("slope_order_2", a, b, points, x),)


class Rectangle(Flush):
    def contacts(self, a, b, points, x):
        return (self.farthest("edge_dot_2", a, b, points, x), self.farthest("slope_order_2", a, b, points, x),
                self.farthest("edge_dot_2", b, a, points, x))


class Area(Rectangle):
    order = "order_rectangle_area"


class Perimeter(Rectangle):
    order = "order_rectangle_perimeter"
