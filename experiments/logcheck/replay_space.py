# SPDX-License-Identifier: GPL-3.0-or-later
"""The Delaunay triangulation in space: every event changes the cells as its ids say, and right after every
instant that has a record they are those of the definition."""

from plane_predicates import of_planes
from replay_cells import Cells
from space import cells, change


class DelaunayInSpace(Cells):
    partly = "blocked flips at degenerate instants: which there are is not followed"
    TIES = {"unfolded_3": "orientation_3"}
    SIZES = {"flip_2_3": (5,), "flip_3_2": (5,), "enter": (4,), "leave": (4,), "hull_2_3": (4,), "hull_3_2": (4,)}
    OTHERS = {"blocked": (4, 5), "touch": (4, 5), "plane_flip": (4,), "plane_enter": (3,), "plane_leave": (3,),
              "plane_blocked": (3, 4), "plane_touch": (3, 4), "line_pass": (2,)}
    # A cell that turns over may leave every sign as it was.
    fails_touching = ("orientation_3", "in_sphere_3", *of_planes())
    change = staticmethod(change)

    def record(self, r, x):
        if r.kind.startswith(("plane_", "line_")):
            self.checker.partly[self.label] = self.partly + "; flips of points of one plane"
        super().record(r, x)

    def signs(self):
        return "orientation_3", "in_sphere_3"

    def current(self, x):
        def sign(name):
            return lambda *ids: self.world.sign_after((name, ids), x)

        def identical(a, b):
            return not any(self.world.sign_after(("order_" + axis, (a, b)), x) for axis in "xyz")

        return cells(self.members, sign("orientation_3"), sign("in_sphere_3"), identical)

    def is_failure(self, query, kind, ids):
        """A claim of these points; that of a tie names four of five."""
        return set(query[1]) <= set(ids) and (len(query[1]) == len(ids) or query[0] == "orientation_3")
