# SPDX-License-Identifier: GPL-3.0-or-later
"""Levels 1 to 4: reads a log instant by instant, with the scene.

The order at one instant: flight plans (all structures), failures; the objects that disappear, one by one, and
failures; the objects that appear, one by one, and failures. Every claim holds right after the instant.
"""

import json
from fractions import Fraction
from itertools import chain

from counted import count
from instants import check_intervals, read_instants
from log import Wrong, printable
from predicates import LEAST_AXES, Key, formula_of, known
from progress import Progress
from registry import is_partial_hull, reads_partial_hull, replay_of
from roots import Instant, compare
from scene import SCENE_REMEDY, BadInput
from subsets import own_objects
from world import World

# After these, certificates of a structure may be negative since they were made, without passing through zero.
UNSETTLING = ("blocked", "plane_blocked", "reinsert", "settled", "rebuild")
# An instant with one of these is degenerate: its structure may have made such certificates before that, too.
REARRANGING = ("blocked", "plane_blocked", "reinsert", "rebuild")


class Checker:
    def __init__(self, log, scene, levels, progress=None):
        self.log, self.scene = log, scene
        self.progress = Progress() if progress is None else progress
        self.on = [level in levels for level in range(6)]
        self.done, self.undone, self.missing, self.partly = {}, {}, [], {}
        self.wanting = None  # why levels are not done that a scene, or another log of the same run, would allow
        self.world = World(scene) if scene is not None else None
        self.history = None  # (instant, attributes) for level 5

    # ---- what can be done

    def run(self):
        log = self.log
        self.done[0] = count(len(log.records), "record") + "".join(
            "; " + printable("%s is corrupt: %s" % item) for item in log.corrupt.items())
        if self.scene is not None:
            self.check_scene()
        if not log.exact:
            return self.want(range(1, 6), "the arithmetic %s is not exact" % log.arithmetic)
        if log.instants == "none":
            return self.want(range(1, 6), "the log has no instants")
        if log.instants == "intervals":
            if self.on[1]:
                check_intervals(log)
                self.done[1] = "order of the intervals alone, as the log does not name its instants"
            return self.want(range(2, 6), "the log does not name its instants")
        instants = read_instants(log, self.on[1], self.progress)
        if self.on[1]:
            self.done[1] = count(len({id(x) for x in instants}), "instant")
        if self.scene is None:
            return self.want(range(2, 6), "no scene was given")
        self.shorten(instants)
        if self.world.scene.bodies:
            self.skip((2, 3, 4), "not for rigid bodies")
            if self.on[5]:
                from bodies import check_bodies

                check_bodies(self, instants)
            return None
        if any(self.on[2:]):
            self.walk(instants)
        return None

    def skip(self, levels, reason):
        for level in levels:
            if self.on[level]:
                self.undone[level] = reason

    def want(self, levels, reason):
        """Levels that the input does not allow."""
        self.skip(levels, reason)
        self.wanting = reason

    def note_partly(self, label, what):
        """Something that no replay covers."""
        self.partly.setdefault(label, what)

    def check_scene(self):
        log, scene = self.log, self.scene
        if log.scene_hash not in scene.hashes:
            raise Wrong("the log is of another scene: its hash is %s, that of %s is %s"
                        % (log.scene_hash, scene.path, scene.hash), 1, SCENE_REMEDY)
        if log.objects != scene.ids:
            raise Wrong("the header's objects are not those of the scene", 1)
        if log.scene_name != scene.name:
            raise Wrong("the scene's name is %s, not %s" % (json.dumps(scene.name), json.dumps(log.scene_name)), 1)
        if log.reached is not None:
            if log.reached < scene.start or (scene.end is not None and log.reached > scene.end):
                raise Wrong("the run reached %s, outside of the scene's time" % log.reached, self.last_line())
        elif scene.end is not None:
            raise Wrong("a scene with an end, and a run that did not reach one", self.last_line())

    def last_line(self):
        return len(self.log.records) + 2

    def key_of(self, structure):
        """The structure's key, as the header says."""
        key = "x" if structure.key is None else structure.key
        if isinstance(key, str) and key.startswith("{"):
            key = json.loads(key, parse_float=str)
        return self.scene.read_key(key)

    def has_direction(self, structure):
        return self.key_of(structure)[0] == "direction"

    # ---- queries of the log

    def is_followed(self, r):
        """False: nothing is known of the structure, and its certificates are judged by their formulas alone."""
        return replay_of(r.structure.name, r.structure.options) is not None

    def query(self, r):
        """The certificate of a record as a query."""
        if r.predicate is None:
            return None
        if hasattr(self.replays[r.structure.index], "own_query"):
            own = self.replays[r.structure.index].own_query(r)
            if own is not None:
                return own
        if hasattr(self.replays[r.structure.index], "meanings"):
            predicate, arity = r.predicate, len(set(r.arguments))
        elif r.predicate == "order_direction" and (self.is_followed(r) or self.has_direction(r.structure)):
            predicate, arity = Key(self.key_of(r.structure)).predicate, 2
        elif r.predicate != "order_direction" and known(r.predicate):
            predicate, arity = r.predicate, formula_of(r.predicate)[1]
        elif not self.is_followed(r):
            self.note_partly(r.structure.label, "certificates %s: no formula is known" % r.predicate)
            return None
        else:
            raise Wrong("no predicate %s is known for points" % json.dumps(r.predicate))
        if len(r.arguments) != arity or len(set(r.arguments)) != arity and predicate != "slope_order_2":
            raise Wrong("%s takes %d objects" % (r.predicate, arity))
        for i in r.arguments:
            if i not in self.world.alive:
                raise Wrong("the certificate names %s, which is not there" % json.dumps(
                    i if isinstance(i, str) else self.scene.ids[i]))
        if self.scene.dimension < LEAST_AXES.get(r.predicate, 1):
            raise Wrong("%s in a scene of %d axes" % (r.predicate, self.scene.dimension))
        return predicate, r.arguments

    def check_certificate(self, r, x):
        """Level 2."""
        query = self.query(r)
        if query is None:
            return
        replay = self.replays[r.structure.index]
        settled = r.structure.index not in self.unsettled
        if hasattr(replay, "meanings"):
            self.check_meanings(replay, r, x, settled)
            self.certificates += 1
            return
        sign = self.world.sign_after(query, x)
        touch = sign > 0 and (replay is None or r.predicate in replay.fails_touching)
        if touch and not self.world.vanishes(query, x):
            raise Wrong("the certificate does not touch zero at the instant: no failure")
        if sign >= 0 and not touch:
            raise Wrong("the certificate is %s right after the instant, not negative: no failure"
                        % ("positive" if sign else "zero identically"))
        if settled and not self.world.vanishes(query, x):
            self.doubt(replay, r, x, "the certificate's polynomial %s is not zero at the instant"
                       % list(self.world.polynomial(*query)))
        self.certificates += 1

    def check_meanings(self, replay, r, x, settled):
        query, is_negative = self.query(r), False
        likely = replay.likely(*query, x) if hasattr(replay, "likely") else ()
        for q in chain(likely, replay.meanings(*query)):
            if self.world.sign_after(q, x) < 0:
                if not settled or self.world.vanishes(q, x):
                    return
                is_negative = True
        if not is_negative:
            raise Wrong("the certificate fails along none of the directions")
        self.doubt(replay, r, x, "the certificate is zero at the instant along none of the directions")

    def doubt(self, replay, r, x, what):
        """A certificate that is negative before the instant already: was it made only now?"""
        if not hasattr(replay, "doubt"):
            raise Wrong(what)
        replay.doubt(r, x, what)

    # ---- the walk

    def shorten(self, instants):
        """A run that is done before the scene's end is of a shorter scene, or has been driven up to there."""
        reached = self.log.reached
        if self.log.end != "done" or reached is None or reached == self.scene.end:
            return
        end = self.rational(reached)
        if not any(r.kind == "erase" and compare(x, end) == 0 for r, x in zip(self.log.records, instants)):
            self.scene.end_at(reached)

    def walk(self, instants):
        self.certificates = 0
        self.unsettled = set()  # structures whose certificates may be negative at this instant already
        self.replays = []
        for s in self.log.structures:
            replay = replay_of(s.name, s.options)
            if replay is None:
                self.missing.append(s.label)
                self.replays.append(None)
            else:
                self.replays.append(replay(self, s))
        self.order_predicates()
        self.touched = {}
        self.recent = None
        self.history = []
        records = self.log.records
        x = self.rational(self.scene.start)
        if records and compare(instants[0], x) < 0:
            raise Wrong("the first record is before the scene's start", records[0].line)
        self.start(x)
        change, i, n = 0, 0, len(records)
        end = None if self.log.reached is None else self.rational(self.log.reached)
        self.own = [own_objects(s.name, s.options, self.scene) for s in self.log.structures]
        # Changes of objects that no structure is built from are in no record.
        changes = [c for c in self.scene.changes if any(own is None or c[2] in own for own in self.own)]
        while True:
            t = self.rational(changes[change][0]) if change < len(changes) else None
            if t is not None and end is not None and compare(t, end) > 0:
                t = None
            if i == n and t is None:
                break
            x = instants[i] if i < n else None
            now = []
            order = -1 if x is None else (1 if t is None else compare(t, x))
            if order <= 0:
                while change < len(changes) and changes[change][0] == Fraction(*t.value):
                    now.append(changes[change])
                    change += 1
                if order < 0:
                    raise Wrong("at %s flight plans change, and no record says so" % now[0][0],
                                records[i].line if i < n else self.last_line())
            j = i
            while j < n and instants[j] is x:
                j += 1
            if end is not None and compare(x, end) > 0:
                raise Wrong("an event after %s, up to which the run is said to go" % self.log.reached,
                            records[i].line)
            self.instant(x, records[i:j], now)
            i = j
            self.progress.show("levels 2 to 4: record", i, n)
        self.finish(end)

    def rational(self, value):
        return Instant.rational(value.numerator, value.denominator)

    def order_predicates(self):
        """Certificates that fail at one instant fail in the order of their structures, then of their
        predicates as these are first declared, then of their objects."""
        self.rank = {}
        for replay in self.replays:
            for predicate in getattr(replay, "bound", ()):
                self.rank.setdefault(predicate, len(self.rank))

    def start(self, x):
        for replay in self.replays:
            if replay is not None:
                replay.start(x)
                self.touched[replay.structure.index] = replay
        self.settled_start = False
        self.note(x)

    def note(self, x):
        if self.on[5]:
            self.history.append((x, [None if r is None else r.attribute for r in self.replays]))

    def instant(self, x, records, changes):
        self.recent = None
        self.unsettled = set()
        for replay in self.replays:
            if replay is not None:
                replay.begun = replay.proofs[0].step
        world = self.world
        updates, erasures, insertions = {}, set(), {}
        for t, rank, o, piece in changes:
            if rank == 0:
                if o in world.alive and world.piece[o].meets(piece, t, False):
                    updates[o] = piece
                else:
                    erasures.add(o)
                    insertions[o] = piece
            elif rank == 1:
                erasures.add(o)
            else:
                insertions[o] = piece
        for o in erasures:
            updates.pop(o, None)
        structures = self.log.structures
        def has(s, o):
            return self.own[s.index] is None or o in self.own[s.index]

        due = [("motion", s, o) for s in structures for o in sorted(updates) if has(s, o)]
        due += [("erase", s, o) for o in sorted(erasures) for s in structures if has(s, o)]
        due += [("insert", s, o) for o in sorted(insertions) for s in structures if has(s, o)]
        degenerate = {r.structure.index for r in records if r.kind in REARRANGING}
        place, moved, phase = 0, False, "motion"
        line = records[0].line if records else self.last_line()
        try:
            for r in records:
                line = r.line
                if r.kind in ("motion", "erase", "insert"):
                    if place == len(due) or due[place] != (r.kind, r.structure, r.ids[0]):
                        raise Wrong("%s: the scene has another change of flight plans here%s" % (
                            r.short(), "" if place == len(due) else ": %s of %s of %s" % (
                                due[place][0], self.scene.ids[due[place][2]], due[place][1].label)))
                    place += 1
                    if r.kind == "motion" and not moved:
                        self.apply_motions(updates, x)
                        # What stood in a line now may have claims of its new motions that fail at once.
                        self.unsettled |= degenerate
                        moved = True
                    elif r.kind != "motion":
                        if r.kind != phase:
                            self.settle(x)
                            phase = r.kind
                        self.apply(r, insertions, x)
                    continue
                replay = self.replays[r.structure.index]
                if self.on[2]:
                    self.check_certificate(r, x)
                if r.kind in UNSETTLING or r.structure.index in degenerate:
                    self.unsettled.add(r.structure.index)
                if r.external and is_partial_hull(r.structure.name):  # its vertices come from afar
                    self.unsettled |= {s.index for s in structures if reads_partial_hull(s.options)}
                if replay is not None:
                    self.check_ids(r)
                    self.touched[r.structure.index] = replay
                    replay.record(r, x)
            line = records[-1].line if records else line
            if place < len(due):
                raise Wrong("the %s of %s of %s is missing" % (
                    due[place][0], self.scene.ids[due[place][2]], due[place][1].label))
            self.settle(x)
        except Wrong as error:
            error.line = error.line or line
            raise
        self.note(x)

    def check_ids(self, r):
        for i in r.ids:
            if isinstance(i, str):
                raise Wrong("the scene has no object %s" % json.dumps(i))

    def apply_motions(self, updates, x):
        objects = set(updates)
        active = [r for r in self.replays if r is not None]
        for replay in active:
            replay.before_motion(objects, x)
        for o, piece in updates.items():
            self.world.set_motion(o, piece)
        for replay in active:
            replay.after_motion(objects, x)
            self.touched[replay.structure.index] = replay

    def apply(self, r, insertions, x):
        o = r.ids[0]
        self.unsettled.add(r.structure.index)
        replay = self.replays[r.structure.index]
        if r.kind == "insert":
            if o not in self.world.alive:
                self.world.set_motion(o, insertions[o])
                self.world.alive.add(o)
        else:
            self.world.alive.discard(o)
        if replay is not None:
            (replay.insert if r.kind == "insert" else replay.erase)(o, x)
            self.touched[r.structure.index] = replay

    def settle(self, x):
        for i, replay in enumerate(self.replays):
            if replay is not None and replay.at_every_instant:
                self.touched[i] = replay
        for replay in list(self.touched.values()):
            replay.settle(x)
        self.touched.clear()

    def touch(self, replay):
        self.touched[replay.structure.index] = replay

    def failed(self, replay, query, made, x):
        """A live claim of the replay fails. Of the claims that fail at one instant and were made before it,
        the first in order fails first."""
        if not self.on[3]:
            return
        predicate, ids = query
        key = (replay.structure.index, self.rank.get(predicate, 0), sorted(ids), list(ids))
        if self.recent is not None:
            recent, index, step = self.recent
            if key < recent and made <= (step if index == replay.structure.index else replay.begun):
                raise Wrong("of failures at one instant this one comes before that of the record before it")
        self.recent = (key, replay.structure.index, replay.proofs[0].step)

    def check_change(self, replay, r, before, after):
        """The gone and came of a settled or rebuild record: the whole attribute, before and after."""
        ids = self.scene.ids
        gone = [ids[i] for i in before]
        came = [ids[i] for i in after]
        if gone == came:
            if r.gone is not None:
                raise Wrong("%s: nothing has changed" % r.short())
        elif r.gone != gone or r.came != came:
            raise Wrong("%s: gone and came are %s and %s; the attribute was %s and is %s" % (
                r.short(), json.dumps(r.gone), json.dumps(r.came), json.dumps(gone), json.dumps(came)))

    def finish(self, end):
        try:
            for replay in self.replays:
                if replay is not None:
                    replay.finish(end)
        except Wrong as error:
            error.line = error.line or self.last_line()
            raise
        if self.on[2]:
            self.done[2] = count(self.certificates, "certificate")
        followed = len(self.log.structures) - len(self.missing)
        said = count(followed, "structure")
        if self.missing:
            said += "; not followed: " + ", ".join(self.missing)
        for level in (3, 4):
            if self.on[level]:
                (self.done if followed else self.undone)[level] = said
        if self.on[5]:
            from brute import check_small

            check_small(self, end)


__all__ = ["Checker", "BadInput"]
