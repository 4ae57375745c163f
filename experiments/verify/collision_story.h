// SPDX-License-Identifier: GPL-3.0-or-later
// All methods of collision detection on the same scenes: one table, one figure.
#ifndef KINEX_EXPERIMENTS_VERIFY_COLLISION_STORY_H
#define KINEX_EXPERIMENTS_VERIFY_COLLISION_STORY_H

#include <optional>
#include <vector>

#include "experiments/verify/gnuplot.h"
#include "experiments/verify/measures.h"

namespace kinex {

// Events of every method by scene; nullopt if no cell is in a story.
std::optional<MeasuresTable> collision_table(const std::vector<CellResult>& cells);
// Signs asked for per event, against log2 min(n, sqrt(D / s)): s the least separation of the scene.
std::optional<MeasuresTable> signs_table(const std::vector<CellResult>& cells);
// Events against mu, for a round, and against n, for turns before the fans.
std::optional<Figure> collision_figure(const std::vector<CellResult>& cells);

}  // namespace kinex

#endif
