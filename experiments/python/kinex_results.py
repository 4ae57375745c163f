# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of kinex in Python: runs, counters, exact numbers, event logs, instants.

Standard library only; pandas is imported by frame() alone. One import:

    import kinex_results as kinex
    for run in kinex.runs("results.sqlite"):           # or verify.sqlite, summary.json, runs.jsonl
        print(run.structure, run.objects, run.counters["external"])
    log = kinex.read_log("square.log")
    first = log.records[0].instant                     # exact: compare it, refine it
    print(first.refine(200).lower, first.decimal(50))

Counts are int, exact numbers Fraction, seconds float.
"""
import json
import math
import re
import sqlite3
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import Any, Optional

from kinex_instants import Instant, greatest_common_divisor, value_at  # noqa: F401


class ResultsError(Exception):
    """A file that cannot be used: "FILE: PROBLEM; REMEDY"."""


def exact(text):
    """A number as kinex writes or reads it, as a Fraction: "-7", "1/3", "0.25", "1e-9", "0x1.8p+3"."""
    try:
        if isinstance(text, str) and re.fullmatch(r"\s*[+-]?0[xX].*", text):
            return _hexadecimal(text)
        return Fraction(text)
    except (ValueError, ZeroDivisionError, TypeError) as error:
        raise ResultsError(f"{text!r} is no number; write it as -7, 1/3, 0.25, 1e-9 or 0x1.8p+3") from error


def _hexadecimal(text):
    """Of any size: float.fromhex would round."""
    parts = re.fullmatch(r"\s*([+-]?)0[xX]([0-9a-fA-F]*)\.?([0-9a-fA-F]*)(?:[pP]([+-]?[0-9]+))?\s*", text)
    if parts is None or not parts[2] + parts[3]:
        raise ValueError
    sign, whole, after, power = parts.groups()
    size = int(whole + after, 16) * Fraction(2) ** (int(power or 0) - 4 * len(after))
    return -size if sign == "-" else size


# ---- what files hold -----------------------------------------------------------------------------

@dataclass
class Run:
    """One run of one structure. What a file does not say is None or empty."""
    source: str                       # the file
    structure: str                    # its label: in "maintain"
    workload: Optional[str] = None
    parameters: dict = field(default_factory=dict)  # n, degree, ..; separation is a Fraction
    scene: Optional[str] = None
    scene_hash: Optional[str] = None
    arithmetic: Optional[str] = None
    seed: Optional[int] = None
    objects: Optional[int] = None
    status: Optional[str] = None      # done, limit or interrupted
    digest: Optional[str] = None      # of the event log
    seconds: Optional[float] = None   # CPU time
    counters: dict = field(default_factory=dict)    # name -> int; a sum over stages where there are any
    extremes: dict = field(default_factory=dict)    # name -> int
    bounds: list = field(default_factory=list)      # Bound

    def row(self):
        """Flat, for tables."""
        flat = {name: value for name, value in vars(self).items()
                if name not in ("parameters", "counters", "extremes", "bounds")}
        return {**self.parameters, **flat, **self.counters, **self.extremes}


@dataclass
class Bound:
    """A hard bound that was checked at the end of a run."""
    id: str
    bound: int
    observed: int
    holds: bool
    source: str


@dataclass
class Record:
    """One line of an event log."""
    seq: int
    structure: str
    kind: str
    ids: list
    external: bool
    predicate: Optional[str]          # of the certificate that failed
    certificate_ids: list
    instant: Optional[Instant]        # exact logs with --instants names
    time: Optional[float]             # a decimal; None where the log has no times
    gone: Any = None
    came: Any = None
    reason: Optional[str] = None

    def row(self):
        return {**vars(self), "ids": " ".join(self.ids), "certificate_ids": " ".join(self.certificate_ids)}


@dataclass
class Log:
    """An event log: header (as written), records, last line (None: the run was cut off)."""
    header: dict
    records: list
    end: Optional[dict]

    def of(self, structure=None, kind=None, object=None, external=None):
        """The records that have all of these."""
        return [r for r in self.records
                if structure in (None, r.structure) and kind in (None, r.kind)
                and external in (None, r.external)
                and (object is None or object in r.ids or object in r.certificate_ids)]


# ---- runs and counters ----------------------------------------------------------------------------

_FILES_OF_RUNS = "give verify.sqlite, a merged sweep, a summary of kinex run or runs.jsonl of kinex reproduce"


def runs(path):
    """All runs of a file: verify.sqlite, the database of kinex sweep merge, a summary of kinex run
    (one Run for each structure), or the runs.jsonl of kinex reproduce."""
    path = Path(path)
    with _opened(path) as file:
        begin = file.read(16)
    if begin.startswith(b"SQLite format 3"):
        return _runs_of_database(path)
    text = _text(path)
    try:
        if text.startswith('{"kinex-runs"') or path.suffix == ".jsonl":
            return _runs_of_lines(path, text)
        return _runs_of_summary(path, json.loads(text))
    except KeyError as error:
        raise ResultsError(f"{path}: it holds no runs (it has no member {error}); {_FILES_OF_RUNS}") from error
    except (ValueError, TypeError, AttributeError) as error:
        raise ResultsError(f"{path}: it holds no runs ({error}); {_FILES_OF_RUNS}") from error


def counters(path, name):
    """[(run, value)] of all runs of the file that have the counter or extreme `name`."""
    found = []
    for run in runs(path):
        value = run.counters.get(name, run.extremes.get(name))
        if value is not None:
            found.append((run, value))
    if not found:
        known = sorted({key for run in runs(path) for key in (*run.counters, *run.extremes)})
        raise ResultsError(f"{path}: no run has {name!r}; take one that they have: {', '.join(known) or 'none'}")
    return found


def _opened(path):
    try:
        return open(path, "rb")
    except OSError as error:
        raise ResultsError(f"{path}: cannot be read: {error.strerror}; check the name") from error


def _text(path):
    """Of a file that should be text."""
    with _opened(path) as file:
        data = file.read()
    for magic, what, remedy in ((b"SQLite format 3", "a SQLite database", "runs() and growth.py read databases"),
                                (b"\x1f\x8b", "a compressed file (gzip)", "unpack it by gunzip")):
        if data.startswith(magic):
            raise ResultsError(f"{path}: it is {what}, not a text; {remedy}")
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError as error:
        raise ResultsError(f"{path}: it is no text in UTF-8 (byte {error.start}); give a file that kinex has written") from error


def _parameters(text):
    parameters = json.loads(text)
    return {name: exact(value) if name == "separation" else value for name, value in parameters.items()}


def _runs_of_database(path):
    try:
        base = sqlite3.connect(path.resolve().as_uri() + "?mode=ro", uri=True)
    except sqlite3.Error as error:
        raise ResultsError(f"{path}: it cannot be opened ({error})") from error
    base.row_factory = sqlite3.Row
    try:
        tables = {row[0] for row in base.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}
        if not {"run", "cell", "counter", "extreme"} <= tables:
            raise ResultsError(f"{path}: it has no table of runs; give verify.sqlite or a merged sweep")
        swept = "attempt" in tables
        return (_swept_runs if swept else _verified_runs)(path, base)
    except (sqlite3.Error, ValueError, KeyError, IndexError) as error:
        raise ResultsError(f"{path}: no whole database ({error}); make it anew by kinex verify or kinex sweep merge") from error
    finally:
        base.close()


def _sums(rows, key):
    """{key: {name: sum}}"""
    sums = {}
    for row in rows:
        of = sums.setdefault(key(row), {})
        of[row["name"]] = of.get(row["name"], 0) + int(row["value"])
    return sums


def _verified_runs(path, base):
    counts = _sums(base.execute("SELECT run_id, name, value FROM counter"), lambda r: r["run_id"])
    largest = _sums(base.execute("SELECT run_id, name, value_text AS value FROM extreme"), lambda r: r["run_id"])
    result = []
    for row in base.execute("SELECT run.*, cell.workload, cell.params_json FROM run "
                            "JOIN cell ON cell.id = run.cell_id ORDER BY run.id"):
        result.append(Run(str(path), row["structure"], row["workload"], _parameters(row["params_json"]),
                          row["scene"], row["scene_hash"], row["number_mode"], int(row["seed"]),
                          row["objects"], row["status"], None, row["cpu_s"],
                          counts.get(row["id"], {}), largest.get(row["id"], {})))
    return result


def _swept_runs(path, base):
    def key(row):
        return row["run_id"], row["structure"]
    counts = _sums(base.execute("SELECT run_id, structure, name, value FROM counter"), key)
    largest = _sums(base.execute("SELECT run_id, structure, name, value_text AS value FROM extreme"), key)
    bounds = {}
    for row in base.execute("SELECT * FROM bound ORDER BY number"):
        bounds.setdefault(key(row), []).append(
            Bound(row["bound_id"], int(row["bound"]), int(row["observed"]), bool(row["holds"]), row["source"]))
    seconds = dict(base.execute("SELECT cell_id, min(cpu_s) FROM attempt WHERE status = 'done' GROUP BY cell_id"))
    labels = {}
    for run_id, structure in sorted(set(counts) | set(largest) | set(bounds)):
        labels.setdefault(run_id, []).append(structure)
    result = []
    for row in base.execute("SELECT run.*, cell.structure, cell.workload, cell.params_json FROM run "
                            "JOIN cell ON cell.id = run.cell_id ORDER BY run.id"):
        whole = counts.get((row["id"], ""), {})
        for label in [one for one in labels.get(row["id"], []) if one] or [row["structure"]]:
            at = (row["id"], label)
            result.append(Run(str(path), label, row["workload"], _parameters(row["params_json"]),
                              row["scene"], row["scene_hash"], row["number_mode"],
                              None if row["seed"] is None else int(row["seed"]), row["objects"],
                              row["status"], row["digest"], seconds.get(row["cell_id"]),
                              {**whole, **counts.get(at, {})}, largest.get(at, {}), bounds.get(at, [])))
    return result


def _runs_of_summary(path, summary):
    result = []
    for label, one in summary["structures"].items():
        names = ("processed", "external", "internal", "failures", "rebuilds", "simultaneous_groups")
        counts = {name: one[name] for name in names if name in one}
        counts.update({"kind." + kind: value for kind, value in one.get("by_kind", {}).items()})
        certificates = one.get("certificates", {})
        counts.update({"certificates_" + name: certificates[name] for name in ("created", "retracted") if name in certificates})
        largest = {name: certificates[key] for name, key in (("certificates_live", "max_live"),
                                                             ("certificates_per_object", "max_per_object"),
                                                             ) if key in certificates}
        bounds = [Bound(b["id"], int(b["bound"]), int(b["observed"]), b["holds"], b.get("source", ""))
                  for b in one.get("bounds", [])]
        seconds = summary.get("seconds", {}).get("structures", {}).get(label)
        result.append(Run(str(path), label, None, {}, summary["scene"], summary["scene_hash"],
                          summary["arithmetic"], None, summary["objects"], summary["status"],
                          summary["log_digest"], seconds, counts, largest, bounds))
    return result


def _runs_of_lines(path, text):
    result = []
    for line in text.split("\n"):  # other ends of lines may be in names
        if not line.endswith("}"):
            continue  # the last line of a run that was cut off
        record = json.loads(line)
        if "key" not in record or "processed" not in record:
            continue
        structure, workload, *words = record["key"].split(" ")
        parameters = dict(word.split("=", 1) for word in words if "=" in word)
        seed = parameters.pop("seed", None)
        parameters = {name: exact(value) if name == "separation" else int(value)
                      for name, value in parameters.items()}
        if "d" in parameters:
            parameters["dimension"] = parameters.pop("d")
        counts = {name: record[name] for name in ("processed", "external", "signs") if name in record}
        counts.update({"kind." + kind: value for kind, value in record.get("kinds", {}).items()})
        largest = {name: record[key] for name, key in (("certificates_live", "max_live"),
                                                       ("certificates_per_object", "max_per_object")) if key in record}
        result.append(Run(str(path), structure, workload, parameters, arithmetic="exact",
                          seed=None if seed is None else int(seed), objects=parameters.get("n"),
                          seconds=record.get("seconds"), counters=counts, extremes=largest))
    return result


# ---- event logs -------------------------------------------------------------------------------------

def read_log(path):
    """An event log of kinex run --events, whole or cut off."""
    lines = _text(path).split("\n")  # other ends of lines may be in names
    if lines[-1] == "":
        lines.pop()
    try:
        header = json.loads(lines[0])
        if header["format"] != "kinex-log" or header["version"] != 2:
            raise ValueError("another format")
    except (IndexError, ValueError, KeyError, TypeError) as error:
        raise ResultsError(f"{path}: line 1: it does not begin an event log of version 2; make one with "
                           "kinex run SCENE --events FILE") from error
    named = header["exact"] and header["instants"] == "names"
    records, end, instants = [], None, {}
    for number, line in enumerate(lines[1:], 2):
        try:
            record = json.loads(line)
            if "end" in record:
                end = record
                break
            records.append(_record(record, named, instants))
        except (ValueError, KeyError, TypeError) as error:
            if number == len(lines):
                break  # cut off in the midst of a line
            raise ResultsError(f"{path}: line {number}: it is no record ({error}); kinex check tells more") from error
    return Log(header, records, end)


def _record(record, named, instants):
    certificate = record["certificate"] or {"predicate": None, "ids": []}
    time = record.get("time")
    instant = None
    if named:
        text = json.dumps(time)
        if text not in instants:  # records of one instant share it
            instants.clear()
            instants[text] = Instant.from_log(time)
        instant = instants[text]
    return Record(record["seq"], record["structure"], record["kind"], record["ids"], record["external"],
                  certificate["predicate"], certificate["ids"], instant,
                  None if time is None else float(time["decimal"]),
                  record.get("gone"), record.get("came"), record.get("reason"))


# ---- tables and fits ---------------------------------------------------------------------------------

def frame(things):
    """Runs or records as a pandas.DataFrame. Needs pandas; nothing else here does."""
    import pandas
    return pandas.DataFrame([thing.row() for thing in things])


@dataclass
class PowerFit:
    """y = factor x^exponent, by least squares of the logarithms; 95 % of the exponent if there are
    three points or more (normal errors are assumed)."""
    factor: float
    exponent: float
    error: Optional[float]            # half the length of the 95 % interval

    def __call__(self, x):
        return self.factor * x ** self.exponent


# 0.975 quantiles of Student's t for 1, 2, .. degrees of freedom
_STUDENT = (12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228)


def fit_power(points):
    """Through positive (x, y) with two different x or more."""
    for x, y in points:
        if not (x > 0 and y > 0):
            raise ResultsError(f"no power fits the point ({x}, {y}), which has no logarithm; leave it out")
    logs = [(math.log(x), math.log(y)) for x, y in points]
    if len({x for x, _ in logs}) < 2:
        raise ResultsError("a power has to be fitted to two sizes or more; give more runs")
    mean_x = sum(x for x, _ in logs) / len(logs)
    mean_y = sum(y for _, y in logs) / len(logs)
    spread = sum((x - mean_x) ** 2 for x, _ in logs)
    exponent = sum((x - mean_x) * (y - mean_y) for x, y in logs) / spread
    offset = mean_y - exponent * mean_x
    degrees = len(logs) - 2
    error = None
    if degrees > 0:
        rest = sum((y - offset - exponent * x) ** 2 for x, y in logs)
        quantile = _STUDENT[degrees - 1] if degrees <= len(_STUDENT) else 2.0
        error = quantile * math.sqrt(rest / degrees / spread)
    return PowerFit(math.exp(offset), exponent, error)
