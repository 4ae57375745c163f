# SPDX-License-Identifier: GPL-3.0-or-later
"""Event logs of version 2: lines, members, digest and seal (level 0)."""

import hashlib
import json
import re
import struct
from fractions import Fraction

from scene import LOG_REMEDY, BadInput, json_string, load_json

COMMON = ["motion", "insert", "erase", "settled", "rebuild"]
RATIONAL = re.compile(r"-?(?:0|[1-9]\d*)(?:/[1-9]\d*)?\Z")
INTEGER = re.compile(r"(?:0|-?[1-9]\d*)\Z")
HEX = re.compile(r"[0-9a-f]{64}\Z")


CUT_REMEDY = "run the scene again (kinex run SCENE --events LOG); kinex log shows what is there"


class Wrong(Exception):
    """An error in the log: its place, what is wrong, and a remedy of its own if there is one."""

    def __init__(self, what, line=None, remedy=None):
        super().__init__(what)
        self.line, self.remedy = line, remedy


def rational(text):
    """A number in lowest terms, as logs write it."""
    if not isinstance(text, str) or not RATIONAL.match(text):
        raise Wrong("%s is not a rational number in lowest terms" % json.dumps(text))
    value = Fraction(text)
    if str(value) != text:
        raise Wrong("%s is not in lowest terms: it is %s" % (text, value))
    return value


class Structure:
    def __init__(self, index, label, name, key, kinds, options=None):
        self.index, self.label, self.name, self.key, self.kinds = index, label, name, key, kinds
        self.options = options  # what it reads and its parameters


class Record:
    __slots__ = ("line", "seq", "structure", "kind", "ids", "predicate", "arguments", "external",
                 "reason", "gone", "came", "time", "names")

    def short(self):
        return "%s %s of %s" % (self.kind, json.dumps(self.names, ensure_ascii=False), self.structure.label)


def members(tree, required, optional, what):
    if not isinstance(tree, dict):
        raise Wrong("%s is not an object" % what)
    for key in required:
        if key not in tree:
            raise Wrong("%s has no member %s" % (what, json.dumps(key)))
    for key in tree:
        if key not in required and key not in optional:
            raise Wrong("%s has a member %s, which the format does not know" % (what, json.dumps(key)))


def refuse_scene(path, data, first):
    """The most likely mistake: the scene in place of its log."""
    if b'"format"' in first:
        return
    try:
        tree = json.loads(data)
    except (ValueError, RecursionError):
        return
    if isinstance(tree, dict) and "kinex" in tree:
        raise BadInput("%s: this is a scene, not an event log; write kinex-logcheck LOG --scene %s, with the log of "
                       "kinex run %s --events LOG" % (path, path, path))


def require(condition, what):
    if not condition:
        raise Wrong(what)


def printable(text):
    """For a report: what a terminal obeys is written out."""
    return "".join(c if c.isprintable() else ascii(c)[1:-1] for c in text)


def is_count(value):
    return isinstance(value, int) and not isinstance(value, bool) and value >= 0


def is_names(value):
    return isinstance(value, list) and all(isinstance(i, str) for i in value)


