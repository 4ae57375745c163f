# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens the page of `kinex view` in Chromium, steps to events and compares what is displayed.

usage: view_page.py PROGRAM
The witness is `kinex run`: its event log, replayed here, and its samples at times between events. It
shares nothing with the page but the scene. Exit code 77 (skipped) where there is no Chromium.
"""
import fractions
import html
import json
import pathlib
import re
import subprocess
import sys
import tempfile

from chromium import browser, dump

# Without a screen there are no frames to wait for.
FRAMES = """<script>
window.requestAnimationFrame = draw => setTimeout(() => draw(performance.now()), 16);
</script>"""
# Runs in the page when it is loaded; the answer becomes the text of one element.
PROBE = """
<pre id="probe"></pre><script>
const errors = [];
addEventListener("error", e => errors.push(String(e.message)));
const press = (key, shift) => dispatchEvent(
  Object.assign(new KeyboardEvent("keydown", {{ key, shiftKey: !!shift, bubbles: true }})));
const settle = () => new Promise(done => setTimeout(done, 50));
const ink = id => {{
  const canvas = document.getElementById(id);
  const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
  const colours = new Set();
  let count = 0;
  for (let i = 0; i < pixels.length; i += 4) {{
    if (pixels[i + 3] < 200) continue;
    ++count;
    colours.add((pixels[i] << 16) + (pixels[i + 1] << 8) + pixels[i + 2]);
  }}
  return [count, colours.size];
}};
// Pixels in the colour of what fails, left and right of where configuration space begins.
const marked = () => {{
  const canvas = document.getElementById("picture");
  const colour = [1, 3, 5].map(i => parseInt(COLOUR.failed.slice(i, i + 2), 16));
  const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
  const border = app.drawing.chart.frame.rectangle[0] * canvas.width / canvas.clientWidth;
  const counts = [0, 0];
  for (let i = 0; i < pixels.length; i += 4) {{
    if (colour.every((c, j) => pixels[i + j] === c)) ++counts[(i / 4) % canvas.width < border ? 0 : 1];
  }}
  return counts;
}};
// Those that what fails next has of its own.
const failing = () => {{
  const proofs = app.proofs[app.shown()], all = marked();
  proofs.failingSlot = () => -1;
  app.drawCanvases();
  const others = marked();
  delete proofs.failingSlot;
  app.drawCanvases();
  return all.map((count, i) => count - others[i]);
}};
// How far inside of the half-planes that are drawn the point is, of all structures: 0 or less.
const within = () => {{
  const pair = app.pair(), poses = pairOf(pair).map(body => poseOf(body, app.u));
  if (poses.includes(null)) return 0;
  const pose = relative(...poses);
  return Math.min(0, ...app.drawing.chart.cells(pair, pose).flat().map(
    ({{ half: {{ n, offset }} }}) => (n[0] * pose.x + n[1] * pose.y - offset) / Math.hypot(...n)));
}};
async function answer() {{
  await settle();
  const result = {{ opened: kinexState().event, states: [] }};
  for (const k of {events}) {{
    const box = document.getElementById("number");
    box.value = k;
    box.dispatchEvent(new Event("change"));
    await settle();
    const state = kinexState();
    state.shown = document.body.dataset.event;
    const words = id => document.getElementById(id).innerText;
    state.text = words("event") + [...document.querySelectorAll("#event [title]")]
      .map(e => "\\n" + e.title).join("");
    state.proofText = words("proof");
    if (BODIES) Object.assign(state, {{ failed: failing(), within: within() }});
    state.claims = [...document.querySelectorAll("#proof li")].map(
      e => [e.innerText, e.title, e.className]);
    state.row = document.querySelector(".row.now").dataset.event;
    state.ink = [ink("picture"), ink("window"), ink("overview")];
    result.states.push(state);
  }}
  const keys = {{}};
  press("Home"); keys.home = kinexState().event;
  press("ArrowRight"); keys.right = kinexState().event;
  press("ArrowRight"); press("ArrowLeft"); keys.left = kinexState().event;
  press("End"); keys.end = kinexState().event;
  press("ArrowLeft", true); keys.external = kinexState().event;
  press("Home"); press("]"); press("]"); press("]"); press("]");
  press(" "); await settle(); keys.playing = document.getElementById("play").textContent;
  await new Promise(done => setTimeout(done, 700));
  press(" "); await settle(); keys.played = kinexState().event;
  keys.paused = document.getElementById("play").textContent;
  press("d"); keys.parted = kinexState().event;
  document.querySelectorAll("#structure option").forEach(o => {{
    const select = document.getElementById("structure");
    select.value = o.value;
    select.dispatchEvent(new Event("change"));
    for (const mode of ["plane", "time"]) {{
      const drawing = document.getElementById("drawing");
      if ([...drawing.options].find(d => d.value === mode).disabled) continue;
      drawing.value = mode;
      drawing.dispatchEvent(new Event("change"));
      app.draw();
    }}
  }});
  await settle();
  result.keys = keys;
  result.errors = errors;
  result.width = [document.documentElement.scrollWidth, innerWidth];
  result.resources = performance.getEntriesByType("resource").map(e => e.name.slice(0, 40));
  result.unnamed = [...document.querySelectorAll("button, input, select, canvas")].filter(
    e => !(e.getAttribute("aria-label") || e.labels && e.labels.length || e.title || e.tagName === "BUTTON" && e.innerText)).length;
  return result;
}}
addEventListener("load", () => answer().catch(e => ({{ thrown: String(e.stack) }})).then(result => {{
  document.getElementById("probe").textContent = JSON.stringify(result);
}}));
</script>"""


def time_text(event, text):
    """How a text has an event's time: a short fraction that the decimal is cut from, or the decimal."""
    decimal = event["time"]["decimal"]
    for shown, fraction in re.findall(r"(t = (-?\d+(?:/\d+)?))", text):
        if abs(fractions.Fraction(fraction) - fractions.Fraction(decimal)) <= abs(fractions.Fraction(decimal)) / 10**11:
            return shown
    return decimal


