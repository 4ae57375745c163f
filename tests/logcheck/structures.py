# SPDX-License-Identifier: GPL-3.0-or-later
"""Every structure on every family that suits it, through kinex check and all levels of kinex-logcheck.

usage: structures.py PROGRAM LOGCHECK_FOLDER [STRUCTURE,...|all [SHIFT]]

Logs of n = 8 (points) or 3 to 4 (bodies) at levels 0 to 4, and
of n = 5 at level 5 too. Of the families of points one in four is tried at the larger size and one in four at the
smaller one; of those in space, and of bodies, one in two. The name of a structure and SHIFT decide which: four SHIFTs
that follow each other try all.
A structure whose logs were never followed, and a level that was done nowhere, fail the test.
"""
import collections
import json
import pathlib
import sys
import tempfile
import zlib

import logs

# What the program or the checker once had wrong: a structure, a family, n and the seed; and scenes beside this file.
ONCE_WRONG = [("line_arrangement_2", "grid", 8, 4), ("mst_maximum_norm_cycles", "grid", 5, 58),
              ("emst_clusters", "meet", 5, 60), ("convex_hull_2_brute_force", "grid", 5, 22),
              ("convex_hull_2_delaunay", "meet", 8, 23), ("convex_hull_2", "collinear-instant", 8, 23),
              ("convex_hull_2", "grid", 5, 163576)]
SCENES = {"line_arrangement_2": ["parallel_lines.json", "parallel_by_a_plan.json"], "sorted_list": ["plan_at_the_end.json"],
          "delaunay_2": ["passes_on_the_hull.json"], "trapezoids_2": ["parallel_walls.json", "points_beside_lines.json"],
          "octants_listed": ["level_below.json", "level_aslant.json", "level_neighbours.json", "level_by_a_plan.json"],
          "regular_3": ["weights_in_a_plane.json"], "delaunay_3": ["point_lands.json", "equal_by_a_plan.json"],
          "closest_pair_discs": ["balls_on_a_wall.json", "ball_lands.json"],
          "mst_maximum_norm_cycles": ["turns_by_itself.json", "tie_in_a_repair.json", "new_cycle.json"],
          "regular_2": ["line_at_a_plan.json"],
          "convex_hull_2_delaunay": ["upright_side.json", "turn_by_a_plan.json"], "diameter_2": ["side_without_length.json"],  # and all that calipers maintain
          "width_2": ["tie_without_a_failure.json"],
          "min_area_rectangle_directions": ["tie_beside_a_failure.json"], "min_area_rectangle_2": ["tie_above_a_failure.json"],
          "disc_pairs_grid": ["two_grids.json"]}
# The same, run up to a time before its end: no object goes at that.
UNTIL = {"sorted_list": [("plan_at_the_end.json", "1"), ("plan_at_the_end.json", "3/2")]}


def maintained(structure, known):
    """What to maintain: one-dimensional structures by several keys."""
    if structure not in known.line:
        return [structure]
    keys = logs.KEYS[:3] if structure in known.linear else logs.KEYS
    return [{"structure": structure, "key": key, "as": structure} for key in keys]


def seed_of(structure):
    """Of its scenes: the same whatever other structures there are."""
    return zlib.crc32(structure.encode()) % 1000


def sizes(i, larger, smaller):
    """[(j, family, n, seed)] of the points of a structure whose number is i: larger scenes, none, smaller ones and none
    take turns."""
    for j, family in enumerate(logs.POINT_FAMILIES):
        if (i + j) % 4 == 0:
            yield j, family, larger, i + j
        elif (i + j) % 4 == 2:
            yield j, family, smaller, i + 2 * j


