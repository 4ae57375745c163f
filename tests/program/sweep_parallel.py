# SPDX-License-Identifier: GPL-3.0-or-later
"""A sweep under GNU parallel: killed with -9 it goes on, and the database is that of one process.

usage: sweep_parallel.py PROGRAM SOURCE_FOLDER
Exit code 77: GNU parallel is not installed.
"""
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from sweep_files import exact_content, merged, records_of, sweep, write_plan

BLOCKS = [{"structure": ["sorted_list", "delaunay_2"], "workload": ["uniform-square", "grid"], "n": [36, 64],
           "seed": {"from": 1, "to": 6}}]
CELLS = 48


def kill_shards_of(folder):
    """GNU parallel gives its jobs process groups of their own: they outlive it."""
    left = True
    while left:
        left = False
        for process in pathlib.Path("/proc").iterdir():
            try:
                words = (process / "cmdline").read_bytes() if process.name.isdigit() else b""
                if str(folder).encode() in words:
                    left = True
                    os.kill(int(process.name), signal.SIGKILL)
            except OSError:
                pass  # it has ended
        time.sleep(0.02)


def check_arguments(source):
    """Bad arguments are refused before anything runs."""
    for script in ("parallel.sh", "submit.sh"):
        for words, message in ((("plan.json", "out"), f"usage: {script} PLAN FOLDER SHARDS "),
                               (("none.json", "out", "4", "2"), f"{script}: none.json: the plan cannot be read; check the name\n"),
                               (("verify", "out", "0", "2"), f"{script}: '0' is no number from 1; usage: {script} PLAN "),
                               (("verify", "out", "4", "2x"), f"{script}: '2x' is no number from 1; usage: {script} PLAN ")):
            done = subprocess.run(["sh", source / "experiments/cluster" / script, *words], capture_output=True, text=True, check=False)
            assert done.returncode == 2 and done.stderr.startswith(message) and not done.stdout, (script, words, done)


def main():
    program, source = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    check_arguments(source)
    if shutil.which("parallel") is None:
        print("skipped: GNU parallel is not installed (Debian: parallel)")
        return 77
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        plan = write_plan(folder / "plan.json", BLOCKS)
        sweep(program, "run", plan, "-o", folder / "one")
        expected = merged(program, folder / "one", folder / "one.sqlite")
        environment = dict(os.environ, PATH=f"{program.parent}:{os.environ['PATH']}", HOME=scratch)
        command = ["sh", source / "experiments/cluster/parallel.sh", plan, folder / "out", "5", "2"]
        for enough in (8, 20):
            run = subprocess.Popen(command, env=environment, start_new_session=True,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            end = time.monotonic() + 60
            while len(records_of(folder / "out")) < enough and time.monotonic() < end:
                time.sleep(0.005)
            os.killpg(run.pid, signal.SIGKILL)
            run.wait()
            kill_shards_of(folder / "out")
            assert enough <= len(records_of(folder / "out")) < CELLS
            assert not (folder / "out.sqlite").exists()
        done = subprocess.run(command, env=environment, capture_output=True, text=True)
        assert done.returncode == 0, done
        keys = [record["key"] for record in records_of(folder / "out")]
        assert len(set(keys)) == CELLS and len(keys) <= CELLS + 4, len(keys)
        assert exact_content(folder / "out.sqlite") == expected
    print(f"{CELLS} cells by GNU parallel, killed twice: the database of one process")
    return 0


sys.exit(main())
