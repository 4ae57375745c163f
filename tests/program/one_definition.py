# SPDX-License-Identifier: GPL-3.0-or-later
"""No type is defined twice: two files that define one name in one namespace, both linked into a
program, break the one-definition rule, and no compiler says so.

usage: one_definition.py SOURCE_FOLDER

Looked at are classes, structs, unions, enumerations and inline functions at namespace scope, outside
unnamed namespaces, in the sources of the program and of each folder of tests.

One name means one thing, whatever namespace it is in: no two types at namespace scope have the same unqualified
name in the program. In experiments/, which has a namespace for every room, nor have one at namespace scope and one
within a class. (Types within two classes may: each is only ever named with its class.)
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
    r"|\b(?P<key>enum\s+class|enum|class|struct|union)\s+(?:alignas\([^()]*\)\s*|\[\[[^\]]*\]\]\s*)*"
    r"(?P<type>\w+)(?!\s*::)\s*"
    r"(?:final\s*)?(?::(?!:)[^;{}()]*)?\{"
    r"|\binline\s+(?:constexpr\s+)?(?P<result>[\w:<>,&*\s]+?)\s+[&*]?(?P<function>\w+)"
    r"\((?P<arguments>[^{};]*?)\)\s*(?:const|noexcept)?\s*\{"
    r"|[{}]")

# Names of two types of experiments/ that may stay, each with the reason.
SHARED_NAMES = {}


def scan(text):
    """(kind, qualified name, unqualified name) of what a file defines outside unnamed namespaces and bodies
    of functions; kinds: "type" and "function" at namespace scope, "part" for a type within a class."""
    text = NOISE.sub(" ", text)
    scopes = []  # of every open brace: (kind, name); kinds: "namespace", "class", "other"
    for token in TOKEN.finditer(text):
        if token.group() == "}":
            if scopes:
                scopes.pop()
            continue
        seen = all(kind != "other" and name for kind, name in scopes)
        within_class = any(kind == "class" for kind, _ in scopes)
        where = "".join(name + "::" for _, name in scopes)
        if token["space"] is not None:
            scopes.append(("namespace", token["space"].strip()))
            continue
        scopes.append(("class", token["type"]) if token["type"] else ("other", ""))
        if not seen:
            continue
        if token["type"]:
            yield "part" if within_class else "type", where + token["type"], token["type"]
        elif token["function"] and not within_class:
            name = f"{token['function']}({' '.join(token['arguments'].split())})"
            yield "function", where + name, name


def definitions(text):
    """The names that a file defines at namespace scope, qualified."""
    return [name for kind, name, _ in scan(text) if kind != "part"]


def shared_names(files, shared, parts=True):
    """Faults: unqualified names of two types, and names of `shared` that are not. `parts`: of types within
    classes, too, beside one at namespace scope."""
    types = collections.defaultdict(set)  # unqualified name: (kind, qualified name, file)
    for name, text in files:
        for kind, qualified, unqualified in scan(text):
            if kind == "type" or (parts and kind == "part"):
                types[unqualified].add((kind, qualified, name))
    twice = {name: sorted(where) for name, where in types.items()
             if len({qualified for _, qualified, _ in where}) > 1 and any(kind == "type" for kind, _, _ in where)}
    for name, where in sorted(twice.items()):
        if name not in shared:
            places = " and ".join(f"{qualified} ({file})" for _, qualified, file in where)
            yield f"{name} is the name of different things: {places}"
    for name in sorted(set(shared) - set(twice)):
        yield f"{name} is listed as shared, and is not"


@functools.cache
def definitions_in(file):
    return tuple(definitions(file.read_text()))


def check_itself():
    sample = """
    namespace a { namespace b { struct S final : T<int> { struct Inner {}; }; } enum class E { k }; }
    namespace { class Hidden {}; }
    namespace a { struct alignas(64) Line {}; class [[nodiscard]] Sign final {}; }
    namespace a::b { class C; struct Outer::Part {}; inline int f(int x) { struct Local {}; return x; } }
    const char* text = "struct Quoted {"; // struct Comment {
    """
    found = list(definitions(sample))
    expected = ["a::b::S", "a::E", "a::Line", "a::Sign", "a::b::f(int x)"]
    if found != expected:
        sys.exit(f"the check is wrong: found {found}, expected {expected}")
    files = [("x.h", sample), ("y.h", "namespace c { class E {}; struct P { enum class S { k }; struct Q {}; }; }"),
             ("z.h", "namespace d { struct R { struct Q {}; }; }")]
    faults = [fault.split(" ")[0] for fault in shared_names(files, {})]
    if faults != ["E", "S"] or list(shared_names(files, {"E": "why", "S": "why"})):
        sys.exit(f"the check is wrong: {faults} have shared names")
    if [fault.split(" ")[0] for fault in shared_names(files, {}, parts=False)] != ["E"]:
        sys.exit("the check is wrong: types within classes count")
    if [fault.split(" ")[0] for fault in shared_names([], {"E": "why"})] != ["E"]:
        sys.exit("the check is wrong: a name that is no longer shared stays listed")


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
    texts = [(str(file.relative_to(root)), file.read_text()) for file in program if file.suffix in (".h", ".cpp")]
    faults.update(shared_names([one for one in texts if one[0].startswith("experiments/")], SHARED_NAMES))
    faults.update(shared_names(texts, {}, parts=False))
    if len(names) < 200:
        sys.exit(f"only {len(names)} definitions found: the check does not see the sources")
    if faults:
        sys.exit("\n".join(sorted(faults)) +
                 "\nremedy: another name, a namespace for the folder, or an unnamed namespace")
    print(f"{len(names)} types and inline functions, each defined once")


main()
