# SPDX-License-Identifier: GPL-3.0-or-later
"""The structures that the built program has, for checks that no file of a room names one."""
import json
import subprocess


def structure_names(program):
    """As `kinex list structures` lists them."""
    listed = subprocess.run([program, "list", "structures", "--json"], stdout=subprocess.PIPE, text=True,
                            check=True).stdout
    names = {structure["name"] for structure in json.loads(listed)}
    assert {"sorted_list", "delaunay_2", "separation_mixed", "calipers_2", "min_circle_2"} <= names, names
    return names
