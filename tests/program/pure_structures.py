# SPDX-License-Identifier: GPL-3.0-or-later
"""Structures are combinatorics: they ask the kernel, and see no numbers.

usage: pure_structures.py SOURCE_FOLDER

No file in structures/ reaches through the kernel to an arithmetic or a queue, and none names a polynomial,
a rational number or a double, but for audits, bounds, makers, and the geometry of rigid bodies that is listed here.
"""
import pathlib
import re
import sys

REACHING = re.compile(r"\b(Arithmetic|EventQueue|Scheduler|SignNow|arithmetic\(\)|queue\(\))")
NUMBERS = re.compile(r"\b(Polynomial|Rational|double|float)\b")
# Audits and bounds have to compute.
COMPUTING = re.compile(r"(_audit|_bounds|key_value)\b")
# The frames of bodies: polygons, hierarchies and radii are numbers that do not move.
FRAMES = {"body_frames", "body_grid", "body_volumes", "outer_hierarchy", "outer_hierarchy_cuts",
          "separation_hysteresis"}
# The lines of a grid, and the box around all flights: numbers that do not move.
GRIDS = {"point_grid"}
# An audit needs the end of the scene, or a box.
AUDITED = {"maximum_envelope", "range_structure"}
# Descriptors and makers: the parameters of a request are numbers.
MAKERS = {"descriptor", "registry", "family"}
# The plan is no structure: it makes the arithmetic for what the structures declare, and reads parameters, too.
PLAN = {"plan"}
NOISE = re.compile(r'"(?:\\.|[^"\\\n])*"|//[^\n]*')


def faults_in(name, text):
    text = NOISE.sub(lambda m: '""' if m[0][0] == '"' else "", text)
    for number, line in enumerate(text.split("\n"), 1):
        for word in REACHING.findall(line):
            if name not in PLAN:
                yield number, word
        if COMPUTING.search(name) or name in FRAMES | GRIDS | AUDITED | MAKERS | PLAN:
            continue
        for word in NUMBERS.findall(line):
            yield number, word


def main():
    assert list(faults_in("list", "int a;\nkernel_->queue().top();")) == [(2, "queue()")]
    assert list(faults_in("list", 'x(); // a double\ndouble y = 1;')) == [(2, "double")]
    assert not list(faults_in("list_audit", "Rational x;"))
    root = pathlib.Path(sys.argv[1]) / "structures"
    files = [f for f in sorted(root.rglob("*")) if f.suffix in (".h", ".cpp")]
    if len(files) < 50:
        sys.exit(f"only {len(files)} files in {root}: the check does not see the sources")
    faults = [f"{file}:{number}: {word}" for file in files
              for number, word in faults_in(file.stem, file.read_text())]
    if faults:
        sys.exit("\n".join(faults) + "\nremedy: ask the kernel, or put it into a predicate")
    print(f"{len(files)} files of structures, no arithmetic, no queue")


main()
