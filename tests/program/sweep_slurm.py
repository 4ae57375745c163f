# SPDX-License-Identifier: GPL-3.0-or-later
"""A sweep on a real Slurm of this machine alone: tasks killed with -9, a node that goes away and comes
back, tasks run twice; the database is that of one process.

usage: sweep_slurm.py PROGRAM SOURCE_FOLDER
Exit code 77: not root, or Slurm is not installed. Takes three minutes: Slurm waits two of them before it
starts a task again that it has put back in the queue.
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

BLOCKS = [{"structure": ["sorted_list", "delaunay_2"], "workload": ["uniform-square", "grid"], "n": [64, 400],
           "seed": {"from": 1, "to": 10}}]
CELLS, SHARDS = 80, 8
SLOW = 240  # seconds in which everything that Slurm does has happened


class Cluster:
    """experiments/cluster/one-machine.sh for as long as it is entered."""

    def __init__(self, source, folder, program):
        self.script = source / "experiments/cluster/one-machine.sh"
        self.submit_script = source / "experiments/cluster/submit.sh"
        self.folder = folder
        self.environment = dict(os.environ, SLURM_CONF=str(folder / "slurm.conf"),
                                PATH=f"{program.parent}:{os.environ['PATH']}")

    def __enter__(self):
        self.call("sh", self.script, "start", self.folder)
        return self

    def __exit__(self, *_):
        subprocess.run(["scancel", "--state=PENDING", "--name=kinex-sweep"], env=self.environment)
        subprocess.run(["scancel", "--name=kinex-sweep"], env=self.environment)
        self.call("sh", self.script, "stop", self.folder)

    def call(self, *words):
        done = subprocess.run([str(word) for word in words], env=self.environment, capture_output=True,
                              text=True, timeout=120)
        assert done.returncode == 0, (words, done)
        return done.stdout

    def submit(self, plan, out, *options):
        """The numbers of the array and of the job that merges."""
        return self.call("sh", self.submit_script, plan, out, SHARDS, 2, "--mem=500", *options).split()

    def wait_for(self, *jobs):
        until(lambda: not self.call("squeue", "--noheader", "--format=%i"), f"jobs {jobs} end")

    def daemon(self, name):
        return int((self.folder / f"{name}.pid").read_text())


def until(condition, what):
    end = time.monotonic() + SLOW
    while not condition():
        assert time.monotonic() < end, f"in {SLOW} s it does not happen that {what}"
        time.sleep(0.05)


def processes_with(*words):
    """Ids of the processes whose command line has all of these words, in this order."""
    found = []
    for process in pathlib.Path("/proc").iterdir():
        try:
            line = (process / "cmdline").read_bytes().split(b"\0") if process.name.isdigit() else []
        except OSError:
            continue
        rest = iter(line)
        if line and all(word.encode() in rest for word in words):
            found.append(int(process.name))
    return [pid for pid in found if pid != os.getpid()]


def parent_of(pid):
    return int(pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(") ", 1)[1].split()[1])


def kill_task(plan):
    """kill -9 of one task that is at work. The number of its shard."""
    for shard in range(SHARDS):
        for pid in processes_with("sweep", "run", str(plan), f"{shard}/{SHARDS}"):
            os.kill(pid, signal.SIGKILL)
            return shard
    return None


def check_killed_task(cluster, program, folder, plan, expected):
    """A task that is killed fails; submitted again it goes on."""
    out = folder / "killed"
    cluster.submit(plan, out)
    until(lambda: len(records_of(out)) > 3, "cells are recorded")
    shard = kill_task(plan)
    assert shard is not None
    cluster.wait_for()
    assert f"{CELLS} cells" in sweep(program, "status", out, code=3).stdout
    before = len(records_of(out))
    assert before < CELLS
    # The job that merges ran all the same, on what there was.
    assert "missing" in exact_content(folder / "killed.sqlite")
    cluster.submit(plan, out, f"--array={shard}")
    cluster.wait_for()
    assert len(records_of(out)) == CELLS
    assert exact_content(folder / "killed.sqlite") == expected
    print(f"task of shard {shard} killed after {before} cells, submitted again", flush=True)


def check_lost_node(cluster, program, folder, plan, expected):
    """The node goes away with all that runs on it, and comes back: Slurm starts its tasks again."""
    out = folder / "lost"
    cluster.submit(plan, out)
    until(lambda: len(records_of(out)) > 3, "cells are recorded")
    os.kill(cluster.daemon("slurmd"), signal.SIGKILL)
    tasks = processes_with("sweep", "run", str(plan))
    for pid in [parent_of(task) for task in tasks] + tasks:  # slurmstepd, and the task
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
    until(lambda: not processes_with("sweep", "cell"), "no cell is at work")
    before = len(records_of(out))
    assert before < CELLS
    cluster.call("sh", cluster.script, "slurmd", cluster.folder)
    cluster.wait_for()
    assert len({record["key"] for record in records_of(out)}) == CELLS
    assert exact_content(folder / "lost.sqlite") == expected
    restarted = [path for path in out.glob("shard-*.jsonl") if ", restart " in path.read_text().split("\n")[0]]
    print(f"node lost after {before} cells; {len(restarted)} tasks started again by Slurm", flush=True)
    assert restarted


def check_stopped_daemon(cluster, program, folder, plan, expected):
    """slurmd is ended and started again while tasks run: they do not notice. Then everything runs a
    second time, into the same folder."""
    out = folder / "twice"
    cluster.submit(plan, out)
    until(lambda: len(records_of(out)) > 3, "cells are recorded")
    os.kill(cluster.daemon("slurmd"), signal.SIGTERM)
    until(lambda: not (cluster.folder / "slurmd.pid").exists(), "slurmd ends")
    cluster.call("sh", cluster.script, "slurmd", cluster.folder)
    cluster.wait_for()
    assert len(records_of(out)) == CELLS
    fresh = folder / "fresh.sh"
    fresh.write_text(f"#!/bin/sh\nexec kinex sweep run {plan} --shard $SLURM_ARRAY_TASK_ID/3 --fresh -o {out}\n")
    cluster.call("sbatch", "--array=0-2", f"--output={out}/log/fresh_%a.txt", fresh)
    cluster.wait_for()
    assert len(records_of(out)) == 2 * CELLS
    assert merged(program, out, folder / "twice.sqlite") == expected
    print(f"slurmd ended and started again; {2 * CELLS} records of {CELLS} cells agree", flush=True)


def main():
    program, source = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    missing = [name for name in ("slurmctld", "slurmd", "sbatch", "munge") if shutil.which(name) is None]
    if missing or os.geteuid() != 0:
        print("skipped: " + (f"{', '.join(missing)} not installed (Debian: slurmctld slurmd slurm-client munge)"
                             if missing else "not root"))
        return 77
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        plan = write_plan(folder / "plan.json", BLOCKS, seconds=600, megabytes=400)
        sweep(program, "run", plan, "-o", folder / "one")
        expected = merged(program, folder / "one", folder / "one.sqlite")
        with Cluster(source, folder / "slurm", program) as cluster:
            for check in (check_killed_task, check_stopped_daemon, check_lost_node):
                check(cluster, program, folder, plan, expected)
    print("each database is that of one process")
    return 0


sys.exit(main())
