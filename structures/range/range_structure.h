// SPDX-License-Identifier: GPL-3.0-or-later
// RangeStructure: what the trees for range search in the plane share: the labels of two sorted
// lists, the notices of these lists, and the search for the corners of a box.
//
//   sorted_list x   sorted_list y      certificates, signs
//         |               |
//     AxisLabels      AxisLabels       integers from here on
//         +-------+-------+
//               a tree
//
// A swap in a list is an exchange of two neighbours' labels. The order of the points on both axes
// determines all answers, so the trees have no certificates of their own.
//
// Cost of a query: at most 4 (log2 N + 1) signs for the four sides of the box, and the nodes that
// the tree looks at.
#ifndef KINEX_STRUCTURES_RANGE_RANGE_STRUCTURE_H
#define KINEX_STRUCTURES_RANGE_RANGE_STRUCTURE_H

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/engine/audit.h"
#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "structures/order/sorted_list.h"
#include "structures/parts/axis_labels.h"
#include "structures/parts/query_trace.h"
#include "structures/parts/range_search.h"
#include "structures/range/worst_case.h"

namespace kinex {

// The labels in a box: low[a] <= label <= high[a] on both axes.
struct LabelBox {
  std::array<AxisLabels::Label, 2> low, high;

  bool holds(int axis, AxisLabels::Label label) const {
    const auto a = static_cast<std::size_t>(axis);
    return low[a] <= label && label <= high[a];
  }
};

class RangeStructure : public Structure, public RangeSearch, public TracedSearch {
 public:
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override { make_anew(); }
  void certificate_failed(CertificateId) override {}  // it has none
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void watched_changed(const Event* event) override;
  void report(ObjectId low, ObjectId high, std::vector<ObjectId>& out,
              QueryCounts& counts) override;
  void trace(ObjectId low, ObjectId high, std::vector<ObjectId>& out, QueryTrace& nodes) override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  // Both orders against exact positions, and answers to some boxes against CGAL's.
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override { return labels_[0].bytes() + labels_[1].bytes(); }

  const AxisLabels& labels(int axis) const { return labels_[static_cast<std::size_t>(axis)]; }

 protected:
  // The cost of a search. `bounded` is the part with a hard bound.
  struct Cost {
    std::uint64_t nodes = 0, bounded = 0;
  };

  // `x` and `y` are lists of the same objects by these coordinates; they outlive this structure and
  // are watched by it.
  RangeStructure(Kernel& kernel, StructureId id, const SortedList& x, const SortedList& y);

  // ---- the tree over the labels
  // Builds it for all objects that have labels.
  virtual void make_tree() = 0;
  virtual void put_in(ObjectId object) = 0;
  virtual void take_out(ObjectId object) = 0;
  // `before` and `after` are neighbours in the order of their labels on this axis and exchange
  // these: calls labels_[axis].exchange. Returns the number of nodes touched.
  virtual std::uint64_t exchange(int axis, ObjectId before, ObjectId after) = 0;
  virtual std::uint64_t most_touched() const = 0;  // by an exchange
  // Appends the points in a box of labels, and to `trace`, if there is one, the nodes.
  virtual Cost search(const LabelBox& box, std::vector<ObjectId>& out, QueryTrace* trace) const = 0;
  // The hard bound of Cost::bounded for k points reported.
  virtual std::uint64_t most_looked_at(std::uint64_t k) const = 0;
  virtual void check_tree(AuditReport& report) const = 0;
  // ---- the attribute
  // A swap in a list has been followed.
  virtual void swapped(int axis, ObjectId before, ObjectId after) = 0;
  // The orders have changed otherwise: calls make_anew(), and sees to it that the change is
  // reported.
  virtual void follow_rebuild() = 0;
  // The attribute has changed with an object that came or went.
  virtual void begin() {}

  // Labels and tree from the two lists.
  void make_anew();
  AxisLabels& labels_of(int axis) { return labels_[static_cast<std::size_t>(axis)]; }
  AxisLabels::Label label(int axis, ObjectId object) const { return labels(axis).of(object); }

  Kernel* kernel_;
  StructureId id_;

 private:
  const SortedList& list(int axis) const { return *lists_[static_cast<std::size_t>(axis)]; }
  bool is_in_step() const;
  std::optional<LabelBox> labelled(ObjectId low, ObjectId high, QueryCounts& counts) const;
  AxisLabels::Cut cut(int axis, ObjectId corner, bool is_low, QueryCounts& counts) const;
  void audit_box(const Snapshot& snapshot, const ExactBox& box, AuditReport& report) const;

  std::array<const SortedList*, 2> lists_;
  std::array<AxisLabels, 2> labels_;
  std::array<PredicateId, 2> orders_;
  int expected_notices_ = 0;  // of the lists, of an insertion or erasure that has been followed
  WorstCase touched_, looked_at_;
};

}  // namespace kinex

#endif
