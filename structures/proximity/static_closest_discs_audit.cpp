// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/static_closest_discs_audit.h"

#include <CGAL/Gmpq.h>
#include <CGAL/Sqrt_extension.h>

#include <optional>

namespace kinex {
namespace {

using Number = CGAL::Gmpq;
using Gap = CGAL::Sqrt_extension<Number, Number, CGAL::Tag_true>;

}  // namespace

std::vector<ObjectId> static_closest_discs(const Snapshot& snapshot) {
  const int dimension = snapshot.dimension();
  const auto number = [&](ObjectId id, int axis) {
    return Number(snapshot.position(id, axis).raw());
  };
  std::vector<ObjectId> closest;
  std::optional<Gap> least;
  for (ObjectId a = 0; a < snapshot.objects(); ++a) {
    for (ObjectId b = a + 1; snapshot.alive(a) && b < snapshot.objects(); ++b) {
      if (!snapshot.alive(b)) continue;
      Number square(0);
      for (int axis = 0; axis < dimension; ++axis) {
        const Number step = number(b, axis) - number(a, axis);
        square += step * step;
      }
      const Number reach = number(a, dimension) + number(b, dimension);
      // The root of a Sqrt_extension is positive.
      const Gap gap = CGAL::is_zero(square) ? Gap(-reach) : Gap(-reach, Number(1), square);
      if (CGAL::sign(gap) != CGAL::POSITIVE) return {};
      if (least && gap.compare(*least, false) != CGAL::SMALLER) continue;
      least = gap;
      closest = {a, b};
    }
  }
  return closest;
}

}  // namespace kinex
