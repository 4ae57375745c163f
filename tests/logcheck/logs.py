# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes, logs and seals for the tests of kinex-logcheck."""
import hashlib
import json
import pathlib
import random
import subprocess
import sys
import tempfile

POINT_FAMILIES = ["uniform-square", "uniform-disk", "gaussian", "grid", "lattice", "meet", "through-one-point",
                  "near-one-point", "collinear-instant", "counter-rotating-rings", "expanding-circle",
                  "rotating-circle", "static-one-mover", "new-plans", "come-and-go"]
BODY_FAMILIES = ["polygon-orbit", "polygon-line", "polygon-fan", "polygon-jitter", "polygon-kinks",
                 "polygon-random", "polygons-in-box"]
KEYS = ["x", "y", {"direction": [3, "-1/2"]}, {"squared_distance_to": "p0"}]
# A point that passes another one, on a line.
SCENE = {"kinex": 1, "name": "two", "dimension": 1, "time": {"start": 0, "end": 2},
         "objects": [{"id": "a", "motion": [[0, 1]]}, {"id": "b", "motion": [[1]]}], "maintain": ["sorted_list"]}


class Structures:
    """The names of all structures that follow motion, by the scenes in which they are tried."""

    def __init__(self, program):
        said = subprocess.run([program, "list", "structures", "--json"], capture_output=True, text=True, check=True)
        infos = [info for info in json.loads(said.stdout) if info["follows_motion"]]

        def names(fits):
            return [info["name"] for info in infos if fits(info)]

        points = [info for info in infos if info["objects"] == "points"]
        self.line = [info["name"] for info in points if "key" in info["takes"]]
        self.linear = names(lambda info: info.get("largest_degree") == 1)
        self.plane = [info["name"] for info in points if info["name"] not in self.line
                      and (info["axes"] == 2 or (info["axes"] == 1 and info["more_axes"]))]
        self.space = [info["name"] for info in points if info["axes"] == 3
                      or ("delaunay_2" in info["reads"] and info["more_axes"])]
        self.graphs = names(lambda info: info["objects"] == "edges")
        self.extents = names(lambda info: info["objects"] in ("discs", "boxes"))  # points become these
        self.lines = names(lambda info: info["objects"] in ("lines", "lines and points"))
        self.bodies = names(lambda info: info["objects"] == "bodies")

    @property
    def all(self):
        names = [*self.line, *self.plane, *self.graphs, *self.extents, *self.lines, *self.space, *self.bodies]
        return list(dict.fromkeys(names))


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
    if done.returncode not in (0, 2):
        sys.exit(f"kinex gen {family}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return path if done.returncode == 0 else None


def run(program, folder, scene, *more):
    """The log of a run, as bytes; None if the scene is refused."""
    path = pathlib.Path(folder) / "run.jsonl"
    path.unlink(missing_ok=True)
    done = subprocess.run([program, "run", str(scene), "--events", str(path), *more], capture_output=True, text=True)
    if done.returncode == 2:
        return None
    if done.returncode != 0 or not path.exists():
        sys.exit(f"kinex run: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return path.read_bytes()


def complaint(program, folder, scene):
    """What kinex check says against the log that run() has written last; "" if nothing."""
    done = subprocess.run([program, "check", "-q", str(pathlib.Path(folder) / "run.jsonl"), "--scene", str(scene)],
                          capture_output=True, text=True)
    return "" if done.returncode == 0 else done.stderr.strip() or f"exit code {done.returncode}"


def require_version(program):
    """Ends the test if the program's logs are not of version 2."""
    with tempfile.TemporaryDirectory() as folder:
        data = run(program, folder, generate(program, folder, "uniform-square", 3, 1, "sorted_list"))
    if json.loads(data.split(b"\n")[0])["version"] != 2:
        sys.exit("the program does not write logs of version 2")


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


def axes_for(structure, known, rng):
    """The number of axes of a random scene for the structure."""
    if structure in known.graphs:
        return 1
    if structure in known.extents:
        return rng.randrange(1, 4)
    return 2 if structure in known.line + known.plane + known.lines else 3


def drawn_scene(rng, program, folder, structure, known):
    """A random small scene for a structure."""
    while True:
        seed = rng.randrange(1, 10**6)
        if structure in known.bodies:
            family = rng.choice(BODY_FAMILIES)
            n = 3 if family == "polygons-in-box" else rng.randrange(3, 6)
            path = generate(program, folder, family, n, seed, structure, "--m", str(rng.randrange(3, 6)))
        else:
            maintain = structure
            if structure in known.line:
                keys = KEYS[:3] if structure in known.linear else KEYS
                maintain = {"structure": structure, "key": rng.choice(keys), "as": "it"}
            family = rng.choice(POINT_FAMILIES)
            axes = axes_for(structure, known, rng)
            path = generate(program, folder, family, rng.randrange(5, 10 if axes < 3 else 8), seed, maintain,
                            "--dimension", str(axes))
        if path is not None:
            return path, f"{family}, seed {seed}"


__all__ = ["random"]
