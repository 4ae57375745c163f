# SPDX-License-Identifier: GPL-3.0-or-later
"""Logs of which one thing was changed, counted, digested and sealed anew, have to be refused.

usage: mutations.py PROGRAM LOGCHECK_FOLDER LOGS [STRUCTURE,...|all [SEED]]

Makes LOGS random runs, of all structures (or of these) in turn, from SEED (default: a fixed one), and applies every kind
of change below to each log, at a random place where it is possible. LOGS may be "each": two short logs of each
structure.
Internal events that the checker reports as not followed (those of bodies, and of hulls with identical ties) are left
alone. An accepted log that means the same as the original one (see equivalent) is counted apart, and so is one within a
limit of the checker that its README states.
"""
import collections
import copy
import random
import sys
import tempfile
from fractions import Fraction

import logs

FEWEST, SHORT = 3, 30  # records of a log, if one among LOOKS of its structure has as many; else the shortest of them
LOOKS = 20
COMMON = ["motion", "insert", "erase", "settled", "rebuild"]


def decimal(t):
    """The decimal of a log: 12 significant digits, truncated."""
    if t == 0:
        return "0"
    leading = 0
    while Fraction(10) ** (leading + 1) <= abs(t):
        leading += 1
    while Fraction(10) ** leading > abs(t):
        leading -= 1
    digits = str(int(abs(t) / Fraction(10) ** (leading - 11)))
    sign = "-" if t < 0 else ""
    if not -5 <= leading <= 11:
        return "%s%s.%se%d" % (sign, digits[0], digits[1:], leading)
    if leading < 0:
        return "%s0.%s%s" % (sign, "0" * (-leading - 1), digits)
    return (sign + digits[:leading + 1] + "." + digits[leading + 1:]).rstrip(".")


def time_after(time):
    """A rational instant right after this one."""
    import roots

    p = tuple(int(c) for c in time["polynomial"])
    e = roots.cauchy_exponent(p)
    x = roots.isolate_square_free(p, -(1 << e), 1 << e, 0)[time["root"] - 1]
    if x.value is None:
        x.refine(100)
        t = Fraction(x.b, 1 << x.k)
    else:
        t = Fraction(*x.value) + Fraction(1, 1 << 100)
    return {"polynomial": [str(-t.numerator), str(t.denominator)], "root": 1, "interval": [str(t), str(t)],
            "decimal": decimal(t)}


