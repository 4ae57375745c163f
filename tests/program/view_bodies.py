# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens pages of scenes of rigid polygons in Chromium, steps to events and compares what is displayed of
the proofs (tiles, their sides, the features behind these, the certificate that fails next, closest
features, contacts and what follows them) with the event log of `kinex run` and with exact geometry on the scene's own numbers.

usage: view_bodies.py PROGRAM
"""
import sys
import tempfile
from fractions import Fraction

import exact_bodies
from chromium import browser
from view_page import Page, check_page, check_states, fail, time_text, times_after

# Certificates and sides of a tile by its kind.
TILES = {"half-plane": (3, 1), "triangle": (5, 3), "left": (6, 4), "right": (6, 4)}
# Of a pair in contact: the edge ahead, the rays through its ends, the order of normals.
OVERLAP = ["half-plane", "ray", "ray", "normals", "normals"]
ALL = "separation_mixed,separation_hysteresis,closest_features,inner_tangents,bounding_volumes"
SQUARE = [[0, 0], [1, 0], [1, 1], [0, 1]]


def tile_of(proof):
    """The kind of the tile as the state of the proof says; None if it is none."""
    if proof["kind"] != "tile":
        return None
    kind = proof["text"].split(":")[0]
    return kind if kind != "parallelogram" else "left" if " left side " in proof["text"] else "right"


def failures(events, label, pair):
    return [e for e in events if e["structure"] == label and e["certificate"] and e["ids"][:2] == pair]


def check_next(name, state, events, label, shown):
    """The certificate that is displayed as failing next is that of the log's next event."""
    proof, pair = state["proof"]["structures"][label], state["proof"]["pair"]
    later = [e for e in failures(events, label, pair) if e["seq"] > state["event"]]
    own = [e for e in events if e["structure"] == label]
    counts = [sum(e["seq"] <= state["event"] for e in own), len(own)]
    if proof["records"] != counts:
        fail(f"{name}: after record {state['event']} {label} has had {counts}, not {proof['records']}")
    if not later:
        if proof["next"] is not None:
            fail(f"{name}: nothing fails after event {state['event']}, not event {proof['next']}")
        return
    event = later[0]
    if proof["next"] != event["seq"]:
        fail(f"{name}: event {event['seq']} is next in {label}, not {proof['next']}")
    if not proof["claims"]:
        return
    text = "%s(%s)" % (event["certificate"]["predicate"], ", ".join(event["certificate"]["ids"]))
    slot = proof["slot"]
    if slot < 0 or proof["claims"][slot]["certificate"] != text:
        fail(f"{name}: after event {state['event']} {text} fails next in {label}; displayed: {proof}")
    if not shown:
        return
    wanted = [f"Fails next: certificate {slot + 1}, log record {event['seq']}", time_text(event, state["proofText"]),
              event["kind"], proof["text"]]
    for text in wanted:
        if text not in state["proofText"]:
            fail(f"{name}: {text!r} is not in {state['proofText']!r}")
    # In both panels; boxes and discs about bodies are not drawn.
    drawn = proof["claims"][slot]["figure"] not in ("discs", "gap")
    if drawn and min(state["failed"]) < 20:
        fail(f"{name}: what fails next is not marked after event {state['event']}: {state['failed']}")
    rows = state["claims"]
    if [i for i, row in enumerate(rows) if "fails" in row[2]] != [slot]:
        fail(f"{name}: another certificate than {slot} is marked: {rows}")
    for row, claim in zip(rows, proof["claims"], strict=True):
        if claim["features"] not in row[0] or row[1] != claim["certificate"]:
            fail(f"{name}: {row} is not {claim}")


def check_features(name, claim, text, pair):
    """The features behind a certificate, against the numbers in its name."""
    negated = lambda body: [(-x, -y) for x, y in body.polygon]
    polygon = {pair[0].name: pair[0].polygon, pair[1].name: negated(pair[1])}
    if " \u2226 " in text:
        parts = [(part, line, True) for part, line in zip(text.split(" \u2226 "), claim.lines)]
    elif claim.name.endswith("_of_ray"):
        parts = [(part, point, False) for part, point in zip(text.split(" + "), claim.points[2:])]
    else:
        line, point = text.split(" + ")
        parts = [(line, claim.lines[0], True), (point, claim.points[0], False)]
    for part, numbers, is_line in parts:
        body, feature = part.split(".", 1)
        check = exact_bodies.check_line if is_line else exact_bodies.check_point
        problem = check(polygon[body], numbers, feature)
        if problem:
            fail(f"{name}: {claim.name}: {problem}")


