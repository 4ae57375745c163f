# SPDX-License-Identifier: GPL-3.0-or-later
"""How near each other the instants of a run are: gaps between neighbours, exactly.

    kinex gen near-one-point --n 12 --seed 1 --force -o near.json
    kinex run near.json --maintain sorted_list --events near.log --force
    python3 close_instants.py near.log close.svg --force

Doubles just below t = 1/2 are 2^-54 apart: they cannot tell instants apart that are nearer.
"""
import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import kinex_results as kinex
import script
from svg_figure import Axis, Figure


def gap_between(a, b):
    """log2 of b - a, for instants a < b: refined until it is known to a hundredth."""
    bits = 16
    while True:
        a, b = a.refine(bits), b.refine(bits)
        least, most = b.lower - a.upper, b.upper - a.lower
        if least > 0 and most <= least * 101 / 100:
            return math.log2(least.numerator) - math.log2(least.denominator)
        bits *= 2


def main():
    parser = script.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("log", help="event log of an exact run")
    parser.add_argument("figure", help="SVG file to write")
    parser.add_argument("--force", action="store_true", help="replace the figure if it exists")
    options = parser.parse_args()
    instants = []
    for record in kinex.read_log(options.log).records:
        if record.instant is None:
            raise kinex.ResultsError(f"{options.log}: it does not name its instants; run kinex in an exact arithmetic, "
                                     "with --instants names (the default)")
        if not instants or instants[-1] < record.instant:
            instants.append(record.instant)
    gaps = [gap_between(a, b) for a, b in zip(instants, instants[1:])]
    if not gaps:
        raise kinex.ResultsError(f"{options.log}: it has fewer than two instants; take a longer run")
    smallest = min(range(len(gaps)), key=gaps.__getitem__)
    print(f"{len(instants)} instants; the nearest are 2^{gaps[smallest]:.2f} apart, at")
    for instant in instants[smallest:smallest + 2]:
        print(" ", instant.decimal(40))
    figure = Figure("Gaps between neighbouring instants", Axis("place of the gap in the run"),
                    Axis("log2 of the gap"))
    figure.points("a gap", list(enumerate(gaps, 1)))
    figure.line("2^-54: distance of doubles just below t = 1/2", [(1, -54), (len(gaps), -54)], dashed=True)
    figure.write(options.figure, options.log, options.force)


if __name__ == "__main__":
    script.run(main)
