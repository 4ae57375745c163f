# SPDX-License-Identifier: GPL-3.0-or-later
"""The committed pages of the papers say what the program finds today, of the parts that take seconds.

usage: committed_verdicts.py PROGRAM SOURCES PAPER/PART..

Runs each part at its full size and compares every claim with papers/PAPER/claims.json: what is expected, what
was observed, and the verdict. A page may be older than the code, but not say something else.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

COMPARED = ("statement", "expected", "tolerance", "observed", "verdict")


def differences(program, sources, paper, part):
    committed = {claim["id"]: claim
                 for claim in json.loads((sources / "papers" / paper / "claims.json").read_text())["claims"]}
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([program, "reproduce", paper, part, "--json", "-o", f"{folder}/out"],
                              capture_output=True, text=True)
    if done.returncode != 0:
        yield f"exit code {done.returncode}: {done.stderr.strip()}"
        return
    found = json.loads(done.stdout)["claims"]
    if not found:
        yield "no claims"
    for claim in found:
        page = committed.get(claim["id"])
        if page is None:
            yield f"{claim['id']} is not in the page"
            continue
        for field in COMPARED:
            if claim[field] != page[field]:
                yield f"{claim['id']}, {field}: the page has\n    {page[field]}\n  the program finds\n    {claim[field]}"


def main():
    program, sources, parts = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
    wrong = []
    for name in parts:
        paper, part = name.split("/")
        wrong += [f"{name}: {difference}" for difference in differences(program, sources, paper, part)]
    print("\n".join(wrong) or f"{len(parts)} parts as in the pages")
    sys.exit(1 if wrong else 0)


main()
