// SPDX-License-Identifier: GPL-3.0-or-later
// MaximumHeap: the object with the largest (or smallest) key, by a binary heap.
//
// Certificates. One per place i > 0 of the heap's array: the object at the parent (i - 1) / 2 is at
// least as good as the one at i; degree D in t, that of the key.
//
//         g                g
//         * 1              * 1
//         p                c            p's certificate with c fails: the two change places, and
//     2 * ' * 3        2 * ' * 3        the five certificates at them are renewed
//      c     s          p     s
//  4 * ' * 5        4 * ' * 5
//
// Quality, for n objects:
//   compactness     n - 1 certificates
//   locality        3 certificates an object
//   responsiveness  at most 5 certificates, O(log n); an insertion or erasure sifts along one path,
//                   O(log n) certificates
// Events, for affine motions without flight-plan changes: at most the number of (ancestor,
// descendant) pairs, the sum of the depths, (k - 2) 2^k + 2 for n = 2^k - 1, which is reached: each
// event removes a pair whose descendant has the larger slope, and makes none. A flight-plan change,
// an insertion or an erasure makes at most as many such pairs as the objects that it changes or
// moves are in, and the bound grows by these: O(log n) for an object at the bottom. (For m updates
// the literature has O(m sqrt(m log m)).) For motions of higher degree no bound with known
// constants is proven but one event per crossing. The maximum changes at most lambda_D(n) - 1
// times.
//
// Ties. Of objects with identically equal keys the smaller id is above the larger, where one is
// above the other; so the top is the smallest.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 5; events:
// Basch, Guibas, Ramkumar, "Reporting red-blue intersections between two sets of connected line
// segments" (1996); da Fonseca, de Figueiredo, "Kinetic heap-ordered trees" (2003).
#ifndef KINEX_STRUCTURES_MAXIMUM_MAXIMUM_HEAP_H
#define KINEX_STRUCTURES_MAXIMUM_MAXIMUM_HEAP_H

#include <span>
#include <string_view>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "core/motion/scene.h"
#include "structures/maximum/maximum_events.h"
#include "structures/parts/key_order.h"

namespace kinex {

class MaximumHeap final : public Structure {
 public:
  enum Kind : std::uint8_t {
    kSwap,     // parent and child change places: the old parent, the new one
    kTie,      // the same, because their keys have become identically equal
    kReplace,  // another maximum, by more than one swap: the old one, the new one
  };

  MaximumHeap(Kernel& kernel, StructureId id, const Key& key, const Scene& scene,
              Extremum extremum);

  std::string_view name() const override;
  std::vector<std::string_view> event_kinds() const override;
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_settled() override { events_.settle(top()); }
  Attribute attribute() const override;
  Attribute told() const override { return events_.told(); }
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override;

  // kNoObject if there is none.
  ObjectId top() const { return heap_.empty() ? kNoObject : heap_[0]; }

 private:
  using Place = std::uint32_t;
  static constexpr Place kNone = 0xffffffffu;

  void construct(std::vector<ObjectId> members);
  std::uint64_t relatives(Place i) const;
  void put(Place i, ObjectId object) {
    heap_[i] = object;
    place_of_[object] = i;
  }
  void set_certificate(Place i);
  void exchange(Place child);
  void settle_ties();
  void sift_up(Place i, std::vector<Place>& moved);
  void sift_down(Place i, std::vector<Place>& moved);
  void renew(const std::vector<Place>& moved);

  Kernel* kernel_;
  StructureId id_;
  Contest contest_;
  MaximumEvents events_;
  std::vector<ObjectId> heap_;
  std::vector<CertificateId> certificate_;  // per place, of it and its parent; none for the root
  std::vector<Place> place_of_;             // per object
  std::uint64_t pairs_ = 0;  // of an ancestor and a descendant that may still fail, or have failed
  std::vector<Place> ties_;  // certificates that are identically zero, not yet checked
};

}  // namespace kinex

#endif
