// SPDX-License-Identifier: GPL-3.0-or-later
// HullCalipers: calipers (calipers.h) that follow a hull, for the structure that owns them.
//
//   the hull      a vertex came or went alone       the list follows: split, merge
//                 anything else, and every change   the list is built anew: renew
//                 of a hull of directions
//   the list      a certificate fails               its two edges change places
//                 the same, while the hull may      the certificate is dropped, and the list is built
//                 change at this instant            anew when the instant is settled
//
// The owner forwards its calls, and reports what is returned as events of its own.
//
// Cost: that of the calipers; O(h log h) signs where the list is built anew.
#ifndef KINEX_STRUCTURES_EXTENT_HULL_CALIPERS_H
#define KINEX_STRUCTURES_EXTENT_HULL_CALIPERS_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/engine/structure.h"
#include "structures/extent/calipers.h"
#include "structures/hull/hull_source.h"

namespace kinex {

class HullCalipers {
 public:
  // The first event kinds of an owner are these, in this order.
  enum Kind : std::uint8_t { kAntiparallel, kPerpendicular, kSplit, kMerge, kRenew };
  // What the failure of a certificate does to the calipers.
  struct Failure {
    Kind kind;                      // kAntiparallel or kPerpendicular
    std::array<ObjectId, 4> edges;  // two, each by its ends
    bool swapped;                   // false: the certificate was dropped
  };
  // What a change of the hull does to the calipers.
  struct HullChange {
    Kind kind;                    // kSplit, kMerge or kRenew
    std::array<ObjectId, 3> ids;  // not kRenew: a vertex, and the two that it is or was between
  };

  // `hull` outlives the calipers and is watched by their owner; it is the structure `hull_id`.
  HullCalipers(Kernel& kernel, StructureId owner, int folds, const HullSource& hull,
               StructureId hull_id);

  const Calipers& calipers() const { return calipers_; }
  const HullSource& hull() const { return *hull_; }
  // A certificate was dropped at this instant: the list may be out of order until settled().
  bool is_behind() const { return is_behind_; }
  bool owns(CertificateId certificate) const { return calipers_.owns(certificate); }

  // The list of the hull as it is; rebuild() makes every certificate anew.
  void build();
  void rebuild();
  Failure failed(CertificateId failed);
  void motions_changed(std::span<const ObjectId> objects) { calipers_.motions_changed(objects); }
  HullChange watched_changed(const Event* event);
  // The instant is settled; true if the list was built anew.
  bool settled();
  void forget_changes() { calipers_.forget_changes(); }

  // Hard bounds on the certificates, and on the events of the owner, which has this name.
  void add_bounds(const std::string& name, const BoundContext& context,
                  std::vector<BoundCheck>& checks) const;
  // One group for each certificate.
  void visit_proof(ProofVisitor& visitor) const;
  void check(AuditReport& report) const;
  std::size_t bytes() const { return calipers_.bytes(); }

 private:
  bool may_swap();
  bool follow(const Event& event, HullChange& change);

  Kernel* kernel_;
  StructureId hull_id_;
  const HullSource* hull_;
  Calipers calipers_;
  bool is_behind_ = false;
  std::uint64_t hull_instant_ = 0;  // of the last change of the hull
  std::uint64_t instant_ = 0;       // of the last failure
  std::size_t swaps_ = 0;           // at that instant
};

}  // namespace kinex

#endif
