#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes moving.svg: a kinetic Delaunay triangulation, played from the event log of an exact run.

usage: moving.py PROGRAM            writes moving.svg beside this script
       moving.py PROGRAM --check    exit code 1 if moving.svg is not what the program gives

Points move linearly, so the picture's own animation is exact up to rounding: an edge is a line whose ends move
linearly while it lives. When edges live is read from the log alone.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
from fractions import Fraction

PICTURE = pathlib.Path(__file__).resolve().parent / "moving.svg"
WORKLOAD = ["gen", "uniform-square", "--n", "9", "--seed", "13", "--maintain", "delaunay_2"]

SECONDS = 20  # one turn of the picture
REST = 0.04  # of it: what is shown at the end stands still
FLASH = 0.35  # seconds that a failure is shown before and after it
SIZE, MARGIN, TOP = 420, 18, 16  # of the square with the points
WIDTH, HEIGHT = SIZE + 2 * MARGIN, SIZE + 126
LINE = SIZE + TOP + 44  # the line of time

STYLE = """
svg{font:13px system-ui,sans-serif;color:#24292f;background:#fff}
.e{stroke:#8c959f;stroke-width:1.4;fill:none}.old{stroke:#cf222e;stroke-width:3;fill:none}
.new{stroke:#1a7f37;stroke-width:3;fill:none}.c{fill:#bf8700;fill-opacity:.1;stroke:#bf8700;stroke-width:1.3}
.p{fill:#0969da}.n{font-weight:600}.axis,.tick{stroke:currentColor;stroke-width:1}.tick{stroke-width:1.6;opacity:.55}
.now{fill:#bf8700}text{fill:currentColor}.small{font-size:12px;opacity:.75}
@media(prefers-color-scheme:dark){svg{color:#e6edf3;background:#0d1117}.e{stroke:#6e7681}.old{stroke:#ff7b72}
.new{stroke:#3fb950}.c{fill:#d29922;stroke:#d29922}.p{fill:#58a6ff}.now{fill:#d29922}}
"""


def run(program, *words):
    done = subprocess.run([program, *map(str, words)], text=True, capture_output=True)
    if done.returncode != 0:
        sys.exit(f"{program} {' '.join(map(str, words))}: exit code {done.returncode}\n{done.stderr}")
    return done.stdout


def number(text):
    return Fraction(str(text))


class Motion:
    """A point on a straight line, at constant speed."""

    def __init__(self, axes):
        self.axes = [[number(c) for c in axis] + [Fraction(0)] * (2 - len(axis)) for axis in axes]
        if any(len(axis) > 2 for axis in self.axes):
            sys.exit("moving.py draws linear motion only")

    def at(self, t):
        return [float(a + b * t) for a, b in self.axes]


class Event:
    def __init__(self, record):
        ids = record["ids"]
        self.kind, self.ids = record["kind"], ids
        self.of = record["certificate"]["ids"] if record["certificate"] else ids
        self.predicate = record["certificate"]["predicate"]
        self.time = Fraction(record["time"]["decimal"])  # to 12 digits: for drawing
        self.degree = len(record["time"]["polynomial"]) - 1
        self.decimal, self.root = record["time"]["decimal"], record["time"]["root"]


def read(program):
    with tempfile.TemporaryDirectory() as name:
        scene, log = pathlib.Path(name) / "scene.json", pathlib.Path(name) / "log.jsonl"
        run(program, *WORKLOAD, "-o", scene)
        data = json.loads(scene.read_text(), parse_float=str, parse_int=str)
        start = number(data["time"]["start"])
        report = run(program, "run", scene, "--events", log, "--at", start, "--summary", "-")
        summary = json.loads(report)
        records = [json.loads(line) for line in log.read_text().splitlines()][1:-1]
    return data, summary, [Event(record) for record in records]


def lifetimes(events, first, start, end):
    """[(edge, from, until)], and for each event the edge that goes and the one that comes."""
    alive = {frozenset(edge): start for edge in first}
    done, changes = [], []
    for event in events:
        gone, came = change_of(event)
        if gone is not None:
            done.append((gone, alive.pop(gone), event.time))
        if came is not None:
            if came in alive:
                sys.exit(f"the edge of {sorted(came)} comes twice")
            alive[came] = event.time
        changes.append((gone, came))
    return done + [(edge, since, end) for edge, since in alive.items()], changes, set(alive)


