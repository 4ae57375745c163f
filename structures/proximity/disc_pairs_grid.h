// SPDX-License-Identifier: GPL-3.0-or-later
// DiscPairsGrid: the pairs of moving discs (in space balls, on a line intervals) that meet, among
// discs with centres in neighbouring cells of a grid.
//
// The centres never leave a box that holds all flight plans. It is cut into cells that are wider
// than the largest diameter that a disc ever has, and no more of them than discs (point_grid.h). Two
// columns apart, or more, discs do not even touch:
//
//     |   a    |        |  b     |      |ab| >= W > 2 r >= ra + rb
//     |  cell  |<- W -->|  cell  |
//
// Certificates.
//   a centre is on its side of the lines around its cell: at most 2 D n in D axes, of degree d for
//   motions and radii of degree d
//   +-disc_overlap of each pair in the same cell or in neighbouring ones: degree 2d (disc_claims.h)
//
// Quality, for n discs: discs that are far from each other share no certificate. Spread-out discs
// of one size have O(n) pairs; n discs in one cell have all C(n, 2), as disc_pairs_all, and so have n
// discs of which one is as large as the box. A centre that moves to another cell brings or takes one
// certificate for each pair that is near from then on, or no longer. External events: those of
// disc_pairs_all. The grid is laid anew when there are more than twice as many discs as cells were
// asked for, or fewer than a quarter.
//
// Requires a scene with an end: otherwise there is no box, and no largest diameter. Both are those of the
// scene's own flight plans, so Simulator refuses others during the run.
//
// Ties. Discs are closed: two that touch identically meet. A centre on a line identically is in
// either cell, since cells are wider than they have to be.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7, has the
// problem. The grid is ours.
#ifndef KINEX_STRUCTURES_PROXIMITY_DISC_PAIRS_GRID_H
#define KINEX_STRUCTURES_PROXIMITY_DISC_PAIRS_GRID_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/proximity/disc_claims.h"
#include "structures/proximity/meeting_events.h"
#include "structures/proximity/point_grid.h"

namespace kinex {

class DiscPairsGrid final : public Structure {
 public:
  DiscPairsGrid(Kernel& kernel, StructureId id, const Scene& scene);

  std::string_view name() const override { return "disc_pairs_grid"; }
  // Those of MeetingEventKind.
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"meet", "part", "change", "tie", "cell"});
  }
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override { build(std::vector<ObjectId>(members_)); }
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_over() override { events_.over(); }
  Attribute attribute() const override {
    return {Attribute::Shape::kTuples, claims_.meeting()};
  }
  Attribute told() const override { return events_.told(attribute()); }
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  // After the scene's end discs may be larger than cells are wide.
  bool holds_at(const Snapshot& snapshot) const override { return grid_.is_wide_enough(snapshot); }
  bool takes_other_plans() const override { return false; }
  std::size_t bytes() const override;

 private:
  using Pair = DiscClaims::Pair;
  // Columns, rows and layers between two discs that may meet.
  static constexpr std::int64_t kReach = 1;

  std::vector<Pair> near_pairs() const;
  void lay();
  void cell_changed(CertificateId failed);

  PointGrid grid_;
  std::vector<ObjectId> members_;  // ascending
  std::size_t most_lines_ = 0, layings_ = 0;
  DiscClaims claims_;  // of the near pairs
  MeetingEvents events_;
};

}  // namespace kinex

#endif
