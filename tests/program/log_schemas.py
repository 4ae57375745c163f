# SPDX-License-Identifier: GPL-3.0-or-later
"""Event logs and summaries of real runs, the good logs of the corpus, the claims of papers, and the examples on
the pages of the formats are valid by their schemas.

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

from page_blocks import blocks_of

PAPERS = [("kds-report-1998", "section-9"), ("separation-sensitive-1999", "translation")]
PAGES = ("scene", "log", "plan")  # each with examples of the schema of its name
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
    for name in ("scene", "log", "summary", "claims", "plan"):
        schema = json.loads((source / f"experiments/schemas/{name}.schema.json").read_text())
        jsonschema.Draft7Validator.check_schema(schema)
        validators[name] = jsonschema.Draft7Validator(schema)
    wrong, counts = [], {name: 0 for name in validators}

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
        # A paper's part as the program writes it now, without and with a second program, and all as committed.
        for number, (paper, part) in enumerate(PAPERS):
            out = pathlib.Path(folder) / paper
            checker = ["--logcheck", str(pathlib.Path(program).with_name("kinex-logcheck"))] if number == 0 else []
            done = subprocess.run([program, "reproduce", paper, part, "--quick", *checker, "-o", str(out)],
                                  capture_output=True, text=True)
            if done.returncode != 0:
                wrong.append(f"{paper} {part}: exit code {done.returncode}: {done.stderr[-500:]}")
                continue
            check("claims", (out / "claims.json").read_text(), f"{paper} {part}")
            check("claims", (source / f"papers/{paper}/claims.json").read_text(), f"papers/{paper}")
    for page in PAGES:
        for language, text in blocks_of(source, f"experiments/guide/formats/{page}.md"):
            if language == "json":
                check(page, text, f"formats/{page}.md")
    for path in sorted((source / "experiments/sweep/plans").glob("*.json")):
        check("plan", path.read_text(), path.name)
    for path in sorted((source / "tests/corpus/logs/good").glob("*.jsonl")):
        for text in path.read_text().splitlines():
            check("log", text, path.name)
    # Not everything is valid.
    for text in ('{"seq": 1}', '{"format": "kinex-log", "version": 1}', '{"end": "foo"}', "[]"):
        if validators["log"].is_valid(json.loads(text)):
            wrong.append(f"valid: {text}")
    if validators["summary"].is_valid({"scene": "s"}):
        wrong.append("a summary of one member is valid")
    claims = json.loads((source / f"papers/{PAPERS[0][0]}/claims.json").read_text())
    claims["claims"][0]["verdict"] = "true"
    if validators["claims"].is_valid(claims) or validators["claims"].is_valid({"paper": "p"}):
        wrong.append("claims with a verdict of another word, or without claims, are valid")
    if counts["log"] < 200 or counts["summary"] < len(RUNS) or min(counts.values()) < 2:
        wrong.append(f"only {counts}")
    print("\n".join(wrong[:20]) or ", ".join(f"{count} of {name}" for name, count in counts.items()))
    return 1 if wrong else 0


sys.exit(main())
