#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes commands.md: what every verb says of itself with --help.

usage: commands.py PROGRAM            writes commands.md beside this script
       commands.py PROGRAM --check    exit code 1 if commands.md is not what the program says
"""
import difflib
import pathlib
import re
import subprocess
import sys

PAGE = pathlib.Path(__file__).resolve().parent / "commands.md"
HEAD = """<!-- Made by experiments/guide/commands.py; do not edit. -->
# Commands

What the program says of itself: `kinex --help`, and `kinex VERB --help` for every verb. Exit codes of all of them: 0 success, 1 a claim,
bound or audit failed (of `diff`: the logs differ), 2 bad input or usage, 3 gave up at a stated limit or interrupted.

"""


def text_of(program, *words):
    done = subprocess.run([program, *words, "--help"], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT)
    if done.returncode != 0:
        sys.exit(f"{' '.join(words)} --help: exit code {done.returncode}\n{done.stdout}")
    return "\n".join(line.rstrip() for line in done.stdout.strip().splitlines())


def verbs_of(text):
    """[(name, one line)] of the subcommands that a help lists."""
    found = re.search(r"(?ms)^Subcommands:\n(.*?)(?=^\S|\Z)", text)
    if found is None:
        return []
    verbs = []
    for line in found.group(1).splitlines():
        entry = re.match(r"  (\S+)\s+(\S.*)", line)
        if entry:
            verbs.append([entry.group(1), entry.group(2)])
        elif verbs and line.strip():
            verbs[-1][1] += " " + line.strip()
    return verbs


def section(program, words):
    text = text_of(program, *words)
    level = "#" * (len(words) + 1)
    page = f"{level} kinex {' '.join(words)}\n\n```console\n{text}\n```\n\n"
    for name, _ in verbs_of(text):
        page += section(program, [*words, name])
    return page


def page_of(program):
    whole = text_of(program)
    verbs = verbs_of(whole)
    if len(verbs) < 10:
        sys.exit(f"{program} --help lists only {len(verbs)} verbs")
    text = HEAD + "| verb | |\n| --- | --- |\n"
    text += "".join(f"| [{name}](#kinex-{name}) | {what} |\n" for name, what in verbs)
    text += f"\n## kinex\n\n```console\n{whole}\n```\n\n"
    for name, _ in verbs:
        text += section(program, [name])
    return text.rstrip() + "\n"


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--check"]):
        sys.exit(__doc__)
    made = page_of(sys.argv[1])
    if sys.argv[2:]:
        there = PAGE.read_text() if PAGE.exists() else ""
        if there != made:
            lines = difflib.unified_diff(there.splitlines(), made.splitlines(), "commands.md", "the program",
                                         lineterm="", n=1)
            sys.exit("\n".join(lines) + f"\ncommands.md is not what the program says: python3 {__file__} PROGRAM")
        print("commands.md is what the program says")
    else:
        PAGE.write_text(made)


main()
