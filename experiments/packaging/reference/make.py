#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the reference of the libraries with Doxygen; its warnings are errors.

usage: make.py DOXYGEN DOXYFILE FOLDER

A file, class, enumeration, type, constant or free function without a comment is an error. Members of classes
may speak for themselves. Exit code 1, with the warnings, if there are any; no reference is left then.
"""
import pathlib
import re
import shutil
import subprocess
import sys

# Members of classes: "Member size() const (function) of class kinex::SortedList is not documented."
MEMBER = re.compile(r"warning: Member .* of (class|struct|union|friend) \S.* is not documented\.$")
FRIEND = re.compile(r"warning: Member .*\(friend\) of .* is not documented\.$")


def main():
    doxygen, settings, folder = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    done = subprocess.run([doxygen, settings], check=False)
    warnings = (folder / "warnings.txt").read_text().splitlines()
    wrong = list(dict.fromkeys(line for line in warnings
                               if line.strip() and not MEMBER.search(line) and not FRIEND.search(line)))
    for line in wrong:
        print(line)
    if wrong or done.returncode != 0:
        shutil.rmtree(folder / "html", ignore_errors=True)
        sys.exit(f"kinex: the reference has {len(wrong)} warning{'' if len(wrong) == 1 else 's'}: write the comments "
                 "that are missing, or mend those that Doxygen cannot read")
    print(f"{folder / 'html' / 'index.html'}")


main()
