// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/plane_geometry.h"

#include <algorithm>

#include "predicates/points/power_predicates.h"
#include "predicates/predicates.h"

namespace kinex {
namespace {

PlaneGeometry::Corners replaced(PlaneGeometry::Corners t, ObjectId old, ObjectId fresh) {
  for (ObjectId& v : t) {
    if (v == old) v = fresh;
  }
  return t;
}

}  // namespace

PlaneGeometry::PlaneGeometry(Kernel& kernel, Extents extents, ObjectId infinity)
    : kernel_(&kernel),
      infinity_(infinity),
      radii_(extents == Extents::kRadius),
      order_{kernel.bind(make_coordinate_order(0)), kernel.bind(make_coordinate_order(1))},
      orientation_(kernel.bind(make_orientation_2())),
      power_(kernel.bind(extents == Extents::kRadius ? make_disc_power_2() : make_power_2())) {}

bool PlaneGeometry::equal(ObjectId a, ObjectId b, When when) const {
  return std::all_of(order_.begin(), order_.end(), [&](PredicateId order) {
    return kernel_->sign(Query(order, {a, b}), when) == Sign::kZero;
  });
}

Query PlaneGeometry::claim(const Corners& t, ObjectId apex) const {
  if (!is_ghost(t)) {
    if (apex == infinity_) return Query(orientation_, {t[0], t[1], t[2]});
    return power_claim(t, apex);
  }
  const Corners filled = replaced(t, infinity_, apex);
  return Query(orientation_, {filled[1], filled[0], filled[2]});
}

bool PlaneGeometry::is_bad(const Corners& t, unsigned i, ObjectId apex) const {
  if (!is_ghost(t)) {
    return apex == infinity_ ? orientation(t) != Sign::kPositive : below(t, apex);
  }
  const Sign sign = orientation(replaced(t, infinity_, apex));
  if (sign != Sign::kZero) return sign == Sign::kPositive;
  if (t[i] == infinity_) return true;
  const ObjectId middle = t[(i + 1) % 3] == infinity_ ? t[(i + 2) % 3] : t[(i + 1) % 3];
  return turns_back(t[i], middle, apex);
}

// Of points identically on one line: b is not strictly between a and c.
bool PlaneGeometry::turns_back(ObjectId a, ObjectId b, ObjectId c) const {
  for (const PredicateId order : order_) {
    const Sign there = kernel_->sign_after(order, {a, b});
    if (there != Sign::kZero) return kernel_->sign_after(order, {b, c}) != there;
  }
  return true;
}

bool PlaneGeometry::below(const Corners& t, ObjectId v) const {
  const Sign sign = kernel_->sign_after(power_, {t[0], t[1], t[2], v});
  if (sign != Sign::kZero) return sign == Sign::kPositive;
  std::array<ObjectId, 4> ids{t[0], t[1], t[2], v};
  std::sort(ids.begin(), ids.end());
  for (const ObjectId u : ids) {
    if (u == v) return true;
    const Sign turned = orientation(replaced(t, u, v));
    if (turned != Sign::kZero) return turned == Sign::kNegative;
  }
  return true;
}

bool PlaneGeometry::conflict(const Triangulation2& store, Triangle t, ObjectId v) const {
  const Corners corners = store.corners(t);
  for (unsigned i = 0; i < 3; ++i) {
    if (corners[i] != infinity_) continue;
    const Sign sign = orientation(replaced(corners, infinity_, v));
    if (sign != Sign::kZero) return sign == Sign::kPositive;
    const HalfEdge within = store.twin(3 * t + (i + 1) % 3);  // of the hull edge
    return store.apex(within) != v && below(store.corners(Triangulation2::triangle(within)), v);
  }
  return below(corners, v);
}

}  // namespace kinex
