// SPDX-License-Identifier: GPL-3.0-or-later
// RectangleDirections: the rectangle of least area or perimeter around moving points of the plane,
// to a proven error: the best of k rectangles with sides along fixed directions.
//
// Certificates. The extreme objects of 4k directions (DirectionMaxima), degree d in t for motions of
// degree d, and a tournament of k boxes, one for each direction u_i with 0 <= i < k and its turn by
// 90 degrees: "the box along u_i is no larger than that along u_j", degree d for the perimeter and
// 2d for the area. (The exact rectangles need 6d.)
//
//        t
//      .----.            a box: its four sides are across the direction and along it, through the
//     l      `----.      extreme objects r, l, t, b
//      \      u ->  r
//       `----.     \     .
//             `----b
//
// Quality. Let p be the least half perimeter, A the least area, and D the diameter of the points. At
// all times the half perimeter p' or the area A' of the rectangle found satisfies
//
//   p <= p' <= p (k + 1) / sqrt(k^2 + 1)
//   A <= A' <= A + 2 D^2 k / (k^2 + 1)
//
// since the best rectangle (W by H), turned by the angle y <= atan(1/k) to the nearest direction, has
// the extents H cos y + W sin y and W cos y + H sin y. The tournament has k - 1 certificates; a failure
// renews O(log k) of them. For n points that move linearly the rectangle changes O(k^2 n) times: the sides
// of the boxes do 2kn times, and the order of two boxes 4n + 1 times (perimeter) or twice that (area).
//
// Attribute. The extreme objects in the direction of the best box, in the opposite one, and in both
// turned by 90 degrees; empty if all points coincide.
//
// Ties. Of objects that are identically level in a direction the smallest id is extreme; of boxes
// that are identically equal the one of the first direction counts.
//
// Source: Agarwal, Har-Peled, "Maintaining approximate extent measures of moving points" (2001).
#ifndef KINEX_STRUCTURES_EXTENT_RECTANGLE_DIRECTIONS_H
#define KINEX_STRUCTURES_EXTENT_RECTANGLE_DIRECTIONS_H

#include <string_view>
#include <vector>

#include "structures/extent/best_direction.h"
#include "structures/extent/box_claims.h"

namespace kinex {

class RectangleDirections final : public BestDirection<BoxClaims> {
 public:
  // k >= 1.
  RectangleDirections(Kernel& kernel, StructureId id, const Scene& scene, int k,
                      BoxMeasure measure);

  std::string_view name() const override {
    return is_area() ? "min_area_rectangle_directions" : "min_perimeter_rectangle_directions";
  }
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;

 private:
  bool is_area() const { return values().claims().measure() == BoxMeasure::kArea; }
  std::vector<ObjectId> best() const override;
  Integer most_changes(const Integer& n) const;  // of the rectangle, for n points in linear motion

  int k_;
};

}  // namespace kinex

#endif
