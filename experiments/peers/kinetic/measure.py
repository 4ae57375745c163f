#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Times kinetic lists of kinex beside that of CGAL's dropped packages for kinetic data structures.

usage: measure.py HEADERS [--kinex PROGRAM] [--rounds N] [--smoke]
HEADERS: a folder with CGAL/Kinetic and the CGAL/Polynomial that belongs to it, of CGAL 4.8 to 4.13; all
else is taken from the CGAL that is installed. The scenes are those of `kinex gen uniform-square`, whose
numbers are small integers over a power of two, and random ones whose coefficients are any doubles. Both
programs run the same motions in turn, on one core; the best CPU time of the rounds counts, without
set-up. Prints one line a scene:

  numbers degree n   events of kinex, of the peer   seconds of exact, double, peer   peer/exact   last

The events of `exact` are right; the peer's differ where it misses some, or tells some twice. Near the end of
its time its root finder loses roots from degree 3 on. So it runs twice, with that end at the end of the scene
and with twice the time; the faster one counts of those whose points are in order at the end. "last" is
its end.
Exit code: 0, 1 if `exact` is not ahead somewhere, 2 for a wrong call.
"""
import argparse
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile
from fractions import Fraction

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent.parent
# (degree, n)
SIZES = [(1, 4000), (2, 2000), (3, 2000)]
SMOKE = [(1, 60), (2, 60), (3, 60)]


def compile_peer(headers, folder):
    """Optimised as kinex is."""
    program = folder / "list"
    subprocess.run(["g++", "-std=gnu++17", "-O3", "-DNDEBUG", "-w", f"-I{headers}", str(HERE / "list.cpp"),
                    "-o", str(program), "-lgmp", "-lmpfr"], check=True)
    return program


def doubles(degree, n):
    """Motions with coefficients of 53 bits."""
    draw = random.Random(1)
    return [[draw.random()] + [draw.uniform(-1, 1) for _ in range(degree)] for _ in range(n)]


def small_numbers(kinex, degree, n):
    """The x of `kinex gen uniform-square`; its coefficients are doubles."""
    done = subprocess.run([kinex, "gen", "uniform-square", "--n", str(n), "--degree", str(degree), "--seed", "1",
                           "-o", "-"], check=True, capture_output=True, text=True)
    motions = []
    for thing in json.loads(done.stdout)["objects"]:
        exact = [Fraction(c) for c in thing["motion"][0]]
        motions.append([float(c) for c in exact])
        assert [Fraction(c) for c in motions[-1]] == exact, "a coefficient is no double"
    return motions


def write(folder, motions, degree):
    """The same motions for both programs."""
    scene = {"kinex": 1, "name": "list", "dimension": 1, "time": {"start": 0, "end": 1},
             "objects": [{"id": f"p{i}", "motion": [[str(Fraction(c)) for c in m]]} for i, m in enumerate(motions)],
             "maintain": ["sorted_list"]}
    (folder / "scene.json").write_text(json.dumps(scene), encoding="utf-8")
    lines = [f"{len(motions)} {degree}"]
    lines += [" ".join(repr(c) for c in m + [0.0] * (degree + 1 - len(m))) for m in motions]
    (folder / "scene.txt").write_text("\n".join(lines) + "\n", encoding="utf-8")


def run_kinex(kinex, folder, arithmetic):
    """(events, CPU seconds)."""
    done = subprocess.run([kinex, "run", str(folder / "scene.json"), "--arithmetic", arithmetic, "--audit", "none",
                           "--json"], check=True, capture_output=True, text=True)
    summary = json.loads(done.stdout)
    return summary["events"], summary["seconds"]["simulate"]


def run_peer(program, folder, last):
    """(events, CPU seconds), the latter infinite if its points are out of order at the end."""
    done = subprocess.run([program, str(folder / "scene.txt"), "1", str(last)], check=True, capture_output=True, text=True)
    events, seconds, out_of_order = done.stdout.split()
    return int(events), float(seconds) if out_of_order == "0" else float("inf")


def run(way, kinex, peer, folder):
    """(events, CPU seconds) of an arithmetic of kinex, or of the peer with its end at this number."""
    return run_peer(peer, folder, way) if isinstance(way, int) else run_kinex(kinex, folder, way)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("headers", type=pathlib.Path)
    parser.add_argument("--kinex", default=str(ROOT / "build-tests" / "experiments" / "kinex"))
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--smoke", action="store_true", help="tiny scenes, which tell nothing about time")
    options = parser.parse_args()
    if not (options.headers / "CGAL" / "Kinetic" / "Sort.h").is_file():
        print(f"measure.py: {options.headers} has no CGAL/Kinetic/Sort.h: name the folder include of CGAL 4.8 to 4.13",
              file=sys.stderr)
        return 2
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    behind = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        peer = compile_peer(options.headers, folder)
        print("numbers  degree     n     exact      peer   exact s  double s    peer s  peer/exact  last")
        for numbers in ("small", "doubles"):
            for degree, n in SMOKE if options.smoke else SIZES:
                small = numbers == "small"
                write(folder, small_numbers(options.kinex, degree, n) if small else doubles(degree, n), degree)
                best = {}
                for _ in range(options.rounds):
                    for way in ("exact", "double", 1, 2):
                        done = run(way, options.kinex, peer, folder)
                        best[way] = min(best.get(way, done), done, key=lambda r: r[1])
                last = min((1, 2), key=lambda way: best[way][1])
                ratio = best[last][1] / best["exact"][1]
                behind += ratio < 1
                print(f"{numbers:8s} {degree:6d} {n:5d} {best['exact'][0]:9d} {best[last][0]:9d}"
                      f" {best['exact'][1]:9.4f} {best['double'][1]:9.4f} {best[last][1]:9.4f} {ratio:11.2f} {last:5d}")
                sys.stdout.flush()
    return 1 if behind and not options.smoke else 0


if __name__ == "__main__":
    sys.exit(main())
