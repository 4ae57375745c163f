# SPDX-License-Identifier: GPL-3.0-or-later
"""The reference means that verify and reproduce compare with are what the simulation prints. The short ones
are made again; all of them with --all.

usage: reference_means.py UNIFORM_MEANS SOURCE_FOLDER [--all]
"""
import pathlib
import re
import subprocess
import sys

SHORT = 3e6  # n times n times seeds: seconds in all


def main():
    simulation, source = sys.argv[1], pathlib.Path(sys.argv[2])
    text = (source / "experiments/families/points/reference_means.cpp").read_text()
    rows = re.findall(r'\{"(\w+)", (\d+), (\d+), ([-\d.e+]+), ([-\d.e+]+)\}', text)
    assert len(rows) >= 13, len(rows)
    compared = 0
    for what, n, seeds, mean, error in rows:
        if "--all" not in sys.argv and int(n) ** 2 * int(seeds) > SHORT:
            continue
        printed = subprocess.run([simulation, what, n, seeds], capture_output=True, text=True, check=True).stdout
        assert printed.split() == [what, n, seeds, mean, error], (printed, mean, error)
        compared += 1
    assert compared >= 4, compared
    print(f"{compared} of {len(rows)} means are what the simulation prints")


main()
