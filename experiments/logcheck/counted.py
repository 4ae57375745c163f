# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers of things in words."""


def count(n, noun):
    """"1 record", "2 records"."""
    return "%d %s%s" % (n, noun, "" if n == 1 else "s")
