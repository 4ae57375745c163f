# SPDX-License-Identifier: GPL-3.0-or-later
"""rank_kd_tree_2 and pseudo_kd_tree_2: the order of their leaves, depth first.

Both read two sorted lists of the log and give every point a label in each (labels.py). What a tree does depends on all
that has happened, so its steps are those of the program's headers: every exchange in a list exchanges two labels.

rank_kd_tree_2 halves the labels in x, y, x, .. pseudo_kd_tree_2 has nodes that split by x, y, x, ..; two points that
exchange labels across the split of the lowest node with both change sides there, and the highest node that is out of
balance is built anew, with exact medians.
"""

from fractions import Fraction

from labels import Labels, bits_for
from parameters import value_of
from proof import Proof
from replay_members import OfMembers
from subsets import own_objects

UNIT = 1 << 30  # of delta


class KdTree(OfMembers):
    bound = []

    def __init__(self, checker, structure):
        super().__init__(checker, structure)
        self.proofs = [Proof(self.world, self.label, checker.on[4])]  # without claims
        self.labels = (Labels(), Labels())

    @property
    def attribute(self):
        return list(self.told)

    # ---- the lists that it reads

    def start(self, x):
        self.members = self.everyone()
        self.lists = [self.list_by(axis) for axis in ("x", "y")]
        for axis, one in enumerate(self.lists):
            one.watchers.append((self, axis))
        self.make_anew()
        self.told = self.leaves()

    def list_by(self, key):
        for one in self.checker.replays:
            if one is None or one.structure.name != "sorted_list" or (one.structure.key or "x") != key:
                continue
            if own_objects("sorted_list", one.structure.options, self.world.scene) == self.own:
                return one
        self.require(False, "%s reads a sorted list by %s, which the log does not have", self.label, key)
        return None

    def order(self, axis):
        return self.lists[axis].order

    def list_changed(self, axis, swap):
        """Two neighbours of a list have changed places; None: it was made anew."""
        self.look = True
        self.checker.touch(self)
        if swap is not None:
            self.exchange(axis, *swap)
        elif any(labels.in_order() != self.order(i) for i, labels in enumerate(self.labels)):
            self.make_anew()

    # ---- labels

    def make_anew(self):
        bits = bits_for(len(self.order(0)))
        if self.labels[0].bits > bits:
            bits += 1  # room for insertions once there was one
        self.assign(bits)

    def assign(self, bits):
        for axis, labels in enumerate(self.labels):
            labels.assign(self.order(axis), bits)
        self.make_tree()

    def insert(self, o, x):
        self.members.add(o)
        moves = [labels.room_between(*self.neighbours(axis, o)) for axis, labels in enumerate(self.labels)]
        if None in moves:
            self.assign(max(self.labels[0].bits, bits_for(len(self.labels[0].of) + 1)) + 1)
        else:
            others = sorted(set().union(*moves) - {o})
            for other in others:
                self.take_out(other)
            for labels, moved in zip(self.labels, moves):
                labels.of.update(moved)
            for other in others + [o]:
                self.put_in(other)
        self.told = self.leaves()

    def neighbours(self, axis, o):
        order = [None, *self.order(axis), None]
        i = order.index(o)
        return order[i - 1], o, order[i + 1]

    def erase(self, o, x):
        self.members.discard(o)
        if 8 * len(self.labels[0].of) < self.labels[0].size:  # they are sparse
            self.assign(bits_for(2 * len(self.order(0))))
        else:
            self.take_out(o)
            for labels in self.labels:
                del labels.of[o]
        self.told = self.leaves()

    # ---- records

    def record(self, r, x):
        self.look = True
        self.require(r.kind in ("settled", "rebuild"), "%s is no event of a kd-tree", r.short())
        self.require(r.external == (r.gone is not None), "%s is external iff the leaves change", r.short())
        if r.kind == "rebuild":
            self.make_anew()
        fresh = self.leaves()
        self.require(r.kind == "rebuild" or fresh != self.told, "%s: the leaves have not changed", r.short())
        self.checker.check_change(self, r, self.told, fresh)
        self.told = fresh

    def settle(self, x):
        if self.look:
            self.look = False
            self.require(self.told == self.leaves(), "%s: right after %r the leaves are %s, and no event says so",
                         self.label, x, self.names(self.leaves()))

    def after_motion(self, objects, x):
        """Its lists say what changes."""

    # ---- the tree

    def make_tree(self):
        raise NotImplementedError

    def put_in(self, o):
        raise NotImplementedError

    def take_out(self, o):
        raise NotImplementedError

    def exchange(self, axis, before, after):
        raise NotImplementedError

    def leaves(self):
        raise NotImplementedError


def spread(label):
    """The bits of a label, each followed by a zero."""
    return int("0".join(format(label, "b")) + "0", 2) if label else 0


class RankKdTree(KdTree):
    """The labels determine the tree."""

    def make_tree(self):
        pass

    def put_in(self, o):
        pass

    def take_out(self, o):
        pass

    def exchange(self, axis, before, after):
        self.labels[axis].exchange(before, after)

    def leaves(self):
        x, y = (labels.of for labels in self.labels)
        return sorted(x, key=lambda o: spread(x[o]) | spread(y[o]) >> 1)


