// SPDX-License-Identifier: GPL-3.0-or-later
// MaximumEnvelope: the object with the largest (or smallest) key, read off the upper envelope of
// the keys, computed in advance.
//
// Certificates. One: the present winner is at least as good as the next one of the envelope. Its
// degree in t is D, the degree of the key. The last winner has none. The envelope is the rest of
// the proof; it needs no certificates while the motions for which it was computed are in force.
//
// Quality, for n objects:
//   compactness     1 certificate
//   locality        1 certificate per object
//   responsiveness  1 certificate per event; every flight-plan change, insertion and erasure
//                   computes the envelope anew, O(lambda_D(n) log n) failure times and comparisons
//                   of instants
//   efficiency      every event is external, at most lambda_D(n) - 1
//   space           O(lambda_D(n)) for the envelope
// lambda_D(n) is the greatest length of a Davenport-Schinzel sequence of order D over n symbols (n
// for D = 1). This is the offline baseline for kinetic structures: as good while no motion changes,
// far more expensive when many do.
//
// Motions on intervals (flight plans, objects that come and go). The envelope is that of the
// motions in force, each extended for all time; it is right until the first of them ends, and is
// then computed anew from those that follow. Pieces planned for later are ignored, although the
// envelope of all of them, lambda_{D+2}(pieces) winners, could be computed at the start: a
// structure learns of a flight plan only when it comes into force. So a run is the same whether a
// change stands in the scene or comes from outside during the run, and a change from outside
// replaces the planned one. The events are nevertheless those of the envelope of all pieces: at
// most lambda_{D+2}(m) - 1 for m pieces. The cost is that of m envelopes.
//
// Ties. Of identically equal keys the smallest id wins. Where several objects overtake the winner
// at one instant, only the one that is best right after it becomes the winner.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 5.
#ifndef KINEX_STRUCTURES_MAXIMUM_MAXIMUM_ENVELOPE_H
#define KINEX_STRUCTURES_MAXIMUM_MAXIMUM_ENVELOPE_H

#include <span>
#include <string_view>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "core/motion/scene.h"
#include "structures/parts/key_order.h"
#include "structures/parts/slots.h"

namespace kinex {

class MaximumEnvelope final : public Structure {
 public:
  enum Kind : std::uint8_t {
    kReplace,  // another winner: the old one, the new one
    kTie,      // the same, because their keys have become identically equal
  };

  MaximumEnvelope(Kernel& kernel, StructureId id, const Key& key, const Scene& scene,
                  Extremum extremum);

  std::string_view name() const override;
  std::vector<std::string_view> event_kinds() const override;
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override { renew(); }
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  Attribute attribute() const override;
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  bool holds_at(const Snapshot& snapshot) const override;
  std::size_t bytes() const override;

  // kNoObject if there is none.
  ObjectId winner() const { return winners_.empty() ? kNoObject : winners_[at_]; }
  // The number of winners still to come under the motions in force.
  std::size_t to_come() const { return winners_.empty() ? 0 : winners_.size() - 1 - at_; }

 private:
  void renew();
  void set_certificate();

  Kernel* kernel_;
  StructureId id_;
  Contest contest_;
  Slots slots_;
  const Scene* scene_;
  std::vector<ObjectId> members_;  // ascending
  std::vector<ObjectId> winners_;  // from some instant on
  std::size_t at_ = 0;             // the present one
  CertificateId certificate_ = kNoCertificate;
};

}  // namespace kinex

#endif
