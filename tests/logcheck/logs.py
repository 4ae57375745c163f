# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes, logs and seals for the tests of kinex-logcheck."""
import hashlib
import json
import pathlib
import random
import subprocess
import sys
import tempfile

LINE = ["sorted_list", "maximum_sorted_list", "minimum_sorted_list", "maximum_heap", "minimum_heap",
        "maximum_hanger", "minimum_hanger", "maximum_tournament", "minimum_tournament", "maximum_envelope",
        "minimum_envelope", "maximum_dual_hull", "minimum_dual_hull"]
PLANE = ["convex_hull_2", "convex_hull_2_naive", "convex_hull_2_brute_force", "convex_hull_2_delaunay",
         "delaunay_2", "bounding_box", "closest_pair_delaunay", "emst_list", "emst_cycles",
         "diameter_2", "diameter_all_pairs",
         "bounding_box_2_hull", "farthest_delaunay_2",
         "min_circle_2", "min_circle_2_brute_force",
         "closest_pair_all", "closest_pair_range_tree", "closest_pair_cones", "closest_pair_local", "closest_pair_bins",
         "octants_listed", "octants_local",
         "bichromatic_pair_delaunay", "bichromatic_pair_all", "nearest_site", "voronoi_cell_2",
         "mst_maximum_norm_list", "mst_maximum_norm_cycles"]
GRAPHS = ["graph_mst_list", "graph_mst_cycles"]
EXTENTS = ["box_pairs", "disc_pairs_all", "disc_pairs_boxes", "disc_pairs_grid"]  # points become boxes or discs
LINES = ["incidences_all"]  # every second point becomes a line
SPACE = ["delaunay_3", "closest_pair_delaunay", "emst_list", "emst_cycles"]  # in scenes of three axes
BODIES = ["separation_mixed", "separation_minkowski", "separation_hysteresis", "closest_features",
          "inner_tangents", "bounding_volumes"]
POINT_FAMILIES = ["uniform-square", "uniform-disk", "gaussian", "grid", "lattice", "meet", "through-one-point",
                  "near-one-point", "collinear-instant", "counter-rotating-rings", "expanding-circle",
                  "rotating-circle", "static-one-mover", "new-plans", "come-and-go"]
BODY_FAMILIES = ["polygon-orbit", "polygon-line", "polygon-fan", "polygon-jitter", "polygon-kinks",
                 "polygon-random", "polygons-in-box"]
KEYS = ["x", "y", {"direction": [3, "-1/2"]}, {"squared_distance_to": "p0"}]


def checker(folder):
    """The modules of the program."""
    sys.path.insert(0, folder)
    sys.set_int_max_str_digits(0)
    import checker as program
    import log
    import scene

    return program, log, scene


def generate(program, folder, family, n, seed, maintain, *more):
    """A scene file; None if the family does not suit what is maintained."""
    path = pathlib.Path(folder) / "scene.json"
    path.unlink(missing_ok=True)
    done = subprocess.run([program, "gen", family, "--n", str(n), "--seed", str(seed), "--maintain",
                           json.dumps(maintain) if isinstance(maintain, dict) else maintain, *more, "-o", str(path)],
                          capture_output=True, text=True)
    return path if done.returncode == 0 else None


def run(program, folder, scene, *more):
    """The log of a run, as bytes; None if the scene is refused."""
    path = pathlib.Path(folder) / "run.jsonl"
    path.unlink(missing_ok=True)
    done = subprocess.run([program, "run", str(scene), "--events", str(path), *more], capture_output=True, text=True)
    if done.returncode == 2 or not path.exists():
        return None
    if done.returncode != 0:
        sys.exit(f"kinex run: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return path.read_bytes()


def skip_old(program):
    """Exit code 77 if the program's logs are not of version 2."""
    with tempfile.TemporaryDirectory() as folder:
        data = run(program, folder, generate(program, folder, "uniform-square", 3, 1, "sorted_list"))
    if json.loads(data.split(b"\n")[0])["version"] != 2:
        print("skipped: this program writes logs of version 1")
        sys.exit(77)


def check(modules, data, scene_path, levels=range(6)):
    """(verdict, message, checker) of a log."""
    program, log, scene = modules
    try:
        read = log.Log("log", data)
        done = program.Checker(read, scene.Scene(str(scene_path), scene_path.read_text()), set(levels))
        done.run()
        return "fine", None, done
    except log.Wrong as error:
        return "wrong", f"line {error.line}: {error}", None
    except scene.BadInput as error:
        return "bad input", str(error), None


# ---- digest and seal, once more


def string(text):
    out = ""
    for c in text:
        out += "\\" + c if c in '"\\' else f"\\u{ord(c):04x}" if c < " " or c == "\x7f" else c
    return f'"{out}"'


def digest(header, records):
    def array(items):
        return "[" + ",".join(items) + "]"

    rows = [array([string(s["label"]), string(s["structure"]), array(string(k) for k in s["kinds"])])
            for s in header["structures"]]
    data = f"kinex-digest 2\n{array(rows)}\n{array(string(o) for o in header['objects'])}\n".encode()
    labels = {s["label"]: i for i, s in enumerate(header["structures"])}
    objects = {o: i for i, o in enumerate(header["objects"])}

    def ids(names):
        result = b""
        for name in names:
            if name in objects:
                result += objects[name].to_bytes(4, "little")
            else:
                text = name.encode()
                result += b"\xff\xff\xff\xff" + len(text).to_bytes(4, "little") + text
        return result

    for r in records:
        index = labels[r["structure"]]
        changed = "gone" in r
        data += bytes([index, header["structures"][index]["kinds"].index(r["kind"]),
                       r["external"] + 2 * changed, len(r["ids"])]) + ids(r["ids"])
        for side in ("gone", "came") if changed else ():
            flat = [i for pair in r[side] for i in (pair if isinstance(pair, list) else [pair])]
            data += len(flat).to_bytes(4, "little") + ids(flat)
    return hashlib.sha256(data).hexdigest()


def sealed(header, records, last):
    """The bytes of a log with these contents, counted, digested and sealed as if they were true."""
    for i, r in enumerate(records):
        r["seq"] = i + 1
    last = {key: value for key, value in last.items() if key != "seal"}
    last.update(records=len(records), external=sum(r["external"] for r in records), digest=digest(header, records))
    body = "".join(json.dumps(line, ensure_ascii=False) + "\n" for line in [header, *records])
    text = json.dumps(last, ensure_ascii=False)[:-1] + ', "seal": "'
    return (body + text + hashlib.sha256((body + text).encode()).hexdigest() + '"}\n').encode()


def parsed(data):
    lines = [json.loads(line) for line in data.decode().splitlines()]
    return lines[0], lines[1:-1], lines[-1]


def drawn_scene(rng, program, folder, structure):
    """A random small scene for a structure."""
    while True:
        seed = rng.randrange(1, 10**6)
        if structure in BODIES:
            family = rng.choice(BODY_FAMILIES)
            n = 3 if family == "polygons-in-box" else rng.randrange(3, 6)
            path = generate(program, folder, family, n, seed, structure, "--m", str(rng.randrange(3, 6)))
        else:
            maintain = structure
            if structure in LINE:
                keys = KEYS[:3] if structure.endswith("dual_hull") else KEYS
                maintain = {"structure": structure, "key": rng.choice(keys), "as": "it"}
            family = rng.choice(POINT_FAMILIES)
            path = generate(program, folder, family, rng.randrange(5, 10), seed, maintain)
        if path is not None:
            return path, f"{family}, seed {seed}"


__all__ = ["random"]
