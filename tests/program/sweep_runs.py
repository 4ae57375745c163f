# SPDX-License-Identifier: GPL-3.0-or-later
"""`kinex sweep` from outside: killed at any point it goes on; crashes and limits are results; records
that do not belong together are refused.

usage: sweep_runs.py PROGRAM SOURCE_FOLDER [TEST,..]
"""
import json
import os
import pathlib
import random
import resource
import signal
import subprocess
import sys
import tempfile
import time

from sweep_files import exact_content, lines_of, merged, records_of, sweep, write_plan

SMALL = [{"structure": ["sorted_list", "maximum_tournament", "delaunay_2"], "workload": "uniform-square",
          "n": [20, 40], "seed": {"from": 1, "to": 6}},
         {"structure": [["sorted_list", "delaunay_2"]], "workload": "grid", "n": 16, "seed": [1, 2],
          "arithmetic": ["exact", "sturm"]}]
CELLS = 40
# Takes many seconds.
LONG = [{"structure": "sorted_list", "workload": "uniform-square", "n": 3000, "arithmetic": "sturm"}]


def start(program, *words):
    return subprocess.Popen([program, "sweep", *map(str, words)], stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, text=True)


def children_of(pid):
    """Ids of the processes that run a cell for this one, even if it has ended."""
    found = []
    for process in pathlib.Path("/proc").iterdir():
        if not process.name.isdigit():
            continue
        try:
            words = (process / "cmdline").read_bytes().split(b"\0")
        except OSError:
            continue
        if b"--parent" in words and words[words.index(b"--parent") + 1] == str(pid).encode():
            found.append(int(process.name))
    return found


def until(condition, seconds=30):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        result = condition()
        if result:
            return result
        time.sleep(0.005)
    raise AssertionError("it does not happen")


def child_at_work(run):
    """A child that has used CPU time: it has set its limits and is at its cell."""
    def busy():
        for child in children_of(run.pid):
            try:
                fields = pathlib.Path(f"/proc/{child}/stat").read_text().rsplit(") ", 1)[1].split()
            except OSError:
                continue
            if int(fields[11]) > 20:  # ticks of user time
                return child
        return None
    return until(busy)


def reference(program, folder):
    plan = write_plan(folder / "plan.json", SMALL)
    sweep(program, "run", plan, "-o", folder / "one")
    assert len(records_of(folder / "one")) == CELLS
    return plan, merged(program, folder / "one", folder / "one.sqlite")


def test_shards_and_jobs(program, source, folder):
    """The merged database is the same for any shards, jobs and order."""
    plan, expected = reference(program, folder)
    for shards, jobs in ((1, 3), (3, 2), (7, 1)):
        out = folder / f"out-{shards}"
        for i in reversed(range(shards)):
            sweep(program, "run", plan, "--shard", f"{i}/{shards}", "--jobs", jobs, "-o", out)
        assert merged(program, out, folder / "some.sqlite") == expected, (shards, jobs)
        again = sweep(program, "run", plan, "-o", out)
        assert again.stdout == "" and "40 cells are finished already" in again.stderr, again
    sweep(program, "run", plan, "--fresh", "--jobs", 2, "-o", out)
    assert len(records_of(out)) == 2 * CELLS
    assert merged(program, out, folder / "twice.sqlite") == expected
    # Folders of several machines.
    a, b = folder / "a", folder / "b"
    sweep(program, "run", plan, "--shard", "0/2", "-o", a)
    assert "20 missing" in sweep(program, "status", a, code=3).stdout
    sweep(program, "run", plan, "--shard", "1/2", "-o", b)
    sweep(program, "merge", a, b, "-o", folder / "both.sqlite")
    assert exact_content(folder / "both.sqlite") == expected


def test_max_events(program, source, folder):
    """Runs that the plan's max_events ended are done, and counted apart by run, status and merge."""
    plan = write_plan(folder / "plan.json", [{"structure": "sorted_list", "workload": "uniform-square", "n": 20,
                                              "max_events": [3, 4, 100000]}])
    counts = "3 cells: 3 done (2 of them ended at max_events)\n"
    assert sweep(program, "run", plan, "-o", folder / "out").stderr.endswith(": " + counts)
    assert sweep(program, "status", folder / "out").stdout.endswith(": " + counts)
    assert counts in sweep(program, "merge", folder / "out", "-o", folder / "out.sqlite").stdout


