// SPDX-License-Identifier: GPL-3.0-or-later
// incidences_all: which points are above which lines y = a x + b, for lines and points that move.
// Every pair is watched: the baseline.
//
// Attribute. The pairs of a line and a point above it, in ascending order of the two ids. External
// events, when the instant is over: "below" for every pair that was above and is so no longer, then
// "above" for every pair that has become so, both in ascending order.
//
// Certificates. nm for n lines and m points, one a pair (line_sides.h), degree 2d for motions of
// degree d; a line in m, a point in n. Every failure is external, unless a pair changes twice at one
// instant.
//
// Bound. At most 2 d n m changes for motions of degree d: each is a root of the pair's polynomial.
//
// Ties. A point that is identically on a line is below it.
//
// Cost: an insertion or erasure O(n + m) certificates; O(log) for each in the queue.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7.
#ifndef KINEX_STRUCTURES_ARRANGEMENT_INCIDENCES_ALL_H
#define KINEX_STRUCTURES_ARRANGEMENT_INCIDENCES_ALL_H

#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/arrangement/line_sides.h"
#include "structures/proximity/meeting_events.h"

namespace kinex {

// All pairs of a line and a point, each with a certificate of its own.
class IncidencesAll final : public Structure {
 public:
  IncidencesAll(Kernel& kernel, StructureId id, const Scene& scene);

  std::string_view name() const override { return "incidences_all"; }
  // Those of MeetingEventKind: a pair "meets" while the point is above the line.
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"above", "below", "change", "tie"});
  }
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_over() override { events_.over(); }
  Attribute attribute() const override;
  Attribute told() const override { return events_.told(attribute()); }
  void visit_proof(ProofVisitor& visitor) const override { sides_.visit_proof(visitor); }
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override;

 private:
  // The members of the other kind, ascending.
  const std::vector<ObjectId>& others(ObjectId object) const {
    return is_line_[object] ? points_ : lines_;
  }
  std::vector<ObjectId>& own(ObjectId object) { return is_line_[object] ? lines_ : points_; }
  LineSides::Pair pair(ObjectId a, ObjectId b) const {
    return is_line_[a] ? LineSides::Pair{a, b} : LineSides::Pair{b, a};
  }

  std::vector<bool> is_line_;  // by object
  std::vector<ObjectId> lines_, points_;  // those that exist, ascending
  LineSides sides_;
  MeetingEvents events_;
};

}  // namespace kinex

#endif
