# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes in space on the page of `kinex view`: an orthogonal projection that can be turned.

usage: view_space.py PROGRAM SOURCE_FOLDER
The witnesses: matrices of rotation that are written down here, and the corners of cells as the event log has
them. Exit code 77 (skipped) where there is no Chromium.
"""
import itertools
import json
import math
import pathlib
import sys
import tempfile
import xml.etree.ElementTree

from chromium import browser
from committed_figures import faults_of, look
from viewer import READY, SETTLE, Viewer

# As the keys X, Y and Z and some others look at it.
VIEWS = [(0, 0), (90, 0), (0, 90), (24, 18), (-130, -47), (61, -90)]
PICTURE = """(() => { app.drawCanvases(); const p = app.plane; return {
  seen: [...p.sx].map((x, i) => [x - p.cx - p.dx, p.cy + p.dy - p.sy[i], p.sz[i] * p.scale]),
  positions: DATA.ids.map((_, i) => p.positionOf(i)), middle: p.middle, scale: p.scale, dx: p.dx, dy: p.dy,
  yaw: p.camera.yaw, pitch: p.camera.pitch }; })()"""
INK = """(name => { app.drawCanvases(); const c = document.getElementById('picture');
  const hex = [1, 3, 5].map(i => parseInt(COLOUR[name].slice(i, i + 2), 16));
  const p = c.getContext('2d').getImageData(0, 0, c.width, c.height).data; let n = 0;
  for (let i = 0; i < p.length; i += 4) if (hex.every((x, j) => p[i + j] === x)) ++n; return n; })"""

ANY = """(() => { app.drawCanvases(); const c = document.getElementById('picture');
  const p = c.getContext('2d').getImageData(0, 0, c.width, c.height).data; let n = 0;
  for (let i = 3; i < p.length; i += 4) if (p[i] > 0) ++n; return n; })()"""


def fail(text):
    sys.exit(f"view_space: {text}")


def projected(vector, yaw, pitch):
    """To the right, upwards and towards the eye: a rotation about z, then one about the line to the right."""
    yaw, pitch = math.radians(yaw), math.radians(pitch)
    x, y, z = vector
    right = x * math.cos(yaw) + y * math.sin(yaw)
    away = y * math.cos(yaw) - x * math.sin(yaw)
    return (right, away * math.sin(pitch) + z * math.cos(pitch), z * math.sin(pitch) - away * math.cos(pitch))


def close(u, v, margin=1e-6):
    return all(abs(a - b) <= margin * (1 + abs(a)) for a, b in zip(u, v))


def check_views(viewer):
    """Every point is where the projection has it; turning changes no scale."""
    scales = set()
    for yaw, pitch in VIEWS:
        viewer.say(f"app.plane.camera.look({yaw}, {pitch}); app.setEvent(3);")
        picture = viewer.ask(PICTURE)
        for position, seen in zip(picture["positions"], picture["seen"]):
            vector = [(p - m) * picture["scale"] for p, m in zip(position, picture["middle"])]
            if not close(projected(vector, yaw, pitch), seen):
                fail(f"from ({yaw}, {pitch}) {position} is at {seen}, not {projected(vector, yaw, pitch)}")
        scales.add(round(picture["scale"], 9))
    if len(scales) != 1:
        fail(f"turning changes the scale: {scales}")


def check_controls(viewer):
    """Dragging and keys turn, dragging with shift moves; the address keeps the view, and Fit keeps it, too."""
    drag = ("(shift => { const c = app.picture.canvas, b = c.getBoundingClientRect(); c.setPointerCapture = () => {};"
            " const at = (kind, x, y) => c.dispatchEvent(new PointerEvent(kind, { clientX: b.left + x, clientY: b.top + y,"
            " pointerId: 1, shiftKey: shift, bubbles: true }));"
            " at('pointerdown', 200, 200); at('pointermove', 240, 230); at('pointerup', 240, 230); })")
    viewer.say("app.drawing.camera.reset(); app.drawing.fit();")
    start = viewer.ask(PICTURE)
    viewer.say(drag + "(false)")
    turned = viewer.ask(PICTURE)
    if (turned["yaw"], turned["pitch"]) != (start["yaw"] - 20, start["pitch"] + 15) or turned["dx"] != 0:
        fail(f"a drag by (40, 30) turns from {start['yaw']}, {start['pitch']} to {turned['yaw']}, {turned['pitch']}")
    if not viewer.ask("location.hash").endswith(f"&view={turned['yaw']},{turned['pitch']}"):
        fail(f"the address is {viewer.ask('location.hash')}")
    viewer.say(drag + "(true)")
    moved = viewer.ask(PICTURE)
    if (moved["dx"], moved["dy"], moved["yaw"]) != (40, 30, turned["yaw"]):
        fail(f"a drag with shift does {moved}")
    viewer.say("document.getElementById('fit').click();")
    fitted = viewer.ask(PICTURE)
    if (fitted["dx"], fitted["dy"], fitted["yaw"]) != (0, 0, turned["yaw"]):
        fail(f"Fit does {fitted}")

    def press(key):
        viewer.say(f"dispatchEvent(new KeyboardEvent('keydown', {{ key: '{key}' }}));")
        return [viewer.ask("app.plane.camera.yaw"), viewer.ask("app.plane.camera.pitch")]

    keys = {"5": [24, 18], "6": [39, 18], "8": [39, 33], "4": [24, 33], "2": [24, 18], "x": [90, 0], "y": [0, 0],
            "z": [0, 90]}
    for key, wanted in keys.items():
        if press(key) != wanted:
            fail(f"{key} turns to {press(key)}, not {wanted}")
    if press("8") != [0, 90]:
        fail("the picture can be turned over")
    viewer.window.open(viewer.ask("location.href.split('#')[0]") + "#event=2&view=-40,12.5")
    viewer.ask(READY)
    viewer.ask(SETTLE)
    found = viewer.ask("[app.k, app.plane.camera.yaw, app.plane.camera.pitch]")
    if found != [2, -40, 12.5]:
        fail(f"an address with a view opens {found}")


def check_cells(viewer, events):
    """The edges of cells are those of the log, and each is drawn from corner to corner."""
    viewer.say("app.setStructure(0);")
    seen = 0
    for k in (0, len(events) // 2, len(events)):
        viewer.say(f"app.setEvent({k});")
        cells = viewer.ask("kinexState().structures[DATA.structures[0].label]")
        wanted = {tuple(sorted(pair)) for cell in cells for pair in itertools.combinations(cell, 2)}
        lines = viewer.ask("""(() => { const lines = new Set(), context = app.picture.context, move = context.moveTo, line = context.lineTo;
          let at = null; const plane = app.plane;
          const name = (x, y) => DATA.ids.findIndex((_, i) => plane.sx[i] === x && plane.sy[i] === y);
          context.moveTo = function (x, y) { at = [x, y]; return move.call(this, x, y); };
          context.lineTo = function (x, y) { if (at) { const ends = [name(...at), name(x, y)];
            if (!ends.includes(-1) && this.strokeStyle === COLOUR.first) lines.add(ends.map(nameOf).sort().join(' ')); }
            return line.call(this, x, y); };
          app.drawCanvases(); delete context.moveTo; delete context.lineTo; return [...lines]; })()""")
        if {tuple(line.split()) for line in lines} != wanted or not wanted:
            fail(f"after record {k} the lines are {sorted(lines)}, not {sorted(wanted)}")
        seen += len(wanted)
    return seen


def check_figures(viewer):
    """Spheres go through their points and planes have a fourth point; both leave ink."""
    shapes = viewer.ask("""[...app.proof.live].map(c => { const claim = app.proof.certificate(c);
      const ball = sphereThrough(claim.ids.slice(0, 4).map(id => app.plane.positionOf(id)));
      return { figure: claim.form.figure, count: claim.ids.length, ball, scale: app.plane.scale,
               points: claim.ids.map(id => app.plane.positionOf(id)), shapes: shapesOf(claim, app.plane) }; })""")
    for one in shapes:
        if (one["figure"], one["count"]) not in (("circle", 5), ("turn", 4)):
            fail(f"a certificate in space has the figure {one['figure']} of {one['count']} points")
        if one["count"] == 4:
            continue
        radius = one["ball"]["radius"]
        if any(abs(math.dist(p, one["ball"]["centre"]) - radius) > 1e-6 * radius for p in one["points"][:4]):
            fail(f"the sphere {one['ball']} does not go through {one['points']}")
        circles = [s for s in one["shapes"] if "centre" in s]
        if len(circles) != 1 or abs(circles[0]["radius"] - radius * one["scale"]) > 1e-6 * circles[0]["radius"]:
            fail(f"the outline of a sphere is {circles}")
    if {one["count"] for one in shapes} != {4, 5}:
        fail("the certificates are of one kind alone")
    inks = []
    for count in (4, 5):
        viewer.say(f"app.select([...app.proof.live].find(c => app.proof.certificate(c).ids.length === {count}));")
        inks.append(viewer.ask(INK + "('selected')"))
    viewer.say("app.select(null);")
    if min(inks) < 60 or viewer.ask(INK + "('selected')") > min(inks) / 4:
        fail(f"selected certificates leave {inks} pixels")


def check_boxes(viewer):
    """The box of the points has the edges of a box; a scene of boxes and one of balls open."""
    box = viewer.ask("(() => { app.setStructure(DATA.structures.findIndex(s => s.role === 'box')); app.plane.camera.look(24, 18);"
                     " app.drawCanvases(); return OUTLINES.box(app.plane, app.replay.ids); })()")
    edges = {tuple(sorted((tuple(box[i]), tuple(box[i - 1])))) for i in range(len(box))}
    if len({tuple(corner) for corner in box}) != 8 or len(edges) != 12:
        fail(f"the box in space has {len(edges)} edges: {box}")
    for workload, structure in (("random-boxes", "box_pairs"), ("random-discs", "disc_pairs_all")):
        viewer.kinex("gen", workload, "--dimension", "3", "--n", "6", "--seed", "4", "--maintain", structure, "-o", "bodies.json",
                     "--force")
        viewer.kinex("view", "bodies.json", "-o", "bodies.html", "--force")
        viewer.open("bodies.html")
        outlined = viewer.ask(ANY)
        viewer.say("app.plane.drawExtents = () => {};")
        if outlined < viewer.ask(ANY) + 60:
            fail(f"{workload}: the outlines are not drawn")


def check_pictures(viewer, chromium, name):
    """The axes are named, and no text covers another, from all sides."""
    viewer.open(name)
    for yaw, pitch in VIEWS:
        svg = viewer.ask(f"(app.plane.camera.look({yaw}, {pitch}), app.setEvent(5), app.draw(), pictureAsSvg(760, 520))")
        xml.etree.ElementTree.fromstring(svg)
        picture, = look(chromium, [f"<div>{svg}</div>"])
        faults = list(faults_of(picture))
        texts = [text for text, _ in picture["texts"]]
        across = [axis for axis, end in zip("xyz", ((1, 0, 0), (0, 1, 0), (0, 0, 1)))
                  if math.hypot(*projected(end, yaw, pitch)[:2]) > 0.3]
        if faults or any(axis not in texts for axis in across):
            fail(f"{name} from ({yaw}, {pitch}): {faults}, {texts}")


def main():
    chromium = browser()
    source = pathlib.Path(sys.argv[2])
    sys.path.insert(0, str(source / "experiments" / "view"))
    import devtools  # pylint: disable=import-outside-toplevel
    with tempfile.TemporaryDirectory() as name, devtools.Browser(1400, 950) as window:
        viewer = Viewer(sys.argv[1], name, window)
        viewer.kinex("gen", "uniform-square", "--dimension", "3", "--n", "9", "--seed", "4", "--maintain",
                     "delaunay_3,bounding_box", "-o", "space.json")
        viewer.kinex("run", "space.json", "--events", "space.jsonl", "--audit", "none")
        viewer.kinex("view", "space.json", "-o", "space.html")
        events = [json.loads(line) for line in (viewer.folder / "space.jsonl").read_text().splitlines()][1:-1]
        viewer.open("space.html")
        if viewer.ask("document.querySelector('#drawing').selectedOptions[0].textContent") != "in space":
            fail("the drawing is not called one in space")
        check_views(viewer)
        check_controls(viewer)
        edges = check_cells(viewer, events)
        check_figures(viewer)
        check_boxes(viewer)
        check_pictures(viewer, chromium, "space.html")
    print(f"{len(VIEWS)} views, {edges} edges of cells")


if __name__ == "__main__":
    main()
