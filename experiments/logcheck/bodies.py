# SPDX-License-Identifier: GPL-3.0-or-later
"""Level 5 for rigid convex polygons: contacts, grazes, separations and overlaps by brute force.

A body carries the point x of its frame to c + R x; with a rotor w = p + iq, R is the multiplication by
w^2 over N = p^2 + q^2. Seen from A's frame, times N = N_A N_B > 0, vertex y of B is, from vertex x0 of A,

    P = N_B W_A^T (c_B - c_A) + W y - N x0,     W the multiplication by (conj(w_A) w_B)^2,

and it is outside the edge from x0 along u, seen from A, where P x u > 0. Two bodies change between apart,
touching and overlapping only where a vertex is on an edge: at a root, of any multiplicity, of one of these
polynomials. Between two roots the bodies are compared at a rational time.
"""

from fractions import Fraction
from math import lcm

import polynomials as poly
from counted import count
from gaps import high_end, merged, rational_between
from log import Wrong
from roots import Instant, SignChanges, all_roots, compare
from world import World, vanishes_at

MOST_PAIRS = 4000  # of a vertex and an edge
EVENTS = ("contact", "graze", "separation", "overlap")
APART, TOUCHING, OVERLAPPING = "apart", "touching", "overlapping"


# ---- polynomials


def complex_product(u, v):
    return (poly.subtract(poly.multiply(u[0], v[0]), poly.multiply(u[1], v[1])),
            poly.add(poly.multiply(u[0], v[1]), poly.multiply(u[1], v[0])))


def conjugate(u):
    return (u[0], poly.negated(u[1]))


