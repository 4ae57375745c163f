# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages of `kinex view`: Voronoi cells, colours, queries, frames of lines, records that report, curves with names.

usage: view_marks.py PROGRAM SOURCE_FOLDER
Exit code 77 (skipped) where there is no Chromium.
"""
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


def look(viewer, name, scene):
    """A page of a scene, or of what `gen` makes."""
    if isinstance(scene, dict):
        (viewer.folder / f"{name}.json").write_text(json.dumps(scene))
    else:
        viewer.kinex("gen", *scene, "-o", f"{name}.json")
    viewer.kinex("view", f"{name}.json", "-o", f"{name}.html")
    viewer.open(f"{name}.html")


def check_cell(viewer):
    """The corners of the cell are as far from the site as from two neighbours, or beyond the picture; no site is nearer."""
    look(viewer, "cell", ["uniform-square", "--n", "12", "--maintain", "voronoi_cell_2"])
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


def check_colours(viewer):
    """Tones and outlines differ, the query is no site, and the legend explains all."""
    look(viewer, "colours", COLOURS)
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
    look(viewer, "turns", TURNS)
    for k in (0, 1):
        x0, x1, y0, y1 = viewer.ask(f"(app.setEvent({k}), app.draw(), app.drawing.box)")
        unit = viewer.ask("DATA.scale")
        if not (x0 * unit < 2 < x1 * unit and y0 * unit <= 6 <= y1 * unit and 2 < (x1 - x0) * unit < 40 and 2 < (y1 - y0) * unit < 40):
            fail(f"the frame is {x0} .. {x1}, {y0} .. {y1} times {unit}")
    for name, scene in (("lines", ["random-lines", "--n", "6", "--maintain", "trapezoids_2"]),
                        ("small", ["small-lines", "--n", "8"])):
        look(viewer, name, scene)
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
    look(viewer, "graph", ["random-graph", "--n", "8", "--m", "5", "--maintain", "graph_mst_cycles"])
    svg = viewer.ask("(app.setEvent(1), app.draw(), pictureAsSvg(700, 500))")
    names = viewer.ask("DATA.ids")
    if not all(f">{name}<" in svg for name in names):
        fail("not every curve has its name")
    spans = viewer.ask("spansOf(FIRST, 0, 0, 1)")
    first, second = viewer.ask("[timeOf(FIRST, 1), timeOf(FIRST, 2)]")
    if len(spans) != 6 or sorted({u for _, *ends in spans for u in ends}) != [0, first, second, 1]:
        fail(f"the edges of the tree are {spans}")
    look(viewer, "discs", ["random-discs", "--n", "5", "--dimension", "1"])
    if len(viewer.ask("(app.setEvent(2), app.draw(), spansOf(FIRST, 0, 0, 1))")) == 0:
        fail("no discs meet")


def main():
    browser()
    sys.path.insert(0, str(pathlib.Path(sys.argv[2]) / "experiments" / "view"))
    import devtools  # pylint: disable=import-outside-toplevel
    with tempfile.TemporaryDirectory() as name, devtools.Browser(1400, 950) as window:
        viewer = Viewer(sys.argv[1], name, window)
        for check in (check_cell, check_colours, check_lines, check_reports, check_curves):
            check(viewer)
    print("cells, colours, lines, reports and curves are as they should be")


if __name__ == "__main__":
    main()
