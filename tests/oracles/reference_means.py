# SPDX-License-Identifier: GPL-3.0-or-later
"""The reference means that verify and reproduce compare with are what the simulation prints. The short ones
are made again; all of them with --all.

usage: reference_means.py UNIFORM_MEANS SOURCE_FOLDER [--all]
"""
import math
import pathlib
import re
import subprocess
import sys

SHORT = 2e6  # n times n times seeds, or sets of points times seeds: seconds in all
POINTS = {"regular_2": 4, "delaunay_3": 5, "regular_3": 5}  # simulations that go through all sets of so many


def work(what, n, seeds):
    return seeds * (math.comb(n, POINTS[what]) if what in POINTS else n * n)


def main():
    simulation, source = sys.argv[1], pathlib.Path(sys.argv[2])
    text = (source / "experiments/families/points/reference_means.cpp").read_text()
    rows = re.findall(r'\{"(\w+)", (\d+), (\d+), ([-\d.e+]+), ([-\d.e+]+)\}', text)
    assert len(rows) >= 13, len(rows)
    compared = 0
    for what, n, seeds, mean, error in rows:
        if "--all" not in sys.argv and work(what, int(n), int(seeds)) > SHORT:
            continue
        printed = subprocess.run([simulation, what, n, seeds], capture_output=True, text=True, check=True).stdout
        assert printed.split() == [what, n, seeds, mean, error], (printed, mean, error)
        compared += 1
    assert compared >= 7, compared
    print(f"{compared} of {len(rows)} means are what the simulation prints")


main()
