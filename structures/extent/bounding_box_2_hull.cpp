// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/bounding_box_2_hull.h"

#include <algorithm>
#include <string>

#include "predicates/predicates.h"
#include "structures/parts/extremum_bounds.h"

namespace kinex {
namespace {

constexpr std::array<std::string_view, 4> kNames{"minimum x", "maximum x", "minimum y",
                                                 "maximum y"};

}  // namespace

BoundingBox2Hull::BoundingBox2Hull(Kernel& kernel, StructureId id,
                                   const HullSource& hull)
    : kernel_(&kernel),
      id_(id),
      hull_(&hull),
      order_{kernel.bind(make_coordinate_order(0)), kernel.bind(make_coordinate_order(1))},
      slots_(kernel, id, "sides"),
      events_(kernel, id, Attribute::Shape::kSequence) {}

// `b` is farther out than `a` right after now, or identically as far and of smaller id.
bool BoundingBox2Hull::beats(std::size_t side, ObjectId b, ObjectId a) const {
  const Sign inside = kernel_->sign_after(claim(side, a, b));
  return inside == Sign::kNegative || (inside == Sign::kZero && b < a);
}

// The ring has the side's vertex between the neighbours that its certificates name.
bool BoundingBox2Hull::fits(const Side& side) const {
  const HullRing& ring = hull_->ring();
  return ring.has(side.vertex) && ring.previous(side.vertex) == side.previous &&
         ring.next(side.vertex) == side.next;
}

// From the vertex of before, or from where it was, outwards. In an inexact arithmetic this may stop
// anywhere, after one round at the latest.
ObjectId BoundingBox2Hull::climb(std::size_t side) const {
  const HullRing& ring = hull_->ring();
  const Side& before = sides_[side];
  ObjectId at = ring.any();
  for (const ObjectId candidate : {before.previous, before.next, before.vertex}) {
    if (ring.has(candidate)) at = candidate;
  }
  const ObjectId start = at;
  std::size_t steps = 0;
  while (steps < ring.size() && beats(side, ring.next(at), at)) at = ring.next(at), ++steps;
  if (at != start) return at;
  while (steps < ring.size() && beats(side, ring.previous(at), at)) at = ring.previous(at), ++steps;
  return at;
}

void BoundingBox2Hull::certify(std::size_t side, std::size_t which, ObjectId neighbour) {
  Side& s = sides_[side];
  CertificateId& slot = s.certificates[which];
  const bool needed = neighbour != s.vertex && (which == 0 || neighbour != s.previous);
  if (!needed) return slots_.drop(slot);
  const Query query = claim(side, s.vertex, neighbour);
  const auto tag = static_cast<std::uint32_t>(2 * side + which);
  const bool stays = slot != kNoCertificate && slot != failing_ && kernel_->claims(slot, query);
  if (!stays) slots_.set(slot, query, tag);
}

void BoundingBox2Hull::look(std::size_t side) {
  const HullRing& ring = hull_->ring();
  Side& s = sides_[side];
  s.vertex = climb(side);
  s.previous = ring.previous(s.vertex);
  s.next = ring.next(s.vertex);
  certify(side, 0, s.previous);
  certify(side, 1, s.next);
  box_[side] = s.vertex;
}

void BoundingBox2Hull::look() {
  if (hull_->ring().size() == 0) {
    for (Side& side : sides_) {
      for (CertificateId& slot : side.certificates) slots_.drop(slot);
      side = {};
    }
    return box_.clear();
  }
  box_.resize(kSides);
  for (std::size_t side = 0; side < kSides; ++side) look(side);
}

void BoundingBox2Hull::rebuild() {
  for (Side& side : sides_) {
    for (CertificateId& slot : side.certificates) slots_.drop(slot);
    side = {};
  }
  begin();
}

// Where the hull changes at this instant, too, the ring may not be final: the sides are looked at
// again when the instant is settled.
void BoundingBox2Hull::certificate_failed(CertificateId failed) {
  const std::uint32_t tag = slots_.failed(failed);
  if (!kernel_->is_exact() && repeats_.failed(kernel_->query(failed))) {
    return kernel_->corrupt(id_, "a certificate fails again and again");
  }
  const std::size_t side = tag / 2;
  const ObjectId old = sides_[side].vertex;
  failing_ = failed;
  if (box_.empty() || hull_->ring().size() == 0) {
    look();
  } else {
    look(side);
  }
  failing_ = kNoCertificate;
  if (hull_->shares_instant()) {
    kernel_->settle_later(hull_->id());
    kernel_->settle_later(id_);
  }
  const ObjectId fresh = box_.empty() ? old : box_[side];
  events_.repaired(kReplace, {old, fresh}, box_, hull_->id());
}

void BoundingBox2Hull::watched_changed(const Event*) {
  if (hull_->ring().size() == 0 || box_.empty()) {
    look();
  } else {
    for (std::size_t side = 0; side < kSides; ++side) {
      if (!fits(sides_[side])) look(side);
    }
  }
  if (box_ != events_.told().ids) kernel_->settle_later(id_);
}

void BoundingBox2Hull::visit_proof(ProofVisitor& visitor) const {
  for (std::size_t side = 0; side < box_.size(); ++side) {
    ProofGroup group;
    group.kind = kNames[side];
    group.about = {box_[side]};
    group.place = side + 1;
    visitor.group(group);
    for (const CertificateId c : sides_[side].certificates) {
      if (c != kNoCertificate) visitor.certificate(c, "a neighbour is not beyond it");
    }
  }
}

std::vector<BoundCheck> BoundingBox2Hull::bounds(const BoundContext& context) const {
  const StructureLedger& ledger = *context.ledger;
  Integer changes = Integer(4) * extremum_changes(context, context.pieces, 1, context.degree);
  if (context.plain() && context.degree <= 1) {
    changes = std::min(changes, Integer(2) * counted(context.objects()));
  }
  return {at_most("bounding_box_2_hull.certificates", "two for each side", Integer(8),
                  counted(ledger.max_live)),
          at_most("bounding_box_2_hull.external",
                  "pieces of the upper and lower envelope of each axis", changes,
                  counted(ledger.external))};
}

void BoundingBox2Hull::check_invariants(AuditReport& report) const {
  report.check(events_.told().ids == box_, [] { return "a change of the box was not reported"; });
  report.check(box_.size() == (hull_->ring().size() == 0 ? 0 : kSides),
               [] { return "a side has no point"; });
  for (std::size_t side = 0; side < box_.size(); ++side) {
    const Side& s = sides_[side];
    const auto name = [side] { return "wrong at the " + std::string(kNames[side]); };
    report.check(fits(s) && box_[side] == s.vertex, name);
    const std::array<ObjectId, 2> neighbours{s.previous, s.next};
    for (std::size_t which = 0; which < 2; ++which) {
      const ObjectId b = neighbours[which];
      const bool needed = b != s.vertex && (which == 0 || b != s.previous);
      const CertificateId slot = s.certificates[which];
      const auto tag = static_cast<std::uint32_t>(2 * side + which);
      report.check(needed ? slots_.holds(slot, claim(side, s.vertex, b), tag)
                          : slot == kNoCertificate,
                   name);
      report.check(!needed || !slots_.is_tie(slot) || s.vertex < b, name);
    }
  }
}

}  // namespace kinex
