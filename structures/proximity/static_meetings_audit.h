// SPDX-License-Identifier: GPL-3.0-or-later
// The pairs that meet at exact positions: for audits.
#ifndef KINEX_STRUCTURES_PROXIMITY_STATIC_MEETINGS_AUDIT_H
#define KINEX_STRUCTURES_PROXIMITY_STATIC_MEETINGS_AUDIT_H

#include <vector>

#include "core/engine/audit.h"

namespace kinex {

// All pairs (a, b) of living objects, a < b, for which meet(a, b), flattened, ascending.
template <class Meet>
std::vector<ObjectId> static_meetings(const Snapshot& snapshot, const Meet& meet) {
  std::vector<ObjectId> result;
  for (ObjectId a = 0; a < snapshot.objects(); ++a) {
    for (ObjectId b = a + 1; snapshot.alive(a) && b < snapshot.objects(); ++b) {
      if (snapshot.alive(b) && meet(a, b)) result.insert(result.end(), {a, b});
    }
  }
  return result;
}

// Closed boxes, or the boxes of discs.
std::vector<ObjectId> static_box_pairs(const Snapshot& snapshot, bool discs);
// Closed discs.
std::vector<ObjectId> static_disc_pairs(const Snapshot& snapshot);

}  // namespace kinex

#endif
