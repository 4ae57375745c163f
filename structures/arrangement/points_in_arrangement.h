// SPDX-License-Identifier: GPL-3.0-or-later
// points_in_arrangement: for every moving point the next line above it and the next one below it,
// among moving lines y = a x + b; so the face of their arrangement that it is in.
//
//          \        /            p is below l, which is above it, between the crossings of l
//   --------m------k---- l       with m and k: three claims; and three for the line below.
//            \  p /
//
// Attribute (kSequence). For each point, ascending: itself, the line above, the line below; the point
// itself again where there is none. External events, when the instant is over, by point:
//   above, below   the point, the line that was next to it, the one that is now
// Internal events: "move", the proof of a point has failed; it is made anew when nothing else is to be
// repaired at the instant.
//
// It reads line_arrangement_2, of the lines: which crossings of l are neighbours. The lines next to a
// point change only where it passes one of them, or a crossing of them: the claims say when.
//
// Certificates. 6 a point, of degree 2d: line_side or line_under, and line_order for the crossing of l
// with m, which is to the left of the point iff there the one that is steeper is the higher one.
//
// Bound. The lines next to a point change only at sign changes of line_side for a line, or of line_order
// for two lines, and both at most once then.
//
// Cost for n lines and m points: a failure O(n) comparisons and at most 6 certificates; an event of the
// arrangement O(m) time, and the same for the points next to its lines; an insertion or erasure of a line
// O(n m) comparisons.
//
// Ties. Lines are raised by infinitesimals, more so the smaller the id (crossing_lists.h): a point that
// is identically on a line is below it, of two lines that identically are at the same height above the
// point the smaller id is the higher one.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7.
#ifndef KINEX_STRUCTURES_ARRANGEMENT_POINTS_IN_ARRANGEMENT_H
#define KINEX_STRUCTURES_ARRANGEMENT_POINTS_IN_ARRANGEMENT_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/arrangement/line_arrangement_2.h"
#include "structures/parts/slots.h"

namespace kinex {

// For each point of the scene the lines next to it.
class PointsInArrangement final : public Structure {
 public:
  // Ranks in event_kinds().
  enum Kind : std::uint8_t { kAbove, kBelow, kMove };

  // `lines` outlives this structure and is watched by it.
  PointsInArrangement(Kernel& kernel, StructureId id, const LineArrangement2& lines,
                      const Scene& scene);

  std::string_view name() const override { return "points_in_arrangement"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"above", "below", "move"});
  }
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_settled() override;
  void instant_over() override;
  void watched_changed(const Event* event) override;
  Attribute attribute() const override;
  Attribute told() const override;
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override;

 private:
  enum Side : std::size_t { kUp, kDown };
  // A line next to a point, and the crossings of it before and behind the point.
  struct Edge {
    ObjectId line = kNoObject, before = kNoObject, after = kNoObject;  // kNoObject: none
    friend bool operator==(const Edge&, const Edge&) = default;
  };
  struct Place {  // of a point
    std::array<Edge, 2> edges;                                 // by side
    std::array<ObjectId, 2> told{kNoObject, kNoObject};        // the lines as last reported
    std::array<std::array<CertificateId, 3>, 2> certificates;  // of line, before, after
    bool moves = false;                                        // it has to be located anew
  };

  bool is_higher(ObjectId l, ObjectId m, ObjectId p) const;  // m than l
  // The crossing of l and m is to the left of p.
  bool is_before(ObjectId l, ObjectId m, ObjectId p) const;
  Edge edge_of(ObjectId line, ObjectId p) const;
  Query side_claim(Side side, ObjectId line, ObjectId p) const;
  Query crossing_claim(ObjectId line, ObjectId m, bool before, ObjectId p) const;
  void locate(ObjectId p);  // right after now, with its proof
  void locate_all();        // nothing is to be reported
  void forget(ObjectId p);
  void move(ObjectId p);    // when the instant is settled
  bool is_next_to(ObjectId p, ObjectId line) const;
  Attribute attribute_of(bool told) const;

  Kernel* kernel_;
  StructureId id_;
  const LineArrangement2* lines_;
  PredicateId above_, under_, order_;
  Slots slots_;
  std::vector<bool> is_line_;     // by object
  std::vector<ObjectId> points_;  // those that exist, ascending
  std::vector<Place> places_;     // by object
  std::vector<ObjectId> moves_;   // to be located
  std::vector<ObjectId> moved_;   // located at this instant
};

}  // namespace kinex

#endif
