# SPDX-License-Identifier: GPL-3.0-or-later
"""The fenced blocks of a section of README.md, for tests that do what README says."""
import pathlib
import re


def blocks_of(source, section):
    """[(language, text)] of the section "## SECTION", in order; none is an error."""
    text = (pathlib.Path(source) / "README.md").read_text()
    parts = re.split(r"(?m)^## (.*)\n", text)
    sections = dict(zip(parts[1::2], parts[2::2]))
    if section not in sections:
        raise SystemExit(f"README.md has no section {section!r}")
    found = re.findall(r"(?ms)^```(\w*)\n(.*?)^```$", sections[section])
    if not found:
        raise SystemExit(f"README.md, {section!r}: no blocks")
    return found


def same_output(shown, printed, what):
    """Ends the test if the output that README shows is not what was printed."""
    if shown.split() == printed.split():
        return
    raise SystemExit(f"{what} prints\n{printed}\nREADME.md shows\n{shown}")