def change_of(event):
    """The edge that an event removes and the one that it adds."""
    ids = event.ids
    if event.kind == "flip":
        return frozenset(ids[:2]), frozenset(ids[2:])
    if event.kind == "enter":  # a point comes to the hull: the edge of its neighbours goes
        return frozenset(ids[1:]), None
    if event.kind == "leave":
        return None, frozenset(ids[1:])
    sys.exit(f"moving.py does not draw {event.kind!r}: choose another seed")


class Picture:
    def __init__(self, data, events):
        self.start, self.end = number(data["time"]["start"]), number(data["time"]["end"])
        self.motions = {o["id"]: Motion(o["motion"]) for o in data["objects"]}
        ends = [m.at(t) for m in self.motions.values() for t in (self.start, self.end)]
        self.low = [min(p[i] for p in ends) for i in (0, 1)]
        span = max(max(p[i] for p in ends) - self.low[i] for i in (0, 1))
        self.scale = SIZE / span
        self.events = events
        self.parts = []

    def place(self, name, t):
        x, y = self.motions[name].at(t)
        return (MARGIN + (x - self.low[0]) * self.scale, TOP + SIZE - (y - self.low[1]) * self.scale)

    def key(self, t):
        """A scene's time as a part of a turn."""
        return float((t - self.start) / (self.end - self.start)) * (1 - REST)

    def around(self, t, seconds):
        return min(max(self.key(t) + seconds / SECONDS, 0.0), 1.0)

    def shown(self, a, b):
        """Visible in a part of a turn, hidden outside of it."""
        keys, values = [0.0], ["hidden" if a > 0 else "visible"]
        if a > 0:
            keys, values = keys + [a], values + ["visible"]
        if b < 1:
            keys, values = keys + [b], values + ["hidden"]
        if len(keys) == 1:
            return ""
        return (f'<animate attributeName="visibility" calcMode="discrete" dur="{SECONDS}s" repeatCount="indefinite" '
                f'values="{";".join(values)}" keyTimes="{";".join(f"{k:.5g}" for k in keys)}"/>')

    def moves(self, attribute, values, a, b):
        """From values[0] to values[1] in a part of a turn."""
        keys, steps = [0.0, a, b, 1.0], [values[0], values[0], values[1], values[1]]
        pairs = [pair for i, pair in enumerate(zip(keys, steps)) if i == 0 or pair[0] > keys[i - 1]]
        return (f'<animate attributeName="{attribute}" dur="{SECONDS}s" repeatCount="indefinite" '
                f'values="{";".join(v for _, v in pairs)}" keyTimes="{";".join(f"{k:.5g}" for k, _ in pairs)}"/>')

    def line(self, edge, since, until, kind, a=None, b=None):
        """An edge between two times of the scene; shown from a to b, parts of a turn."""
        u, v = sorted(edge)
        paths = ["M{:.1f} {:.1f}L{:.1f} {:.1f}".format(*self.place(u, t), *self.place(v, t))
                 for t in (since, until)]
        k, l = self.key(since), self.key(until)
        if k >= l:
            return  # it goes at the instant at which it comes
        a, b = (k if a is None else a), (b if b is not None else l if l < 1 - REST else 1.0)
        self.parts.append(f'<path class="{kind}" d="{paths[0]}">{self.moves("d", paths, k, l)}{self.shown(a, b)}</path>')

    def points(self):
        for name in self.motions:
            (x, y), (z, w) = self.place(name, self.start), self.place(name, self.end)
            self.parts.append(f'<circle class="p" r="4" cx="{x:.1f}" cy="{y:.1f}">'
                              f'{self.moves("cx", [f"{x:.1f}", f"{z:.1f}"], 0, 1 - REST)}'
                              f'{self.moves("cy", [f"{y:.1f}", f"{w:.1f}"], 0, 1 - REST)}</circle>'
                              f'<text class="n" x="{x + 7:.1f}" y="{y - 6:.1f}">{letter(name)}'
                              f'{self.moves("x", [f"{x + 7:.1f}", f"{z + 7:.1f}"], 0, 1 - REST)}'
                              f'{self.moves("y", [f"{y - 6:.1f}", f"{w - 6:.1f}"], 0, 1 - REST)}</text>')

    def failure(self, event, change):
        """What fails (its circle), what goes (before), and what comes (after)."""
        before, after = self.around(event.time, -FLASH), self.around(event.time, FLASH)
        places = [self.place(name, event.time) for name in event.of]
        circle = circle_through(places[:3])
        if len(event.of) == 4 and circle:
            x, y, r = circle
            self.parts.append(f'<circle class="c" cx="{x:.1f}" cy="{y:.1f}" r="{r:.1f}">{self.shown(before, after)}</circle>')
        step = Fraction(FLASH / SECONDS / (1 - REST)) * (self.end - self.start)
        gone, came = change
        if gone is not None:
            self.line(gone, max(event.time - step, self.start), event.time, "old", before)
        if came is not None:
            self.line(came, event.time, min(event.time + step, self.end), "new", None, after)

    def axis(self):
        right = MARGIN + SIZE
        self.parts.append(f'<path class="axis" d="M{MARGIN} {LINE}H{right}"/>')
        ticks = "".join(f"M{MARGIN + SIZE * self.key(e.time) / (1 - REST):.1f} {LINE - 9}v18" for e in self.events)
        self.parts.append(f'<path class="tick" d="{ticks}"/>')
        self.parts.append(f'<circle class="now" r="5" cx="{MARGIN}" cy="{LINE}">'
                          f'{self.moves("cx", [str(MARGIN), str(right)], 0, 1 - REST)}</circle>')

    @staticmethod
    def claim(event):
        """What its certificate has claimed until now."""
        names = [letter(name) for name in event.of]
        if event.predicate == "in_circle_2":
            return f"{names[3]} is outside the circle through {names[0]}, {names[1]}, {names[2]}"
        return f"{names[0]}, {names[1]}, {names[2]} is a left turn"

    def words(self):
        y = LINE + 32
        total = len(self.events)
        keys = [0.0] + [self.key(e.time) for e in self.events] + [1.0]
        for k in range(total + 1):
            if k == 0:
                text, small = f"event 0 of {total}: every certificate holds", "a certificate is a claim about four points, or three of the hull"
            else:
                event = self.events[k - 1]
                text = f"event {k} of {total}: no longer true: {self.claim(event)}"
                small = f"t = {event.decimal}.. = root {event.root} of a known polynomial of degree {event.degree}"
            self.parts.append(f'<g visibility="{"hidden" if k else "visible"}"><text x="{MARGIN}" y="{y}">{text}</text>'
                              f'<text class="small" x="{MARGIN}" y="{y + 18}">{small}</text>{self.shown(keys[k], keys[k + 1])}</g>')

    def text(self, lives, changes):
        for edge, since, until in lives:
            self.line(edge, since, until, "e")
        for event, change in zip(self.events, changes):
            self.failure(event, change)
        self.points()
        self.axis()
        self.words()
        what = f"{len(self.motions)} moving points, their Delaunay triangulation, and the {len(self.events)} events at which it changes"
        return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" '
                f'role="img"><title>{what}</title>\n<!-- Made by experiments/pictures/moving.py; do not edit. -->\n'
                f'<style>{STYLE}</style>\n<clipPath id="b"><rect x="0" y="0" width="{WIDTH}" height="{SIZE + 2 * TOP}"/></clipPath>\n'
                + self.clipped() + "</svg>\n")

    def clipped(self):
        return "".join(part.replace('class="c"', 'class="c" clip-path="url(#b)"', 1) + "\n" for part in self.parts)


