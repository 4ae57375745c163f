// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/arrangement/trapezoids_2.h"

#include <algorithm>
#include <string>

#include "structures/arrangement/line_bounds.h"

namespace kinex {

Trapezoids2::Trapezoids2(Kernel& kernel, StructureId id, const LineArrangement2& lines)
    : kernel_(&kernel), id_(id), lines_(&lines), walls_(kernel, id, lines.crossings()) {}

// Of a triangle that turns over, inexact arithmetics may change the lists of its lines one after the other,
// at different times: in between faces do not close. All of them are cut when it is heard of the next change.
bool Trapezoids2::settle() {
  if (walls_.is_settled()) return true;
  if (walls_.settle(lines_->slopes())) {
    tries_ = 0;
    return true;
  }
  walls_.note_all();
  if (kernel_->is_exact() || ++tries_ > kMostTries) {
    kernel_->corrupt(id_, "a face of the arrangement does not close");
  }
  return false;
}

// In an inexact arithmetic faces may not close yet: what is there is then what later changes start from.
void Trapezoids2::settle_all() {
  walls_.note_all();
  settle();
  walls_.forget();
}

void Trapezoids2::build(std::span<const ObjectId>) {
  walls_.clear();
  settle_all();
}

// Within an instant the lists of crossings may be on their way to another order, in which faces do not
// close: the proof is built when the instant is settled, and the walls are as they were until then.
void Trapezoids2::rebuild() {
  walls_.drop_proof();
  walls_.forget();
  walls_.note_all();
  kernel_->settle_later(id_);
}

void Trapezoids2::insert(ObjectId) { settle_all(); }

void Trapezoids2::erase(ObjectId) { settle_all(); }

void Trapezoids2::certificate_failed(CertificateId failed) {
  const auto [a, b, c, d] = walls_.failed(failed);
  kernel_->settle_later(id_);
  kernel_->report(id_, kWallPass, {a, b, c, d}, false);
}

void Trapezoids2::motions_changed(std::span<const ObjectId> objects) {
  walls_.motions_changed(objects);
  if (!walls_.is_settled()) kernel_->settle_later(id_);
}

void Trapezoids2::watched_changed(const Event* event) {
  kernel_->settle_later(id_);
  if (event == nullptr || event->kind > LineArrangement2::kEqual) return walls_.note_all();
  const auto& ids = event->ids;
  switch (event->kind) {
    case LineArrangement2::kTriple:
      walls_.note_crossing(ids[0], ids[1]);
      walls_.note_crossing(ids[0], ids[2]);
      return walls_.note_crossing(ids[1], ids[2]);
    case LineArrangement2::kParallel:
      walls_.note_crossing(ids[0], ids[1]);
      walls_.note_ends(ids[0]);
      return walls_.note_ends(ids[1]);
    default:  // equal: all faces between these two and others
      walls_.note_line(ids[0]);
      return walls_.note_line(ids[1]);
  }
}

void Trapezoids2::instant_over() {
  const std::vector<FaceWalls::Wall> changed = walls_.changed();
  const auto came_or_gone = [this](const FaceWalls::Wall& wall) {
    return (walls_.end(wall) == FaceWalls::kAbsent) !=
           (walls_.end_before(wall) == FaceWalls::kAbsent);
  };
  if (std::any_of(changed.begin(), changed.end(), came_or_gone)) {
    const Attribute before = told();
    walls_.forget();
    return kernel_->report_settled(id_, before.ids, attribute().ids);
  }
  for (const FaceWalls::Wall& wall : changed) {
    const ObjectId was = walls_.end_before(wall), is = walls_.end(wall);
    if (was == is) continue;
    kernel_->report(
        id_, wall.side == FaceWalls::kUp ? kWallUp : kWallDown,
        {wall.l, wall.m, was == kNoObject ? wall.l : was, is == kNoObject ? wall.l : is}, true);
  }
  walls_.forget();
}

std::size_t Trapezoids2::trapezoids() const {
  std::size_t result = 0;
  walls_.each_trapezoid(lines_->slopes(),
                        [&result](const FaceWalls::Trapezoid&, bool) { ++result; });
  return result;
}

Attribute Trapezoids2::attribute_of(bool told) const {
  Attribute result{Attribute::Shape::kSequence, {}};
  walls_.each(told, [&result](const FaceWalls::Wall& wall, ObjectId end) {
    if (wall.side == FaceWalls::kUp) result.ids.insert(result.ids.end(), {wall.l, wall.m});
    result.ids.push_back(end == kNoObject ? wall.l : end);
  });
  return result;
}

// The wall upwards from a crossing v changes from a line h to a line k. Either h or k passed v: a root of
// the orientation of three lines, with three crossings and two walls each. Or both are above v before and
// after it: then they changed their order at v, at a root of slope_order_2, which is that of one of three
// pairs of two pairs of four lines, for one wall of each of the two crossings; or where the lines of v are
// parallel, for two walls.
std::vector<BoundCheck> Trapezoids2::bounds(const BoundContext& context) const {
  const Integer n = counted(context.objects());
  const int degree = 2 * context.degree;
  Integer observed(0);
  for (const char* kind : {"wall_up", "wall_down"}) {
    const auto found = context.ledger->by_kind.find(kind);
    if (found != context.ledger->by_kind.end()) observed += counted(found->second);
  }
  return {
      at_most("trapezoids_2.certificates", "one for each wall, two walls for each two lines",
              n * std::max(Integer(0), n - Integer(1)), counted(context.ledger->max_live)),
      at_most("trapezoids_2.events",
              "walls end on other lines only where three lines meet, crossings are one above the "
              "other, lines are parallel, and where pieces meet",
              Integer(6) * (triple_sign_changes(context.pieces, degree) +
                            quadruple_sign_changes(context.pieces, degree)) +
                  Integer(2) * pair_sign_changes(context.pieces, context.degree),
              observed)};
}

void Trapezoids2::check_invariants(AuditReport& report) const {
  walls_.check(lines_->slopes(), report);
  report.check(told() == attribute(), [] { return "a change of the walls was not reported"; });
}

}  // namespace kinex
