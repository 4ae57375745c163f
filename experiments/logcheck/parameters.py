# SPDX-License-Identifier: GPL-3.0-or-later
"""The parameters of structures, and the values that they have if none is given.

Of a structure that is not known here every further member of its entry counts as a parameter with another value.
"""

from families import USUAL

# Members that are no parameters.
OTHERS = ("structure", "key", "over", "of", "query", "colours", "as")


def unusual(structure, tree, number):
    """Those of an entry of "maintain" that have another value, in its order. `number` reads one."""
    usual = USUAL.get(structure, {})
    given = [(name, number(value)) for name, value in tree.items() if name not in OTHERS]
    return [(name, value) for name, value in given if name not in usual or value != usual[name]]


def is_known(structure, name):
    return name in USUAL.get(structure, {})


def value_of(structure, options, name, number):
    """The value of a parameter, by the options of a structure in a log's header."""
    return number(options[name]) if name in (options or {}) else USUAL[structure][name]