class Node:
    """Of at least two points: those on its first side have labels up to `last`."""

    __slots__ = ("last", "axis", "size", "above", "below")

    def __init__(self, last, axis, size, above):
        self.last, self.axis, self.size, self.above, self.below = last, axis, size, above, [None, None]


class PseudoKdTree(KdTree):
    """A node is a Node or a point; `above` of a point is in self.above."""

    def __init__(self, checker, structure):
        super().__init__(checker, structure)
        delta = value_of(structure.name, structure.options, "delta", lambda v: Fraction(str(v)))
        self.delta = int(delta * UNIT)
        self.root, self.above = None, {}

    def leaves(self):
        return points_below(self.root)

    # ---- balance

    def largest_side(self, size):
        excess = max(1, 2 * self.delta * size // UNIT)
        return min((size + excess) // 2, size - 1)

    def is_balanced(self, node):
        first = size_of(node.below[0])
        return max(first, node.size - first) <= self.largest_side(node.size)

    def balance_above(self, node):
        """Builds the highest node anew that is out of balance, from this one up."""
        worst = None
        while node is not None:
            if not self.is_balanced(node):
                worst = node
            node = node.above
        if worst is not None:
            self.build_anew(worst)

    def build_anew(self, node):
        above = node.above
        place = None if above is None else index_of(above, node)
        fresh = self.subtree(points_below(node), node.axis, above)
        if above is None:
            self.root = fresh
        else:
            above.below[place] = fresh

    # ---- nodes

    def make_tree(self):
        self.above = {}
        points = list(self.labels[0].of)
        self.root = self.subtree(points, 0, None) if points else None

    def subtree(self, points, axis, above):
        if len(points) == 1:
            self.above[points[0]] = above
            return points[0]
        label = self.labels[axis].of
        points = sorted(points, key=label.get)
        half = (len(points) + 1) // 2
        node = Node(label[points[half - 1]], axis, len(points), above)
        node.below = [self.subtree(side, 1 - axis, node) for side in (points[:half], points[half:])]
        return node

    def replace(self, above, old, fresh):
        if above is None:
            self.root = fresh
        else:
            above.below[index_of(above, old)] = fresh

    def hang(self, o):
        self.above[o] = None
        if self.root is None:
            self.root = o
            return
        at, axis = self.root, 0
        while isinstance(at, Node):
            at.size += 1
            at, axis = at.below[self.labels[at.axis].of[o] > at.last], 1 - axis
        own, other = self.labels[axis].of[o], self.labels[axis].of[at]
        made = Node(min(own, other), axis, 2, self.above[at])
        made.below = [o, at] if own < other else [at, o]
        self.replace(made.above, at, made)
        self.above[at] = self.above[o] = made

    def unhang(self, o):
        """The node above the one that has gone with the leaf."""
        parent = self.above.pop(o)
        if parent is None:
            self.root = None
            return None
        sibling = parent.below[1 - index_of(parent, o)]
        grandparent = parent.above
        self.replace(grandparent, parent, sibling)
        node = grandparent
        while node is not None:
            node.size -= 1
            node = node.above
        if isinstance(sibling, Node):  # it has moved up by a level, and splits by the other axis from now on
            sibling.above, sibling.axis = grandparent, parent.axis
            self.build_anew(sibling)
        else:
            self.above[sibling] = grandparent
        return grandparent

    def put_in(self, o):
        self.hang(o)
        self.balance_above(self.above[o])

    def take_out(self, o):
        self.balance_above(self.unhang(o))

    # ---- an exchange of two labels

    def beside(self, leaf):
        """A leaf below the node that is on the other side of the one above the leaf."""
        parent = self.above[leaf]
        at = parent.below[1 - index_of(parent, leaf)]
        while isinstance(at, Node):
            at = at.below[0]
        return at

    def exchange(self, axis, before, after):
        meet = self.lowest_with(before, after)
        if meet.axis != axis:
            self.move_splits(axis, before, after, meet)
            self.labels[axis].exchange(before, after)
            return
        touched = [before, after, self.beside(before), self.beside(after)]
        self.unhang(before)
        self.unhang(after)
        self.labels[axis].exchange(before, after)
        self.hang(before)
        self.hang(after)
        for leaf in touched:
            self.balance_above(self.above[leaf])

    def lowest_with(self, one, other):
        above = set()
        node = self.above[one]
        while node is not None:
            above.add(node)
            node = node.above
        node = self.above[other]
        while node not in above:
            node = node.above
        return node

    def move_splits(self, axis, before, after, meet):
        """No node below `meet` has both: the splits between the two labels move with the points."""
        smaller, larger = self.labels[axis].of[before], self.labels[axis].of[after]
        for leaf, last in ((before, larger), (after, smaller - 1)):
            node = self.above[leaf]
            while node is not meet:
                if node.axis == axis and smaller <= node.last < larger:
                    node.last = last
                node = node.above


def index_of(node, below):
    return 0 if node.below[0] is below or node.below[0] == below else 1


def size_of(node):
    return node.size if isinstance(node, Node) else 1


def points_below(node):
    if node is None:
        return []
    return points_below(node.below[0]) + points_below(node.below[1]) if isinstance(node, Node) else [node]
