// SPDX-License-Identifier: GPL-3.0-or-later
// KeyOrder and Contest: the order of objects by a key, as certificates and as comparisons.
//
// Ties: of objects with identically equal keys the smaller id comes first, and wins.
#ifndef KINEX_STRUCTURES_PARTS_KEY_ORDER_H
#define KINEX_STRUCTURES_PARTS_KEY_ORDER_H

#include <memory>
#include <span>
#include <vector>

#include "core/arithmetic/predicate.h"
#include "core/engine/bound.h"
#include "core/engine/kernel.h"
#include "core/motion/scene.h"
#include "structures/parts/claim.h"

namespace kinex {

class KeyOrder {  // the smaller key comes first
 public:
  // Throws std::invalid_argument if the key is undefined in the scene.
  KeyOrder(Kernel& kernel, const Key& key, const Scene& scene);

  const Key& key() const { return key_; }
  // The object that squared distances are measured to, itself not ordered; kNoObject: none.
  ObjectId reference() const { return reference_; }
  // "key(a) <= key(b)".
  Query query(ObjectId a, ObjectId b) const {
    return reference_ == kNoObject ? Query::of(predicate_, a, b)
                                   : Query(predicate_, {a, b, reference_});
  }
  // The claims of a part whose items are objects (claim.h): the smaller key is in front.
  Query claim(ObjectId front, ObjectId back) const { return query(front, back); }
  bool goes_first(ObjectId a, ObjectId b) const { return a < b; }
  // True if a comes before b right after now, ties by id.
  bool before(ObjectId a, ObjectId b) const { return in_front(*kernel_, *this, a, b); }
  // `objects` without the reference. Throws std::invalid_argument if the reference is not among
  // them.
  std::vector<ObjectId> members(std::span<const ObjectId> objects) const;
  // Throws std::invalid_argument if `object` is the reference.
  void check_erasure(ObjectId object) const;
  // Degree in t of the certificates for motions of degree d.
  int degree(int motion_degree) const { return formula_->degree(motion_degree); }
  // The pieces of the members, and those of the reference (1 if there is none).
  std::vector<int> member_pieces(const BoundContext& context) const;
  int reference_pieces(const BoundContext& context) const;

 private:
  Kernel* kernel_;
  Key key_;
  ObjectId reference_;
  std::shared_ptr<const Predicate> formula_;
  PredicateId predicate_;
};

enum class Extremum { kMaximum, kMinimum };  // which end of an order

// A key and its better end: the largest or the smallest key wins.
class Contest {
 public:
  Contest(Extremum extremum, Kernel& kernel, const Key& key, const Scene& scene)
      : order_(kernel, key, scene), extremum_(extremum), kernel_(&kernel) {}

  const KeyOrder& order() const { return order_; }
  Extremum extremum() const { return extremum_; }
  // "winner's key is at least as good as loser's".
  Query claim(ObjectId winner, ObjectId loser) const {
    return extremum_ == Extremum::kMaximum ? order_.query(loser, winner)
                                           : order_.query(winner, loser);
  }
  bool goes_first(ObjectId a, ObjectId b) const { return a < b; }
  // True if a wins right after now, ties by id.
  bool beats(ObjectId a, ObjectId b) const { return in_front(*kernel_, *this, a, b); }

 private:
  KeyOrder order_;
  Extremum extremum_;
  Kernel* kernel_;
};

}  // namespace kinex

#endif
