# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages of `kinex view` and the log of `kinex run`: how many log records a lane has, the ends of the time window, what records without
a certificate are, numbers that no record has, the nodes of queries, and numbers that are very small, large or close together.

usage: view_records.py PROGRAM SOURCE_FOLDER
Exit code 77 (skipped) where there is no Chromium.
"""
import fractions
import json
import pathlib
import sys
import tempfile

from chromium import browser
from viewer import READY, Viewer

SQUARE = [[0, 0], [1, 0], [1, 1], [0, 1]]
# a and b overlap at the start; a gets another flight plan, c comes near both.
OVERLAP = {"kinex": 1, "name": "overlap", "dimension": 2, "time": {"start": 0, "end": 4}, "overlapping_starts": "contact",
           "objects": [{"id": "a", "polygon": SQUARE, "motion": [{"from": 0, "to": 1, "coordinates": [[0], [0]]},
                                                                 {"from": 1, "to": 4, "coordinates": [[1, -1], [0]]}]},
                       {"id": "b", "polygon": SQUARE, "motion": [["1/2", 1], ["1/4"]]},
                       {"id": "c", "polygon": SQUARE, "motion": [[8, -2], ["1/3"]]}],
           "maintain": ["separation_mixed", "closest_features"]}
# Swaps, the last one at the very end.
LATE = {"kinex": 1, "name": "late", "dimension": 1, "time": {"start": 0, "end": 2}, "maintain": ["sorted_list"],
        "objects": [{"id": "a", "motion": [[0, 1]]}, {"id": "b", "motion": [["1/2"]]}, {"id": "c", "motion": [[1]]},
                    {"id": "d", "motion": [[2]]}]}
# Every common kind but a rebuild: c comes and goes, b jumps and d gets another flight plan.
CHANGES = {"kinex": 1, "name": "changes", "dimension": 2, "time": {"start": 0, "end": 4}, "jumps": True,
           "objects": [{"id": "a", "motion": [[0, 1], [0, "1/3"]]},
                       {"id": "b", "motion": [{"from": 0, "to": 2, "coordinates": [[3], [-1]]},
                                              {"from": 2, "to": 4, "coordinates": [["1/2", "1/7"], [5, -1]]}]},
                       {"id": "c", "motion": [{"from": 1, "to": 3, "coordinates": [[2], [3, -1]]}]},
                       {"id": "d", "motion": [{"from": 0, "to": 2, "coordinates": [[1, "1/2"], [4, -2]]},
                                              {"from": 2, "to": 4, "coordinates": [[0, 1], [4, -2]]}]}],
           "maintain": ["delaunay_2", "convex_hull_2", "rank_kd_tree_2"]}
WITHOUT = {"motion": "none: a change of the scene", "insert": "none: a change of the scene",
           "erase": "none: a change of the scene", "rebuild": "none: the whole proof is made anew",
           "settled": "none of its own: reports what this instant has changed"}




def around(start, place, speed, turn):
    """The coefficients of place + speed (t - start) + turn (t - start)^2."""
    speed, turn = fractions.Fraction(speed), fractions.Fraction(turn)
    return [str(place - speed * start + turn * start**2), str(speed - 2 * turn * start), str(turn)]


# Times and places as they are in the world: seconds since 1970, metres on a map; and very small ones.
LARGE = {"kinex": 1, "name": "large", "dimension": 2, "time": {"start": 1700000000, "end": 1700000020}, "maintain": ["sorted_list", "delaunay_2"],
         "objects": [{"id": name, "motion": [around(1700000000, *motion), [row]]} for name, row, *motion in (
             ("a", 437000, 5812300, "1/3", "1/97"), ("b", 437005, 5812302, "1/5", "1/89"), ("c", 437001, 5812305, "-1/7", "-1/101"),
             ("d", 437007, 5812309, "-1/3", "1/103"))]}
SMALL = {"kinex": 1, "name": "small", "dimension": 1, "time": {"start": 0, "end": "1/100000"}, "maintain": ["sorted_list"],
         "objects": [{"id": "a", "motion": [[0, 0, 1]]}, {"id": "b", "motion": [["1/100000000000"]]}, {"id": "c", "motion": [["3/100000000000"]]}]}
# The numbers of a canvas's texts, with their places: [number, x, y].
NUMBERS = """((id, draw) => { const context = document.getElementById(id).getContext("2d"), write = context.fillText, found = [];
  context.fillText = function (text, x, y) {
    if (/^-?[0-9.]+(e-?[0-9]+)?$/.test(text)) found.push([text, x, y, this.textAlign]);
    write.call(this, text, x, y); };
  draw(); delete context.fillText; return found; })"""


def fail(text):
    sys.exit(f"view_records: {text}")


def look(viewer, name, scene):
    """The log records of a scene, or of what `gen` makes; its page is open."""
    viewer.look(name, scene)
    viewer.kinex("run", f"{name}.json", "--events", f"{name}.jsonl", "--summary", f"{name}.summary.json", "--audit", "none")
    return [json.loads(line) for line in (viewer.folder / f"{name}.jsonl").read_text().splitlines()][1:-1]


def check_lanes(viewer):
    """A lane names, counts and draws all log records of its structure, those without a certificate too; the panel counts the same."""
    events = look(viewer, "overlap", OVERLAP)
    if events[0]["kind"] != "overlap" or events[0]["certificate"] or not events[0]["external"]:
        fail(f"the scene does not begin with an overlap: {events[0]}")
    if not any(e["kind"] == "motion" for e in events):
        fail("no flight plan changes")
    for k in (0, 1, len(events) // 2, len(events)):
        # The names of the lanes, and the bars that are as high as bars are, by their middle.
        names, bars, places, panel = viewer.ask(
            "(() => { const names = [], bars = [], plain = label;"
            " label = (c, text, ...more) => { names.push(text); plain(c, text, ...more); };"
            " const context = app.window.picture.canvas.getContext('2d'), fill = context.fillRect;"
            " context.fillRect = function (x, y, w, h) {"
            " if (w <= 4 && Math.abs(h) > 4) bars.push(x + w / 2); fill.call(this, x, y, w, h); };"
            f" app.setEvent({k}); app.draw(); label = plain; delete context.fillRect;"
            " const axis = app.window.axis; return [names, bars, FIRST.u.map((_, e) => Math.round(axis.x(axis.placeOf(FIRST, e + 1)))),"
            " document.getElementById('proof').textContent]; })()")
        for structure in OVERLAP["maintain"]:
            own = [e for e in events if e["structure"] == structure]
            done, external = sum(e["seq"] <= k for e in own), sum(e["external"] for e in own)
            wanted = f"{structure}  {done} of {len(own)} log records, {external} external"
            if wanted not in names:
                fail(f"after record {k} the lanes are called {names}, not {wanted!r}")
            if f"{structure}{done} of {len(own)} log records" not in panel:
                fail(f"after record {k} the panel does not have {done} of {len(own)} log records of {structure}: {panel!r}")
        lost = [event["seq"] for event, x in zip(events, places) if not any(abs(bar - x) <= 1 for bar in bars)]
        if lost or min(places) < 2:
            fail(f"after record {k} the records {lost} have no bar: {bars}, {places}")


def check_window(viewer):
    """The time window of a short run has its start and its end, with a margin, after every record and in every drawing."""
    events = look(viewer, "late", LATE)
    if events[-1]["time"]["interval"] != ["2", "2"]:
        fail(f"the last record is at {events[-1]['time']}")
    for mode in ("plane", "time", "axis"):
        for k in range(len(events) + 1):
            start, end, left, right, last = viewer.ask(
                f"(() => {{ app.setMode('{mode}'); app.setEvent({k}); app.draw(); const axis = app.window.axis;"
                " return [axis.x(0), axis.x(1), axis.left, axis.right, axis.x(axis.placeOf(FIRST, LAST))]; })()")
            if not (left + 4 < start < left + 40 and right - 40 < end < right - 4 and abs(last - end) < 1e-6):
                fail(f"{mode}, record {k}: the run goes from {start} to {end} in {left} .. {right}, its last record is at {last}")
    # A longer run: the window is around now, and has the ends when it comes to them.
    look(viewer, "many", ["uniform-square", "--n", "24", "--seed", "3", "--maintain", "sorted_list"])
    for u, inside in ((0, 0), (1, 1)):
        place, left, right, span = viewer.ask(f"(() => {{ app.setTime({u}); app.draw(); const axis = app.window.axis;"
                                              f" return [axis.x({inside}), axis.left, axis.right, app.span]; }})()")
        if not left + 4 < place < right - 4 or not span < 0.9:
            fail(f"at {u} the end of the run is at {place} in {left} .. {right}")


def check_kinds(viewer):
    """A record without a certificate is called what it is, by its kind."""
    seen = set()
    for name, scene in (("changes", CHANGES), ("grid", ["grid", "--n", "16", "--maintain", "delaunay_2"])):
        for event in look(viewer, name, scene):
            if event["kind"] not in WITHOUT:
                continue
            text = viewer.ask(f"(app.setEvent({event['seq']}), app.draw(), document.getElementById('event').innerText)")
            seen.add(event["kind"])
            if WITHOUT[event["kind"]] not in text.split("\n"):
                fail(f"{event['kind']}, record {event['seq']}: {text!r}")
    if seen != set(WITHOUT):
        fail(f"only the kinds {seen} were seen")


def check_numbers(viewer):
    """A number without a log record is told in a line, with the remedy, until something else is shown."""
    count = len(look(viewer, "numbers", CHANGES))

    def line():
        return viewer.ask("(app.draw(), (e => e.offsetParent === null ? null : e.textContent)(document.getElementById('asked')))")

    def ask_by_address(text):
        viewer.say(f"location.hash = '#event={text}';")

    def ask_by_number(text):
        viewer.say(f"const box = document.getElementById('number'); box.value = '{text}'; box.dispatchEvent(new Event('change'));")

    remedy = f"write #event= and a number from 0 to {count}."
    for ask in (ask_by_address, ask_by_number):
        for number, shown in ((count + 1, count), (10 * count, count), (-3, 2)):
            viewer.say("app.setEvent(2);")
            ask(number)
            wanted = f"There is no log record {number}: the run has {count} log records. Shown is log record {shown}; {remedy}"
            if line() != wanted or viewer.ask("app.k") != shown:
                fail(f"{number}: {line()!r}, record {viewer.ask('app.k')}, not {wanted!r}")
            viewer.say("app.setEvent(1);")
            if line() is not None:
                fail(f"{number}: the line stays: {line()!r}")
        for number in (0, 3, count):
            ask(number)
            if line() is not None or viewer.ask("app.k") != number:
                fail(f"{number}: {line()!r}, record {viewer.ask('app.k')}")
    viewer.say("app.setEvent(2);")
    ask_by_address("last")
    if not line().startswith("There is no log record last: ") or viewer.ask("app.k") != 2:
        fail(f"'last': {line()!r}, record {viewer.ask('app.k')}")
    # When the page is opened.
    viewer.window.open("about:blank")
    viewer.window.open(f"{(viewer.folder / 'numbers.html').as_uri()}#event={count + 5}")
    viewer.ask(READY)
    if f"There is no log record {count + 5}: " not in (line() or ""):
        fail(f"opened at {count + 5}: {line()!r}")


def check_nodes(viewer):
    """The nodes that are drawn are counted apart from all that the run counts, whose number is that of `kinex run`."""
    trees = ["range_tree_2", "rank_kd_tree_2", "pseudo_kd_tree_2", "trajectory_tree"]
    viewer.kinex("gen", "uniform-square", "--n", "30", "--seed", "4", "-o", "nodes.json")
    scene = json.loads((viewer.folder / "nodes.json").read_text())
    scene["maintain"] = trees
    scene["queries"] = [{"at": "1/4", "box": [["1/8", "5/8"], ["1/4", "3/4"]]}, {"at": "1/2", "box": [["0", "1"], ["2/5", "3/5"]]}]
    look(viewer, "nodes", scene)
    samples = json.loads((viewer.folder / "nodes.summary.json").read_text())["samples"]
    more = 0
    for i, sample in enumerate(samples):
        for tree in trees:
            nodes = sample["queries"][0][tree]["nodes"]
            index, places, texts = viewer.ask(
                f"(() => {{ const query = FIRST.queries[{i}], index = DATA.structures.findIndex(s => s.name === '{tree}');"
                " const answer = query.answers.find(([s]) => s === index);"
                " return [index, [0, 1, 2].map(p => answer[2].filter(([place]) => place === p).length), textsOfQuery(query, answer)]; })()")
            outside, crossed, inside = places
            drawn = f"nodes: {crossed} crossed, {inside} inside, {outside} outside"
            if texts[0].split("; ")[1:] != [drawn, f"with those below and in them, as kinex run counts: {nodes}"]:
                fail(f"{tree}, query {i}: {texts}, not {drawn} and {nodes}")
            if nodes < sum(places):
                fail(f"{tree}, query {i}: {sum(places)} nodes are drawn, {nodes} counted")
            more += nodes > sum(places)
            # The longest text that there is room for is in the picture.
            shown = viewer.ask(
                "(() => { const names = [], plain = label; label = (c, text, ...more) => { names.push(text); plain(c, text, ...more); };"
                f" app.setStructure({index}); app.setTime(FIRST.queries[{i}].u); app.setMode('plane'); app.draw(); label = plain;"
                " return names; })()")
            if texts[0] not in shown:
                fail(f"{tree}, query {i}: {texts[0]!r} is not among {shown}")
    if more < 4:
        fail("the run counts no more nodes than are drawn")


def check_instants(viewer):
    """Instants in lists keep their powers of ten and all digits before the point, and differ where the log's do."""
    for name, scene, near in (("small", SMALL, 1e-11), ("large", LARGE, 1e-4)):
        events = look(viewer, name, scene)
        shown = viewer.ask("FIRST.u.map((_, e) => shortInstant(instantOf(FIRST, e + 1)).split(' ').slice(1))")
        if len(events) < 2 or len({text for _, text in shown}) < len({e["time"]["decimal"] for e in events}):
            fail(f"{name}: instants are {shown}")
        for (_, text), event in zip(shown, events):
            value = float(fractions.Fraction(text))
            if abs(value - float(event["time"]["decimal"])) > near or len(text) > 18:
                fail(f"{name}: the instant {event['time']['decimal']} is {text}")
    viewer.say("app.setStructure(0); app.setEvent(0); document.getElementById('show-certificates').click();")
    times = viewer.ask("[0.25, 0.2501, 0.5].map(timeText)")
    if times != ["1700000005", "1700000005.002", "1700000010"]:
        fail(f"times are {times}")


