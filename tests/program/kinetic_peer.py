# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests experiments/peers/kinetic/measure.py.

usage: kinetic_peer.py PROGRAM SOURCE
A folder without the peer's headers is refused by name. With headers (the environment's
KINEX_KINETIC_HEADERS names their folder) small lists have the same events in both programs; without them
that part is left out, with a message.
"""
import os
import subprocess
import sys


def fail(message):
    print(f"kinetic_peer: {message}")
    sys.exit(1)


def main():
    program, source = sys.argv[1], sys.argv[2]
    measure = [sys.executable, f"{source}/experiments/peers/kinetic/measure.py"]
    done = subprocess.run(measure + ["no-such-folder", "--kinex", program], capture_output=True, text=True, check=False)
    if done.returncode != 2 or "no-such-folder has no CGAL/Kinetic/Sort.h: name the folder" not in done.stderr:
        fail(f"a folder without headers: exit code {done.returncode}: {done.stderr}")
    headers = os.environ.get("KINEX_KINETIC_HEADERS")
    if headers is None:
        print("KINEX_KINETIC_HEADERS names no headers: both programs are not compared")
        return
    done = subprocess.run(measure + [headers, "--kinex", program, "--rounds", "1", "--smoke"], capture_output=True,
                          text=True, check=False)
    if done.returncode != 0:
        fail(f"exit code {done.returncode}: {done.stderr}")
    rows = [line.split() for line in done.stdout.splitlines()[1:]]
    if len(rows) != 6:
        fail(f"{len(rows)} rows: {done.stdout}")
    for row in rows:
        if row[3] != row[4] or int(row[3]) < 100:
            fail(f"other events, or few: {' '.join(row)}")


if __name__ == "__main__":
    main()
