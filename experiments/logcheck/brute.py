# SPDX-License-Identifier: GPL-3.0-or-later
"""Level 5: small scenes by brute force.

The instants at which anything can change are all found: every root of every predicate over every tuple of
objects, whether or not it is in a structure's proof. At a rational time between two consecutive instants the
attribute is computed from positions and compared with the attribute that the log's events lead to.
"""

from fractions import Fraction
from itertools import combinations, permutations

from log import Wrong
from octants import AXES, pairs_of_positions
from replay_calipers import folds_of
from replay_directions import all_directions, extent_query, half_directions, k_of, opposite
from roots import Instant, all_roots, compare
from scene import Extended
from space import cells_of
from static import forest_edges, spanning_tree
from subsets import TWO_COLOURS, classes_of, own_objects, query_of
from world import World

MOST_OBJECTS = 12
MOST_GAPS = 20000
MOST_EXTENTS = 12000


# ---- attributes from positions


def value_of(key, positions, o):
    kind, what = key
    if kind == "axis":
        return positions[o][what]
    if kind == "direction":
        return sum(v * c for v, c in zip(what, positions[o]))
    return sum((a - b) ** 2 for a, b in zip(positions[o], positions[what]))


def ordered(key, positions):
    members = [o for o in positions if key[0] != "distance" or o != key[1]]
    return sorted(members, key=lambda o: (value_of(key, positions, o), o))


def turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def without_equals(positions):
    """Of equal points the smallest number."""
    seen, result = set(), {}
    for o in sorted(positions):
        if tuple(positions[o]) not in seen:
            seen.add(tuple(positions[o]))
            result[o] = positions[o]
    return result


def between(a, b, p):
    return min(a[0], b[0]) <= p[0] <= max(a[0], b[0]) and min(a[1], b[1]) <= p[1] <= max(a[1], b[1])


def hull_of(positions):
    points = without_equals(positions)
    if len(points) < 3:
        return sorted(points)
    after = {}
    for a in points:
        for b in points:
            if a != b and all(s > 0 or (s == 0 and between(points[a], points[b], points[p]))
                              for p in points if p not in (a, b)
                              for s in [turn(points[a], points[b], points[p])]):
                after[a] = b
    cycle = [min(after)]
    while after[cycle[-1]] != cycle[0]:
        cycle.append(after[cycle[-1]])
    return cycle


def in_circle(a, b, c, d):
    rows = [(p[0] - d[0], p[1] - d[1]) for p in (a, b, c)]
    (ax, ay), (bx, by), (cx, cy) = rows
    aa, bb, cc = (x * x + y * y for x, y in rows)
    return aa * (bx * cy - by * cx) + bb * (cx * ay - cy * ax) + cc * (ax * by - ay * bx)


def delaunay_of(positions):
    """Every empty circle through three points gives the polygon of all points on it, and the fan of its
    smallest number."""
    points = without_equals(positions)
    edges = set()
    flat = True
    for triple in combinations(sorted(points), 3):
        a, b, c = triple
        side = turn(points[a], points[b], points[c])
        if side == 0:
            continue
        flat = False
        if side < 0:
            b, c = c, b
        signs = {d: in_circle(points[a], points[b], points[c], points[d]) for d in points if d not in triple}
        if any(s > 0 for s in signs.values()):
            continue
        circle = list(triple) + [d for d, s in signs.items() if s == 0]
        if triple != tuple(sorted(circle)[:3]):
            continue
        cycle = hull_of({o: points[o] for o in circle})
        edges.update((min(e), max(e)) for e in zip(cycle, cycle[1:] + cycle[:1]))
        edges.update((cycle[0], o) for o in cycle[1:])
    if flat:
        line = sorted(points, key=lambda o: tuple(points[o]))
        edges = {(min(e), max(e)) for e in zip(line, line[1:])}
    return sorted(edges)


def box_of(positions):
    members = sorted(positions)
    result = []
    for axis in range(len(positions[members[0]]) if members else 0):
        for extreme in (min, max):
            result.append(extreme(members, key=lambda o: positions[o][axis]))
    return result


def box_of_hull(positions):
    """As box_of, among the vertices of the hull."""
    return box_of({o: positions[o] for o in hull_of(positions)})


def acute(a, b, c):
    """Positive: the angle at b is acute."""
    return (a[0] - b[0]) * (c[0] - b[0]) + (a[1] - b[1]) * (c[1] - b[1])


