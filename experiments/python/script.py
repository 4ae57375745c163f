# SPDX-License-Identifier: GPL-3.0-or-later
"""The end of a script: an error as one line, "SCRIPT: FILE: PROBLEM; REMEDY", with exit code 2."""
import sys
from pathlib import Path

from kinex_results import ResultsError


def text_of(error):
    """Of a ResultsError or an OSError."""
    if isinstance(error, ResultsError):
        return str(error)
    remedy = "add --force to replace it" if isinstance(error, FileExistsError) else "check the name, or take another one"
    return f"{error.filename}: {error.strerror}; {remedy}"


def run(main):
    """Calls main()."""
    try:
        main()
    except (ResultsError, OSError) as error:
        print(f"{Path(sys.argv[0]).name}: {text_of(error)}", file=sys.stderr)
        sys.exit(2)
