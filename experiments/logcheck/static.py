# SPDX-License-Identifier: GPL-3.0-or-later
"""Attributes from scratch, right after an instant, by signs alone."""

from functools import cmp_to_key


def before(world, key, a, b, x):
    """a precedes b right after x; equal keys: by number."""
    sign = world.sign_after(key.claim(a, b), x)
    return sign > 0 or (sign == 0 and a < b)


def sorted_by(world, key, members, x):
    return sorted(sorted(members), key=cmp_to_key(lambda a, b: -1 if before(world, key, a, b, x) else 1))


def insertion_place(world, key, order, o, x):
    low, high = 0, len(order)
    while low < high:
        middle = (low + high) // 2
        if before(world, key, order[middle], o, x):
            low = middle + 1
        else:
            high = middle
    return low


def turn(world, a, b, c, x):
    return world.sign_after(("orientation_2", (a, b, c)), x)


def along(world, a, b, x):
    """Lexicographic order of points right after x: +1 if a comes before b, 0 if they are equal."""
    return world.sign_after(("order_x", (a, b)), x) or world.sign_after(("order_y", (a, b)), x)


def lexicographic(world, members, x):
    """The points from left to right; of equal points only the one with the smallest number."""
    order = sorted(sorted(members), key=cmp_to_key(lambda a, b: -along(world, a, b, x)))
    return [o for i, o in enumerate(order) if i == 0 or along(world, order[i - 1], o, x) != 0]


def hull(world, members, x):
    """Strict vertices counter-clockwise from the smallest number (Andrew's chain)."""
    order = lexicographic(world, members, x)
    if len(order) <= 2:
        return sorted(order)

    def chain(points):
        result = []
        for p in points:
            while len(result) > 1 and turn(world, result[-2], result[-1], p, x) <= 0:
                result.pop()
            result.append(p)
        return result

    cycle = chain(order)[:-1] + chain(order[::-1])[:-1]
    if len(cycle) == 2:
        return sorted(cycle)
    return rotated(cycle)


def rotated(cycle):
    i = cycle.index(min(cycle)) if cycle else 0
    return cycle[i:] + cycle[:i]


def spanning_tree(pairs):
    """The edges of the minimum spanning forest, ascending, of pairs in the order of their lengths."""
    component = {}
    tree = []
    for a, b in pairs:
        one, other = component.setdefault(a, {a}), component.setdefault(b, {b})
        if one is other:
            continue
        tree.append((a, b))
        one |= other
        for o in other:
            component[o] = one
    return sorted(tree)


def forest_edges(order, scene):
    """Of objects that are edges of a graph, in the order of their weights: those of the minimum spanning forest."""
    component, edges = {}, []
    for o in order:
        a, b = scene.objects[o].ends
        one, other = component.setdefault(a, {a}), component.setdefault(b, {b})
        if one is other:
            continue
        edges.append(o)
        one |= other
        for vertex in other:
            component[vertex] = one
    return edges