def fail(text):
    sys.exit(f"view_page: {text}")


class Page:
    def __init__(self, chromium, program, folder):
        self.chromium, self.program, self.folder = chromium, program, pathlib.Path(folder)

    def kinex(self, *arguments, allowed=(0,)):
        done = subprocess.run([self.program, *arguments], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, cwd=self.folder, check=False)
        if done.returncode not in allowed:
            fail(f"kinex {' '.join(arguments)}: exit code {done.returncode}: {done.stderr}")
        return done

    def ask(self, name, opened, events):
        """What the page, opened after one event, displays after each of the others."""
        text = (self.folder / f"{name}.html").read_text(encoding="utf-8")
        probe = PROBE.format(events=json.dumps(events))
        # The page's own rules forbid what is not its own; the probe is inline, as its scripts are.
        path = self.folder / f"{name}.probe.html"
        text = text.replace("<body>", "<body>" + FRAMES).replace("</body>", probe + "</body>")
        path.write_text(text, encoding="utf-8")
        document = dump(self.chromium, f"{path.as_uri()}#event={opened}",
                        ["--window-size=1400,900", "--virtual-time-budget=20000"])
        answer = re.search(r'<pre id="probe">(.*?)</pre>', document, re.S).group(1)
        answer = json.loads(html.unescape(answer))
        if "thrown" in answer:
            fail(f"{name}: {answer['thrown']}")
        return answer

    def run(self, name, arithmetic="exact", times=()):
        """The event log and the samples of a run that knows nothing of pages."""
        log = self.folder / f"{name}.{arithmetic}.jsonl"
        summary = self.folder / f"{name}.{arithmetic}.summary.json"
        self.kinex("run", f"{name}.json", "--arithmetic", arithmetic, "--events", log.name,
                   "--summary", summary.name, "--audit", "none", "--force",
                   *(["--at", ",".join(map(str, times))] if times else []),
                   allowed=(0,) if arithmetic == "exact" else (0, 1))  # 1: it was led astray
        lines = [json.loads(line) for line in log.read_text(encoding="utf-8").splitlines()]
        return lines[1:-1], json.loads(summary.read_text(encoding="utf-8"))["samples"]


def same_value(displayed, sampled, shape):
    if shape == "tuples":
        return {tuple(e) for e in displayed} == {tuple(e) for e in sampled}
    return displayed == sampled


