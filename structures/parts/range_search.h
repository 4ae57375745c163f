// SPDX-License-Identifier: GPL-3.0-or-later
// RangeSearch: the points in an axis-parallel box, right after now.
#ifndef KINEX_STRUCTURES_PARTS_RANGE_SEARCH_H
#define KINEX_STRUCTURES_PARTS_RANGE_SEARCH_H

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/motion/scene.h"

namespace kinex {

// The role of the structures that answer queries for boxes (StructureInfo::role).
inline constexpr std::string_view kRangeSearch = "range_search";

// The cost of a query.
struct QueryCounts {
  std::uint64_t nodes = 0;  // of trees, looked at
  std::uint64_t signs = 0;  // of coordinate differences
};

class RangeSearch {
 public:
  virtual ~RangeSearch() = default;
  // Appends the points in the closed box whose least and largest corners are the constants `low`
  // and `high` (Kernel::constant), in no particular order. A box whose least coordinate is larger
  // than its largest on some axis holds no point. Adds its cost to `counts`.
  virtual void report(ObjectId low, ObjectId high, std::vector<ObjectId>& out,
                      QueryCounts& counts) = 0;
};

}  // namespace kinex

#endif