class Pose:
    """B as seen from A: axes as polynomials, times one positive number."""

    def __init__(self, a, b):
        d = lcm(a.denominator, b.denominator)

        def axes(piece):
            return [poly.scaled(p, d // piece.denominator) for p in piece.polynomials]

        (ax, ay, ap, aq), (bx, by, bp, bq) = axes(a), axes(b)
        wa, wb = (ap, aq), (bp, bq)
        na = poly.add(poly.multiply(ap, ap), poly.multiply(aq, aq))
        nb = poly.add(poly.multiply(bp, bp), poly.multiply(bq, bq))
        step = (poly.subtract(bx, ax), poly.subtract(by, ay))
        turned = complex_product(conjugate(complex_product(wa, wa)), step)
        # The step has one factor d, the rotors' products four and the lengths of vertices none.
        self.step = [poly.multiply(nb, p) for p in turned]
        w = complex_product(conjugate(wa), wb)
        self.w = [poly.scaled(p, d) for p in complex_product(w, w)]
        self.n = poly.scaled(poly.multiply(na, nb), d)

    def place(self, x0, y):
        """P, times the common denominator of the vertices."""
        m = lcm(*(c.denominator for c in x0 + y))
        x, y = [int(c * m) for c in x0], [int(c * m) for c in y]
        c, s = self.w
        rotated = (poly.subtract(poly.scaled(c, y[0]), poly.scaled(s, y[1])),
                   poly.add(poly.scaled(s, y[0]), poly.scaled(c, y[1])))
        return [poly.subtract(poly.add(poly.scaled(self.step[i], m), rotated[i]), poly.scaled(self.n, x[i]))
                for i in (0, 1)], m


def combination(p, u):
    return poly.add(poly.scaled(p[0], u[0]), poly.scaled(p[1], u[1]))


class Side:
    """Vertex y of one body against edge x0 x1 of the other."""

    def __init__(self, pose, x0, x1, y):
        place, m = pose.place(x0, y)
        k = lcm(*(c.denominator for c in x0 + x1))
        u = [int((b - a) * k) for a, b in zip(x0, x1)]
        self.outside = poly.primitive(combination(place, (u[1], -u[0])))
        # From x0 along the edge, and back from x1.
        self.after = combination(place, u)
        whole = poly.scaled(pose.n, m * (u[0] ** 2 + u[1] ** 2))
        self.before = poly.subtract(whole, poly.scaled(self.after, k))
        # An edge of length u/k in the frame, in which the place is m times too large.

    def touches(self, x, window):
        """The vertex is on the edge at x, a root of `outside`."""
        return all(sign_at(p, x, window) >= 0 for p in (self.after, self.before))


def sign_at(p, x, window):
    if vanishes_at(p, x):
        return 0
    return SignChanges(p, window).after(x)


# ---- positions


def position(o, piece, t):
    x, y, p, q = (piece.position(i, t) for i in range(4))
    n = p * p + q * q
    c, s = (p * p - q * q) / n, 2 * p * q / n
    return [(x + c * v[0] - s * v[1], y + s * v[0] + c * v[1]) for v in o.polygon]


def compare_bodies(a, b):
    """Two convex polygons: the widest gap over the edges of both."""
    best = None
    for one, other in ((a, b), (b, a)):
        for i, v in enumerate(one):
            w = one[(i + 1) % len(one)]
            u = (w[0] - v[0], w[1] - v[1])
            gap = min((z[0] - v[0]) * u[1] - (z[1] - v[1]) * u[0] for z in other)
            sign = (gap > 0) - (gap < 0)
            best = sign if best is None else max(best, sign)
    return (OVERLAPPING, TOUCHING, APART)[best + 1]


# ---- one pair


class Pair:
    def __init__(self, scene, world, a, b):
        self.scene, self.world, self.a, self.b = scene, world, a, b
        self.sides = None
        self.state = None
        self.parted = self.fresh = False

    def read(self):
        """The sides under the motions in force."""
        a, b = self.a, self.b
        poses = ((a, b), (b, a))
        self.sides = {}
        for one, other in poses:
            pose = Pose(self.world.piece[one], self.world.piece[other])
            polygon = self.scene.objects[one].polygon
            for i, x0 in enumerate(polygon):
                for j, y in enumerate(self.scene.objects[other].polygon):
                    self.sides[one, i, other, j] = Side(pose, x0, polygon[(i + 1) % len(polygon)], y)

    def roots(self, window):
        result = []
        for p in {s.outside for s in self.sides.values()}:
            result += all_roots(p, window)
        return merged(result)

    def at(self, t):
        return compare_bodies(*(position(self.scene.objects[o], self.world.piece[o], t) for o in (self.a, self.b)))

    def touch(self, x, window):
        return any(vanishes_at(s.outside, x) and s.touches(x, window) for s in self.sides.values())


def check_bodies(checker, instants):
    scene, log = checker.scene, checker.log
    structures = [s for s in log.structures if set(EVENTS[:3]) <= set(s.kinds)]
    checker.missing += [s.label for s in log.structures if s not in structures]
    vertices = [len(o.polygon) for o in scene.objects]
    if sum(2 * m * n for i, m in enumerate(vertices) for n in vertices[:i]) > MOST_PAIRS:
        checker.undone[5] = "more than %d pairs of a vertex and an edge" % MOST_PAIRS
        return
    if not structures:
        checker.undone[5] = "no structure of the log follows contacts"
        return
    end = None if log.reached is None else Instant.rational(log.reached.numerator, log.reached.denominator)
    story, gaps = Story(scene, end).tell()
    for s in structures:
        compare_stories(checker, s, story, instants)
    kinds = "contact, graze or separation" if len(story) == 1 else "contacts, grazes and separations"
    checker.done[5] = "%s between instants, %d %s" % (count(gaps, "gap"), len(story), kinds)
    checker.partly.update({s.label: "internal events" for s in structures})


def compare_stories(checker, s, story, instants):
    scene = checker.scene
    told = [(x, r) for x, r in zip(instants, checker.log.records) if r.structure is s and r.kind in EVENTS]
    due = list(story)
    for x, r in told:
        if not r.external or len(r.ids) != (2 if r.kind == "overlap" else 4) \
                or not all(isinstance(i, int) for i in r.ids[:2]):
            raise Wrong("%s: a contact, graze or separation is external and names two bodies and two features, "
                        "an overlap two bodies" % r.short(), r.line)
        place = next((i for i, (y, kind, pair, _) in enumerate(due)
                      if kind == r.kind and pair == r.ids[:2] and compare(x, y) == 0), None)
        if place is None:
            raise Wrong("%s: by brute force there is none of these two bodies then" % r.short(), r.line)
        if r.kind != "overlap":
            due[place][3].check_features(r, x)
        del due[place]
    if due:
        x, kind, pair, _ = due[0]
        raise Wrong("%s: a %s of %s at %r is missing" % (s.label, kind, [scene.ids[i] for i in pair], x),
                    checker.last_line())
    for x, r in zip(instants, checker.log.records):
        if r.structure is s and r.external and r.kind not in EVENTS:
            raise Wrong("%s is internal" % r.short(), r.line)


class Touch:
    """The sides of a pair at an instant."""

    def __init__(self, pair, window):
        self.sides, self.names, self.window = pair.sides, pair.scene.ids, window
        self.polygons = {o: pair.scene.objects[o].polygon for o in (pair.a, pair.b)}

    def check_features(self, r, x):
        """The two features that the record names touch."""
        features = []
        for o, name in zip(r.ids[:2], r.names[2:]):
            body, _, feature = name.rpartition(".")
            if body != self.names[o] or feature[:1] not in "ve" or not feature[1:].isdigit() \
                    or int(feature[1:]) >= len(self.polygons[o]):
                raise Wrong("%s: %s is no feature of %s" % (r.short(), name, self.names[o]), r.line)
            features.append((o, feature[0], int(feature[1:])))
        if not any(self.touches(one, other, x) for one, other in (features, features[::-1])):
            raise Wrong("%s: the two features do not touch" % r.short(), r.line)

    def touches(self, one, other, x):
        """A vertex of `other` is on an edge of `one`, each being the feature or an end of it."""
        (a, kind_a, i), (b, kind_b, j) = one, other
        n, m = len(self.polygons[a]), len(self.polygons[b])
        edges = [i] if kind_a == "e" else [i, (i - 1) % n]
        corners = [j] if kind_b == "v" else [j, (j + 1) % m]
        for v in corners:
            sides = [self.sides[a, e, b, v] for e in edges]
            if all(vanishes_at(s.outside, x) and s.touches(x, self.window) for s in sides):
                return True
        return False


class Story:
    """All contacts, grazes and separations of a scene."""

    def __init__(self, scene, end):
        self.scene, self.end = scene, end
        self.world = World(scene)
        self.events, self.gaps = [], 0

    def tell(self):
        scene, world = self.scene, self.world
        changes, place = scene.changes, 0
        begin = Instant.rational(scene.start.numerator, scene.start.denominator)
        self.pairs = {}
        self.meet(begin)
        while True:
            t = changes[place][0] if place < len(changes) else None
            until = None if t is None else Instant.rational(t.numerator, t.denominator)
            if until is None or (self.end is not None and compare(until, self.end) > 0):
                until, t = self.end, None
            now = []
            while t is not None and place < len(changes) and changes[place][0] == t:
                now.append(changes[place])
                place += 1
            for pair in self.pairs.values():
                self.follow(pair, begin, until)
            updates, gone, come = self.sort_out(now)
            old = dict(world.piece)
            for o, piece in updates.items():
                world.set_motion(o, piece)
            if until is not None:
                for pair in self.pairs.values():
                    self.turn(pair, until, old)
            if t is None:
                break
            world.alive -= gone
            for o, piece in come.items():
                world.set_motion(o, piece)
            world.alive |= set(come)
            for name in [p for p in self.pairs if gone & set(p) or set(come) & set(p)]:
                del self.pairs[name]
            self.meet(until)
            begin = until
        return self.events, self.gaps

    def sort_out(self, now):
        updates, gone, come = {}, set(), {}
        for t, rank, o, piece in now:
            if rank == 0 and self.world.piece[o].meets(piece, t, True):
                updates[o] = piece
            elif rank == 0:
                gone.add(o)
                come[o] = piece
            elif rank == 1:
                gone.add(o)
            else:
                come[o] = piece
        for o in gone:
            updates.pop(o, None)
        return updates, gone, come

    def meet(self, x):
        alive = sorted(self.world.alive)
        for i, a in enumerate(alive):
            for b in alive[i + 1:]:
                if (a, b) not in self.pairs:
                    pair = self.pairs[a, b] = Pair(self.scene, self.world, a, b)
                    pair.read()
                    pair.after = pair.roots(self.world.window)
                    pair.state = self.state_after(pair, x)
                    if pair.state == OVERLAPPING:
                        # One of the two is new: this is not a contact.
                        self.events.append((x, "overlap", (a, b), None))

    def state_after(self, pair, x):
        later = next((r for r in pair.after if compare(r, x) > 0), None)
        self.gaps += 1
        point = rational_between(x, later) if later is not None else self.past(x)
        return pair.at(point)

    def past(self, x):
        return high_end(x) + 1

    def follow(self, pair, begin, until):
        for x in pair.after:
            if compare(x, begin) > 0 and (until is None or compare(x, until) < 0):
                self.pass_instant(pair, x, Touch(pair, self.world.window))

    def turn(self, pair, x, old):
        """The end of flight plans, or of the run: the old ones hold before it, the new ones after it."""
        changed = any(self.world.piece[o] is not old[o] for o in (pair.a, pair.b))
        if changed:
            pair.read()
            pair.after = pair.roots(self.world.window)
        self.pass_instant(pair, x, Touch(pair, self.world.window))

    def pass_instant(self, pair, x, touch):
        before, after = pair.state, self.state_after(pair, x)
        pair.state = after
        kind = None
        if before != OVERLAPPING and after == OVERLAPPING:
            kind = "contact"
        elif before == OVERLAPPING and after != OVERLAPPING:
            kind = "separation"
        elif before == APART and (after == TOUCHING or (after == APART and pair.touch(x, self.world.window))):
            kind = "graze"
        if kind:
            self.events.append((x, kind, (pair.a, pair.b), touch))
