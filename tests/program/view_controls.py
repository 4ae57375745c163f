# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of `kinex view` by hand: clicks on the window, a second run that goes on, menus, keys in lists, fingers, buttons, playing,
addresses.

usage: view_controls.py PROGRAM SOURCE_FOLDER
Exit code 77 (skipped) where there is no Chromium.
"""
import json
import pathlib
import sys
import tempfile

from chromium import browser
from view_records import CHANGES, OVERLAP
from viewer import READY, SETTLE, Viewer

# c passes d; a and b pass each other twice, 2^-39 apart: doubles see one touch, and no swap.
TOUCH = {"kinex": 1, "name": "touch", "dimension": 1, "time": {"start": 0, "end": 2}, "maintain": ["sorted_list"],
         "objects": [{"id": "a", "motion": [["302231454903657293676543/1208925819614629174706176", -1, 1]]}, {"id": "b", "motion": [[0]]},
                     {"id": "c", "motion": [[10, 1]]}, {"id": "d", "motion": [["41/4"]]}]}
KEYS = {" ": ("Space", 32, " "), "/": ("Slash", 191, "/"), "Enter": ("Enter", 13, "\r"), "ArrowDown": ("ArrowDown", 40, None),
        "ArrowUp": ("ArrowUp", 38, None), "Home": ("Home", 36, None), "End": ("End", 35, None)}


def fail(text):
    sys.exit(f"view_controls: {text}")


def press(viewer, key):
    """A key of the keyboard, for what has the focus."""
    code, number, text = KEYS[key]
    for kind in ("keyDown", "keyUp"):
        more = {"text": text} if text and kind == "keyDown" else {}
        viewer.window.call("Input.dispatchKeyEvent", type=kind, key=key, code=code, windowsVirtualKeyCode=number, **more)
    viewer.ask(SETTLE)


def check_clicks(viewer):
    """On the axis of log records a click goes to the nearest one, of the lane that it is in, however far that is."""
    for name, scene in (("overlap", OVERLAP), ("changes", CHANGES)):
        viewer.look(name, scene)
        viewer.say("app.setAxis(true);")
        rows = viewer.ask("app.draw(), BODIES ? DATA.structures.map((_, i) => [app.window.counts[0][i].records, app.window.parts(i).base - 4])"
                          " : [[FIRST.u.map((_, e) => BEFORE + e + 1), 40]]")
        far = 0
        for records, y in rows:
            for part in range(20):
                viewer.say("app.setEvent(0);")
                left, right, places = viewer.ask("(() => { app.draw(); const { axis } = app.window; return [axis.left, axis.right,"
                                                 f" {json.dumps(records)}.map(k => axis.x(k))]; }})()")
                x = left + (right - left) * (part + 0.5) / 20
                viewer.say("const bars = app.window.picture.canvas, box = bars.getBoundingClientRect(); bars.dispatchEvent("
                           f"new MouseEvent('click', {{ clientX: box.left + {x}, clientY: box.top + {y}, bubbles: true }}));")
                k, distances = viewer.ask("app.k"), [abs(place - x) for place in places]
                if k not in records or distances[records.index(k)] > min(distances) + 2:
                    fail(f"{name}: a click at {x} goes to record {k}, of {records} at {places}")
                far += min(distances) > 10
        if far < 5:
            fail(f"{name}: only {far} clicks were far from a record")


def check_second(viewer):
    """Where the first run ends before the second one, the page goes on by time: D and the button lead to what only the second one has."""
    (viewer.folder / "touch.json").write_text(json.dumps(TOUCH))
    viewer.kinex("view", "touch.json", "--arithmetic", "double", "--with", "exact", "-o", "touch.html")
    viewer.open("touch.html")
    if viewer.ask("[LAST, PARTED, OTHER.u.length]") != [1, 2, 3]:
        fail(f"the runs have {viewer.ask('[LAST, PARTED, OTHER.u.length]')}")
    seen = "app.draw(), [app.k, app.kOther(), document.getElementById('event').innerText.includes('exact, last log record by then: 2')]"
    for way in ("dispatchEvent(new KeyboardEvent('keydown', { key: 'd' }));", "document.querySelector('#divergence button').click();"):
        viewer.say("app.setEvent(LAST);")
        if viewer.ask(seen) != [1, 1, False]:
            fail(f"after the last record of the first run {viewer.ask(seen)}")
        viewer.say(way)
        if viewer.ask(seen) != [1, 2, True]:
            fail(f"where the runs part {viewer.ask(seen)}: {viewer.ask('app.u')}, {viewer.ask('app.partedAt')}")
    viewer.say("app.setTime(1);")
    if viewer.ask("[app.k, app.kOther()]") != [1, 3]:
        fail(f"at the end {viewer.ask('[app.k, app.kOther()]')}")


def check_menu(viewer):
    """A certificate of another structure brings this structure into the menu."""
    viewer.look("square", ["uniform-square", "--n", "12", "--seed", "3", "--maintain", "delaunay_2,sorted_list"])
    for index in (1, 0):
        viewer.say(f"app.setStructure({1 - index}); app.setEvent(FIRST.s.indexOf({index}) + 1);")
        viewer.say("document.querySelector('#event .moves button').click();")
        seen = viewer.ask("[app.index, document.getElementById('structure').value]")
        if seen != [index, str(index)]:
            fail(f"a certificate of structure {index} was chosen; shown is {seen[0]}, the menu has {seen[1]}")


def check_lists(viewer):
    """Arrows choose rows of both lists; certificates of a panel are buttons that keep the focus; space opens what can be opened."""
    viewer.say("app.setStructure(0); app.setEvent(3); document.getElementById('show-certificates').click();")
    viewer.say("document.getElementById('certificates').focus();")
    order = viewer.ask("app.certificates.order")
    for key, place in (("ArrowDown", 0), ("ArrowDown", 1), ("ArrowUp", 0), ("ArrowUp", 0), ("End", len(order) - 1), ("Home", 0)):
        press(viewer, key)
        seen = viewer.ask("(() => { const row = document.querySelector('#certificate-rows .now'), box = row && row.parentElement.parentElement;"
                          " return [app.selected, app.k, row !== null && row.offsetTop >= box.scrollTop &&"
                          " row.offsetTop + row.offsetHeight <= box.scrollTop + box.clientHeight,"
                          " document.getElementById('certificates').getAttribute('aria-activedescendant') === (row && row.id)]; })()")
        if seen != [order[place], 3, True, True]:
            fail(f"{key} in the list of certificates: {seen}, not number {place} of {order}")
    press(viewer, "/")
    if viewer.ask("[document.activeElement.id, document.activeElement.offsetParent !== null]") != ["search", True]:
        fail("/ does not lead from the certificates to the filter")
    viewer.say("document.getElementById('list').focus();")
    for key, k in (("ArrowDown", 4), ("ArrowDown", 5), ("ArrowUp", 4)):
        press(viewer, key)
        if viewer.ask("[app.k, document.activeElement.id]") != [k, "list"]:
            fail(f"{key} in the list of log records leads to {viewer.ask('app.k')}, not {k}")
    viewer.say("document.querySelector('summary').focus();")
    press(viewer, " ")
    if viewer.ask("[app.playing, document.querySelector('details').open]") != [False, True]:
        fail("space does not open the keys")
    viewer.say("document.querySelector('details').open = false;")
    check_buttons_in(viewer, "#event .moves")
    viewer.open("overlap.html")
    viewer.say("app.setEvent(2);")
    check_buttons_in(viewer, "#proof .claims")


def check_buttons_in(viewer, where):
    for number, key in ((1, " "), (0, "Enter")):
        viewer.say(f"app.select(null); app.draw(); document.querySelectorAll('{where} button')[{number}].focus();")
        press(viewer, key)
        seen = viewer.ask(f"[app.selected === null, app.playing, [...document.querySelectorAll('{where} button')].indexOf(document.activeElement)]")
        if seen != [False, False, number]:
            fail(f"key {key!r} on button {number} of {where}: {seen}")


FINGERS = """(moves => { const canvas = app.picture.canvas, box = canvas.getBoundingClientRect(); canvas.setPointerCapture = () => {};
  for (const [kind, pointerId, x, y] of moves) canvas.dispatchEvent(new PointerEvent("pointer" + kind,
    { pointerId, clientX: box.left + x, clientY: box.top + y, pointerType: "touch", bubbles: true })); app.draw(); })"""
# What lies at a place of the picture.
UNDER = "((x, y) => [(x - app.plane.cx - app.plane.dx) / app.plane.scale, (y - app.plane.cy - app.plane.dy) / app.plane.scale])"


def check_fingers(viewer):
    """Two fingers zoom, and what is under each stays there; one that stays down goes on to move the picture, without a jump."""
    viewer.open("square.html")
    viewer.say("app.setStructure(0); app.setMode('plane'); app.drawing.fit(); app.draw();")
    under = [viewer.ask(f"{UNDER}(200, 150)"), viewer.ask(f"{UNDER}(300, 200)")]
    viewer.ask(FINGERS + "([['down', 1, 200, 150], ['down', 2, 300, 200], ['move', 2, 420, 280], ['move', 1, 180, 160], ['down', 3, 10, 10],"
               " ['move', 3, 90, 90]])")
    now = [viewer.ask(f"{UNDER}(180, 160)"), viewer.ask(f"{UNDER}(420, 280)")]
    if any(abs(x - y) > 1e-9 for p, q in zip(under, now) for x, y in zip(p, q)):
        fail(f"under two fingers was {under}, is {now}")
    zoom = viewer.ask("app.plane.zoom")
    if abs(zoom - (240**2 + 120**2) ** 0.5 / (100**2 + 50**2) ** 0.5) > 1e-9:
        fail(f"two fingers zoom by {zoom}")
    before = viewer.ask("[app.plane.dx, app.plane.dy, app.selected]")
    viewer.ask(FINGERS + "([['up', 2, 420, 280], ['move', 1, 190, 165], ['up', 3, 90, 90], ['up', 1, 190, 165], ['move', 1, 0, 0]])")
    after = viewer.ask("[app.plane.dx, app.plane.dy, app.selected]")
    if [round(after[0] - before[0], 9), round(after[1] - before[1], 9), after[2]] != [10, 5, before[2]]:
        fail(f"the last finger moved the picture from {before} to {after}")


def check_buttons(viewer):
    """What keys do can be done by buttons."""
    def push(name):
        viewer.say(f"document.getElementById('{name}').click();")

    viewer.say("app.drawing.fit(); app.setEvent(2);")
    push("zoom-in")
    push("zoom-in")
    push("zoom-out")
    if abs(viewer.ask("app.plane.zoom") - 1.25) > 1e-9:
        fail(f"buttons zoom by {viewer.ask('app.plane.zoom')}")
    push("next-failure")
    if viewer.ask("app.selected") is None or viewer.ask("app.selected !== app.proof.next(app.k)[0]"):
        fail(f"the certificate that fails next is not selected, but {viewer.ask('app.selected')}")
    shown = viewer.ask("app.showsAll()")
    push("all-certificates")
    if viewer.ask("[app.showsAll(), document.getElementById('all-certificates').ariaPressed]") != [not shown, str(not shown).lower()]:
        fail("all certificates are not turned on or off")
    if viewer.ask("document.getElementById('next-query').hidden") is not True:
        fail("there is a button for queries where there is none")
    viewer.say("app.setEvent(LAST);")
    if viewer.ask("document.getElementById('next-failure').disabled !== (app.proof.next(app.k) === null)"):
        fail("a button for what fails next where nothing does")


def check_playing(viewer):
    """However often playing begins and ends, one loop runs; a long pause between two frames is no jump; speeds stay speeds."""
    seen = viewer.ask("""(() => { const frames = [], real = window.requestAnimationFrame; let times = 0;
      window.requestAnimationFrame = frame => frames.push(frame);
      const set = app.setTime;
      app.setTime = u => { ++times; set.call(app, u); };
      const round = now => { times = 0; frames.splice(0).forEach(frame => frame(now)); return times; };
      app.setTime(0);
      app.rate = 0.01;
      for (const on of [true, false, true, false, true]) app.play(on);
      const start = performance.now(), counts = [round(start + 20), round(start + 40)], before = app.u;
      round(start + 60000);
      const jump = app.u - before;
      app.play(false);
      counts.push(round(start + 60020));
      delete app.setTime;
      window.requestAnimationFrame = real;
      app.waiting = false;
      app.changed();
      const rates = [];
      for (const factor of [0.5, 2]) { for (let i = 0; i < 3000; ++i) app.setRate(factor); rates.push(app.rate); }
      return [counts, jump, rates, document.getElementById("speed").textContent]; })()""")
    counts, jump, (slow, fast), text = seen
    if counts != [1, 1, 0]:
        fail(f"a frame of playing sets the time {counts} times")
    if not 0 < jump <= 0.25 * 0.01 + 1e-12:
        fail(f"a pause between two frames is a jump by {jump}")
    if not (0 < slow < 1e-3 and 1 < fast < 1e3) or "t/s" not in text:
        fail(f"speeds go from {slow} to {fast}: {text!r}")


def check_addresses(viewer):
    """An address without a structure means the first, without a view the first; what the page does not have is told."""
    def go(text):
        viewer.say(f"location.hash = '{text}';")
        return viewer.ask("(app.draw(), [app.k, DATA.structures[app.index].label, document.getElementById('structure').selectedOptions[0].label,"
                          " (e => e.offsetParent === null ? null : e.textContent)(document.getElementById('asked'))])")

    first, other = "delaunay_2", "sorted_list"
    nowhere = f"There is no structure nothing: this page has {first}, {other}. Shown is {{}}; write structure= and one of these."
    flat = "There is no view 90,0: only pictures of space are turned; leave view= out."
    for text, wanted in ((f"event=3&structure={other}", [3, other, other, None]), ("event=4", [4, first, first, None]),
                         (f"event=4&structure={other}", [4, other, other, None]),
                         ("event=5&structure=nothing", [5, other, other, nowhere.format(other)]), ("event=6", [6, first, first, None]),
                         ("event=6&structure=nothing", [6, first, first, nowhere.format(first)]),
                         ("event=7&view=90,0", [7, first, first, flat])):
        if go(text) != wanted:
            fail(f"the address {text} leads to {go(text)}, not {wanted}")
    viewer.say("app.setStructure(1); app.draw(); app.setStructure(0);")
    if viewer.ask("document.getElementById('asked').hidden") is not True:
        fail("the line stays when another structure was chosen")
    viewer.window.open("about:blank")
    viewer.window.open((viewer.folder / "square.html").as_uri() + "#event=2&structure=nothing")
    viewer.ask(READY)
    if viewer.ask("[app.k, app.index, document.getElementById('asked').textContent]") != [2, 0, nowhere.format(first)]:
        fail(f"opened at a structure that is not there: {viewer.ask('document.getElementById(`asked`).textContent')}")
    viewer.look("space", ["uniform-square", "--dimension", "3", "--n", "6", "--seed", "4", "--maintain", "delaunay_3"])
    turned = "[app.plane.camera.yaw, app.plane.camera.pitch, app.told && app.told.text]"
    start = viewer.ask(turned)
    for text, wanted in (("event=2&view=-40,12.5", [-40, 12.5, None]), ("event=2", start), ("event=1&view=90,0", [90, 0, None]),
                         ("event=1&view=up", [90, 0, "There is no view up: write view= and two numbers of degrees, as in view=90,0."])):
        viewer.say(f"location.hash = '{text}';")
        if viewer.ask(turned) != wanted:
            fail(f"the address {text} leads to {viewer.ask(turned)}, not {wanted}")


def main():
    browser()
    sys.path.insert(0, str(pathlib.Path(sys.argv[2]) / "experiments" / "view"))
    import devtools  # pylint: disable=import-outside-toplevel
    with tempfile.TemporaryDirectory() as name, devtools.Browser(1400, 950) as window:
        viewer = Viewer(sys.argv[1], name, window)
        for check in (check_clicks, check_second, check_menu, check_lists, check_fingers, check_buttons, check_playing, check_addresses):
            check(viewer)
    print("clicks, a second run, menus, lists, fingers, buttons, playing and addresses are as they should be")


if __name__ == "__main__":
    main()