def times_after(events, k, end):
    """A rational time after event k and before event k + 1, or None if they are too close."""
    at = [fractions.Fraction(e["time"]["decimal"]) for e in events]
    low = at[k - 1] if k > 0 else fractions.Fraction(0)
    high = at[k] if k < len(at) else end
    if high - low < fractions.Fraction(1, 10**12):
        return None
    middle = (low + high) / 2
    return fractions.Fraction(round(middle * 10**16), 10**16)


def check_states(name, answer, events, samples):
    """Displayed states against samples taken right before the event that follows."""
    compared = 0
    for state in answer["states"]:
        k = state["event"]
        if state["shown"] != str(k) or state["row"] != str(k):
            fail(f"{name}: event {k} is shown as {state['shown']}, row {state['row']}")
        for count, colours in state["ink"]:
            if count < 50 or colours < 2:
                fail(f"{name}: an empty picture after event {k}: {state['ink']}")
        if k > 0:
            event = events[k - 1]
            wanted = [f"Log record {k} of {len(events)}", event["kind"],
                      "external" if event["external"] else "internal", time_text(event, state["text"])]
            if event["certificate"]:
                wanted.append("%s(%s)" % (event["certificate"]["predicate"],
                                          ", ".join(event["certificate"]["ids"])))
            for text in wanted:
                if text not in state["text"]:
                    fail(f"{name}: {text!r} is not in {state['text']!r}")
        if k not in samples:
            continue
        for label, value in state["structures"].items():
            shape = "tuples" if value and isinstance(value, list) and isinstance(value[0], list) \
                else "other"
            if not same_value(value, samples[k][label], shape):
                fail(f"{name}: after event {k} {label} is {samples[k][label]}, not {value}")
            compared += 1
    return compared


def check_swaps(name, answer, events, label, first):
    """The order as the log leads to it, swap by swap, from the first displayed order on."""
    for state in answer["states"]:
        order = list(first)
        for event in events[: state["event"]]:
            if event["structure"] != label:
                continue
            a, b = (order.index(i) for i in event["ids"])
            if b != a + 1:
                fail(f"{name}: no swap of neighbours: {event}")
            order[a], order[b] = order[b], order[a]
        if state["structures"][label] != order:
            fail(f"{name}: after event {state['event']} the log gives {order}")


def check_page(name, answer, events, opened):
    if answer["errors"]:
        fail(f"{name}: {answer['errors']}")
    if answer["opened"] != opened:
        fail(f"{name}: opened after event {answer['opened']}, not {opened}")
    if any(not r.startswith("data:") for r in answer["resources"]):
        fail(f"{name}: it loads {answer['resources']}")
    if answer["width"][0] > answer["width"][1]:
        fail(f"{name}: the page is wider than the window: {answer['width']}")
    if answer["unnamed"]:
        fail(f"{name}: {answer['unnamed']} controls without a name")
    keys, last = answer["keys"], len(events)
    if (keys["home"], keys["right"], keys["left"], keys["end"]) != (0, 1, 1, last):
        fail(f"{name}: keys lead to {keys}")
    if "Pause" not in keys["playing"] or "Play" not in keys["paused"] or keys["played"] == 0:
        fail(f"{name}: it does not play: {keys}")


