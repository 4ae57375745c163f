# SPDX-License-Identifier: GPL-3.0-or-later
"""The databases that the program writes have the tables, columns and references that
experiments/schemas/*.sql document, and no others; every column there has a comment.

usage: databases.py PROGRAM SOURCE_FOLDER
"""
import pathlib
import re
import sqlite3
import subprocess
import sys
import tempfile

PLAN = """{"kinex_plan": 1, "name": "small", "blocks": [{"structure": ["sorted_list"],
 "workload": "uniform-square", "n": [8, 16], "seed": {"from": 1, "to": 2}}]}"""


def run(folder, *words):
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True)
    if done.returncode not in (0, 3):  # 3: too few seeds to tell
        sys.exit(f"{words}: exit code {done.returncode}\n{done.stdout[-1000:]}{done.stderr}")


def tables_of(database):
    """{table: (STRICT, WITHOUT ROWID, columns, references, unique columns)}"""
    tables = {}
    for _, name, kind, _, without_rowid, strict in database.execute("PRAGMA table_list"):
        if kind != "table" or name.startswith("sqlite_"):
            continue
        columns = [row[1:4] + row[5:] for row in database.execute(f"PRAGMA table_info({name})")]
        references = sorted(row[2:5] for row in database.execute(f"PRAGMA foreign_key_list({name})"))
        unique = sorted(tuple(column[2] for column in database.execute(f"PRAGMA index_info({index[1]})"))
                        for index in database.execute(f"PRAGMA index_list({name})") if index[2])
        tables[name] = (strict, without_rowid, columns, references, unique)
    return tables


def without_comment(text):
    """Lines that define a column and do not say what it is."""
    keys = ("PRIMARY", "UNIQUE", "FOREIGN", "CREATE", ")")
    for line in text.splitlines():
        word = line.strip().split(" ")[0].split("(")[0]
        if line.startswith("  ") and word not in keys and "--" not in line and line.split()[0] != "id":
            yield line.strip()


def main():
    program, source = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
    wrong, count = [], 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "plan.json").write_text(PLAN)
        run(folder, program, "verify", "sorted_list", "--quick", "--seeds", "2")
        run(folder, program, "gen", "uniform-square", "--n", "8", "--maintain", "sorted_list", "-o", "s.json")
        run(folder, program, "trade", "s.json", "--arithmetic", "gsl")
        run(folder, program, "sweep", "run", "plan.json", "-o", "out")
        run(folder, program, "sweep", "merge", "out", "-o", "sweep.sqlite")
        for kind in ("verify", "trade", "sweep"):
            text = (source / f"experiments/schemas/{kind}.sql").read_text()
            documented = sqlite3.connect(":memory:")
            documented.executescript(text)
            wrong += [f"{kind}.sql: no comment: {line}" for line in without_comment(text)]
            made = sqlite3.connect(f"file:{folder / kind}.sqlite?mode=ro", uri=True)
            told, there = tables_of(documented), tables_of(made)
            count += len(there)
            for table in sorted(told.keys() | there.keys()):
                if told.get(table) != there.get(table):
                    wrong.append(f"{kind}, {table}:\n  documented {told.get(table)}\n  written    {there.get(table)}")
            if not any(made.execute(f"SELECT count(*) FROM {table}").fetchone()[0] for table in there):
                wrong.append(f"{kind}: nothing was written")
        # The page has a section for every table.
        page = (source / "experiments/guide/formats/databases.md").read_text()
        for kind in ("verify", "trade", "sweep"):
            names = re.findall(r"(?m)^CREATE TABLE (\w+)", (source / f"experiments/schemas/{kind}.sql").read_text())
            wrong += [f"databases.md does not mention {table}" for table in names if f"`{table}`" not in page]
    if count < 20:
        wrong.append(f"only {count} tables were compared")
    print("\n".join(wrong) or f"{count} tables are as documented")
    return 1 if wrong else 0


sys.exit(main())
