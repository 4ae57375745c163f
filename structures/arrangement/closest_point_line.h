// SPDX-License-Identifier: GPL-3.0-or-later
// ClosestPointLine: the pair of a moving line y = a x + b and a moving point that are closest to each
// other, by a tournament of all pairs: closest_point_line for Euclidean distances,
// closest_point_line_vertical for vertical ones.
//
// Certificates. "The point of this pair is at most as far from its line as that of the other one is":
// one for each match, nm - 1 for n lines and m points; degree 6d, of vertical distances 4d, for
// motions of degree d.
//
//     .p            |      the vertical distance is |y_p - a x_p - b|, the Euclidean one is that over
//     |\            |      sqrt(1 + a^2). Their squares are compared: fractions without a common root.
//     | \ __.--     |      A point that passes a line is at distance 0 for an instant; the square
//   __|.-'          |      touches zero there and does not change its sign.
//
// Quality: a line is in up to m ceil(log2 nm) certificates, a point in n ceil(log2 nm); a failure
// renews O(log nm), an insertion or erasure O(n log nm) or O(m log nm). External events: one for each
// instant that changes the pair, at most lambda_6d(nm) - 1, or lambda_4d(nm) - 1, without flight-plan
// changes. While a point is on a line for an instant that pair is the closest, if no other is at
// distance 0: so all nm pairs can win.
//
// Ties. Of pairs at identically equal distances the lexicographically smallest one, ids ascending; so
// among points that are identically on lines.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), sections 5 and 7.
#ifndef KINEX_STRUCTURES_ARRANGEMENT_CLOSEST_POINT_LINE_H
#define KINEX_STRUCTURES_ARRANGEMENT_CLOSEST_POINT_LINE_H

#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/arrangement/line_distances.h"
#include "structures/parts/front_pair.h"
#include "structures/parts/member_pairs.h"

namespace kinex {

class ClosestPointLine final : public FrontPair<LineDistances> {
 public:
  ClosestPointLine(Kernel& kernel, StructureId id, const Scene& scene, LineMeasure measure);

  std::string_view name() const override {
    return measure_ == LineMeasure::kHeight ? "closest_point_line_vertical" : "closest_point_line";
  }
  void build(std::span<const ObjectId> objects) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override {
    return members_.bytes() + FrontPair::bytes() + pairs_.claims().bytes();
  }

 private:
  // Of a square of a distance, and so of the order of two.
  int degree_of_claims(int of_motions) const {
    return (measure_ == LineMeasure::kHeight ? 4 : 6) * of_motions;
  }
  bool is_pair(ObjectId a, ObjectId b) const {
    return pairs_.claims().is_line(a) != pairs_.claims().is_line(b);
  }
  std::vector<Pair> all_pairs() const;

  LineMeasure measure_;
  MemberPairs members_;
};

}  // namespace kinex

#endif
