# SPDX-License-Identifier: GPL-3.0-or-later
"""The parameters of structures, and the values that they have if none is given."""

from fractions import Fraction

USUAL = {name: {"k": Fraction(4)}
         for name in ("directions_2", "directions_2_tournament", "diameter_directions", "width_directions")}


def unusual(structure, tree, number):
    """Those of an entry of "maintain" that have another value, in its order. `number` reads one."""
    usual = USUAL.get(structure, {})
    given = [(name, number(value)) for name, value in tree.items() if name in usual]
    return [(name, value) for name, value in given if value != usual[name]]


def value_of(structure, options, name, number):
    """The value of a parameter, by the options of a structure in a log's header."""
    return number(options[name]) if name in (options or {}) else USUAL[structure][name]
