// SPDX-License-Identifier: GPL-3.0-or-later
// PointGridLines: the lines of a grid over a box that moving points never leave, as constants of a
// kernel: at most m cells with sides of W, which is larger than the largest diameter of a disc, if
// there are discs. W, and the places of the lines, are short numbers.
#ifndef KINEX_PREDICATES_POINTS_POINT_GRID_LINES_H
#define KINEX_PREDICATES_POINTS_POINT_GRID_LINES_H

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "core/engine/kernel.h"
#include "core/motion/scene.h"
#include "core/numbers/rational.h"

namespace kinex {

// A box that holds all flight plans of a scene from its start to its end.
struct FlightBox {
  std::vector<Rational> low, high;  // by axis of a position
  Rational diameter;                // no disc of the scene has a larger one; 0 unless asked for

  // Tight for linear motions. Requires an end.
  static FlightBox of(const Scene& scene);
  // Of a scene of discs, balls or intervals: the same for their centres, and the diameter, tight for
  // linear radii.
  static FlightBox of_discs(const Scene& scene);
};

class PointGridLines {
 public:
  // Keeps a reference to the kernel. 1 to 3 axes.
  PointGridLines(Kernel& kernel, FlightBox box);

  // Lays the lines anew, for at most `cells` >= 1 cells; lines of the same place stay the same
  // constants. O(cells), in space O(cells log cells).
  void lay(std::size_t cells);
  std::size_t axes() const { return axes_.size(); }
  // Those across this axis, ascending: line k is between columns k and k + 1. Valid until lay().
  std::span<const ObjectId> of(std::size_t axis) const { return axes_[axis].lines; }
  // W; 0 where all points are at one place at all times: there are no lines then.
  const Rational& width() const { return width_; }
  // For audits: a coordinate is within this column, sides included.
  bool is_in_column(std::size_t axis, std::int64_t column, const Rational& x) const;
  std::size_t bytes() const;

 private:
  struct Axis {
    std::map<Rational, ObjectId> known;  // all lines so far
    std::vector<ObjectId> lines;
    std::vector<Rational> at;  // their places
  };
  ObjectId line(std::size_t axis, const Rational& at);

  Kernel& kernel_;
  FlightBox box_;
  std::vector<Axis> axes_;
  Rational width_;
};

}  // namespace kinex

#endif
