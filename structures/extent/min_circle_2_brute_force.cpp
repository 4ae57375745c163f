// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/min_circle_2_brute_force.h"

#include <algorithm>
#include <utility>

#include "predicates/predicates.h"
#include "structures/extent/min_circle_audit.h"

namespace kinex {

MinCircle2BruteForce::MinCircle2BruteForce(Kernel& kernel, StructureId id, const Scene& scene)
    : kernel_(&kernel),
      id_(id),
      acute_(kernel.bind(make_acute_angle_2())),
      obtuse_(kernel.bind(make_obtuse_angle_2())),
      orientation_(kernel.bind(make_orientation_2())),
      in_circle_(kernel.bind(make_in_circle_2())),
      order_{kernel.bind(make_coordinate_order(0)), kernel.bind(make_coordinate_order(1))},
      slots_(kernel, id, "claims"),
      alive_(scene.objects.size(), false),
      events_(kernel, id, Attribute::Shape::kSequence) {}

// ---- the static algorithm

bool MinCircle2BruteForce::identical(ObjectId a, ObjectId b) const {
  return kernel_->sign_after(order_[0], {a, b}) == Sign::kZero &&
         kernel_->sign_after(order_[1], {a, b}) == Sign::kZero;
}

// Positive: p is inside the circle of the basis right after now; zero: it is identically on it.
Sign MinCircle2BruteForce::side(ObjectId p) const {
  if (std::find(basis_.begin(), basis_.end(), p) != basis_.end()) return Sign::kZero;
  if (basis_.size() == 1) return identical(basis_[0], p) ? Sign::kZero : Sign::kNegative;
  if (basis_.size() == 2) {
    return kernel_->sign_after(obtuse_, {basis_[0], p, basis_[1]});
  }
  return kernel_->sign_after(in_circle_, {basis_[0], basis_[1], basis_[2], p});
}

void MinCircle2BruteForce::set_basis(std::vector<ObjectId> basis) {
  std::sort(basis.begin(), basis.end());
  basis_ = std::move(basis);
  if (basis_.size() < 3) return;
  const Sign turn = kernel_->sign_after(orientation_, {basis_[0], basis_[1], basis_[2]});
  if (turn == Sign::kNegative) std::swap(basis_[1], basis_[2]);
}

// The smallest circle of the first members that passes through `fixed`, and may be enlarged to hold
// members [0, before).
void MinCircle2BruteForce::add(std::size_t before, std::vector<ObjectId> fixed) {
  set_basis(fixed);
  if (fixed.size() == 3) return;
  for (std::size_t i = 0; i < before; ++i) {
    const ObjectId p = members_[i];
    if (side(p) != Sign::kNegative) continue;
    std::vector<ObjectId> more = fixed;
    more.push_back(p);
    add(i, std::move(more));
  }
}

// A circle of three points may have a right angle or an obtuse one if the arithmetic is inexact
// only.
void MinCircle2BruteForce::find_basis() {
  basis_.clear();
  if (members_.empty()) return;
  basis_ = {members_[0]};
  for (std::size_t i = 1; i < members_.size(); ++i) {
    if (side(members_[i]) == Sign::kNegative) add(i, {members_[i]});
  }
}

// All points identically on the circle, of equal ones the smallest.
void MinCircle2BruteForce::collect() {
  circle_.clear();
  for (const ObjectId p : members_) {
    if (side(p) != Sign::kZero) continue;
    const auto same = [&](ObjectId q) { return identical(q, p); };
    if (std::none_of(circle_.begin(), circle_.end(), same)) circle_.push_back(p);
  }
}

// ---- certificates

std::vector<Query> MinCircle2BruteForce::claims() const {
  std::vector<Query> result;
  if (basis_.size() < 2) return result;
  const ObjectId a = basis_[0], b = basis_[1];
  const auto angle_at = [this](ObjectId at, ObjectId p, ObjectId q) {
    return Query(acute_, {std::min(p, q), at, std::max(p, q)});
  };
  if (basis_.size() == 3) {
    const ObjectId c = basis_[2];
    result = {Query(orientation_, {a, b, c}), angle_at(a, b, c), angle_at(b, c, a),
              angle_at(c, a, b)};
  }
  for (const ObjectId p : members_) {
    if (std::find(basis_.begin(), basis_.end(), p) != basis_.end()) continue;
    result.push_back(basis_.size() == 2 ? Query(obtuse_, {a, p, b})
                                        : Query(in_circle_, {a, b, basis_[2], p}));
  }
  return result;
}

// Finds the circle just after now and makes the certificates that prove it; if the basis is the
// same, those that have not failed stay.
void MinCircle2BruteForce::find() {
  find_basis();
  collect();
  const std::vector<Query> wanted = claims();
  for (std::size_t i = wanted.size(); i < certificates_.size(); ++i) slots_.drop(certificates_[i]);
  certificates_.resize(wanted.size(), kNoCertificate);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    CertificateId& slot = certificates_[i];
    const bool stays =
        slot != kNoCertificate && slot != failing_ && kernel_->claims(slot, wanted[i]);
    if (!stays) slots_.set(slot, wanted[i], static_cast<std::uint32_t>(i));
  }
}

