// SPDX-License-Identifier: GPL-3.0-or-later
// The objects that a request is about: its query, its two classes, and the sites: those from which
// the structures that it reads are built.
#ifndef KINEX_STRUCTURES_PARTS_OBJECT_SETS_H
#define KINEX_STRUCTURES_PARTS_OBJECT_SETS_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/motion/scene.h"
#include "structures/parts/descriptor.h"

namespace kinex {

// The request's query; the first object if it names none.
ObjectId query_of(const Request& request);
// The objects of "of", without the query unless it is a site; of a structure of two colours those of
// both.
Subset sites_of(const StructureInfo& info, const Request& request, const Scene& scene);
// By object: true for those that the structure is built from, the query included. Empty: all.
std::vector<bool> members_of(const StructureInfo& info, const Request& request, const Scene& scene);

// Two classes of objects: those of the request's two colours, or, if it names none, those at even
// and at odd places of the scene.
class TwoClasses {
 public:
  TwoClasses(const Request& request, const Scene& scene);

  bool differ(ObjectId a, ObjectId b) const { return class_[a] + class_[b] == 1; }
  // False if it is in none of them. (Then it differs from no object.)
  bool has(ObjectId object) const { return class_[object] < kNone; }
  bool is_first(ObjectId object) const { return class_[object] == 0; }
  // The number of objects of the scene in the first class (0) or in the second (1).
  std::size_t size(int which) const { return sizes_[which]; }
  std::size_t bytes() const { return class_.capacity(); }

 private:
  static constexpr std::uint8_t kNone = 2;
  std::vector<std::uint8_t> class_;  // by object
  std::size_t sizes_[2] = {0, 0};
};

}  // namespace kinex

#endif
