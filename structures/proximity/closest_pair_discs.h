// SPDX-License-Identifier: GPL-3.0-or-later
// ClosestPairDiscs: the pair of moving discs (in space balls) of any radii whose gap |ab| - r_a - r_b is
// smallest, while no two meet; while two meet there is none.
//
// Two discs meet iff a disc is hidden in their regular triangulation, of weights r^2, or two meet that an
// edge joins; and while all are disjoint the pair of the smallest gap is an edge, however ties are broken
// (README.md). So the structure watches the triangulation (regular_2, or regular_3 in space), and keeps
// the edge of the smallest gap.
//
//   a     b        c      g: the gap; x has equal power to a and b, and larger power to c: the
//  ( )-x-( )      ( )     triangulation has an edge between a and b
//     g
//
// Certificates. A tournament of the edges: "the gap of this edge is at most that of that one", in one of
// three cases (disc_gaps.h), two or three certificates of degrees D, 2D, 4D for motions and radii of
// degree D. And one of degree 2D: the discs of the winner are apart, or meet.
//
// Quality, for n discs: at most 9n - 20 certificates of its own in the plane, and for balls that are all
// in one plane of space; at most 3 C(n,2) - 2 otherwise in space, and where all discs are on one line,
// since the triangulation then names all pairs. Not local; a flip or a failure renews O(log n). What
// changes more than one edge (a disc that shows or hides, a new flight plan, discs that come or go, a
// degenerate instant) renews O(log n) certificates for each changed one, and looks at those that the
// triangulation has touched (seen_edges.h), in O(n) to know whether discs are hidden. All pairs are read
// where discs are on one line, and all edges of balls in one plane. Failures that change the case of a duel
// alone change no winner.
//
// Ties. Of pairs whose gaps are identically equal the lexicographically smallest one. Discs are closed:
// two that touch identically meet; those that touch at an instant do not.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7, names a weighted
// diagram. The theorems and the cases are ours.
#ifndef KINEX_STRUCTURES_PROXIMITY_CLOSEST_PAIR_DISCS_H
#define KINEX_STRUCTURES_PROXIMITY_CLOSEST_PAIR_DISCS_H

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "structures/parts/attribute_events.h"
#include "structures/parts/changing_extremum.h"
#include "structures/proximity/disc_gaps.h"
#include "structures/proximity/regular_edges.h"
#include "structures/proximity/seen_edges.h"

namespace kinex {

class ClosestPairDiscs final : public Structure {
  using Pair = DiscGaps::Value;  // two ids, ascending
  auto tied() {
    return [this](const Pair& a, const Pair& b) {
      kernel_->report(id_, kTie, {a[0], a[1], b[0], b[1]}, false);
    };
  }

 public:
  enum Kind : std::uint8_t {
    kReplace,  // another winner of a duel of two edges: the ends of the old one and of the new one
    kTie,      // the same, because the gaps have become identically equal
    kCase,     // internal: another case proves the result of a duel; the ends of the winner
    kTouch,    // internal: the discs of the winner meet from now on, or are apart
    kContact,  // external: two discs meet from now on, none did: the closest pair until now
    kApart,    // external: no two discs meet any longer: the closest pair from now on
  };

  // The triangulation of the same discs outlives this structure and is watched by it.
  ClosestPairDiscs(Kernel& kernel, StructureId id, const RegularGraph& graph);

  std::string_view name() const override { return "closest_pair_discs"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"replace", "tie", "case", "touch", "contact", "apart"});
  }
  void build(std::span<const ObjectId>) override { begin(); }
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  // Discs come and go in the structures that are watched.
  void insert(ObjectId) override { begin(); }
  void erase(ObjectId) override { begin(); }
  void motions_changed(std::span<const ObjectId> objects) override;
  // The triangulation may have changes that it has not reported yet.
  void instant_settled() override {
    if (kernel_->instant_is_shared(graph_.id())) read_edges();
  }
  void instant_over() override { tell(); }
  void watched_changed(const Event* event) override;
  Attribute attribute() const override {
    return {Attribute::Shape::kTuples, {closest().begin(), closest().end()}};
  }
  Attribute told() const override { return events_.told(); }
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  // The winner of a node only gets better, so a pair rises at most log2 of their number times; a duel has
  // three cases.
  std::uint64_t most_repairs(std::uint64_t certificates) const override {
    return 64 * certificates;
  }
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override {
    return edges_.bytes() + edges_.claims().bytes() + events_.bytes();
  }

 private:
  std::span<const ObjectId> closest() const;
  void begin();
  void read_edges();
  void catch_up();
  void changed();
  void watch_winner();
  void certify_winner();
  bool instant_is_over() const {
    return kernel_->instant_is_over(id_) && kernel_->instant_is_over(graph_.id());
  }
  void tell();

  Kernel* kernel_;
  StructureId id_;
  RegularGraph graph_;
  SeenEdges<RegularGraph> seen_;
  ChangingExtremum<DiscGaps> edges_;
  PredicateId overlap_, apart_;
  Slots contact_;
  Pair winner_{kNoObject, kNoObject};  // of the tournament, as certified
  CertificateId winner_slot_ = kNoCertificate;
  bool winner_meets_ = false;
  bool hidden_ = false;       // there are hidden discs
  bool was_of_plane_ = true;  // the edges, at all times so far
  AttributeEvents events_;
};

}  // namespace kinex

#endif
