// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/arrangement/line_arrangement_2.h"

#include <algorithm>
#include <utility>

#include "structures/arrangement/line_bounds.h"
#include "structures/parts/binomial.h"

namespace kinex {

LineArrangement2::LineArrangement2(Kernel& kernel, StructureId id, const Scene& scene)
    : kernel_(&kernel),
      id_(id),
      slopes_(kernel, id, "slopes", KeyOrder(kernel, Key{}, scene), scene.objects.size()),
      crossings_(kernel, id, scene.objects.size()) {}

void LineArrangement2::build(std::span<const ObjectId> objects) {
  crossings_.clear();
  slopes_.build({objects.begin(), objects.end()}, slope_tied());
  for (const ObjectId object : objects) crossings_.insert(object);
  settle_ties();
  before_.clear();
}

void LineArrangement2::rebuild() { build(std::vector<ObjectId>(crossings_.lines())); }

void LineArrangement2::report(Kind kind, std::initializer_list<ObjectId> ids) {
  kernel_->report(id_, kind, ids, false);
}

void LineArrangement2::settle_ties() {
  crossings_.settle_ties(noting(), [this](const CrossingLists::Swap& swap) {
    report(kTie, {swap.line, swap.before, swap.after});
  });
}

void LineArrangement2::certificate_failed(CertificateId failed) {
  if (!crossings_.owns(failed)) return slopes_failed(failed);
  note(crossings_.line_of(failed));
  const CrossingLists::Swap swap = crossings_.failed(failed);
  repaired(kSwap, {swap.line, swap.before, swap.after});
}

void LineArrangement2::slopes_failed(CertificateId failed) {
  note(kSlopeRow);
  const auto [before, after] = slopes_.failed(failed);
  note(before);
  note(after);
  const bool alone = !kernel_->instant_is_shared(id_) && !crossings_.any_ties();
  if (alone && crossings_.side(before, after) != -1) {
    crossings_.pass_at_infinity(before, after);
  } else {
    crossings_.turn(before, after, noting());
  }
  slopes_.settle(slope_tied());
  repaired(kSlopes, {before, after});
}

void LineArrangement2::insert(ObjectId object) {
  slopes_.insert(object, slope_tied());
  crossings_.insert(object);
  settle_ties();
  before_.clear();
}

void LineArrangement2::erase(ObjectId object) {
  crossings_.erase(object);
  slopes_.erase(object, slope_tied());
  settle_ties();
  before_.clear();
}

void LineArrangement2::motions_changed(std::span<const ObjectId> objects) {
  const std::vector<ObjectId> slopes_before = slopes_.items();
  slopes_.motions_changed(objects, slope_tied());
  if (slopes_.items() != slopes_before) before_.emplace(kSlopeRow, slopes_before);
  crossings_.motions_changed(objects, noting());
  settle_ties();
  if (crossings_.any_loose() || !before_.empty()) kernel_->settle_later(id_);
}

void LineArrangement2::instant_settled() {
  crossings_.settle();
  settle_ties();
}

void LineArrangement2::repaired(Kind kind, std::initializer_list<ObjectId> ids) {
  settle_ties();
  const bool over_now = !kernel_->instant_is_shared(id_) && !kernel_->failure_is_due() &&
                        !crossings_.any_loose();
  if (over_now && tell(true)) return;
  report(kind, ids);
  if (!before_.empty()) kernel_->settle_later(id_);
}

void LineArrangement2::instant_over() { tell(false); }

Attribute LineArrangement2::orders(const Rows& instead) const {
  const auto row_of = [&](ObjectId line) {
    const auto there = instead.find(line);
    return there == instead.end() ? row(line) : there->second;
  };
  Attribute result{Attribute::Shape::kOrders, row_of(kSlopeRow)};
  for (const ObjectId line : crossings_.lines()) {
    result.ids.push_back(line);
    const std::vector<ObjectId> others = row_of(line);
    result.ids.insert(result.ids.end(), others.begin(), others.end());
  }
  return result;
}

namespace {

// True if two neighbours have changed places, which are then these.
bool is_exchange(const std::vector<ObjectId>& before, const std::vector<ObjectId>& after,
                 ObjectId& a, ObjectId& b) {
  const auto [x, y] = std::mismatch(before.begin(), before.end(), after.begin(), after.end());
  if (x == before.end() || x + 1 == before.end() || *x != *(y + 1) || *(x + 1) != *y) return false;
  a = std::min(*x, *y);
  b = std::max(*x, *y);
  return std::equal(x + 2, before.end(), y + 2);
}

// True if m has gone from one end to the other one.
bool is_passage(std::vector<ObjectId> before, const std::vector<ObjectId>& after, ObjectId m) {
  if (before.front() == m) {
    std::rotate(before.begin(), before.begin() + 1, before.end());
  } else if (before.back() == m) {
    std::rotate(before.begin(), before.end() - 1, before.end());
  }
  return before == after && after.size() > 0 && (after.front() == m || after.back() == m);
}

}  // namespace

std::optional<LineArrangement2::Change> LineArrangement2::simple_change(const Rows& changed) const {
  const auto slopes = changed.find(kSlopeRow);
  ObjectId a = kNoObject, b = kNoObject;
  if (slopes != changed.end()) {
    if (!is_exchange(slopes->second, row(kSlopeRow), a, b)) return std::nullopt;
    const std::size_t others = crossings_.lines().size() > 2 ? 2 : 0;  // one is at both ends
    if (changed.size() != others + 1) return std::nullopt;
    for (const auto& [line, before] : changed) {
      if (line == kSlopeRow) continue;
      if (line != a && line != b) return std::nullopt;
      if (!is_passage(before, row(line), line == a ? b : a)) return std::nullopt;
    }
    return Change{kParallel, {a, b, kNoObject}};
  }
  if (changed.size() != 3) return std::nullopt;
  std::array<ObjectId, 3> ids;
  std::transform(changed.begin(), changed.end(), ids.begin(), [](const auto& one) { return one.first; });
  for (std::size_t i = 0; i < 3; ++i) {
    if (!is_exchange(changed.at(ids[i]), row(ids[i]), a, b)) return std::nullopt;
    if (a != ids[i == 0 ? 1 : 0] || b != ids[i == 2 ? 1 : 2]) return std::nullopt;
  }
  return Change{kTriple, ids};
}

// False, with nothing reported, if nothing has changed, or nothing simple.
bool LineArrangement2::tell(bool only_simple) {
  Rows changed;
  for (const auto& [line, before] : before_) {
    if (before != row(line)) changed.emplace(line, before);
  }
  const std::optional<Change> change = changed.empty() ? std::nullopt : simple_change(changed);
  if (only_simple && !change) return false;
  if (change && change->kind == kTriple) {
    kernel_->report(id_, kTriple, {change->ids[0], change->ids[1], change->ids[2]}, true);
  } else if (change) {
    kernel_->report(id_, kParallel, {change->ids[0], change->ids[1]}, true);
  } else if (!changed.empty()) {
    const Attribute was = told();
    kernel_->report_settled(id_, was.ids, attribute().ids);
  }
  before_.clear();
  return !changed.empty();
}

void LineArrangement2::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "neighbours by slope";
  slopes_.each_link([&](Item before, Item after, CertificateId certificate) {
    group.about = {before, after};
    visitor.group(group);
    if (certificate != kNoCertificate) visitor.certificate(certificate, "order");
  });
  crossings_.visit_proof(visitor);
}

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
                  Integer(3) * n, counted(context.ledger->max_per_object)),
          at_most("line_arrangement_2.parallels",
                  "slopes change their order only where they are equal, and where pieces meet",
                  pair_sign_changes(context.pieces, context.degree), count("parallel")),
          at_most("line_arrangement_2.triples",
                  "three lines change their orientation only at its roots, and where pieces meet",
                  triple_sign_changes(context.pieces, 2 * context.degree), count("triple"))};
}

void LineArrangement2::check_invariants(AuditReport& report) const {
  slopes_.check(report, "the order of slopes");
  crossings_.check(report);
  report.check(before_.empty(), [] { return "a change of the orders was not reported"; });
  std::vector<ObjectId> lines = slopes_.items();
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    const int side = crossings_.side(lines[i], lines[i + 1]);
    report.check(side > 0 || (side == 0 && lines[i] < lines[i + 1]),
                 [] { return "the crossings have other slopes"; });
  }
  std::sort(lines.begin(), lines.end());
  report.check(lines == crossings_.lines(), [] { return "other lines cross than have slopes"; });
}

}  // namespace kinex
