// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/static_order_audit.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

namespace kinex {

std::vector<ObjectId> static_order(const Snapshot& snapshot, OctantAxis axis) {
  const auto [u, v] = octant_axis(axis);
  std::vector<std::tuple<Rational, Rational, ObjectId>> keys;
  for (ObjectId id = 0; id < snapshot.objects(); ++id) {
    if (!snapshot.alive(id)) continue;
    const Rational &x = snapshot.position(id, 0), &y = snapshot.position(id, 1);
    keys.emplace_back(Rational(u) * x + Rational(v) * y, Rational(v) * x - Rational(u) * y, id);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<ObjectId> order;
  order.reserve(keys.size());
  for (const auto& key : keys) order.push_back(std::get<2>(key));
  return order;
}

void check_order(const Snapshot& snapshot, OctantAxis axis, const std::vector<ObjectId>& order,
                 AuditReport& report) {
  report.check(order == static_order(snapshot, axis), [axis] {
    return std::string("the order differs from a sorted list, by ") + octant_axis_name(axis);
  });
}

}  // namespace kinex