def check_scales(viewer):
    """The numbers of scales differ, and each is where it says, however large, small or close together they are."""
    cases = 0
    for name in ("small", "large"):
        viewer.open(f"{name}.html")
        for zoom in (1, 30, 1000):
            for mode in ("plane", "time", "axis"):
                if viewer.ask(f"[...document.getElementById('drawing').options].find(o => o.value === '{mode}').disabled"):
                    continue
                viewer.say(f"app.setStructure(0); app.setMode('{mode}'); app.setTime(0.4); app.drawing.fit(); app.draw();"
                           f" app.span = 1.04 / {zoom}; app.zoom({zoom}); app.draw();")
                found = {"window": viewer.ask(NUMBERS + "('window', () => app.window.draw())"),
                         "picture": viewer.ask(NUMBERS + "('picture', () => app.drawing.draw(app.picture))")}
                for where, texts in found.items():
                    for axis, align in ((1, "center"), (2, "left")):
                        own = [(fractions.Fraction(text), place[axis - 1]) for text, *place in texts if place[2] == align]
                        if len(own) < 2:
                            continue
                        cases += 1
                        (v, p), (w, q) = min(own), max(own)
                        if len({value for value, _ in own}) < len(own) or v == w:
                            fail(f"{name}, {mode}, {where}, {zoom} times: equal numbers in {texts}")
                        off = max(abs(place - (p + float((value - v) / (w - v)) * (q - p))) for value, place in own)
                        if off > 2:
                            fail(f"{name}, {mode}, {where}, {zoom} times: a number is {off} pixels from its place: {texts}")
                if len(found["window"]) < 2:
                    fail(f"{name}, {mode}: the window has the numbers {found['window']}")
    if cases < 20:
        fail(f"only {cases} scales were looked at")


def main():
    browser()
    sys.path.insert(0, str(pathlib.Path(sys.argv[2]) / "experiments" / "view"))
    import devtools  # pylint: disable=import-outside-toplevel
    with tempfile.TemporaryDirectory() as name, devtools.Browser(1400, 950) as window:
        viewer = Viewer(sys.argv[1], name, window)
        for check in (check_lanes, check_window, check_kinds, check_numbers, check_nodes, check_instants, check_scales):
            check(viewer)
    print("lanes, windows, kinds, numbers, nodes, instants and scales are as they should be")


if __name__ == "__main__":
    main()
