# SPDX-License-Identifier: GPL-3.0-or-later
"""Each family of structures has a page with its layers, its files and their roles, and its departures from
the papers; the parts are in the table of structures/README.md.

usage: family_pages.py SOURCE_FOLDER

Every header of a family is named in its page, between backquotes, in a row of a table "layer, file, role".
"""
import pathlib
import re
import sys

LAYERS = "| layer | file | role |"
DEPARTURES = re.compile(r"(?m)^#+ .*[Dd]epartures")


def rows_of(page):
    """The rows of all tables of layers."""
    rows, inside = [], False
    for line in page.split("\n"):
        inside = line.startswith("|") and (inside or line == LAYERS)
        if inside:
            rows.append(line)
    return rows


def faults_in(page, headers):
    rows = rows_of(page)
    if not rows:
        yield "has no table " + LAYERS
    if not DEPARTURES.search(page):
        yield "has no section on departures from the papers"
    named = set(re.findall(r"`(?:[\w./]*/)?(\w+\.h)`", "\n".join(rows)))
    for header in headers:
        if header not in named:
            yield f"does not name {header} in a table of layers"


def main():
    page = LAYERS + "\n| --- | --- | --- |\n| part | `a.h`, `.cpp` | .. |\n\n`b.h`\n## Departures from the paper\n"
    assert list(faults_in(page, ["a.h", "b.h"])) == ["does not name b.h in a table of layers"]
    assert len(list(faults_in("`a.h`\n", ["a.h"]))) == 3
    root = pathlib.Path(sys.argv[1]) / "structures"
    faults, families = [], 0
    for folder in sorted(root.iterdir()):
        if not folder.is_dir():
            continue
        headers = sorted(file.name for file in folder.glob("*.h"))
        if folder.name == "parts":
            text = (root / "README.md").read_text()
            faults += [f"structures/README.md does not name {name}" for name in headers if f"| `{name}` |" not in text]
            continue
        families += 1
        text = (folder / "README.md").read_text()
        faults += [f"structures/{folder.name}/README.md {fault}" for fault in faults_in(text, headers)]
    if families < 9:
        sys.exit(f"only {families} families: the check does not see the sources")
    if faults:
        sys.exit("\n".join(faults))
    print(f"the pages of {families} families name their files")


main()