void MinCircle2BruteForce::begin() {
  for (CertificateId& slot : certificates_) slots_.drop(slot);
  certificates_.clear();
  repeats_.clear();
  find();
  events_.begin(circle_);
}

void MinCircle2BruteForce::build(std::span<const ObjectId> objects) {
  for (const ObjectId id : objects) alive_[id] = true;
  members_.assign(objects.begin(), objects.end());
  begin();
}

void MinCircle2BruteForce::insert(ObjectId object) {
  alive_[object] = true;
  members_.insert(std::lower_bound(members_.begin(), members_.end(), object), object);
  begin();
}

void MinCircle2BruteForce::erase(ObjectId object) {
  alive_[object] = false;
  members_.erase(std::find(members_.begin(), members_.end(), object));
  begin();
}

void MinCircle2BruteForce::certificate_failed(CertificateId failed) {
  slots_.failed(failed);
  if (!kernel_->is_exact() && repeats_.failed(kernel_->query(failed))) {
    return kernel_->corrupt(id_, "a certificate fails again and again");
  }
  failing_ = failed;
  find();
  failing_ = kNoCertificate;
  std::vector<ObjectId> on = basis_;
  std::sort(on.begin(), on.end());
  if (on.size() == 3) {
    events_.repaired(kToThree, {on[0], on[1], on[2]}, circle_);
  } else if (on.size() == 2) {
    events_.repaired(kToTwo, {on[0], on[1]}, circle_);
  } else {
    events_.repaired(kToTwo, {}, circle_);
  }
}

void MinCircle2BruteForce::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "circle";
  group.about = circle_;
  visitor.group(group);
  for (const CertificateId c : certificates_) {
    const PredicateId predicate = kernel_->query(c).predicate;
    visitor.certificate(c, predicate == orientation_ ? "upright"
                           : predicate == acute_     ? "not obtuse"
                                                     : "inside");
  }
}

std::vector<BoundCheck> MinCircle2BruteForce::bounds(const BoundContext& context) const {
  const std::uint64_t n = context.objects();
  std::vector<BoundCheck> checks{
      at_most("min_circle_2_brute_force.certificates", "a triangle and every other point",
              counted(n < 2 ? 0 : n + 1), counted(context.ledger->max_live))};
  add_circle_bound("min_circle_2_brute_force", context, checks);
  return checks;
}

void MinCircle2BruteForce::check_invariants(AuditReport& report) const {
  report.check(circle_ == events_.told().ids,
               [] { return "a change of the circle was not reported"; });
  const std::vector<Query> wanted = claims();
  report.check(wanted.size() == certificates_.size(), [] { return "too few certificates"; });
  for (std::size_t i = 0; i < wanted.size() && i < certificates_.size(); ++i) {
    report.check(slots_.holds(certificates_[i], wanted[i], static_cast<std::uint32_t>(i)),
                 [] { return "a wrong certificate"; });
  }
}

void MinCircle2BruteForce::audit(const Snapshot& snapshot, AuditReport& report) const {
  audit_min_circle(circle_, snapshot, report);
}

std::size_t MinCircle2BruteForce::bytes() const {
  return sizeof *this + alive_.capacity() / 8 + events_.bytes() +
         (members_.capacity() + basis_.capacity() + circle_.capacity() + certificates_.capacity()) *
             sizeof(ObjectId);
}

}  // namespace kinex