class Log:
    def __init__(self, path, data):
        self.path = path
        try:
            data.decode()
        except UnicodeDecodeError as error:
            raise BadInput("%s: not UTF-8 (byte %d); %s" % (path, error.start, LOG_REMEDY)) from None
        if not data.strip():
            raise BadInput("%s: the file is empty; %s" % (path, LOG_REMEDY))
        lines = data.split(b"\n")
        refuse_scene(path, data, lines[0])
        if lines[-1] == b"":
            lines.pop()
        elif len(lines) > 1 or b'"format"' in lines[0]:
            raise Wrong("the last line does not end with a newline: the file was cut", len(lines), CUT_REMEDY)
        first = load_json(lines[0].decode(), path, LOG_REMEDY)
        if not isinstance(first, dict) or first.get("format") != "kinex-log":
            raise BadInput("%s:1: not an event log of kinex; %s" % (path, LOG_REMEDY))
        if first.get("version") == 1:
            raise BadInput("%s:1: a log of version 1, which tells too little to be checked; run the scene "
                           "again: kinex run SCENE --events LOG" % path)
        if first.get("version") != 2:
            raise BadInput("%s:1: a log of version %s; this program reads version 2: take both from one release"
                           % (path, json.dumps(first.get("version"))))
        self.at(1, lambda: self.read_header(first))
        if len(lines) < 2:
            raise Wrong("the log ends after its header", 1)
        self.records = []
        for number in range(2, len(lines)):
            tree = self.parse(lines[number - 1], number)
            if isinstance(tree, dict) and "end" in tree and "seq" not in tree:
                raise Wrong("a last line, and lines after it", number)
            self.at(number, lambda: self.read_record(tree, number))
        last = self.parse(lines[-1], len(lines))
        if isinstance(last, dict) and "seq" in last:
            raise Wrong("the log has no last line: it was cut", len(lines), CUT_REMEDY)
        self.at(len(lines), lambda: self.read_last(last, lines, len(lines)))

    def parse(self, line, number):
        try:
            return load_json(line.decode(), "the record")
        except BadInput as error:
            raise Wrong(str(error), number) from None

    def at(self, number, read):
        try:
            read()
        except Wrong as error:
            if error.line is None:
                error.line = number
            raise

    def read_header(self, tree):
        members(tree, ["format", "version", "scene", "scene_hash", "arithmetic", "exact", "instants", "build",
                       "structures", "objects"], ["provenance"], "the header")
        if "provenance" in tree:
            made = tree["provenance"]
            members(made, ["commit", "dirty", "compiler", "flags", "libraries", "cpu", "command"], [],
                    "the header's provenance")
            require(all(isinstance(value, bool if key == "dirty" else str) for key, value in made.items()),
                    "the header's provenance is not written as one")
        for key in ("scene", "scene_hash", "arithmetic", "build"):
            require(isinstance(tree[key], str), "the header's %s is not a string" % key)
        require(HEX.match(tree["scene_hash"]), "the header's scene_hash is not a SHA-256")
        require(isinstance(tree["exact"], bool), "the header's exact is neither true nor false")
        require(tree["instants"] in ("names", "intervals", "none"),
                "the header's instants is not names, intervals or none")
        self.scene_hash, self.exact, self.instants = tree["scene_hash"], tree["exact"], tree["instants"]
        self.scene_name, self.arithmetic = tree["scene"], tree["arithmetic"]
        require(self.exact == (self.arithmetic in ("exact", "sturm")),
                "the arithmetic %s, and exact: %s" % (self.arithmetic, json.dumps(self.exact)))
        require(is_names(tree["objects"]) and len(set(tree["objects"])) == len(tree["objects"]),
                "the header's objects are not names, each once")
        self.objects = tree["objects"]
        self.number = {name: i for i, name in enumerate(self.objects)}
        require(isinstance(tree["structures"], list) and tree["structures"], "the header names no structures")
        self.structures = []
        for i, s in enumerate(tree["structures"]):
            members(s, ["label", "structure", "kinds"], ["key", "options"], "a structure of the header")
            require(isinstance(s["label"], str) and isinstance(s["structure"], str) and is_names(s["kinds"]),
                    "structure %d of the header is not written as one" % i)
            require(s["kinds"][-len(COMMON):] == COMMON and len(set(s["kinds"])) == len(s["kinds"]),
                    "the kinds of %s do not end with %s" % (s["label"], ", ".join(COMMON)))
            self.structures.append(Structure(i, s["label"], s["structure"], s.get("key"), s["kinds"],
                                             s.get("options")))
        self.labels = {s.label: s for s in self.structures}
        require(len(self.labels) == len(self.structures), "two structures have one label")

    def read_record(self, tree, line):
        members(tree, ["seq", "structure", "kind", "ids", "certificate", "external"],
                ["reason", "gone", "came", "time"], "the record")
        r = Record()
        r.line, r.seq = line, tree["seq"]
        require(is_count(r.seq) and r.seq == len(self.records) + 1,
                "record %s stands where number %d belongs" % (json.dumps(r.seq), len(self.records) + 1))
        r.structure = self.labels.get(tree["structure"]) if isinstance(tree["structure"], str) else None
        require(r.structure is not None, "the header knows no structure %s" % json.dumps(tree["structure"]))
        r.kind = tree["kind"]
        require(r.kind in r.structure.kinds, "%s has no events of kind %s"
                % (r.structure.label, json.dumps(r.kind)))
        require(is_names(tree["ids"]) and len(tree["ids"]) < 256, "the ids are not a list of names")
        r.names = tree["ids"]
        r.ids = tuple(self.number.get(name, name) for name in r.names)
        require(isinstance(tree["external"], bool), "external is neither true nor false")
        r.external = tree["external"]
        certificate = tree["certificate"]
        r.predicate, r.arguments = None, ()
        if certificate is not None:
            members(certificate, ["predicate", "ids"], [], "the certificate")
            require(isinstance(certificate["predicate"], str) and is_names(certificate["ids"]),
                    "the certificate is not a predicate and its arguments")
            r.predicate = certificate["predicate"]
            r.arguments = tuple(self.number.get(name, name) for name in certificate["ids"])
        r.reason = tree.get("reason")
        require((r.reason is not None) == (r.kind == "rebuild"),
                "a reason belongs to a rebuild, and to nothing else")
        require(r.reason is None or isinstance(r.reason, str), "the reason is not a string")
        require(("gone" in tree) == ("came" in tree), "gone and came do not stand together")
        r.gone, r.came = tree.get("gone"), tree.get("came")
        if r.gone is not None:
            for side in (r.gone, r.came):
                require(is_names(side) or (isinstance(side, list) and all(
                    is_names(one) and len(one) > 0 for one in side)),
                    "gone or came is neither a list of ids nor one of tuples of ids")
            require(r.gone or r.came, "gone and came are both empty")
        if r.kind in ("motion", "insert", "erase"):
            require(len(r.ids) == 1 and certificate is None and not r.external and r.gone is None,
                    "a %s names one object, has no certificate and is not external" % r.kind)
        if r.kind in ("settled", "rebuild"):
            require(certificate is None and not r.ids, "a %s names no objects and no certificate" % r.kind)
            require(r.external == (r.gone is not None),
                    "a %s is external if, and only if, it says what has changed" % r.kind)
            require(r.kind != "settled" or r.gone is not None, "a settled record without a change")
        self.read_time(r, tree.get("time"))
        self.records.append(r)

    def read_time(self, r, time):
        if self.instants == "none":
            require(time is None, "a time in a log whose header says that there are none")
            r.time = None
            return
        if not self.exact:
            members(time, ["decimal"], [], "the time")
        elif self.instants == "intervals":
            members(time, ["interval", "decimal"], [], "the time")
        else:
            members(time, ["polynomial", "root", "interval", "decimal"], [], "the time")
            require(isinstance(time["polynomial"], list) and len(time["polynomial"]) >= 2 and all(
                isinstance(c, str) and INTEGER.match(c) for c in time["polynomial"]),
                "the polynomial is not a list of integers, as strings")
            require(is_count(time["root"]) and time["root"] >= 1, "the root is not a number from 1")
        require(isinstance(time["decimal"], str), "the decimal is not a string")
        if self.exact:
            require(is_names(time["interval"]) and len(time["interval"]) == 2,
                    "the interval is not a pair of rational numbers")
        r.time = time

    def read_last(self, tree, lines, number):
        members(tree, ["end", "reached", "records", "external", "digest", "seal"], ["corrupt"], "the last line")
        require(tree["end"] in ("done", "limit", "interrupted"), "the run ended neither done nor stopped")
        self.end = tree["end"]
        self.corrupt = self.read_corrupt(tree["corrupt"]) if "corrupt" in tree else {}
        self.reached = None if tree["reached"] is None else rational(tree["reached"])
        require(tree["records"] == len(self.records) and is_count(tree["records"]),
                "%s records, says the last line; there are %d" % (json.dumps(tree["records"]), len(self.records)))
        external = sum(r.external for r in self.records)
        require(tree["external"] == external and is_count(tree["external"]),
                "%s external events, says the last line; there are %d" % (json.dumps(tree["external"]), external))
        digest = self.digest()
        require(tree["digest"] == digest, "the digest is %s, says the last line; it is %s" % (tree["digest"], digest))
        text = lines[-1]
        mark = b'"seal"'
        place = text.rfind(mark)
        place = text.index(b'"', text.index(b":", place)) + 1
        seal = hashlib.sha256(b"".join(line + b"\n" for line in lines[:-1]) + text[:place]).hexdigest()
        require(tree["seal"] == seal and text[place:].strip() == seal.encode() + b'"}',
                "the seal is broken: the file is not as it was written")

    def read_corrupt(self, tree):
        """The structures that an inexact arithmetic led into an impossible state, each with what was found."""
        require(isinstance(tree, dict) and tree and all(isinstance(text, str) and text for text in tree.values()),
                "corrupt is not an object of labels and texts")
        for label in tree:
            require(label in self.labels, "corrupt names %s, and the header has no such structure" % json.dumps(label))
        require(not self.exact, "a structure is corrupt in an exact arithmetic, where nothing can be")
        return tree

    def digest(self):
        """The digest covers the events and their order, not their times."""
        def array(items):
            return "[" + ",".join(items) + "]"

        names = [json_string(o) for o in self.objects]
        structures = [array([json_string(s.label), json_string(s.name), array(map(json_string, s.kinds))])
                      for s in self.structures]
        h = hashlib.sha256(("kinex-digest 2\n" + array(structures) + "\n" + array(names) + "\n").encode())

        def ids(names_):
            for name in names_:
                number = self.number.get(name)
                if number is not None:
                    yield struct.pack("<I", number)
                else:
                    text = name.encode()
                    yield struct.pack("<II", 0xffffffff, len(text)) + text

        for r in self.records:
            changed = r.gone is not None
            h.update(bytes([r.structure.index, r.structure.kinds.index(r.kind),
                            r.external + 2 * changed, len(r.names)]))
            h.update(b"".join(ids(r.names)))
            if changed:
                for side in (r.gone, r.came):
                    flat = [i for pair in side for i in (pair if isinstance(pair, list) else [pair])]
                    h.update(struct.pack("<I", len(flat)) + b"".join(ids(flat)))
        return h.hexdigest()
