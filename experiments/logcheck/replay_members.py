# SPDX-License-Identifier: GPL-3.0-or-later
"""What replays have in common whose attribute is made anew whenever an object comes or goes."""

from replay import Replay


class OfMembers(Replay):
    """Subclasses have begin(x): the attribute of the present members, right after x."""

    look = False  # is there anything to be settled at the present instant?

    def everyone(self):
        """The objects that it is about."""
        return self.alive()

    def start(self, x):
        self.members = self.everyone()
        self.begin(x)

    def begin(self, x):
        raise NotImplementedError

    def insert(self, o, x):
        self.members.add(o)
        self.begin(x)

    def erase(self, o, x):
        self.members.discard(o)
        self.begin(x)

    def after_motion(self, objects, x):
        super().after_motion(objects, x)
        self.look = True
