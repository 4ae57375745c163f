# SPDX-License-Identifier: GPL-3.0-or-later
"""Nothing is defined twice: two files that define one name in one namespace, both linked into a program, break the
one-definition rule, and no compiler says so.

usage: one_definition.py SOURCE_FOLDER

Looked at are classes, structs, unions, enumerations, concepts, and functions that are inline, constexpr or templates
at namespace scope, outside unnamed namespaces, in the sources of the program and of each folder of tests. (Two other
functions of one name the linker refuses.) Functions are told apart by what makes overloads different: the parameters of
their templates with their concepts, the types of their arguments and what follows these; names of parameters do not
count.

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
    r"|\bconcept\s+(?P<concept>\w+)\s*="
    r"|[{}]")
SHARED_FUNCTION = re.compile(r"\b(?:inline|constexpr|consteval|template)\b")
BUILT_IN = set("auto bool char const double float int long short signed unsigned void".split())
OPENING, CLOSING = "(<[{", ")>]}"

# Names of two types of experiments/ that may stay, each with the reason.
SHARED_NAMES = {}


def closing(text, at):
    """The place after the bracket that closes that at text[at]; arrows close nothing."""
    depth = 0
    for i in range(at, len(text)):
        if text[i] in OPENING:
            depth += 1
        elif text[i] in CLOSING and text[i - 1:i + 1] not in ("->", "=>"):
            depth -= 1
            if depth == 0:
                return i + 1
    return len(text)


def split_at_commas(text):
    """What stands between the commas that are in no bracket, without default values."""
    parts, depth, begin = [], 0, 0
    for i, letter in enumerate(text + ","):
        if letter in OPENING:
            depth += 1
        elif letter in CLOSING:
            depth -= 1
        elif letter == "," and depth == 0:
            parts.append(" ".join(re.sub(r"(?<![=<>!])=(?!=).*", "", text[begin:i], flags=re.DOTALL).split()))
            begin = i + 1
    return [part for part in parts if part]


def type_of(argument):
    """An argument without its name, if it has one."""
    named = re.fullmatch(r"(.*[\s&*>])(\w+)((?:\[.*\])?)", argument)
    if not named or named[2] in BUILT_IN or named[1].strip() in ("const", "class", "typename"):
        return argument
    return named[1].strip() + named[3]


def function_of(head):
    """The name and the signature of a function that may be defined in several files, from what stands before its
    body; None if it is another function, or none."""
    parameters, rest = [], head.strip()
    if not SHARED_FUNCTION.search(rest) or re.search(r"\bstatic\b", rest) or rest.count("(") != rest.count(")"):
        return None
    while template := re.match(r"template\s*<", rest):
        end = closing(rest, template.end() - 1)
        parameters += split_at_commas(rest[template.end():end - 1])
        rest = rest[end:].strip()
    if requires := re.match(r"requires\s*\(", rest):
        end = closing(rest, requires.end() - 1)
        parameters.append(rest[:end])
        rest = rest[end:].strip()
    rest = re.sub(r"\[\[.*?\]\]", " ", rest)
    named = re.match(r"[^(=]*?((?:[\w:]+(?:<[^()]*?>)?::)?(?:operator\s*(?:\(\)|[^\s(]+)|~?\w+(?:<[^()]*>)?))\s*\(", rest)
    if not named or re.search(r"\b(?:class|struct|union|enum)\s+\w+\s*(?::|$)", rest):
        return None
    end = closing(rest, named.end() - 1)
    arguments = [type_of(argument) for argument in split_at_commas(rest[named.end():end - 1])]
    after = re.sub(r"\bnoexcept\b|->.*|(?<!:):(?!:).*", "", rest[end:], flags=re.DOTALL)
    heads = f"<{', '.join(parameters)}>" if parameters else ""
    signature = " ".join(f"{''.join(named[1].split())}{heads}({', '.join(arguments)}) {after}".split())
    for place, parameter in enumerate(parameters):
        if name := re.fullmatch(r".*[\s.](\w+)", parameter):
            signature = re.sub(rf"\b{name[1]}\b", f"${place}", signature)
    return signature


def scan(text):
    """(kind, qualified name, unqualified name) of what a file defines outside unnamed namespaces and bodies
    of functions; kinds: "type" and "function" at namespace scope, "part" for a type within a class."""
    text = NOISE.sub(" ", text)
    scopes = []  # of every open brace: (kind, name); kinds: "namespace", "class", "other"
    begin = 0  # of what stands before the next brace at namespace scope
    for token in TOKEN.finditer(text):
        if token["concept"]:
            if all(kind == "namespace" and name for kind, name in scopes):
                yield "type", "".join(name + "::" for _, name in scopes) + token["concept"], token["concept"]
            continue
        if token.group() == "}":
            if scopes:
                scopes.pop()
            if text.count("(", begin, token.end()) == text.count(")", begin, token.end()):
                begin = token.end()  # else it ends a default value
            continue
        seen = all(kind != "other" and name for kind, name in scopes)
        within_class = any(kind == "class" for kind, _ in scopes)
        where = "".join(name + "::" for _, name in scopes)
        if token["space"] is not None:
            scopes.append(("namespace", token["space"].strip()))
            begin = token.end()
            continue
        scopes.append(("class", token["type"]) if token["type"] else ("other", ""))
        if not seen:
            continue
        if token["type"]:
            yield "part" if within_class else "type", where + token["type"], token["type"]
        elif not within_class:
            name = function_of(text[begin:token.start()].rpartition(";")[2])
            if name:
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
    namespace t {
    template <class T> concept Whole = requires(T a) { a.whole(); };
    template <class T> struct Box {}; template <class T> T Box<T>::get(int at) const { return {}; }
    constexpr int kList[] = {1, 2}; constexpr auto kCall = [](int x) { return x; }; inline std::vector<int> v(3);
    static constexpr int hidden() { return 1; } void linked(int x) { }
    constexpr bool odd(unsigned n = 3, const S& = S{1}) noexcept { return n % 2; }
    template <Whole T, class... More> inline std::pair<T, int> add(const std::vector<T>& all, More... more) { }
    }
    """
    found = list(definitions(sample))
    expected = ["a::b::S", "a::E", "a::Line", "a::Sign", "a::b::f(int)", "t::Whole", "t::Box",
                "t::Box<$0>::get<class $0>(int) const", "t::odd(unsigned, const S&)",
                "t::add<Whole $0, class... $1>(const std::vector<$0>&, $1...)"]
    if found != expected:
        sys.exit(f"the check is wrong: found {found}, expected {expected}")
    overloads = [function_of(head) for head in (
        "template <Claims C> bool in_front(Kernel& kernel, const C& claims, Item a)",
        "template <CasedClaims C> bool in_front(Kernel& kernel, const C& claims, Item a)",
        "template <Claims D> constexpr bool in_front(Kernel&, const D& others, Item b)")]
    if overloads[0] == overloads[1] or overloads[0] != overloads[2] or not overloads[0]:
        sys.exit(f"the check is wrong: overloads are {overloads}")
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
    print(f"{len(names)} types, concepts and shared functions, each defined once")


main()