def check_overlap(name, state, label, pair, t):
    """The five certificates in contact: their texts, against each other."""
    proof = state["proof"]["structures"][label]
    figures = [entry["figure"] for entry in proof["claims"]]
    if figures != OVERLAP or proof["kind"] != "overlap" or proof["closest"]:
        fail(f"{name}: no proof of an overlap after event {state['event']}: {proof}")
    ahead = proof["claims"][0]["features"]
    if proof["text"] != f"they overlap; ahead is {ahead}":
        fail(f"{name}: ahead is {ahead}, not {proof['text']!r}")
    # The rays go through the ends of the edge ahead.
    edge, vertex = ahead.split(" + ")
    body, number = edge.split(".e")
    ends = [f"{body}.v{(int(number) + i) % len(next(b for b in pair if b.name == body).polygon)}"
            for i in (0, 1)]
    for end, entry in zip(ends, proof["claims"][1:3]):
        if set(entry["features"].split(" + ")) != {end, vertex}:
            fail(f"{name}: {entry} does not go through {end} + {vertex}")
    if not exact_bodies.overlap(*(body.vertices(t) for body in pair)):
        fail(f"{name}: after event {state['event']}, at {t}, they do not overlap")


def check_proof(name, state, label, bodies, t):
    """At a time before the next event: the certificates hold, and are about these features."""
    proof = state["proof"]["structures"][label]
    pair = [bodies[i] for i in state["proof"]["pair"]]
    contact = proof["contact"] is not None
    if contact:
        check_overlap(name, state, label, pair, t)
    checked = 0
    for entry in proof["claims"]:
        claim = exact_bodies.Claim(entry["certificate"])
        value = claim.value(*pair, t)
        if value is None:
            continue
        if value < 0:
            fail(f"{name}: after event {state['event']}, at {t}, {label}: {entry} is negative")
        if contact or label in ("separation_mixed", "closest_features", "inner_tangents"):
            check_features(name, claim, entry["features"], pair)
        checked += 1
    if label == "separation_mixed" and checked and not contact:
        sides = sum(entry["figure"] == "half-plane" for entry in proof["claims"])
        if (len(proof["claims"]), sides) != TILES[tile_of(proof)]:
            fail(f"{name}: {proof['text']} with {len(proof['claims'])} certificates, {sides} sides")
    if proof["closest"]:
        vertices = [body.vertices(t) for body in pair]
        features = [exact_bodies.feature_points(v, f.split(".", 1)[1])
                    for v, f in zip(vertices, proof["closest"])]
        if exact_bodies.squared_distance(*features) != exact_bodies.closest(*vertices):
            fail(f"{name}: after event {state['event']} {proof['closest']} are not the closest")
    return checked


def check_contact(name, state, events, label):
    pair = state["proof"]["pair"]
    done = [e for e in events if e["structure"] == label and e["kind"] == "contact"
            and e["ids"][:2] == pair and e["seq"] <= state["event"]]
    shown = state["proof"]["structures"][label]["contact"]
    if pair not in state["structures"][label]:
        if shown is not None:
            fail(f"{name}: {label} shows a contact that is none: {shown}")
        return 0
    if shown is None or shown["event"] != done[-1]["seq"] or shown["features"] != done[-1]["ids"][2:]:
        fail(f"{name}: the contact of {label} is {done[-1]}, not {shown}")
    return 1


def meeting(page, name, turning, maintain):
    """Two unit squares that meet, part and meet again."""
    rotor = {"rotor": [[1], [0, "1/3"]]} if turning else {}
    scene = {"kinex": 1, "name": name, "dimension": 2, "time": {"start": 0, "end": 6},
             "objects": [{"id": "a", "polygon": SQUARE, "motion": [[0], [0]]},
                         {"id": "b", "polygon": SQUARE, "motion": [[6, -6, 1], ["1/3"]], **rotor}],
             "maintain": maintain.split(",")}
    (page.folder / f"{name}.json").write_text(exact_bodies.json.dumps(scene), encoding="utf-8")


