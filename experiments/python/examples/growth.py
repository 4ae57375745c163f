# SPDX-License-Identifier: GPL-3.0-or-later
"""How a count grows with the number of objects: points, a fitted power, its exponent.

    kinex sweep run growth-plan.json -o out && kinex sweep merge out -o results.sqlite --force
    python3 growth.py results.sqlite external growth.svg --force

growth-plan.json is beside this file. verify.sqlite of kinex verify does as well.
"""
import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import kinex_results as kinex
from svg_figure import Axis, Figure


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results", help="results.sqlite or verify.sqlite")
    parser.add_argument("counter", help="external, processed, kind.swap, ..")
    parser.add_argument("figure", help="SVG file to write")
    parser.add_argument("--force", action="store_true", help="replace the figure if it exists")
    options = parser.parse_args()
    by_structure = {}
    for run, value in kinex.counters(options.results, options.counter):
        if value > 0 and run.arithmetic == "exact":
            by_structure.setdefault(run.structure, []).append((run.objects, value))
    what = {"external": "external events", "processed": "events"}.get(options.counter, options.counter)
    figure = Figure(f"Growth of the number of {what}", Axis("objects n", log=True),
                    Axis(f"{what} of a run", log=True))
    for structure, points in sorted(by_structure.items()):
        figure.points(structure, points)
        sizes = sorted({n for n, _ in points})
        if len(sizes) < 2:
            continue
        fit = kinex.fit_power(points)
        error = "" if fit.error is None else f" \u00b1 {fit.error:.3f}"
        print(f"{structure}: {len(points)} runs, {options.counter} ~ n^{fit.exponent:.3f}{error}")
        figure.line(f"{fit.factor:.3g} n^{fit.exponent:.3f}{error} (95 %)", [(n, fit(n)) for n in sizes],
                    like=structure)
    figure.write(options.figure, options.force)


if __name__ == "__main__":
    try:
        main()
    except (kinex.ResultsError, OSError) as error:
        sys.exit(f"growth.py: {error}")
