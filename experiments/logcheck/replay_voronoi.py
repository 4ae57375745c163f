# SPDX-License-Identifier: GPL-3.0-or-later
"""voronoi_cell_2: the neighbours of one site, counter-clockwise from the smallest number, reported as a hull is.

The proof: the star of the site in the Delaunay triangulation. Its triangles are upright, no site is in one of their
circles, and all sites are on one side of a hull edge that ends at the site.
"""

from replay_hull import Hull
from static import rotated
from subsets import query_of
from triangulation import delaunay


def star(t, site):
    """The corners around a vertex counter-clockwise, infinity included; it has three at least."""
    first = next(v for u, v in t.apex if u == site)
    corners = [first]
    while True:
        after = t.apex[site, corners[-1]]
        if after == first:
            return corners
        corners.append(after)


class VoronoiCell(Hull):
    at_every_instant = True  # the site may reach the hull, which changes the proof and not its neighbours
    bound = ["order_x", "order_y", "orientation_2", "in_circle_2", "obtuse_angle_2"]

    def __init__(self, checker, structure):
        super().__init__(checker, structure)
        self.asked = query_of(structure.options, self.world.scene)

    def vertex(self, x):
        """The smallest number of those that are equal to the site identically; None: it is not there."""
        if self.asked not in self.members:
            return None
        return next(o for o in sorted(self.members) if o == self.asked or all(
            self.world.is_zero((axis, (o, self.asked))) for axis in ("order_x", "order_y")))

    def current(self, x):
        self.corners, self.line, self.site = [], [], self.vertex(x)
        if self.site is None:
            return []
        t, self.line = delaunay(self.world, self.members, x)
        if t is None:
            i = self.line.index(self.site)
            return sorted(self.line[max(0, i - 1):i] + self.line[i + 1:i + 2])
        self.infinity, self.corners, self.line = t.infinity, star(t, self.site), []
        return rotated([o for o in self.corners if o != t.infinity])

    def wanted(self):
        for a, b in zip(self.line, self.line[1:]):
            axis = "order_y" if self.world.is_zero(("order_x", (a, b))) else "order_x"
            yield (axis, (a, b))
        s = self.site
        for a, b in zip(self.corners, self.corners[1:] + self.corners[:1]):
            others = self.members - {s, a, b}
            if self.infinity not in (a, b):
                yield ("orientation_2", (s, a, b))
                for p in others:
                    yield ("in_circle_2", (a, s, b, p))
            else:
                for p in others:
                    yield ("orientation_2", (s, b, p) if a == self.infinity else (a, s, p))

    def claims(self, x):
        wanted = {query: query for query in self.wanted()}
        for place in list(self.proof.claims):
            if place not in wanted:
                self.proof.drop(place, x)
        for place, query in wanted.items():
            self.proof.put(place, query, x)