def main():
    program, folder = sys.argv[1:3]
    known = logs.Structures(program)
    chosen = sys.argv[3].split(",") if len(sys.argv) > 3 and sys.argv[3] != "all" else known.all
    shift = int(sys.argv[4]) if len(sys.argv) > 4 else 0
    modules = logs.checker(folder)
    logs.require_version(program)
    tried, levels, wrong = collections.Counter(), collections.defaultdict(collections.Counter), []

    def check(scratch, structure, family, n, seed, maintain, *more):
        path = logs.generate(program, scratch, family, n, seed, maintain, *more)
        if path:
            check_scene(scratch, structure, path, f"{family}, n = {n}, seed {seed}, {json.dumps(maintain)}", n <= 5)

    def check_scene(scratch, structure, path, where, small, *more):
        data = logs.run(program, scratch, path, *more)
        if data is None:
            return
        tried[structure] += 1
        problem = logs.complaint(program, scratch, path)
        if problem:
            wrong.append(f"{structure} on {where}: kinex check: {problem}")
        verdict, message, done = logs.check(modules, data, path, range(6) if small else range(5))
        if verdict != "fine":
            wrong.append(f"{structure} on {where}: {message}")
            return
        if done.missing:
            wrong.append(f"{structure} on {where}: {', '.join(done.missing)} was not followed")
        for level in done.done:
            levels[structure][level] += 1

    with tempfile.TemporaryDirectory() as scratch:
        for structure, family, n, seed in ONCE_WRONG:
            if structure in chosen:
                check(scratch, structure, family, n, seed, structure)
        for structure in [name for name in SCENES if name in chosen]:
            for name in SCENES[structure]:
                check_scene(scratch, structure, pathlib.Path(__file__).with_name(name), name, True)
            for name, until in UNTIL.get(structure, ()):
                path = pathlib.Path(__file__).with_name(name)
                check_scene(scratch, structure, path, f"{name} until {until}", True, "--until", until)
        for structure in known.line + known.plane:
            if structure not in chosen:
                continue
            i = seed_of(structure) + shift
            options = maintained(structure, known)
            for j, family, n, seed in sizes(i, 8, 5):
                check(scratch, structure, family, n, seed, options[(i + j // 2) % len(options)])
            if structure in known.line and structure not in known.linear:
                check(scratch, structure, "uniform-square", 7, i, structure, "--degree", "3", "--dimension", "1")
            check(scratch, structure, "gaussian", 6, i, maintained(structure, known)[0], "--degree", "2")
        for structure in known.graphs:
            if structure not in chosen:
                continue
            i = seed_of(structure) + shift
            for _, family, n, seed in sizes(i, 9, 5):
                check(scratch, structure, family, n, seed, structure, "--dimension", "1")
            check(scratch, structure, "random-graph", 10, i, structure, "--m", "4")
            check(scratch, structure, "parallel-edges", 4, i, structure, "--m", "2")
        for structure in known.extents:
            if structure not in chosen:
                continue
            i = seed_of(structure) + shift
            for _, family, n, seed in sizes(i, 8, 5):
                check(scratch, structure, family, n, seed, structure)
            for family in ("fan", "small", "random"):
                family += {"fan": "-of", "small": "", "random": ""}[family]
                family += "-boxes" if structure == "box_pairs" else "-discs"
                for dimension in "123":
                    check(scratch, structure, family, 5, 3, structure, "--dimension", dimension)
        for structure in known.lines:
            if structure not in chosen:
                continue
            i = seed_of(structure) + shift
            for _, family, n, seed in sizes(i, 8, 5):
                check(scratch, structure, family, n, seed, structure)
            check(scratch, structure, "gaussian", 6, i, structure, "--degree", "2")
            check(scratch, structure, "small-lines-and-points", 8, 1, structure)
            check(scratch, structure, "points-through-lines", 3, 1, structure, "--m", "2")
            if structure in ("line_arrangement_2", "trapezoids_2"):
                check(scratch, structure, "small-lines", 6, 1, structure)
                check(scratch, structure, "three-bundles", 6, 1, structure)
                check(scratch, structure, "turning-pencil", 5, 1, structure)
        for structure in known.space:
            if structure not in chosen:
                continue
            i = seed_of(structure) + shift
            for j, family in enumerate(("uniform-square", "lattice", "grid", "meet")):
                n, seed = (7, i + j) if (i + j) % 2 == 0 else (5, i + 2 * j)
                check(scratch, structure, family, n, seed, structure, "--dimension", "3")
        for structure in ("regular_2", "regular_3"):
            if structure not in chosen:
                continue
            for family in ("small-weights", "small-moving-weights", "random-weights", "breathing"):
                for n in (5, 7):
                    check(scratch, structure, family, n, n, structure, "--dimension", structure[-1])
            if structure == "regular_2":
                check(scratch, structure, "show-and-hide", 2, 1, structure, "--m", "3")
        for structure in known.bodies:
            if structure not in chosen:
                continue
            i = seed_of(structure) + shift
            for j, family in enumerate(logs.BODY_FAMILIES):
                if (i + j) % 2 == 0:
                    check(scratch, structure, family, 3, i + j, structure, "--m", "4")
    for structure in chosen:
        print(f"{structure}: {tried[structure]} logs;",
              ", ".join(f"level {k}: {levels[structure][k]}" for k in sorted(levels[structure])))
        for level in (0, 1, 5) if structure in known.bodies else range(6):
            if not levels[structure][level] and not wrong:
                wrong.append(f"{structure}: level {level} was done on no log")
    print("\n".join(wrong))
    sys.exit(1 if wrong else 0)


main()