def farthest_delaunay_of(positions):
    """Every circle through three vertices of the hull that holds all of them gives the polygon of all vertices
    on it, and the fan of its smallest number."""
    cycle = hull_of(positions)
    edges = {(min(e), max(e)) for e in zip(cycle, cycle[1:] + cycle[:1]) if e[0] != e[1]}
    for a, b, c in combinations(cycle, 3):
        signs = {d: in_circle(*(positions[o] for o in (a, b, c, d))) for d in cycle if d not in (a, b, c)}
        if any(s < 0 for s in signs.values()):
            continue
        circle = {a, b, c} | {d for d, s in signs.items() if s == 0}
        polygon = [o for o in cycle if o in circle]
        least = min(polygon)
        edges.update((min(e), max(e)) for e in zip(polygon, polygon[1:] + polygon[:1]))
        edges.update((least, o) for o in polygon if o != least)
    return sorted(edges)


def circle_of(positions):
    """The vertices on the smallest circle: that of two or three vertices which holds all."""
    points = without_equals(positions)
    if len(points) < 2:
        return sorted(points)
    for a, b in combinations(sorted(points), 2):
        signs = {p: -acute(points[a], points[p], points[b]) for p in points if p not in (a, b)}
        if all(s >= 0 for s in signs.values()):
            return sorted([a, b] + [p for p, s in signs.items() if s == 0])
    for a, b, c in combinations(sorted(points), 3):
        u, v, w = points[a], points[b], points[c]
        side = turn(u, v, w)
        if side == 0 or min(acute(u, v, w), acute(v, w, u), acute(w, u, v)) < 0:
            continue
        signs = {p: side * in_circle(u, v, w, points[p]) for p in points if p not in (a, b, c)}
        if all(s >= 0 for s in signs.values()):
            return sorted([a, b, c] + [p for p, s in signs.items() if s == 0])
    raise AssertionError("points without a smallest circle")


