# SPDX-License-Identifier: GPL-3.0-or-later
"""The extreme object along each of a set of directions, as the records of a log say.

A record "replace" names the object that was ahead in a direction, or in a duel for it, and the one that is. Of linear
motions there are no duels: one record for every direction whose extreme object changes at an instant. A record "tie"
says the same of two objects that have become identically level.
"""

from log import Wrong


def extreme(world, members, u, x):
    """The farthest along u right after x; of those that are level the smallest number."""
    best = None
    for o in sorted(members):
        if best is None or world.sign_after((("order_direction", u), (best, o)), x) > 0:
            best = o
    return best


class Extremes:
    def __init__(self, replay, directions, duels, x):
        """`duels`: is an extreme object the winner of a tournament?"""
        self.replay, self.world = replay, replay.world
        self.directions, self.duels = directions, duels
        self.begin(x)

    def begin(self, x):
        """What is extreme right after x, whatever was."""
        self.at = {u: extreme(self.world, self.replay.members, u, x) for u in self.directions}
        self.events = []  # (was ahead, is ahead, directions in which that may be) since then

    def record(self, r, x):
        was, now = r.ids
        query = self.replay.query(r)
        # A tie may come to light in a duel that is repeated since another one has failed.
        of_another = self.duels and r.kind == "tie"
        if query is not None and not of_another and set(query[1]) != {was, now}:
            raise Wrong("%s is not a failure of the order of the two" % r.short())
        found = [u for u in self.directions if self.is_passed(r.kind, u, was, now, x)]
        if not self.duels:
            found = [u for u in found if self.at[u] == was and extreme(self.world, self.replay.members, u, x) == now]
            if found:
                self.at[found[0]] = now
        if not found:
            raise Wrong("%s: along no direction the second takes the place of the first" % r.short())
        self.events.append((was, now, found))

    def is_passed(self, kind, u, was, now, x):
        if kind == "tie":
            return now < was and self.world.is_zero((("order_direction", u), (was, now)))
        return self.replay.fails((("order_direction", u), (now, was)), x)

    def may_be(self, u, o, x):
        """Has o been extreme along u at some step of the present instant?"""
        return (o == self.at[u] or any(o == now and u in found for _, now, found in self.events)
                or o == extreme(self.world, self.replay.members, u, x))

    def settle(self, x):
        """All records of the instant x have been read."""
        for u in self.directions:
            was, now = self.at[u], extreme(self.world, self.replay.members, u, x)
            if was == now:
                continue
            if not self.duels or not any(was == before and u in found for before, _, found in self.events):
                raise Wrong("%s: right after %r another object is extreme along (%s), and no event says so" % (
                    self.replay.label, x, ", ".join(map(str, u))))
            self.at[u] = now
        self.events = []
