#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures all structures for near points on the same scenes, and writes the table into proximity.md.

usage: proximity_table.py FOLDER

FOLDER: of a build, with experiments/kinex and experiments/bench/kinex_proximity. What is between the lines

    <!-- proximity_table.py -->
    <!-- end -->

of the page is replaced: for each attribute that several structures maintain, on each scene, those with the
least of each figure; then all figures. A minute or two on an idle machine; with another load the milliseconds
are too long.
Exit code 1: a program is missing or fails; the page is left as it is.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

PAGE = pathlib.Path(__file__).resolve().parent / "proximity.md"
TABLE = re.compile(r"(<!-- proximity_table\.py -->\n).*?(<!-- end -->)", re.DOTALL)


def ran(command):
    try:
        return subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True).stdout
    except OSError as error:
        sys.exit(f"kinex: {error.filename}: {error.strerror}; build the programs first: cmake --build FOLDER")
    except subprocess.CalledProcessError as error:
        sys.exit(f"kinex: {error.cmd[0]} ends with {error.returncode}: {error.stderr.strip()}; nothing is written")


def provenance(kinex, folder):
    """What made the program: a summary of a run of it says so."""
    scene, summary = folder / "scene.json", folder / "summary.json"
    ran([kinex, "gen", "uniform-square", "--n", "4", "--maintain", "delaunay_2", "-o", scene])
    ran([kinex, "run", scene, "--summary", summary])
    read = json.loads(summary.read_text())
    made = read["provenance"]
    dirty = " with changes that are not committed" if made["dirty"] else ""
    return (f"{read['build']} at {made['commit']}{dirty}, {made['compiler']}, flags `{made['flags']}`; {made['cpu']}. "
            "One core.")


def without_rates_of_nothing(rows):
    """The rows of a table, with "-" for the failures per change where there are no changes."""
    names = rows[0].split(" | ")
    rate, changes = names.index("failures per change"), names.index("changes")
    result = []
    for row in rows:
        cells = row.split(" | ")
        if cells[changes] == "0.0":
            cells[rate] = "-"
        result.append(" | ".join(cells))
    return result


LEAST = ("certificates", "of one object", "failures per change", "milliseconds")


def least_of_each(rows):
    """A table of the structures with the least of each figure of LEAST, of two or more on the same scene."""
    cells_of = [[cell.strip() for cell in row.strip("| ").split(" | ")] for row in rows]
    names = cells_of[0]
    scenes = {}  # (attribute, scene, n) -> the cells of its rows, by name
    for cells in cells_of[2:]:
        row = dict(zip(names, cells, strict=True))
        scenes.setdefault((row["attribute"], row["scenes"], row["n"]), []).append(row)
    result = ["| attribute | scenes | n | " + " | ".join(f"least {name}" for name in LEAST) + " |",
              "| --- | --- | ---: |" + " --- |" * len(LEAST)]
    for scene, found in scenes.items():
        if len(found) < 2:
            continue
        cells = list(scene)
        for name in LEAST:
            values = {row["structure"]: float(row[name]) for row in found if row[name] != "-"}
            least = min(values.values(), default=None)
            cells.append(", ".join(one for one, value in values.items() if value == least) or "-")
        result.append("| " + " | ".join(cells) + " |")
    return result


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    build = pathlib.Path(sys.argv[1]).resolve() / "experiments"
    page = PAGE.read_text()
    if not TABLE.search(page):
        sys.exit(f"kinex: {PAGE}: the lines around the table are missing; write them, as proximity_table.py --help has them")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        made = provenance(build / "kinex", folder)
        ran([build / "bench/kinex_proximity", "--markdown", folder / "table.md"])
        rows = [line for line in (folder / "table.md").read_text().split("\n") if line.startswith("|")]
    rows = without_rates_of_nothing(rows)
    text = (f"\nMade by `python3 experiments/guide/proximity_table.py FOLDER`, {made}\n\n"
            "Which structures have the least of a figure, where several maintain the attribute:\n\n"
            + "\n".join(least_of_each(rows)) + "\n\nAll figures:\n\n" + "\n".join(rows) + "\n\n")
    PAGE.write_text(TABLE.sub(lambda found: found.group(1) + text + found.group(2), page))


if __name__ == "__main__":
    main()