def calipers_of(positions, folds):
    """For each edge what the calipers touch when they have passed it: its head, and in each other fold the lowest
    vertex; of two that are level, the ends of an edge, the head if its tail is smaller than that of the first."""
    cycle = hull_of(positions)
    if len(cycle) < 3:
        return [tuple(sorted(cycle * (folds // 2)))] if len(cycle) == 2 else []
    following = dict(zip(cycle, cycle[1:] + cycle[:1]))
    touched = []
    for a, b in following.items():
        u = tuple(q - p for p, q in zip(positions[a], positions[b]))
        contacts = [b]
        for _ in range(folds - 1):
            u = (-u[0], -u[1]) if folds == 2 else (-u[1], u[0])
            heights = {o: u[0] * positions[o][1] - u[1] * positions[o][0] for o in cycle}
            low = [o for o in cycle if heights[o] == min(heights.values())]
            tail = low[0] if len(low) == 1 or following[low[0]] == low[1] else low[1]
            contacts.append(following[tail] if len(low) == 2 and tail < a else tail)
        touched.append(tuple(sorted(contacts)))
    return sorted(touched)


def squared_distance(positions, pair):
    return sum((a - b) ** 2 for a, b in zip(positions[pair[0]], positions[pair[1]]))


def pairs_of(structure, members, scene):
    """All pairs; those of two colours for structures of two colours."""
    pairs = combinations(sorted(members), 2)
    if structure.name not in TWO_COLOURS:
        return list(pairs)
    red, blue = classes_of(structure.options, scene)
    return [(a, b) for a, b in pairs if (a in red and b in blue) or (a in blue and b in red)]


def nearest_of(query, positions):
    sites = [o for o in sorted(positions) if o != query]
    if query not in positions or not sites:
        return []
    return [min(sites, key=lambda o: squared_distance(positions, (query, o)))]


def lightest_of(positions, scene):
    """The edges of the minimum spanning forest of a graph."""
    order = sorted(positions, key=lambda o: (positions[o][0], o))
    return sorted((o,) for o in forest_edges(order, scene))


def closest_of(pairs, positions):
    return [min(pairs, key=lambda pair: squared_distance(positions, pair))] if pairs else []


def tree_of(positions):
    """Kruskal's algorithm; of equal lengths the smaller pair comes first."""
    pairs = sorted(combinations(sorted(positions), 2), key=lambda pair: (squared_distance(positions, pair), pair))
    return spanning_tree(pairs)


def farthest_of(positions):
    pairs = list(combinations(sorted(positions), 2))
    return [max(pairs, key=lambda pair: (squared_distance(positions, pair), [-o for o in pair]))] if pairs else []


def farthest(positions, u):
    """The farthest along u; of those that are level the smallest number."""
    return max(sorted(positions), key=lambda o: u[0] * positions[o][0] + u[1] * positions[o][1])


def polygon_of(positions, directions):
    if not positions:
        return []
    return hull_of({o: positions[o] for o in {farthest(positions, u) for u in directions}})


def extent_of(positions, directions, largest):
    best = None
    for u in directions if positions else []:
        a, b = farthest(positions, u), farthest(positions, opposite(u))
        extent = sum(v * (p - q) for v, p, q in zip(u, positions[a], positions[b]))
        if best is None or (extent > best[0] if largest else extent < best[0]):
            best = (extent, a, b)
    return [] if best is None or best[1] == best[2] else [tuple(sorted(best[1:]))]


def boxes_meet(a, b):
    return all(abs(a[i] - b[i]) <= a.half(i) + b.half(i) for i in range(len(a)))


def discs_meet(a, b):
    return sum((p - q) ** 2 for p, q in zip(a, b)) <= (a.half(0) + b.half(0)) ** 2


def meetings_of(positions, meet):
    return [(a, b) for a, b in combinations(sorted(positions), 2) if meet(positions[a], positions[b])]


def attribute_of(structure, key, positions, scene):
    name = structure.name
    if name == "sorted_list":
        return ordered(key, positions)
    if name.startswith(("maximum_", "minimum_")):
        order = ordered(key, positions)
        if not order:
            return []
        if name.startswith("minimum_"):
            return order[:1]
        most = value_of(key, positions, order[-1])
        return [next(o for o in order if value_of(key, positions, o) == most)]
    if name.startswith("convex_hull_2"):
        return hull_of(positions)
    if name == "delaunay_2":
        return delaunay_of(positions)
    if name == "delaunay_3":
        return cells_of(positions)
    if name == "bounding_box":
        return box_of(positions)
    if name.startswith("octants_"):
        return pairs_of_positions(positions)
    if name.startswith(("closest_pair_", "bichromatic_pair_")):
        return closest_of(pairs_of(structure, positions, scene), positions)
    if name == "nearest_site":
        return nearest_of(query_of(structure.options, scene), positions)
    if name.startswith("graph_mst_"):
        return lightest_of(positions, scene)
    if name == "box_pairs":
        return meetings_of(positions, boxes_meet)
    if name.startswith("disc_pairs_"):
        return meetings_of(positions, discs_meet)
    if name.startswith("emst_"):
        return tree_of(positions)
    if name in ("diameter_2", "diameter_all_pairs"):
        return farthest_of(positions)
    if name == "bounding_box_2_hull":
        return box_of_hull(positions)
    if name == "calipers_2":
        return calipers_of(positions, folds_of(structure))
    if name == "farthest_delaunay_2":
        return farthest_delaunay_of(positions)
    if name.startswith("min_circle_2"):
        return circle_of(positions)
    if name == "range_tree_2":
        return ordered(("axis", 0), positions) + ordered(("axis", 1), positions)
    if name == "trajectory_tree":
        return sorted(positions)
    if name.startswith("directions_2"):
        return polygon_of(positions, all_directions(k_of(structure)))
    if name in ("diameter_directions", "width_directions"):
        dimension = len(next(iter(positions.values()), (0, 0)))
        if not few_extents(structure, positions, dimension):
            return None
        return extent_of(positions, half_directions(k_of(structure), dimension), name == "diameter_directions")
    return None


# ---- instants


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
    if name.startswith("octants_"):
        for pair in combinations(sorted(members), 2):
            for axis in AXES:
                yield (axis, pair)
        return
    if name.startswith(("closest_pair_", "bichromatic_pair_")) or name in (
                "diameter_2", "diameter_all_pairs", "emst_list", "emst_cycles"):
        pairs = pairs_of(structure, members, scene)
        for front, back in combinations(pairs, 2):
            yield distance_query(front, back)
        return
    if name == "delaunay_3":
        for size, predicate in ((4, "orientation_3"), (5, "in_sphere_3")):
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
    if name in ("delaunay_2", "farthest_delaunay_2") or name.startswith("min_circle_2"):
        for quad in combinations(sorted(members), 4):
            yield ("in_circle_2", quad)


def few_extents(structure, members, dimension):
    """Pairs of extents of other scenes are too many: their attribute is checked at levels 3 and 4 only."""
    half, n = len(half_directions(k_of(structure), dimension)), len(members)
    return half * (half - 1) // 2 * (n * (n - 1)) ** 2 <= MOST_EXTENTS


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
