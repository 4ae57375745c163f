# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages of `kinex view`: Voronoi cells, weights, colours, queries, frames of lines, records that report, curves with names,
walls of grids, what is named, lines of a record, roles, frames of pairs and of one place, what has left.

usage: view_marks.py PROGRAM SOURCE_FOLDER
Exit code 77 (skipped) where there is no Chromium.
"""
import fractions
import json
import math
import pathlib
import re
import sys
import tempfile

from chromium import browser
from viewer import Viewer

TURNS = {"kinex": 1, "name": "a line that turns, and a point", "dimension": 2, "time": {"start": 0, "end": 4},
         "objects": [{"id": "l", "line": True, "motion": [[0, 1], [1]]}, {"id": "p", "motion": [[2], [6]]}],
         "maintain": ["incidences_all"]}
COLOURS = {"kinex": 1, "name": "two colours", "dimension": 2, "time": {"start": 0, "end": 4},
           "objects": [{"id": "a", "motion": [[0, 1], [0]]}, {"id": "b", "motion": [[1], [1]], "colour": "red"},
                       {"id": "c", "motion": [[3], [2]], "colour": "red"}, {"id": "d", "motion": [[2], [0, 1]], "colour": "blue"}],
           "maintain": [{"structure": "nearest_site", "query": "a", "of": "red"}]}


def fail(text):
    sys.exit(f"view_marks: {text}")


def check_cell(viewer):
    """The corners of the cell are as far from the site as from two neighbours, or beyond the picture; no site is nearer."""
    viewer.look("cell", ["uniform-square", "--n", "12", "--maintain", "voronoi_cell_2"])
    corners = 0
    for u in (0.05, 0.3, 0.6, 0.9):
        cell, points, (left, top, wide, high), marked = viewer.ask(
            "(() => { const cells = [], rings = [], plain = trace, shapes = drawShapes; trace = (c, points, closed) => {"
            " if (closed) cells.push(points); plain(c, points, closed); };"
            " drawShapes = (c, list, ...more) => { for (const s of list) if (s.dot) rings.push(s.dot); shapes(c, list, ...more); };"
            f" app.setTime({u}); app.draw(); trace = plain; drawShapes = shapes; const plane = app.drawing;"
            " return [cells[0], [...Array(OBJECTS).keys()].map(id => plane.at(id)), plane.rectangle,"
            " rings.some(([x, y]) => x === plane.sx[0] && y === plane.sy[0])]; })()")
        if not marked:
            fail(f"the site is not marked at {u}")
        for x, y in cell:
            if not (left < x < left + wide and top < y < top + high):
                continue
            corners += 1
            away = sorted(math.dist((x, y), p) for p in points)
            if abs(away[2] - away[0]) > 1e-6 or abs(math.dist((x, y), points[0]) - away[0]) > 1e-6:
                fail(f"at {u} the corner {x}, {y} is {away[:3]} from the sites")
    if corners < 6:
        fail(f"only {corners} corners of cells are in sight")


# Weights above 0, at 0 and below, one that grows; e is not in the triangulation; f leaves.
WEIGHTS = {"kinex": 1, "name": "weights", "dimension": 2, "time": {"start": 0, "end": 4},
           "objects": [{"id": "a", "motion": [[0], [0]], "weight": [4]}, {"id": "b", "motion": [[9, 1], [0]], "weight": [0]},
                       {"id": "c", "motion": [[4], [7]], "weight": [-2]}, {"id": "d", "motion": [[5], [-6]], "weight": [0, "9/4"]},
                       {"id": "e", "motion": [[7], [3]], "weight": [1]},
                       {"id": "f", "motion": [{"to": 2, "coordinates": [[2], [3]]}], "weight": [1]}],
           "maintain": [{"structure": "regular_2", "of": ["a", "b", "c", "d", "f"]}, "sorted_list"]}


def check_weights(viewer):
    """Around every point of a structure that is there is a circle of its weight, dashed below 0; none where nothing reads weights."""
    def circles(u):
        viewer.say(f"app.setStructure(DATA.structures.findIndex(s => s.name === 'regular_2')); app.setMode('plane'); app.setTime({u});")
        return viewer.ask("(() => { const context = app.picture.context, arc = context.arc, seen = [], plane = app.drawing; context.arc ="
                          " function (x, y, r, ...more) { seen.push([x, y, r, this.getLineDash().length > 0]); return arc.call(this, x, y, r,"
                          " ...more); }; drawWeights(context, plane); delete context.arc; return seen.map(([x, y, r, dashed]) =>"
                          " [DATA.ids[[...Array(OBJECTS).keys()].find(id => plane.sx[id] === x && plane.sy[id] === y)],"
                          " Math.round(1e6 * (r / plane.scale * DATA.scale) ** 2) / 1e6, dashed]); })()")

    viewer.look("weights", WEIGHTS)
    for u, wanted in ((0.25, {"a": (4, False), "c": (2, True), "d": (2.25, False), "f": (1, False)}),
                      (1, {"a": (4, False), "c": (2, True), "d": (9, False)})):
        seen = {name: (square, dashed) for name, square, dashed in circles(u)}
        if seen != wanted:
            fail(f"at {u} the weights are drawn as {seen}, not as {wanted}")
    if "square of a radius" not in viewer.ask("document.getElementById('legend').innerText"):
        fail("the legend does not explain weights")
    viewer.look("unread", {**WEIGHTS, "maintain": ["convex_hull_2"]})
    if viewer.ask("[READS_WEIGHTS, document.getElementById('legend').innerText.includes('weight')]") != [False, False]:
        fail("weights are drawn that nothing reads")


def check_colours(viewer):
    """Tones and outlines differ, the query is no site, and the legend explains all."""
    viewer.look("colours", COLOURS)
    viewer.say("app.setStructure(DATA.structures.findIndex(s => s.name === 'nearest_site')); app.setEvent(0);")
    signs = viewer.ask("meaningsOfMarks(app)")
    texts = [text for _, _, text in signs]
    if texts != ["blue", "red", "the query a", "not in nearest_site"] or len({sign for sign, _, _ in signs}) != 4:
        fail(f"the legend has {signs}")
    if not all(text in viewer.ask("document.getElementById('legend').textContent") for text in texts):
        fail("the legend is not on the page")
    parts = viewer.ask("Array.from(PARTS[app.shown()])")
    if parts != [1, 0, 0, 2]:
        fail(f"the parts of the objects are {parts}")


def check_lines(viewer):
    """Points and most crossings are in the frame, and of every log record the lines that it names."""
    viewer.look("turns", TURNS)
    for k in (0, 1):
        x0, x1, y0, y1 = viewer.ask(f"(app.setEvent({k}), app.draw(), app.drawing.box)")
        unit = viewer.ask("DATA.scale")
        if not (x0 * unit < 2 < x1 * unit and y0 * unit <= 6 <= y1 * unit and 2 < (x1 - x0) * unit < 40 and 2 < (y1 - y0) * unit < 40):
            fail(f"the frame is {x0} .. {x1}, {y0} .. {y1} times {unit}")
    for name, scene in (("lines", ["random-lines", "--n", "6", "--maintain", "trapezoids_2"]),
                        ("small", ["small-lines", "--n", "8"])):
        viewer.look(name, scene)
        # Of how many crossings are in sight, and how many named lines are not.
        seen = viewer.ask(
            "(() => { let all = 0, there = 0, named = 0, lost = 0; for (let k = BEFORE; k <= LAST; k += 7) {"
            " app.setEvent(k); app.draw(); const plane = app.drawing, [left, top, wide, high] = plane.rectangle;"
            " const inside = ([x, y]) => x >= left && x <= left + wide && y >= top && y <= top + high;"
            " linesThere().forEach((l, i) => linesThere().slice(0, i).forEach(m => { const c = crossingOf(l, m);"
            " if (c !== null) { ++all; there += inside(plane.onScreen(...c)) ? 1 : 0; } }));"
            " for (const l of app.certificateObjects()) { const { from, to } = plane.across(l); ++named;"
            " lost += Math.max(from[1], to[1]) < top || Math.min(from[1], to[1]) > top + high ? 1 : 0; } }"
            " return [all, there, named, lost]; })()")
        if seen[1] < 0.6 * seen[0] or seen[3] > 0.05 * seen[2]:
            fail(f"{name}: {seen[1]} of {seen[0]} crossings are in sight, {seen[3]} of {seen[2]} named lines are not")


def check_reports(viewer):
    """A record without a certificate that reports says so, with the change; one of a thing is no plural."""
    viewer.open("lines.html")
    k = viewer.ask("FIRST.x.findIndex((x, e) => x === 1 && FIRST.certificates[e] === 0) + 1")
    text = viewer.ask(f"(app.setEvent({k}), app.draw(), document.getElementById('event').textContent)")
    if "reports what this instant has changed" not in text or "(at this instant)" not in text:
        fail(f"record {k}: {text}")
    viewer.open("turns.html")
    text = viewer.ask("(app.setEvent(1), app.draw(), document.body.innerText)")
    if re.search(r"\b1 (certificates|log records|objects|points)\b", text):
        fail(f"a wrong plural: {text}")


def check_curves(viewer):
    """Over time curves have names, and the edges of a tree are wide while they are in it."""
    viewer.look("graph", ["random-graph", "--n", "8", "--m", "5", "--maintain", "graph_mst_cycles"])
    svg = viewer.ask("(app.setEvent(1), app.draw(), pictureAsSvg(700, 500))")
    names = viewer.ask("DATA.ids")
    if not all(f">{name}<" in svg for name in names):
        fail("not every curve has its name")
    spans = viewer.ask("spansOf(FIRST, 0, 0, 1)")
    first, second = viewer.ask("[timeOf(FIRST, 1), timeOf(FIRST, 2)]")
    if len(spans) != 6 or sorted({u for _, *ends in spans for u in ends}) != [0, first, second, 1]:
        fail(f"the edges of the tree are {spans}")
    viewer.look("discs", ["random-discs", "--n", "5", "--dimension", "1"])
    if len(viewer.ask("(app.setEvent(2), app.draw(), spansOf(FIRST, 0, 0, 1))")) == 0:
        fail("no discs meet")


# The segments and rings of a drawing in one tone, and the texts with theirs: [x, y, text, tone].
DRAWN = """((k, tone) => { const lines = [], rings = [], texts = [], shapes = drawShapes, plain = label;
  drawShapes = (c, list, colour, ...more) => { if (colour === COLOUR[tone]) for (const s of list) {
    if (s.from) lines.push([s.from, s.to]); else if (s.dot) rings.push(s.dot); } shapes(c, list, colour, ...more); };
  label = (c, text, x, y, colour, ...more) => { texts.push([x, y, text, colour]); plain(c, text, x, y, colour, ...more); };
  app.setEvent(k); app.draw(); drawShapes = shapes; label = plain;
  const next = app.proof.next(k), claim = next === null ? null : app.proof.certificate(next[0]);
  return { lines, rings, named: texts.filter(t => t[3] === COLOUR[tone]).map(t => t[2]), texts: texts.map(t => t[2]),
           ids: claim === null ? [] : claim.ids.map(nameOf), places: DATA.ids.map((_, i) => app.plane.at(i)),
           legend: document.getElementById('legend').textContent, rectangle: app.plane.rectangle,
           origin: app.plane.onScreen(0, 0), scale: app.plane.scale / DATA.scale }; })"""


def check_walls(viewer):
    """The certificate that fails next at a wall of a grid is drawn: the wall where it is, a ring around the object; both are named."""
    for name, scene in (("grid", ["small-discs", "--n", "10", "--maintain", "disc_pairs_grid"]),
                        ("bins", ["uniform-square", "--n", "20", "--seed", "2", "--maintain", "closest_pair_bins"])):
        viewer.look(name, scene)
        axes = set()
        for k in range(0, min(60, viewer.ask("LAST"))):
            seen = viewer.ask(f"{DRAWN}({k}, 'next')")
            walls = [i for i, text in enumerate(seen["ids"]) if "=" in text]
            if not walls:
                continue
            axis, value = seen["ids"][walls[0]].split("=")
            axis, value = "xy".index(axis), float(fractions.Fraction(value)) * seen["scale"]
            wanted = seen["origin"][axis] + (value if axis == 0 else -value)
            if not any(abs(end[axis] - wanted) < 1e-6 for line in seen["lines"] for end in line):
                fail(f"{name}, record {k}: {seen['ids']}, but {seen['lines']} are drawn, not {wanted}")
            point = viewer.ask(f"DATA.ids.indexOf({json.dumps(seen['ids'][1 - walls[0]])})")
            if seen["places"][point] not in seen["rings"] or sorted(seen["named"]) != sorted(seen["ids"]):
                if set(seen["ids"]) & set(viewer.ask("app.certificateObjects().map(nameOf)")):
                    continue  # in the tone of the last record
                fail(f"{name}, record {k}: {seen['ids']}, but {seen['rings']} and {seen['named']}")
            axes.add(axis)
        if axes != {0, 1}:
            fail(f"{name}: walls on the axes {axes} fail next")
    # What cannot be drawn is not in the legend.
    viewer.say("app.plane.isThere = () => false;")
    if "fails next" in viewer.ask(f"{DRAWN}({k}, 'next')")["legend"]:
        fail("the legend has what is not drawn")


def check_names(viewer):
    """All objects in sight are named if they are few, however many the scene has; else those of the last record and the next."""
    few = {"kinex": 1, "name": "come and go", "dimension": 2, "time": {"start": 0, "end": 10}, "maintain": ["delaunay_2"],
           "objects": [{"id": f"p{i}", "motion": [{"from": f"{i}/8", "to": f"{i + 8}/8",
                                                   "coordinates": [[i * 37 % 11, 1], [i * 17 % 13, -1]]}]} for i in range(72)]}
    viewer.look("few", few)
    for k in range(viewer.ask("LAST")):
        seen = viewer.ask(f"{DRAWN}({k}, 'next')")
        there = viewer.ask("[...alive.keys()].filter(i => alive[i]).map(nameOf)")
        missing = [name for name in there if name not in seen["texts"]]
        if len(missing) > len(there) / 3 or set(seen["ids"]) & set(missing):
            fail(f"few, record {k}: {missing} of {there} are not named")
    viewer.look("many", ["uniform-square", "--n", "90", "--maintain", "delaunay_2"])
    for k in range(0, 60, 7):
        seen = viewer.ask(f"{DRAWN}({k}, 'next')")
        if not set(seen["ids"]) <= set(seen["texts"]) or not seen["ids"] or seen["texts"].count("p0") > 1:
            fail(f"many, record {k}: of {seen['ids']} only {seen['named']} are named")


def check_marked_lines(viewer):
    """Lines of the last record are red, whatever certificates lie on them, and rings are on top of lines."""
    viewer.look("arrangement", ["random-lines", "--n", "8", "--maintain", "line_arrangement_2"])
    seen = 0
    for k in range(1, 80, 3):
        drawn = viewer.ask(
            "(() => { const last = {}, shapes = drawShapes; let order = 0, rings = 0;"
            " drawShapes = (c, list, colour, ...more) => { ++order; for (const s of list) {"
            " if (s.dot) rings = order; else if (s.from) last[s.from] = [colour, order]; } shapes(c, list, colour, ...more); };"
            f" app.setEvent({k}); app.draw(); drawShapes = shapes; const next = app.proof.next({k});"
            " return app.certificateObjects().map(id => [nameOf(id), last[app.plane.across(id).from], rings, COLOUR.failed,"
            " next !== null && app.proof.certificate(next[0]).ids.includes(id)]); })()")
        for name, (colour, order), rings, red, fails_next in drawn:
            if not fails_next and (colour != red or order > rings):
                fail(f"record {k}: {name} is {colour}, drawn at {order}, rings at {rings}")
            seen += not fails_next
    if seen < 20:
        fail(f"only {seen} lines are of the last record alone")


def check_roles(viewer):
    """An object that stands in several places of a certificate has a row for each of them."""
    viewer.look("gaps", ["gaps-along-row", "--n", "4", "--m", "4"])
    shared = 0
    for k in range(viewer.ask("LAST")):
        seen = viewer.ask(
            f"(() => {{ app.setEvent({k}); app.draw(); const next = app.proof.next({k}); if (next === null) return null;"
            " const { name, form, ids } = app.proof.certificate(next[0]); return [name, form.says, ids.map(nameOf),"
            " [...document.querySelectorAll('#proof .details dt')].map(dt => [dt.textContent, dt.nextSibling.textContent])]; })()")
        if seen is None or "/" not in seen[0]:
            continue
        name, pattern = seen[0].split("/")
        rows = [row for row in seen[3] if "pair, " in row[0]]
        wanted = [[f"{pair} pair, {disc} disc", seen[2][int(place)]] for place, (pair, disc) in
                  zip(pattern, (("first", "one"), ("first", "other"), ("second", "one"), ("second", "other")))]
        if rows != wanted or ["predicate", name] not in seen[3]:
            fail(f"record {k}: the rows of {seen[:3]} are {seen[3]}")
        shared += 1
    if shared < 5:
        fail(f"only {shared} certificates have an object in two places")


def check_frame(viewer):
    """The circle of a closest pair at the edge of the scene is in sight."""
    pair = {"kinex": 1, "name": "pair", "dimension": 2, "time": {"start": 0, "end": 4}, "maintain": ["closest_pair_delaunay"],
            "objects": [{"id": "a", "motion": [[0], [0]]}, {"id": "b", "motion": [[0], [10, 1]]},
                        {"id": "c", "motion": [[40, -1], [5]]}, {"id": "d", "motion": [[70], [1]]}]}
    viewer.look("pair", pair)
    for u in (0, 0.3, 0.7, 1):
        (x, y), radius, (left, top, wide, high) = viewer.ask(
            "(() => { app.setStructure(DATA.structures.findIndex(s => s.role === 'diameter'));"
            f" app.setTime({u}); app.draw(); const [around] = OUTLINES.diameter(app.plane, app.replay.row);"
            " return [around.centre, around.radius, app.plane.rectangle]; })()")
        if not (left < x - radius and x + radius < left + wide and top < y - radius and y + radius < top + high) or radius < 20:
            fail(f"at {u} the circle about {x}, {y} of radius {radius} is cut off")


def check_place(viewer):
    """One point, and points that meet, are in a frame that has a size: that of the whole run, or one around the place."""
    one = {"kinex": 1, "dimension": 2, "time": {"start": 0, "end": 4}, "maintain": ["delaunay_2"]}
    moves = {**one, "name": "one", "objects": [{"id": "a", "motion": [[3, 1], [2]]}]}
    still = {**one, "name": "still", "objects": [{"id": "a", "motion": [[5000], [2]]}]}
    meet = {**one, "name": "meet", "objects": [{"id": name, "motion": [[3 - 2 * x, x], [2 - 2 * y, y]]}
                                               for name, x, y in (("a", 1, 0), ("b", 0, 1), ("c", -1, -1))]}
    for scene in (moves, still, meet):
        viewer.look(scene["name"], scene)
    for scene, u, least, most in ((moves, 0, 50, 400), (moves, 0.5, 50, 400), (moves, 1, 50, 400), (still, 0.5, 0.01, 1),
                                  (meet, 0.5, 50, 400)):
        viewer.open(f"{scene['name']}.html")
        scale, places, (left, top, wide, high) = viewer.ask(
            f"(app.setMode('plane'), app.setTime({u}), app.draw(), [app.plane.scale / DATA.scale,"
            " DATA.ids.map((_, i) => app.plane.at(i)), app.plane.rectangle])")
        if not least < scale < most or any(not (left < x < left + wide and top < y < top + high) for x, y in places):
            fail(f"{scene['name']} at {u}: a unit has {scale} pixels, the points are at {places}")
    viewer.look("space", {**meet, "name": "space", "dimension": 3, "maintain": ["delaunay_3"],
                          "objects": [{**one, "motion": [*one["motion"], [1]]} for one in meet["objects"]]})
    scale = viewer.ask("(app.setTime(0.5), app.draw(), app.plane.scale / DATA.scale)")
    if not 30 < scale < 400:
        fail(f"points that meet in space: a unit has {scale} pixels")


def check_left(viewer):
    """Between the log records of one instant an object may have left that a structure still has: its figures are not drawn."""
    square = [[0, 0], [1, 0], [1, 1], [0, 1]]
    bodies = {"kinex": 1, "name": "bodies", "dimension": 2, "time": {"start": 0, "end": 4},
              "maintain": ["closest_features", "separation_mixed"],
              "objects": [{"id": "a", "polygon": square, "motion": [[0], [0]]}, {"id": "b", "polygon": square, "motion": [[8, -1], ["1/3"]]},
                          {"id": "c", "polygon": square, "motion": [{"from": 0, "to": 2, "coordinates": [["1/8", "1/16"], ["9/8"]]}]}]}
    viewer.look("bodies", bodies)
    seen = viewer.ask("(() => { let seen = 0; for (let k = BEFORE; k <= LAST; ++k) for (const i of DATA.structures.keys())"
                      " for (const pair of [pairCode(0, 1), pairCode(0, 2), pairCode(1, 2)]) { app.chosen = pair; app.setStructure(i);"
                      " app.setEvent(k); app.draw(); const away = pairOf(pair).some(body => app.drawing.poses[body] === null);"
                      " seen += away && app.drawing.labels.length > 0; } return seen; })()")
    if seen == 0:
        fail("no body leaves before its certificates, or they leave no names")
    structures = ["bounding_box", "min_circle_2", "width_2", "min_area_rectangle_2"]
    points = {"kinex": 1, "name": "leaves", "dimension": 2, "time": {"start": 0, "end": 4}, "maintain": structures,
              "objects": [{"id": "a", "motion": [[0], [0, "1/5"]]}, {"id": "b", "motion": [[1, "1/7"], [0]]},
                          {"id": "c", "motion": [["1/2"], [1]]},
                          {"id": "d", "motion": [{"from": 0, "to": 2, "coordinates": [[9, "-1/9"], [8]]}]}]}
    viewer.look("leaves", points)
    drawn = viewer.ask("(() => { const drawn = [], plain = drawOutline; drawOutline = (c, shapes, ...more) => { const ids = app.replay.row;"
                       " drawn.push([app.shown(), ids.every(id => alive[id]), shapes.length]); plain(c, shapes, ...more); };"
                       " app.setMode('plane'); for (let k = BEFORE; k <= LAST; ++k) for (const i of DATA.structures.keys()) {"
                       " if (OUTLINES[DATA.structures[i].role] === undefined) continue; app.setStructure(i); app.setEvent(k); app.draw(); }"
                       " drawOutline = plain; return drawn; })()")
    left = [one for one in drawn if not one[1]]
    if len({index for index, *_ in left}) < 3 or any(shapes > 0 for *_, shapes in left) or any(s == 0 for _, there, s in drawn if there):
        fail(f"figures with a point that has left, and others: {drawn}")


def check_feature_names(viewer):
    """Names of the features of two bodies cover no feature and no other name, and no leader runs through one."""
    viewer.look("near", ["polygon-spin-orbit", "--n", "24", "--m", "24", "--separation", "1/10", "--maintain", "separation_mixed"])
    names = 0
    for k in range(1, viewer.ask("LAST"), 3):
        placed = viewer.ask(f"(app.setEvent({k}), app.draw(), app.drawing.placed)")
        for one in placed:
            left, top, right, bottom = one["box"]
            for other in placed:
                (x, y), (l, t, r, b) = other["where"], other["box"]
                on = left < x < right and top < y < bottom
                led = other is not one and other["end"] and viewer.ask(f"passes({[x, y]}, {other['end']}, {one['box']})")
                if on or led or (other is not one and left < r and l < right and top < b and t < bottom):
                    fail(f"record {k}: {one['text']} lies on {other['text']}, or on its leader")
            names += 1
    if names < 60:
        fail(f"only {names} features are named")


def main():
    browser()
    sys.path.insert(0, str(pathlib.Path(sys.argv[2]) / "experiments" / "view"))
    import devtools  # pylint: disable=import-outside-toplevel
    with tempfile.TemporaryDirectory() as name, devtools.Browser(1400, 950) as window:
        viewer = Viewer(sys.argv[1], name, window)
        for check in (check_cell, check_weights, check_colours, check_lines, check_reports, check_curves,
                      check_walls, check_names, check_marked_lines, check_roles, check_frame, check_place, check_left,
                      check_feature_names):
            check(viewer)
    print("cells, weights, colours, lines, reports and curves are as they should be")


if __name__ == "__main__":
    main()
