// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/box_pairs.h"

#include "structures/proximity/meeting_bounds.h"

namespace kinex {

void BoxPairs::build(std::span<const ObjectId> objects) {
  overlaps_.build(objects, changed(), tied());
  events_.begin();
}

void BoxPairs::certificate_failed(CertificateId failed) {
  const auto [a, b] = overlaps_.failed(failed, changed());
  events_.repaired(a, b);
  overlaps_.settle(changed(), tied());
}

void BoxPairs::insert(ObjectId object) {
  overlaps_.insert(object, changed(), tied());
  events_.begin();
}

void BoxPairs::erase(ObjectId object) {
  overlaps_.erase(object, changed(), tied());
  events_.begin();
}

Attribute BoxPairs::attribute() const {
  Attribute result{Attribute::Shape::kTuples, {}};
  for (const BoxOverlaps::Pair& pair : overlaps_.pairs()) {
    result.ids.insert(result.ids.end(), pair.begin(), pair.end());
  }
  return result;
}

std::vector<BoundCheck> BoxPairs::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> result = end_bounds("box_pairs", overlaps_, context);
  // A pair begins or ceases to meet where one of two orders of ends along an axis changes.
  result.push_back(meeting_bound("box_pairs", 2 * dimension_, 1, context));
  return result;
}

void BoxPairs::check_invariants(AuditReport& report) const {
  overlaps_.check(report);
  report.check(!events_.any(), [] { return "a change of the pairs was not reported"; });
}

}  // namespace kinex
