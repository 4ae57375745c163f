# SPDX-License-Identifier: GPL-3.0-or-later
"""Event logs of version 2 as Python data: digest and seal computed again, without kinex.

The format is described in experiments/formats/event_log.h and experiments/formats/log_digest.h.
"""
import hashlib
import json
import struct


def compact(value):
    """Compact JSON as the digest takes it."""
    if isinstance(value, list):
        return "[" + ",".join(compact(v) for v in value) + "]"
    out = '"'
    for c in value:
        if c in '"\\':
            out += "\\" + c
        elif ord(c) < 0x20 or ord(c) == 0x7f:
            out += "\\u%04x" % ord(c)
        else:
            out += c
    return out + '"'


def digest(header, records):
    """Of records as far as their names are known."""
    structures = header["structures"]
    head = "kinex-digest 2\n"
    head += compact([[s["label"], s["structure"], s["kinds"]] for s in structures]) + "\n"
    head += compact(header["objects"]) + "\n"
    sha = hashlib.sha256(head.encode())
    places = {name: i for i, name in enumerate(header["objects"])}
    labels = {s["label"]: i for i, s in enumerate(structures)}

    def ids(names):
        data = b""
        for name in names:
            if name in places:
                data += struct.pack("<I", places[name])
            else:
                text = name.encode()
                data += struct.pack("<II", 0xffffffff, len(text)) + text
        return data

    def flat(side):
        return [name for entry in side for name in (entry if isinstance(entry, list) else [entry])]

    for record in records:
        structure = labels.get(record.get("structure"))
        if structure is None or record.get("kind") not in structures[structure]["kinds"]:
            continue
        kind = structures[structure]["kinds"].index(record["kind"])
        change = "gone" in record
        flags = (1 if record["external"] else 0) | (2 if change else 0)
        sha.update(struct.pack("<BBBB", structure, kind, flags, len(record["ids"])))
        sha.update(ids(record["ids"]))
        if change:
            for side in (flat(record["gone"]), flat(record["came"])):
                sha.update(struct.pack("<I", len(side)) + ids(side))
    return sha.hexdigest()


def line(value):
    return json.dumps(value, ensure_ascii=False) + "\n"


def text_of(lines):
    """The lines with a new seal in the last one."""
    text = "".join(line(one) for one in lines[:-1])
    last = dict(lines[-1])
    last.pop("seal", None)
    text += line(last)[:-2] + ', "seal": "'
    return text + hashlib.sha256(text.encode()).hexdigest() + '"}\n'


def sealed_anew(lines):
    """With counts, digest and seal made again."""
    header, records = lines[0], lines[1:-1]
    last = dict(lines[-1])
    last["records"] = len(records)
    last["external"] = sum(1 for r in records if r.get("external") is True)
    try:
        last["digest"] = digest(header, records)
    except (KeyError, TypeError, ValueError, AttributeError, struct.error):
        pass  # not even the form of a log
    return text_of([header, *records, last])


def parsed(text):
    return [json.loads(one) for one in text.splitlines()]
