// SPDX-License-Identifier: GPL-3.0-or-later
// CaliperExtremum: diameter_2, width_2, min_area_rectangle_2 and min_perimeter_rectangle_2: the
// best candidate of rotating calipers around a convex hull.
//
// Certificates. It watches a hull (HullSource). Calipers (calipers.h) prove which vertices are
// opposite to every edge: degree 2d for motions of degree d. A ChangingExtremum of the candidates
// of all edges (caliper_candidates.h) proves which one is the best: degree 2d for the diameter,
// otherwise 6d. It has calipers of its own, or watches those that it shares with other structures
// over the same hull (calipers_2); these may have more folds than it needs.
//
//   hull        enter, leave          a vertex between its neighbours: one edge becomes two, or
//                                     two become one
//   calipers    two edges change      the contacts of both edges change, so do their candidates:
//               places                one pair of the diameter, both strips, both rectangles
//   extremum    a duel                another winner
//
// Quality, for h hull vertices: at most h certificates of its own calipers, and h - 1 of the
// candidates. The calipers are local; the candidates are not, for a vertex is the contact of up to
// h - 1 edges. A failure renews O(log h). An insertion, an erasure, or an instant with several changes
// of the hull builds the calipers anew, O(h log h), and renews O(log h) for each candidate that
// changes. O(n^(2 + eps)) events for algebraic motions. The attribute can change Omega(n^2) times
// (Agarwal et al.). One external event for each
// instant that changes it.
//
// Ties. Of pairs at identically equal distances the lexicographically smallest; of strips and
// rectangles of identically equal width, area or perimeter that with the smallest tail of its edge.
// Of the two ends of an edge that is identically tangent the smaller one is the contact.
//
// Attribute. The diameter: two ids. Width: the edge a, b and its antipode c. Rectangles: the edge
// a, b and the contacts r (in the direction of the edge), c (opposite), l (against the direction).
// With fewer than two points it is empty; width and rectangles also where all points are
// identically on one line. Of points that are all identically equal the two smallest ids are the
// diameter.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 6.7;
// Agarwal, Guibas, Hershberger, Veach, "Maintaining the extent of a moving point set" (2001);
// Freeman and Shapira, "Determining the minimum-area encasing rectangle for an arbitrary closed
// curve" (1975).
#ifndef KINEX_STRUCTURES_EXTENT_CALIPER_EXTREMUM_H
#define KINEX_STRUCTURES_EXTENT_CALIPER_EXTREMUM_H

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "structures/extent/caliper_candidates.h"
#include "structures/extent/calipers_2.h"
#include "structures/extent/hull_calipers.h"
#include "structures/hull/hull_source.h"
#include "structures/parts/attribute_events.h"
#include "structures/parts/changing_extremum.h"

namespace kinex {

class CaliperExtremum final : public Structure {
  using Value = CaliperCandidates::Value;
  auto tied() {
    return [this](const Value& a, const Value& b) {
      kernel_->report(id_, kTie, {a[0], a[1], b[0], b[1]}, false);
    };
  }

 public:
  // Those of HullCalipers, of its own calipers: two edges, each by its ends; a vertex that came or
  // went between two others; the calipers were built anew. kReplace: another winner of a duel: the
  // first two ids of the old one and of the new one. kTie: the same, because the two have become
  // identically equal.
  enum Kind : std::uint8_t { kReplace = HullCalipers::kRenew + 1, kTie };

  // `hull` outlives this structure and is watched by it; it is the structure `hull_id`. So are the
  // calipers over it that are shared, if any; their folds are a multiple of folds_of(measure).
  CaliperExtremum(Kernel& kernel, StructureId id, std::string_view name, CaliperMeasure measure,
                  const HullSource& hull, StructureId hull_id, const Calipers2* shared = nullptr);

  std::string_view name() const override { return name_; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds(
        {"antiparallel", "perpendicular", "split", "merge", "renew", "replace", "tie"});
  }
  void build(std::span<const ObjectId> objects) override {
    members_ = {objects.begin(), objects.end()};
    begin();
  }
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override {
    members_.insert(object);
    begin();
  }
  void erase(ObjectId object) override {
    members_.erase(object);
    begin();
  }
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_settled() override;
  void instant_over() override { events_.over(best()); }
  void watched_changed(const Event* event) override;
  Attribute attribute() const override { return {events_.told().shape, best()}; }
  Attribute told() const override { return events_.told(); }
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override;

  // Calipers of its own, or those that it shares.
  const Calipers& calipers() const { return shared_ ? shared_->calipers() : own_->calipers(); }

 private:
  std::vector<ObjectId> best() const;
  void begin();
  void follow();
  void follow(std::span<const ObjectId> edges);
  bool is_up_to_date() const { return followed_ == calipers().changes_end(); }
  bool is_settling() const;
  void report_repair(std::uint8_t kind, std::initializer_list<ObjectId> ids);
  // ---- caliper_extremum_audit.cpp: among the points of the snapshot
  void audit_best(const Snapshot& snapshot, AuditReport& report) const;
  void audit_diameter(const Snapshot& snapshot, AuditReport& report) const;
  void audit_strip(const Snapshot& snapshot, AuditReport& report) const;
  void audit_rectangle(const Snapshot& snapshot, AuditReport& report) const;

  Kernel* kernel_;
  StructureId id_, hull_id_;
  std::string_view name_;
  CaliperMeasure measure_;
  const HullSource* hull_;
  std::optional<HullCalipers> own_;
  const Calipers2* shared_;
  std::uint64_t followed_ = 0;  // changes of the calipers before this one
  ChangingExtremum<CaliperCandidates> candidates_;
  std::set<ObjectId> members_;   // all points
  std::vector<Value> value_of_;  // by tail: its candidate; unused: kNoObject
  AttributeEvents events_;
};

}  // namespace kinex

#endif