def test_killed_at_random_points(program, source, folder):
    """kill -9 loses the running cells only, and the same commands go on."""
    plan, expected = reference(program, folder)
    seed = 20261123
    random.seed(seed)
    out, kills = folder / "out", 0
    for shard in ("0/2", "1/2"):
        words = ("run", plan, "--shard", shard, "--jobs", 2, "-o", out)
        while True:
            enough = len(lines_of(out) if out.exists() else []) + random.randint(1, 4)
            run = start(program, *words)
            # Once it has got ahead, or has ended: neither a fast nor a slow machine decides.
            while run.poll() is None and len(lines_of(out) if out.exists() else []) < enough:
                time.sleep(0.002)
            time.sleep(random.uniform(0, 0.02))
            before = lines_of(out) if out.exists() else []
            run.kill()
            run.communicate()
            until(lambda: not children_of(run.pid))
            after = lines_of(out) if out.exists() else []
            assert set(before) <= set(after)
            if run.returncode == 0:
                break
            kills += 1
            files = sorted(out.glob("shard-*.jsonl")) if out.exists() else []
            if files:  # what a power cut may leave of a line
                with random.choice(files).open("a") as file:
                    file.write('{"key": "0123')
    run = start(program, "run", write_plan(folder / "long.json", LONG), "-o", folder / "long")
    child_at_work(run)
    run.kill()
    run.communicate()
    until(lambda: not children_of(run.pid), 2)  # it does not go on by itself
    records = records_of(out)
    assert kills >= 3, f"only {kills} kills (seed {seed})"
    assert sorted({r["key"] for r in records}) == sorted(r["key"] for r in records)  # none twice
    assert len(records) == CELLS
    assert merged(program, out, folder / "out.sqlite") == expected


def test_signals_stop_it(program, source, folder):
    for number in (signal.SIGINT, signal.SIGTERM):
        out = folder / str(number)
        run = start(program, "run", write_plan(folder / "plan.json", LONG + SMALL), "--jobs", 2, "-o", out)
        child_at_work(run)
        begin = time.monotonic()
        run.send_signal(number)
        out_text, err = run.communicate(timeout=20)
        taken = time.monotonic() - begin
        assert run.returncode == 3 and "the same command resumes" in err, (run.returncode, err)
        assert taken < 1, taken
        assert not children_of(run.pid)
        assert LONG[0]["n"] not in [r["cell"]["n"] for r in records_of(out)]


def test_limits_are_results(program, source, folder):
    plan = write_plan(folder / "plan.json", LONG + SMALL[1:], seconds=1)
    out = folder / "out"
    sweep(program, "run", plan, "-o", out, code=3)
    limited = [r for r in records_of(out) if r["status"] == "limit"]
    # The kernel limits what it counts in ticks; what it reports of a child differs from that by some.
    assert [r["signal"] for r in limited] == [signal.SIGXCPU] and 0.5 < limited[0]["cpu_s"] < 2.5, limited
    assert limited[0]["cell"]["n"] == 3000 and len(records_of(out)) == 5
    assert "1 limit" in sweep(program, "status", out, code=3).stdout
    done = sweep(program, "run", plan, "-o", out, code=3)
    assert "5 cells are finished already" in done.stderr and done.stdout == ""
    write_plan(folder / "plan.json", LONG + SMALL[1:], seconds=2)
    sweep(program, "run", plan, "-o", out, code=3)  # raised: tried again
    assert [r["seconds"] for r in records_of(out) if r["status"] == "limit"] == [1, 2]
    sweep(program, "merge", out, "-o", folder / "limits.sqlite", code=3)
    assert "'limit'" in exact_content(folder / "limits.sqlite")


def test_limits_above_those_in_force(program, source, folder):
    """They are refused at once, not cell by cell."""
    plan = write_plan(folder / "plan.json", SMALL[1:], seconds=500)
    done = sweep(program, "run", plan, "-o", folder / "out", code=2,
                 preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (400, 400)))
    assert "seconds: this limit is above the one in force here" in done.stderr, done.stderr
    assert not (folder / "out").exists()


def test_memory_is_a_result(program, source, folder):
    big = [{"structure": "sorted_list", "workload": "uniform-square", "n": 300000}]
    out = folder / "out"
    sweep(program, "run", write_plan(folder / "plan.json", SMALL[1:], megabytes=200), "-o", out)
    flags = json.loads(next(out.glob("*.jsonl")).read_text().splitlines()[0])["flags"]
    if "-fsanitize" in flags:
        return  # its shadow memory is larger than any limit
    sweep(program, "run", write_plan(folder / "plan.json", big, megabytes=200), "-o", out, code=3)
    memory = [r for r in records_of(out) if r["status"] == "memory"]
    assert len(memory) == 1 and memory[0]["peak_kb"] < 210000 and "memory" in memory[0]["message"], memory


