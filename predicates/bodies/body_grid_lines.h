// SPDX-License-Identifier: GPL-3.0-or-later
// BodyGridLines: the lines of a uniform grid for bodies, as constants of a kernel: line k is at k
// times the width of a cell, on either axis.
#ifndef KINEX_PREDICATES_BODIES_BODY_GRID_LINES_H
#define KINEX_PREDICATES_BODIES_BODY_GRID_LINES_H

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "core/engine/kernel.h"
#include "core/motion/scene.h"

namespace kinex {

class BodyGridLines {
 public:
  // For bodies whose discs have at most this radius. A cell is at least twice as wide as the radius,
  // and so wide that the ends of all flight plans lie within 64 + n cells of the origin on each axis:
  // a fast or distant body crosses no more cells than that. nullopt for a scene without an end, in
  // which bodies would cross cells without end. Exact. O(pieces).
  static std::optional<BodyGridLines> over(Kernel& kernel, const Scene& scene,
                                           const Rational& largest_radius);

  // Made when it is first needed. O(log lines).
  ObjectId line(std::int64_t k);
  std::size_t bytes() const;

 private:
  BodyGridLines(Kernel& kernel, Rational width) : kernel_(&kernel), width_(std::move(width)) {}

  Kernel* kernel_;
  Rational width_;
  std::map<std::int64_t, ObjectId> lines_;
};

}  // namespace kinex

#endif
