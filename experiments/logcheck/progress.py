# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a check is: on a terminal one line that changes, elsewhere, if it is asked for, a line every few seconds."""

import sys
import time

ON_TERMINAL, ELSEWHERE = 0.25, 5  # seconds between two lines


class Progress:
    def __init__(self, wanted=False, file=None):
        self.file = sys.stderr if file is None else file
        self.terminal = self.file.isatty()
        self.wanted = wanted or self.terminal
        self.began = self.last = time.monotonic()
        self.shown = False

    def show(self, what, done, of=None):
        """"record 120 of 668, 3 s": most calls do nothing."""
        if not self.wanted:
            return
        now = time.monotonic()
        if now - self.last < (ON_TERMINAL if self.terminal else ELSEWHERE):
            return
        self.last = now
        text = "%s %d%s, %.0f s" % (what, done, "" if of is None else " of %d" % of, now - self.began)
        self.file.write("\r\033[K" + text if self.terminal else "kinex-logcheck: " + text + "\n")
        self.file.flush()
        self.shown = self.terminal

    def wipe(self):
        """Clears the line of a terminal, before other output."""
        if self.shown:
            self.file.write("\r\033[K")
            self.file.flush()
        self.shown = False
