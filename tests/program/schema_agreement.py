# SPDX-License-Identifier: GPL-3.0-or-later
"""The scene schema and the reader give the same verdict, as far as a schema can.

usage: schema_agreement.py PROGRAM SOURCE_FOLDER
Exit code 77: jsonschema is not there. For every scene of the corpus index.json says what the schema
must do; the program itself gives the verdict of the reader. A good scene, and every scene that the
program generates or that lies in experiments/scenes, must validate.
"""
import json
import pathlib
import subprocess
import sys

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
    print("\n".join(wrong) or f"{checked} scenes: schema and reader agree")
    return 1 if wrong else 0


sys.exit(main())
