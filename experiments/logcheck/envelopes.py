# SPDX-License-Identifier: GPL-3.0-or-later
"""The tree of envelopes of a kinetic convex hull in the dual, merged from scratch.

Point (p, q) is the line y = p x + q; the upper hull is the upper envelope, the lower hull the same
upside down. A node merges the chains of its children, red and blue. A corner (a, b) is where line b
follows line a; corners of both colours have one order from left to right, and each has a contender,
the line of the other colour there. What a node claims follows from its state alone (see the table in
structures/hull/convex_hull_2.h); claims() below is that table.
"""

UPPER, LOWER = 0, 1


class Tied(Exception):
    """A sign is identically zero, and the rule that resolves it is not implemented here."""


class TreeNode:
    def __init__(self, parent=None, point=None):
        self.parent, self.point, self.children = parent, point, None
        self.leaves = 1
        self.chains = [[point], [point]]
        self.claimed = [{}, {}]  # place: (query, kind, ids)


class Tree:
    def __init__(self, world, naive):
        self.world, self.naive = world, naive
        self.root, self.leaf = None, {}

    # ---- signs

    def sign(self, query, x):
        sign = self.world.sign_after(query, x)
        if sign == 0:
            raise Tied
        return sign

    def flatter(self, a, b, x):
        """The slope of line a is less than that of b."""
        return self.sign(("order_x", (a, b)), x) > 0

    @staticmethod
    def left_of(half, v, w):
        """Corner v is left of corner w."""
        return ("slope_order_2", w + v if half == UPPER else v + w)

    @staticmethod
    def height(half, above, v, c):
        """Corner v is above (or below) line c."""
        a, b = v
        return ("orientation_2", (b, a, c) if above == (half == UPPER) else (a, b, c))

    # ---- the shape of the tree

    def build(self, points, parent=None):
        if not points:
            return None
        node = TreeNode(parent)
        if len(points) == 1:
            node.point, node.chains = points[0], [[points[0]], [points[0]]]
            self.leaf[points[0]] = node
            return node
        middle = len(points) // 2
        node.children = [self.build(points[:middle], node), self.build(points[middle:], node)]
        node.leaves = len(points)
        return node

    def insert(self, point):
        """The shallowest leaf becomes a node over its point and the new one."""
        if self.root is None:
            self.root = self.build([point])
            return
        t = self.root
        while t.children:
            a, b = t.children
            t = b if b.leaves < a.leaves else a
        fresh = self.build([point])
        node = TreeNode(t.parent)
        self.put_in_place(t, node)
        node.children = [t, fresh]
        t.parent = fresh.parent = node
        self.balance(node)

    def erase(self, point):
        t = self.leaf.pop(point)
        node = t.parent
        if node is None:
            self.root = None
            return
        sibling = node.children[node.children[0] is t]
        sibling.parent = node.parent
        self.put_in_place(node, sibling)
        self.balance(node.parent)

    def put_in_place(self, old, new):
        above = old.parent
        if above is None:
            self.root = new
        else:
            above.children[above.children[1] is old] = new

    def balance(self, t):
        """A node is rebuilt when a child has more than three quarters of its leaves, and a few."""
        while t is not None:
            a, b = (c.leaves for c in t.children)
            t.leaves = a + b
            if 4 * max(a, b) > 3 * (a + b) + 8:
                fresh = self.build(sorted(self.points(t)), t.parent)
                self.put_in_place(t, fresh)
                t = fresh
            t = t.parent

    def points(self, t):
        return [t.point] if not t.children else self.points(t.children[0]) + self.points(t.children[1])

    def nodes(self, t=None):
        """Children first."""
        t = t or self.root
        if t is not None and t.children:
            yield from self.nodes(t.children[0])
            yield from self.nodes(t.children[1])
            yield t

    # ---- the merge

    def merge(self, t, half, x):
        """Sets the chain and the claims of one half of a node."""
        red, blue = (c.chains[half] for c in t.children)
        chains = {True: red, False: blue}
        at = {True: 0, False: 0}
        ends = [self.flatter(red[0], blue[0], x), self.flatter(blue[-1], red[-1], x)]
        corners = []  # (corner, is red, contender, is above, place of its left line, place of the contender)
        while True:
            more = {colour: at[colour] + 1 < len(chains[colour]) for colour in (True, False)}
            if not any(more.values()):
                break
            colour = more[True]
            corner = {c: tuple(chains[c][at[c]:at[c] + 2]) for c in (True, False)}
            if all(more.values()):
                colour = self.sign(self.left_of(half, corner[True], corner[False]), x) > 0
            contender = chains[not colour][at[not colour]]
            above = self.sign(self.height(half, True, corner[colour], contender), x) > 0
            corners.append((corner[colour], colour, contender, above))
            at[colour] += 1
        chain, crossings = self.purple(chains, ends, corners)
        t.chains[half] = chain
        t.claimed[half] = dict(self.claims(half, chains, ends, corners, crossings, x))

    @staticmethod
    def purple(chains, ends, corners):
        """The upper chain from left to right, and the number of crossings of each line."""
        at = {True: 0, False: 0}
        red_shows = ends[0]
        chain = [chains[red_shows][0]]
        crossings = {}
        for red_above, colour, above in [(c[1] == c[3], c[1], c[3]) for c in corners] + [(ends[1], None, False)]:
            if red_above != red_shows:
                for c in (True, False):
                    line = chains[c][at[c]]
                    crossings[line] = crossings.get(line, 0) + 1
                red_shows = red_above
                chain.append(chains[red_shows][at[red_shows]])
            if colour is None:
                break
            at[colour] += 1
            if above:
                chain.append(chains[colour][at[colour]])
        return chain, crossings

    def claims(self, half, chains, ends, corners, crossings, x):
        """(place, (query, kind, ids)) of all claims of one half of a node."""
        red, blue = chains[True], chains[False]
        for end, (r, b) in enumerate(((red[0], blue[0]), (red[-1], blue[-1]))):
            pair = (r, b) if ends[end] == (end == 0) else (b, r)
            yield ("end", end), (("order_x", pair), "end", pair)
        tangents = set()
        for colour in () if self.naive else (True, False):
            for line in chains[colour]:
                run = [c for c in corners if c[2] == line and c[1] != colour]
                if crossings.get(line) or not run or not run[0][3]:
                    continue
                first, last = run[0][0], run[-1][0]
                if self.flatter(line, first[0], x):
                    yield ("s1", line), (("order_x", (line, first[0])), "sr", (line, first[0]))
                elif self.flatter(last[1], line, x):
                    yield ("s1", line), (("order_x", (last[1], line)), "sl", (last[1], line))
                else:
                    a, b = next(c[0] for c in run if not self.flatter(c[0][1], line, x))
                    tangents.add((a, b))
                    yield ("s1", line), (("order_x", (a, line)), "st", (a, line))
                    yield ("s2", line), (("order_x", (line, b)), "st", (line, b))
        for i, (v, colour, contender, above) in enumerate(corners):
            if i + 1 < len(corners) and corners[i + 1][1] != colour:
                w = corners[i + 1][0]
                yield ("x", v), (self.left_of(half, v, w), "x", v + w)
            red_above = colour == above
            left = red_above != (ends[0] if i == 0 else corners[i - 1][1] == corners[i - 1][3])
            right = red_above != (ends[1] if i + 1 == len(corners) else corners[i + 1][1] == corners[i + 1][3])
            if self.naive or left or right or v in tangents:
                kind = ("yb" if right else "yl") if left else ("yr" if right else "yt")
                yield ("y", v), (self.height(half, above, v, contender), kind, v + (contender,))
