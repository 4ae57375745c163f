# SPDX-License-Identifier: GPL-3.0-or-later
"""The viewer shows proofs by the roles, groups and figures that structures and predicates give.

usage: pure_viewer.py SOURCE_FOLDER PROGRAM

No file of experiments/view names a structure or a predicate, includes a structure's header, or takes a tag
or a slot of a certificate apart. The names are those of the built program's structures, and those that the
sources of predicates give.
"""
import pathlib
import re
import sys

from structure_names import structure_names

# A number that stands for a slot: "claims[4]", "slot === 2", "claims.length === 8".
SLOTS = re.compile(r"\b(?:claims|certificates|slots?)\w*\s*(?:\[\s*\d|\.length\s*[=!]==?\s*\d*[1-9]"
                   r"|(?:===?|!==?|<|>)\s*\d*[1-9])|\.tag\b")
HEADERS = re.compile(r'#include "structures/(?!plan|registry|parts/query_trace|parts/range_search|parts/local_pairs)[^"]*"')


def predicate_names(root):
    """From the sources: the program does not list them."""
    names = set()
    for file in sorted((root / "predicates").rglob("*.cpp")):
        for body in re.findall(r"\bname\(\) (?:const )?\{(.*?)\}", file.read_text(), re.S):
            names.update(re.findall(r'"(\w+)"', body))
    return names


def faults_in(text, names):
    for number, line in enumerate(text.split("\n"), 1):
        for name in re.findall(r"[A-Za-z0-9_]+", line):
            if name in names or name.rstrip("_") in names:
                yield number, name
        for match in SLOTS.findall(line) + HEADERS.findall(line):
            yield number, match


def main():
    root = pathlib.Path(sys.argv[1])
    names = predicate_names(root) | structure_names(sys.argv[2])
    for known in ("in_circle_2", "side_a"):
        if known not in names:
            sys.exit(f"{known} is not among the registered names: {sorted(names)}")
    assert list(faults_in('if (name === "in_circle_2") {', names))
    assert list(faults_in("claims[4].line;", names)) and list(faults_in("slot === 2", names))
    assert not list(faults_in("proofs.claims(pair)[slot].form", names))
    files = [f for f in sorted((root / "experiments" / "view").rglob("*"))
             if f.suffix in (".h", ".cpp", ".js", ".html", ".css")]
    if len(files) < 30:
        sys.exit(f"only {len(files)} files of the viewer: the check does not see the sources")
    faults = [f"{file}:{number}: {word}" for file in files
              for number, word in faults_in(file.read_text(encoding="utf-8"), names)]
    if faults:
        sys.exit("\n".join(faults) + "\nremedy: let the structure or the predicate say it as data")
    print(f"{len(files)} files of the viewer, none of {len(names)} names")


main()
