# SPDX-License-Identifier: GPL-3.0-or-later
"""The include graph of the project's rooms, the folders of the second level (of the third in
experiments/families), has no cycle, and is the one that is drawn.

usage: include_graph.py SOURCE_FOLDER [--draw]

A file that lies directly in a folder of the first level belongs to that folder's hall (core, predicates,
..). --draw writes experiments/pictures/rooms.dot, and rooms.svg by graphviz; without it the former must be
what would be written, and the latter must have its rooms and arrows.
"""
import argparse
import html
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


def include_graph(source):
    """{room: rooms that its files include}, itself left out."""
    graph = {}
    for folder in FOLDERS:
        for file in sorted((source / folder).rglob("*")):
            if file.suffix not in (".h", ".cpp"):
                continue
            room = room_of(file.relative_to(source).as_posix())
            rooms = graph.setdefault(room, set())
            for included in re.findall(r'(?m)^#include "([^"]+/[^"]+)"', file.read_text()):
                if (source / included).exists() and room_of(included) != room:
                    rooms.add(room_of(included))
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


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("--draw", action="store_true")
    options = parser.parse_args()
    assert find_cycle({"a": {"b"}, "b": {"c"}, "c": {"a"}}) == ["a", "b", "c", "a"]
    assert find_cycle({"a": {"b", "c"}, "b": {"c"}}) is None
    assert drawn_in('<g class="node">\n<title>a/b</title></g><g class="edge">\n<title>a/b&#45;&gt;c</title>'
                    ) == {'"a/b"', '"a/b" -> "c"'}
    graph = include_graph(options.source)
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
    print(f"{len(graph)} rooms, no circle")


if __name__ == "__main__":
    main()
