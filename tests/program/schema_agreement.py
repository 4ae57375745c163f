# SPDX-License-Identifier: GPL-3.0-or-later
"""The scene schema and the reader give the same verdict, as far as a schema can.

usage: schema_agreement.py PROGRAM SOURCE_FOLDER
Exit code 77: jsonschema is not there. For every scene of the corpus index.json says what the schema
must do; the program itself gives the verdict of the reader. A good scene, and every scene that the
program generates or that lies in experiments/scenes, must validate. Of every structure that is listed,
entries of "maintain" with each member that some structure takes, in its range and beyond it: on these
the two verdicts are the same. Of structures that take the same members the first is tried with all
entries and each of the others with every twelfth one.
"""
import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys
import tempfile

try:
    import jsonschema
except ImportError:
    print("skipped: this Python has no jsonschema (Debian: python3-jsonschema)")
    sys.exit(77)


def strict_object(pairs):
    result = dict(pairs)
    if len(result) != len(pairs):
        raise ValueError("a name stands twice")
    return result


def refuse_constant(name):
    raise ValueError(name)


def load(data):
    text = data.decode("utf-8")
    value = json.loads(text, object_pairs_hook=strict_object, parse_constant=refuse_constant,
                       parse_float=check_float)
    json.dumps(value, ensure_ascii=False).encode("utf-8")  # no lone surrogates
    return value


def check_float(token):
    value = float(token)
    if value in (float("inf"), float("-inf")):
        raise ValueError(token)
    return value


def verdict(validator, data):
    try:
        value = load(data)
    except ValueError:
        return "unparsable"
    return "accepts" if validator.is_valid(value) else "refuses"


# By the objects that structures are about: scenes of few of them, of two axes or of three.
FAMILIES = {"points": [["uniform-square"], ["uniform-square", "--dimension", "3"]], "discs": [["random-discs"]],
            "boxes": [["random-boxes"]], "lines": [["uniform-square"]], "lines and points": [["uniform-square"]],
            "edges": [["random-graph", "--m", "4"]],
            "bodies": [["polygons-in-box", "--m", "3"], ["polygon-approach"]]}


def scene_for(program, info):
    """A scene that the structure takes; its points have two colours."""
    for family in FAMILIES[info["objects"]]:
        done = subprocess.run([program, "gen", *family, "--n", "6", "--maintain", info["name"]],
                              capture_output=True, text=True)
        if done.returncode == 0:
            scene = json.loads(done.stdout)
            for i, one in enumerate(scene["objects"]):
                if "polygon" not in one:
                    one["colour"] = ("red", "blue")[i % 2]
            return scene
    sys.exit(f"no scene suits {info['name']}")


def entries(info, infos, ids):
    """Entries for the structure: right and wrong ones."""
    name = info["name"]
    yield name
    yield name + "_"
    members = [{"key": "x"}, {"key": {"squared_distance_to": ids[0]}}, {"key": "w"}, {"query": ids[0]}, {"query": 3},
               {"colours": ["red", "blue"]}, {"colours": ["red"]}, {"as": "it"}, {"as": "t"}, {"as": ""},
               {"of": {"all_but": []}}, {"of": 7}, {"nothing": 1}, {"query": ids[0], "as": "it"}]
    if "query" not in info["takes"]:
        members.append({"of": ids})
    for role in sorted({other["role"] for other in infos if "role" in other}):
        first = next(other["name"] for other in infos if other.get("role") == role)
        members += [{"over": first}, {"over": {"structure": first}}, {"over": {"structure": first, "of": ids}}]
    members += [{"over": name}, {"over": {"structure": "directions_2", "k": 8}},
                {"over": {"structure": "directions_2", "k": 0}}, {"over": {}}]
    for parameter in sorted({one["name"] for other in infos for one in other["parameters"]}):
        values = [0, 1, 2, 3, 4, 60, 61, -1, 0.25, 0.5, 2.5, "4", "one", None, [2]]
        members += [{parameter: value} for value in (values if parameter in info["takes"] else [2])]
    for member in members:
        yield {"structure": name, **member}
    yield {"key": "x"}
    yield 3


def alike(info):
    """The same for structures whose entries the schema and the reader treat alike."""
    return json.dumps([info["objects"], sorted(info["takes"]), info["parameters"], info.get("role")])


def disagreements(program, validator, info, infos, folder):
    """(what, how often they were compared) of one structure."""
    scene = scene_for(program, info)
    path = os.path.join(folder, info["name"] + ".json")
    wrong, checked = [], 0
    before = infos[:infos.index(info)]
    number = sum(alike(other) == alike(info) for other in before)
    for k, entry in enumerate(entries(info, infos, [one["id"] for one in scene["objects"]])):
        if number > 0 and (k + number) % 12 > 0:
            continue
        scene["maintain"] = [entry]
        data = json.dumps(scene).encode()
        pathlib.Path(path).write_bytes(data)
        by_schema = verdict(validator, data)
        done = subprocess.run([program, "check", path], capture_output=True, text=True)
        by_reader = {0: "accepts", 2: "refuses"}[done.returncode]
        checked += 1
        # The value of a number that is written as a text is the reader's business.
        texts = isinstance(entry, dict) and any(isinstance(entry.get(one["name"]), str) for one in info["parameters"])
        if by_schema != by_reader and not (texts and by_schema == "accepts"):
            wrong.append(f"{json.dumps(entry)}: the schema {by_schema}, the reader {by_reader}: {done.stderr.strip()}")
    return wrong, checked


def main():
    program, source = sys.argv[1], pathlib.Path(sys.argv[2])
    schema = json.loads((source / "experiments/schemas/scene.schema.json").read_text())
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    wrong = []
    checked = 0
    for entry in json.loads((source / "tests/corpus/index.json").read_text()):
        if not entry["file"].startswith("scenes/"):
            continue
        checked += 1
        path = source / "tests/corpus" / entry["file"]
        by_schema = verdict(validator, path.read_bytes())
        if by_schema != entry["schema"]:
            wrong.append(f"{path}: the schema {by_schema}, the index says {entry['schema']}")
        by_reader = subprocess.run([program, "check", str(path)], capture_output=True).returncode
        if by_schema != "accepts" and by_reader != 2:
            wrong.append(f"{path}: the schema {by_schema}, the reader accepts")
    listing = subprocess.run([program, "gen", "--list"], capture_output=True, text=True, check=True)
    families = [line.split()[0] for line in listing.stdout.splitlines()]
    scenes = [(name, subprocess.run([program, "gen", name, "--n", "8"], capture_output=True,
                                    check=True).stdout) for name in families]
    scenes += [(str(path), path.read_bytes()) for path in source.glob("experiments/scenes/*.json")]
    for name, data in scenes:
        checked += 1
        if verdict(validator, data) != "accepts":
            wrong.append(f"{name}: the schema does not accept it")
    if checked < 50 or len(families) < 10:
        wrong.append(f"only {checked} scenes and {len(families)} families were checked")
    infos = json.loads(subprocess.run([program, "list", "structures", "--json"], capture_output=True, text=True,
                                      check=True).stdout)
    tried = 0
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(2) as pool:
        for found, count in pool.map(lambda info: disagreements(program, validator, info, infos, folder), infos):
            wrong += found
            tried += count
    if tried < 20 * len(infos):
        wrong.append(f"only {tried} entries of {len(infos)} structures were tried")
    print("\n".join(wrong) or f"{checked} scenes, and {tried} entries of {len(infos)} structures: "
          "schema and reader agree")
    return 1 if wrong else 0


sys.exit(main())
