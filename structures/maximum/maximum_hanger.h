// SPDX-License-Identifier: GPL-3.0-or-later
// MaximumHanger: the object with the largest (or smallest) key, by a kinetic hanger: a randomised
// heap-ordered binary tree.
//
// The tree. An object below the best one of a subtree hangs in its left or its right part, by a
// coin of its own. Insertion starts at the root: the new object takes the place of the first object
// that is worse. The loser descends to a random child and becomes a leaf at the first empty slot.
// Erasure promotes the better child, down to a leaf. So the tree of a set of keys is distributed as
// if they had been inserted from the best to the worst.
//
//        a                   a           x, better than b but not than a, takes b's place; b goes
//       / '.                / '.         on to a random child, and so on down to an empty slot:
//      b    c     --->     x    c        the path of one insertion
//       '.                  '.
//         d                  b
//                             '.
//                               d
//
// Certificates. One per object except the root: its parent is at least as good; degree D in t, that
// of the key. When a child overtakes its parent they change places, which is the whole repair: the
// two are neighbours in the order of all keys, and the distribution with respect to the new order
// is unchanged (where two neighbours of the order are not parent and child, exchanging them gives a
// tree of the same probability).
//
// Quality, for n objects:
//   compactness     n - 1 certificates
//   locality        3 certificates an object
//   responsiveness  at most 5 certificates; an insertion or erasure a path, expected O(log n)
//                   certificates
// Events: two neighbours of the order that change places are parent and child with a probability
// that depends only on the number k of objects above them: q(0) = 1,
//   q(k) = sum_j C(k-1, j) q(j) / 2^k = Theta(1/k).
// So the expected number of events is exactly the sum of q(k) over all crossings of two keys with k
// objects above, which is O(lambda_D(n) log n), O(n log n) for lines: a statistical bound, checked
// by the tests. Hard bounds: for affine motions the number of (ancestor, descendant) pairs, as in a
// heap of any shape; otherwise one event per crossing. The maximum changes at most lambda_D(n) - 1
// times.
//
// Randomness. Coins come from a counter and a seed (fixed, except in tests): same input, same tree.
//
// Ties. As in MaximumHeap: of objects with identically equal keys the smaller id is above the
// larger, where one is above the other.
//
// Source: da Fonseca, de Figueiredo, Carvalho, "Kinetic hanger" (2004); the level argument:
// Clarkson, Shor, "Applications of random sampling in computational geometry, II" (1989).
#ifndef KINEX_STRUCTURES_MAXIMUM_MAXIMUM_HANGER_H
#define KINEX_STRUCTURES_MAXIMUM_MAXIMUM_HANGER_H

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "structures/maximum/maximum_structure.h"
#include "structures/parts/slots.h"
#include "structures/parts/ties.h"

namespace kinex {

class MaximumHanger final : public MaximumStructure {
 public:
  enum Kind : std::uint8_t {
    kSwap,     // parent and child change places: the old parent, the new one
    kTie,      // the same, because their keys have become identically equal
    kReplace,  // another maximum, by more than one swap: the old one, the new one
  };
  static constexpr std::uint64_t kSeed = 0x6b696e6574696373;

  MaximumHanger(Kernel& kernel, StructureId id, const Key& key, const Scene& scene,
                Extremum extremum, std::uint64_t seed = kSeed);

  std::vector<std::string_view> event_kinds() const override;
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  std::size_t bytes() const override;

  ObjectId winner() const override { return root_ == kNone ? kNoObject : nodes_[root_].object; }
  // The largest number of steps from the root to an object.
  std::size_t depth() const;

 private:
  using Place = std::uint32_t;
  static constexpr Place kNone = 0xffffffffu;
  // A place of the tree and its object. A swap changes only the objects at two places.
  struct Node {
    ObjectId object = kNoObject;
    Place parent = kNone;
    std::array<Place, 2> child{kNone, kNone};
    CertificateId certificate = kNoCertificate;  // of the parent and this; none for the root
  };

  void construct(std::vector<ObjectId> members);
  bool coin();
  Place hang(ObjectId object, std::vector<Place>& moved);
  void put(Place p, ObjectId object) {
    nodes_[p].object = object;
    place_of_[object] = p;
  }
  ObjectId above(Place p) const { return nodes_[nodes_[p].parent].object; }
  void set_certificate(Place p);
  void set_certificates_below(Place p, Place except);
  void exchange(Place child);
  void settle_ties();
  std::vector<std::uint64_t> depths() const;

  Slots slots_;
  Ties ties_;
  std::uint64_t seed_;
  std::uint64_t coins_ = 0;  // thrown so far
  std::vector<Node> nodes_;
  std::vector<Place> free_;
  std::vector<Place> place_of_;  // per object
  Place root_ = kNone;
  std::size_t size_ = 0;
};

}  // namespace kinex

#endif