def one_scene(page, name, generate, label=None, second=None):
    page.kinex("gen", *generate, "-o", f"{name}.json")
    events, _ = page.run(name)
    steps = sorted({0, 1, 2, 3, len(events) // 3, len(events) // 2, len(events) - 1, len(events)})
    order = steps[::2] + steps[1::2][::-1]  # forward, then back
    times = {k: times_after(events, k, fractions.Fraction(1)) for k in steps}
    times = {k: t for k, t in times.items() if t is not None}
    _, sampled = page.run(name, times=sorted(times.values()))
    samples = {k: sampled[sorted(times.values()).index(t)] for k, t in times.items()}
    view = [f"{name}.json", "-o", f"{name}.html"]
    if second:
        page.run(name, second)
        view = [f"{name}.exact.jsonl", "--scene", f"{name}.json", "--with",
                f"{name}.{second}.jsonl", "-o", f"{name}.html"]
    page.kinex("view", *view)
    opened = len(events) // 2
    answer = page.ask(name, opened, order)
    check_page(name, answer, events, opened)
    compared = check_states(name, answer, events, samples)
    if label:
        first = next(s for s in answer["states"] if s["event"] == 0)["structures"][label]
        check_swaps(name, answer, events, label, first)
    return answer, events, compared


def check_second(page, name, answer, events, second, parted):
    """Which of its events the second run is shown after, and the state there."""
    others, _ = page.run(name, second)
    at = [fractions.Fraction(e["time"]["decimal"]) for e in others]
    until = lambda t: sum(1 for other in at if other <= t)
    near = fractions.Fraction(1, 10**12)
    wanted = {}
    for state in answer["states"]:
        k, j = state["event"], state["other"]["event"]
        if k < parted:
            if j != k:
                fail(f"{name}: before they part {second} is at event {j}, not {k}")
            continue
        t = fractions.Fraction(events[k - 1]["time"]["decimal"])
        low, high = max(until(t - near), parted - 1), max(until(t + near), parted - 1)
        if not low <= j <= high:
            fail(f"{name}: at event {k} {second} is at event {j}, not {low} to {high}")
        later = times_after(events, k, fractions.Fraction(1))
        if j == high and later is not None and until(later) == j:
            wanted[later] = state
    _, samples = page.run(name, second, sorted(wanted))
    for t, sample in zip(sorted(wanted), samples):
        for label, value in wanted[t]["other"]["structures"].items():
            shape = "tuples" if value and isinstance(value[0], list) else "other"
            if (value is None) != (sample[label] is None) or (
                    value is not None and not same_value(value, sample[label], shape)):
                fail(f"{name}: {second} has {sample[label]} at {t}, not {value}")
    if not wanted:
        fail(f"{name}: no state of {second} was compared")


def check_parted(page, name, answer, events, second):
    others, _ = page.run(name, second)
    key = lambda e: (e["structure"], e["kind"], e["ids"])
    parted = next(i + 1 for i, (a, b) in enumerate(zip(events, others)) if key(a) != key(b))
    state = answer["states"][0]
    if state["diverges"] != parted or answer["keys"]["parted"] != parted:
        fail(f"{name}: the runs part at event {parted}, not {state['diverges']}")
    for state in answer["states"]:
        if state["event"] < parted and state["other"]["structures"] != state["structures"]:
            fail(f"{name}: the second run differs before event {parted}")
    if all(s["other"]["structures"] == s["structures"] for s in answer["states"]):
        fail(f"{name}: the second run is never seen in another state")
    check_second(page, name, answer, events, second, parted)


def main():
    chromium = browser()
    with tempfile.TemporaryDirectory() as folder:
        page = Page(chromium, sys.argv[1], folder)
        total = 0
        _, events, compared = one_scene(
            page, "line", ["uniform-square", "--n", "14", "--dimension", "1", "--degree", "2",
                           "--seed", "2", "--maintain", "sorted_list,maximum_tournament"],
            label="sorted_list")
        total += compared
        _, events, compared = one_scene(
            page, "square", ["uniform-square", "--n", "30", "--seed", "3", "--maintain",
                             "delaunay_2,maximum_heap,sorted_list"], label="sorted_list")
        total += compared
        answer, events, compared = one_scene(
            page, "near", ["near-one-point", "--n", "9", "--dimension", "1", "--maintain",
                           "sorted_list"], second="double", label="sorted_list")
        check_parted(page, "near", answer, events, "double")
        total += compared
        answer, events, compared = one_scene(
            page, "grid", ["grid", "--n", "36", "--maintain", "delaunay_2"], second="double")
        check_parted(page, "grid", answer, events, "double")
        total += compared
        for name, generate, structures in (
                ("hull", ["uniform-square", "--n", "40", "--seed", "3"],
                 "convex_hull_2,convex_hull_2_brute_force"),
                ("hull-plans", ["new-plans", "--n", "12", "--m", "12"], "convex_hull_2"),
                ("envelope", ["uniform-square", "--n", "40", "--seed", "3", "--dimension", "1"],
                 "maximum_envelope,maximum_dual_hull,minimum_hanger")):
            _, events, compared = one_scene(page, name, [*generate, "--maintain", structures])
            total += compared
    if total < 30:
        fail(f"only {total} states were compared")
    print(f"{total} displayed states are those of kinex run")


if __name__ == "__main__":
    main()
