# SPDX-License-Identifier: GPL-3.0-or-later
"""experiments/python: the reader of results, against what the program says, and its examples as their page gives them."""
import json
import math
import os
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from fractions import Fraction
from pathlib import Path

PROGRAM, SOURCE = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
PYTHON = SOURCE / "experiments" / "python"
sys.path.insert(0, str(PYTHON))
import kinex_results as kinex  # noqa: E402


def kinex_run(folder, *words):
    done = subprocess.run([PROGRAM, *words], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, (words, done.stderr)
    return done.stdout


def refused(call, message):
    try:
        call()
    except (kinex.ResultsError, ValueError) as error:
        assert message in str(error), error
        return
    raise AssertionError(f"not refused: {message}")


def test_instants():
    root = kinex.Instant([-2, 0, 1], 2, 1, 2)
    assert root.decimal(30) == "1.414213562373095048801688724209"
    assert float(root) == math.sqrt(2)
    near = root.refine(100)
    assert near.upper - near.lower <= Fraction(1, 2 ** 100) and near.lower ** 2 < 2 < near.upper ** 2
    negative = kinex.Instant([-2, 0, 1], 1, -2, -1)
    assert negative.decimal(5) == "-1.41421" and negative < 0 < root and root > negative and root != 2
    # The same number as a root of (t^2 - 2)(t + 3), and a number 10^-40 beside it.
    same = kinex.Instant([-6, -2, 3, 1], 3, Fraction(5, 4), 2)
    assert root == same and not root < same and root <= same
    beside = kinex.Instant([-2 * 10 ** 40 - 1, 0, 10 ** 40], 2, 1, 2)
    assert root < beside and beside > root and root.decimal(20) == beside.decimal(20)
    half = kinex.Instant([-1, 2], 1, 0, 1)  # rational, but not known to be
    assert half == Fraction(1, 2) and half.decimal(3) == "0.500" and half.refine(3).is_rational
    assert kinex.Instant([-1, 3], 1, Fraction(1, 3), Fraction(1, 3)) == Fraction(1, 3)
    refused(lambda: kinex.Instant([-1, 2], 1, 1, 0), "is empty")
    refused(lambda: kinex.Instant.from_log({"decimal": "1"}), "--instants names")


def test_log_and_summary(folder):
    kinex_run(folder, "gen", "uniform-square", "--n", "14", "--seed", "5", "-o", "scene.json")
    kinex_run(folder, "run", "scene.json", "--maintain", "delaunay_2,sorted_list", "--events", "run.log",
              "--summary", "run.json")
    log = kinex.read_log(folder / "run.log")
    summary = json.loads((folder / "run.json").read_text())
    runs = {run.structure: run for run in kinex.runs(folder / "run.json")}
    assert set(runs) == {"delaunay_2", "sorted_list"}
    assert log.end["end"] == "done" and len(log.records) == summary["records"]
    for label, run in runs.items():
        assert len(log.of(structure=label, external=True)) == run.counters["external"]
        assert run.digest == log.end["digest"] and run.bounds and all(bound.holds for bound in run.bounds)
    flips = log.of(kind="flip")
    assert len(flips) == runs["delaunay_2"].counters["kind.flip"] > 0
    assert all("p3" in record.ids + record.certificate_ids for record in log.of(object="p3"))
    # Instants ascend, exactly; decimals agree with the log's own.
    for before, after in zip(log.records, log.records[1:]):
        assert before.instant <= after.instant
    for record in log.records:
        assert abs(float(record.instant) - record.time) <= 1e-11 * max(1, abs(record.time))
        assert kinex.value_at(record.instant.polynomial, Fraction(10 ** 9)) != 0
    # In lockstep with the program's own table.
    table = kinex_run(folder, "log", "run.log", "--csv", "--filter", "kind=flip").splitlines()
    assert len(table) == len(flips) + 1
    assert [int(row.split(",")[0]) for row in table[1:]] == [record.seq for record in flips]
    # Cut off in the midst of a line: what is whole is read.
    text = (folder / "run.log").read_text()
    (folder / "cut.log").write_text(text[:len(text) * 2 // 3])
    cut = kinex.read_log(folder / "cut.log")
    assert cut.end is None and 0 < len(cut.records) < len(log.records)
    refused(lambda: kinex.read_log(folder / "scene.json"), "does not begin an event log")
    refused(lambda: kinex.runs(folder / "scene.json"), "it holds no runs (it has no member 'structures')")
    refused(lambda: kinex.runs(folder / "missing"), "cannot be read")
    for name, data, message in (("base", b"SQLite format 3\0\xff", "it is a SQLite database, not a text; runs() and growth.py read databases"),
                                ("run.log.gz", b"\x1f\x8b\x08\xff", "it is a compressed file (gzip), not a text; unpack it by gunzip"),
                                ("bytes", b"{\xff", "it is no text in UTF-8 (byte 1); give a file that kinex has written")):
        (folder / name).write_bytes(data)
        refused(lambda: kinex.read_log(folder / name), f"{folder / name}: {message}")
    refused(lambda: kinex.runs(folder / "bytes"), "it is no text in UTF-8")
    # Ids with other ends of lines.
    odd = json.loads((folder / "scene.json").read_text())
    for number, one in enumerate(odd["objects"]):
        one["id"] = f"a\u2028b\u0085c\u2029{number}"
    (folder / "odd.json").write_text(json.dumps(odd))
    kinex_run(folder, "run", "odd.json", "--maintain", "sorted_list", "--events", "odd.log")
    assert len(kinex.read_log(folder / "odd.log").records) > 0
    refused(lambda: kinex.counters(folder / "run.json", "flops"), "take one that they have:")


def test_fit():
    fit = kinex.fit_power([(n, 3 * n ** 1.5) for n in (2, 4, 8, 16)])
    assert abs(fit.exponent - 1.5) < 1e-9 and abs(fit.factor - 3) < 1e-9 and fit.error < 1e-6
    refused(lambda: kinex.fit_power([(2, 3), (2, 4)]), "two sizes")
    refused(lambda: kinex.fit_power([(1, 0), (2, 3), (3, 4)]), "no power fits the point (1, 0)")


def test_numbers():
    for text, value in (("-7", -7), ("1/3", Fraction(1, 3)), ("0.25", Fraction(1, 4)), ("1e-9", Fraction(1, 10 ** 9)),
                        ("0x1.8p+3", 12), ("-0x1p-1200", -Fraction(1, 2 ** 1200)), ("0x.8", Fraction(1, 2))):
        assert kinex.exact(text) == value, text
    for text in ("abc", "1/0", "0x", "0x1.8p", ""):
        refused(lambda: kinex.exact(text), f"{text!r} is no number")


def test_names_of_databases(folder):
    kinex_run(folder, "verify", "sorted_list", "--quick", "-o", "odd")
    for name in ("r#1.sqlite", "r?1.sqlite", "r%41.sqlite"):
        (folder / name).write_bytes((folder / "odd" / "verify.sqlite").read_bytes())
        assert kinex.runs(folder / name)


def test_limits_and_zeros(folder):
    """Runs that ended at a limit, and counts of 0, are in no fit, and the message says so."""
    block = {"structure": ["sorted_list"], "workload": "uniform-square", "n": [20, 40, 80], "seed": {"from": 1, "to": 2}}
    for name, more in (("limits", {"max_events": 30}), ("whole", {})):
        (folder / f"{name}-plan.json").write_text(json.dumps({"kinex_plan": 1, "name": name, "blocks": [{**block, **more}]}))
        kinex_run(folder, "sweep", "run", f"{name}-plan.json", "-o", name)
        kinex_run(folder, "sweep", "merge", name, "-o", f"{name}.sqlite")
    code, _, err = example(folder, "growth.py", "limits.sqlite", "external", "limits.svg")
    assert code == 2 and "(left out: 6 that ended at a limit); run more sizes, to their end" in err, err
    code, _, err = example(folder, "growth.py", "whole.sqlite", "internal", "zeros.svg")
    assert code == 2 and "(left out: 6 with internal 0, which fit no power)" in err, err
    kinex_run(folder, "gen", "uniform-square", "--n", "20", "--seed", "1", "-o", "one.json")
    kinex_run(folder, "run", "one.json", "--maintain", "sorted_list", "--summary", "one-summary.json")
    swept = next(run for run in kinex.runs(folder / "whole.sqlite") if run.objects == 20 and run.seed == 1)
    of_summary, = kinex.runs(folder / "one-summary.json")
    for name in ("external", "certificates_created", "certificates_retracted"):
        assert swept.counters[name] == of_summary.counters[name], name
    for name in ("certificates_live", "certificates_per_object"):
        assert swept.extremes[name] == of_summary.extremes[name], name


def commands_of_page():
    """Those of the examples, in order; the first block says where files go."""
    blocks = re.findall(r"(?ms)^```sh\n(.*?)^```$", (PYTHON / "README.md").read_text())
    return [line for block in blocks[1:] for line in block.splitlines()]


def test_examples(folder):
    """Every command of the page, as it stands there."""
    commands = commands_of_page()
    assert len(commands) == 9, commands
    printed = ""
    for command in commands:
        words = re.sub(r"^kinex ", f"{PROGRAM} ", re.sub(r"^python3 ", sys.executable + " ", command))
        done = subprocess.run(words, shell=True, cwd=folder, capture_output=True, text=True, check=False,
                              env={**os.environ, "EXAMPLES": str(PYTHON / "examples")})
        assert done.returncode == 0, (command, done.stderr)
        printed += done.stdout
    exponent = float(re.search(r"sorted_list on uniform-square, 2 axes, degree 1: 20 runs, external ~ n\^([0-9.]+)", printed).group(1))
    assert 1.9 < exponent < 2.2, exponent  # Theta(n^2)
    nearest = float(re.search(r"the nearest are 2\^(-[0-9.]+) apart", printed).group(1))
    assert nearest < -60, nearest
    assert "enter      external" in printed
    for name in ("growth.svg", "close.svg", "events.svg"):
        drawing = ElementTree.fromstring((folder / name).read_text())
        points = len(drawing.findall(".//{*}circle"))
        points += sum(path.get("d").count("L") for path in drawing.findall(".//{*}path"))
        assert points > 30, (name, points)
    # A figure that exists is not replaced.
    again = subprocess.run([sys.executable, PYTHON / "examples/events_in_time.py", "square.log", "events.svg"], cwd=folder,
                           capture_output=True, text=True, check=False)
    assert again.returncode == 2, again
    assert again.stderr == "kinex: events.svg: File exists; add --force to replace it\n", again.stderr
    # Nor is the input, under this name or another, whatever is said.
    (folder / "link.log").symlink_to("square.log")
    for words in (("events_in_time.py", "square.log"), ("close_instants.py", "near.log"), ("growth.py", "growth-example.sqlite", "external")):
        name = words[1]
        before = (folder / name).read_bytes()
        for target in (name, f"../{folder.name}/{name}", *(["link.log"] if name == "square.log" else [])):
            code, _, err = example(folder, *words, target, "--force")
            assert code == 2 and f"{target}: it is the input itself; give the figure another name\n" in err, (words, err)
        assert (folder / name).read_bytes() == before, name
    code, _, err = example(folder, "close_instants.py", "growth-example.sqlite", "x.svg")
    assert code == 2 and "growth-example.sqlite: it is a SQLite database" in err and "Traceback" not in err, err
    for run in kinex.runs(folder / "growth-example.sqlite"):
        assert run.arithmetic == "exact" and run.parameters["n"] == run.objects and run.seed in range(1, 6)


def example(folder, script, *words):
    done = subprocess.run([sys.executable, PYTHON / "examples" / script, *map(str, words)], cwd=folder,
                          capture_output=True, text=True, check=False)
    return done.returncode, done.stdout, done.stderr


def growth(folder, *words):
    return example(folder, "growth.py", *words)


def test_growth_of_verify(folder):
    """One fit for each structure, workload, dimension and degree, of a database that mixes them."""
    kinex_run(folder, "verify", "sorted_list", "--quick", "-o", "w")
    base = folder / "w" / "verify.sqlite"
    wanted = {}
    for run, value in kinex.counters(base, "external"):
        if run.arithmetic == "exact" and value > 0:
            key = run.workload, run.parameters["dimension"], run.parameters["degree"]
            wanted.setdefault(key, []).append((run.objects, value))
    wanted = {key: points for key, points in wanted.items() if len({n for n, _ in points}) > 1}
    code, out, err = growth(folder, base, "external", "w.svg")
    assert code == 0 and f"kinex: {base}: left out: " in err, (out, err)
    lines = out.splitlines()
    assert len(lines) == len(wanted) >= 4, lines
    for (workload, axes, degree), points in wanted.items():
        name = f"sorted_list on {workload}, " + ("1 axis, " if axes == 1 else "") + f"degree {degree}: {len(points)} runs, "
        line = next(one for one in lines if one.startswith(name))
        assert f"external ~ n^{kinex.fit_power(points).exponent:.3f}" in line, line
    texts = [text.text for text in ElementTree.fromstring((folder / "w.svg").read_text()).findall(".//{*}text")]
    assert "sorted_list on uniform-square, 1 axis, degree 1" in texts and "objects n" in texts, texts
    code, out, _ = growth(folder, base, "external", "one.svg", "--workload", "sort-worst", "--degree", 2, "--dimension", 0)
    assert code == 0 and out.startswith("sorted_list on sort-worst, degree 2: ") and out.count("\n") == 1, out
    assert "Growth of the number of external events on sort-worst" in (folder / "one.svg").read_text()
    # Errors.
    code, _, err = growth(folder, "missing.sqlite", "external", "x.svg")
    assert code == 2 and err == "kinex: missing.sqlite: cannot be read: No such file or directory; check the name\n", err
    code, _, err = growth(folder)
    assert code == 2 and err.startswith("kinex: growth.py: the following arguments are required: results"), err
    assert err.endswith("; growth.py --help says what it takes\n"), err
    code, _, err = growth(folder, base, "external", "x.svg", "--workload", "sort-best")
    assert code == 2 and "no series is chosen; its series are:\n  --structure sorted_list --workload sort-worst" in err, err
    code, _, err = growth(folder, base, "flops", "x.svg")
    assert code == 2 and "no run has 'flops'; take one that they have: " in err, err
    cut = folder / "cut.sqlite"
    cut.write_bytes(base.read_bytes()[:5000])
    code, _, err = growth(folder, cut, "external", "x.svg")
    assert code == 2 and "no whole database" in err and "Traceback" not in err, err


def test_too_many_series(folder):
    """They are listed with the options that choose them."""
    lines = ['{"kinex-runs": 1}'] + [
        json.dumps({"key": f"sorted_list uniform-square n={n} d={d} m={m} seed=1", "processed": n, "external": n * n})
        for n in (4, 8) for d in (1, 2) for m in range(1, 5)]
    (folder / "runs.jsonl").write_text("\n".join(lines) + "\n")
    code, _, err = growth(folder, "runs.jsonl", "external", "x.svg")
    assert code == 2 and "8 series, which are too many for one picture; choose 6 at most by --structure," in err, err
    options = re.findall(r"(?m)^  (--structure .*?)  \(2 runs, n 4, 8\)$", err)
    assert len(options) == 8, err
    for one in options:
        code, out, err = growth(folder, "runs.jsonl", "external", "x.svg", "--force", *one.split())
        assert code == 0 and out.count("\n") == 1 and "external ~ n^2.000" in out, (one, out, err)


test_instants()
test_fit()
test_numbers()
with tempfile.TemporaryDirectory() as scratch:
    for number, test in enumerate((test_log_and_summary, test_examples, test_growth_of_verify, test_too_many_series, test_limits_and_zeros,
                                   test_names_of_databases)):
        own = Path(scratch) / str(number)
        own.mkdir()
        test(own)
print("fine")
