# SPDX-License-Identifier: GPL-3.0-or-later
"""Event logs and summaries of real runs, and the good logs of the corpus, are valid by their schemas.

usage: log_schemas.py PROGRAM SOURCE_FOLDER
Exit code 77: jsonschema is not there.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

try:
    import jsonschema
except ImportError:
    print("skipped: this Python has no jsonschema (Debian: python3-jsonschema)")
    sys.exit(77)

RUNS = [  # gen arguments, run arguments
    (["come-and-go", "--n", "12"], ["--maintain", "sorted_list,delaunay_2"]),
    (["grid", "--n", "16"], ["--maintain", "delaunay_2,convex_hull_2,maximum_tournament"]),
    (["uniform-square", "--n", "10"],
     ["--maintain", '{"structure": "sorted_list", "key": {"direction": ["1/3", 2]}, "as": "d"}',
      "--at", "1/3"]),
    (["polygon-fan", "--n", "6", "--m", "6"], []),
    (["uniform-square", "--n", "10"], ["--instants", "intervals"]),
    (["uniform-square", "--n", "10"], ["--instants", "none", "--max-events", "5"]),
    (["uniform-square", "--n", "10"], ["--arithmetic", "mpfr:100"]),
    (["uniform-square", "--n", "10"], ["--provenance"]),
]


def main():
    program, source = sys.argv[1], pathlib.Path(sys.argv[2])
    validators = {}
    for name in ("log", "summary"):
        schema = json.loads((source / f"experiments/schemas/{name}.schema.json").read_text())
        jsonschema.Draft7Validator.check_schema(schema)
        validators[name] = jsonschema.Draft7Validator(schema)
    wrong, counts = [], {"log": 0, "summary": 0}

    def check(name, text, where):
        counts[name] += 1
        for error in validators[name].iter_errors(json.loads(text)):
            wrong.append(f"{where}: {error.message[:200]} at {list(error.absolute_path)}: {text[:200]}")

    with tempfile.TemporaryDirectory() as folder:
        for number, (generate, run) in enumerate(RUNS):
            at = pathlib.Path(folder) / str(number)
            scene, log, summary = (f"{at}.json", f"{at}.jsonl", f"{at}.summary.json")
            subprocess.run([program, "gen", *generate, "-o", scene], check=True, capture_output=True)
            done = subprocess.run([program, "run", scene, *run, "--events", log, "--summary", summary],
                                  capture_output=True, text=True)
            if done.returncode not in (0, 3):
                wrong.append(f"{generate} {run}: {done.stderr}")
                continue
            for text in pathlib.Path(log).read_text().splitlines():
                check("log", text, f"{generate} {run}")
            check("summary", pathlib.Path(summary).read_text(), f"{generate} {run}")
    for path in sorted((source / "tests/corpus/logs/good").glob("*.jsonl")):
        for text in path.read_text().splitlines():
            check("log", text, path.name)
    # Not everything is valid.
    for text in ('{"seq": 1}', '{"format": "kinex-log", "version": 1}', '{"end": "foo"}', "[]"):
        if validators["log"].is_valid(json.loads(text)):
            wrong.append(f"valid: {text}")
    if validators["summary"].is_valid({"scene": "s"}):
        wrong.append("a summary of one member is valid")
    if counts["log"] < 200 or counts["summary"] < len(RUNS):
        wrong.append(f"only {counts}")
    print("\n".join(wrong[:20]) or f"{counts['log']} lines of logs, {counts['summary']} summaries")
    return 1 if wrong else 0


sys.exit(main())
