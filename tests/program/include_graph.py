# SPDX-License-Identifier: GPL-3.0-or-later
"""The include graph of the project's rooms, the folders of the second level (of the third in
experiments/families), has no cycle, and is the one that is drawn; a file includes only rooms that its target links.

usage: include_graph.py SOURCE_FOLDER [--draw | --links FILE]

A file that lies directly in a folder of the first level belongs to that folder's hall (core, predicates,
..). --draw writes experiments/pictures/rooms.dot, and rooms.svg by graphviz; without it the former must be
what would be written, and the latter must have its rooms and arrows.

--links compares the includes with FILE, which CMake writes (kinex_write_links, experiments/packaging/rooms.cmake):
the library of every room that a file includes is linked by the target of the file, itself or through others, and
libraries do not link each other in a circle. A header belongs to the library of its room; a room without one
(benchmarks) has several targets, and its headers are held to each that includes them (to each of all if none does). A
hall without sources declares what its rooms define (predicates/predicates.h): its rooms may include it.
"""
import argparse
import collections
import html
import os
import pathlib
import re
import subprocess
import sys

FOLDERS = ("core", "predicates", "structures", "experiments")
PICTURE = "experiments/pictures/rooms"  # .dot and .svg


DEEP = ("experiments/families",)  # its folders are rooms of their own


def room_of(path):
    folders = path.split("/")[:-1]
    return "/".join(folders[:3 if "/".join(folders[:2]) in DEEP else 2])


