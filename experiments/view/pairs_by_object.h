// SPDX-License-Identifier: GPL-3.0-or-later
// PairsByObject: an attribute that is a set of pairs, by their objects: a change near a few objects is
// found in their neighbourhood alone.
#ifndef KINEX_EXPERIMENTS_VIEW_PAIRS_BY_OBJECT_H
#define KINEX_EXPERIMENTS_VIEW_PAIRS_BY_OBJECT_H

#include <vector>

#include "core/engine/structure.h"
#include "experiments/view/attribute_change.h"
#include "structures/parts/local_pairs.h"

namespace kinex::view {

class PairsByObject {
 public:
  // Requires a set of pairs.
  explicit PairsByObject(const Attribute& attribute);

  // Takes over the pairs of these objects from the structure; returns what has changed (its event is not
  // set), as difference() would. O(pairs of these objects, and of their neighbours).
  AttributeChange update(const LocalPairs& structure, std::vector<ObjectId> objects);
  Attribute attribute() const;

 private:
  std::vector<ObjectId>& of(ObjectId object);
  void erase(ObjectId a, ObjectId b);
  void insert(ObjectId a, ObjectId b);

  std::vector<std::vector<ObjectId>> neighbours_;  // ascending
};

}  // namespace kinex::view

#endif
