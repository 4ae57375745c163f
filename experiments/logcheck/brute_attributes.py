# SPDX-License-Identifier: GPL-3.0-or-later
"""Level 5: the attributes of all structures at one time, from positions."""

from fractions import Fraction
from functools import cmp_to_key
from itertools import combinations, product

from brute_flush import ORDERS, smallest_flush
from families import TWO_COLOURS
from octants import pairs_of_pointers, pairs_of_positions, pointers_of
from polygons import cones, counted, precedes_along, sign_at, units
from replay_boxes import boxes
from replay_calipers import folds_of
from replay_discs import closest_discs
from replay_directions import all_directions, half_directions, k_of, opposite
from replay_lines import measure_of
from replay_norms import MOST_MEMBERS, nearest_in_norm, norm_tree_of
from replay_octants import corners_of
from space import cells_of, regular_of
from static import forest_edges, rotated, spanning_tree
from subsets import classes_of, query_of


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


def cell_of(site, positions):
    """The Delaunay neighbours of a site, counter-clockwise from the smallest."""
    if site not in positions:
        return []
    here = tuple(positions[site])
    vertex = min(o for o in positions if tuple(positions[o]) == here)
    around = [a if b == vertex else b for a, b in delaunay_of(positions) if vertex in (a, b)]

    def before(a, b):
        u, v = ([q - p for p, q in zip(here, positions[o])] for o in (a, b))
        halves = [w[1] < 0 or (w[1] == 0 and w[0] < 0) for w in (u, v)]
        return halves[0] - halves[1] or (u[1] * v[0] > u[0] * v[1]) - (u[1] * v[0] < u[0] * v[1])

    return rotated(sorted(around, key=cmp_to_key(before)))


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


def closest_to_line(measure, positions, scene):
    """The line and the point at the smallest distance; of several the smallest pair."""
    found = []
    for line, point in product(positions, repeat=2):
        if scene.objects[line].line and not scene.objects[point].line:
            (a, b), (x, y) = positions[line], positions[point]
            square = Fraction((y - a * x - b) ** 2) / (1 if measure == "height" else 1 + a * a)
            found.append((square, tuple(sorted((line, point)))))
    return [min(found)[1]] if found else []


def tree_of(positions):
    """Kruskal's algorithm; of equal lengths the smaller pair comes first."""
    pairs = sorted(combinations(sorted(positions), 2), key=lambda pair: (squared_distance(positions, pair), pair))
    return spanning_tree(pairs)


def farthest_of(positions):
    pairs = list(combinations(sorted(positions), 2))
    return [max(pairs, key=lambda pair: (squared_distance(positions, pair), [-o for o in pair]))] if pairs else []


def farthest(positions, u):
    """The farthest along u; of those that are level the smallest number."""
    return max(sorted(positions), key=lambda o: sum(v * c for v, c in zip(u, positions[o])))


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


def rectangle_of(positions, along, by_area):
    """The objects that touch the smallest of the boxes, each given by four directions; of equal ones the first."""
    best = None
    for box in along if positions else []:
        touched = [farthest(positions, u) for u in box]
        width, height = (sum(v * (p - q) for v, p, q in zip(u, positions[a], positions[b]))
                         for u, a, b in ((box[0], *touched[:2]), (box[2], *touched[2:])))
        size = width * height if by_area else width + height
        if best is None or size < best[0]:
            best = (size, touched)
    return [] if best is None or len(set(best[1])) == 1 else best[1]


def boxes_meet(a, b):
    return all(abs(a[i] - b[i]) <= a.half(i) + b.half(i) for i in range(len(a)))


def discs_meet(a, b):
    return sum((p - q) ** 2 for p, q in zip(a, b)) <= (a.half(0) + b.half(0)) ** 2


def meetings_of(positions, meet):
    return [(a, b) for a, b in combinations(sorted(positions), 2) if meet(positions[a], positions[b])]


def points_above(positions, scene):
    """The pairs of a line y = a x + b and a point above it."""
    result = []
    for line, (a, b) in positions.items():
        for point, (x, y) in positions.items():
            if scene.objects[line].line and not scene.objects[point].line and y > a * x + b:
                result.append((min(line, point), max(line, point)))
    return sorted(result)


def orders_of(positions, scene):
    """The orders of the arrangement of the lines y = a x + b. At a common crossing the smallest number that matters
    is raised by 1, alone, and crossings are compared by how far they go to the right."""
    lines = {o: positions[o] for o in sorted(positions) if scene.objects[o].line}
    rows = [tuple(sorted(lines, key=lambda o: (lines[o][0], -lines[o][1], o)))] if lines else []
    for line, (a, b) in lines.items():
        crossed = [m for m in lines if lines[m][0] != a]

        def place(m):
            slope = lines[m][0] - a
            moved = [Fraction((who == line) - (who == m)) / slope for who in lines]
            return (Fraction(b - lines[m][1]) / slope, moved, m)

        parallel = [m for m in lines if m != line and lines[m][0] == a]
        rows.append(tuple(parallel + [line] + sorted(crossed, key=place)))
    return rows


