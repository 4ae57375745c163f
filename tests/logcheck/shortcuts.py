# SPDX-License-Identifier: GPL-3.0-or-later
"""What kinex-logcheck does otherwise than by definition, to be fast: pointers by places, queries kept while the motions last,
meanings by doubles first, positions in whole numbers.

usage: shortcuts.py LOGCHECK_FOLDER
"""
import json
import random
import sys
import types
import unittest
from fractions import Fraction

import logs

logs.checker(sys.argv.pop(1))
import gaps  # noqa: E402
import octants  # noqa: E402
import roots  # noqa: E402
from replay_directions import Along  # noqa: E402
from scene import Scene  # noqa: E402
from world import World  # noqa: E402

SCENE = logs.SCENE


class Pointers(unittest.TestCase):
    @staticmethod
    def by_definition(members, precedes):
        """Every point against every other, in every cone."""
        def ahead(axis, way, a, b):
            return precedes(axis, a, b) if way > 0 else precedes(axis, b, a)

        result = {}
        for p in members:
            for cone, (one, other, by) in enumerate(octants.CONES):
                for q in members:
                    if q == p or not ahead(*one, p, q) or not ahead(*other, p, q):
                        continue
                    if (p, cone) not in result or ahead(*by, q, result[p, cone]):
                        result[p, cone] = q
        return result

    def test_places_lead_to_those_of_the_definition(self):
        rng = random.Random(3)
        for k in range(40):
            n, size = rng.randint(1, 9), rng.choice((2, 4, 30))  # with level points, and equal ones
            positions = [(rng.randint(0, size), rng.randint(0, size)) for _ in range(n)]

            def sign(axis, a, b):
                u = ((1, 0), (0, 1), (1, 1), (1, -1))[axis]
                value = sum(c * (y - x) for c, x, y in zip(u, positions[a], positions[b]))
                return (value > 0) - (value < 0)

            precedes = octants.precedes_by(sign)
            self.assertEqual(octants.pointers_of(range(n), precedes), self.by_definition(range(n), precedes))

    def test_every_axis_is_sorted_once(self):
        asked = []

        def precedes(axis, a, b):
            asked.append(axis)
            return a < b

        octants.pointers_of(range(30), precedes)
        self.assertLess(len(asked), 4 * 30 * 6)  # n log n an axis; every cone, point and point would be 5000 and more


class InForce(unittest.TestCase):
    def test_queries_are_made_anew_when_a_motion_changes(self):
        scene = Scene("two", json.dumps(SCENE))
        world = World(scene)
        query = ("order_x", (0, 1))
        changes, sign = world.changes(*query)
        self.assertIs(world.changes(*query)[0], changes)
        self.assertEqual((world.changes("order_x", (1, 0))[0], world.changes("order_x", (1, 0))[1]), (changes, -sign))
        world.set_motion(0, world.piece[1])
        self.assertTrue(world.is_zero(query))


class Meanings(unittest.TestCase):
    """What a certificate between extents can mean, by doubles first."""
    IDS = (0, 1, 2, 3)

    def extents(self, unit):
        """Four points in space whose coordinates have the size of `unit`."""
        random.seed(5)
        objects = [{"id": f"p{i}", "motion": [[str(unit * random.randint(-50, 50)) for _ in range(2)] for _ in range(3)]}
                   for i in self.IDS]
        replay = Along()
        replay.structure = types.SimpleNamespace(name="diameter_directions", options={})
        replay.world = World(Scene("four", json.dumps(dict(
            SCENE, dimension=3, objects=objects, maintain=["diameter_directions"]))))
        return replay

    def test_what_fails_is_among_the_first(self):
        for unit in (1, Fraction(1, 10 ** 300), 10 ** 200):
            replay = self.extents(unit)
            meanings = list(replay.meanings("order_extent", self.IDS))
            for query in meanings[::499]:
                for x in replay.world.changes(*query)[0].roots:
                    likely = list(replay.likely("order_extent", self.IDS, x))
                    self.assertIn(query, likely)
                    self.assertLess(len(likely), 10)
                    self.assertLessEqual(set(likely), set(meanings))

    def test_where_doubles_overflow_there_are_none(self):
        replay = self.extents(10 ** 400)
        x = roots.Instant.rational(1)
        self.assertEqual(list(replay.likely("order_extent", self.IDS, x)), [])
        self.assertEqual(list(replay.likely("order_direction", (0, 1), x)), [])


class Positions(unittest.TestCase):
    """At a time, for level 5."""

    def at_a_third(self, *objects):
        scene = Scene("some", json.dumps(dict(
            SCENE, dimension=2, objects=[dict(o, id=f"p{i}") for i, o in enumerate(objects)], maintain=["delaunay_2"])))
        world = World(scene)
        now = roots.Instant.rational(0)
        positions = gaps.Period(world, now, None, {}).positions_of(range(len(objects)), Fraction(1, 3))
        return [list(p) + p.extents for p in positions.values()]

    def test_whole_numbers(self):
        half = {"motion": [["1/2", 1], [0]]}
        self.assertEqual(self.at_a_third(half, {"motion": [[1], ["1/4"]]}), [[10, 0], [12, 3]])
        self.assertEqual(self.at_a_third(dict(half, radius=[1])), [[5, 0, 6]])
        self.assertEqual(self.at_a_third(dict(half, weight=["1/2", "1/2"])), [[5, 0, 24]])

    def test_lines_have_no_unit(self):
        line = {"motion": [["1/2", 1], [0]], "line": True}
        self.assertEqual(self.at_a_third(line, {"motion": [[1], ["1/4"]]}),
                         [[Fraction(5, 6), 0], [1, Fraction(1, 4)]])


unittest.main()
