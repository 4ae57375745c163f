# SPDX-License-Identifier: GPL-3.0-or-later
"""The man pages are made, one for the program and one for each verb, and say what --help says.

usage: man_pages.py KINEX SOURCE_FOLDER
Exit code 77: help2man is not installed.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile


def run(*command, **options):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, **options)


def plain(roff):
    """The words of a page, without its markup."""
    return re.sub(r"\\f[A-Z]|\\,|\\/|\\&", "", roff).replace("\\-", "-").replace("\\(aq", "'").replace("\\e", "\\")


def main():
    program, source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    if shutil.which("help2man") is None:
        print("skipped: help2man is not installed")
        return 77
    wrong = []
    with tempfile.TemporaryDirectory() as name:
        folders = [pathlib.Path(name, "first"), pathlib.Path(name, "again")]
        for folder in folders:
            done = run("sh", source / "experiments/packaging/man-pages", program, "1.2.3", folder)
            if done.returncode != 0 or done.stderr:
                sys.exit(f"man-pages: {done}")
        verbs = run(program, "completion", "verbs").stdout.split("\n")[:-1]
        expected = {"kinex.1", "kinex-logcheck.1"} | {f"kinex-{verb.replace(' ', '-')}.1" for verb in verbs}
        found = {path.name for path in folders[0].iterdir()}
        if found != expected:
            wrong.append(f"there are {sorted(found)}, not {sorted(expected)}")
        for page in sorted(found):
            text = (folders[0] / page).read_text()
            if text != (folders[1] / page).read_text():
                wrong.append(f"{page}: another time it is another")
            if '"kinex 1.2.3"' not in text or not re.search(r"^\.SH NAME\n\S+ \\- \S", text, re.MULTILINE):
                wrong.append(f"{page}: no name or no version")
        for verb in ["", *verbs]:
            page = "-".join(["kinex", *verb.split()]) + ".1"
            text = plain((folders[0] / page).read_text())
            help_text = run(program, *verb.split(), "--help").stdout
            for option in re.findall(r"^  (?:-\w,)?(--[a-z-]+)", help_text, re.MULTILINE):
                if option not in text:
                    wrong.append(f"{page}: {option} is missing")
            # An example keeps its lines.
            for line in re.findall(r"^  (kinex .*)$", help_text, re.MULTILINE):
                if not re.search("^" + re.escape(line) + "$", text, re.MULTILINE):
                    wrong.append(f"{page}: the example is missing: {line}")
        # groff has nothing to complain about.
        if shutil.which("groff") is not None:
            for page in sorted(found):
                done = run("groff", "-man", "-Tutf8", "-ww", "-z", folders[0] / page)
                if done.stderr:
                    wrong.append(f"{page}: {done.stderr}")
    print("\n".join(wrong[:20]) or f"{len(found)} man pages")
    return 1 if wrong else 0


sys.exit(main())
