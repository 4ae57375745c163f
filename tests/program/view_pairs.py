# SPDX-License-Identifier: GPL-3.0-or-later
"""Closest pairs on the page of `kinex view`, and lines around points.

usage: view_pairs.py PROGRAM SOURCE_FOLDER
A closest pair has the circle with both points on a diameter: no other point is in it. In the maximum norm two points of
two colours have a square around the first one: no point of the other colour is in it. A pair of discs has its gap.
Every line is in the picture. Exit code 77 (skipped) where there is no Chromium.
"""
import json
import math
import pathlib
import sys
import tempfile

from chromium import browser
from viewer import Viewer

PAIRS = ["closest_pair_delaunay", "closest_pair_all", "closest_pair_range_tree", "closest_pair_cones", "closest_pair_local",
         "closest_pair_bins"]
SQUARE = "bichromatic_pair_maximum_norm"
SHOWN = """(u => { app.setTime(u); app.draw(); const plane = app.plane, row = app.replay.row;
  return { row, positions: [...Array(OBJECTS).keys()].map(id => plane.positionOf(id)), scale: plane.scale,
    half: HALF.length > 0 ? [...HALF[0]] : [], at: row.map(id => plane.at(id)),
    shapes: OUTLINES[DATA.structures[app.shown()].role](plane, row) }; })"""


def fail(text):
    sys.exit(f"view_pairs: {text}")


def shown(viewer, name, u):
    viewer.say(f"app.setStructure(DATA.structures.findIndex(s => s.name === '{name}'));")
    return viewer.ask(f"{SHOWN}({u})")


def check_circle(name, state, members):
    """The circle has the pair on a diameter, and no other point inside."""
    a, b = state["row"]
    circles = [s for s in state["shapes"] if "centre" in s]
    centre = [(x + y) / 2 for x, y in zip(state["at"][0], state["at"][1])]
    points = state["positions"]
    radius = math.dist(points[a], points[b]) / 2
    if len(circles) != 1 or math.dist(circles[0]["centre"], centre) > 1e-6 * state["scale"]:
        fail(f"{name}: the circle is {circles}, not around {centre}")
    if abs(circles[0]["radius"] - radius * state["scale"]) > 1e-6 * circles[0]["radius"]:
        fail(f"{name}: the radius is {circles[0]['radius']}, not {radius} times {state['scale']}")
    middle = [(x + y) / 2 for x, y in zip(points[a], points[b])]
    inside = [i for i in members if i not in (a, b) and math.dist(points[i], middle) < radius * (1 - 1e-9)]
    if inside:
        fail(f"{name}: {inside} are in the circle of {a}, {b}")


def check_square(name, state, others):
    """The square is around the first point, has the second on its border, and none of the second one's colour inside."""
    a, b = state["row"]
    sides = [s for s in state["shapes"] if "from" in s and not s.get("wide")]
    points, middle = state["positions"], state["at"][0]
    half = max(abs(x - y) for x, y in zip(points[a], points[b]))
    corners = sorted(tuple((x - y) / state["scale"] for x, y in zip(side["from"], middle)) for side in sides)
    right = sorted((x, y) for x in (-half, half) for y in (-half, half))
    if len(corners) != 4 or any(math.dist(one, other) > 1e-6 for one, other in zip(corners, right)):
        fail(f"{name}: the corners are {corners} around the first point, not {right}")
    inside = [i for i in others[b] if max(abs(x - y) for x, y in zip(points[i], points[a])) < half * (1 - 1e-9)]
    if inside:
        fail(f"{name}: {inside} are in the square of {a}, {b}")


