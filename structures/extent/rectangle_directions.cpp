// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/rectangle_directions.h"

#include <algorithm>
#include <string>

#include "predicates/points/unit_directions.h"
#include "structures/parts/tournament_proof.h"

namespace kinex {
namespace {

// One side of each of k boxes; the other one is direction i + k of unit_directions_2(k).
std::vector<DirectionVector> sides(int k) {
  std::vector<DirectionVector> all = unit_directions_2(k);
  all.resize(static_cast<std::size_t>(k));
  return all;
}

}  // namespace

RectangleDirections::RectangleDirections(Kernel& kernel, StructureId id, const Scene& scene, int k,
                                         BoxMeasure measure)
    : kernel_(&kernel),
      id_(id),
      k_(k),
      maxima_(
          make_direction_maxima(kernel, id, scene, unit_directions_2(k), MaximaChoice::kByDegree)),
      boxes_(kernel, id, "boxes", BoxClaims(kernel, sides(k), measure)),
      events_(kernel, id, Attribute::Shape::kSequence) {
  for (std::size_t i = 0; i < boxes(); ++i) current_.push_back(box(i));
}

RectangleDirections::Value RectangleDirections::box(std::size_t i) const {
  const std::size_t turned = i + boxes();
  return {static_cast<ObjectId>(i), maxima_->winner(i), maxima_->winner(maxima_->opposite(i)),
          maxima_->winner(turned), maxima_->winner(maxima_->opposite(turned))};
}

void RectangleDirections::read(std::size_t i) {
  const Value fresh = box(i);
  if (fresh == current_[i]) return;
  if (!is_point(current_[i])) boxes_.go(current_[i]);
  if (!is_point(fresh)) boxes_.come(fresh);
  current_[i] = fresh;
}

void RectangleDirections::read_all() {
  for (std::size_t i = 0; i < boxes(); ++i) read(i);
  boxes_.apply(equal());
}

std::vector<ObjectId> RectangleDirections::touched() const {
  const Value* front = boxes_.front();
  if (front == nullptr) return {};
  return {front->begin() + 1, front->end()};
}

void RectangleDirections::begin() {
  read_all();
  events_.begin(touched());
}

void RectangleDirections::build(std::span<const ObjectId> objects) {
  maxima_->build(objects, level());
  begin();
}

void RectangleDirections::rebuild() {
  maxima_->rebuild(level());
  read_all();
  boxes_.rebuild(equal());
  begin();
}

void RectangleDirections::certificate_failed(CertificateId failed) {
  if (maxima_->owns(failed)) {
    const auto [direction, before, after] = maxima_->failed(failed, level());
    read(direction % boxes());
    boxes_.apply(equal());
    events_.repaired(kReplace, {before, after}, touched());
  } else {
    const auto [a, b] = boxes_.failed(failed, equal());
    events_.repaired(kOvertake, {a[1], a[2], a[3], a[4], b[1], b[2], b[3], b[4]}, touched());
  }
}

void RectangleDirections::insert(ObjectId object) {
  maxima_->insert(object, level());
  begin();
}

void RectangleDirections::erase(ObjectId object) {
  maxima_->erase(object, level());
  begin();
}

void RectangleDirections::motions_changed(std::span<const ObjectId> objects) {
  maxima_->motions_changed(objects, level());
  read_all();
  boxes_.motions_changed(objects, equal());
}

// ---- proof, bounds, invariants

void RectangleDirections::visit_proof(ProofVisitor& visitor) const {
  maxima_->visit_proof(visitor);
  visit_tournament(
      visitor, boxes_, static_cast<std::uint32_t>(maxima_->size()), "boxes, the smallest wins",
      [](const Value& winner) { return std::vector<ObjectId>(winner.begin() + 1, winner.end()); });
}

std::vector<BoundCheck> RectangleDirections::bounds(const BoundContext& context) const {
  const StructureLedger& ledger = *context.ledger;
  const std::string name(this->name());
  const Integer all = counted(boxes());
  std::vector<BoundCheck> result{
      at_most(name + ".certificates", "those of the extreme objects, and of the boxes",
              maxima_->most_certificates(context) + all, counted(ledger.max_live)),
      at_most(name + ".locality", "those of the extreme objects, and of the boxes",
              maxima_->most_per_object(context) + all, counted(ledger.max_per_object)),
      at_most(name + ".events", "those of the extreme objects, and the epochs of the tournament",
              maxima_->most_failures(context) +
                  boxes_.most_failures(boxes_.claims().degree(context.degree)),
              counted(ledger.failures))};
  if (context.plain() && context.degree <= 1) {
    result.push_back(at_most(name + ".external",
                             "the changes of all sides, and of the order of each two boxes",
                             most_changes(counted(context.objects())), counted(ledger.external)));
  }
  return result;
}

// For n lines: both sides across a direction change n times in all, so a box has 2n + 1 pieces at
// most, and two of them have 4n + 1 joint ones. On each the measures are polynomials of degree 1 or 2,
// and continuous where pieces meet. For the perimeter also the pieces of a lower envelope of segments.
Integer RectangleDirections::most_changes(const Integer& n) const {
  const Integer k = counted(boxes()), one(1), two(2);
  const Integer degree = is_area() ? two : one;
  const Integer crossings = pairs(k) * degree * (Integer(4) * n + one) + two * k * n;
  if (is_area()) return crossings;
  return std::min(crossings, davenport_schinzel_bound(3, k * (two * n + one)) - one);
}

void RectangleDirections::check_invariants(AuditReport& report) const {
  maxima_->check(report);
  boxes_.check(report, "boxes");
  std::size_t present = 0;
  for (std::size_t i = 0; i < boxes(); ++i) {
    const auto where = [i] { return " in direction " + std::to_string(i); };
    report.check(current_[i] == box(i), [&] { return "a box of other objects" + where(); });
    if (is_point(current_[i])) continue;
    ++present;
    report.check(boxes_.has(current_[i]), [&] { return "a box that is lost" + where(); });
  }
  report.check(present == boxes_.size(), [] { return "a box too many"; });
  report.check(events_.told().ids == touched(),
               [] { return "a change of the rectangle was not reported"; });
}

}  // namespace kinex
