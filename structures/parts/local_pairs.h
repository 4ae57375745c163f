// SPDX-License-Identifier: GPL-3.0-or-later
// LocalPairs: an attribute of pairs that changes near what an event names: for viewers, which would
// otherwise read all of it after every event.
#ifndef KINEX_STRUCTURES_PARTS_LOCAL_PAIRS_H
#define KINEX_STRUCTURES_PARTS_LOCAL_PAIRS_H

#include <vector>

#include "core/engine/certificate.h"

namespace kinex {

// What a structure whose attribute is a set of pairs can offer. In a call of certificate_failed that
// reports no common event, each pair that changes has an object that an event of the call names.
class LocalPairs {
 public:
  virtual ~LocalPairs() = default;
  // The objects that are paired with this one, ascending. O(their number).
  virtual std::vector<ObjectId> neighbours(ObjectId object) const = 0;
};

}  // namespace kinex

#endif
