// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/space_geometry.h"

#include <array>

#include "predicates/points/space_predicates.h"

namespace kinex {

SpaceGeometry::SpaceGeometry(Kernel& kernel, ObjectId infinity)
    : LiftedGeometry(kernel, infinity, make_in_sphere_3()) {}

Query SpaceGeometry::claim(const Simplex& q, unsigned, ObjectId apex) const {
  if (is_ghost(q)) return orientation_claim(turned(replaced(q, infinity(), apex)));
  return apex == infinity() ? orientation_claim(q) : power_claim(q, apex);
}

bool SpaceGeometry::is_bad(const Simplex& q, unsigned i, ObjectId apex) const {
  if (!is_ghost(q)) {
    return apex == infinity() ? orientation(q) != Sign::kPositive : below(q, apex);
  }
  const Sign sign = orientation(replaced(q, infinity(), apex));
  if (sign != Sign::kZero) return sign == Sign::kPositive;
  return q[i] == infinity() || folded(q, i, apex);
}

// In their plane both triangles must lie on different sides of their edge.
bool SpaceGeometry::folded(const Simplex& q, unsigned i, ObjectId apex) const {
  std::array<ObjectId, 2> edge{};
  std::size_t count = 0;
  for (unsigned k = 0; k < 4; ++k) {
    if (k != i && q[k] != infinity()) edge[count++] = q[k];
  }
  for (const PredicateId turn : projections()) {
    const Sign sign = kernel().sign_after(turn, {edge[0], edge[1], q[i]});
    if (sign == Sign::kZero) continue;
    const Sign other = kernel().sign_after(turn, {edge[0], edge[1], apex});
    return other == sign || other == Sign::kZero;
  }
  return true;
}

}  // namespace kinex
