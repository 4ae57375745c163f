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
    refused(lambda: kinex.runs(folder / "scene.json"), "it holds no runs")
    refused(lambda: kinex.runs(folder / "missing"), "cannot be read")
    refused(lambda: kinex.counters(folder / "run.json", "flops"), "known are")


def test_fit():
    fit = kinex.fit_power([(n, 3 * n ** 1.5) for n in (2, 4, 8, 16)])
    assert abs(fit.exponent - 1.5) < 1e-9 and abs(fit.factor - 3) < 1e-9 and fit.error < 1e-6
    refused(lambda: kinex.fit_power([(2, 3), (2, 4)]), "two sizes")


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
    exponent = float(re.search(r"sorted_list: 20 runs, external ~ n\^([0-9.]+)", printed).group(1))
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
    assert again.returncode == 1 and "File exists" in again.stderr, again.stderr
    for run in kinex.runs(folder / "growth-example.sqlite"):
        assert run.arithmetic == "exact" and run.parameters["n"] == run.objects and run.seed in range(1, 6)


test_instants()
test_fit()
with tempfile.TemporaryDirectory() as scratch:
    for number, test in enumerate((test_log_and_summary, test_examples)):
        own = Path(scratch) / str(number)
        own.mkdir()
        test(own)
print("fine")
