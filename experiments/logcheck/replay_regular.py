# SPDX-License-Identifier: GPL-3.0-or-later
"""The regular triangulation in the plane: every event changes the triangles as its ids say, and right after every
instant that has a record they are those of the definition."""

from replay_cells import Cells
from space import change_in_plane, simplices


class RegularInThePlane(Cells):
    partly = ("blocked flips at degenerate instants, and the witnesses of hidden points: which there are is not "
              "followed")
    SIZES = {"flip": (4,), "enter": (3,), "leave": (3,), "show": (3, 4), "hide": (3, 4)}
    OTHERS = {"blocked": (3, 4), "witness": (1,), "touch": (3,)}
    change = staticmethod(change_in_plane)

    def current(self, x):
        def sign(name):
            return lambda *ids: self.world.sign_after((name, ids), x)

        power = "disc_power_2" if self.world.scene.extents == "radius" else "power_2"
        return simplices(self.members, 3, sign("orientation_2"), sign(power))

    def is_failure(self, query, kind, ids):
        """Of a witness of the point that shows, or of a claim of these points; that of a tie names only three."""
        return ids[0] in query[1] if kind == "show" else set(query[1]) <= set(ids)
