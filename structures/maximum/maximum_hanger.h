// SPDX-License-Identifier: GPL-3.0-or-later
// MaximumHanger: the object with the largest (or smallest) key, by a kinetic hanger: a randomised
// heap-ordered binary tree.
//
// The tree. It is heap-ordered: the root of every subtree holds the best object of the subtree.
// Insertion walks down from the root, by a coin flip at each node. At the first object that is
// worse than the new one the two change roles: the new one stays, the other walks on; it beats all
// that it meets, so the objects on the walk move down by one place, and the last becomes a leaf at
// the first empty slot. Erasure promotes the better child into the hole, down to a leaf. The tree
// of a set of keys is thus distributed as if they had been inserted from the best to the worst.
//
//        a                   a           Insertion of x, better than b but not than a: x takes the
//       / '.                / '.         place of b; b and d move down along a random path that
//      b    c     --->     x    c        ends at an empty slot.
//       '.                  '.
//         d                  b
//                             '.
//                               d
//
// Certificates. One per object except the root: its parent is at least as good. The degree in t is
// D, the degree of the key. When a child overtakes its parent they change places; that is the whole
// repair. The two are neighbours in the order of all keys, and the distribution with respect to the
// new order is unchanged (where two neighbours of the order are not parent and child, exchanging
// them gives a tree of the same probability).
//
// Quality, for n objects:
//   compactness     n - 1 certificates
//   locality        3 certificates an object; with squared distances as keys, the object from
//                   which they are measured is in all n - 1
//   responsiveness  an event renews at most 5 certificates; an insertion or erasure renews those
//                   along one path, expected O(log n)
// lambda_D(n) is the greatest length of a Davenport-Schinzel sequence of order D over n symbols; it
// is n for D = 1.
// Events: two neighbours of the order that change places are parent and child with a probability
// that depends only on the number k of objects above them: q(0) = 1,
//   q(k) = sum_j C(k-1, j) q(j) / 2^k = Theta(1/k).
// So the expected number of events is exactly the sum of q(k) over all crossings of two keys with k
// objects above, which is O(lambda_D(n) log n), O(n log n) for lines: a statistical bound, checked
// by the tests. Hard bounds on the events: for affine keys the number of (ancestor, descendant)
// pairs, which holds for a heap of any shape; otherwise one event per crossing of two keys. The
// maximum changes at most lambda_D(n) - 1 times.
//
// Randomness. Coins come from a counter and a seed (fixed, except in tests): same input, same tree.
//
// Ties. As in MaximumHeap: where one of two objects with identically equal keys is an ancestor of
// the other, it has the smaller id.
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
    kReplace,  // the maximum has changed over an instant, not by a single swap: the old, the new
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
  // The largest number of steps from the root to an object. O(n).
  std::size_t depth() const;

 private:
  using Place = std::uint32_t;
  static constexpr Place kNone = 0xffffffffu;
  // A place of the tree and its object. A swap exchanges the objects of two places, no links.
  struct Node {
    ObjectId object = kNoObject;
    Place parent = kNone;
    std::array<Place, 2> child{kNone, kNone};
    CertificateId certificate = kNoCertificate;  // about the parent and this; none for the root
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
