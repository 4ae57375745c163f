# SPDX-License-Identifier: GPL-3.0-or-later
"""No generic file names a family: the rooms of experiments/ that all families share neither include a file
of one, nor have the name of a structure in their code or strings, examples in help texts included (they take
one from the families). The list of families is the only exception. Benchmarks hold no name of a workload
either.

The same goes for the second program, experiments/logcheck, apart from what its families bring: their replays, their
definitions by brute force, and the tables of both; and for experiments/families/points, whose scenes all structures of
points share, apart from FAMILIES_IN_POINTS.

usage: generic_rooms.py SOURCE_FOLDER PROGRAM
"""
import pathlib
import re
import sys

from structure_names import structure_names

GENERIC = ("formats", "lab", "sweep", "verify", "trade", "reproduce", "verbs", "view", "bench")
LIST = "experiments/families/families.cpp"
# What the families bring to the second program.
OF_FAMILIES = re.compile(r"(?:registry|families|replay_\w+|brute_\w+)\.py")
POINTS = "families/points"
FAMILIES_IN_POINTS = {
    # One section of a report, on structures of five families.
    "experiments/families/points/kds_section_9.cpp",
    # Named as the independent simulation names what it simulates, tests/oracles/uniform_means.
    "experiments/families/points/reference_means.cpp",
}
SUFFIXES = (".h", ".cpp", ".js", ".html", ".css")


def workload_names(source):
    """Each has a generator of its name, declared in a header of its family."""
    names = set()
    for file in (source / "experiments/families").glob("*/*.h"):
        names |= set(re.findall(r"void generate_(\w+)\(const lab::WorkloadParameters&", file.read_text()))
    return {name.replace("_", "-") for name in names}


def problems_of(text, names, families, workloads=frozenset(), own=()):
    """What a generic file must not hold, one sentence each. Workloads have names that may be words of
    a sentence: only a string of its own counts. `own`: families whose headers it may include."""
    return problems_of_code(re.sub(r"//[^\n]*", "", text), names, families, workloads, own)


def problems_of_python(text, names):
    """The same for a file of Python; comments and documentation may name structures."""
    code = re.sub(r'"""[\s\S]*?"""|#[^\n]*', "", text)
    return problems_of_code(code, names, ())


def problems_of_code(code, names, families, workloads=frozenset(), own=()):
    problems = []
    for included in re.findall(r'(?m)^#include "([^"]+)"', code):
        folders = included.split("/")
        if (folders[:2] == ["experiments", "families"] and folders[2] not in own) or (
                folders[0] == "structures" and len(folders) > 2 and folders[1] in families):
            problems.append(f"includes {included}")
    problems += [f"names {word}" for word in re.findall(r"\w+", code) if word in names]
    problems += [f'names "{name}"' for name in re.findall(r'"([^"\n]*)"', code) if name in workloads]
    return problems


def main():
    source, names = pathlib.Path(sys.argv[1]), structure_names(sys.argv[2])
    families = {file.parent.name for file in (source / "structures").glob("*/family.h")}
    assert families == {file.parent.name for file in (source / "experiments/families").glob("*/family.h")
                        } - {"points"}, families
    assert problems_of('#include "structures/order/sorted_list.h"\n', names, families)
    assert problems_of('x = "delaunay_2";\n', names, families)
    assert problems_of('"kinex verify calipers_2 --quick\\n"', names, families)
    assert not problems_of('#include "structures/registry.h"\n// "delaunay_2"\n', names, families)
    assert problems_of('#include "experiments/families/points/lines.h"\n', names, families)
    assert not problems_of('#include "experiments/families/points/lines.h"\n', names, families, own=("points",))
    assert problems_of('#include "experiments/families/hull/family.h"\n', names, families, own=("points",))
    assert problems_of_python('x = "delaunay_2"\n', names)
    assert not problems_of_python('"""delaunay_2\n"""\nx = 1  # "delaunay_2"\n', names)
    workloads = workload_names(source)
    assert {"uniform-square", "walks", "polygon-gears", "seesaw"} <= workloads, workloads
    assert problems_of('x = "walks";\n', names, families, workloads)
    assert not problems_of('"it walks"\n', names, families, workloads)
    failed, seen = False, 0
    for room in GENERIC:
        for file in sorted((source / "experiments" / room).rglob("*")):
            if file.suffix not in SUFFIXES:
                continue
            seen += 1
            for problem in problems_of(file.read_text(encoding="utf-8"), names, families,
                                       workloads if room == "bench" else frozenset()):
                print(f"{file.relative_to(source)}: {problem}")
                failed = True
    needed = set()  # of FAMILIES_IN_POINTS
    for file in sorted((source / "experiments" / POINTS).rglob("*")):
        if file.suffix not in SUFFIXES:
            continue
        seen += 1
        name = file.relative_to(source).as_posix()
        problems = problems_of(file.read_text(encoding="utf-8"), names, families, own=("points",))
        if problems and name in FAMILIES_IN_POINTS:
            needed.add(name)
            problems = [problem for problem in problems if problem.startswith("includes")]
        for problem in problems:
            print(f"{name}: {problem}")
            failed = True
    for name in sorted(FAMILIES_IN_POINTS - needed):
        print(f"{name} names no structure: take it from FAMILIES_IN_POINTS")
        failed = True
    checkers = [file for file in sorted((source / "experiments/logcheck").glob("*.py"))
                if not OF_FAMILIES.fullmatch(file.name)]
    for file in checkers:
        for problem in problems_of_python(file.read_text(encoding="utf-8"), names):
            print(f"{file.relative_to(source)}: {problem}")
            failed = True
    seen += len(checkers)
    if len(checkers) < 15:
        print(f"only {len(checkers)} files of the second program: the check does not see them")
        failed = True
    listed = re.findall(r'"experiments/families/(\w+)/family.h"', (source / LIST).read_text())
    if set(listed) != families | {"points"}:
        print(f"{LIST} lists {sorted(listed)}, there are {sorted(families)}")
        failed = True
    if seen < 300:
        print(f"only {seen} files: the check does not see the sources")
        failed = True
    if not failed:
        print(f"{seen} files, none of {len(names)} structures")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