class Mutator:
    def __init__(self, rng, modules, header, records, last, followed):
        self.rng, self.modules = rng, modules
        self.header, self.records, self.last = header, records, last
        self.followed = followed  # indices of records whose place in the log is checked
        self.kinds = {s["label"]: s["kinds"] for s in header["structures"]}

    def pick(self, condition=lambda r: True):
        places = [i for i in self.followed if condition(self.records[i])]
        return self.rng.choice(places) if places else None

    def event_out(self, records):
        i = self.pick()
        if i is not None:
            del records[i]
        return i

    def event_doubled(self, records):
        i = self.pick()
        if i is not None:
            records.insert(i, copy.deepcopy(records[i]))
        return i

    def two_exchanged(self, records):
        """With their times."""
        i = self.pick(lambda r: r is not self.records[-1])
        if i is None or i + 1 not in self.followed:
            return None
        records[i], records[i + 1] = records[i + 1], records[i]
        return i

    def two_exchanged_in_place(self, records):
        """The times stay."""
        i = self.pick(lambda r: r is not self.records[-1])
        if i is None or i + 1 not in self.followed:
            return None
        records[i], records[i + 1] = records[i + 1], records[i]
        records[i]["time"], records[i + 1]["time"] = records[i + 1]["time"], records[i]["time"]
        return i

    def neighbouring_root(self, records):
        import polynomials
        import roots

        def others(r):
            p = tuple(int(c) for c in r["time"]["polynomial"])
            if len(p) < 3:
                return []
            e = roots.cauchy_exponent(p)
            found = roots.isolate_square_free(p, -(1 << e), 1 << e, 0)
            return [(k, x) for k, x in enumerate(found, 1)
                    if abs(k - r["time"]["root"]) == 1 and x.value is None and polynomials.is_square_free(x.p)
                    and x.p == p]

        i = self.pick(others)
        if i is None:
            return None
        k, x = self.rng.choice(others(records[i]))
        time = records[i]["time"]
        x.refine(60)
        time["root"] = k
        time["interval"] = [str(Fraction(x.a, 1 << x.k)), str(Fraction(x.b, 1 << x.k))]
        low = Fraction(x.a if x.a >= 0 else x.b, 1 << x.k)
        time["decimal"] = decimal(low)
        return i

    def other_ids(self, records):
        i = self.pick(lambda r: r["ids"])
        if i is None:
            return None
        objects = [o for o in self.header["objects"] if o not in records[i]["ids"]]
        if not objects:
            return None
        count = len([o for o in records[i]["ids"] if o in self.header["objects"]])
        records[i]["ids"][self.rng.randrange(count)] = self.rng.choice(objects)
        return i

    def external_flag(self, records):
        i = self.pick()
        if i is not None:
            records[i]["external"] = not records[i]["external"]
        return i

    def coefficient(self, records):
        i = self.pick()
        if i is None:
            return None
        p = records[i]["time"]["polynomial"]
        k = self.rng.randrange(len(p))
        p[k] = str(int(p[k]) + 1)
        return i

    def ids_exchanged(self, records):
        i = self.pick(lambda r: len(r["ids"]) >= 2)
        if i is None:
            return None
        ids = records[i]["ids"]
        a, b = self.rng.sample(range(len(ids)), 2)
        ids[a], ids[b] = ids[b], ids[a]
        return i

    def end_cut(self, records):
        if not self.followed:
            return None
        i = self.rng.choice(self.followed)
        del records[i:]
        return i

    def kind(self, records):
        i = self.pick()
        if i is None:
            return None
        own = [k for k in self.kinds[records[i]["structure"]] if k != records[i]["kind"]]
        records[i]["kind"] = self.rng.choice(own)
        return i

    def a_little_later(self, records):
        """With all that follow it at its instant."""
        i = self.pick()
        if i is None:
            return None
        later = time_after(records[i]["time"])
        for r in records[i:]:
            if same_instant(r, self.records[i]):
                r["time"] = copy.deepcopy(later)
        return i

    def difference(self, records):
        i = self.pick(lambda r: "gone" in r)
        if i is None:
            return None
        side = self.rng.choice([s for s in ("gone", "came") if records[i][s]])
        change = self.rng.randrange(3)
        if change == 0:
            del records[i][side][self.rng.randrange(len(records[i][side]))]
            if not records[i]["gone"] and not records[i]["came"]:
                del records[i]["gone"], records[i]["came"]
                records[i]["external"] = False
        elif change == 1:
            records[i]["gone"], records[i]["came"] = records[i]["came"], records[i]["gone"]
        else:
            del records[i]["gone"], records[i]["came"]
            records[i]["external"] = False
        return i

    CHANGES = [event_out, event_doubled, two_exchanged, two_exchanged_in_place, neighbouring_root, other_ids,
               external_flag, coefficient, ids_exchanged, end_cut, kind, a_little_later, difference]


# Not equivalent, but not refused either: README says so.
SLOPES = {"sl", "sr", "st", "end"}  # kinds of a hull's claims about the slopes of two lines
LIMIT_HULL = "a limit: internal events of a hull at an instant that has several"
LIMIT_DELAUNAY = ("a limit: internal events, and the order of flips, at an instant with a blocked, reinsert, settled or "
                  "rebuild")


def same_instant(a, b):
    return (a["time"]["polynomial"], a["time"]["root"]) == (b["time"]["polynomial"], b["time"]["root"])


def equivalent(change, before, after, i, kinds):
    """Why the changed log says the same as the true one; None if it does not."""
    if before == after:
        return "nothing was changed"
    if change in ("two_exchanged", "two_exchanged_in_place") and same_instant(before[i], before[i + 1]):
        a, b = before[i], before[i + 1]
        if a["structure"] != b["structure"]:
            return "two structures at one instant"
        if "tie" in (a["kind"], b["kind"]):
            return "two ties at one instant"
        if not (a["external"] or b["external"]):
            return "two internal events at one instant"
    at = [r for r in before if same_instant(r, before[i]) and r["structure"] == before[i]["structure"]]
    if "yt" in kinds and not before[i]["external"] and change in ("event_out", "kind", "ids_exchanged", "other_ids"):
        if len([r for r in at if not r["external"]]) > 1:
            return LIMIT_HULL
    if "yt" in kinds and change == "kind" and {before[i]["kind"], after[i]["kind"]} <= SLOPES:
        return "two claims of a node about the same two lines, of which one record tells"
    if "yt" in kinds and change == "end_cut" and after:
        if all(not r["external"] and same_instant(r, after[-1]) for r in before[len(after):]):
            return LIMIT_HULL
    if "blocked" in kinds and any(r["kind"] in ("blocked", "reinsert", "settled", "rebuild") for r in at):
        if before[i]["kind"] in ("blocked", "reinsert") or change.startswith("two_exchanged"):
            return LIMIT_DELAUNAY
        if not before[i]["external"] and change in ("other_ids", "ids_exchanged", "event_out", "event_doubled",
                                                      "kind"):
            return LIMIT_DELAUNAY
    return None


