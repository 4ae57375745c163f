# SPDX-License-Identifier: GPL-3.0-or-later
"""Stale pages are found, and say so: in a small repository of its own.

usage: stale_pages.py SOURCE_FOLDER
"""
import pathlib
import subprocess
import sys
import tempfile

PAGE = "experiments/trade/trade.md"
CODE = "core/numbers/sign.h"
MARK = "*Older than the code:*"


def main():
    script = pathlib.Path(sys.argv[1]) / "experiments/packaging/stale-pages"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)

        def git(*words):
            return subprocess.run(["git", "-C", folder, "-c", "user.name=n", "-c", "user.email=e", *words], check=True,
                                  capture_output=True, text=True).stdout.strip()

        def write(path, text):
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / path).write_text(text)

        def commit(**files):
            for path, text in files.items():
                write({"code": CODE, "page": PAGE}.get(path, path), text)
            git("add", "-A")
            git("commit", "-qm", "x")
            return git("rev-parse", "HEAD")

        def expect(code, words, *arguments):
            done = subprocess.run([sys.executable, script, *arguments, folder], capture_output=True, text=True, check=False)
            if done.returncode != code or words not in done.stdout:
                sys.exit(f"exit code {done.returncode}, not {code}, or no {words!r}:\n{done.stdout}{done.stderr}")

        expect(77, "no repository")
        git("init", "-q")
        first = commit(code="int f();  // one\n")
        made = f"# Trade\n\nMade by `kinex trade`, kinex 0.1.0 at {first}, GCC 12, flags `-O3`; CPU.\n\nText.\n"
        commit(page=made)
        expect(0, "up to date")
        # Comments and layout are no code.
        commit(code="// two\nint  f();\n")
        expect(0, "up to date")
        # Other code, uncommitted already.
        write(CODE, "int g();\n")
        expect(1, "stale, and does not say so")
        expect(1, "1 file changed since: core/numbers/sign.h")
        git("checkout", "-q", CODE)
        second = commit(code="const char* f = \"a // b\";\n")
        expect(1, "stale, and does not say so")
        expect(0, "stale", "--mark")
        if (folder / PAGE).read_text().count(MARK) != 1 or not (folder / PAGE).read_text().endswith("\n\nText.\n"):
            sys.exit((folder / PAGE).read_text())
        expect(0, "stale")
        # What is behind // in a string is code.
        write(PAGE, made.replace(first, second))
        expect(0, "up to date")
        write(CODE, "const char* f = \"a // c\";\n")
        expect(1, "stale")
        write(CODE, "const char* f = \"a // b\";\n")
        write("core/new.cpp", "")
        git("add", "-A")
        expect(1, "core/new.cpp")
        git("rm", "-qf", "core/new.cpp")
        # A page that is made again, and keeps the line.
        write(PAGE, made.replace(first, second).replace("CPU.", "CPU.\n\n" + MARK))
        expect(0, "up to date")  # only the whole line counts
        write(PAGE, made)
        expect(0, "stale", "--mark")
        write(PAGE, (folder / PAGE).read_text().replace(first, second))
        expect(1, "it says that it is stale, and is not")
        expect(0, "up to date", "--mark")
        if MARK in (folder / PAGE).read_text():
            sys.exit("the line is still there")
        write(PAGE, "# Trade\n")
        expect(1, "does not say what made it")
        write(PAGE, made.replace(first, "0" * 40))
        expect(1, "is not in the history")
        write(PAGE, made.replace(first, first + " with changes that are not committed"))
        expect(1, "made of sources that were not committed")
        write("papers/new/README.md", made.replace(first, second))
        git("add", "-A")
        expect(1, "papers/new/README.md: say in stale-pages")
    print("stale pages are found")


main()
