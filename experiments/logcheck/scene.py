# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes: objects, flight plans, what is maintained, and the hash that logs name.

Numbers are read exactly as they are written. The hash of a scene is the SHA-256 of its canonical text
(canonical_text below), which has everything that has a meaning and nothing else: it does not depend on the
layout of the file.
"""

import hashlib
import json
import re
from fractions import Fraction
from math import lcm

from families import USUALLY_READ
from parameters import is_known, unusual
from subsets import sets_of

MOST_EXPONENT = 100000  # of a decimal number
HEX = re.compile(r"([+-]?)0[xX]([0-9a-fA-F]*)(?:\.([0-9a-fA-F]*))?(?:[pP]([+-]?\d+))?\Z")
DECIMAL = re.compile(r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE]([+-]?\d+))?(?:/\d+)?\Z")


class BadInput(Exception):
    """A file that cannot be read as what its name or its place in the command line says."""


def exact(value, place):
    """The number that is written; floats arrive here as their own text (see load_json)."""
    if isinstance(value, bool) or not isinstance(value, (int, str)):
        raise BadInput("%s: %r is not a number; %s" % (place, value, CORRECT_IT))
    if isinstance(value, int):
        return Fraction(value)
    text = value.strip()
    match = HEX.match(text)
    if match:
        sign, whole, part, exponent = match.groups()
        digits = whole + (part or "")
        if digits:
            shift = int(exponent or 0) - 4 * len(part or "")
            if abs(shift) <= MOST_EXPONENT:
                result = Fraction(int(digits, 16)) * Fraction(2) ** shift
                return -result if sign == "-" else result
    elif match := DECIMAL.match(text):
        if abs(int(match.group(1) or 0)) <= MOST_EXPONENT:
            numerator, _, denominator = text.partition("/")
            if not denominator or int(denominator):
                return Fraction(numerator) / (int(denominator) if denominator else 1)
    raise BadInput("%s: %s is not a number that this program reads; %s" % (place, json.dumps(value), CORRECT_IT))


def whole(value, place):
    """The integer that is written, as 2, 2.0 or 2e0."""
    number = exact(value, place)
    if number.denominator != 1:
        raise BadInput("%s: %s is not an integer; %s" % (place, value, CORRECT_IT))
    return int(number)


CORRECT_IT = "correct it there: kinex check SCENE says how"
SCENE_REMEDY = "give the scene that was run, as kinex gen or kinex import writes it"
LOG_REMEDY = "give an event log, as kinex run SCENE --events LOG writes it"


def load_json(text, name, remedy=None):
    def unique(pairs):
        result = {}
        for key, value in pairs:
            if key in result:
                raise BadInput("%s: the member %s stands twice in one object; remove one of the two"
                               % (name, json.dumps(key)))
            result[key] = value
        return result

    try:
        return json.loads(text, parse_float=str, object_pairs_hook=unique)
    except (ValueError, RecursionError) as error:
        where = ""
        if isinstance(error, json.JSONDecodeError):
            where = " at line %d, column %d (%s)" % (error.lineno, error.colno, error.msg[0].lower() + error.msg[1:])
        raise BadInput("%s: not JSON%s%s" % (name, where, "; " + remedy if remedy else "")) from None


def stripped(coefficients):
    """Without zeros at the end."""
    n = len(coefficients)
    while n > 1 and coefficients[n - 1] == 0:
        n -= 1
    return coefficients[:n]


class Piece:
    """A flight plan: one coefficient list per axis (a body has four: its origin's two and its
    rotor's), in force from `start` to `end` (None: open)."""

    def __init__(self, start, end, axes):
        self.start, self.end, self.axes = start, end, axes
        # The same, as integer polynomials over one positive denominator.
        self.denominator = lcm(*(c.denominator for axis in axes for c in axis))
        self.polynomials = []
        for axis in axes:
            p = [int(c * self.denominator) for c in axis]
            while p and p[-1] == 0:
                p.pop()
            self.polynomials.append(tuple(p))

    def position(self, axis, t):
        value = Fraction(0)
        for c in reversed(self.axes[axis]):
            value = value * t + c
        return value

    def meets(self, other, t, body):
        if any(self.position(i, t) != other.position(i, t) for i in range(2 if body else len(self.axes))):
            return False
        if not body:
            return True
        return self.position(2, t) * other.position(3, t) == self.position(3, t) * other.position(2, t)


class Extended(list):
    """The axes of a position, with those of the extents of the disc or box there: a radius, or half extents; or with the
    weight of the point."""

    def __init__(self, axes, dimension):
        super().__init__(axes[:dimension])
        self.extents = axes[dimension:]

    def half(self, axis):
        """Half the width along an axis."""
        return self.extents[min(axis, len(self.extents) - 1)]


class Object:
    def __init__(self, name, pieces, polygon):
        self.name, self.pieces, self.polygon = name, pieces, polygon
        self.open = False  # written as one motion, not as a list of pieces
        self.colour, self.ends = "", []  # the ends of an edge of a graph: two vertices
        self.line = False  # the line y = a x + b by its axes (a, b)
        self.extents = None  # "radius", "half_extents", "weight": axes of the motion behind those of the position


class Request:
    def __init__(self, structure, key, label, parameters=(), sets=(), over=None):
        self.structure, self.key, self.label = structure, key, label
        self.parameters = parameters  # (name, value), those that have another value than usual
        self.sets = sets  # (name, value) of "of", "query" and "colours" (subsets.py)
        self.over = over  # the request for what it reads in place of the usual structure; None: that one


class Scene:
    """`ids`: object names in the scene's order; an object's number is its place there."""

    def __init__(self, path, text):
        self.path = path
        if '"kinex-log"' in text.partition("\n")[0]:
            raise BadInput("%s: this is an event log, not a scene; %s" % (path, SCENE_REMEDY))
        tree = load_json(text, path, SCENE_REMEDY)
        if not isinstance(tree, dict) or "kinex" not in tree or whole(tree["kinex"], path + ": /kinex") != 1:
            raise BadInput("%s: not a kinex scene of version 1; %s" % (path, SCENE_REMEDY))
        try:
            self.read(tree)
        except (KeyError, TypeError, IndexError, AttributeError, ZeroDivisionError) as error:
            raise BadInput("%s: not a scene: %s %s; %s"
                           % (path, type(error).__name__, error, CORRECT_IT)) from None
        self.hash = self.hash_of_text()
        # Of structures that are not known here: whether a parameter has its usual value is not known, either.
        self.hashes = {self.hash}
        for request in self.maintain:
            request.parameters = [one for one in request.parameters if is_known(request.structure, one[0])]
        self.hashes.add(self.hash_of_text())

    def hash_of_text(self):
        return hashlib.sha256(canonical_text(self).encode()).hexdigest()

    def read(self, tree):
        self.name = tree.get("name", "")
        self.dimension = whole(tree["dimension"], self.path + ": /dimension")
        self.start = exact(tree["time"]["start"], self.path + ": /time/start")
        end = tree["time"].get("end")
        self.end = None if end is None else exact(end, self.path + ": /time/end")
        self.jumps = tree.get("jumps", False)
        self.overlapping_starts = tree.get("overlapping_starts", "refused")
        self.objects = [self.read_object(o, "%s: /objects/%d" % (self.path, i))
                        for i, o in enumerate(tree["objects"])]
        self.ids = [o.name for o in self.objects]
        self.number = {name: i for i, name in enumerate(self.ids)}
        if len(self.number) != len(self.ids):
            raise BadInput("%s: two objects have one id; give one of them another: kinex check SCENE says which"
                           % self.path)
        self.bodies = any(o.polygon for o in self.objects)
        if any(o.extents == "weight" for o in self.objects):
            for o in self.objects:
                if o.extents is None:  # its weight is 0
                    o.extents = "weight"
                    o.pieces = [Piece(p.start, p.end, p.axes + [[Fraction(0)]]) for p in o.pieces]
        kinds = {o.extents for o in self.objects}
        if len(kinds) > 1:
            raise BadInput("%s: objects of different extents; give all of them a radius, half_extents, a weight or none"
                           % self.path)
        self.extents = kinds.pop() if kinds else None
        self.maintain = [self.read_request(r) for r in tree.get("maintain", [])]
        self.queries = [(exact(q["at"], self.path + ": /queries"),
                         [[exact(c, self.path + ": /queries") for c in side] for side in q["box"]])
                        for q in tree.get("queries", [])]
        self.changes = self.plan()

    def degree(self):
        """The largest degree in t of a position."""
        return max((len(a) - 1 for o in self.objects for p in o.pieces for a in p.axes[:self.dimension]), default=0)

    def read_object(self, tree, place):
        extents = next((k for k in ("radius", "half_extents", "weight")
                        for owner in [tree, tree["motion"][0]] if k in owner), None)

        def numbers(list_, where):
            if not isinstance(list_, list) or not list_:
                raise BadInput("%s: a coefficient list is missing; %s" % (where, CORRECT_IT))
            return stripped([exact(c, "%s/%d" % (where, i)) for i, c in enumerate(list_)])

        polygon = [[exact(c, place + "/polygon") for c in v] for v in tree.get("polygon", [])]

        def axes(coordinates, owner, where):
            result = [numbers(a, "%s/%d" % (where, i)) for i, a in enumerate(coordinates)]
            if len(result) != self.dimension:
                raise BadInput("%s: %d axes in a scene of %d; %s" % (where, len(result), self.dimension, CORRECT_IT))
            if polygon:
                result += [numbers(a, where + "/rotor") for a in owner.get("rotor", [[1], [0]])]
            if extents == "radius":
                result.append(numbers(owner["radius"], where + "/radius"))
            elif extents == "weight":
                weight = tree["weight"] if "weight" in tree else owner["weight"]
                result.append(numbers(weight if isinstance(weight, list) else [weight], where + "/weight"))
            elif extents:
                result += [numbers(a, where + "/half_extents") for a in owner["half_extents"]]
                if len(result) != 2 * self.dimension:
                    raise BadInput("%s: half extents of another number than of axes; %s" % (where, CORRECT_IT))
            return result

        motion = tree["motion"]
        if not isinstance(motion[0], dict):
            pieces = [Piece(None, None, axes(motion, tree, place + "/motion"))]
        else:
            pieces = []
            for i, p in enumerate(motion):
                where = "%s/motion/%d" % (place, i)
                times = [exact(p[k], where + "/" + k) if k in p else None for k in ("from", "to")]
                pieces.append(Piece(*times, axes(p["coordinates"], p, where)))
        result = Object(tree["id"], pieces, polygon)
        result.extents = extents
        result.line = tree.get("line", False)
        result.colour, result.ends = tree.get("colour", ""), tree.get("ends", [])
        return result

    def read_key(self, key):
        """("axis", i), ("direction", [..]) or ("distance", object number)."""
        if isinstance(key, str) and key in "xyz"[:self.dimension] and key:
            return ("axis", "xyz".index(key))
        if isinstance(key, dict) and list(key) == ["direction"]:
            return ("direction", [exact(c, "a direction") for c in key["direction"]])
        if isinstance(key, dict) and list(key) == ["squared_distance_to"]:
            if key["squared_distance_to"] in self.number:
                return ("distance", self.number[key["squared_distance_to"]])
        raise BadInput("%s: %s is not a key of a scene of dimension %d; %s"
                       % (self.path, json.dumps(key), self.dimension, CORRECT_IT))

    def read_request(self, tree):
        if isinstance(tree, str):
            return Request(tree, ("axis", 0), tree)
        return Request(tree["structure"], self.read_key(tree.get("key", "x")),
                       tree.get("as", tree["structure"]),
                       unusual(tree["structure"], tree, lambda value: exact(value, self.path + ": /maintain")),
                       sets_of(tree, self), self.read_over(tree.get("over")))

    def read_over(self, tree):
        """The request for another structure to be read, without a label."""
        if tree is None:
            return None
        over = self.read_request(tree)
        over.label = over.structure
        return None if over.structure in USUALLY_READ and request_text(over, self)[0] == '"' else over

    # ---- flight plans

    def plan(self):
        """[(t, rank, object, piece)] by t, rank and object; rank 0: a new flight plan, 1: the object
        disappears, 2: it appears. `first` has the pieces in force right after the start."""
        self.first = {}
        changes = []
        for number, o in enumerate(self.objects):
            present, ended = False, None
            for piece in o.pieces:
                start = self.start if piece.start is None else max(piece.start, self.start)
                if piece.end is not None and piece.end <= start:
                    continue
                if self.end is not None and self.end < start:
                    break
                if present and ended is not None and ended < start:
                    changes.append((ended, 1, number, None))
                    present = False
                if not present and start == self.start:
                    self.first[number] = piece
                else:
                    changes.append((start, 0 if present else 2, number, piece))
                present = True
                ended = piece.end
                if ended is None:
                    break
                if self.end is not None and ended >= self.end:
                    ended = None  # another piece may begin at the end
            if present and ended is not None:
                changes.append((ended, 1, number, None))
        changes.sort(key=lambda c: c[:3])
        return changes

    def end_at(self, end):
        """The scene as if it ended earlier: no object disappears at that time."""
        self.changes = [c for c in self.changes if c[:2] != (end, 1)]


# ---- the canonical text


def json_string(text):
    out = ['"']
    for c in text:
        if c in '"\\':
            out.append("\\" + c)
        elif c < " " or c == "\x7f":
            out.append("\\u%04x" % ord(c))
        else:
            out.append(c)
    return "".join(out) + '"'


def number_text(x):
    """An integer of at most 53 bits as it is, every other number as a string, n/d in lowest terms."""
    if x.denominator == 1 and abs(x.numerator).bit_length() <= 53:
        return str(x.numerator)
    return '"%s"' % x


def numbers_text(numbers):
    return "[" + ", ".join(map(number_text, numbers)) + "]"


def axes_text(axes):
    return "[" + ", ".join(map(numbers_text, axes)) + "]"


def trajectory_text(axes, body, extents, dimension):
    text = axes_text(axes[:2] if body else axes[:dimension])
    if extents == "radius":
        text += ', "radius": ' + numbers_text(axes[-1])
    elif extents == "half_extents":
        text += ', "half_extents": ' + axes_text(axes[dimension:])
    if body and axes[2:] != [[1], [0]]:
        text += ', "rotor": ' + axes_text(axes[2:])
    return text


def common_weight(o):
    """The weight that all pieces have, or None."""
    weights = [p.axes[-1] for p in o.pieces]
    return weights[0] if all(w == weights[0] for w in weights) else None


def weight_text(weight):
    return number_text(weight[0]) if len(weight) == 1 else numbers_text(weight)


def motion_text(o, dimension):
    body = bool(o.polygon)
    first = o.pieces[0]
    own_weights = o.extents == "weight" and common_weight(o) is None
    if len(o.pieces) == 1 and first.start is None and first.end is None:
        return trajectory_text(first.axes, body, o.extents, dimension)
    pieces = []
    for p in o.pieces:
        members = []
        if p.start is not None:
            members.append('"from": ' + number_text(p.start))
        if p.end is not None:
            members.append('"to": ' + number_text(p.end))
        members.append('"coordinates": ' + trajectory_text(p.axes, body, o.extents, dimension))
        if own_weights:
            members.append('"weight": ' + weight_text(p.axes[-1]))
        pieces.append("{" + ", ".join(members) + "}")
    return "[" + ", ".join(pieces) + "]"


def key_text(key, scene):
    if key[0] == "axis":
        return '"%s"' % "xyz"[key[1]]
    if key[0] == "direction":
        return '{"direction": %s}' % numbers_text(key[1])
    return '{"squared_distance_to": %s}' % json_string(scene.ids[key[1]])


def set_text(value):
    """A value of "of", "query", "colours" or "ends"."""
    if isinstance(value, str):
        return json_string(value)
    if isinstance(value, dict):
        return "{" + ", ".join(json_string(name) + ": " + set_text(v) for name, v in value.items()) + "}"
    return "[" + ", ".join(map(json_string, value)) + "]"


def request_text(r, scene):
    plain = r.key == ("axis", 0)
    if plain and r.label == r.structure and not r.parameters and not r.sets and r.over is None:
        return json_string(r.structure)
    members = ['"structure": ' + json_string(r.structure)]
    if not plain:
        members.append('"key": ' + key_text(r.key, scene))
    members += [json_string(name) + ": " + set_text(value) for name, value in r.sets]
    if r.over is not None:
        members.append('"over": ' + request_text(r.over, scene))
    members += [json_string(name) + ": " + number_text(value) for name, value in r.parameters]
    if r.label != r.structure:
        members.append('"as": ' + json_string(r.label))
    return "{" + ", ".join(members) + "}"


def canonical_text(scene):
    """The text of which the scene's hash is the SHA-256: members in a fixed order, one object a line,
    numbers in lowest terms, nothing that is a default or a comment."""
    def lines(items):
        return "[" + ",".join("\n  " + i for i in items) + "]"

    head = '{"kinex": 1, "name": %s, "dimension": %d, "time": {"start": %s' % (
        json_string(scene.name), scene.dimension, number_text(scene.start))
    if scene.end is not None:
        head += ', "end": ' + number_text(scene.end)
    head += "}"
    if scene.jumps:
        head += ', "jumps": true'
    if scene.overlapping_starts == "contact":
        head += ', "overlapping_starts": "contact"'
    objects = []
    for o in scene.objects:
        text = '{"id": ' + json_string(o.name)
        if o.polygon:
            text += ', "polygon": ' + axes_text(o.polygon)
        if o.extents == "weight" and common_weight(o) not in (None, [0]):
            text += ', "weight": ' + weight_text(common_weight(o))
        if o.colour:
            text += ', "colour": ' + json_string(o.colour)
        if o.ends:
            text += ', "ends": ' + set_text(o.ends)
        if o.line:
            text += ', "line": true'
        objects.append(text + ', "motion": ' + motion_text(o, scene.dimension) + "}")
    maintain = "[" + ", ".join(request_text(r, scene) for r in scene.maintain) + "]"
    queries = ['{"at": %s, "box": %s}' % (number_text(t), axes_text(box)) for t, box in scene.queries]
    asked = ',\n "queries": ' + lines(queries) if queries else ""
    return '%s,\n "objects": %s,\n "maintain": %s%s}\n' % (head, lines(objects), maintain, asked)