def drawn_log(rng, program, folder, structure, known, each):
    """(path of the scene, where it is from, log) of a random run; of `each` structure a short one."""
    best = None
    looks = 0
    while True:
        path, where = logs.drawn_scene(rng, program, folder, structure, known)
        data = logs.run(program, folder, path)
        if data is None:
            continue
        records = len(logs.parsed(data)[1])
        if not each:
            if records or rng.random() >= 0.9:
                return path, where, data
            continue
        looks += 1
        rank = records < FEWEST, abs(records - FEWEST)
        if best is None or rank < best[0]:
            best = rank, path.read_text(), where, data
        if FEWEST <= records <= SHORT or looks >= LOOKS:
            _, scene, where, data = best
            path.write_text(scene)
            return path, where, data


def followed_records(done, records):
    partly = set(done.partly) | set(done.missing)
    return [i for i, r in enumerate(records) if r["external"] or r["structure"] not in partly]


def main():
    program, folder = sys.argv[1:3]
    modules = logs.checker(folder)
    logs.require_version(program)
    rng = random.Random(int(sys.argv[5]) if len(sys.argv) > 5 else 20261122)
    made, refused, same, accepted = (collections.Counter() for _ in range(4))
    reasons = collections.Counter()
    known = logs.Structures(program)
    structures = sys.argv[4].split(",") if len(sys.argv) > 4 and sys.argv[4] != "all" else known.all
    each = sys.argv[3] == "each"
    count = 2 * len(structures) if each else int(sys.argv[3])
    lines = 0
    with tempfile.TemporaryDirectory() as scratch:
        for number in range(count):
            structure = structures[number % len(structures)]
            path, where, data = drawn_log(rng, program, scratch, structure, known, each)
            header, records, last = logs.parsed(data)
            verdict, message, checked = logs.check(modules, data, path)
            if verdict != "fine":
                sys.exit(f"a log of {structure} ({where}) is refused: {message}\n{path.read_text()}")
            again = logs.sealed(*copy.deepcopy((header, records, last)))
            if logs.check(modules, again, path, {0})[0] != "fine":
                sys.exit(f"a log of {structure} ({where}), sealed again, is refused")
            lines += len(records)
            mutator = Mutator(rng, modules, header, records, last, followed_records(checked, records))
            for change in Mutator.CHANGES:
                name = change.__name__
                changed = copy.deepcopy(records)
                i = change(mutator, changed)
                if i is None:
                    continue
                made[name] += 1
                verdict, message, _ = logs.check(modules, logs.sealed(header, changed, copy.deepcopy(last)), path)
                if verdict != "fine":
                    refused[name] += 1
                    continue
                for k, r in enumerate(changed):
                    r["seq"] = k + 1
                why = equivalent(name, records, changed, i, mutator.kinds[records[i]["structure"]])
                if why:
                    same[name] += 1
                    reasons[why] += 1
                else:
                    accepted[name] += 1
                    print(f"ACCEPTED: {name} at record {i + 1} of {structure} ({where}): {records[i]}")
    print(f"{count} logs, {lines} records, {sum(made.values())} changes: {sum(refused.values())} refused, "
          f"{sum(same.values())} equivalent or within a stated limit, {sum(accepted.values())} accepted")
    for name in made:
        print(f"  {name:24} {made[name]:5} made {refused[name]:5} refused {same[name]:4} apart "
              f"{accepted[name]:4} accepted")
    for why, times in reasons.items():
        print(f"  accepted as {why}: {times}")
    if sum(made.values()) < 5 * count:
        sys.exit("too few changes were possible")
    sys.exit(1 if accepted else 0)


main()
