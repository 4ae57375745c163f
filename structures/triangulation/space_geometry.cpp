// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/space_geometry.h"

#include <algorithm>

#include "predicates/points/space_predicates.h"
#include "predicates/predicates.h"

namespace kinex {
namespace {

SpaceGeometry::Quad with(SpaceGeometry::Quad q, ObjectId old, ObjectId fresh) {
  for (ObjectId& v : q) {
    if (v == old) v = fresh;
  }
  return q;
}

}  // namespace

SpaceGeometry::SpaceGeometry(Kernel& kernel, ObjectId infinity)
    : kernel_(&kernel),
      infinity_(infinity),
      order_{kernel.bind(make_coordinate_order(0)), kernel.bind(make_coordinate_order(1)),
             kernel.bind(make_coordinate_order(2))},
      projected_{kernel.bind(make_projected_orientation(0, 1)),
                 kernel.bind(make_projected_orientation(0, 2)),
                 kernel.bind(make_projected_orientation(1, 2))},
      orientation_(kernel.bind(make_orientation_3())),
      in_sphere_(kernel.bind(make_in_sphere_3())) {}

bool SpaceGeometry::equal(ObjectId a, ObjectId b, When when) const {
  return std::all_of(order_.begin(), order_.end(), [&](PredicateId order) {
    return kernel_->sign(Query(order, {a, b}), when) == Sign::kZero;
  });
}

bool SpaceGeometry::on_line(ObjectId a, ObjectId b, ObjectId c) const {
  return std::all_of(projected_.begin(), projected_.end(), [&](PredicateId turn) {
    return kernel_->sign_after(turn, {a, b, c}) == Sign::kZero;
  });
}

Query SpaceGeometry::claim(const Quad& q, ObjectId apex) const {
  if (!is_ghost(q)) {
    if (apex == infinity_) return Query(orientation_, {q[0], q[1], q[2], q[3]});
    return Query(in_sphere_, {q[1], q[0], q[2], q[3], apex});
  }
  const Quad filled = with(q, infinity_, apex);
  return Query(orientation_, {filled[1], filled[0], filled[2], filled[3]});
}

bool SpaceGeometry::is_bad(const Quad& q, unsigned i, ObjectId apex) const {
  if (!is_ghost(q)) {
    return apex == infinity_ ? orientation(q) != Sign::kPositive : inside(q, apex);
  }
  const Sign sign = orientation(with(q, infinity_, apex));
  if (sign != Sign::kZero) return sign == Sign::kPositive;
  return q[i] == infinity_ || folded(q, i, apex);
}

// In their plane both triangles must lie on different sides of their edge.
bool SpaceGeometry::folded(const Quad& q, unsigned i, ObjectId apex) const {
  std::array<ObjectId, 2> edge{};
  std::size_t count = 0;
  for (unsigned k = 0; k < 4; ++k) {
    if (k != i && q[k] != infinity_) edge[count++] = q[k];
  }
  for (const PredicateId turn : projected_) {
    const Sign sign = kernel_->sign_after(turn, {edge[0], edge[1], q[i]});
    if (sign == Sign::kZero) continue;
    const Sign other = kernel_->sign_after(turn, {edge[0], edge[1], apex});
    return other == sign || other == Sign::kZero;
  }
  return true;
}

bool SpaceGeometry::inside(const Quad& q, ObjectId v) const {
  const Sign sign = kernel_->sign_after(in_sphere_, {q[0], q[1], q[2], q[3], v});
  if (sign != Sign::kZero) return sign == Sign::kPositive;
  std::array<ObjectId, 5> ids{q[0], q[1], q[2], q[3], v};
  std::sort(ids.begin(), ids.end());
  for (const ObjectId u : ids) {
    if (u == v) return true;
    const Sign turned = orientation(with(q, u, v));
    if (turned != Sign::kZero) return turned == Sign::kNegative;
  }
  return true;
}

bool SpaceGeometry::conflict(const Triangulation3& store, Cell c, ObjectId v) const {
  const Quad q = store.quad(c);
  const Facet beyond = store.place_of(c, infinity_);
  if (beyond == Triangulation3::kNone) return inside(q, v);
  const Sign sign = orientation(with(q, infinity_, v));
  if (sign != Sign::kZero) return sign == Sign::kPositive;
  const Facet within = store.mate(beyond);
  return store.apex(within) != v && inside(store.quad(Triangulation3::cell(within)), v);
}

}  // namespace kinex
