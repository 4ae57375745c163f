// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/range/range_structure.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "predicates/predicates.h"

namespace kinex {

RangeStructure::RangeStructure(Kernel& kernel, StructureId id, const SortedList& x,
                               const SortedList& y)
    : kernel_(&kernel),
      id_(id),
      lists_{&x, &y},
      labels_{AxisLabels(x.objects()), AxisLabels(y.objects())},
      orders_{kernel.bind(make_coordinate_order(0)), kernel.bind(make_coordinate_order(1))} {}

namespace {

std::vector<ObjectId> objects_of(const SortedList& list) { return list.attribute().ids; }

}  // namespace

void RangeStructure::make_anew() {
  unsigned bits = 0;
  for (const SortedList* list : lists_) bits = std::max(bits, AxisLabels::bits_for(list->size()));
  // Room for insertions once there was one: two labels an object.
  if (labels_[0].bits() > bits) ++bits;
  for (const int axis : {0, 1}) labels_of(axis).assign(objects_of(list(axis)), bits);
  make_tree();
}

void RangeStructure::build(std::span<const ObjectId>) {
  make_anew();
  begin();
}

// The lists have inserted it already.
void RangeStructure::insert(ObjectId object) {
  expected_notices_ += 2;
  std::array<std::optional<std::vector<AxisLabels::Move>>, 2> moves;
  bool fits = true;
  for (const int axis : {0, 1}) {
    const ObjectId previous = list(axis).previous(object), next = list(axis).next(object);
    const auto rank = [&](ObjectId o) { return labels(axis).rank(o); };
    // In an inexact arithmetic the list may have put ties in order, too.
    fits = fits && (previous == kNoObject || labels(axis).has(previous)) &&
           (next == kNoObject || labels(axis).has(next)) &&
           (previous == kNoObject ? 0 : rank(previous) + 1) ==
               (next == kNoObject ? labels(axis).count() : rank(next));
    if (!fits) break;
    moves[static_cast<std::size_t>(axis)] = labels(axis).room_between(previous, object, next);
    fits = moves[static_cast<std::size_t>(axis)].has_value();
  }
  if (!fits) {
    const unsigned bits =
        std::max(labels_[0].bits(), AxisLabels::bits_for(labels_[0].count() + 1)) + 1;
    for (const int axis : {0, 1}) labels_of(axis).assign(objects_of(list(axis)), bits);
    make_tree();
    return begin();
  }
  std::vector<ObjectId> moved;
  for (const auto& axis_moves : moves) {
    for (const AxisLabels::Move& move : *axis_moves) {
      if (move.object != object) moved.push_back(move.object);
    }
  }
  std::sort(moved.begin(), moved.end());
  moved.erase(std::unique(moved.begin(), moved.end()), moved.end());
  for (const ObjectId other : moved) take_out(other);
  for (const int axis : {0, 1}) labels_of(axis).apply(*moves[static_cast<std::size_t>(axis)]);
  for (const ObjectId other : moved) put_in(other);
  put_in(object);
  begin();
}

void RangeStructure::erase(ObjectId object) {
  expected_notices_ += 2;
  constexpr std::size_t kSparse = 8;  // labels an object, before they are made fewer
  if (kSparse * labels_[0].count() < labels_[0].size()) {
    const unsigned bits = AxisLabels::bits_for(2 * list(0).size());
    for (const int axis : {0, 1}) labels_of(axis).assign(objects_of(list(axis)), bits);
    make_tree();
  } else {
    take_out(object);
    for (const int axis : {0, 1}) labels_of(axis).erase(object);
  }
  begin();
}

bool RangeStructure::is_in_step() const {
  return labels_[0].in_order() == objects_of(list(0)) &&
         labels_[1].in_order() == objects_of(list(1));
}

void RangeStructure::watched_changed(const Event* event) {
  if (event == nullptr) {
    if (expected_notices_ > 0) {
      --expected_notices_;
    } else if (!is_in_step()) {
      follow_rebuild();
    }
    return;
  }
  const int axis = event->structure == list(0).id() ? 0 : 1;
  const ObjectId before = event->ids[0], after = event->ids[1];
  const bool is_swap = event->kind == SortedList::kSwap || event->kind == SortedList::kTie;
  if (is_swap && labels(axis).are_neighbours(before, after)) {
    touched_.note(exchange(axis, before, after), most_touched());
    swapped(axis, before, after);
  } else if (!is_in_step()) {
    follow_rebuild();
  }
}

// Where the points before the corner, and those that are level with it if it is not the low one,
// end.
AxisLabels::Cut RangeStructure::cut(int axis, ObjectId corner, bool is_low,
                                    QueryCounts& counts) const {
  const PredicateId order = orders_[static_cast<std::size_t>(axis)];
  return labels(axis).cut([&](ObjectId object) {
    ++counts.signs;
    const Sign sign = kernel_->sign_after(order, {object, corner});
    return sign == Sign::kPositive || (sign == Sign::kZero && !is_low);
  });
}

// The box in labels, as large as its points allow; nullopt: it holds no point.
std::optional<LabelBox> RangeStructure::labelled(ObjectId low, ObjectId high,
                                                 QueryCounts& counts) const {
  LabelBox box;
  for (const int axis : {0, 1}) {
    const AxisLabels::Cut before = cut(axis, low, true, counts);
    const AxisLabels::Cut up_to = cut(axis, high, false, counts);
    if (before.count >= up_to.count) return std::nullopt;
    const auto a = static_cast<std::size_t>(axis);
    box.low[a] = static_cast<AxisLabels::Label>(before.first);
    box.high[a] = static_cast<AxisLabels::Label>(up_to.end - 1);
  }
  return box;
}

void RangeStructure::report(ObjectId low, ObjectId high, std::vector<ObjectId>& out,
                            QueryCounts& counts) {
  const std::optional<LabelBox> box = labelled(low, high, counts);
  if (!box) return;
  const std::size_t reported = out.size();
  const Cost cost = search(*box, out, nullptr);
  counts.nodes += cost.nodes;
  looked_at_.note(cost.bounded, most_looked_at(out.size() - reported));
}

void RangeStructure::trace(ObjectId low, ObjectId high, std::vector<ObjectId>& out,
                           QueryTrace& nodes) {
  QueryCounts counts;
  if (const std::optional<LabelBox> box = labelled(low, high, counts)) search(*box, out, &nodes);
}

std::vector<BoundCheck> RangeStructure::bounds(const BoundContext& context) const {
  const std::string own(name());
  std::vector<BoundCheck> result{
      at_most(own + ".certificates", "it reads those of the lists", Integer(0),
              counted(context.ledger->max_live)),
      at_most(own + ".swaps", "every pair changes places at each sign change on either axis",
              Integer(2) * pair_sign_changes(context.pieces, context.degree),
              counted(context.ledger->external))};
  if (touched_.seen) {
    result.push_back(at_most(own + ".touched", "nodes that a swap touches", counted(touched_.bound),
                             counted(touched_.observed)));
  }
  if (looked_at_.seen) {
    result.push_back(at_most(own + ".looked_at", "nodes that a query looks at",
                             counted(looked_at_.bound), counted(looked_at_.observed)));
  }
  return result;
}

void RangeStructure::check_invariants(AuditReport& report) const {
  report.check(labels_[0].consistent() && labels_[1].consistent(),
               [] { return "labels and objects disagree"; });
  report.check(is_in_step(), [] { return "the labels are not in the order of the lists"; });
  report.check(labels_[0].bits() == labels_[1].bits(),
               [] { return "one axis has more labels than the other"; });
  report.check(expected_notices_ == 0, [] { return "a notice of a list has not come"; });
  report.check(touched_.observed <= touched_.bound, [] { return "a swap touched too many nodes"; });
  report.check(looked_at_.observed <= looked_at_.bound,
               [] { return "a query looked at too many nodes"; });
  check_tree(report);
}

}  // namespace kinex
