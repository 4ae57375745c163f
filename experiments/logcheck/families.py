# SPDX-License-Identifier: GPL-3.0-or-later
"""What the entries of single structures in a scene mean: data of the families, beside their replays (registry.py)."""

from fractions import Fraction

# The parameters of structures, and the values that they have if none is given.
USUAL = {name: {"k": Fraction(4)}
         for name in ("directions_2", "directions_2_tournament", "diameter_directions", "width_directions",
                      "min_area_rectangle_directions", "min_perimeter_rectangle_directions")}
USUAL["calipers_2"] = {"folds": Fraction(2)}
USUAL["pseudo_kd_tree_2"] = {"delta": Fraction(1, 4)}
USUAL["cones_local"] = {"corners": Fraction(12)}
USUAL["closest_pair_range_tree"] = {"cones": Fraction(8)}
for clusters in ("emst_clusters", "graph_mst_clusters"):
    USUAL[clusters] = {"cluster": Fraction(0)}
# What is read if "over" does not say otherwise.
USUALLY_READ = ("convex_hull_2", "octants_local", "cones_local")

# Structures about one object, "query", which need not be in "of".
OF_QUERY = ("nearest_site",)
OF_LINES = ("line_arrangement_2", "trapezoids_2")  # of the lines alone, whatever points there are
TWO_COLOURS = ("bichromatic_pair_delaunay", "bichromatic_pair_all", "bichromatic_pair_maximum_norm")
