// SPDX-License-Identifier: GPL-3.0-or-later
// Scatter: a picture of groups of points on logarithmic axes, the points small and the median of each
// group large, with its label, in gnuplot's commands.
#ifndef KINEX_EXPERIMENTS_LAB_SCATTER_H
#define KINEX_EXPERIMENTS_LAB_SCATTER_H

#include <cstddef>
#include <string>
#include <vector>

#include "experiments/lab/gnuplot.h"

namespace kinex::lab {

struct ScatterPoint {
  double x, y;       // x above 0; y = 0 is drawn on an axis of its own below all others
  std::size_t kind;  // of ScatterPicture::kinds
};
struct ScatterGroup {
  std::string label;
  std::vector<ScatterPoint> points;  // at least one
};

// How points of a kind look, and their place in the legend, from the left: a share of the width.
struct ScatterKind {
  const char* style;
  const char* title;
  double place;
};

struct ScatterPicture {
  std::string x, y;     // names of the axes, with units
  double most_y = 1e16;  // larger ones, also infinite ones, are drawn here
  double median_place;  // in the legend, as of a kind
  std::vector<ScatterKind> kinds;
};

// Sets the script, width and height of a figure. Labels cover neither points nor each other
// (label_placer.h).
void set_scatter(Figure& figure, const ScatterPicture& picture,
                 const std::vector<ScatterGroup>& groups);

}  // namespace kinex::lab

#endif
