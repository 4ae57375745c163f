# SPDX-License-Identifier: GPL-3.0-or-later
"""maximum_heap, maximum_hanger, maximum_tournament: the places of their objects.

A heap is an array; an object is appended and sifted up. A hanger is a heap-ordered binary tree; coins
choose the sides (the 64-bit generator of Steele, Lea and Flood, seed "kinetics"). A tournament is an
array: the winner at node v is one of the winners at 2v and 2v + 1; the leaves n .. 2n - 1 are the
objects in the scene's order.
"""

from log import Wrong
from replay_maximum import Tree


class HeapOrdered(Tree):
    """A parent is at least as good as its children; a failure exchanges a parent and a child."""

    def repair(self, child, query, x):
        up, down = self.object_at(child), self.object_at(self.parent(child))
        self.pending = ("swap", (down, up), query)
        self.exchange(child, x)

    def tie(self, r, query, x):
        down, up = r.ids
        child = self.where(up)
        parent = self.parent(child)
        self.require(parent is not None and self.object_at(parent) == down and up < down
                     and self.world.is_zero(self.claim(down, up)),
                     "%s: the two are not parent and child with equal keys in the wrong order", r.short())
        self.inside.step += 1
        self.exchange(child, x)

    def pairs(self):
        for place, claim in self.inside.claims.items():
            up, down = self.object_at(self.parent(place)), self.object_at(place)
            yield claim[0], up, down

    def renew(self, places, x):
        for place in places:
            parent = self.parent(place)
            if parent is not None:
                self.inside.put(place, self.claim(self.object_at(parent), self.object_at(place)), x)