def test_crash_is_a_result(program, source, folder):
    plan, out = write_plan(folder / "plan.json", LONG), folder / "out"
    words = ("run", plan, "-o", out)
    run = start(program, *words)
    os.kill(child_at_work(run), signal.SIGSEGV)
    run.communicate()
    assert run.returncode == 1
    assert [(r["status"], r["signal"]) for r in records_of(out)] == [("crash", signal.SIGSEGV)]
    assert "1 crash" in sweep(program, "status", out, code=1).stdout
    sweep(program, *words, code=1)  # it is known
    assert len(records_of(out)) == 1
    # --retry runs it again; a child that is killed from outside is no result.
    run = start(program, *words, "--retry")
    os.kill(child_at_work(run), signal.SIGKILL)
    run.communicate()
    statuses = sorted(r["status"] for r in records_of(out))  # two files of one second have no order
    assert statuses == ["crash", "killed"], statuses
    killed = folder / "killed"
    run = start(program, "run", plan, "-o", killed)
    os.kill(child_at_work(run), signal.SIGKILL)
    run.communicate()
    assert run.returncode == 3
    run = start(program, "run", plan, "-o", killed)
    child_at_work(run)
    run.send_signal(signal.SIGINT)
    run.communicate()


def test_other_commits_are_refused(program, source, folder):
    plan = write_plan(folder / "plan.json", SMALL[1:])
    out = folder / "out"
    sweep(program, "run", plan, "-o", out)
    path = next(out.glob("*.jsonl"))
    head, rest = path.read_text().split("\n", 1)
    other = json.loads(head)
    other["program"] = other["commit"] = "0123456789abcdef"
    path.write_text(json.dumps(other) + "\n" + rest)
    for words in (("run", plan, "-o", out), ("run", plan, "--fresh", "-o", out)):
        done = sweep(program, *words, code=2)
        assert f"{path}: line 1: its records are of another commit, 0123456789abcdef" in done.stderr, done
    assert len(list(out.iterdir())) == 1
    (out / "shard-9-x-y.jsonl").write_text(head + "\n")
    for verb in (("status", out), ("merge", out, "-o", folder / "x.sqlite")):
        assert "of another commit" in sweep(program, *verb, code=2).stderr
    assert not (folder / "x.sqlite").exists()


def test_conflicts_are_shown(program, source, folder):
    plan, out = write_plan(folder / "plan.json", SMALL[1:]), folder / "out"
    sweep(program, "run", plan, "-o", out)
    path = next(out.glob("*.jsonl"))
    head, first, rest = path.read_text().split("\n", 2)
    record = json.loads(first)
    record["cpu_s"] += 1
    (out / "shard-0-again.jsonl").write_text(head + "\n" + json.dumps(record) + "\n")
    sweep(program, "merge", out, "-o", folder / "fine.sqlite")
    for label, change in (("counts", lambda e: e["run"]["counters"].update(external=1)),
                          ("digest", lambda e: e.update(digest="0" * 64))):
        wrong = json.loads(first)
        change(wrong["exact"])
        (out / "shard-0-again.jsonl").write_text(head + "\n" + json.dumps(wrong) + "\n")
        done = sweep(program, "merge", out, "-o", folder / f"{label}.sqlite", code=1)
        shown = done.stderr.splitlines()
        assert first in shown and json.dumps(wrong, separators=(",", ":"), sort_keys=True) in [
            json.dumps(json.loads(line), separators=(",", ":"), sort_keys=True)
            for line in shown if line.startswith("{")], shown
        assert f"{path}, line 2:" in shown, shown
        assert not (folder / f"{label}.sqlite").exists()


