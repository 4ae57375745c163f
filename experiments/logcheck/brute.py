# SPDX-License-Identifier: GPL-3.0-or-later
"""Level 5: small scenes by brute force.

The instants at which anything can change are all found: every root of every predicate over every tuple of
objects, whether or not it is in a structure's proof. At a rational time between two consecutive instants the
attribute is computed from positions and compared with the attribute that the log's events lead to.
"""

from fractions import Fraction

from brute_attributes import attribute_of
from brute_queries import queries_of
from log import Wrong
from roots import Instant, all_roots, compare
from scene import Extended
from subsets import own_objects
from world import World

MOST_OBJECTS = 12
MOST_GAPS = 20000


def low_end(x):
    return Fraction(*x.value) if x.value is not None else Fraction(x.a, 1 << x.k)


def high_end(x):
    return Fraction(*x.value) if x.value is not None else Fraction(x.b, 1 << x.k)


def rational_between(x, y):
    """x < y."""
    while True:
        a, b = high_end(x), low_end(y)
        if a < b or (a == b and x.value is None and y.value is None):
            return simplest((a + b) / 2, a, b)
        x.refine(8)
        y.refine(8)


def simplest(t, a, b):
    """A number of few bits near t, between a and b."""
    if a == b:
        return t
    k = 1
    while True:
        rounded = Fraction(round(t * k), k)
        if a < rounded < b:
            return rounded
        k *= 16


def merged(instants):
    """Sorted, each once."""
    from functools import cmp_to_key

    instants.sort(key=cmp_to_key(compare))
    result = []
    for x in instants:
        if not result or compare(result[-1], x) != 0:
            result.append(x)
    return result


def check_small(checker, end):
    scene, structures = checker.scene, checker.log.structures
    if len(scene.ids) > MOST_OBJECTS:
        checker.undone[5] = "%d objects; it is for at most %d" % (len(scene.ids), MOST_OBJECTS)
        return
    keys = [checker.key_of(s) if uses_key(s) else None for s in structures]
    followed = [i for i, r in enumerate(checker.replays) if r is not None]
    if not followed:
        checker.undone[5] = "no structure of the log has a replay"
        return
    world = World(scene)
    history, told, gaps, roots = checker.history, 0, 0, {}
    changes, place = scene.changes, 0
    begin = Instant.rational(scene.start.numerator, scene.start.denominator)
    while True:
        t = changes[place][0] if place < len(changes) else None
        until = None if t is None else Instant.rational(t.numerator, t.denominator)
        if until is None or (end is not None and compare(until, end) > 0):
            until, t = end, None
        instants = [begin]
        owns = {i: own_objects(structures[i].name, structures[i].options, scene) for i in followed}
        present = {i: world.alive if owns[i] is None else world.alive & owns[i] for i in followed}
        for query in {q for i in followed for q in queries_of(structures[i], keys[i], present[i], scene)}:
            p = world.changes(*query)[0].p
            if p not in roots:
                roots[p] = all_roots(p, world.window)
            instants += [r for r in roots[p] if compare(r, begin) > 0 and (until is None or compare(r, until) < 0)]
        instants = merged(instants)
        instants.append(until)
        for x, y in zip(instants, instants[1:]):
            if y is not None and compare(x, y) >= 0:
                continue
            gaps += 1
            if gaps > MOST_GAPS:
                checker.undone[5] = "more than %d gaps" % MOST_GAPS
                return
            point = high_end(x) + 1 if y is None else rational_between(x, y)
            sample = Instant.rational(point.numerator, point.denominator)
            while told + 1 < len(history) and compare(history[told + 1][0], sample) < 0:
                told += 1
            positions = {o: Extended([world.piece[o].position(axis, point)
                                      for axis in range(len(world.piece[o].axes))], scene.dimension)
                         for o in world.alive}
            for i in followed:
                right = attribute_of(structures[i], keys[i], {o: positions[o] for o in present[i]}, scene)
                if right is not None and history[told][1][i] != right:
                    raise Wrong("%s: at t = %s it is %s; what the events say is %s" % (
                        structures[i].label, point, shown(scene, right), shown(scene, history[told][1][i])),
                        checker.last_line())
        if t is None:
            break
        while place < len(changes) and changes[place][0] == t:
            _, rank, o, piece = changes[place]
            if rank == 1:
                world.alive.discard(o)
            else:
                world.alive.add(o)
                world.set_motion(o, piece)
            place += 1
        begin = until
    checker.done[5] = "%d gaps between instants" % gaps


def uses_key(structure):
    return structure.name == "sorted_list" or structure.name.startswith(("maximum_", "minimum_"))


def shown(scene, attribute):
    return "[" + ", ".join(shown(scene, i) if isinstance(i, tuple) else scene.ids[i] for i in attribute) + "]"
