# SPDX-License-Identifier: GPL-3.0-or-later
"""Messages of a script, as those of the program: "kinex: FILE: PROBLEM; REMEDY"; an error ends it with exit code 2."""
import argparse
import sys

from kinex_results import ResultsError


def text_of(error):
    """Of a ResultsError or an OSError."""
    if isinstance(error, ResultsError):
        return str(error)
    remedy = "add --force to replace it" if isinstance(error, FileExistsError) else "check the name, or take another one"
    return f"{error.filename}: {error.strerror}; {remedy}"


def note(text):
    """A line on standard error."""
    print(f"kinex: {text}", file=sys.stderr)


class ArgumentParser(argparse.ArgumentParser):
    def error(self, message):
        note(f"{self.prog}: {message}; {self.prog} --help says what it takes")
        sys.exit(2)


def run(main):
    """Calls main()."""
    try:
        main()
    except (ResultsError, OSError) as error:
        note(text_of(error))
        sys.exit(2)
