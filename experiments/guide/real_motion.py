#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs recorded motion through structures for near points, and writes what it found into real-motion.md.

usage: real_motion.py PROGRAM DATA

DATA is a folder with hurricanes.csv and nearest_stars.csv (tests/shared_data.h says where tests look for it). Only what
stands between the lines
    <!-- real_motion.py -->
    <!-- end -->
of the page is written. Every bound of every exact run is checked; the audits are in tests (tests/program). Minutes of
one core.
"""
import csv
import json
import pathlib
import re
import subprocess
import sys
import tempfile

PAGE = pathlib.Path(__file__).resolve().parent / "real-motion.md"
MADE = re.compile(r"(<!-- real_motion\.py -->\n).*?(<!-- end -->)", re.DOTALL)

STORMS = ["sorted_list", "closest_pair_local", "closest_pair_delaunay", "closest_pair_cones", "emst_list", "emst_cycles",
          "delaunay_2"]
STARS = ["delaunay_3", "closest_pair_delaunay", "emst_list", "emst_cycles"]


def ran(command, codes=(0,)):
    done = subprocess.run(command, text=True, capture_output=True, check=False)
    if done.returncode not in codes:
        sys.exit(f"kinex: {' '.join(map(str, command))}: exit code {done.returncode}\n{done.stderr}")
    return done


def summary_of(program, folder, scene, structure, arithmetic):
    file = folder / "summary.json"
    done = ran([program, "run", scene, "--maintain", structure, "--arithmetic", arithmetic, "--audit", "end", "--summary",
                file, "--force"], (0, 1))
    if arithmetic == "exact" and done.returncode != 0:
        sys.exit(f"kinex: {structure} on {scene}: {done.stderr}")
    return json.loads(file.read_text()), done.returncode


def row_of(program, folder, scene, structure):
    exact, _ = summary_of(program, folder, scene, structure, "exact")
    # The one that was asked for is the last: structures that are read come before it.
    ledgers = exact["structures"]
    asked = ledgers[structure]
    failures = sum(one["failures"] for one in ledgers.values())
    double, code = summary_of(program, folder, scene, structure, "double")
    apart = "the same events" if double["log_digest"] == exact["log_digest"] else "other events"
    wrong = "" if code == 0 else ", and says so"
    if code == 0 and apart == "other events":
        wrong = ", unnoticed at the end"
    if exact["violations"]:
        sys.exit(f"kinex: {structure} on {scene}: {exact['violations'][0]}")
    rebuilds = sum(one["rebuilds"] for one in ledgers.values())
    groups = max(one["largest_group"] for one in ledgers.values())
    live = sum(one["certificates"]["max_live"] for one in ledgers.values())
    local = sum(one["certificates"]["max_per_object"] for one in ledgers.values())
    return [f"`{structure}`", asked["external"], failures, rebuilds, groups, live, local,
            f"{exact['seconds']['simulate']:.2f}", apart + wrong], exact, reasons_of(ledgers)


def reasons_of(ledgers):
    """Why structures were built anew."""
    return {reason for one in ledgers.values() for reason in one.get("rebuild_reasons", {})}


HEAD = ["structure", "changes", "certificate failures", "built anew", "most failures at an instant", "certificates",
        "of one object", "CPU s", "in doubles"]


ABOUT = """
Data: `hurricanes.csv` is made of HURDAT2, the best tracks of Atlantic storms of the US National Hurricane Center
(https://www.nhc.noaa.gov/data/#hurdat; a work of the US government, in the public domain), all seasons laid over one year.
`nearest_stars.csv` is computed from `SSData/Stars/Nearest.csv` of SSCore (https://github.com/timmyd7777/SSCore; free for any use): right
ascension, declination, distance, proper motion and radial velocity as positions and velocities, equatorial, the Sun at the origin.

"In doubles" is the same run in `double`, audited at its end, held against the exact run. "The same events": the same, in the same order,
internal ones included. "Other events, and says so": events or their order differ, and the run ends with exit code 1, because the structure
has found itself corrupt, or because the audit finds the attribute wrong at the end. "Other events, unnoticed at the end": events or their
order differ, but the attribute at the end is right, so nothing is reported; wrong attributes before the end are not looked for.
"""


def table_of(rows):
    text = "| " + " | ".join(HEAD) + " |\n| --- |" + " ---: |" * (len(HEAD) - 2) + " --- |\n"
    return text + "".join("| " + " | ".join(map(str, row)) + " |\n" for row in rows)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    program, data = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    for name in ("hurricanes.csv", "nearest_stars.csv"):
        if not (data / name).is_file():
            sys.exit(f"kinex: {data / name}: there is no such file; name the folder that has it")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        storms, stars = folder / "storms.json", folder / "stars.json"
        ran([program, "import", data / "hurricanes.csv", "-o", storms])
        ran([program, "import", data / "nearest_stars.csv", "--start", "-0.1", "--end", "0.1", "--fixed", "Sun,0,0,0",
             "--maintain", "delaunay_3", "-o", stars])
        text = ""
        for title, scene, structures in (("Storms", storms, STORMS), ("Stars", stars, STARS)):
            rows, reasons = [], set()
            for structure in structures:
                row, summary, why = row_of(program, folder, scene, structure)
                rows.append(row)
                reasons |= why
                print(*row, sep="\t", flush=True)
            text += f"\n**{title}.** {summary['objects']} objects.\n\n" + table_of(rows)
            if reasons:
                text += "\nBuilt anew because " + ", or because ".join(sorted(reasons)) + ".\n"
        made = summary["provenance"]
        dirty = " with changes that are not committed" if made["dirty"] else ""
        text = (f"\nMade by `python3 experiments/guide/real_motion.py PROGRAM DATA`, {summary['build']} at {made['commit']}{dirty}, "
                f"{made['compiler']}, flags `{made['flags']}`; {made['cpu']}. One core.\n" + ABOUT + text)
    page = PAGE.read_text()
    PAGE.write_text(MADE.sub(lambda found: found.group(1) + text + "\n" + found.group(2), page))


main()
