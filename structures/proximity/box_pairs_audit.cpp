// SPDX-License-Identifier: GPL-3.0-or-later
// The pairs of closed boxes that meet at exact positions, and of discs, by trying all pairs.
#include "structures/proximity/box_pairs.h"
#include "structures/proximity/static_meetings_audit.h"

namespace kinex {

std::vector<ObjectId> static_box_pairs(const Snapshot& snapshot, bool discs) {
  return static_meetings(snapshot, [&](ObjectId a, ObjectId b) {
    const int dimension = snapshot.dimension();
    for (int axis = 0; axis < dimension; ++axis) {
      const int extent = discs ? dimension : dimension + axis;
      const Rational reach = snapshot.position(a, extent) + snapshot.position(b, extent);
      const Rational apart = snapshot.position(b, axis) - snapshot.position(a, axis);
      if (reach < apart || reach < -apart) return false;
    }
    return true;
  });
}

std::vector<ObjectId> static_disc_pairs(const Snapshot& snapshot) {
  return static_meetings(snapshot, [&](ObjectId a, ObjectId b) {
    const int dimension = snapshot.dimension();
    const Rational reach = snapshot.position(a, dimension) + snapshot.position(b, dimension);
    Rational rest = reach * reach;
    for (int axis = 0; axis < dimension; ++axis) {
      const Rational step = snapshot.position(b, axis) - snapshot.position(a, axis);
      rest -= step * step;
    }
    return rest.sign() >= 0;
  });
}

void BoxPairs::audit(const Snapshot& snapshot, AuditReport& report) const {
  report.check(static_box_pairs(snapshot, discs_) == attribute().ids,
               [] { return "other boxes meet"; });
}

}  // namespace kinex
