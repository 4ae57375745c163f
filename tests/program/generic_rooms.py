# SPDX-License-Identifier: GPL-3.0-or-later
"""No generic file names a family: the rooms of experiments/ that all families share neither include
a file of one, nor hold the name of a structure as a string of its own. The list of families is the
only exception.

usage: generic_rooms.py SOURCE_FOLDER
"""
import pathlib
import re
import sys

GENERIC = ("formats", "lab", "sweep", "verify", "trade", "reproduce", "verbs")
LIST = "experiments/families/families.cpp"


def structure_names(source):
    """Of the descriptors: the strings in structures/*/family.cpp that look like names."""
    names = set()
    for file in (source / "structures").glob("*/family.cpp"):
        names |= set(re.findall(r'"((?:[a-z]+_)+[a-z0-9_]+)"', file.read_text()))
    return names


def problems_of(text, names, families):
    """What a generic file must not hold, one sentence each."""
    code = re.sub(r"//[^\n]*", "", text)
    problems = []
    for included in re.findall(r'(?m)^#include "([^"]+)"', code):
        folders = included.split("/")
        if folders[:2] == ["experiments", "families"] or (
                folders[0] == "structures" and len(folders) > 2 and folders[1] in families):
            problems.append(f"includes {included}")
    problems += [f'names "{name}"' for name in re.findall(r'"([^"\n]*)"', code) if name in names]
    return problems


def main():
    source = pathlib.Path(sys.argv[1])
    names = structure_names(source)
    families = {file.parent.name for file in (source / "structures").glob("*/family.h")}
    assert {"sorted_list", "delaunay_2", "separation_mixed"} <= names, names
    assert families == {file.parent.name for file in (source / "experiments/families").glob("*/family.h")
                        } - {"points"}, families
    assert problems_of('#include "structures/order/sorted_list.h"\n', names, families)
    assert problems_of('x = "delaunay_2";\n', names, families)
    assert not problems_of('#include "structures/registry.h"\n// "delaunay_2"\n', names, families)
    failed = False
    for room in GENERIC:
        for file in sorted((source / "experiments" / room).glob("*")):
            if file.suffix not in (".h", ".cpp"):
                continue
            for problem in problems_of(file.read_text(), names, families):
                print(f"{file.relative_to(source)}: {problem}")
                failed = True
    listed = re.findall(r'"experiments/families/(\w+)/family.h"', (source / LIST).read_text())
    if set(listed) != families | {"points"}:
        print(f"{LIST} lists {sorted(listed)}, there are {sorted(families)}")
        failed = True
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
