# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines y = a x + b, among themselves and against points: from scratch, right after every instant that may change
the attribute."""

from replay_scratch import BoxesThatMeet


def lines_and_points(members, scene):
    """Two ascending lists."""
    return ([o for o in sorted(members) if scene.objects[o].line],
            [o for o in sorted(members) if not scene.objects[o].line])


class PointsAboveLines(BoxesThatMeet):
    """The pairs of a line and a point above it. One event, "above" or "below", for each pair that an instant
    changes."""

    partly = "internal events: pairs that change twice at one instant are not followed"
    KINDS = ("above", "below")

    def current(self, x):
        lines, points = lines_and_points(self.members, self.world.scene)
        return sorted((min(line, point), max(line, point)) for line in lines for point in points
                      if self.world.sign_after(("line_side", (line, point)), x) > 0)