def check_points(viewer):
    pictures = 0
    for dimension, names in ((2, PAIRS), (3, PAIRS[:2])):
        viewer.kinex("gen", "uniform-square", "--n", "12", "--seed", "3", "--dimension", str(dimension), "--maintain",
                     ",".join(names), "-o", f"pairs-{dimension}.json")
        scene = json.loads((viewer.folder / f"pairs-{dimension}.json").read_text())
        for i, one in enumerate(scene["objects"]):
            one["colour"] = ("red", "blue", "none")[i % 3]
        bichromatic = ["bichromatic_pair_delaunay", "bichromatic_pair_all"]
        squares = [SQUARE] if dimension == 2 else []
        scene["maintain"] += [{"structure": name, "colours": ["red", "blue"]} for name in bichromatic + squares]
        (viewer.folder / "pairs.json").write_text(json.dumps(scene))
        viewer.kinex("view", "pairs.json", "-o", f"pairs-{dimension}.html")
        viewer.open(f"pairs-{dimension}.html")
        coloured = [i for i in range(12) if i % 3 != 2]
        if dimension == 2:
            for u in (0.05, 0.3, 0.6, 0.9):
                check_square(SQUARE, shown(viewer, SQUARE, u), [[j for j in coloured if j % 3 == i % 3] for i in range(12)])
        for name in names + bichromatic:
            for u in (0.05, 0.5, 0.9):
                check_circle(name, shown(viewer, name, u), coloured if name in bichromatic else range(12))
                pictures += 1
    return pictures


def check_discs(viewer):
    """The gap is as long as the distance between the two discs."""
    viewer.kinex("gen", "apart-discs", "--n", "9", "--maintain", "closest_pair_discs", "-o", "discs.json")
    viewer.kinex("view", "discs.json", "-o", "discs.html")
    viewer.open("discs.html")
    gaps = 0
    for u in (0.05, 0.3, 0.6, 0.9):
        state = shown(viewer, "closest_pair_discs", u)
        if not state["row"]:
            continue
        a, b = state["row"]
        gap = math.dist(state["positions"][a], state["positions"][b]) - state["half"][a] - state["half"][b]
        drawn = [math.dist(s["from"], s["to"]) for s in state["shapes"] if "from" in s]
        if len(drawn) != 1 or abs(drawn[0] - gap * state["scale"]) > 1e-6 * state["scale"]:
            fail(f"the gap of discs is {drawn}, not {gap} times {state['scale']}")
        gaps += 1
    if gaps == 0:
        fail("no gap of discs was seen")


def check_lines(viewer):
    """Lines above and below the points are in the picture."""
    def line(name, height):
        return {"id": name, "line": True, "motion": [["1/10"], [height]]}
    viewer.kinex("gen", "random-lines-and-points", "--n", "6", "--maintain", "points_in_arrangement", "-o", "lines.json")
    scene = json.loads((viewer.folder / "lines.json").read_text())
    scene["objects"] += [line("high", "8/5"), line("low", "-3/5")]
    (viewer.folder / "lines.json").write_text(json.dumps(scene))
    viewer.kinex("view", "lines.json", "-o", "lines.html")
    viewer.open("lines.html")
    for u in (0, 0.5, 1):
        outside = viewer.ask(f"""(() => {{ app.setTime({u}); app.draw(); const plane = app.plane, [left, top, width, height] = plane.rectangle;
          return DATA.ids.filter((_, id) => IS_LINE[id] && alive[id]).filter((name, _) => {{
            const id = DATA.ids.indexOf(name), {{ from, to }} = plane.across(id);
            return Math.max(from[1], to[1]) < top || Math.min(from[1], to[1]) > top + height; }}); }})()""")
        if outside:
            fail(f"at {u} the lines {outside} are outside of the picture")


def main():
    browser()
    source = pathlib.Path(sys.argv[2])
    sys.path.insert(0, str(source / "experiments" / "view"))
    import devtools  # pylint: disable=import-outside-toplevel
    with tempfile.TemporaryDirectory() as name, devtools.Browser(1400, 950) as window:
        viewer = Viewer(sys.argv[1], name, window)
        pictures = check_points(viewer)
        check_discs(viewer)
        check_lines(viewer)
    print(f"{pictures} circles of closest pairs")


if __name__ == "__main__":
    main()
