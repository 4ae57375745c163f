// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/hull/convex_hull_2_brute_force.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "structures/hull/hull_audit.h"
#include "structures/hull/hull_bounds.h"
#include "structures/hull/static_hull.h"

namespace kinex {

std::vector<std::string_view> ConvexHull2BruteForce::event_kinds() const {
  return HullEvents::kinds({"reflex", "outside", "between"});
}

std::vector<ObjectId> ConvexHull2BruteForce::members() const {
  std::vector<ObjectId> result;
  for (ObjectId id = 0; id < alive_.size(); ++id) {
    if (alive_[id]) result.push_back(id);
  }
  return result;
}

void ConvexHull2BruteForce::retract_all() {
  for (const CertificateId c : certificates_) kernel_->retract(c);
  certificates_.clear();
}

void ConvexHull2BruteForce::claim(const Query& query, Kind kind) {
  certificates_.push_back(kernel_->create(id_, query, kind).id);
}

// The point is left of u v, or identically on it between its ends.
void ConvexHull2BruteForce::claim_inside(ObjectId u, ObjectId v, ObjectId point) {
  const Kernel::Created created =
      kernel_->create(id_, signs_.left_turn(u, v, point), static_cast<std::uint32_t>(kInside));
  certificates_.push_back(created.id);
  if (created.outlook != Outlook::kIdenticallyZero) return;
  for (const int axis : {0, 1}) {
    const Sign direction = signs_.order_sign(axis, u, v);
    if (direction == Sign::kZero) continue;
    const bool forward = direction == Sign::kPositive;
    claim(forward ? signs_.order(axis, u, point) : signs_.order(axis, point, u), kBetween);
    claim(forward ? signs_.order(axis, point, v) : signs_.order(axis, v, point), kBetween);
    return;
  }
}

void ConvexHull2BruteForce::certify_all() {
  const std::size_t h = cycle_.size();
  std::vector<bool> vertex(alive_.size(), false);
  for (const ObjectId id : cycle_) vertex[id] = true;
  for (std::size_t i = 0; i < h && h > 2; ++i) {
    claim(Query(touch_turn_, {cycle_[i], cycle_[(i + 1) % h], cycle_[(i + 2) % h]}), kTurn);
  }
  for (ObjectId id = 0; id < alive_.size() && h > 1; ++id) {
    if (!alive_[id] || vertex[id]) continue;
    for (std::size_t i = 0; i < h; ++i) claim_inside(cycle_[i], cycle_[(i + 1) % h], id);
  }
  most_certificates_ = std::max(most_certificates_, certificates_.size());
}

// Finds the hull just after now and makes all certificates that prove it.
void ConvexHull2BruteForce::find_hull() {
  retract_all();
  cycle_ = static_hull(signs_, members());
  std::vector<ObjectId> once = cycle_;
  std::sort(once.begin(), once.end());
  if (std::adjacent_find(once.begin(), once.end()) != once.end()) {
    return kernel_->corrupt(id_, "the hull goes through a point twice");
  }
  certify_all();
}

void ConvexHull2BruteForce::build(std::span<const ObjectId> objects) {
  for (const ObjectId id : objects) alive_[id] = true;
  find_hull();
  events_.begin(cycle_);
}

void ConvexHull2BruteForce::rebuild() {
  find_hull();
  events_.begin(cycle_);
}

void ConvexHull2BruteForce::certificate_failed(CertificateId failed) {
  const Query query = kernel_->query(failed);
  const std::uint8_t kind = static_cast<std::uint8_t>(kernel_->tag(failed));
  if (query.arity == 3) {
    kernel_->report(id_, kind, {query.ids[0], query.ids[1], query.ids[2]}, false);
  } else {
    kernel_->report(id_, kind, {query.ids[0], query.ids[1]}, false);
  }
  if (!kernel_->is_exact() && repeats_.failed(query)) {
    return kernel_->corrupt(id_, "a certificate fails again and again");
  }
  if (!kernel_->is_exact() && static_hull(signs_, members()) == cycle_) {
    // The signs contradict the failure: the certificate is dropped.
    certificates_.erase(std::find(certificates_.begin(), certificates_.end(), failed));
    return;
  }
  find_hull();
  events_.settle(cycle_);
}

void ConvexHull2BruteForce::insert(ObjectId object) {
  repeats_.clear();
  alive_[object] = true;
  find_hull();
  events_.begin(cycle_);
}

void ConvexHull2BruteForce::erase(ObjectId object) {
  alive_[object] = false;
  find_hull();
  events_.begin(cycle_);
}

// Certificates have been rescheduled. Where points are, or come to be, identically on a hull edge,
// or equal, a change may show in no certificate.
void ConvexHull2BruteForce::motions_changed(std::span<const ObjectId> objects) {
  repeats_.clear();
  if (cycle_.size() < 3 || signs_.tied()) look_again_ = true;
  for (const ObjectId object : objects) {
    for (const CertificateId c : kernel_->certificates_of(object)) {
      if (kernel_->is_tie_of(id_, c)) look_again_ = true;
    }
  }
}

void ConvexHull2BruteForce::instant_settled() {
  if (!look_again_) return;
  look_again_ = false;
  find_hull();
  events_.settle(cycle_);
}

// The certificates come in the order of certify_all, but for some that an inexact arithmetic has
// dropped: the groups are found by what the claims name.
void ConvexHull2BruteForce::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  std::map<std::vector<ObjectId>, std::vector<CertificateId>> of;
  for (const CertificateId c : certificates_) {
    const Query query = kernel_->query(c);
    const auto& ids = query.ids;
    switch (kernel_->tag(c)) {
      case kTurn:
        of[{ids[1]}].push_back(c);
        break;
      case kInside:
        of[{ids[0], ids[1]}].push_back(c);
        break;
      default:
        of[{}].push_back(c);
    }
  }
  for (const auto& [about, certificates] : of) {
    group.about = about;
    group.kind = about.empty()       ? "points on hull edges"
                 : about.size() == 1 ? "hull vertex"
                                     : "hull edge";
    const std::string_view role = about.empty()       ? "between the ends"
                                  : about.size() == 1 ? "the hull turns left"
                                                      : "inside";
    visitor.group(group);
    for (const CertificateId c : certificates) visitor.certificate(c, role);
  }
}

std::vector<BoundCheck> ConvexHull2BruteForce::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> checks = hull_bounds(name(), context, signs_.tied());
  if (context.plain() && !signs_.tied()) {
    checks.push_back(at_most(std::string(name()) + ".events",
                             "each triple of points changes its orientation at most 2d times",
                             turns_of_triples(context), counted(context.ledger->failures)));
  }
  return checks;
}

void ConvexHull2BruteForce::check_invariants(AuditReport& report) const {
  report.check(events_.cycle() == cycle_, [] { return "the hull was not reported"; });
  report.check(cycle_ == static_hull(signs_, members()),
               [] { return "the hull is not that of the static algorithm"; });
}

void ConvexHull2BruteForce::audit(const Snapshot& snapshot, AuditReport& report) const {
  audit_hull(attribute(), alive_.size(), snapshot, report);
}

std::size_t ConvexHull2BruteForce::bytes() const {
  return sizeof *this + alive_.capacity() / 8 + events_.bytes() +
         cycle_.capacity() * sizeof(ObjectId) + certificates_.capacity() * sizeof(CertificateId);
}

}  // namespace kinex
