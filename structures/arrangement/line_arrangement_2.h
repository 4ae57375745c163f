// SPDX-License-Identifier: GPL-3.0-or-later
// line_arrangement_2: the arrangement of moving lines y = a x + b, as the order of all lines by slope
// and, for every line, the order in which it crosses the others from left to right.
//
// Attribute (kOrders). The lines by slope, then for each line, in the order of the ids, itself and the
// others as it crosses them. External events:
//   triple    three lines meet in a point: on each of them the other two change places
//   parallel  two lines become parallel: they change places among the slopes, and each goes from one
//             end of the other's order to the other end
//   settled   an instant changes the orders in another way: several of these at once, or lines that
//             have been parallel; with both attributes
// All are reported when the instant is over. Internal events: "swap", two neighbours l, m of the order
// on the first line change places; "slopes", two neighbours in the order of slopes; "tie".
//
// Certificates. n - 1 for the order of slopes (degree d), n - 2 on each line (orientation_2, degree
// 2d): n^2 - n - 1, a line in at most 3n. A triple fails three, a parallel one.
//
// Bounds, for linear motion: 2 C(n,3) triples, C(n,2) parallels.
//
// Cost: build O(n^2 log n) comparisons; a triple renews 9 certificates; a parallel O(1), and O(n) time
// to move two lines in arrays and to look for ties; an insertion or erasure O(n log n) comparisons,
// O(n) certificates, O(n^2) time. At an instant at which slopes change beside other failures the
// orders on these lines are sorted anew.
//
// Ties: crossing_lists.h. Of lines with identically equal slopes the smaller id is first among the
// slopes.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7.
#ifndef KINEX_STRUCTURES_ARRANGEMENT_LINE_ARRANGEMENT_2_H
#define KINEX_STRUCTURES_ARRANGEMENT_LINE_ARRANGEMENT_2_H

#include <array>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/arrangement/crossing_lists.h"
#include "structures/parts/key_order.h"
#include "structures/parts/kinetic_list.h"

namespace kinex {

class LineArrangement2 final : public Structure {
 public:
  // Ranks in event_kinds().
  enum Kind : std::uint8_t { kTriple, kParallel, kSwap, kSlopes, kTie };

  LineArrangement2(Kernel& kernel, StructureId id, const Scene& scene);

  std::string_view name() const override { return "line_arrangement_2"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"triple", "parallel", "swap", "slopes", "tie"});
  }
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_settled() override;
  void instant_over() override;
  Attribute attribute() const override { return orders({}); }
  Attribute told() const override { return orders(before_); }
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  std::uint64_t most_repairs(std::uint64_t certificates) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override { return slopes_.bytes() + crossings_.bytes(); }

 private:
  static constexpr ObjectId kSlopeRow = kNoObject;
  // Orders as they were just before the instant: of lines, and that of the slopes.
  using Rows = std::map<ObjectId, std::vector<ObjectId>>;

  Attribute orders(const Rows& instead) const;
  std::vector<ObjectId> row(ObjectId line) const {
    return line == kSlopeRow ? slopes_.items() : crossings_.order(line);
  }
  // The order on the line, or of the slopes, is about to change.
  void note(ObjectId line) {
    if (!before_.contains(line)) before_.emplace(line, row(line));
  }
  auto noting() {
    return [this](ObjectId line) { note(line); };
  }
  auto slope_tied() {
    return [this](Item before, Item after) { report(kTie, {before, after}); };
  }
  void report(Kind kind, std::initializer_list<ObjectId> ids);
  void slopes_failed(CertificateId failed);
  void settle_ties();
  void repaired(Kind kind, std::initializer_list<ObjectId> ids);
  struct Change {
    Kind kind;
    std::array<ObjectId, 3> ids;
  };
  std::optional<Change> simple_change(const Rows& changed) const;
  bool tell(bool only_simple);

  Kernel* kernel_;
  StructureId id_;
  KineticList<KeyOrder> slopes_;
  CrossingLists crossings_;
  Rows before_;
};

}  // namespace kinex

#endif
