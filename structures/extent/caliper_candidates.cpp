// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/caliper_candidates.h"

#include <algorithm>

#include "predicates/points/edge_predicates.h"

namespace kinex {

CaliperCandidates::CaliperCandidates(Kernel& kernel, CaliperMeasure measure) : measure_(measure) {
  switch (measure) {
    case CaliperMeasure::kDiameter:
      distances_.emplace(kernel, 2);
      break;
    case CaliperMeasure::kWidth:
      orders_.emplace(kernel, make_strip_order_2());
      break;
    case CaliperMeasure::kArea:
      orders_.emplace(kernel, make_rectangle_area_order_2());
      break;
    case CaliperMeasure::kPerimeter:
      orders_.emplace(kernel, make_rectangle_perimeter_order_2());
  }
}

std::optional<CaliperCandidates::Value> CaliperCandidates::of(const Calipers& calipers,
                                                              ObjectId edge) const {
  const HullRing& ring = calipers.ring();
  if (!ring.has(edge) || ring.size() < 2) return std::nullopt;
  const ObjectId to = ring.next(edge);
  Value value;
  value.fill(kNoObject);
  if (measure_ == CaliperMeasure::kDiameter) {
    if (!calipers.has_list() && to < edge) return std::nullopt;
    const ObjectId other = calipers.has_list() ? calipers.contact(edge, fold(calipers, 1)) : edge;
    if (other == to) return std::nullopt;
    value[0] = std::min(to, other);
    value[1] = std::max(to, other);
    return value;
  }
  if (!calipers.has_list()) return std::nullopt;
  value[0] = edge;
  value[1] = to;
  for (int k = 1; k < folds_of(measure_); ++k) {
    value[static_cast<std::size_t>(k) + 1] = calipers.contact(edge, fold(calipers, k));
  }
  return value;
}

std::vector<ObjectId> CaliperCandidates::shown(const Calipers& calipers, const Value& value) const {
  std::vector<ObjectId> ids(value.begin(), value.begin() + static_cast<std::ptrdiff_t>(size()));
  for (std::size_t i = 2; i < ids.size(); ++i) {
    ids[i] = calipers.least_contact(value[0], fold(calipers, static_cast<int>(i) - 1));
  }
  return ids;
}

Query CaliperCandidates::claim(const Value& front, const Value& back) const {
  if (distances_) return distances_->claim({back[0], back[1]}, {front[0], front[1]});
  return orders_->order({front.data(), size()}, {back.data(), size()});
}

}  // namespace kinex
