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
      touch_(kernel.bind(make_orientation_2_touch())),
      power_(kernel.bind(extents == Extents::kRadius ? make_disc_power_2() : make_power_2())),
      between_(kernel.bind(make_obtuse_angle_2())) {}

bool PlaneGeometry::equal(ObjectId a, ObjectId b, When when) const {
  return std::all_of(order_.begin(), order_.end(), [&](PredicateId order) {
    return kernel_->sign(Query(order, {a, b}), when) == Sign::kZero;
  });
}

Query PlaneGeometry::claim(const Corners& t, unsigned i, ObjectId apex) const {
  if (!is_ghost(t)) {
    if (apex == infinity_) return Query(touch_, {t[0], t[1], t[2]});
    return power_claim(t, apex);
  }
  const Corners filled = replaced(t, infinity_, apex);
  return Query(t[i] == infinity_ ? touch_ : orientation_, {filled[1], filled[0], filled[2]});
}

Query PlaneGeometry::tie_claim(const Corners& t, unsigned i, ObjectId apex) const {
  if (is_ghost(t)) return t[i] == infinity_ ? claim(t, i, apex) : between_claim(t, i, apex);
  if (apex == infinity_) return claim(t, i, apex);
  std::array<ObjectId, 4> ids{t[0], t[1], t[2], apex};
  std::sort(ids.begin(), ids.end());
  for (const ObjectId u : ids) {
    if (u == apex) break;
    const Corners turned = replaced(t, u, apex);
    if (orientation(turned) != Sign::kZero) {
      return orientation_claim(turned[0], turned[1], turned[2]);
    }
  }
  return orientation_claim(t[1], t[0], t[2]);  // the apex is below
}

Query PlaneGeometry::between_claim(const Corners& t, unsigned i, ObjectId apex) const {
  const ObjectId middle = t[(i + 1) % 3] == infinity_ ? t[(i + 2) % 3] : t[(i + 1) % 3];
  return Query(between_, {t[i], middle, apex});
}

bool PlaneGeometry::is_bad(const Corners& t, unsigned i, ObjectId apex) const {
  if (!is_ghost(t)) {
    return apex == infinity_ ? orientation(t) != Sign::kPositive : below(t, apex);
  }
  const Sign sign = orientation(replaced(t, infinity_, apex));
  if (sign != Sign::kZero) return sign == Sign::kPositive;
  return t[i] == infinity_ ||
         kernel_->sign_after(between_claim(t, i, apex)) != Sign::kPositive;
}

bool PlaneGeometry::below(const Corners& t, ObjectId v) const {
  const Sign sign = kernel_->sign_after(power_, {t[0], t[1], t[2], v});
  if (sign != Sign::kZero) return sign == Sign::kPositive;
  return kernel_->sign_after(tie_claim(t, 0, v)) != Sign::kPositive;
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
