#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes what the descriptors of structures say into the documents and into the schema of scenes.

usage: descriptors.py PROGRAM            writes the tables and the definitions
       descriptors.py PROGRAM --check    exit code 1 if a file is not what the program says

In a document a table stands between the lines
    <!-- kinex list structures --markdown --family NAME -->
    <!-- end -->
and the first of them is the command that prints it. In experiments/schemas/scene.schema.json all definitions
after the marker "from_here_on" are those of `kinex list structures --schema`.
"""
import difflib
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCHEMA = ROOT / "experiments" / "schemas" / "scene.schema.json"
TABLE = re.compile(r"(<!-- kinex (list structures --markdown[^\n]*?) -->\n)(.*?)(<!-- end -->)", re.DOTALL)
MARKER = '"from_here_on": '


def said(program, *words):
    done = subprocess.run([program, *words], text=True, capture_output=True, check=False)
    if done.returncode != 0:
        sys.exit(f"kinex {' '.join(words)}: exit code {done.returncode}\n{done.stderr}")
    return done.stdout


def page_of(program, text):
    """The document with its tables made anew, and the commands that made them."""
    commands = []

    def table(found):
        commands.append(found.group(2))
        return found.group(1) + said(program, *found.group(2).split()) + found.group(4)

    return TABLE.sub(table, text), commands


def schema_of(program, text):
    start = text.index(MARKER)
    end = text.index("\n", start)
    made = text[:end].rstrip(",") + ",\n" + said(program, "list", "structures", "--schema") + "  }\n}\n"
    json.loads(made)
    return made


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--check"]):
        sys.exit(__doc__)
    program, check = sys.argv[1], bool(sys.argv[2:])
    made, tables = {}, []
    pages = sorted((ROOT / "structures").glob("*/README.md")) + [ROOT / "experiments" / "guide" / "concepts.md"]
    for page in pages:
        made[page], commands = page_of(program, page.read_text())
        if not commands:
            sys.exit(f"{page}: there is no table of structures")
        tables += commands
    made[SCHEMA] = schema_of(program, SCHEMA.read_text())
    wrong = []
    for file, text in made.items():
        there = file.read_text()
        if there == text:
            continue
        if check:
            wrong += difflib.unified_diff(there.splitlines(), text.splitlines(), str(file.relative_to(ROOT)),
                                          "the program", lineterm="", n=1)
        else:
            file.write_text(text)
    if wrong:
        sys.exit("\n".join(wrong) + f"\nremedy: python3 {__file__} PROGRAM")
    print(f"{len(tables)} tables and the schema of scenes are what the program says")


main()
