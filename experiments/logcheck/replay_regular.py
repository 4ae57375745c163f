# SPDX-License-Identifier: GPL-3.0-or-later
"""Regular triangulations in the plane and in space: every event changes the triangles, or cells, as its ids say, and
right after every instant that has a record they are those of the definition."""

from plane_predicates import of_planes
from replay_cells import Cells
from space import change, change_in_plane, simplices


class Regular(Cells):
    partly = ("blocked flips at degenerate instants, and the witnesses of hidden points: which there are is not "
              "followed")
    CORNERS = 0

    def signs(self):
        power = "disc_power_%d" if self.world.scene.extents == "radius" else "power_%d"
        return tuple(name % (self.CORNERS - 1) for name in ("orientation_%d", power))

    def current(self, x):
        def sign(name):
            return lambda *ids: self.world.sign_after((name, ids), x)

        return simplices(self.members, self.CORNERS, *map(sign, self.signs()))

    def is_failure(self, query, kind, ids):
        """Of a witness of the point that shows, or of a claim of these points; that of a tie names fewer."""
        return ids[0] in query[1] if kind == "show" else set(query[1]) <= set(ids)


class RegularInThePlane(Regular):
    # Vertices of the hull that meet and part again leave every turn as it was, and a simplex that turns over may
    # leave every power.
    fails_touching = ("orientation_2", "power_2", "disc_power_2")
    CORNERS = 3
    SIZES = {"flip": (4,), "enter": (3,), "leave": (3,), "show": (3, 4), "hide": (3, 4)}
    OTHERS = {"blocked": (3, 4), "witness": (1,), "touch": (3, 4)}
    change = staticmethod(change_in_plane)


class RegularInSpace(Regular):
    fails_touching = ("orientation_3", "power_3", "disc_power_3", *of_planes())
    CORNERS = 4
    TIES = {"unfolded_3": "orientation_3"}
    SIZES = {"flip_2_3": (5,), "flip_3_2": (5,), "enter": (4,), "leave": (4,), "hull_2_3": (4,), "hull_3_2": (4,),
             "show": (4, 5), "hide": (4, 5)}
    OTHERS = {"blocked": (4, 5), "witness": (1,), "touch": (4, 5), "plane_flip": (4,), "plane_enter": (3,),
              "plane_leave": (3,), "plane_show": (3, 4), "plane_hide": (3, 4), "plane_witness": (1,),
              "plane_blocked": (3, 4), "plane_touch": (3, 4)}
    change = staticmethod(change)

    def record(self, r, x):
        if r.kind.startswith("plane_"):
            self.checker.partly[self.label] = self.partly + "; changes in the plane of all points"
        super().record(r, x)
