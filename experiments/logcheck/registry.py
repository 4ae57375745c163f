# SPDX-License-Identifier: GPL-3.0-or-later
"""The replay of each structure."""

from replay_delaunay import Delaunay
from replay_envelopes import Envelopes
from replay_heaps import Hanger, Heap, Tournament
from replay_hull import HullBruteForce, HullOfDelaunay
from replay_list import SortedList
from replay_maximum import Maximum, OfList
from replay_scratch import BoundingBox, ClosestPair

REPLAYS = {"sorted_list": SortedList, "delaunay_2": Delaunay,
            "convex_hull_2_brute_force": HullBruteForce, "convex_hull_2_delaunay": HullOfDelaunay,
            "convex_hull_2": Envelopes, "convex_hull_2_naive": Envelopes,
            "bounding_box": BoundingBox, "closest_pair_delaunay": ClosestPair}
for extremum in ("maximum_", "minimum_"):
    REPLAYS.update({extremum + "sorted_list": OfList, extremum + "heap": Heap, extremum + "hanger": Hanger,
                    extremum + "tournament": Tournament, extremum + "envelope": Maximum,
                    extremum + "dual_hull": Maximum})
BODY_STRUCTURES = ["separation_mixed", "separation_minkowski", "separation_hysteresis", "closest_features",
                   "inner_tangents", "bounding_volumes", "outer_hierarchy"]


def replay_of(name):
    return REPLAYS.get(name)
