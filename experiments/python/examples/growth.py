# SPDX-License-Identifier: GPL-3.0-or-later
"""How a count grows with the number of objects: points, a fitted power, its exponent.

    kinex sweep run growth-plan.json -o out && kinex sweep merge out -o results.sqlite --force
    python3 growth.py results.sqlite external growth.svg --force
    python3 growth.py verify.sqlite external growth.svg --structure sorted_list --workload uniform-square

growth-plan.json is beside this file. verify.sqlite of kinex verify does as well. A series is the exact runs of one
structure on one workload that differ in n and seed alone; those of a single n are left out, and so are runs that
ended at a limit.
"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import kinex_results as kinex
import script
from svg_figure import COLOURS, Axis, Figure

MOST_SERIES = len(COLOURS)  # of one picture
# Parameters that tell no series apart: those in which its runs may differ, and what a run says elsewhere.
NO_PARAMETERS = ("n", "seed", "first_seed", "seeds", "structure", "workload", "arithmetic")


class Series:
    """What its runs have in common, and their points (n, count)."""

    def __init__(self, run):
        self.structure = run.structure
        self.workload = run.workload or run.scene
        self.parameters = common(run)
        self.points = []

    def sizes(self):
        return sorted({n for n, _ in self.points})

    def options(self):
        """Those by which it is chosen."""
        words = ["--structure", self.structure, "--workload", self.workload]
        for name, value in self.parameters:
            words += [f"--{name}", value] if name in ("dimension", "degree") else ["--parameter", f"{name}={value}"]
        return " ".join(words)

    def name(self):
        """"sorted_list on uniform-square, 1 axis, degree 1"; 0 axes are those that the workload has."""
        text = f"{self.structure} on {self.workload}"
        for name, value in self.parameters:
            if name == "dimension":
                text += "" if value == "0" else f", {value} {'axis' if value == '1' else 'axes'}"
            else:
                text += f", {name} {value}"
        return text


def common(run):
    """The parameters that tell series apart, as text."""
    names = [name for name, value in run.parameters.items() if name not in NO_PARAMETERS and value is not False]
    names.sort(key=lambda name: (name != "dimension", name != "degree", name))
    return tuple((name, str(run.parameters[name]).replace("True", "true")) for name in names)


def arguments():
    parser = script.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results", help="results.sqlite or verify.sqlite")
    parser.add_argument("counter", help="external, processed, kind.swap, ..")
    parser.add_argument("figure", help="SVG file to write")
    parser.add_argument("--force", action="store_true", help="replace the figure if it exists")
    choice = parser.add_argument_group("which series (each option may be given several times; default: all)")
    choice.add_argument("--structure", action="append")
    choice.add_argument("--workload", action="append")
    choice.add_argument("--dimension", action="append", help="axes; 0: as many as the workload has by itself")
    choice.add_argument("--degree", action="append", help="of the motion")
    choice.add_argument("--parameter", action="append", default=[], metavar="NAME=VALUE", help="m=16, separation=1/4, ..")
    return parser.parse_args()


def is_chosen(series, options):
    parameters = dict(series.parameters)
    wanted = {}
    for one in options.parameter:
        name, _, value = one.partition("=")
        wanted.setdefault(name, []).append(value)
    return ((options.structure is None or series.structure in options.structure)
            and (options.workload is None or series.workload in options.workload)
            and (options.dimension is None or parameters.get("dimension") in options.dimension)
            and (options.degree is None or parameters.get("degree") in options.degree)
            and all(parameters.get(name) in values for name, values in wanted.items()))


def listed(every):
    return "".join(f"\n  {one.options()}  ({len(one.points)} runs, n {', '.join(map(str, one.sizes()))})" for one in every)


def chosen_series(options):
    """In order of their names. Says what is left out."""
    found, zeros, inexact, limited = {}, 0, 0, 0
    for run, value in kinex.counters(options.results, options.counter):
        series = Series(run)
        series = found.setdefault((series.structure, series.workload, series.parameters), series)
        if run.arithmetic != "exact":
            inexact += is_chosen(series, options)
        elif run.status not in (None, "done"):
            limited += is_chosen(series, options)
        elif value > 0:
            series.points.append((run.objects, value))
        elif is_chosen(series, options):
            zeros += 1
    every = [found[key] for key in sorted(found) if len(found[key].sizes()) >= 2]
    chosen = [one for one in every if is_chosen(one, options)]
    if not every:
        left_out = ", ".join(f"{number} {what}" for number, what in (
            (zeros, f"with {options.counter} 0, which fit no power"), (limited, "that ended at a limit"),
            (inexact, "in other arithmetics than exact")) if number)
        raise kinex.ResultsError(f"{options.results}: no two exact runs with {options.counter} differ in n alone"
                                 + (f" (left out: {left_out})" if left_out else "")
                                 + "; run more sizes, to their end (kinex sweep, kinex verify), or take another counter")
    if not chosen:
        raise kinex.ResultsError(f"{options.results}: no series is chosen; its series are:{listed(every)}")
    if len(chosen) > MOST_SERIES:
        raise kinex.ResultsError(f"{options.results}: {len(chosen)} series, which are too many for one picture; choose "
                                 f"{MOST_SERIES} at most by --structure, --workload, --dimension, --degree, --parameter "
                                 f"from:{listed(chosen)}")
    small = sum(len(one.sizes()) == 1 and is_chosen(one, options) for one in found.values())
    for number, what, remedy in (
            (small, "series of a single n", "run more sizes of them (kinex sweep, kinex verify)"),
            (zeros, f"runs with {options.counter} 0, which has no logarithm", "larger sizes have more events"),
            (limited, "runs that ended at a limit", "their counts are those of a part of the motion"),
            (inexact, "runs in other arithmetics than exact", "their counts may be wrong")):
        if number:
            script.note(f"{options.results}: left out: {number} {what}; {remedy}")
    return chosen


def main():
    options = arguments()
    chosen = chosen_series(options)
    what = {"external": "external events", "processed": "events"}.get(options.counter, options.counter)
    workloads = sorted({one.workload for one in chosen})
    where = f" on {workloads[0]}" if len(workloads) == 1 else ""
    figure = Figure(f"Growth of the number of {what}{where}", Axis("objects n", log=True),
                    Axis(f"{what} of a run", log=True))
    for series in chosen:
        name = series.name()
        figure.points(name, series.points)
        fit = kinex.fit_power(series.points)
        error = "" if fit.error is None else f" \u00b1 {fit.error:.3f} (95 %)"
        power = f"n^{fit.exponent:.3f}".replace("^-0.000", "^0.000")
        print(f"{name}: {len(series.points)} runs, {options.counter} ~ {power}{error}")
        figure.line(f"{fit.factor:.3g} {power}{error}", [(n, fit(n)) for n in series.sizes()], like=name)
    figure.write(options.figure, options.results, options.force)


if __name__ == "__main__":
    script.run(main)
