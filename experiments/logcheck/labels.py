# SPDX-License-Identifier: GPL-3.0-or-later
"""The labels of trees for range search, from the program's header axis_labels.h: numbers that increase along a list.

An insertion takes a free label between those of its neighbours; if there is none, it spreads the smallest dyadic
interval of labels that is sparse enough.
"""


def bits_for(n):
    """The least number of bits that n labels need."""
    return max(n - 1, 0).bit_length()


class Labels:
    def __init__(self):
        self.assign([], 0)

    @property
    def size(self):
        return 1 << self.bits

    def assign(self, order, bits):
        """Spreads these objects evenly over all labels, in place of those that were there."""
        self.bits = bits
        self.of = {o: i * self.size // len(order) for i, o in enumerate(order)}

    def in_order(self):
        return sorted(self.of, key=self.of.get)

    def exchange(self, a, b):
        self.of[a], self.of[b] = self.of[b], self.of[a]

    def room_between(self, before, o, after):
        """{object: its label from now on}, for o and those that make room for it; None: more bits are needed. o comes
        between its neighbours; None: there is none."""
        begin = 0 if before is None else self.of[before] + 1
        end = self.size if after is None else self.of[after]
        if begin < end:
            return {o: (begin + end) // 2}
        near = self.of[after if before is None else before]
        for k in range(1, self.bits + 1):
            first, length = near >> k << k, 1 << k
            order = [p for p in self.in_order() if first <= self.of[p] < first + length]
            if (len(order) + 1) * 2 * self.bits > length * (2 * self.bits - k):
                continue
            order.insert(order.index(before) + 1 if before in order else 0, o)
            moves = {p: first + i * length // len(order) for i, p in enumerate(order)}
            return {p: label for p, label in moves.items() if self.of.get(p) != label}
        return None
