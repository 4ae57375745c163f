# SPDX-License-Identifier: GPL-3.0-or-later
"""Level 5: every polynomial on which an attribute depends, whether or not it is in a structure's proof."""

from functools import partial
from itertools import combinations, permutations, product

from brute_attributes import farthest, hull_of, pairs_of
from brute_flush import ORDERS, candidates_of
from octants import AXES
from polygons import cones, counted, turned, units
from polynomials import sign_at
from replay_boxes import box_order, boxes
from replay_calipers import folds_of
from replay_discs import GAP_TERMS, gap_query
from replay_directions import extent_query, half_directions, k_of, opposite
from replay_lines import line_query, lines_and_points, measure_of
from replay_norms import MOST_MEMBERS, norm_queries
from replay_octants import corners_of
from subsets import query_of


def queries_of(structure, key, members, period):
    """The polynomials that the attribute depends on in a period (gaps.py)."""
    from predicates import Key, axis_order, distance_query

    scene = period.world.scene
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
    if name == "closest_pair_discs":
        pairs = list(combinations(sorted(members), 2))
        for pair in pairs:
            yield ("disc_overlap", pair)
        for front, back in combinations(pairs, 2):
            for term in GAP_TERMS:
                yield gap_query(term, front, back)
        return
    if name.startswith("closest_point_line"):
        lines, points = lines_and_points(members, scene)
        for front, back in combinations(product(lines, points), 2):
            yield line_query(measure_of(name), front, back)
        return
    if name.startswith("incidences_") or name == "points_in_arrangement":
        lines, points = lines_and_points(members, scene)
        for line, point in product(lines, points):
            yield ("line_side", (line, point))
        if name == "points_in_arrangement":
            for pair, point in product(combinations(lines, 2), points):
                yield ("line_order", (*pair, point))
        return
    if name in ("line_arrangement_2", "trapezoids_2"):
        lines = [o for o in sorted(members) if scene.objects[o].line]
        for pair in combinations(lines, 2):
            yield ("order_x", pair)
            yield ("order_y", pair)
        for triple in combinations(lines, 3):
            yield ("orientation_2", triple)
        for a, b, c, d in combinations(lines, 4) if name == "trapezoids_2" else []:
            yield from (("slope_order_2", ids) for ids in ((a, b, c, d), (a, c, b, d), (a, d, b, c)))
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
    if name == "bichromatic_pair_maximum_norm":
        yield from norm_queries(members, pairs_of(structure, members, scene))
        return
    if name.startswith("mst_polygon_"):
        if len(members) <= MOST_MEMBERS:
            yield from polygon_queries(corners_of(structure), members, period)
        return
    if name in ORDERS:
        yield from flush_queries(name, members, period)
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
    if name.endswith("_directions"):
        yield from along_directions(structure, members, period)
        return
    if name.startswith("directions_2"):
        yield from orders_along(half_directions(k_of(structure)), members)
    yield from signs_of_hull(members)
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


def signs_of_hull(members):
    for pair in combinations(sorted(members), 2):
        yield ("order_x", pair)
        yield ("order_y", pair)
    for triple in combinations(sorted(members), 3):
        yield ("orientation_2", triple)


def flush_queries(name, members, period):
    """The hull; between two changes of it what calipers touch, and between two changes of that the best of the strips or
    rectangles against all others."""
    hulls = list(signs_of_hull(members))
    yield from hulls
    for gap, t in period.samples(hulls):
        cycle = hull_of(gap.positions_of(members, t))
        if len(cycle) < 3:
            continue
        contacts = [(predicate, edge + pair) for edge in zip(cycle, cycle[1:] + cycle[:1])
                    for pair in combinations(sorted(cycle), 2)
                    for predicate in ("slope_order_2", "edge_dot_2")[:1 if name == "width_2" else 2]]
        yield from contacts
        for part, u in gap.samples(contacts):
            found = candidates_of(name, cycle, part.positions_of(members, u))
            yield from best_against_all(found, lambda one, other: (ORDERS[name], one + other), part, u)


def polygon_queries(corners, members, period):
    """The cones that pairs are in; between two changes of these each two lengths, and the turned ones of those that are
    identically equal."""
    pairs = list(combinations(sorted(members), 2))
    sides = {u for cone in counted(corners) for u, _ in cones(corners)[cone][:2]}
    orders = [(("order_direction", u), pair) for u in sides for pair in pairs]
    yield from orders
    for gap, t in period.samples(orders):
        positions = gap.positions_of(members, t)
        forms = [longest_forms(corners, positions, pair) for pair in pairs]
        for one, other in [*combinations(forms, 2), *((form, form) for form in forms if len(form) > 1)]:
            for (u, a, b), (v, c, d) in product(one, other):
                query = extent_query(u, v, b, a, d, c)
                if query is not None and not gap.world.is_zero(query):
                    yield query
                elif (turn := extent_query(turned(u), turned(v), b, a, d, c)) is not None:
                    yield turn


def longest_forms(corners, positions, pair):
    """[(u, from, to)]: those of which the step along u is the pair's length."""
    lengths = {}
    for u in units(corners):
        for a, b in (pair, pair[::-1]):
            lengths[u, a, b] = sum(c * (q - p) for c, p, q in zip(u, positions[a], positions[b]))
    return [form for form, length in lengths.items() if length == max(lengths.values())]


def orders_along(directions, members):
    for u in directions:
        for pair in combinations(sorted(members), 2):
            yield (("order_direction", u), pair)


def along_directions(structure, members, period):
    """Orders along every direction; between two exchanges in these, of the extents or boxes whose ends are known then,
    the best one against all others."""
    half = half_directions(k_of(structure), period.world.scene.dimension)
    orders = list(orders_along(half, members))
    yield from orders
    for gap, t in period.samples(orders) if members else []:
        positions = gap.positions_of(members, t)
        if "rectangle" in structure.name:
            found = [(box[0], tuple(farthest(positions, u) for u in box)) for box in boxes(k_of(structure))]
            claim = partial(box_order, "order_box_area" if "area" in structure.name else "order_box_perimeter")
        else:
            found = [(u, farthest(positions, u), farthest(positions, opposite(u))) for u in half]
            claim = extents_in_order if structure.name == "width_directions" else extents_in_reverse
        yield from best_against_all(found, claim, gap, t)


def extents_in_order(one, other):
    """The second is at least as large as the first; None: they are identically equal."""
    return extent_query(other[0], one[0], *other[1:], *one[1:])


def extents_in_reverse(one, other):
    return extents_in_order(other, one)


def best_against_all(found, claim, gap, t):
    """The claims that the best of some is at least as good as each other one, whichever is the best in parts of the gap.
    `t`: a time in it."""
    def is_better(one, other, t):
        query = claim(other, one)
        return query is not None and sign_at(gap.world.polynomial(*query), t.numerator, t.denominator) < 0

    best = found[0]
    for other in found[1:]:
        if is_better(other, best, t):
            best = other
    queries = [claim(best, other) for other in found if other is not best]
    queries = [query for query in queries if query is not None]
    yield from queries
    for part, u in gap.samples(queries):
        if any(is_better(other, best, u) for other in found):
            yield from best_against_all(found, claim, part, u)
