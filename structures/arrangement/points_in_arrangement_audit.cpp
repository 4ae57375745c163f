// SPDX-License-Identifier: GPL-3.0-or-later
// The witness: the heights of all lines at the x of each point, in CGAL's exact numbers. Of lines at one
// height the smaller id is the higher one, and above a point at that height.
#include <CGAL/Gmpq.h>

#include <string>
#include <tuple>
#include <vector>

#include "structures/arrangement/points_in_arrangement.h"

namespace kinex {

void PointsInArrangement::audit(const Snapshot& snapshot, AuditReport& report) const {
  const auto number = [&snapshot](ObjectId object, int axis) {
    return CGAL::Gmpq(snapshot.position(object, axis).raw());
  };
  for (const ObjectId p : points_) {
    report.check(snapshot.alive(p), [] { return "a point that is not there"; });
    if (!snapshot.alive(p)) return;
    // Height above the point, and rank among those of this height.
    using Height = std::tuple<CGAL::Gmpq, int, ObjectId>;
    Height up, down;
    ObjectId above = kNoObject, below = kNoObject;
    for (ObjectId l = 0; l < snapshot.objects(); ++l) {
      if (!is_line_[l] || !snapshot.alive(l)) continue;
      const Height height(number(l, 0) * number(p, 0) + number(l, 1) - number(p, 1),
                          -static_cast<int>(l), l);
      if (std::get<0>(height) >= 0) {
        if (above == kNoObject || height < up) {
          up = height;
          above = l;
        }
      } else if (below == kNoObject || down < height) {
        down = height;
        below = l;
      }
    }
    report.check(places_[p].edges[kUp].line == above && places_[p].edges[kDown].line == below,
                 [p] { return "other lines are next to point " + std::to_string(p); });
  }
}

}  // namespace kinex
