// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/extent_directions.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "predicates/points/unit_directions_3.h"

namespace kinex {

ExtentDirections::ExtentDirections(Kernel& kernel, StructureId id, const Scene& scene, int k,
                                   Extremum extremum)
    : BestDirection(kernel, id,
                    make_direction_maxima(kernel, id, scene, directions(k, scene.dimension),
                                          MaximaChoice::kByDegree),
                    "extents",
                    extremum == Extremum::kMaximum ? "extents, the largest wins"
                                                   : "extents, the smallest wins",
                    ExtentClaims(kernel, directions(k, scene.dimension), extremum),
                    Attribute::Shape::kTuples),
      k_(scene.dimension == 3 ? std::min(k, kMostInSpace) : k),
      dimension_(scene.dimension) {
  if (dimension_ != 2 && (dimension_ != 3 || !maximum())) {
    throw std::invalid_argument("extents along directions are for the plane, diameters for space, too");
  }
}

std::vector<ObjectId> ExtentDirections::best() const {
  const Value* front = values().front();
  if (front == nullptr || (!maximum() && values().size() < count())) return {};
  return {std::min((*front)[1], (*front)[2]), std::max((*front)[1], (*front)[2])};
}

std::vector<BoundCheck> ExtentDirections::bounds(const BoundContext& context) const {
  const StructureLedger& ledger = *context.ledger;
  const std::string name(this->name());
  const Integer extents = counted(count());
  std::vector<BoundCheck> result{
      at_most(name + ".certificates", "those of the extreme objects, and of the extents",
              maxima().most_certificates(context) + extents, counted(ledger.max_live)),
      at_most(name + ".locality", "those of the extreme objects, and of the extents",
              maxima().most_per_object(context) + extents, counted(ledger.max_per_object)),
      at_most(name + ".events", "those of the extreme objects, and the epochs of the tournament",
              maxima().most_failures(context) + values().most_failures(context.degree),
              counted(ledger.failures))};
  if (context.plain() && context.degree <= 1) {
    const Integer pieces = extents * counted(context.objects() + 1);
    result.push_back(
        maximum() ? at_most(name + ".external", "an upper envelope of n + 1 lines a direction",
                            pieces - Integer(1), counted(ledger.external))
                  : at_most(name + ".external", "a lower envelope of n + 1 segments a direction",
                            davenport_schinzel_bound(3, pieces), counted(ledger.external)));
  }
  return result;
}

}  // namespace kinex
