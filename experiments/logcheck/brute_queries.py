# SPDX-License-Identifier: GPL-3.0-or-later
"""Level 5: every polynomial on which an attribute depends, whether or not it is in a structure's proof."""

from itertools import combinations, permutations

from brute_attributes import few_extents, pairs_of
from octants import AXES
from polygons import cones, corners_of
from replay_calipers import folds_of
from replay_directions import extent_query, half_directions, k_of
from replay_norms import MOST_MEMBERS, norm_queries
from subsets import query_of


def queries_of(structure, key, members, scene):
    """The polynomials that the attribute depends on."""
    from predicates import Key, axis_order, distance_query

    name, dimension = structure.name, scene.dimension
    if name == "sorted_list" or name.startswith(("maximum_", "minimum_")):
        k = Key(key)
        for a, b in combinations(sorted(members - {k.reference}), 2):
            yield k.claim(a, b)
        return
    if name == "nearest_site":
        query = query_of(structure.options, scene)
        for pair in combinations(sorted(members - {query}), 2):
            if query in members:
                yield ("order_squared_distance", (*pair, query))
        return
    if name.startswith("graph_mst_"):
        for pair in combinations(sorted(members), 2):
            yield (axis_order(0), pair)
        return
    if name.startswith("disc_pairs_"):
        for pair in combinations(sorted(members), 2):
            yield ("disc_overlap", pair)
        return
    if name.startswith("incidences_"):
        for line, point in permutations(sorted(members), 2):
            if scene.objects[line].line and not scene.objects[point].line:
                yield ("line_side", (line, point))
        return
    if name == "line_arrangement_2":
        lines = [o for o in sorted(members) if scene.objects[o].line]
        for pair in combinations(lines, 2):
            yield ("order_x", pair)
            yield ("order_y", pair)
        for triple in combinations(lines, 3):
            yield ("orientation_2", triple)
        return
    if name == "box_pairs":
        for pair in permutations(sorted(members), 2):
            for axis in range(dimension):
                yield ("meeting_" + "xyz"[axis], pair)
        return
    if name == "trajectory_tree":
        return
    if name in ("bounding_box", "range_tree_2", "rank_kd_tree_2", "pseudo_kd_tree_2"):
        for pair in combinations(sorted(members), 2):
            for axis in range(dimension):
                yield (axis_order(axis), pair)
        return
    if name.startswith("mst_maximum_norm_"):
        if len(members) <= MOST_MEMBERS:
            yield from norm_queries(members)
        return
    if name.startswith("mst_polygon_"):
        return
    if name == "cones_local":
        for pair in combinations(sorted(members), 2):
            for cone in cones(corners_of(structure)):
                for u, _ in cone:
                    yield (("order_direction", u), pair)
        return
    if name.startswith("octants_"):
        for pair in combinations(sorted(members), 2):
            for axis in AXES:
                yield (axis, pair)
        return
    if name.startswith(("closest_pair_", "bichromatic_pair_")) or name in (
                "diameter_2", "diameter_all_pairs", "emst_list", "emst_cycles", "emst_clusters"):
        pairs = pairs_of(structure, members, scene)
        for front, back in combinations(pairs, 2):
            yield distance_query(front, back)
        return
    if name in ("delaunay_3", "regular_3"):
        power = ("in_sphere_3" if name == "delaunay_3" else
                 "disc_power_3" if scene.extents == "radius" else "power_3")
        for size, predicate in ((4, "orientation_3"), (5, power)):
            for some in combinations(sorted(members), size):
                yield (predicate, some)
        for pair in combinations(sorted(members), 2):
            for axis in range(3):
                yield (axis_order(axis), pair)
        return
    if name.startswith("min_circle_2"):
        for a, b, c in combinations(sorted(members), 3):
            for triple in ((a, b, c), (b, c, a), (c, a, b)):
                yield ("acute_angle_2", triple)
    if name.startswith("directions_2") or name in ("diameter_directions", "width_directions"):
        yield from along_directions(structure, members, dimension)
        return
    for pair in combinations(sorted(members), 2):
        yield ("order_x", pair)
        yield ("order_y", pair)
    for triple in combinations(sorted(members), 3):
        yield ("orientation_2", triple)
    if name == "calipers_2":
        for first, second in combinations(combinations(sorted(members), 2), 2):
            yield ("slope_order_2", first + second)
            if folds_of(structure) == 4:
                yield ("edge_dot_2", first + second)
    if name == "regular_2":
        for quad in combinations(sorted(members), 4):
            yield ("disc_power_2" if scene.extents == "radius" else "power_2", quad)
    if name in ("delaunay_2", "farthest_delaunay_2", "voronoi_cell_2") or name.startswith("min_circle_2"):
        for quad in combinations(sorted(members), 4):
            yield ("in_circle_2", quad)


def along_directions(structure, members, dimension):
    """Orders along every direction; for extents all pairs of extents, whatever their ends."""
    half = half_directions(k_of(structure), dimension)
    for u in half:
        for pair in combinations(sorted(members), 2):
            yield (("order_direction", u), pair)
    if structure.name.startswith("directions_2") or not few_extents(structure, members, dimension):
        return
    pairs = list(permutations(sorted(members), 2))
    for u, v in combinations(half, 2):
        for a, b in pairs:
            for c, d in pairs:
                yield extent_query(u, v, a, b, c, d)
