// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/arrangement/points_in_arrangement.h"

#include <algorithm>
#include <string>
#include <utility>

#include "predicates/points/line_predicates.h"
#include "structures/arrangement/line_bounds.h"
#include "structures/parts/sort_unique.h"

namespace kinex {

PointsInArrangement::PointsInArrangement(Kernel& kernel, StructureId id,
                                         const LineArrangement2& lines, const Scene& scene)
    : kernel_(&kernel),
      id_(id),
      lines_(&lines),
      above_(kernel.bind(make_line_side())),
      under_(kernel.bind(make_line_under())),
      order_(kernel.bind(make_line_order())),
      slots_(kernel, id, "places"),
      is_line_(lines_of(scene)),
      places_(scene.objects.size()) {
  for (Place& place : places_) {
    for (auto& certificates : place.certificates) certificates.fill(kNoCertificate);
  }
}

// ---- where a point is

bool PointsInArrangement::is_higher(ObjectId l, ObjectId m, ObjectId p) const {
  const Sign sign = kernel_->sign_after({order_, {l, m, p}});
  return sign == Sign::kPositive || (sign == Sign::kZero && m < l);
}

bool PointsInArrangement::is_before(ObjectId l, ObjectId m, ObjectId p) const {
  return is_higher(l, m, p) == (lines_->crossings().side(l, m) > 0);
}

PointsInArrangement::Edge PointsInArrangement::edge_of(ObjectId line, ObjectId p) const {
  const std::vector<ObjectId>& row = lines_->crossings().order(line);
  const std::size_t first = lines_->crossings().place(line, line) + 1;
  std::size_t low = first, high = row.size();
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (is_before(line, row[middle], p)) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return {line, low > first ? row[low - 1] : kNoObject, low < row.size() ? row[low] : kNoObject};
}

Query PointsInArrangement::side_claim(Side side, ObjectId line, ObjectId p) const {
  return {side == kUp ? under_ : above_, {line, p}};
}

Query PointsInArrangement::crossing_claim(ObjectId line, ObjectId m, bool before,
                                          ObjectId p) const {
  const bool higher = before == (lines_->crossings().side(line, m) > 0);
  return higher ? Query(order_, {line, m, p}) : Query(order_, {m, line, p});
}

void PointsInArrangement::locate(ObjectId p) {
  std::array<ObjectId, 2> next{kNoObject, kNoObject};
  for (const ObjectId l : lines_->crossings().lines()) {
    const bool is_below = kernel_->sign_after({above_, {l, p}}) == Sign::kPositive;
    ObjectId& best = next[is_below ? kDown : kUp];
    if (best == kNoObject || is_higher(best, l, p) == is_below) best = l;
  }
  Place& place = places_[p];
  place.moves = false;
  for (const Side side : {kUp, kDown}) {
    const Edge edge = next[side] == kNoObject ? Edge{} : edge_of(next[side], p);
    place.edges[side] = edge;
    auto& [own, before, after] = place.certificates[side];
    const auto prove = [&](CertificateId& slot, bool needed, const auto& claim) {
      if (needed) {
        slots_.renew(slot, claim(), p);
      } else {
        slots_.drop(slot);
      }
    };
    prove(own, edge.line != kNoObject, [&] { return side_claim(side, edge.line, p); });
    prove(before, edge.before != kNoObject,
          [&] { return crossing_claim(edge.line, edge.before, true, p); });
    prove(after, edge.after != kNoObject,
          [&] { return crossing_claim(edge.line, edge.after, false, p); });
  }
}

void PointsInArrangement::locate_all() {
  for (const ObjectId p : points_) {
    locate(p);
    for (const Side side : {kUp, kDown}) places_[p].told[side] = places_[p].edges[side].line;
  }
  moves_.clear();
  moved_.clear();
}

void PointsInArrangement::forget(ObjectId p) {
  for (auto& certificates : places_[p].certificates) {
    for (CertificateId& slot : certificates) slots_.drop(slot);
  }
  places_[p].edges = {};
  places_[p].moves = false;
  std::erase(moves_, p);
  std::erase(moved_, p);
}

// ---- calls

void PointsInArrangement::build(std::span<const ObjectId> objects) {
  for (const ObjectId p : points_) forget(p);
  points_.clear();
  for (const ObjectId object : objects) {
    if (!is_line_[object]) points_.push_back(object);
  }
  locate_all();
}

void PointsInArrangement::rebuild() { build(std::vector<ObjectId>(points_)); }

void PointsInArrangement::insert(ObjectId object) {
  if (is_line_[object]) return locate_all();
  points_.insert(std::lower_bound(points_.begin(), points_.end(), object), object);
  locate(object);
  for (const Side side : {kUp, kDown}) {
    places_[object].told[side] = places_[object].edges[side].line;
  }
}

void PointsInArrangement::erase(ObjectId object) {
  if (is_line_[object]) return locate_all();
  forget(object);
  points_.erase(std::lower_bound(points_.begin(), points_.end(), object));
}

void PointsInArrangement::move(ObjectId p) {
  kernel_->settle_later(id_);
  if (places_[p].moves) return;
  places_[p].moves = true;
  moves_.push_back(p);
}

void PointsInArrangement::certificate_failed(CertificateId failed) {
  const ObjectId p = slots_.failed(failed);
  for (auto& certificates : places_[p].certificates) {
    for (CertificateId& slot : certificates) {
      if (slot == failed) slots_.drop(slot);
    }
  }
  move(p);
  kernel_->report(id_, kMove, {p}, false);
}

void PointsInArrangement::motions_changed(std::span<const ObjectId> objects) {
  for (const ObjectId object : objects) {
    for (const CertificateId c : kernel_->certificates_of(object)) {
      if (slots_.owns(c)) move(kernel_->tag(c));
    }
  }
}

bool PointsInArrangement::is_next_to(ObjectId p, ObjectId line) const {
  return places_[p].edges[kUp].line == line || places_[p].edges[kDown].line == line;
}

void PointsInArrangement::watched_changed(const Event* event) {
  const bool few = event != nullptr && event->kind <= LineArrangement2::kEqual;
  for (const ObjectId p : points_) {
    bool near = !few;
    for (std::size_t i = 0; few && i < event->count; ++i) near = near || is_next_to(p, event->ids[i]);
    if (near) move(p);
  }
}

// The orders of the lines are those right after now.
void PointsInArrangement::instant_settled() {
  for (const ObjectId p : std::exchange(moves_, {})) {
    locate(p);
    moved_.push_back(p);
  }
}

void PointsInArrangement::instant_over() {
  sort_unique(moved_);
  for (const ObjectId p : std::exchange(moved_, {})) {
    Place& place = places_[p];
    for (const Side side : {kUp, kDown}) {
      const ObjectId was = std::exchange(place.told[side], place.edges[side].line);
      const ObjectId is = place.told[side];
      if (was == is) continue;
      kernel_->report(id_, side == kUp ? kAbove : kBelow,
                      {p, was == kNoObject ? p : was, is == kNoObject ? p : is}, true);
    }
  }
}

Attribute PointsInArrangement::attribute_of(bool told) const {
  Attribute result{Attribute::Shape::kSequence, {}};
  for (const ObjectId p : points_) {
    result.ids.push_back(p);
    for (const Side side : {kUp, kDown}) {
      const ObjectId line = told ? places_[p].told[side] : places_[p].edges[side].line;
      result.ids.push_back(line == kNoObject ? p : line);
    }
  }
  return result;
}

Attribute PointsInArrangement::attribute() const { return attribute_of(false); }
Attribute PointsInArrangement::told() const { return attribute_of(true); }

// ---- checks

void PointsInArrangement::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "line next to a point";
  for (const ObjectId p : points_) {
    for (const Side side : {kUp, kDown}) {
      const Edge& edge = places_[p].edges[side];
      if (edge.line == kNoObject) continue;
      group.about = {p, edge.line};
      group.text = side == kUp ? "the next line above" : "the next line below";
      visitor.group(group);
      const auto& [own, before, after] = places_[p].certificates[side];
      if (own != kNoCertificate) visitor.certificate(own, side == kUp ? "below" : "above");
      if (before != kNoCertificate) visitor.certificate(before, "behind a crossing");
      if (after != kNoCertificate) visitor.certificate(after, "before a crossing");
    }
  }
}

