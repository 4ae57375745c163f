// SPDX-License-Identifier: GPL-3.0-or-later
// The comparison of all methods of collision detection on the same scenes: tables and a figure.
#ifndef KINEX_EXPERIMENTS_FAMILIES_COLLISION_STORY_H
#define KINEX_EXPERIMENTS_FAMILIES_COLLISION_STORY_H

#include <optional>
#include <vector>

#include "experiments/lab/gnuplot.h"
#include "experiments/lab/measures.h"

namespace kinex::families {

// Events of every method by scene, signs per event; empty if no cell is in a row of theirs (Cell::family_row).
std::vector<lab::Table> collision_tables(const std::vector<lab::CellResult>& cells);
// Events of every method by scene; nullopt likewise.
std::optional<lab::Table> events_table(const std::vector<lab::CellResult>& cells);
// The limit on the signs per event of this cell, c log2 mu + c0, where a law is known: for the tile
// structures, in scenes of two bodies of a known separation that do not touch. Levels: a tile at
// distance s was made by a cut before which the outer polygons were within 5.5 (r_A + r_B) / 4^i of
// the bodies, i = floor(level / 2); with r <= 0.72 D that gives 2 log2 sqrt(D / s) + 5 levels, and
// the balance of the hierarchies 2 log2 n + 3. The rest is SeparationMixed::kSignsPerLevel and
// kSigns.
std::optional<double> signs_limit(const lab::Cell& cell);
// Signs per event against log2 min(n, sqrt(D / s)), with s the least separation of the scene, and
// that limit.
std::optional<lab::Table> signs_table(const std::vector<lab::CellResult>& cells);
// Events against mu for one orbit, and against n for turns in front of the fans: three pictures in
// one frame. Empty if there are too few sizes.
inline constexpr const char* kStoryTitle = "collision: events of every method, against mu and against n";
std::vector<lab::Figure> collision_figures(const std::vector<lab::CellResult>& cells);

}  // namespace kinex::families

#endif
