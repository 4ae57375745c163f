// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/arrangement/line_arrangement_2.h"

#include <algorithm>
#include <string>
#include <utility>

#include "structures/arrangement/line_bounds.h"

namespace kinex {

// Lines as points (a, b): along x they are ordered by slope, and level ones by height, from above.
LineArrangement2::LineArrangement2(Kernel& kernel, StructureId id, const std::vector<bool>& is_line)
    : kernel_(&kernel),
      id_(id),
      slopes_(kernel, id, "slopes", TurnedOrder(kernel, {1, 0}), is_line.size()),
      crossings_(kernel, id, is_line) {}

void LineArrangement2::report(Kind kind, std::initializer_list<ObjectId> ids) {
  kernel_->report(id_, kind, ids, false);
}

void LineArrangement2::build(std::span<const ObjectId> objects) {
  slopes_.build({objects.begin(), objects.end()}, slope_tied());
  crossings_.build(objects);
  begin();
}

void LineArrangement2::rebuild() { build(std::vector<ObjectId>(crossings_.lines())); }

void LineArrangement2::insert(ObjectId object) {
  slopes_.insert(object, slope_tied());
  crossings_.insert(object);
  begin();
}

void LineArrangement2::erase(ObjectId object) {
  crossings_.erase(object);
  slopes_.erase(object, slope_tied());
  begin();
}

// Nothing is left to be reported.
void LineArrangement2::begin() {
  slopes_before_.reset();
  crossings_.forget();
}

void LineArrangement2::motions_changed(std::span<const ObjectId> objects) {
  note_slopes();
  slopes_.renew(objects, slope_tied());
  crossings_.motions_changed(objects);
}

void LineArrangement2::certificate_failed(CertificateId failed) {
  if (crossings_.owns(failed)) {
    const auto [line, before, after] = crossings_.failed(failed);
    return repaired(kSwap, {line, before, after});
  }
  note_slopes();
  const auto [before, after] = slopes_.failed(failed);
  // Otherwise they are parallel identically, and have changed their heights.
  if (crossings_.side(before, after) != 0) {
    crossings_.turn(before, after, kernel_->instant_is_over(id_));
  }
  slopes_.settle(slope_tied());
  repaired(kSlopes, {before, after});
}

void LineArrangement2::repaired(Kind kind, std::initializer_list<ObjectId> ids) {
  if (!crossings_.is_settled()) kernel_->settle_later(id_);
  if (kernel_->instant_is_over(id_) && tell()) return;
  report(kind, ids);
  if (any_change()) kernel_->settle_later(id_);
}

// False, with nothing reported, if nothing has changed.
bool LineArrangement2::tell() {
  if (!any_change()) return false;
  LineOrders before = crossings_.before(), after;
  if (slopes_before_) before.emplace(kNoObject, *slopes_before_);
  for (const auto& [line, row] : before) {
    after.emplace(line, line == kNoObject ? slopes_.items() : crossings_.order(line));
  }
  const bool changed = before != after;
  const auto change = crossings_.reclassified() ? std::nullopt : change_between(before, after);
  if (changed && !change) {
    kernel_->report_settled(id_, told().ids, attribute().ids);
  } else if (changed) {
    for (const auto& [a, b, c] : change->triples) kernel_->report(id_, kTriple, {a, b, c}, true);
    for (const auto& [a, b] : change->parallels) kernel_->report(id_, kParallel, {a, b}, true);
    for (const auto& [a, b] : change->equals) kernel_->report(id_, kEqual, {a, b}, true);
  }
  begin();
  return changed;
}

Attribute LineArrangement2::attribute() const {
  Attribute result{Attribute::Shape::kOrders, slopes_.items()};
  for (const ObjectId line : crossings_.lines()) {
    const std::vector<ObjectId>& row = crossings_.order(line);
    result.ids.insert(result.ids.end(), row.begin(), row.end());
  }
  return result;
}

Attribute LineArrangement2::told() const {
  Attribute result{Attribute::Shape::kOrders, slopes_before_.value_or(slopes_.items())};
  for (const ObjectId line : crossings_.lines()) {
    const auto was = crossings_.before().find(line);
    const bool is_noted = was != crossings_.before().end();
    const std::vector<ObjectId>& row = is_noted ? was->second : crossings_.order(line);
    result.ids.insert(result.ids.end(), row.begin(), row.end());
  }
  return result;
}

void LineArrangement2::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "neighbours by slope";
  slopes_.each_link([&](Item before, Item after, CertificateId certificate) {
    group.about = {before, after};
    visitor.group(group);
    visitor.certificate(certificate, "order");
  });
  crossings_.visit_proof(visitor);
}

// Of n lines that meet in a point each exchanges all pairs of the others.
std::uint64_t LineArrangement2::most_repairs(std::uint64_t certificates) const {
  return certificates * crossings_.lines().size();
}

std::vector<BoundCheck> LineArrangement2::bounds(const BoundContext& context) const {
  const Integer n = counted(context.objects());
  const auto count = [&context](const char* kind) {
    const auto found = context.ledger->by_kind.find(kind);
    return counted(found == context.ledger->by_kind.end() ? 0 : found->second);
  };
  return {at_most("line_arrangement_2.certificates", "n - 1 for the slopes, n - 2 on each line",
                  std::max(Integer(0), n * n - n - Integer(1)), counted(context.ledger->max_live)),
          at_most("line_arrangement_2.locality",
                  "two among the slopes, n - 2 on the line itself, two on each other line",
                  std::max(Integer(0), Integer(3) * n - Integer(2)),
                  counted(context.ledger->max_per_object)),
          at_most("line_arrangement_2.triples",
                  "a triangle turns over only at a root of its orientation, and where pieces meet",
                  triple_sign_changes(context.pieces, 2 * context.degree), count("triple")),
          at_most("line_arrangement_2.parallels",
                  "slopes, or the heights of parallels, change their order only where they are "
                  "equal, and where pieces meet",
                  pair_sign_changes(context.pieces, context.degree),
                  count("parallel") + count("equal"))};
}

void LineArrangement2::check_invariants(AuditReport& report) const {
  slopes_.check(report, "the order of slopes");
  crossings_.check(report);
  report.check(!any_change(), [] { return "a change of the orders was not reported"; });
  std::vector<ObjectId> lines = slopes_.items();
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    report.check(crossings_.side(lines[i], lines[i + 1]) >= 0,
                 [] { return "the lists of crossings are for another order of slopes"; });
  }
  std::sort(lines.begin(), lines.end());
  report.check(lines == crossings_.lines(), [] { return "other lines cross than have slopes"; });
}

}  // namespace kinex
