# SPDX-License-Identifier: GPL-3.0-or-later
"""The checker's own proof (level 4): claims "value >= 0", each with the time during which it must hold."""

import json

from log import Wrong
from roots import compare


class Proof:
    """Claims by place (an edge, a node, a pair of neighbours). A claim that is removed must not have failed
    before that instant: it holds from the moment, or from the end of the instant, at which it was made
    until it is removed."""

    def __init__(self, world, label, on=True):
        self.world, self.label, self.on = world, label, on
        self.claims = {}  # place: [query, first failure or None, number of the step at which it was made]
        self.step = 0

    def put(self, place, query, x):
        old = self.claims.get(place)
        if old is not None:
            if old[0] == query:
                return
            self.judge(old, x)
        self.claims[place] = [query, self.world.first_negative(query, x), self.step]

    def drop(self, place, x):
        old = self.claims.pop(place, None)
        if old is not None:
            self.judge(old, x)

    def clear(self, x):
        for place in list(self.claims):
            self.drop(place, x)

    def judge(self, claim, x):
        failure = claim[1]
        if self.on and failure is not None and compare(failure, x) < 0:
            self.refuse(claim, failure)

    def refuse(self, claim, failure):
        raise Wrong("%s: %s is negative right after %r, and no event says so" % (
            self.label, self.tell(claim[0]), failure))

    def tell(self, query):
        predicate = query[0] if isinstance(query[0], str) else query[0][0]
        return predicate + json.dumps([self.world.scene.ids[i] for i in query[1]], ensure_ascii=False)

    def before_motion(self, objects, x):
        """The motions of these objects are about to change: their claims are checked up to now."""
        self.touched = [c for c in self.claims.values() if not objects.isdisjoint(c[0][1])]
        for claim in self.touched:
            self.judge(claim, x)

    def after_motion(self, x):
        for claim in self.touched:
            claim[1] = self.world.first_negative(claim[0], x)

    def failing(self, x):
        """Places whose claims are negative right after x."""
        return [place for place, c in self.claims.items() if c[1] is not None and compare(c[1], x) <= 0]

    def finish(self, end):
        """The claims hold up to and including `end`; None: for all time."""
        if not self.on:
            return
        for claim in self.claims.values():
            if claim[1] is not None and (end is None or compare(claim[1], end) <= 0):
                self.refuse(claim, claim[1])