def one_scene(page, name, generate, maintain, steps=24, second=None):
    if callable(generate):
        generate(page, name, maintain)
    else:
        page.kinex("gen", *generate, "--maintain", maintain, "-o", f"{name}.json")
    events, _ = page.run(name)
    last = len(events)
    ks = sorted({round(i * last / steps) for i in range(steps + 1)} | {0, 1, 2, last})
    end = page.end(name)
    times = {k: times_after(events, k, end) for k in ks}
    times = {k: t for k, t in times.items() if t is not None}
    _, sampled = page.run(name, times=sorted(times.values()))
    samples = {k: sampled[sorted(times.values()).index(t)] for k, t in times.items()}
    page.kinex("view", f"{name}.exact.jsonl", "--scene", f"{name}.json", "-o", f"{name}.html",
               *(["--with", second] if second else []))
    answer = page.ask(name, last // 2, ks[::2] + ks[1::2][::-1])
    check_page(name, answer, events, last // 2)
    check_states(name, answer, events, samples)
    bodies = exact_bodies.bodies_of(page.folder / f"{name}.json")
    found = {"claims": 0, "contacts": 0, "overlaps": 0, "tiles": set()}
    for state in answer["states"]:
        # When all repairs of an instant are done.
        if state["event"] in times and state["within"] < -1e-9:
            fail(f"{name}: after event {state['event']} the point is {-state['within']} out of its tile")
        for i, label in enumerate(maintain.split(",")):
            contact = check_contact(name, state, events, label)
            found["contacts"] += contact
            check_next(name, state, events, label, i == 0)
            if contact and i == 0:
                shown = state["proof"]["structures"][label]["contact"]
                for text in ("contact: " + " meets ".join(shown["features"]),
                             f"since log record {shown['event']}, t"):
                    if text not in state["proofText"]:
                        fail(f"{name}: no {text!r} in {state['proofText']!r}")
            if state["event"] in times:
                checked = check_proof(name, state, label, bodies, times[state["event"]])
                found["claims"] += checked
                found["overlaps"] += contact and checked > 0
        mixed = state["proof"]["structures"].get("separation_mixed")
        if mixed and tile_of(mixed):
            found["tiles"].add(tile_of(mixed))
    return answer, events, found


class BodyPage(Page):
    def end(self, name):
        scene = exact_bodies.json.loads((self.folder / f"{name}.json").read_text(encoding="utf-8"))
        return Fraction(str(scene["time"]["end"]))


def main():
    chromium = browser()
    with tempfile.TemporaryDirectory() as folder:
        page = BodyPage(chromium, sys.argv[1], folder)
        both = "separation_mixed,closest_features"
        answer, events, fan = one_scene(page, "fan", ["polygon-fan", "--n", "6", "--m", "6"], both)
        counts = [answer["states"][0]["proof"]["structures"][s]["records"][1] for s in both.split(",")]
        if not counts[0] * 10 < counts[1]:
            fail(f"fan: {counts} events")
        _, _, orbit = one_scene(
            page, "orbit", ["polygon-spin-orbit", "--n", "7", "--m", "5", "--separation", "1/50"], both)
        if orbit["tiles"] != set(TILES):
            fail(f"orbit: only the tiles {orbit['tiles']} were seen")
        _, _, random = one_scene(page, "random", ["polygon-random", "--n", "9", "--m", "8", "--seed",
                                                  "3"], both, second="double")
        if random["contacts"] == 0:
            fail("random: no contact was seen")
        # Flight plans that change, and every structure.
        _, _, approach = one_scene(
            page, "approach", ["polygon-approach", "--n", "8"],
            "inner_tangents,separation_hysteresis,bounding_volumes,separation_minkowski,"
            "separation_mixed")
        _, _, box = one_scene(page, "box", ["polygons-in-box", "--n", "6", "--m", "4"],
                              both + ",bounding_volumes")
        # They meet, part and meet again.
        _, _, turning = one_scene(page, "turning", lambda *to: meeting(*to[:2], True, to[2]), ALL,
                                  steps=48)
        _, _, level = one_scene(page, "level", lambda *to: meeting(*to[:2], False, to[2]),
                                "separation_minkowski," + ALL, steps=48)
        for name, scene in (("turning", turning), ("level", level)):
            if scene["overlaps"] < 15:
                fail(f"{name}: only {scene['overlaps']} proofs of overlaps were seen")
        claims = sum(x["claims"] for x in (fan, orbit, random, approach, box, turning, level))
    if claims < 400:
        fail(f"only {claims} certificates were evaluated")
    print(f"{claims} displayed certificates hold, and are about the features that are displayed")


if __name__ == "__main__":
    main()
