// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/rectangle_directions.h"

#include <algorithm>
#include <string>

#include "predicates/points/unit_directions.h"

namespace kinex {
namespace {

// One side of each of k boxes; the other one is direction i + k of unit_directions_2(k).
std::vector<DirectionVector> sides(int k) {
  std::vector<DirectionVector> all = unit_directions_2(k);
  all.resize(static_cast<std::size_t>(k));
  return all;
}

}  // namespace

RectangleDirections::RectangleDirections(Kernel& kernel, StructureId id, const Scene& scene, int k,
                                         BoxMeasure measure)
    : BestDirection(
          kernel, id,
          make_direction_maxima(kernel, id, scene, unit_directions_2(k), MaximaChoice::kByDegree),
          "boxes", "boxes, the smallest wins", BoxClaims(kernel, sides(k), measure),
          Attribute::Shape::kSequence),
      k_(k) {}

std::vector<ObjectId> RectangleDirections::best() const {
  const Value* front = values().front();
  if (front == nullptr) return {};
  return {front->begin() + 1, front->end()};
}

std::vector<BoundCheck> RectangleDirections::bounds(const BoundContext& context) const {
  const StructureLedger& ledger = *context.ledger;
  const std::string name(this->name());
  const Integer all = counted(count());
  std::vector<BoundCheck> result{
      at_most(name + ".certificates", "those of the extreme objects, and of the boxes",
              maxima().most_certificates(context) + all, counted(ledger.max_live)),
      at_most(name + ".locality", "those of the extreme objects, and of the boxes",
              maxima().most_per_object(context) + all, counted(ledger.max_per_object)),
      at_most(name + ".events", "those of the extreme objects, and the epochs of the tournament",
              maxima().most_failures(context) +
                  values().most_failures(values().claims().degree(context.degree)),
              counted(ledger.failures))};
  if (context.plain() && context.degree <= 1) {
    result.push_back(at_most(name + ".external",
                             "the changes of all sides, and of the order of each two boxes",
                             most_changes(counted(context.objects())), counted(ledger.external)));
  }
  return result;
}

// For n lines: both sides across a direction change n times in all, so a box has 2n + 1 pieces at
// most, and two of them have 4n + 1 joint ones. On each the measures are polynomials of degree 1 or 2,
// and continuous where pieces meet. For the perimeter also the pieces of a lower envelope of segments.
Integer RectangleDirections::most_changes(const Integer& n) const {
  const Integer k = counted(count()), one(1), two(2);
  const Integer degree = is_area() ? two : one;
  const Integer crossings = pairs(k) * degree * (Integer(4) * n + one) + two * k * n;
  if (is_area()) return crossings;
  return std::min(crossings, davenport_schinzel_bound(3, k * (two * n + one)) - one);
}

}  // namespace kinex
