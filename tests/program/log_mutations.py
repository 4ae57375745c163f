# SPDX-License-Identifier: GPL-3.0-or-later
"""kinex check refuses event logs in which any member of any kind of line was tampered with.

usage: log_mutations.py PROGRAM
Of real logs one line of every form is taken: header, last line, and records of each kind with each
set of members. Every member of it, at any depth, is changed, removed, doubled and moved. With the old
seal every mutant must be refused. With counts, digest and seal made anew all but those of BY_REPLAY
must be: these are wrong about the run and right about themselves, and a replay of the events
(kinex-logcheck) is what finds them; those of BY_SCENE are refused where the scene is given; those of
STILL_TRUE say the same in other words.
"""
import copy
import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import log_files  # noqa: E402

# (kind of line, path, what was done): accepted with a new seal.
BY_REPLAY = {
    ("record", "reason", "changed"),         # the text is not interpreted
    ("record", "certificate", "null"),       # events that settle ties have none
    ("record", "external", "changed"),       # of kinds that are external at times (see SOMETIMES)
    ("record", "gone", "shortened"), ("record", "came", "shortened"),
    ("record", "ids", "shortened"), ("record", "ids", "doubled"),
    ("record", "", "removed"),               # the whole line; numbers are made anew
}
BY_SCENE = {
    ("header", "scene", "changed"),
    ("header", "objects", "shortened"),      # an object that no record names
    # So small a change that root, interval and decimal still fit.
    ("record", "time/polynomial/*", "plus one"),
    ("last", "reached", "plus one"),         # after the scene's end
}
STILL_TRUE = {
    ("record", "time/interval/*", "plus one"),  # another interval that isolates the root
}
SOMETIMES = {"replace", "swap", "pass", "flip"}  # of tournaments, heaps, triangulations

RUNS = [  # gen arguments, run arguments
    (["come-and-go", "--n", "8"], ["--maintain", "sorted_list,delaunay_2"]),
    (["grid", "--n", "9"], ["--maintain", "delaunay_2,convex_hull_2"]),
    (["uniform-square", "--n", "6"], ["--maintain", "sorted_list:y,maximum_tournament,maximum_heap"]),
    (["polygon-fan", "--n", "4", "--m", "4"], ["--maintain", "separation_mixed"]),
    (["uniform-square", "--n", "5"], ["--maintain", "sorted_list", "--instants", "intervals"]),
    (["uniform-square", "--n", "5"], ["--maintain", "sorted_list", "--instants", "none"]),
    (["uniform-square", "--n", "5"], ["--maintain", "sorted_list", "--arithmetic", "double"]),
]


class Members(list):
    """The members of an object as pairs, so that one can be there twice."""


def dump(value):
    if isinstance(value, Members):
        return "{" + ", ".join(json.dumps(k) + ": " + dump(v) for k, v in value) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(dump(v) for v in value) + "]"
    return json.dumps(value, ensure_ascii=False)


def plain(value):
    """As dictionaries; nothing may be there twice."""
    if isinstance(value, Members):
        return {k: plain(v) for k, v in value}
    if isinstance(value, list):
        return [plain(v) for v in value]
    return value


def load(text):
    return json.loads(text, object_pairs_hook=Members)


def changed(value):
    """(how, other value) for a value that is no object."""
    if value is None:
        yield "changed", "x"
    elif isinstance(value, bool):
        yield "changed", not value
    elif isinstance(value, int):
        yield "changed", value + 1
    elif isinstance(value, str):
        yield "changed", value + "x"
        if value.lstrip("-").isdigit():
            yield "plus one", str(int(value) + 1)
    elif isinstance(value, list) and not isinstance(value, Members):
        if value:
            yield "shortened", value[:-1]
            yield "doubled", value + value[-1:]


def mutants(value, path=""):
    """(path, how, mutant) for everything inside of an object or array."""
    if isinstance(value, Members):
        for i, (key, inner) in enumerate(value):
            here = path + "/" + key if path else key

            def with_member(new, i=i, value=value):
                return Members(value[:i] + new + value[i + 1:])
            yield here, "removed", with_member([])
            yield here, "named twice", with_member([value[i], value[i]])
            if i + 1 < len(value):
                yield here, "moved", Members(value[:i] + [value[i + 1], value[i]] + value[i + 2:])
            for how, other in changed(inner):
                yield here, how, with_member([(key, other)])
            if isinstance(inner, Members):
                yield here, "null", with_member([(key, None)])
            if isinstance(inner, list):
                for where, how, mutant in mutants(inner, here):
                    yield where, how, with_member([(key, mutant)])
    else:
        for i, inner in list(enumerate(value))[:2]:
            for how, other in changed(inner):
                yield path + "/*", how, value[:i] + [other] + value[i + 1:]
            if isinstance(inner, list):
                for where, how, mutant in mutants(inner, path + "/*"):
                    yield where, how, value[:i] + [mutant] + value[i + 1:]


def form(line):
    keys = [k for k, _ in line]
    kind = "header" if "format" in keys else "last" if "end" in keys else "record"
    members = dict(line)
    certificate = members.get("certificate") is not None
    return kind, members.get("kind"), members.get("structure"), certificate, tuple(keys)


