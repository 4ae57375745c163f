// SPDX-License-Identifier: GPL-3.0-or-later
// LineArrangement2: the arrangement of moving lines y = a x + b, as the order of all lines by slope
// and, for every line, the order in which it crosses the others from left to right. Vertices, edges
// and faces are walks on these lists.
//
// Attribute (kOrders). First all lines by slope; of those with identically equal slopes the higher
// one comes first, so that this is their order far to the left, from above. Then for each line, in
// the order of the ids, the lines that are parallel to it identically, by id, itself, and the others
// as it crosses them. External events, when the instant is over, in this order and ascending:
//   triple    the triangle of three lines turned over: they met in a point
//   parallel  two lines changed their order by slope, and each went from one end of the other's
//             crossings to the other end
//   equal     two lines that are parallel identically passed through each other
//   settled   new motions made two lines parallel identically, or parallel lines cross; with both
//             attributes
// k lines that meet in a point change all their triples. Internal events: "swap", two neighbours m
// and k of the order on the first line change places; "slopes", two neighbours in the order of
// slopes; "tie", two of these that coincide identically.
//
// Certificates. n - 1 for the order of slopes (degree d), n - 2 on each line (orientation_2, degree
// 2d): n^2 - n - 1, a line in at most 3n - 2. A triple fails three, a parallel one.
//
// Bounds, for linear motion: 2 C(n,3) triples, C(n,2) parallels and equals together.
//
// Cost: build O(n^2 log n) comparisons; a triple renews 9 certificates and copies 3 lists; a parallel
// renews O(1) certificates in O(n) time; an insertion or erasure O(n log n) comparisons, O(n)
// certificates, O(n^2) time. If slopes change their order at an instant at which other claims fail,
// the lists of these lines are sorted anew.
//
// Ties. Lines are raised by infinitesimals, more so the smaller the id: crossing_lists.h. Of lines
// that coincide identically the smaller id is first among the slopes.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7.
#ifndef KINEX_STRUCTURES_ARRANGEMENT_LINE_ARRANGEMENT_2_H
#define KINEX_STRUCTURES_ARRANGEMENT_LINE_ARRANGEMENT_2_H

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/arrangement/crossing_lists.h"
#include "structures/parts/kinetic_list.h"
#include "structures/proximity/turned_order.h"

namespace kinex {

class LineArrangement2 final : public Structure {
 public:
  // Ranks in event_kinds().
  enum Kind : std::uint8_t { kTriple, kParallel, kEqual, kSwap, kSlopes, kTie };

  // `is_line`: by object, the lines that it may be built from.
  LineArrangement2(Kernel& kernel, StructureId id, const std::vector<bool>& is_line);

  std::string_view name() const override { return "line_arrangement_2"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"triple", "parallel", "equal", "swap", "slopes", "tie"});
  }
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_settled() override { crossings_.settle(); }
  void instant_over() override { tell(); }
  Attribute attribute() const override;
  Attribute told() const override;
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  std::uint64_t most_repairs(std::uint64_t certificates) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override { return crossings_.bytes(); }

  // For structures that read it.
  const CrossingLists& crossings() const { return crossings_; }
  // All lines in the order of slopes. O(n).
  std::vector<ObjectId> slopes() const { return slopes_.items(); }

 private:
  void note_slopes() {
    if (!slopes_before_) slopes_before_ = slopes_.items();
  }
  auto slope_tied() {
    return [this](Item before, Item after) { report(kTie, {before, after}); };
  }
  void report(Kind kind, std::initializer_list<ObjectId> ids);
  void repaired(Kind kind, std::initializer_list<ObjectId> ids);
  bool any_change() const { return slopes_before_ || !crossings_.before().empty(); }
  bool tell();
  void begin();

  Kernel* kernel_;
  StructureId id_;
  KineticList<TurnedOrder> slopes_;
  CrossingLists crossings_;
  std::optional<std::vector<ObjectId>> slopes_before_;  // just before the instant, if it changed
};

}  // namespace kinex

#endif
