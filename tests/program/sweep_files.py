# SPDX-License-Identifier: GPL-3.0-or-later
"""Plans, folders and databases of `kinex sweep`, for its tests."""
import json
import pathlib
import sqlite3
import subprocess

EXACT_TABLES = ("plan", "cell", "plan_cell", "run", "counter", "extreme", "bound", "violation")


def write_plan(path, blocks, **limits):
    plan = {"kinex_plan": 1, "name": "test", "blocks": blocks}
    if limits:
        plan["limits"] = limits
    path.write_text(json.dumps(plan))
    return path


def sweep(program, *words, code=0, **options):
    """Runs `kinex sweep WORDS`; it must end with this exit code (None: any)."""
    done = subprocess.run([program, "sweep", *map(str, words)], capture_output=True, text=True, **options)
    assert code is None or done.returncode == code, (words, done.returncode, done.stdout, done.stderr)
    return done


def lines_of(folder):
    """[(file, line)] of all whole lines but the first of each file."""
    found = []
    for path in sorted(pathlib.Path(folder).glob("shard-*.jsonl")):
        text = path.read_text()
        whole = text[:text.rfind("\n") + 1].splitlines()
        found += [(path, line) for line in whole[1:]]
    return found


def records_of(folder):
    return [json.loads(line) for _, line in lines_of(folder)]


def exact_content(path):
    """The exact tables, with their definitions, as text."""
    database = sqlite3.connect(f"file:{path}?mode=ro", uri=True)
    content = []
    for table in EXACT_TABLES:
        content += database.execute("SELECT sql FROM sqlite_schema WHERE name = ?", (table,)).fetchone()
        content += [repr(row) for row in database.execute(f"SELECT * FROM {table}")]
    assert "STRICT" in content[0] and len(content) > 20, content[:20]
    return "\n".join(content)


def merged(program, folder, path, code=0):
    sweep(program, "merge", folder, "-o", path, "--force", code=code)
    return exact_content(path)
