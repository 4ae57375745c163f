# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangulations by their edges, and the Delaunay triangulation from scratch.

Each directed edge has the vertex to its left. The plane is closed by a vertex at infinity, whose
number is above all others, so that hull edges have two sides like all edges. Ties: of four identically
cocircular points the diagonal contains the smallest number; points on a hull edge are hull vertices; of equal
points the smallest number is the vertex.
"""

from static import lexicographic, turn


class Triangulation:
    def __init__(self, infinity):
        self.infinity = infinity
        self.apex = {}

    def add(self, a, b, c):
        for edge, apex in (((a, b), c), ((b, c), a), ((c, a), b)):
            if edge in self.apex:
                raise ValueError("an edge with two triangles on one side")
            self.apex[edge] = apex

    def flip(self, u, v):
        """Replaces edge uv by the other diagonal of its two triangles, which are positively oriented."""
        p, q = self.apex[u, v], self.apex[v, u]
        for edge in ((u, v), (v, u), (v, p), (p, u), (u, q), (q, v)):
            del self.apex[edge]
        self.add(p, u, q)
        self.add(q, v, p)

    def flippable(self, u, v):
        p, q = self.apex[u, v], self.apex[v, u]
        return p != q and (p, q) not in self.apex

    def edges(self):
        """Without the unbounded ones."""
        return {(u, v) for u, v in self.apex if u < v and v != self.infinity}

    def triangles(self):
        """The bounded ones, each from its smallest corner."""
        return {(u, v, w) for (u, v), w in self.apex.items() if u < v and u < w and max(v, w) != self.infinity}

    def hull(self):
        """The outer boundary, counter-clockwise."""
        first = next(v for u, v in self.apex if u == self.infinity)
        cycle = [first]
        while True:
            # The triangle (u, infinity, v) stands to the right of the hull edge u v.
            after = self.apex[cycle[-1], self.infinity]
            if after == first:
                return cycle
            cycle.append(after)
            if len(cycle) > len(self.apex):
                raise ValueError("a hull without an end")


def edge_query(t, u, v):
    """The claim of the edge: value >= 0."""
    p, q = t.apex[u, v], t.apex[v, u]
    infinity = t.infinity
    if max(u, v, p, q) < infinity:
        return ("in_circle_2", (v, u, p, q))
    if p == infinity:
        return ("orientation_2", (v, u, q))
    if q == infinity:
        return ("orientation_2", (u, v, p))
    if u == infinity:
        return ("orientation_2", (p, v, q))
    return ("orientation_2", (q, u, p))


def wants_other_diagonal(world, t, u, v):
    """The four points are identically cocircular, and the smallest number is not on the edge."""
    p, q = t.apex[u, v], t.apex[v, u]
    return max(u, v, p, q) < t.infinity and min(p, q) < min(u, v) and world.is_zero(edge_query(t, u, v))


def delaunay(world, members, x):
    """(triangulation or None, line): right after x; where all points are on one line, the points along
    it."""
    order = lexicographic(world, members, x)
    i = 2
    while i < len(order) and turn(world, order[0], order[1], order[i], x) == 0:
        i += 1
    if i >= len(order):
        return None, order
    t = Triangulation(len(world.scene.ids))
    apex, line = order[i], order[:i]
    left = turn(world, order[0], order[1], apex, x) > 0
    for a, b in zip(line, line[1:]):
        if left:
            t.add(a, b, apex)
        else:
            t.add(b, a, apex)
    hull = line + [apex] if left else line[::-1] + [apex]
    for p in order[i + 1:]:
        n = len(hull)
        visible = [turn(world, hull[k], hull[(k + 1) % n], p, x) < 0 for k in range(n)]
        first = next(k for k in range(n) if visible[k] and not visible[k - 1])
        hull = hull[first:] + hull[:first]
        visible = visible[first:] + visible[:first]
        seen = visible.index(False)
        for k in range(seen):
            t.add(hull[k + 1], hull[k], p)
        hull = [hull[0], p] + hull[seen:]
    for a, b in zip(hull, hull[1:] + hull[:1]):
        t.add(b, a, t.infinity)
    legalise(world, t, x)
    return t, None


def legalise(world, t, x):
    for wanted in (lambda u, v: world.sign_after(edge_query(t, u, v), x) < 0,
                   lambda u, v: wants_other_diagonal(world, t, u, v)):
        todo = sorted(t.edges())
        while todo:
            u, v = todo.pop()
            if (u, v) not in t.apex or t.infinity in (t.apex[u, v], t.apex[v, u]) or not wanted(u, v):
                continue
            p, q = t.apex[u, v], t.apex[v, u]
            t.flip(u, v)
            todo += [(u, p), (p, v), (v, q), (q, u)]
