// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/extent_directions.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "predicates/points/unit_directions_3.h"
#include "structures/parts/tournament_proof.h"

namespace kinex {

ExtentDirections::ExtentDirections(Kernel& kernel, StructureId id, const Scene& scene, int k,
                                   Extremum extremum)
    : kernel_(&kernel),
      id_(id),
      k_(scene.dimension == 3 ? std::min(k, kMostInSpace) : k),
      dimension_(scene.dimension),
      maxima_(make_direction_maxima(kernel, id, scene, unit_directions(k_, dimension_),
                                    MaximaChoice::kByDegree)),
      extents_(kernel, id, "extents",
               ExtentClaims(kernel, unit_directions(k_, dimension_), extremum)),
      events_(kernel, id, Attribute::Shape::kTuples) {
  if (dimension_ != 2 && (dimension_ != 3 || !maximum())) {
    throw std::invalid_argument("extents along directions are for the plane, diameters for space, too");
  }
  for (std::size_t i = 0; i < half(); ++i) current_.push_back(extent(i));
}

ExtentDirections::Value ExtentDirections::extent(std::size_t i) const {
  return {static_cast<ObjectId>(i), maxima_->winner(i), maxima_->winner(maxima_->opposite(i))};
}

// Extents of one object are identically zero and take no part in the tournament.
void ExtentDirections::read(std::size_t i) {
  const Value fresh = extent(i);
  if (fresh == current_[i]) return;
  if (!is_point(current_[i])) extents_.go(current_[i]);
  if (!is_point(fresh)) extents_.come(fresh);
  current_[i] = fresh;
}

void ExtentDirections::read_all() {
  for (std::size_t i = 0; i < half(); ++i) read(i);
  extents_.apply(equal());
}

std::vector<ObjectId> ExtentDirections::ends() const {
  const Value* front = extents_.front();
  if (front == nullptr || (!maximum() && extents_.size() < half())) return {};
  return {std::min((*front)[1], (*front)[2]), std::max((*front)[1], (*front)[2])};
}

void ExtentDirections::begin() {
  read_all();
  events_.begin(ends());
}

void ExtentDirections::build(std::span<const ObjectId> objects) {
  maxima_->build(objects, level());
  begin();
}

void ExtentDirections::rebuild() {
  maxima_->rebuild(level());
  read_all();
  extents_.rebuild(equal());
  begin();
}

void ExtentDirections::certificate_failed(CertificateId failed) {
  if (maxima_->owns(failed)) {
    const auto [direction, before, after] = maxima_->failed(failed, level());
    read(direction % half());
    extents_.apply(equal());
    events_.repaired(kReplace, {before, after}, ends());
  } else {
    const auto [old, fresh] = extents_.failed(failed, equal());
    events_.repaired(kOvertake, {old[1], old[2], fresh[1], fresh[2]}, ends());
  }
}

void ExtentDirections::insert(ObjectId object) {
  maxima_->insert(object, level());
  begin();
}

void ExtentDirections::erase(ObjectId object) {
  maxima_->erase(object, level());
  begin();
}

void ExtentDirections::motions_changed(std::span<const ObjectId> objects) {
  maxima_->motions_changed(objects, level());
  read_all();
  extents_.motions_changed(objects, equal());
}

// ---- proof, bounds, invariants

void ExtentDirections::visit_proof(ProofVisitor& visitor) const {
  maxima_->visit_proof(visitor);
  visit_tournament(visitor, extents_, static_cast<std::uint32_t>(maxima_->size()),
                   maximum() ? "extents, the largest wins" : "extents, the smallest wins",
                   [](const Value& winner) {
                     return std::vector<ObjectId>{winner[1], winner[2]};
                   });
}

std::vector<BoundCheck> ExtentDirections::bounds(const BoundContext& context) const {
  const StructureLedger& ledger = *context.ledger;
  const std::string name(this->name());
  const Integer extents = counted(half());
  std::vector<BoundCheck> result{
      at_most(name + ".certificates", "those of the extreme objects, and of the extents",
              maxima_->most_certificates(context) + extents, counted(ledger.max_live)),
      at_most(name + ".locality", "those of the extreme objects, and of the extents",
              maxima_->most_per_object(context) + extents, counted(ledger.max_per_object)),
      at_most(name + ".events", "those of the extreme objects, and the epochs of the tournament",
              maxima_->most_failures(context) + extents_.most_failures(context.degree),
              counted(ledger.failures))};
  if (context.plain() && context.degree <= 1) {
    const Integer pieces = extents * counted(context.objects() + 1);
    result.push_back(
        maximum() ? at_most(name + ".external", "an upper envelope of n + 1 lines a direction",
                            pieces - Integer(1), counted(ledger.external))
                  : at_most(name + ".external", "a lower envelope of n + 1 segments a direction",
                            davenport_schinzel_bound(3, pieces), counted(ledger.external)));
  }
  return result;
}

void ExtentDirections::check_invariants(AuditReport& report) const {
  maxima_->check(report);
  extents_.check(report, "extents");
  std::size_t present = 0;
  for (std::size_t i = 0; i < half(); ++i) {
    const auto where = [i] { return " in direction " + std::to_string(i); };
    report.check(current_[i] == extent(i), [&] { return "an extent of other objects" + where(); });
    if (is_point(current_[i])) continue;
    ++present;
    report.check(extents_.has(current_[i]), [&] { return "an extent that is lost" + where(); });
  }
  report.check(present == extents_.size(), [] { return "an extent too many"; });
  report.check(events_.told().ids == ends(),
               [] { return "a change of the extent was not reported"; });
}

}  // namespace kinex