std::vector<BoundCheck> PointsInArrangement::bounds(const BoundContext& context) const {
  const LinesAndPoints both(context, is_line_);
  const int degree = 2 * context.degree;
  return {at_most("points_in_arrangement.certificates", "6 for each point",
                  Integer(6) * counted(both.points.size()), counted(context.ledger->max_live)),
          at_most("points_in_arrangement.events",
                  "lines next to a point change where it meets a line, or two lines above or below "
                  "it meet, and where pieces meet",
                  Integer(2) * (side_changes(both, degree) + order_changes(both, degree)),
                  counted(context.ledger->external))};
}

void PointsInArrangement::check_invariants(AuditReport& report) const {
  report.check(moves_.empty() && moved_.empty(), [] { return "a point was not located"; });
  const CrossingLists& crossings = lines_->crossings();
  for (const ObjectId p : points_) {
    const auto where = [p] { return " at point " + std::to_string(p); };
    const Place& place = places_[p];
    for (const Side side : {kUp, kDown}) {
      const Edge& edge = place.edges[side];
      report.check(place.told[side] == edge.line,
                   [&] { return "a change was not reported" + where(); });
      const auto& [own, before, after] = place.certificates[side];
      if (edge.line == kNoObject) {
        report.check(own == kNoCertificate && before == kNoCertificate && after == kNoCertificate,
                     [&] { return "a certificate too many" + where(); });
        continue;
      }
      const auto holds = [&](CertificateId slot, ObjectId m, bool is_before) {
        if (m == kNoObject) return slot == kNoCertificate;
        return slots_.holds(slot, crossing_claim(edge.line, m, is_before, p), p);
      };
      report.check(slots_.holds(own, side_claim(side, edge.line, p), p) &&
                       holds(before, edge.before, true) && holds(after, edge.after, false),
                   [&] { return "a wrong certificate" + where(); });
      const std::vector<ObjectId>& row = crossings.order(edge.line);
      const std::size_t behind = edge.before == kNoObject
                                     ? crossings.place(edge.line, edge.line) + 1
                                     : crossings.place(edge.line, edge.before) + 1;
      report.check((behind < row.size() ? row[behind] : kNoObject) == edge.after,
                   [&] { return "crossings that are no neighbours" + where(); });
    }
  }
}

std::size_t PointsInArrangement::bytes() const {
  return is_line_.capacity() / 8 + places_.capacity() * sizeof(Place) +
         (points_.capacity() + moves_.capacity() + moved_.capacity()) * sizeof(ObjectId);
}

}  // namespace kinex
