# SPDX-License-Identifier: GPL-3.0-or-later
"""The replay of each structure. A structure without one is reported as such: its certificates are checked where their
formulas are known, its events are not followed."""

from replay_boxes import RectangleAlong
from replay_calipers import Area, Calipers, FarthestPairOfHull, Perimeter, Width
from replay_circle import BoxOfHull, FarthestDelaunay, MinCircle
from replay_delaunay import Delaunay
from replay_discs import ClosestDiscs
from replay_directions import Directions, DirectionsByTournaments, Extent
from replay_envelopes import Envelopes
from replay_grid import ClosestPairOfCells, DiscsOfCells
from replay_heaps import Hanger, Heap, Tournament
from replay_hull import HullBruteForce, HullOfDelaunay
from replay_kd import PseudoKdTree, RankKdTree
from replay_lines import ArrangementOfLines, ClosestPointLine, PointsAboveLines, PointsOfCells
from replay_list import SortedList
from replay_locations import LinesNextToPoints
from replay_maximum import Maximum, OfList
from replay_norms import MaximumNormTree, NearestInMaximumNorm, PolygonTree
from replay_octants import Cones, Octants
from replay_pairs import BoxesThatMeet, DiscsThatMeet
from replay_range import RangeTree, TrajectoryTree
from replay_regular import RegularInSpace, RegularInThePlane
from replay_scratch import (BoundingBox, ClosestPair, ClosestPairOfOrders, FarthestPair, NearestSite, TwoColours)
from replay_space import DelaunayInSpace
from replay_trees import GraphTree, SpanningTree
from replay_voronoi import VoronoiCell
from replay_walls import WallsOfLines

REPLAYS = {"sorted_list": SortedList, "delaunay_2": Delaunay, "delaunay_3": DelaunayInSpace,
            "regular_2": RegularInThePlane, "regular_3": RegularInSpace,
            "convex_hull_2_brute_force": HullBruteForce, "convex_hull_2_delaunay": HullOfDelaunay,
            "convex_hull_2": Envelopes, "convex_hull_2_naive": Envelopes,
            "bounding_box": BoundingBox, "closest_pair_delaunay": ClosestPair,
            "closest_pair_all": ClosestPair, "closest_pair_range_tree": ClosestPairOfOrders,
            "closest_pair_cones": ClosestPair, "closest_pair_local": ClosestPair,
            "closest_pair_bins": ClosestPairOfCells, "closest_pair_discs": ClosestDiscs,
            "octants_listed": Octants, "octants_local": Octants, "cones_local": Cones,
            "nearest_site": NearestSite, "voronoi_cell_2": VoronoiCell,
            "bichromatic_pair_delaunay": TwoColours, "bichromatic_pair_all": TwoColours,
            "bichromatic_pair_maximum_norm": NearestInMaximumNorm,
            "mst_maximum_norm_list": MaximumNormTree, "mst_maximum_norm_cycles": MaximumNormTree,
            "mst_maximum_norm_clusters": MaximumNormTree,
            "mst_polygon_list": PolygonTree, "mst_polygon_cycles": PolygonTree,
            "mst_polygon_clusters": PolygonTree,
            "emst_list": SpanningTree, "emst_cycles": SpanningTree, "emst_clusters": SpanningTree,
            "box_pairs": BoxesThatMeet, "disc_pairs_all": DiscsThatMeet, "disc_pairs_boxes": DiscsThatMeet,
            "disc_pairs_grid": DiscsOfCells,
            "closest_point_line": ClosestPointLine, "closest_point_line_vertical": ClosestPointLine,
            "incidences_all": PointsAboveLines, "incidences_cutting": PointsOfCells, "line_arrangement_2": ArrangementOfLines,
            "points_in_arrangement": LinesNextToPoints, "trapezoids_2": WallsOfLines,
            "graph_mst_list": GraphTree, "graph_mst_cycles": GraphTree,
            "graph_mst_clusters": GraphTree, "graph_mst_sparsified": GraphTree,
            "diameter_2": FarthestPairOfHull, "diameter_all_pairs": FarthestPair,
            "bounding_box_2_hull": BoxOfHull, "farthest_delaunay_2": FarthestDelaunay,
            "min_circle_2": MinCircle, "min_circle_2_brute_force": MinCircle,
            "range_tree_2": RangeTree, "rank_kd_tree_2": RankKdTree, "pseudo_kd_tree_2": PseudoKdTree,
            "calipers_2": Calipers,
            "trajectory_tree": TrajectoryTree,
            "width_2": Width, "min_area_rectangle_2": Area, "min_perimeter_rectangle_2": Perimeter,
            "directions_2": Directions, "directions_2_tournament": DirectionsByTournaments,
            "diameter_directions": Extent, "width_directions": Extent,
            "min_area_rectangle_directions": RectangleAlong, "min_perimeter_rectangle_directions": RectangleAlong}
for extremum in ("maximum_", "minimum_"):
    REPLAYS.update({extremum + "sorted_list": OfList, extremum + "heap": Heap, extremum + "hanger": Hanger,
                    extremum + "tournament": Tournament, extremum + "envelope": Maximum,
                    extremum + "dual_hull": Maximum})


def is_partial_hull(name):
    return name in REPLAYS and REPLAYS[name].partial_hull


def reads_partial_hull(options):
    over = (options or {}).get("over")
    return is_partial_hull(over["structure"] if isinstance(over, dict) else over)


def replay_of(name, options=None):
    """None: the structure has none, or none over what it reads."""
    return None if reads_partial_hull(options) else REPLAYS.get(name)
