# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of `kinex view` as people use it: filter, axes, exact numbers, sizes of windows, exports, long runs.

usage: view_looks.py PROGRAM SOURCE_FOLDER
Exit code 77 (skipped) where there is no Chromium.
"""
import base64
import fractions
import json
import math
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

from chromium import browser
from committed_figures import faults_of, look
from viewer import Viewer

# Instants 1/2 and 1/2 + 2^-60, and one that is no fraction.
CLOSE = {"kinex": 1, "name": "close", "dimension": 1, "time": {"start": 0, "end": 1}, "maintain": ["sorted_list"],
         "objects": [{"id": "a", "motion": [[0, 1]]}, {"id": "b", "motion": [["1/2"]]},
                     {"id": "c", "motion": [[10, 1]]},
                     {"id": "d", "motion": [[str(fractions.Fraction(21, 2) + fractions.Fraction(1, 2**60))]]},
                     {"id": "e", "motion": [[20, 0, 1]]}, {"id": "f", "motion": [["81/4", 0, "1/3"]]}]}


def fail(text):
    sys.exit(f"view_looks: {text}")


def check_filter(viewer, events):
    """What the filter finds, against the log."""
    def found(text, kind=""):
        viewer.say(f"const box = document.getElementById('search'); box.value = {json.dumps(text)};"
                   f"document.getElementById('search-kind').value = {json.dumps(kind)};"
                   "box.dispatchEvent(new Event('input'));")
        return viewer.ask("app.filter.found")

    def names(event):
        return event["ids"] + (event["certificate"]["ids"] if event["certificate"] else [])

    cases = {("object:p3", ""): lambda e: "p3" in names(e),
             ("kind:swap", ""): lambda e: e["kind"] == "swap",
             ("structure:delaunay external", ""): lambda e: e["structure"] == "delaunay_2" and e["external"],
             ("p3 -p4", ""): lambda e: "p3" in names(e) and "p4" not in names(e),
             ("", "flip"): lambda e: e["kind"] == "flip",
             ("in_circle", ""): lambda e: e["certificate"] and "in_circle" in e["certificate"]["predicate"]}
    for (text, kind), fits in cases.items():
        wanted = [e["seq"] for e in events if fits(e)]
        if not wanted or found(text, kind) != wanted:
            fail(f"{text!r} {kind!r} finds {found(text, kind)}, not {wanted}")
    wanted = [e["seq"] for e in events if "p3" in names(e)]
    found("object:p3")
    viewer.say("app.setEvent(0); app.filter.go(1); app.filter.go(1);")
    if viewer.ask("app.k") != wanted[1]:
        fail(f"the second match is record {viewer.ask('app.k')}, not {wanted[1]}")
    rows = viewer.ask("[...document.querySelectorAll('#rows .row')].map(r => +r.dataset.event)")
    if not rows or any(k not in wanted for k in rows):
        fail(f"the list has the rows {rows}")
    if found("") is not None:
        fail("no words choose all")


def check_words(viewer, events):
    """Kinds are explained, and rational instants are fractions."""
    kinds = viewer.ask("DATA.structures.flatMap((s, i) => s.kinds.map(kind => [s.name, kind, kindText(i, kind)]))")
    if any(not text for _, _, text in kinds):
        fail(f"kinds without an explanation: {[k for k in kinds if not k[2]]}")
    exact = 0
    for event in events:
        lower, upper = event["time"]["interval"]
        shown = viewer.ask(f"rationalOf(instantOf(FIRST, {event['seq']}))")
        if lower == upper and shown != lower:
            fail(f"record {event['seq']} is at {lower}, shown as {shown}")
        exact += shown is not None
    if exact == 0:
        fail("no instant is a fraction")
    title = viewer.ask("app.setEvent(3), app.draw(), document.querySelector('#event abbr').title")
    if not title:
        fail("the kind of an event has no title")


def check_close(viewer):
    """Events that are too close for the time axis stand apart on that of records, with the gap between them."""
    viewer.open("close.html")
    texts = viewer.ask("[1, 2, 3].map(k => [rationalOf(instantOf(FIRST, k)), instantOf(FIRST, k)[0]])")
    wanted = [str(fractions.Fraction(1, 2)), str(fractions.Fraction(1, 2) + fractions.Fraction(1, 2**60))]
    if [texts[0][0], texts[1][0]] != wanted or texts[2][0] is not None:
        fail(f"instants are shown as {texts}, not {wanted} and one that is no fraction")
    places = "[1, 2].map(k => { const axis = app.windowAxis(800); return axis.x(axis.placeOf(FIRST, k)); })"
    viewer.say("app.setAxis(false); app.setEvent(1);")
    a, b = viewer.ask(places)
    if b - a > 1:
        fail(f"on the time axis the events are {b - a} pixels apart")
    viewer.say("app.setAxis(true);")
    a, b = viewer.ask(places)
    if b - a < 20 or viewer.ask("gapText(1)") != "2\u207b\u2076\u2070":
        fail(f"on the axis of records they are {b - a} pixels and {viewer.ask('gapText(1)')} apart")
    gaps = viewer.ask("app.draw(), app.window.gaps")
    if gaps[0] != [1, "2\u207b\u2076\u2070"] or len(gaps) != 2:
        fail(f"the axis of records names the gaps {gaps}")
    # A click at the second bar goes to the second record.
    viewer.say(f"const axis = app.window.axis; app.setEvent(app.window.eventAt(axis.x(2) + 3, 10));")
    if viewer.ask("app.k") != 2:
        fail(f"a click beside record 2 goes to {viewer.ask('app.k')}")


def check_root(viewer, count):
    """The polynomial is positive left of its root and negative right of it, and the interval holds the root."""
    drawn = named = 0
    for k in range(1, count + 1):
        seen = viewer.ask(f"(() => {{ app.setEvent({k}); app.draw(); const root = app.panel.root; return root === null ? null"
                          " : { ...root.sample(41), width: root.canvas.width, curve: root.curve, names: root.names }; })()")
        if seen is None:
            continue
        drawn += 1
        values, (low, high) = seen["values"], seen["ends"]
        for box in seen["names"]:
            if box is not None and any(box[0] < x < box[2] and box[1] < y < box[3] for x, y in seen["curve"]):
                fail(f"record {k}: the curve passes through the name in {box}")
        named += sum(box is not None for box in seen["names"])
        if values[19] < 0 or values[21] > 0 or not low <= 0.001 or not high >= -0.001 or seen["width"] < 50:
            fail(f"record {k}: {values} with the interval [{low}, {high}]")
    if drawn < count // 2:
        fail(f"only {drawn} of {count} polynomials are drawn")
    if named < 1.5 * drawn:
        fail(f"only {named} of {2 * drawn} sides of the axis are named")


def check_sizes(viewer, name):
    """One thing scrolls, everything is inside of the page, in light and dark."""
    viewer.open(name)
    for width, height, dark in ((1024, 640, False), (1024, 640, True), (420, 800, False), (420, 800, True)):
        viewer.window.size(width, height, dark)
        viewer.say("app.setEvent(5);")
        seen = viewer.ask("""({ width: document.documentElement.scrollWidth, window: innerWidth,
          scrolling: [...document.querySelectorAll('body *')].filter(e => /auto|scroll/.test(getComputedStyle(e).overflowY) &&
            e.scrollHeight > e.clientHeight + 1).map(e => e.id || e.tagName),
          lost: [...document.querySelectorAll('button, input, select, canvas')].filter(e => e.offsetParent !== null)
            .map(e => [e.id, e.getBoundingClientRect()]).filter(([, b]) => b.left < -1 || b.right > innerWidth + 1 || b.width < 8)
            .map(([id]) => id),
          pages: [document.getElementById('rows-up'), document.getElementById('rows-down')].every(b => b.offsetParent !== null),
          back: getComputedStyle(document.body).backgroundColor })""")
        if seen["width"] > seen["window"] or seen["scrolling"] or seen["lost"] or not seen["pages"]:
            fail(f"{name} at {width} x {height}: {seen}")
        if (seen["back"] == "rgb(255, 255, 255)") == dark:
            fail(f"{name}: the background is {seen['back']}, dark: {dark}")
    viewer.window.size(1400, 950)


# A square that turns and a wedge, as in the guide: an order of normals fails first.
TURNING = {"kinex": 1, "name": "turning", "dimension": 2, "time": {"start": 0, "end": "1/2"}, "maintain": ["separation_mixed"],
           "objects": [{"id": "square", "polygon": [[-1, -1], [1, -1], [1, 1], [-1, 1]], "motion": [[0], [0]],
                        "rotor": [[1], [0, 1]]},
                       {"id": "wedge", "polygon": [[0, 0], [2, "-1/2"], [2, "1/2"]],
                        "motion": [{"coordinates": [[2, "-1/2"], [1]], "rotor": [[1, -2], [0, 2]]}]}]}
# Two ships as in the guide: a name would lie over a number of the scales.
SHIPS = "id,t,x,y,course\n" + "".join(f"ferry,{t},{x},{y},{course}\n" for t, x, y, course in (
    (0, -900, -150, 80), (60, -420, -60, 80), (120, 60, 20, 95), (180, 540, -20, 95))) + (
        "tanker,0,700,500,225\ntanker,180,-100,-300,225\n")
HULLS = "id,x,y\n" + "".join(f"{ship},{x},{y}\n" for ship, tail, side, bow, tip in (
    ("ferry", -60, 12, 45, 60), ("tanker", -150, 24, 120, 150))
    for x, y in ((tail, -side), (bow, -side), (tip, 0), (bow, side), (tail, side)))


def check_pictures(viewer, chromium, name, records):
    """SVG and PNG of the drawings: texts apart from one another, the names of the axes among them."""
    viewer.open(name)
    # What fonts a machine has is not known: pictures have to suit narrow and wide ones, and numbers beside the names of axes.
    cases = [(family, width, k) for family, widths in (("system-ui, sans-serif", (760,)), ("monospace", range(560, 780, 20)))
             for width in widths for k in records]
    drawings = []
    for family, width, k in cases:
        viewer.ask(f"FACE.family = {json.dumps(family)}")
        svg = viewer.ask(f"(app.setEvent({k}), app.draw(), pictureAsSvg({width}, 520))")
        title = xml.etree.ElementTree.fromstring(svg).findtext("{*}title")
        if not title or (f"log record {k} " if k else "t = 0") not in title:
            fail(f"{name}: the picture of record {k} is called {title!r}")
        drawings.append(f"<div>{svg}</div>")
    for case, picture in zip(cases, look(chromium, drawings)):
        faults = list(faults_of(picture))
        texts = [text for text, _ in picture["texts"]]
        if faults or "x \u2192" not in texts or "y \u2191" not in texts:
            fail(f"{name}, {case}: {faults}, {texts}")
    png = base64.b64decode(viewer.ask("kinexFrame({ u: 0.5, width: 300, height: 200 })").split(",")[1])
    if struct.unpack(">II", png[16:24]) != (300, 200):
        fail("a frame has another size")


def check_scales(viewer, chromium):
    """Long numbers leave the names of the axes alone, wherever the origin is."""
    svgs = viewer.ask("""[...Array(40).keys()].map(i => {
      const context = new SvgContext(300, 200);
      new Sheet(context, 300, 200).begin();
      drawScales(context, [0, 0, 300, 200], [60 + 3 * i, 90 + i], DATA.scale / 500, new Places([0, 0, 300, 200]));
      return context.result("scales");
    })""")
    for origin, picture in enumerate(look(chromium, [f"<div>{svg}</div>" for svg in svgs])):
        texts = [text for text, _ in picture["texts"]]
        if list(faults_of(picture)) or len(texts) < 4:
            fail(f"scales, origin {origin}: {list(faults_of(picture))}, {texts}")


def check_animation(source, folder):
    script = source / "experiments" / "view" / "animate.py"
    page, frames, moving = folder / "square.html", folder / "frames", folder / "moving.png"
    for output, more in ((frames, ["--records"]), (moving, ["--to", "0.5"])):
        subprocess.run([sys.executable, "-B", script, page, output, "--frames", "4", "--size", "200x160", *more], check=True,
                       stdout=subprocess.DEVNULL)
    if sorted(p.name for p in frames.iterdir()) != [f"frame-000{i}.png" for i in range(1, 5)]:
        fail("the folder has other files than four frames")
    data = moving.read_bytes()
    if data.count(b"fcTL") != 4 or b"acTL" not in data:
        fail("the animated PNG does not have four frames")
    again = subprocess.run([sys.executable, "-B", script, page, moving], stderr=subprocess.PIPE, text=True, check=False)
    if again.returncode != 2 or "--force" not in again.stderr:
        fail(f"an animation that exists is replaced: {again.stderr}")
    # Frames of an earlier animation stay, and are no part of a later one.
    shorter = subprocess.run([sys.executable, "-B", script, page, frames, "--records", "--frames", "2", "--force"],
                             stderr=subprocess.PIPE, text=True, check=False)
    if (shorter.returncode != 2 or "2 are drawn: those up to record 1; give --frames" not in shorter.stderr
            or "frame-0003.png to frame-0004.png would stay there" not in shorter.stderr
            or len(list(frames.iterdir())) != 4):
        fail(f"an animation is mixed with an earlier one, or cut in silence: {shorter.stderr}")


LARGEST_RECORD = 300  # bytes, with its proof; one without takes some 110


def check_long(viewer):
    """A run whose data are packed opens and shows the same; so small that 160,000 records have a page."""
    viewer.kinex("gen", "uniform-square", "--n", "300", "--seed", "5", "--maintain", "delaunay_2", "-o", "long.json")
    viewer.kinex("view", "long.json", "-o", "long.html")
    viewer.kinex("run", "long.json", "--events", "long.jsonl", "--audit", "none")
    text = (viewer.folder / "long.html").read_text(encoding="utf-8")
    if "DecompressionStream" not in text:
        fail("the data of a long run are not packed")
    events = [json.loads(line) for line in (viewer.folder / "long.jsonl").read_text().splitlines()][1:-1]
    viewer.kinex("gen", "uniform-square", "--n", "3", "--maintain", "delaunay_2", "-o", "short.json")
    viewer.kinex("view", "short.json", "-o", "short.html")
    record = (len(text) - len((viewer.folder / "short.html").read_text(encoding="utf-8"))) / len(events)
    if record > LARGEST_RECORD:
        fail(f"a record of a long run takes {record:.0f} bytes of the page, more than {LARGEST_RECORD}")
    viewer.open("long.html")
    for k in (1, len(events) // 2, len(events)):
        shown = viewer.ask(f"(app.setEvent({k}), [kindOf(FIRST, {k}), FIRST.ids[{k - 1}].map(nameOf),"
                           f" instantOf(FIRST, {k})[0]])")
        event = events[k - 1]
        if shown != [event["kind"], event["ids"], event["time"]["decimal"]]:
            fail(f"record {k} of a long run is {shown}")
    return len(events), len(text)


def check_queries(viewer):
    """The queries of a scene are drawn with their nodes, for every tree; boxes are drawn as boxes."""
    trees = ["range_tree_2", "rank_kd_tree_2", "pseudo_kd_tree_2", "trajectory_tree"]
    viewer.kinex("gen", "uniform-square", "--n", "30", "--seed", "4", "--maintain", ",".join(trees + ["bounding_box"]),
                 "-o", "queries.json")
    path = viewer.folder / "queries.json"
    scene = json.loads(path.read_text())
    scene["queries"] = [{"at": "1/4", "box": [["1/8", "5/8"], ["1/4", "3/4"]]},
                        {"at": "1/2", "box": [["0", "1"], ["2/5", "3/5"]]}]
    path.write_text(json.dumps(scene))
    viewer.kinex("view", "queries.json", "-o", "queries.html")
    viewer.open("queries.html")
    answers = viewer.ask("FIRST.queries.map(q => q.answers.map(([s, ids, nodes]) => "
                         "[DATA.structures[s].name, ids, nodes.map(([place, objects]) => [place, objects.length])]))")
    for query in answers:
        if [name for name, _, _ in query] != trees or len({tuple(ids) for _, ids, _ in query}) != 1:
            fail(f"the answers of the trees are {query}")
        if any(not nodes or max(size for _, size in nodes) > 30 for _, _, nodes in query):
            fail(f"the nodes are {query}")
    ink = ("(() => { app.draw(); const c = document.getElementById('picture'); const hex = [1, 3, 5].map(i => "
           "parseInt(COLOUR.first.slice(i, i + 2), 16)); const p = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;"
           " let n = 0; for (let i = 0; i < p.length; i += 4) if (hex.every((x, j) => p[i + j] === x)) ++n; return n; })()")
    for name in trees:
        viewer.say(f"app.setStructure(DATA.structures.findIndex(s => s.name === '{name}')); app.setTime(0.4);")
        before = viewer.ask(ink)
        viewer.say("dispatchEvent(new KeyboardEvent('keydown', { key: 'q' }));")
        at = viewer.ask("queryShown(app) === null ? null : queryShown(app).at")
        if at != "1/2" or viewer.ask(ink) < before + 300:
            fail(f"{name}: the query at {at} is not drawn")
    box = viewer.ask("(() => { const s = DATA.structures.findIndex(s => s.role === 'box'); app.setStructure(s); app.setTime(0.1);"
                     " app.draw(); return OUTLINES.box(app.drawing, app.replay.ids); })()")
    if len(box) != 4 or box[0][0] != box[3][0] or box[0][1] != box[1][1] or not box[0][0] < box[1][0]:
        fail(f"the box is {box}")


def check_figures(viewer):
    """The smallest circle, the narrowest strip and the least rectangles are drawn from the points that are named: all points are
    inside, and those that are named are on the figure; the farthest pair is a segment."""
    names = ["min_circle_2", "min_circle_2_brute_force", "width_2", "min_area_rectangle_2", "min_perimeter_rectangle_2", "diameter_2"]
    viewer.kinex("gen", "uniform-square", "--n", "25", "--seed", "1", "--maintain", ",".join(names), "-o", "figures.json")
    viewer.kinex("view", "figures.json", "-o", "figures.html")
    viewer.open("figures.html")
    sizes = set()
    for name in names:
        viewer.say(f"app.setStructure(DATA.structures.findIndex(s => s.name === '{name}'));")
        for u in (0.02, 0.3, 0.55, 0.9):
            seen = viewer.ask(f"(() => {{ app.setTime({u}); app.draw(); const plane = app.drawing, role = DATA.structures[app.shown()].role;"
                              " const pairs = [...(app.replay.edges || [])].map(code => [Math.floor(code / OBJECTS), code % OBJECTS]);"
                              " return { ids: role in OUTLINES ? app.replay.ids : pairs.flat(), points: [...Array(OBJECTS).keys()].map(id => plane.at(id)),"
                              " figure: role in OUTLINES ? OUTLINES[role](plane, app.replay.ids) : null }; })()")
            points, ids, figure = seen["points"], seen["ids"], seen["figure"]
            if name == "diameter_2":
                lengths = [math.dist(p, q) for p in points for q in points]
                if len(ids) != 2 or max(lengths) - math.dist(points[ids[0]], points[ids[1]]) > 1e-6:
                    fail(f"{name} at {u}: {ids}")
                continue
            # How far each point is inside; 0 on the figure.
            if name.startswith("min_circle"):
                circle = figure[0]
                inside = [circle["radius"] - math.dist(circle["centre"], p) for p in points]
                sizes.add(len(ids))
            else:
                sides = ([[s["from"], s["to"]] for s in figure[:2]] if name == "width_2"
                         else [[figure[i], figure[(i + 1) % 4]] for i in range(4)])
                middle = [sum(p[axis] for side in sides for p in side) / (2 * len(sides)) for axis in (0, 1)]

                def height(side, point):
                    (ax, ay), (bx, by) = side
                    return ((bx - ax) * (point[1] - ay) - (by - ay) * (point[0] - ax)) / math.dist(*side)

                inside = [min(height(s, p) * (1 if height(s, middle) > 0 else -1) for s in sides) for p in points]
            if min(inside) < -1e-6 or any(abs(inside[i]) > 1e-6 for i in ids):
                fail(f"{name} at {u}: {ids} on {figure}, points inside by {inside}")
    if sizes != {2, 3}:
        fail(f"the circles pass through {sizes} points")
    # The same in pixels: the figure has the colour of the attribute, but for smooth edges.
    ink = ("(() => { app.draw(); const c = document.getElementById('picture'); const hex = [1, 3, 5].map(i => "
           "parseInt(COLOUR.first.slice(i, i + 2), 16)); const p = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;"
           " let n = 0; for (let i = 0; i < p.length; i += 4) if (hex.every((x, j) => Math.abs(p[i + j] - x) < 60)) ++n; return n; })()")
    for name in names:
        viewer.say(f"app.setStructure(DATA.structures.findIndex(s => s.name === '{name}')); app.setTime(0.3);")
        drawn = viewer.ask(ink)
        if drawn < 300:
            fail(f"{name} is not drawn: {drawn} pixels")


def check_sets(viewer):
    """A sequence that is no order by a key is marked points; an order is joined."""
    viewer.kinex("gen", "uniform-square", "--n", "9", "--seed", "1", "--maintain", "trajectory_tree,sorted_list", "-o", "sets.json")
    viewer.kinex("view", "sets.json", "-o", "sets.html")
    viewer.open("sets.html")
    for index, (lines, rings) in enumerate(((0, 9), (1, 0))):
        viewer.say(f"app.setStructure({index}); app.setMode('plane');")
        svg = viewer.ask("pictureAsSvg(500, 400)")
        colour = viewer.ask("COLOUR.first")
        paths = [path for path in re.findall(r'<path d="([^"]*)" fill="none" stroke="([^"]*)"', svg) if path[1] == colour]
        seen = (sum("L" in d for d, _ in paths), sum("A" in d for d, _ in paths))
        if seen != (lines, rings):
            fail(f"structure {index} is drawn by {seen[0]} lines and {seen[1]} rings, not {lines} and {rings}")


def check_next(viewer):
    """The page opens with the structure that was asked for; what fails next is marked whenever some certificate fails."""
    viewer.open("figures.html")
    label = viewer.ask("DATA.structures[app.index].label")
    if label != "min_circle_2":
        fail(f"the page opens with {label}")
    seen = viewer.ask("(() => { const seen = []; app.setStructure(DATA.structures.findIndex(s => s.name === 'width_2'));"
                      " for (let k = BEFORE; k <= LAST; k += 3) { app.setEvent(k); app.draw(); const { proof } = app;"
                      " const fails = [...proof.live].map(c => proof.failsAt(c, k)).filter(e => e !== null).sort((a, b) => a - b);"
                      " const next = proof.next(k); seen.push([fails.length ? fails[0] : null, next && next[1],"
                      " document.getElementById('legend').textContent.includes('none of these')]); } return seen; })()")
    for first, marked, none in seen:
        if first != marked or none != (first is None):
            fail(f"the first failure is at {first}, marked is {marked}")
    if all(none for *_, none in seen):
        fail("no certificate of the width fails")


def check_leaders(viewer):
    """Labels of an order stand at their points as far as there is room; two normals are drawn inside of their chart."""
    places = "placesInOrder({}, 16, 44, 400)"
    for wanted, answer in (("[60, 100, 300]", [60, 100, 300]), ("[100, 50, 200]", [67, 83, 200]), ("[60, 60, 60]", [44, 60, 76]),
                           ("[undefined, 390, 395]", [368, 384, 400]), ("[]", [])):
        if viewer.ask(places.format(wanted)) != answer:
            fail(f"labels for {wanted} are at {viewer.ask(places.format(wanted))}, not {answer}")
    (viewer.folder / "turning.json").write_text(json.dumps(TURNING))
    viewer.kinex("view", "turning.json", "-o", "turning.html")
    viewer.open("turning.html")
    for width, height in ((1400, 950), (1024, 640), (420, 800)):
        viewer.window.size(width, height, False)
        seen = viewer.ask("(() => { const places = [], plain = badge; badge = (c, text, x, y) => places.push([x, y]);"
                          " app.setEvent(0); app.draw(); badge = plain; return [app.drawing.chart.frame.rectangle, places]; })()")
        (left, top, wide, high), badges = seen
        if len(badges) < 2 or any(not (left + 8 < x < left + wide - 8 and top + 8 < y < top + high - 8) for x, y in badges):
            fail(f"at {width} x {height} the certificates' numbers are at {badges} in {seen[0]}")
    viewer.window.size(1400, 950)


def check_figures_along(viewer):
    """The least strip and boxes along fixed directions touch the points that are named, are along a direction, hold all points that
    the structure is built from, and are the least of all directions, found here from the points."""
    some = [f"p{i}" for i in range(12)]
    maintain = [{"structure": name, "k": k, "as": f"{name}_{k}", **of}
                for name in ("width_directions", "min_area_rectangle_directions", "min_perimeter_rectangle_directions")
                for k, of in ((1, {}), (2, {}), (5, {}), (3, {"of": some}))]
    viewer.kinex("gen", "uniform-square", "--n", "25", "--seed", "1", "-o", "along.json")
    scene = json.loads((viewer.folder / "along.json").read_text())
    scene["maintain"] = maintain
    (viewer.folder / "along.json").write_text(json.dumps(scene))
    viewer.kinex("view", "along.json", "-o", "along.html")
    viewer.open("along.html")
    for index, one in enumerate(maintain):
        k, sides = one["k"], 1 if one["structure"].startswith("width") else 2
        angles = [2 * math.atan(i / k) + turn for turn in (0, math.pi / 2) for i in range(k)]
        for u in (0.02, 0.3, 0.55, 0.9):
            seen = viewer.ask(f"(() => {{ app.setStructure({index}); app.setTime({u}); app.draw(); const plane = app.drawing;"
                              " return { ids: app.replay.row, figure: OUTLINES[DATA.structures[app.shown()].role](plane, app.replay.row),"
                              " points: [...Array(OBJECTS).keys()].map(id => plane.at(id)), names: DATA.ids }; })()")
            # On the screen, where the second axis points down.
            held = [p for name, p in zip(seen["names"], seen["points"]) if "of" not in one or name in some]
            at = [seen["points"][i] for i in seen["ids"]]
            if len(at) != 2 * sides:
                fail(f"{one} at {u}: {seen['ids']}")

            def extent(angle, points):
                along = [x * math.cos(angle) - y * math.sin(angle) for x, y in points]
                return max(along) - min(along)

            if sides == 1:
                (line, other), drawn = seen["figure"][:2], lambda angle: extent(angle, at)
                (x0, y0), (x1, y1) = line["from"], line["to"]
                angle = next((a for a in angles if abs((x1 - x0) * math.cos(a) - (y1 - y0) * math.sin(a)) < 1e-6), None)
                least = min(extent(a, held) for a in angles)
                if angle is None or abs(extent(angle, [line["from"], other["from"]]) - least) > 1e-6:
                    fail(f"{one} at {u}: {seen['figure']}, not of width {least}")
                if abs(drawn(angle) - least) > 1e-6:
                    fail(f"{one} at {u}: {seen['ids']} do not touch both lines")
            else:
                measure = (lambda w, h: w * h) if "area" in one["structure"] else (lambda w, h: w + h)
                least = min(measure(extent(a, held), extent(a + math.pi / 2, held)) for a in angles[:k])
                a, b, _, d = seen["figure"]
                size = measure(math.dist(a, b), math.dist(a, d))
                if abs(size - least) > 1e-6 * least:
                    fail(f"{one} at {u}: {seen['figure']} is {size}, not {least}")

                def outside(p):
                    s, t = (((p[0] - a[0]) * (q[0] - a[0]) + (p[1] - a[1]) * (q[1] - a[1])) / math.dist(a, q) ** 2 for q in (b, d))
                    return [-s, s - 1, -t, t - 1]

                touched = [abs(outside(p)[side]) for p, side in zip(at, (1, 0, 3, 2))]
                if max(max(outside(p)) for p in held) > 1e-6 or max(touched) > 1e-6:
                    fail(f"{one} at {u}: {seen['figure']} does not touch {seen['ids']}, or not all points are inside")


def main():
    chromium = browser()
    source = pathlib.Path(sys.argv[2])
    sys.path.insert(0, str(source / "experiments" / "view"))
    import devtools  # pylint: disable=import-outside-toplevel
    with tempfile.TemporaryDirectory() as name, devtools.Browser(1400, 950) as window:
        viewer = Viewer(sys.argv[1], name, window)
        folder = viewer.folder
        (folder / "close.json").write_text(json.dumps(CLOSE))
        viewer.kinex("gen", "uniform-square", "--n", "24", "--seed", "3", "--maintain", "delaunay_2,maximum_heap,sorted_list",
                     "-o", "square.json")
        viewer.kinex("gen", "polygon-orbit", "--n", "12", "--separation", "1/4", "--maintain",
                     "separation_mixed,closest_features", "-o", "bodies.json")
        for scene in ("close", "square", "bodies"):
            viewer.kinex("run", f"{scene}.json", "--events", f"{scene}.jsonl", "--audit", "none")
            viewer.kinex("view", f"{scene}.json", "-o", f"{scene}.html")
        events = [json.loads(line) for line in (folder / "square.jsonl").read_text().splitlines()][1:-1]
        viewer.open("square.html")
        check_filter(viewer, events)
        check_words(viewer, events)
        check_root(viewer, 30)
        check_close(viewer)
        for page in ("square.html", "bodies.html"):
            check_sizes(viewer, page)
        check_queries(viewer)
        check_figures(viewer)
        check_next(viewer)
        check_sets(viewer)
        check_leaders(viewer)
        check_figures_along(viewer)
        check_pictures(viewer, chromium, "square.html", [0, 5, 40, 90])
        (folder / "ships.csv").write_text(SHIPS)
        (folder / "hulls.csv").write_text(HULLS)
        viewer.kinex("import", "ships.csv", "--polygons", "hulls.csv", "--bearing", "course", "-o", "ships.json")
        viewer.kinex("view", "ships.json", "-o", "ships.html")
        check_pictures(viewer, chromium, "ships.html", range(11))
        check_scales(viewer, chromium)
        check_animation(source, folder)
        records, size = check_long(viewer)
    print(f"{len(events)} log records filtered; {records} packed into {size // 1024} kB")


if __name__ == "__main__":
    main()
