# SPDX-License-Identifier: GPL-3.0-or-later
"""The fenced blocks of a page, for tests that do what the page says."""
import pathlib
import re

ANYTHING = "..."  # in an output that a page shows: any words, or none


def blocks_of(source, page, section=None):
    """[(language, text)] of the page, or of its section "## SECTION", in order; none is an error."""
    text = (pathlib.Path(source) / page).read_text()
    if section is not None:
        parts = re.split(r"(?m)^## (.*)\n", text)
        sections = dict(zip(parts[1::2], parts[2::2]))
        if section not in sections:
            raise SystemExit(f"{page} has no section {section!r}")
        text = sections[section]
    found = re.findall(r"(?ms)^```(\w*)\n(.*?)^```$", text)
    if not found:
        raise SystemExit(f"{page}{f', {section!r}' if section else ''}: no blocks")
    return found


def agrees(shown, printed):
    """Whether the words are the same; "..." on the page stands for any words."""
    pieces = [" ".join(piece.split()) for piece in re.split(r"(?:^|(?<=\s))\.\.\.(?=\s|$)", shown)]
    words = " ".join(printed.split())
    pattern = ".*".join(re.escape(piece) for piece in pieces)
    return re.fullmatch(pattern.replace(r".*", r"\s*.*?\s*"), words) is not None


def same_output(shown, printed, what, page="the page"):
    """Ends the test if the output that the page shows is not what was printed."""
    if agrees(shown, printed):
        return
    raise SystemExit(f"{what} prints\n{printed}\n{page} shows\n{shown}")