def letter(name):
    """p0 is a, p1 is b, .."""
    return chr(ord("a") + int(name[1:]))


def circle_through(places):
    (ax, ay), (bx, by), (cx, cy) = places
    d = 2 * (ax * (by - cy) + bx * (cy - ay) + cx * (ay - by))
    if abs(d) < 1e-9:
        return None
    a, b, c = ax * ax + ay * ay, bx * bx + by * by, cx * cx + cy * cy
    x, y = (a * (by - cy) + b * (cy - ay) + c * (ay - by)) / d, (a * (cx - bx) + b * (ax - cx) + c * (bx - ax)) / d
    return x, y, ((ax - x) ** 2 + (ay - y) ** 2) ** 0.5


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--check"]):
        sys.exit(__doc__)
    data, summary, events = read(sys.argv[1])
    first = summary["samples"][0]["delaunay_2"]
    picture = Picture(data, events)
    lives, changes, last = lifetimes(events, first, picture.start, picture.end)
    # The picture's last edges are those of the run.
    if last != {frozenset(edge) for edge in summary["structures"]["delaunay_2"]["attribute"]}:
        sys.exit("the edges that the log leads to are not those of the run")
    made = picture.text(lives, changes)
    if sys.argv[2:]:
        if not PICTURE.exists() or PICTURE.read_text() != made:
            sys.exit(f"moving.svg is not what the program gives: python3 {__file__} PROGRAM")
        print(f"moving.svg is what the program gives: {len(events)} events, {len(made)} bytes")
    else:
        PICTURE.write_text(made)
        print(f"{PICTURE.name}: {len(events)} events, {len(made)} bytes")


main()
