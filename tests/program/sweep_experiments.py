# SPDX-License-Identifier: GPL-3.0-or-later
"""verify and trade are plans of sweeps: run in shards by child processes and merged, they give the reports
that `kinex verify` and `kinex trade` make, in all exact fields.

usage: sweep_experiments.py PROGRAM
"""
import json
import pathlib
import sqlite3
import subprocess
import sys
import tempfile

from sweep_files import records_of, sweep

# Columns that two runs do not have alike, in whatever table; and tables of one run alone.
TIMED = ("started_utc", "exact_over_double", "time_over_double")
NOT_EXACT = ("build", "machine")


def kinex(program, *words, code=0):
    done = subprocess.run([program, *map(str, words)], capture_output=True, text=True)
    assert code is None or done.returncode == code, (words, done.returncode, done.stdout[-2000:], done.stderr)
    return done


def exact_content(path):
    database = sqlite3.connect(f"file:{path}?mode=ro", uri=True)
    content = []
    for (table,) in database.execute("SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name"):
        if table in NOT_EXACT:
            continue
        rows = database.execute(f"SELECT * FROM {table}")
        names = [column[0] for column in rows.description]
        content += [(table, *((name, value) for name, value in zip(names, row)
                              if not isinstance(value, float) and name not in TIMED and "_ratio" not in name))
                    for row in rows]
    assert len(content) > 30, len(content)
    return content


def exact_rows(text):
    """JSON lines of verify without times."""
    rows = [json.loads(line) for line in text.splitlines() if line.startswith("{")]
    for row in rows:
        row.pop("seconds", None)
        row.pop("exact_over_double", None)
    return rows


def report_equals(program, folder, verb, words):
    out, here, merged = folder / f"{verb}-sweep", folder / f"{verb}-here", folder / f"{verb}-merged"
    direct = kinex(program, verb, *words, "-o", here, "--json")
    for shard in ("0/2", "1/2"):
        if shard == "1/2":  # the first half is not enough
            refused = kinex(program, verb, *words, "--from", out, "-o", merged, code=2)
            assert "are missing" in refused.stderr and "kinex sweep run" in refused.stderr, refused.stderr
        sweep(program, "run", verb, *words, "--shard", shard, "-o", out)
    again = sweep(program, "run", verb, *words, "-o", out)
    assert "finished already" in again.stderr and not again.stdout, (again.stdout, again.stderr)
    sweep(program, "status", out)
    sweep(program, "merge", out, "-o", folder / f"{verb}.sqlite")
    report = kinex(program, verb, *words, "--from", out, "-o", merged, "--json")
    if verb == "verify":
        assert exact_rows(report.stdout) == exact_rows(direct.stdout)
    assert exact_content(merged / f"{verb}.sqlite") == exact_content(here / f"{verb}.sqlite")
    # A record that says something else is a conflict, not another report.
    cell = next(record for record in records_of(out) if "fields" in (record["exact"] or {}))
    cell["exact"]["fields"] += " "
    first = next(pathlib.Path(out).glob("shard-0-*.jsonl"))
    (out / "shard-0-20990101T000000Z-0.jsonl").write_text(
        first.read_text().splitlines()[0] + "\n" + json.dumps(cell) + "\n")
    sweep(program, "merge", out, "-o", folder / "no.sqlite", code=1)
    kinex(program, verb, *words, "--from", out, "-o", folder / "no", code=2)


def main():
    program = sys.argv[1]
    listed = sweep(program, "list").stdout
    assert "verify" in listed and "trade" in listed, listed
    cells = sweep(program, "list", "verify", "sorted_list", "--quick").stdout
    assert '{"verify":{' in cells and "cells" in cells, cells
    one = json.loads(sweep(program, "list", "verify", "sorted_list", "--quick", "--json").stdout.splitlines()[-1])
    report = json.loads(sweep(program, "cell", json.dumps(one["cell"])).stdout)
    assert report["status"] == "done" and report["exact"]["fields"], report
    for words in (("verify", "nothing"), ("nothing.json", "--quick"), ("trade", "--seeds", "3"), ("verify", "--arithmetic", "gsl")):
        sweep(program, "list", *words, code=2)
    with tempfile.TemporaryDirectory() as name:
        report_equals(program, pathlib.Path(name), "verify", ("sorted_list", "--quick"))
        report_equals(program, pathlib.Path(name), "trade", ("sorted_list", "--quick", "--arithmetic", "gsl"))


main()