def test_full_disk(program, source, folder):
    """Where a record does not fit nothing of it stays, and the same command resumes."""
    plan, expected = reference(program, folder)
    size = next((folder / "one").glob("*.jsonl")).stat().st_size

    def small_files():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (size // 3, size // 3))

    out = folder / "out"
    for _ in range(2):
        done = sweep(program, "run", plan, "-o", out, code=2, preexec_fn=small_files)
        assert "cannot be written" in done.stderr and "make room" in done.stderr, done.stderr
    paths = list(out.glob("*.jsonl"))
    assert len(paths) == 2 and all(p.read_text().endswith("\n") for p in paths)
    assert 0 < len(records_of(out)) < CELLS
    sweep(program, "run", plan, "-o", out)
    assert len(records_of(out)) == CELLS
    assert merged(program, out, folder / "out.sqlite") == expected


def test_cells_are_runs(program, source, folder):
    """A cell counts what `kinex gen` and `kinex run` count."""
    block = {"structure": "delaunay_2", "workload": "new-plans", "n": 12, "m": 30, "seed": 4, "until": "1/2"}
    sweep(program, "run", write_plan(folder / "plan.json", [block]), "-o", folder / "out")
    exact = records_of(folder / "out")[0]["exact"]
    scene = folder / "scene.json"
    subprocess.run([program, "gen", "new-plans", "--n", "12", "--m", "30", "--seed", "4", "--maintain",
                    "delaunay_2", "-o", scene], check=True)
    summary = json.loads(subprocess.run([program, "run", scene, "--until", "1/2", "--json"],
                                        capture_output=True, text=True, check=True).stdout)
    assert exact["digest"] == summary["log_digest"] and exact["scene_hash"] == summary["scene_hash"]
    own, theirs = exact["structures"]["delaunay_2"], summary["structures"]["delaunay_2"]
    for name in ("processed", "external", "failures", "records"):
        assert own["counters"][name] == theirs[name] > 0, name
    assert own["extremes"]["certificates_live"] == theirs["certificates"]["max_live"]
    assert own["bounds"] == theirs["bounds"] != []
    cell = sweep(program, "cell", json.dumps(block))
    assert json.loads(cell.stdout)["exact"] == exact
    listed = sweep(program, "list", folder / "plan.json", "--json").stdout
    assert json.loads(listed)["key"] == records_of(folder / "out")[0]["key"]


def test_cells_by_hand(program, source, folder):
    """Their exit codes are those of the program, and standard error says why."""
    cell = {"structure": "emst_lst", "workload": "uniform-square", "n": 10}
    refused = sweep(program, "cell", json.dumps(cell), code=2)
    assert json.loads(refused.stdout)["status"] == "refused"
    assert refused.stderr.startswith('kinex: cell: structure: "emst_lst" is not a known structure'), refused.stderr
    late = sweep(program, "cell", json.dumps({**LONG[0], "seed": 1}), "--seconds", 1, code=3)
    assert late.stdout == "" and "raise --seconds" in late.stderr, (late.stdout, late.stderr)
    cell.update(structure="emst_list", workload="no-such")
    assert "no-such" in sweep(program, "cell", json.dumps(cell), code=2).stderr


def test_plans(program, source, folder):
    """Plans that are committed can be run, and the schema agrees with the reader."""
    try:
        import jsonschema
    except ImportError:
        jsonschema = None
    schema = json.loads((source / "experiments/schemas/plan.schema.json").read_text())

    def accepted(plan):
        return jsonschema.Draft7Validator(schema).is_valid(plan) if jsonschema else None

    committed = sorted((source / "experiments/sweep/plans").glob("*.json"))
    assert len(committed) >= 2
    for path in committed:
        cells = sweep(program, "list", path).stdout.splitlines()
        assert len(cells) > 100, path
        assert accepted(json.loads(path.read_text())) is not False, path
    good = {"structure": "sorted_list", "workload": "grid", "n": 4}
    for change in ({"n": 0}, {"n": "4"}, {"seed": -1}, {"seed": {"from": 1}}, {"audit": "all"}, {"x": 1},
                   {"structure": []}, {"structure": "a,b"}, {"dimension": 4}, {"max_events": 0}):
        plan = folder / "bad.json"
        write_plan(plan, [dict(good, **change)])
        done = sweep(program, "list", plan, code=2)
        assert done.stderr.startswith(f"kinex: {plan}: /blocks/0/{next(iter(change))}"), (change, done.stderr)
        assert not accepted(json.loads(plan.read_text())), change
    for change in ({"n": [2, 3]}, {"seed": [0, 2**64 - 1]}, {"structure": [["sorted_list", "delaunay_2"]]},
                   {"until": 0.5}, {"until": ["1/2", 1]}, {"audit": ["end", "none"]}):
        write_plan(plan, [dict(good, **change)])
        sweep(program, "list", plan)
        assert accepted(json.loads(plan.read_text())) is not False, change
    for words in (("run", plan, "--shard", "4/4", "-o", folder), ("status", folder / "nowhere"),
                  ("status", folder), ("run", plan, "--jobs", 0, "-o", folder)):
        sweep(program, *words, code=2)


def main():
    # AddressSanitizer would make an exit code of the signal that is sent.
    options = os.environ.get("ASAN_OPTIONS")
    os.environ["ASAN_OPTIONS"] = (options + ":" if options else "") + "handle_segv=0"
    program, source = sys.argv[1], pathlib.Path(sys.argv[2])
    tests = {name[5:]: test for name, test in globals().items() if name.startswith("test_")}
    chosen = sys.argv[3].split(",") if len(sys.argv) > 3 else tests
    for name in chosen:
        begin = time.monotonic()
        with tempfile.TemporaryDirectory() as folder:
            tests[name](program, source, pathlib.Path(folder))
        print(f"{name}: fine, {time.monotonic() - begin:.1f} s", flush=True)


main()
