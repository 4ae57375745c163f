# SPDX-License-Identifier: GPL-3.0-or-later
"""Level 5: small scenes by brute force.

The instants at which anything can change are all found: every root of every predicate over every tuple of
objects, whether or not it is in a structure's proof. At a rational time between two consecutive instants the
attribute is computed from positions and compared with the attribute that the log's events lead to.
"""

from brute_attributes import attribute_of
from brute_queries import queries_of
from counted import count
from gaps import Period
from log import Wrong
from roots import Instant, compare
from subsets import own_objects
from world import World

MOST_OBJECTS = 12
MOST_GAPS = 20000
MOST_QUERIES = 8000


def check_small(checker, end):
    scene, structures = checker.scene, checker.log.structures
    if len(scene.ids) > MOST_OBJECTS:
        checker.undone[5] = "%d objects; it is for at most %d" % (len(scene.ids), MOST_OBJECTS)
        return
    followed = [i for i, r in enumerate(checker.replays) if r is not None]
    if not followed:
        checker.undone[5] = "no structure of the log has a replay"
        return
    keys = {i: checker.key_of(structures[i]) for i in followed}
    world = World(scene)
    history, told, gaps, roots = checker.history, 0, 0, {}
    untouched = set()  # structures whose attribute at a time does not follow from positions, or would take too long
    changes, place = scene.changes, 0
    begin = Instant.rational(scene.start.numerator, scene.start.denominator)
    while True:
        t = changes[place][0] if place < len(changes) else None
        until = None if t is None else Instant.rational(t.numerator, t.denominator)
        if until is None or (end is not None and compare(until, end) > 0):
            until, t = end, None
        period = Period(world, begin, until, roots)
        owns = {i: own_objects(structures[i].name, structures[i].options, scene) for i in followed}
        present = {i: world.alive if owns[i] is None else world.alive & owns[i] for i in followed}
        queries = {q for i in followed for q in queries_of(structures[i], keys[i], present[i], period)}
        if len(queries) > MOST_QUERIES:
            checker.undone[5] = "%d signs of which the attributes are made; it is for at most %d" % (
                len(queries), MOST_QUERIES)
            return
        for _, point in period.samples(queries):
            gaps += 1
            checker.progress.show("level 5: gap between instants", gaps)
            if gaps > MOST_GAPS:
                checker.undone[5] = "more than %d gaps" % MOST_GAPS
                return
            sample = Instant.rational(point.numerator, point.denominator)
            while told + 1 < len(history) and compare(history[told + 1][0], sample) < 0:
                told += 1
            positions = period.positions_of(world.alive, point)
            for i in followed:
                right = attribute_of(structures[i], keys[i], {o: positions[o] for o in present[i]}, scene)
                if right is None:
                    untouched.add(structures[i].label)
                elif history[told][1][i] != right:
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
    not_judged = ", ".join(s.label for s in structures if s.label in untouched)
    if len(untouched) == len(followed):
        checker.undone[5] = "not for " + not_judged
    else:
        checker.done[5] = count(gaps, "gap") + " between instants" + ("; not for " + not_judged if not_judged else "")


def shown(scene, attribute):
    return "[" + ", ".join(shown(scene, i) if isinstance(i, tuple) else scene.ids[i] for i in attribute) + "]"
