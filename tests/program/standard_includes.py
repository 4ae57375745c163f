# SPDX-License-Identifier: GPL-3.0-or-later
"""A file has the standard headers that it needs, without help of a precompiled header.

usage: standard_includes.py SOURCE_FOLDER

A name of the standard library counts as provided if its header is included by the file itself, or by a
header of the project that the file includes, directly or not. The check is about the headers that
experiments/packaging/precompile.cmake precompiles: the compiler would not miss what they provide.
"""
import functools
import pathlib
import re
import sys

FOLDERS = ("core", "predicates", "structures", "experiments", "tests")
# What says that a header is needed. Names that several headers provide are left out.
NAMES = {
    "algorithm": "sort stable_sort nth_element max_element min_element lower_bound upper_bound equal_range find_if "
                 "find_if_not any_of all_of none_of count_if remove_if reverse rotate unique is_sorted fill copy clamp "
                 "binary_search transform set_difference set_union includes partition for_each next_permutation shuffle",
    "array": "array", "cmath": "sqrt ldexp frexp isfinite isnan pow fma nextafter hypot floor ceil cbrt log2 exp2",
    "functional": "function invoke", "limits": "numeric_limits", "map": "map multimap",
    "memory": "unique_ptr shared_ptr make_unique make_shared weak_ptr", "optional": "optional nullopt make_optional",
    "span": "span", "stdexcept": "runtime_error invalid_argument logic_error out_of_range domain_error length_error",
    "string": "string to_string getline", "string_view": "string_view", "utility": "pair exchange index_sequence as_const",
    "vector": "vector", "cstdint": "uint8_t uint16_t uint32_t uint64_t int8_t int16_t int32_t int64_t",
    "random": "mt19937 mt19937_64 uniform_int_distribution uniform_real_distribution", "set": "set multiset",
    "sstream": "ostringstream istringstream stringstream",
}
HEADER_OF = {name: header for header, names in NAMES.items() for name in names.split()}
# Headers that the standard says include another, or cannot be used without it.
BESIDES = {"map": ["utility"], "set": ["utility"], "unordered_map": ["utility"], "unordered_set": ["utility"],
           "sstream": ["string"], "string": ["string_view"], "fstream": ["string"], "filesystem": ["string"],
           "iostream": ["string"], "regex": ["string"], "deque": [], "tuple": ["utility"], "stdexcept": ["string"],
           "algorithm": ["utility"], "functional": [], "optional": ["utility"], "system_error": ["string"],
           "gtest/gtest.h": ["string", "vector", "memory", "map", "set", "sstream", "functional", "utility", "limits",
                             "cstdint"],
           "gmock/gmock.h": ["string", "vector", "memory", "map", "set", "sstream", "functional", "utility", "algorithm",
                             "limits", "cstdint"],
           "fmt/format.h": ["string", "string_view", "cstdint", "cmath", "limits", "memory", "stdexcept"],
           "CLI/CLI.hpp": ["string", "vector", "functional", "memory", "algorithm", "utility", "map", "set", "sstream"],
           "nlohmann/json.hpp": ["string", "vector", "map", "utility", "cstdint", "array", "memory", "algorithm"],
           "SQLiteCpp/SQLiteCpp.h": ["string", "memory", "cstdint"],
           "rapidcheck.h": ["string", "vector", "functional", "map", "set", "memory", "random", "cstdint"]}
NOISE = re.compile(r'R"(\w*)\(.*?\)\1"|//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.DOTALL)
STANDARD = re.compile(r"\bstd::(?:ranges::)?(\w+)")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]+(?:<([^>]+)>|"([^"]+)")', re.MULTILINE)


def needs(text):
    text = NOISE.sub(lambda m: '""', INCLUDE.sub("", text))
    return {HEADER_OF[name]: name for name in STANDARD.findall(text) if name in HEADER_OF}


@functools.cache
def provided(root, file):
    """The standard headers that a file includes, directly or through headers of the project."""
    found, seen, open_files = set(), set(), [file]
    while open_files:
        one = open_files.pop()
        if one in seen:
            continue
        seen.add(one)
        for system, own in INCLUDE.findall((root / one).read_text(errors="replace")):
            if system:
                found.update([system, *BESIDES.get(system, [])])
            elif (root / own).is_file():
                open_files.append(own)
            elif (sibling := str(pathlib.Path(one).parent / own)) and (root / sibling).is_file():
                open_files.append(sibling)
    return found


def check_itself():
    assert needs("std::vector<int> a; // std::map\n") == {"vector": "vector"}
    assert needs('"std::map" std::ranges::sort(a)') == {"algorithm": "sort"}


def main():
    check_itself()
    root = pathlib.Path(sys.argv[1])
    wrong = []
    files = sorted(p.relative_to(root) for folder in FOLDERS for p in (root / folder).rglob("*") if p.suffix in (".h", ".cpp"))
    for file in files:
        missing = needs((root / file).read_text(errors="replace"))
        for header in sorted(set(missing) - provided(root, str(file))):
            wrong.append(f"{file}: std::{missing[header]} needs #include <{header}>")
    print("\n".join(wrong) or f"{len(files)} files have the standard headers that they need")
    return 1 if wrong else 0


sys.exit(main())
