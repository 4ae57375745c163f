# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the commands of README's tutorial and of its section on sweeps, as they stand there, in an
otherwise empty folder.

usage: readme_tutorial.py PROGRAM SOURCE_FOLDER
Every block of commands must succeed. Where README shows an output after it, that must be it.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from readme_blocks import blocks_of, same_output

FEWEST_COMMANDS = 8
# kinex diff says by exit code 1 that two logs differ: that is no failure here.
PRELUDE = """set -eu
kinex() {
  command kinex "$@" && return
  status=$?
  [ "$1" = diff ] && [ $status -eq 1 ]
}
"""
MARK = "== end of a block =="


def main():
    program, source = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    blocks = blocks_of(source, "Five minutes") + blocks_of(source, "Sweeps")
    commands = [text for language, text in blocks if language == "sh"]
    number = sum(line.startswith("kinex ") for text in commands for line in text.splitlines())
    if number < FEWEST_COMMANDS:
        sys.exit(f"README.md has only {number} commands")
    script = PRELUDE + "".join(f"{text}\necho '{MARK}'\n" for text in commands)
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(source / "experiments/scenes", pathlib.Path(folder) / "experiments/scenes")
        environment = {**os.environ, "PATH": f"{program.parent}:{os.environ['PATH']}"}
        done = subprocess.run(["sh", "-c", script], cwd=folder, env=environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    outputs = done.stdout.split(MARK)[:-1]
    if done.returncode != 0 or len(outputs) != len(commands):
        failed = commands[min(len(outputs), len(commands) - 1)]
        sys.exit(f"exit code {done.returncode} at\n{failed}\n{done.stdout[-2000:]}{done.stderr}")
    shown = 0
    at = -1
    for language, text in blocks:
        if language == "sh":
            at += 1
        elif language == "text":
            shown += 1
            same_output(text, outputs[at], commands[at])
        else:
            sys.exit(f"a block of {language!r}: write sh or text")
    if shown == 0:
        sys.exit("README.md shows no output")
    print(f"{number} commands run, {shown} outputs as shown")


main()