def next_lines_of(positions, scene):
    """For each point itself, the next line above it and the next one below, itself again where there is none. Of lines
    at one height the smaller number is the higher one; a point is below a line that it is on."""
    result = []
    for p in sorted(positions):
        if scene.objects[p].line:
            continue
        x, y = positions[p]
        heights = [(positions[o][0] * x + positions[o][1], -o) for o in positions if scene.objects[o].line]
        above, below = min((h for h in heights if h[0] >= y), default=None), max(
            (h for h in heights if h[0] < y), default=None)
        result += [p] + [p if h is None else -h[1] for h in (above, below)]
    return result


def walls_of(positions, scene):
    """For each two lines that cross, themselves and the next line above their crossing and the next one below, the first
    again where there is none. Lines are raised by infinitesimals, more so the smaller the number: heights are lists,
    of the height and of what each line adds to it."""
    lines = {o: positions[o] for o in sorted(positions) if scene.objects[o].line}
    result = []
    for (l, (a, b)), (m, (c, d)) in combinations(lines.items(), 2):
        if a == c:
            continue
        up = 1 if a < c else -1
        run, rise = up * (c - a), up * (b - d)  # the crossing is at rise / run, and heights are times run
        plain = {h: lines[h][0] * rise + lines[h][1] * run for h in lines}

        def raised(h):
            return [(o == h) * run + lines[h][0] * up * ((o == l) - (o == m)) for o in lines]

        def nearest(choose, found):
            if not found:
                return l
            height = choose(plain[h] for h in found)
            return choose((raised(h), h) for h in found if plain[h] == height)[1]

        others = [h for h in lines if h not in (l, m)]
        level = {h: raised(h) > raised(l) for h in others if plain[h] == plain[l]}
        above = [h for h in others if plain[h] > plain[l] or level.get(h, False)]
        below = [h for h in others if plain[h] < plain[l] or not level.get(h, True)]
        result += [l, m, nearest(min, above), nearest(max, below)]
    return result


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
    if name == "regular_2":
        return regular_of(positions, 3, scene.extents == "radius")
    if name == "regular_3":
        return regular_of(positions, 4, scene.extents == "radius")
    if name == "bounding_box":
        return box_of(positions)
    if name.startswith("octants_"):
        return pairs_of_positions(positions)
    if name == "closest_pair_discs":
        return closest_discs(positions)
    if name == "bichromatic_pair_maximum_norm":
        return nearest_in_norm(pairs_of(structure, positions, scene), positions)
    if name.startswith(("closest_pair_", "bichromatic_pair_")):
        return closest_of(pairs_of(structure, positions, scene), positions)
    if name == "nearest_site":
        return nearest_of(query_of(structure.options, scene), positions)
    if name == "voronoi_cell_2":
        return cell_of(query_of(structure.options, scene), positions)
    if name.startswith("graph_mst_"):
        return lightest_of(positions, scene)
    if name.startswith("incidences_"):
        return points_above(positions, scene)
    if name.startswith("closest_point_line"):
        return closest_to_line(measure_of(name), positions, scene)
    if name == "line_arrangement_2":
        return orders_of(positions, scene)
    if name == "points_in_arrangement":
        return next_lines_of(positions, scene)
    if name == "trapezoids_2":
        return walls_of(positions, scene)
    if name == "box_pairs":
        return meetings_of(positions, boxes_meet)
    if name.startswith("disc_pairs_"):
        return meetings_of(positions, discs_meet)
    if name.startswith("mst_maximum_norm_"):
        return norm_tree_of(positions) if len(positions) <= MOST_MEMBERS else None
    if name.startswith("mst_polygon_"):
        vectors = units(corners_of(structure))
        return norm_tree_of(positions, vectors) if len(positions) <= MOST_MEMBERS else None
    if name == "cones_local":
        corners = corners_of(structure)
        pointers = pointers_of(sorted(positions), precedes_along(sign_at(positions)), cones(corners))
        return pairs_of_pointers(pointers, counted(corners))
    if name.startswith("emst_"):
        return tree_of(positions)
    if name in ("diameter_2", "diameter_all_pairs"):
        return farthest_of(positions)
    if name == "bounding_box_2_hull":
        return box_of_hull(positions)
    if name == "calipers_2":
        return calipers_of(positions, folds_of(structure))
    if name in ORDERS:
        return smallest_flush(name, hull_of(positions), positions)
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
        return extent_of(positions, half_directions(k_of(structure), dimension), name == "diameter_directions")
    if name.endswith("_rectangle_directions"):
        return rectangle_of(positions, boxes(k_of(structure)), name.startswith("min_area"))
    return None
