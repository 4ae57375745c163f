# SPDX-License-Identifier: GPL-3.0-or-later
"""A structure that kinex-logcheck has no replay for: it says so, checks what it can, and finds no fault.

usage: unknown.py PROGRAM LOGCHECK_FOLDER

The structure is one that the checker knows, under another name in
the scene and in the log, which is counted, digested and sealed anew. Also: scenes with "over" and with parameters have
the hash that the program gives them.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import logs

NAME = "nothing_known_2"
# What is maintained, a family of scenes, and further options of `kinex gen`.
CASES = [("bounding_box", "uniform-square", []), ("closest_pair_all", "meet", []), ("delaunay_2", "lattice", []),
         ("convex_hull_2_brute_force", "gaussian", []), ("separation_mixed", "polygons-in-box", ["--m", "4"]),
         ({"structure": "directions_2", "k": 5}, "uniform-square", []),
         ({"structure": "calipers_2", "folds": 4}, "uniform-square", [])]
HASHED = [{"structure": "pseudo_kd_tree_2", "delta": "1/3"}, {"structure": "pseudo_kd_tree_2", "delta": "1/4"},
          {"structure": "diameter_2", "over": "convex_hull_2_delaunay"},
          {"structure": "diameter_2", "over": "convex_hull_2"},
          {"structure": "diameter_2", "over": {"structure": "directions_2", "k": 8}},
          {"structure": "min_circle_2", "over": {"structure": "directions_2", "k": 4}, "of": ["p1", "p3", "p4"]}]


def fail(text):
    sys.exit(f"unknown: {text}")


def renamed(modules, data, scene_path, name, predicate):
    """The log and its scene with another name for the structure, and for its certificates if `predicate`."""
    header, *records, last = [json.loads(line) for line in data.decode().splitlines()]
    tree = json.loads(scene_path.read_text())
    entry = tree["maintain"][0]
    tree["maintain"] = [{**entry, "structure": NAME} if isinstance(entry, dict) else NAME]
    for s in header["structures"]:
        s["label"] = NAME if s["label"] == name else s["label"]
        s["structure"] = NAME if s["structure"] == name else s["structure"]
    for r in records:
        r["structure"] = NAME if r["structure"] == name else r["structure"]
        if predicate and r["structure"] == NAME and r["certificate"]:
            r["certificate"]["predicate"] = "no_such_claim"
    path = scene_path.with_name("renamed.json")
    path.write_text(json.dumps(tree))
    header["scene_hash"] = modules[2].Scene(str(path), path.read_text()).hash
    return logs.sealed(header, records, last), path


def check_renamed(program, folder, modules, scratch, case):
    maintain, family, more = case
    name = maintain["structure"] if isinstance(maintain, dict) else maintain
    scene = logs.generate(program, scratch, family, 6, 3, maintain, *more)
    data = logs.run(program, scratch, scene)
    for predicate in (False, True):
        changed, path = renamed(modules, data, scene, name, predicate)
        verdict, message, done = logs.check(modules, changed, path, range(6))
        if verdict != "fine":
            fail(f"{name} under another name: {verdict}: {message}")
        bodies = family.startswith("polygon")
        if not bodies and done.missing != [NAME]:
            fail(f"{name} under another name is followed: {done.missing}")
        if not bodies and predicate and "no formula is known" not in done.partly[NAME]:
            fail(f"{name}: nothing is said of certificates that are not known")
        log = pathlib.Path(scratch) / "renamed.jsonl"
        log.write_bytes(changed)
        said = subprocess.run([sys.executable, folder, str(log), "--scene", str(path)], capture_output=True, text=True,
                              check=False)
        if said.returncode != 0 or (not bodies and f"structure {NAME} has no replay" not in said.stdout):
            fail(f"{name}: {said}")
    # What is wrong is still seen, where it can be: an event that is missing in its count, another instant.
    broken = data.replace(b'"root":1', b'"root":2').replace(b'"root": 1', b'"root": 2')
    if broken == data or logs.check(modules, broken, scene)[0] == "fine":
        fail(f"{name}: a changed log is accepted")


def main():
    program, folder = sys.argv[1:3]
    modules = logs.checker(folder)
    logs.require_version(program)
    with tempfile.TemporaryDirectory() as scratch:
        for case in CASES:
            check_renamed(program, folder, modules, scratch, case)
        for maintain in HASHED:
            scene = logs.generate(program, scratch, "uniform-square", 7, 2, maintain)
            tree = json.loads(scene.read_text())
            tree["maintain"] = [maintain]  # as it is written, defaults and all
            scene.write_text(json.dumps(tree))
            verdict, message, _ = logs.check(modules, logs.run(program, scratch, scene), scene, range(4))
            if verdict != "fine":
                fail(f"{json.dumps(maintain)}: {verdict}: {message}")
    print(f"{len(CASES)} structures under another name, {len(HASHED)} scenes with members of structures: nothing wrong")


main()
