# SPDX-License-Identifier: GPL-3.0-or-later
"""Does what a page of the guide says, as it stands there, twice in one folder.

usage: guide_pages.py PROGRAM SOURCE_FOLDER PAGE [copy]
A page's blocks of `sh` are run in order, in one shell, in a folder that has the checkout's files but no
build; for a page that changes the sources and builds them these are copies ("copy"). Every block must succeed, a second time too: nothing in a tutorial fails because a file exists.
A block of `text` after one of `sh` is what that prints, with "..." for any words. A block of `json` is
JSON. Other blocks are left alone: `console` shows commands that take long or need more packages.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from fresh_clone import copy_sources
from page_blocks import blocks_of, same_output

# kinex diff says by exit code 1 that two logs differ: that is no failure here.
PRELUDE = """set -eu
kinex() {
  command kinex "$@" && return
  status=$?
  [ "$1" = diff ] && [ $status -eq 1 ]
}
"""
MARK = "== end of a block =="
KNOWN = ("sh", "text", "json", "console", "cpp", "cmake", "sql", "python")
TIMES = 2


def checkout(source, folder):
    """The files of the checkout as links, in a folder that can be written to."""
    for name in ("core", "experiments", "papers", "predicates", "structures", "tests", "README.md"):
        (folder / name).symlink_to(source.resolve() / name)


def run_once(commands, folder, program):
    script = PRELUDE + "".join(f"{text}\necho '{MARK}'\n" for text in commands)
    environment = {**os.environ, "PATH": f"{program.parent}:{os.environ['PATH']}"}
    environment.pop("KINEX", None)
    # Of what is built in a copy ccache has nearly all.
    environment.update(CCACHE_BASEDIR=str(folder), CCACHE_NOHASHDIR="1")
    if shutil.which("ninja"):
        environment["CMAKE_GENERATOR"] = "Ninja"
    done = subprocess.run(["sh", "-c", script], cwd=folder, env=environment, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    outputs = done.stdout.split(MARK + "\n")[:-1]
    if done.returncode != 0 or len(outputs) != len(commands):
        failed = commands[min(len(outputs), len(commands) - 1)]
        sys.exit(f"exit code {done.returncode} at\n{failed}\n{done.stdout[-2000:]}{done.stderr}")
    return outputs


def main():
    program, source, page = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]), sys.argv[3]
    blocks = blocks_of(source, page)
    for language, text in blocks:
        if language not in KNOWN:
            sys.exit(f"{page}: a block of {language!r}: write one of {', '.join(KNOWN)}")
        if language == "json":
            json.loads(text)
    commands = [text for language, text in blocks if language == "sh"]
    if not commands:
        sys.exit(f"{page} has no commands")
    shown = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        if sys.argv[4:] == ["copy"]:
            copy_sources(source, folder)
        else:
            checkout(source, folder)
        for _ in range(TIMES):
            outputs = run_once(commands, folder, program)
            at = -1
            before = None
            for language, text in blocks:
                if language == "sh":
                    at += 1
                elif language == "text":
                    if before != "sh":
                        sys.exit(f"{page}: a block of text that follows no commands:\n{text}")
                    shown += 1
                    same_output(text, outputs[at], commands[at], page)
                before = language
    print(f"{page}: {len(commands)} blocks run {TIMES} times, {shown // TIMES} outputs as shown")


main()
