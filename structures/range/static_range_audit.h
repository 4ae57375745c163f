// SPDX-License-Identifier: GPL-3.0-or-later
// The points in a box by exact positions: for audits.
#ifndef KINEX_STRUCTURES_RANGE_STATIC_RANGE_AUDIT_H
#define KINEX_STRUCTURES_RANGE_STATIC_RANGE_AUDIT_H

#include <cstdint>
#include <vector>

#include "core/engine/audit.h"

namespace kinex {

// A few boxes with points on their sides, which differ from one `turn` to the next.
std::vector<ExactBox> boxes_between_points(const Snapshot& snapshot,
                                           const std::vector<ObjectId>& alive, std::uint64_t turn);
// The points in the closed box, ascending, by comparing the coordinates of all.
std::vector<ObjectId> scanned_range(const Snapshot& snapshot, const ExactBox& box);
// Likewise by CGAL's Kd_tree and Fuzzy_iso_box with epsilon 0 in an exact kernel. Requires a box
// that is not empty.
std::vector<ObjectId> cgal_range(const Snapshot& snapshot, const ExactBox& box);

}  // namespace kinex

#endif
