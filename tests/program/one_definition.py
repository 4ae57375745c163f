# SPDX-License-Identifier: GPL-3.0-or-later
"""No type is defined twice: two files that define one name in one namespace, both linked into a
program, break the one-definition rule, and no compiler says so.

usage: one_definition.py SOURCE_FOLDER

Looked at are classes, structs, unions, enumerations and inline functions at namespace scope, outside
unnamed namespaces, in the sources of the program and of each folder of tests.
"""
import collections
import functools
import pathlib
import re
import sys

NOISE = re.compile(
    r'R"(\w*)\(.*?\)\1"'                # raw strings
    r"|//[^\n]*|/\*.*?\*/"               # comments
    r'|"(?:\\.|[^"\\\n])*"'              # strings
    r"|(?<![0-9A-Za-z_])'(?:\\.|[^'\\\n])+'"  # characters, not digit separators
    r"|^[ \t]*\#(?:[^\n]*\\\n)*[^\n]*",  # the preprocessor
    re.DOTALL | re.MULTILINE)
TOKEN = re.compile(
    r"\bnamespace\b(?P<space>\s*[\w:]*)\s*\{"
    r"|\b(?P<key>enum\s+class|enum|class|struct|union)\s+(?P<type>\w+)(?!\s*::)\s*"
    r"(?:final\s*)?(?::(?!:)[^;{}()]*)?\{"
    r"|\binline\s+(?:constexpr\s+)?(?P<result>[\w:<>,&*\s]+?)\s+[&*]?(?P<function>\w+)"
    r"\((?P<arguments>[^{};]*?)\)\s*(?:const|noexcept)?\s*\{"
    r"|[{}]")


def definitions(text):
    """The names that a file defines at namespace scope, qualified."""
    text = NOISE.sub(" ", text)
    scopes = []  # of every open brace: a namespace's name, or None
    for token in TOKEN.finditer(text):
        if token.group() == "}":
            if scopes:
                scopes.pop()
            continue
        open_scope = all(scopes)  # neither in braces of something else nor in an unnamed namespace
        where = "::".join(scopes) + "::" if open_scope and scopes else ""
        if token["space"] is not None:
            scopes.append(token["space"].strip())
            continue
        scopes.append(None)
        if not open_scope:
            continue
        if token["type"]:
            yield where + token["type"]
        elif token["function"]:
            yield f"{where}{token['function']}({' '.join(token['arguments'].split())})"


@functools.cache
def definitions_in(file):
    return tuple(definitions(file.read_text()))


def check_itself():
    sample = """
    namespace a { namespace b { struct S final : T<int> { struct Inner {}; }; } enum class E { k }; }
    namespace { class Hidden {}; }
    namespace a::b { class C; struct Outer::Part {}; inline int f(int x) { struct Local {}; return x; } }
    const char* text = "struct Quoted {"; // struct Comment {
    """
    found = list(definitions(sample))
    expected = ["a::b::S", "a::E", "a::b::f(int x)"]
    if found != expected:
        sys.exit(f"the check is wrong: found {found}, expected {expected}")


def main():
    check_itself()
    root = pathlib.Path(sys.argv[1])
    folders = ["core", "predicates", "structures", "experiments"]
    program = [file for folder in folders for file in sorted((root / folder).rglob("*"))]
    programs = {"the program": program}
    for folder in sorted((root / "tests").iterdir()):
        if folder.is_dir():
            programs[f"tests/{folder.name}"] = program + sorted(folder.rglob("*"))
    faults, names = set(), set()
    for files in programs.values():
        places = collections.defaultdict(set)
        for file in files:
            if file.suffix not in (".h", ".cpp") or not file.is_file():
                continue
            for name in definitions_in(file):
                places[name].add(str(file.relative_to(root)))
        names.update(places)
        for name, where in places.items():
            if len(where) > 1:
                faults.add(f"{name} is defined in {' and in '.join(sorted(where))}")
    if len(names) < 200:
        sys.exit(f"only {len(names)} definitions found: the check does not see the sources")
    if faults:
        sys.exit("\n".join(sorted(faults)) +
                 "\nremedy: another name, a namespace for the folder, or an unnamed namespace")
    print(f"{len(names)} types and inline functions, each defined once")


main()