class Check:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        self.count, self.wrong = 0, []

    def refused(self, text, scene=None):
        self.count += 1
        log = self.folder / "mutant.jsonl"
        log.write_text(text)
        command = [self.program, "check", str(log)]
        if scene:
            command += ["--scene", str(scene)]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode not in (0, 1, 2) or (done.returncode != 0 and "kinex: " not in done.stderr):
            self.wrong.append(f"exit code {done.returncode}: {done.stderr}\n{text}")
        return done.returncode != 0

    def complain(self, what, kind, line):
        self.wrong.append(f"{what}: {kind}: {dump(line)[:300]}")


def resealed(lines):
    if any(has_double(line) for line in lines):
        text = "".join(dump(line) + "\n" for line in lines)
        marker = '"seal": "'
        place = text.rfind(marker) + len(marker)
        return text[:place] + log_files.hashlib.sha256(text[:place].encode()).hexdigest() + '"}\n'
    as_plain = [plain(line) for line in lines]
    if "seal" not in as_plain[-1] or list(as_plain[-1])[-1] != "seal":
        return "".join(dump(line) + "\n" for line in lines)  # nothing to seal
    return log_files.sealed_anew(as_plain) if last_is_whole(as_plain[-1]) else log_files.text_of(as_plain)


def last_is_whole(last):
    return list(last) == ["end", "reached", "records", "external", "digest", "seal"]


def has_double(value):
    if isinstance(value, Members):
        keys = [k for k, _ in value]
        return len(set(keys)) < len(keys) or any(has_double(v) for _, v in value)
    return isinstance(value, list) and any(has_double(v) for v in value)


def expected(kind, record_kind, structure, path, how):
    key = (kind, path, how)
    if key == ("record", "external", "changed"):
        at_times = structure == "delaunay_2" if record_kind in ("enter", "leave") else record_kind in SOMETIMES
        return "replay" if at_times else "refused"
    if key in STILL_TRUE:
        return "true"
    return "replay" if key in BY_REPLAY else "scene" if key in BY_SCENE else "refused"


def mutate(check, text, scene, seen):
    lines = [load(one) for one in text.splitlines()]
    if check.refused(text, scene):
        check.complain("a log of the program was refused", "", lines[0])
    for i, line in enumerate(lines):
        this = form(line)
        if this in seen:
            continue
        seen.add(this)
        for path, how, mutant in mutants(line):
            tampered = lines[:i] + [mutant] + lines[i + 1:]
            if not check.refused("".join(dump(one) + "\n" for one in tampered)):
                check.complain(f"{path} {how}, the old seal", this[0], mutant)
            # What the new seal is made of: counts and digest of the last line stay as they are stated.
            if this[0] == "last" and path in ("records", "external", "digest", "seal"):
                anew = log_files.text_of([plain(o) for o in tampered]) \
                    if not has_double(mutant) and path != "seal" else resealed(tampered)
                if path == "seal" or (path, how) == ("digest", "moved"):
                    continue  # a new seal stands at the end again
            else:
                anew = resealed(tampered)
            due = expected(*this[:3], path, how)
            refused = check.refused(anew)
            if not refused and due == "refused":
                check.complain(f"{path} {how}, a new seal", this[0], mutant)
            if not refused and due == "scene" and not check.refused(anew, scene):
                check.complain(f"{path} {how}, a new seal, with the scene", this[0], mutant)
    # Whole lines: the old seal sees each; a new one only where something else does.
    for i in (1, len(lines) // 2, len(lines) - 2):
        if not 1 <= i < len(lines) - 1:
            continue
        for tampered in (lines[:i] + lines[i + 1:], lines[:i + 1] + lines[i:],
                         lines[:i - 1] + [lines[i], lines[i - 1]] + lines[i + 1:]):
            if not check.refused("".join(dump(one) + "\n" for one in tampered)):
                check.complain("a line removed, doubled or moved, the old seal", "", lines[i])
    # Hunted down by the scene: another polynomial's certificate, another scene.
    for i, line in enumerate(lines[1:-1], 1):
        members = dict(line)
        if members.get("certificate") is None or "polynomial" not in dict(members.get("time", [])):
            continue
        other = copy.deepcopy(lines)
        ids = dict(dict(other[i])["certificate"])["ids"]
        if len(ids) < 2 or dict(lines[0])["objects"][0].count("."):
            break
        ids[0], ids[1] = ids[1], ids[0]
        if scene and "polygon" not in scene.read_text() and not check.refused(resealed(other), scene):
            check.complain("a certificate with its objects exchanged", "record", other[i])
        break


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        check, seen = Check(program, folder), set()
        for number, (generate, run) in enumerate(RUNS):
            scene, log = folder / f"scene-{number}.json", folder / f"{number}.jsonl"
            subprocess.run([program, "gen", *generate, "--seed", "2", "-o", str(scene)], check=True,
                           capture_output=True)
            subprocess.run([program, "run", str(scene), *run, "--events", str(log)], check=True,
                           capture_output=True)
            mutate(check, log.read_text(), scene, seen)
    kinds = {one[0] for one in seen}
    if kinds != {"header", "record", "last"} or len(seen) < 15 or check.count < 500:
        check.wrong.append(f"only {len(seen)} forms of lines and {check.count} mutants")
    print("\n".join(check.wrong[:20]) or f"{check.count} logs, {len(seen)} forms of lines")
    return 1 if check.wrong else 0


sys.exit(main())
