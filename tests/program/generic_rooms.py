# SPDX-License-Identifier: GPL-3.0-or-later
"""No generic file names a family: the rooms of experiments/ that all families share neither include a file
of one, nor have the name of a structure in their code or strings, examples in help texts included (they take
one from the families). The list of families is the only exception. Benchmarks hold no name of a workload
either.

usage: generic_rooms.py SOURCE_FOLDER PROGRAM
"""
import pathlib
import re
import sys

from structure_names import structure_names

GENERIC = ("formats", "lab", "sweep", "verify", "trade", "reproduce", "verbs", "view", "bench")
LIST = "experiments/families/families.cpp"
SUFFIXES = (".h", ".cpp", ".js", ".html", ".css")


def workload_names(source):
    """Each has a generator of its name, declared in a header of its family."""
    names = set()
    for file in (source / "experiments/families").glob("*/*.h"):
        names |= set(re.findall(r"void generate_(\w+)\(const lab::WorkloadParameters&", file.read_text()))
    return {name.replace("_", "-") for name in names}


def problems_of(text, names, families, workloads=frozenset()):
    """What a generic file must not hold, one sentence each. Workloads have names that may be words of
    a sentence: only a string of its own counts."""
    code = re.sub(r"//[^\n]*", "", text)
    problems = []
    for included in re.findall(r'(?m)^#include "([^"]+)"', code):
        folders = included.split("/")
        if folders[:2] == ["experiments", "families"] or (
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