class Heap(HeapOrdered):
    def start(self, x):
        super().start(x)
        self.build(x)

    def build(self, x):
        self.heap = sorted(self.members)
        for i in range(len(self.heap) // 2 - 1, -1, -1):
            self.sink(i, x)
        self.renew(range(1, len(self.heap)), x)

    def winner(self):
        return self.heap[0] if self.heap else None

    def parent(self, i):
        return (i - 1) // 2 if i else None

    def object_at(self, i):
        return self.heap[i]

    def where(self, o):
        return self.heap.index(o)

    def rise(self, i, x):
        h = self.heap
        while i and self.beats(h[i], h[(i - 1) // 2], x):
            h[i], h[(i - 1) // 2] = h[(i - 1) // 2], h[i]
            i = (i - 1) // 2

    def sink(self, i, x):
        h = self.heap
        while 2 * i + 1 < len(h):
            child = 2 * i + 1
            if child + 1 < len(h) and self.beats(h[child + 1], h[child], x):
                child += 1
            if not self.beats(h[child], h[i], x):
                return
            h[i], h[child] = h[child], h[i]
            i = child

    def exchange(self, child, x):
        parent = self.parent(child)
        h = self.heap
        h[parent], h[child] = h[child], h[parent]
        places = {parent, child, 2 * parent + 1, 2 * parent + 2, 2 * child + 1, 2 * child + 2}
        self.renew([i for i in places if i < len(h)], x)

    def insert(self, o, x):
        super().insert(o, x)
        self.inside.step += 1
        self.heap.append(o)
        self.rise(len(self.heap) - 1, x)
        self.renew(range(1, len(self.heap)), x)

    def erase(self, o, x):
        super().erase(o, x)
        self.inside.step += 1
        hole, last = self.heap.index(o), self.heap.pop()
        self.inside.drop(len(self.heap), x)
        if o != last:
            self.heap[hole] = last
            self.rise(hole, x)
            if self.heap[hole] == last:
                self.sink(hole, x)
        self.renew(range(1, len(self.heap)), x)

    def change(self, r, x):
        super().change(r, x)
        self.inside.clear(x)
        self.build(x)


class Node:
    def __init__(self, o, parent):
        self.object, self.parent, self.child = o, parent, [None, None]


class Hanger(HeapOrdered):
    SEED = 0x6b696e6574696373
    MASK = (1 << 64) - 1
    coins = 0

    def coin(self):
        self.coins += 1
        z = (self.SEED + self.coins * 0x9e3779b97f4a7c15) & self.MASK
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9 & self.MASK
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb & self.MASK
        return (z ^ (z >> 31)) >> 63

    def start(self, x):
        super().start(x)
        self.build(x)

    def build(self, x):
        self.root, self.node = None, {}
        for o in sorted(self.members):
            self.hang(o, x)
        self.renew(list(self.node.values()), x)

    def winner(self):
        return self.root.object if self.root else None

    def parent(self, node):
        return node.parent

    def object_at(self, node):
        return node.object

    def where(self, o):
        return self.node[o]

    def put(self, node, o):
        node.object = o
        self.node[o] = node

    def hang(self, o, x):
        """The better object stays; the loser descends to a random child and becomes a leaf at the first empty
        slot."""
        parent, side, node = None, 0, self.root
        while node is not None:
            if self.beats(o, node.object, x):
                there = node.object
                self.put(node, o)
                o = there
            side = self.coin()
            parent, node = node, node.child[side]
        fresh = Node(o, parent)
        if parent is None:
            self.root = fresh
        else:
            parent.child[side] = fresh
        self.put(fresh, o)

    def exchange(self, child, x):
        parent = child.parent
        up, down = child.object, parent.object
        self.put(parent, up)
        self.put(child, down)
        places = [parent, child] + parent.child + child.child
        self.renew([n for n in places if n is not None], x)

    def insert(self, o, x):
        super().insert(o, x)
        self.inside.step += 1
        self.hang(o, x)
        self.renew(list(self.node.values()), x)

    def erase(self, o, x):
        super().erase(o, x)
        self.inside.step += 1
        hole = self.node.pop(o)
        while any(hole.child):
            left, right = hole.child
            up = left or right
            if left and right and self.beats(right.object, left.object, x):
                up = right
            self.put(hole, up.object)
            hole = up
        self.inside.drop(hole, x)
        if hole.parent is None:
            self.root = None
        else:
            hole.parent.child[hole.parent.child.index(hole)] = None
        self.renew(list(self.node.values()), x)

    def change(self, r, x):
        super().change(r, x)
        self.inside.clear(x)
        self.build(x)


class Tournament(Tree):
    def start(self, x):
        super().start(x)
        self.expected = []
        self.build(x)

    def build(self, x):
        leaves = sorted(self.members)
        self.size = len(leaves)
        self.node = [None] * self.size + leaves
        for v in range(self.size - 1, 0, -1):
            self.decide(v, x)

    def winner(self):
        return self.node[1] if self.size else None

    def loser(self, v):
        a, b = self.node[2 * v], self.node[2 * v + 1]
        return b if self.node[v] == a else a

    def set_node(self, v, winner, loser, x):
        claim = self.claim(winner, loser)
        self.inside.put(v, claim, x)
        if loser < winner and self.world.is_zero(claim):
            winner, loser = loser, winner
            self.inside.put(v, self.claim(winner, loser), x)
            self.expected.append(("tie", (loser, winner)))
        self.node[v] = winner

    def decide(self, v, x):
        a, b = self.node[2 * v], self.node[2 * v + 1]
        old = self.inside.claims.get(v)
        if old is not None and old[0] in (self.claim(a, b), self.claim(b, a)):
            return
        if self.beats(a, b, x):
            self.set_node(v, a, b, x)
        else:
            self.set_node(v, b, a, x)

    def flip(self, v, x):
        """The loser becomes the winner at v, and at the nodes above up to where it loses."""
        old, fresh = self.node[v], self.loser(v)
        self.set_node(v, fresh, old, x)
        while v > 1 and old != self.node[v]:
            fresh, sibling = self.node[v], self.node[v ^ 1]
            v //= 2
            before = self.node[v]
            if before == old:
                self.set_node(v, fresh, sibling, x)
            else:
                self.set_node(v, sibling, fresh, x)
            old = before

    def repair(self, v, query, x):
        self.pending = ("replace", (self.node[v], self.loser(v)), query)
        self.flip(v, x)

    def tie(self, r, query, x):
        self.require(self.expected and self.expected[0] == (r.kind, r.ids), "%s: no two equal keys lead to it",
                     r.short())
        del self.expected[0]

    def event(self, r, x):
        super().event(r, x)
        if r.kind != "tie" and self.expected:
            raise Wrong("%s: a tie is missing before it" % r.short())

    def after_motion(self, objects, x):
        super().after_motion(objects, x)
        places = [v for v, claim in self.inside.claims.items()
                  if not objects.isdisjoint(claim[0][1]) and self.world.is_zero(claim[0])]
        for v in sorted(places, reverse=True):
            old, fresh = self.node[v], self.loser(v)
            if self.world.is_zero(self.inside.claims[v][0]) and fresh < old:
                self.flip(v, x)
                self.expected.append(("tie", (old, fresh)))

    def settle(self, x):
        self.require(not self.expected, "%s: a tie is missing", self.label)
        super().settle(x)

    def pairs(self):
        for v, claim in self.inside.claims.items():
            yield claim[0], self.node[v], self.loser(v)

    def insert(self, o, x):
        super().insert(o, x)
        self.inside.step += 1
        self.size += 1
        v = self.size - 1
        if self.size == 1:
            self.node = [None, o]
            return
        self.node += [self.node[v], o]
        self.decide_above([v], x)

    def erase(self, o, x):
        super().erase(o, x)
        self.inside.step += 1
        hole = self.node.index(o, self.size)
        self.size -= 1
        if self.size == 0:
            self.node = [None, None]
            return
        parent = self.size
        b, a = self.node.pop(), self.node.pop()
        self.inside.drop(parent, x)
        up = b if o == a else a
        self.node[parent] = up
        paths = [parent // 2]
        if o not in (a, b):
            self.node[hole] = b
            paths.append(hole // 2)
        self.decide_above(paths, x)

    def decide_above(self, nodes, x):
        all_ = set()
        for v in nodes:
            while v:
                all_.add(v)
                v //= 2
        for v in sorted(all_, reverse=True):
            self.decide(v, x)

    def change(self, r, x):
        super().change(r, x)
        self.inside.clear(x)
        self.build(x)
