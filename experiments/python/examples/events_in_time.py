# SPDX-License-Identifier: GPL-3.0-or-later
"""An event log as a table: records of every kind so far, in the course of time.

    kinex gen uniform-square --n 30 --seed 7 --force -o square.json
    kinex run square.json --maintain convex_hull_2 --events square.log --force
    python3 events_in_time.py square.log events.svg --force
"""
import collections
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import kinex_results as kinex
import script
from svg_figure import Axis, Figure


def main():
    parser = script.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("log", help="event log")
    parser.add_argument("figure", help="SVG file to write")
    parser.add_argument("--structure", help="label of the structure, if the log has several")
    parser.add_argument("--force", action="store_true", help="replace the figure if it exists")
    options = parser.parse_args()
    log = kinex.read_log(options.log)
    stairs = {"external": [], "internal": []}
    kinds = collections.Counter()
    for record in log.of(structure=options.structure):
        if record.time is None:
            raise kinex.ResultsError(f"{options.log}: it has no times; run kinex with --instants names")
        stair = stairs["external" if record.external else "internal"]
        stair.append((record.time, len(stair) + 1))
        kinds[record.kind, record.external] += 1
    print("kind       effect     records")
    for (kind, external), number in sorted(kinds.items(), key=lambda entry: -entry[1]):
        print(f"{kind:<10} {'external' if external else 'internal':<10} {number:>7}")
    figure = Figure(f"Log of {log.header['scene']}", Axis("t"), Axis("records so far"))
    for name, stair in stairs.items():
        if stair:
            figure.steps(f"{name}: {len(stair)}", stair)
    figure.write(options.figure, options.log, options.force)


if __name__ == "__main__":
    script.run(main)