def included_files(source):
    """{file: files of the project that it includes}."""
    included = {}
    for folder in FOLDERS:
        for path in sorted((source / folder).rglob("*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            file = path.relative_to(source).as_posix()
            included[file] = {other for other in re.findall(r'(?m)^#include "([^"]+/[^"]+)"', path.read_text())
                              if (source / other).exists()}
    return included


def included_rooms(included):
    """{file: rooms that it includes}, its own left out, of included_files."""
    return {file: {room_of(other) for other in others} - {room_of(file)} for file, others in included.items()}


def reached_in_room(sources, included):
    """The files that sources include, themselves or through files of their own rooms; sources too."""
    found, left = set(), list(sources)
    while left:
        file = left.pop()
        if file not in found:
            found.add(file)
            left += [other for other in included.get(file, ()) if room_of(other) == room_of(file)]
    return found


def include_graph(files):
    """{room: rooms that its files include}."""
    graph = {}
    for file, rooms in files.items():
        graph.setdefault(room_of(file), set()).update(rooms)
    return graph


def find_cycle(graph):
    """[room, .., the same room] or None."""
    done, path = set(), []

    def visit(room):
        if room in path:
            return path[path.index(room):] + [room]
        if room in done:
            return None
        path.append(room)
        for other in sorted(graph.get(room, ())):
            cycle = visit(other)
            if cycle:
                return cycle
        path.pop()
        done.add(room)
        return None

    for room in sorted(graph):
        cycle = visit(room)
        if cycle:
            return cycle
    return None


def without_shortcuts(graph):
    """The same order with fewest edges: an edge that a longer way stands for is left out."""
    reach = {}

    def reachable(room):
        if room not in reach:
            reach[room] = set()
            for other in graph.get(room, ()):
                reach[room] |= {other} | reachable(other)
        return reach[room]

    return {room: {a for a in below if not any(a in reachable(b) for b in below if b != a)}
            for room, below in graph.items()}


def text_of(graph):
    """The graph for `dot`: every room above all that it includes."""
    lines = ["digraph rooms {", '  graph [rankdir="TB"];',
             '  node [shape="box", style="rounded,filled", fillcolor="#f4f4f0", fontname="sans"];',
             '  edge [color="#777777"];']
    lines += [f'  "{room}";' for room in sorted(graph)]
    for room, below in sorted(without_shortcuts(graph).items()):
        lines += [f'  "{room}" -> "{other}";' for other in sorted(below)]
    return "\n".join(lines + ["}"]) + "\n"


def drawn_in(svg):
    """The names of the rooms and arrows of a picture by graphviz, as they are in text_of."""
    titles = re.findall(r'class="(?:node|edge)">\s*<title>([^<]*)</title>', svg)
    return {" -> ".join(f'"{end}"' for end in html.unescape(title).split("->")) for title in titles}


class Target:
    """A line of kinex_write_links."""

    def __init__(self, line, source):
        self.name, self.room, folder, sources, links, passed_on = line.split("|")
        paths = [os.path.relpath(os.path.join(folder, path), source) for path in sources.split(";") if path]
        self.sources = {pathlib.PurePath(path).as_posix() for path in paths}
        self.links, self.passed_on = ({re.sub(r"^\$<LINK_ONLY:(.*)>$", r"\1", link) for link in some.split(";") if link}
                                      for some in (links, passed_on))


def linked_by(target, targets):
    """The names of all targets that it links, itself or through others."""
    found, left = set(), list(target.links | target.passed_on)
    while left:
        name = left.pop()
        if name in targets and name not in found:
            found.add(name)
            left += targets[name].passed_on
    return found


def wrong_links(included, lines, source):
    """Faults: one sentence for each file that includes a room which its target does not link, and for each circle."""
    files = included_rooms(included)
    targets = {target.name: target for target in (Target(line, source) for line in lines)}
    links = {name: linked_by(target, targets) for name, target in targets.items()}
    library = {target.room: target.name for target in targets.values() if target.room}
    owners = collections.defaultdict(set)  # of a source, and of a room without a library and its headers
    for target in targets.values():
        for file in target.sources:
            owners[file].add(target.name)
            if room_of(file) not in library:
                owners[room_of(file)].add(target.name)
        for file in reached_in_room({file for file in target.sources if room_of(file) not in library}, included):
            owners[file].add(target.name)
    cycle = find_cycle({name: {other for other in target.links | target.passed_on if other in targets}
                        for name, target in targets.items()})
    if cycle:
        yield "libraries link each other in a circle: " + " -> ".join(cycle)
    for file, rooms in files.items():
        own = {library[room_of(file)]} if room_of(file) in library else owners[room_of(file)]
        for target in sorted(owners.get(file) or own):
            for room in sorted(rooms):
                if room not in library:
                    yield f"{file} includes {room}, which is no library"
                elif library[room] not in links[target] and not (
                        target in links[library[room]] and not targets[library[room]].sources):
                    yield f"{file} includes {room}, which {target} does not link"


def check_links():
    """The check itself, on four rooms: c links b links a, and the hall h has both."""
    lines = ["a|s/a|/p/s|/p/out/batch.cpp|options|options", "b|s/b|/p/s|/p/out/b.cpp|a|$<LINK_ONLY:a>",
             "c|s/c|/p/s|/p/out/c.cpp|b|b", "h|s|/p/s||a;b|a;b", "run||/p/s/bench|c.cpp|c|"]

    def faults(files, more=()):
        return list(wrong_links(files, [*lines, *more], "/p"))

    assert not faults({"s/c/x.h": {"s/a/y.h", "s/b/y.h"}, "s/b/x.cpp": {"s/a/y.h", "s/y.h"},
                       "s/bench/c.cpp": {"s/a/y.h", "s/c/y.h"}})
    assert faults({"s/b/x.cpp": {"s/c/y.h"}}) == ["s/b/x.cpp includes s/c, which b does not link"]
    assert faults({"s/bench/c.h": {"s/y.h"}}) == ["s/bench/c.h includes s, which run does not link"]
    assert faults({"s/c/x.h": {"s/bench/y.h"}}) == ["s/c/x.h includes s/bench, which is no library"]
    # A second target of the benchmarks includes one of the two headers, through the other.
    both = ["two||/p/s/bench|d.cpp||"]
    headers = {"s/bench/c.cpp": {"s/bench/c.h"}, "s/bench/c.h": {"s/a/y.h"}}
    assert not faults({**headers, "s/bench/d.cpp": {"s/bench/d.h"}, "s/bench/d.h": set()}, both)
    assert faults({**headers, "s/bench/d.cpp": {"s/bench/d.h"}, "s/bench/d.h": {"s/bench/c.h"}}, both) == [
        "s/bench/c.h includes s/a, which two does not link"]
    assert len(faults({"s/bench/c.h": {"s/b/y.h", "s/a/y.h"}}, both)) == 2
    assert faults({}, ["d|s/d|/p/s|d/d.cpp||e", "e|s/e|/p/s|e/e.cpp|d|"]) == [
        "libraries link each other in a circle: d -> e -> d"]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("--draw", action="store_true")
    parser.add_argument("--links", type=pathlib.Path)
    options = parser.parse_args()
    assert find_cycle({"a": {"b"}, "b": {"c"}, "c": {"a"}}) == ["a", "b", "c", "a"]
    assert find_cycle({"a": {"b", "c"}, "b": {"c"}}) is None
    assert drawn_in('<g class="node">\n<title>a/b</title></g><g class="edge">\n<title>a/b&#45;&gt;c</title>'
                    ) == {'"a/b"', '"a/b" -> "c"'}
    check_links()
    included = included_files(options.source)
    graph = include_graph(included_rooms(included))
    cycle = find_cycle(graph)
    if cycle:
        sys.exit("the rooms include each other in a circle: " + " -> ".join(cycle))
    drawn = options.source / (PICTURE + ".dot")
    if options.draw:
        drawn.write_text(text_of(graph))
        subprocess.run(["dot", "-Tsvg", "-o", drawn.with_suffix(".svg"), drawn], check=True)
    elif not drawn.exists() or drawn.read_text() != text_of(graph):
        sys.exit(f"{PICTURE}.dot is not the graph of today: draw it again with --draw, and look at it")
    wanted = set(re.findall(r'(?m)^  (".*);$', text_of(graph)))
    pictured = drawn_in(drawn.with_suffix(".svg").read_text())
    if wanted != pictured:
        sys.exit(f"{PICTURE}.svg is not the graph of today, for {sorted(wanted ^ pictured)}: draw it again with --draw")
    if options.links:
        lines = options.links.read_text().splitlines()
        faults = list(wrong_links(included, lines, options.source.resolve()))
        if faults:
            sys.exit("\n".join(faults) + "\nremedy: include another room, or link it in CMakeLists.txt")
        if len(lines) < len(graph):
            sys.exit(f"{options.links} has {len(lines)} targets for {len(graph)} rooms: the check does not see them")
    print(f"{len(graph)} rooms, no circle")


if __name__ == "__main__":
    main()
