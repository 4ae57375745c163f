// SPDX-License-Identifier: GPL-3.0-or-later
// incidences_cutting: which points are above which lines y = a x + b, for lines and points that move. A
// point is watched against the lines that cross its cell of a cutting alone.
//
// The cutting. r lines, a random sample, and their trapezoids: trapezoids_2, of these lines. Each other
// line goes through the trapezoids from left to right, and each point is in one: a line that does not
// cross the trapezoid of a point cannot come to that point before one of these proofs fails.
//
// Attribute and external events: those of incidences_all. Internal events: "cell", the way of a line or
// the place of a point has changed; "change", "tie" as there.
//
// Certificates, beside those of trapezoids_2 and line_arrangement_2 of the sample:
//   ways     of each other line 2 or 3 for each trapezoid that it crosses (line_ways.h): O(r) of these
//            on average, in all O(n r)
//   places   4 of each point: line_side, line_under, and line_order of the two lines that cross at the
//            left side of its trapezoid, and at its right side
//   sides    one of each point and each line that crosses its trapezoid (line_sides.h): in a trapezoid
//            of a random sample expected O((n / r) log r)
// All have degree 2d at most. For n lines and n points O(r^2 + n r + (n^2 / r) log n) are expected.
//
// Repair. A line is led anew, in O(r) steps of O(r^2) time and O(r) comparisons, and compared with all
// points; a point is located anew with O(r^2) time and O(r) comparisons, and compared with all lines.
// Where the trapezoids change, so are the lines and points of those that are gone. All that when the
// instant is settled.
//
// Why that is all. Let a point pass a line that it is not watched against, while neither its place nor the
// way of the line fails, and the trapezoid of the point is still there. Then the trapezoid has shrunk to a
// part of the line for that instant, and the line has passed its corners, crossings of the sample. A line
// with a way crosses the sample in another order then: its way fails. Of a sample line the arrangement of
// the sample reports triples: their lines are compared with all points. What parallel lines do that pass
// through each other is not followed: then all lines and points are led and located anew.
//
// Bound. At most 2 d n m external events for motions of degree d, as for incidences_all.
//
// Ties. A point that is identically on a line is below it; lines are raised by infinitesimals, more so the
// smaller the id (crossing_lists.h).
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7, which names
// eps-nets; the layout is ours.
#ifndef KINEX_STRUCTURES_ARRANGEMENT_INCIDENCES_CUTTING_H
#define KINEX_STRUCTURES_ARRANGEMENT_INCIDENCES_CUTTING_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/arrangement/cutting_cells.h"
#include "structures/arrangement/line_numbers.h"
#include "structures/arrangement/line_sides.h"
#include "structures/arrangement/line_ways.h"
#include "structures/proximity/meeting_events.h"

namespace kinex {

// Pairs of a line and a point in one trapezoid, and the proof that the others do not meet.
class IncidencesCutting final : public Structure {
 public:
  // `trapezoids` outlives this structure and is watched by it, and so is the arrangement that it reads.
  // `sample`: the lines that they are of.
  IncidencesCutting(Kernel& kernel, StructureId id, const Trapezoids2& trapezoids,
                    std::span<const ObjectId> sample, const Scene& scene);

  std::string_view name() const override { return "incidences_cutting"; }
  // Those of MeetingEventKind: a pair "meets" while the point is above the line.
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"above", "below", "change", "tie", "cell"});
  }
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_settled() override { settle(); }
  void instant_over() override;
  void watched_changed(const Event* event) override;
  Attribute attribute() const override;
  Attribute told() const override { return events_.told(attribute()); }
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  std::uint64_t most_repairs(std::uint64_t certificates) const override { return certificates; }
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override;

 private:
  using Cell = CuttingCells::Cell;
  using Ids = std::vector<ObjectId>;
  enum Claim : std::size_t { kFloor, kCeiling, kLeft, kRight, kClaims };
  struct Place {  // of a point
    Cell cell = CuttingCells::kNone;
    std::array<CertificateId, kClaims> certificates;
    Ids watched;  // the lines that cross its cell, ascending
  };

  Ids& own(ObjectId object) {
    return !is_line_[object] ? points_ : is_sample_[object] ? samples_ : lines_;
  }
  void lose(ObjectId object);  // its way or place is to be found anew
  void lose_all();
  bool is_settled() const { return !cells_changed_ && lost_.empty() && suspects_.empty(); }
  bool
  settle();  // right after now; false: something is left, which the trapezoids do not allow yet
  void settle_all();
  bool is_higher(ObjectId l, ObjectId m, ObjectId p) const;  // m than l
  bool is_behind(const std::array<ObjectId, 2>& crossing, ObjectId p) const;
  Query order_claim(const std::array<ObjectId, 2>& crossing, bool behind, ObjectId p) const;
  std::vector<Query> claims_of(ObjectId p, std::vector<Claim>& which) const;
  bool locate(ObjectId p);
  void leave(ObjectId p);  // without a proof
  void compare(ObjectId line, ObjectId p);
  void watch(ObjectId line, ObjectId p);  // or no longer, as it crosses the cell of p
  std::vector<bool>::reference above(ObjectId line, ObjectId p) {
    return above_[std::size_t{numbers_[line]} * places_.size() + p];
  }
  bool above(ObjectId line, ObjectId p) const {
    return above_[std::size_t{numbers_[line]} * places_.size() + p];
  }

  static constexpr int kMostTries = 100;
  Kernel* kernel_;
  StructureId id_;
  const Trapezoids2* trapezoids_;
  PredicateId side_, under_, order_;
  std::vector<bool> is_line_, is_sample_;  // by object
  Ids lines_, points_, samples_;           // those that exist, ascending; lines without the sample
  CuttingCells cells_;
  LineWays ways_;
  Slots slots_;
  std::vector<Place> places_;  // by object
  LineSides sides_;
  LineNumbers numbers_;
  std::vector<bool> above_;  // by number of a line and by point
  MeetingEvents events_;
  Ids lost_;
  Ids suspects_;  // sample lines that have passed crossings of the sample
  bool cells_changed_ = false;
  int tries_ = 0;  // instants in a row at which something was left
};

}  // namespace kinex

#endif
