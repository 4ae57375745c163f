// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/hull/convex_hull_2_brute_force.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>

#include "structures/hull/hull_bounds.h"
#include "structures/hull/static_hull.h"
#include "structures/parts/sort_unique.h"

namespace kinex {

std::vector<std::string_view> ConvexHull2BruteForce::event_kinds() const {
  return HullEvents::kinds({"reflex", "outside", "between"});
}

Outlook ConvexHull2BruteForce::claim(const Query& query, Kind kind) {
  return slots_.set(certificates_.emplace_back(kNoCertificate), query, kind);
}

// The point is left of u v, or identically on it between its ends.
void ConvexHull2BruteForce::claim_inside(ObjectId u, ObjectId v, ObjectId point) {
  if (claim(signs_.left_turn(u, v, point), kInside) != Outlook::kIdenticallyZero) return;
  signs_.note_tie();  // the bounds on events count triples that are not always on one line
  for (const int axis : {0, 1}) {
    const Sign direction = signs_.order_sign(axis, u, v);
    if (direction == Sign::kZero) continue;
    const bool forward = direction == Sign::kPositive;
    claim(forward ? signs_.order(axis, u, point) : signs_.order(axis, point, u), kBetween);
    claim(forward ? signs_.order(axis, point, v) : signs_.order(axis, v, point), kBetween);
    return;
  }
}

// Finds the hull just after now and makes all certificates that prove it.
const std::vector<ObjectId>& ConvexHull2BruteForce::find_hull() {
  for (CertificateId& slot : certificates_) slots_.drop(slot);
  certificates_.clear();
  cycle_ = static_hull(signs_, members_);
  const std::size_t h = cycle_.size();
  std::vector<ObjectId> vertices = cycle_;
  sort_unique(vertices);
  if (vertices.size() < h) {
    kernel_->corrupt(id_, "the hull goes through a point twice");
    return cycle_;
  }
  for (std::size_t i = 0; i < h && h > 2; ++i) {
    claim(Query(touch_turn_, {cycle_[i], cycle_[(i + 1) % h], cycle_[(i + 2) % h]}), kTurn);
  }
  std::vector<ObjectId> others;
  std::set_difference(members_.begin(), members_.end(), vertices.begin(), vertices.end(),
                      std::back_inserter(others));
  for (const ObjectId point : others) {
    for (std::size_t i = 0; i < h && h > 1; ++i) {
      claim_inside(cycle_[i], cycle_[i + 1 == h ? 0 : i + 1], point);
    }
  }
  return cycle_;
}

void ConvexHull2BruteForce::build(std::span<const ObjectId> objects) {
  members_.assign(objects.begin(), objects.end());
  rebuild();
}

void ConvexHull2BruteForce::certificate_failed(CertificateId failed) {
  const auto kind = static_cast<std::uint8_t>(slots_.failed(failed));
  const Query query = kernel_->query(failed);
  const auto& ids = query.ids;
  if (query.arity == 3) {
    kernel_->report(id_, kind, {ids[0], ids[1], ids[2]}, false);
  } else {
    kernel_->report(id_, kind, {ids[0], ids[1]}, false);
  }
  if (!kernel_->is_exact()) {
    if (repeats_.failed(query)) {
      return kernel_->corrupt(id_, "a certificate fails again and again");
    }
    if (static_hull(signs_, members_) == cycle_) {
      // The signs contradict the failure: the certificate is dropped.
      const auto at = std::find(certificates_.begin(), certificates_.end(), failed);
      slots_.drop(*at);
      certificates_.erase(at);
      return;
    }
  }
  events_.settle(find_hull());
}

void ConvexHull2BruteForce::insert(ObjectId object) {
  repeats_.clear();
  members_.insert(std::lower_bound(members_.begin(), members_.end(), object), object);
  rebuild();
}

void ConvexHull2BruteForce::erase(ObjectId object) {
  members_.erase(std::lower_bound(members_.begin(), members_.end(), object));
  rebuild();
}

// Certificates have been rescheduled. Where points are, or come to be, identically on a hull edge,
// or equal, a change may show in no certificate.
void ConvexHull2BruteForce::motions_changed(std::span<const ObjectId> objects) {
  repeats_.clear();
  if (cycle_.size() < 3 || signs_.tied()) look_again_ = true;
  each_tie(*kernel_, id_, objects, [this](CertificateId) { look_again_ = true; });
}

void ConvexHull2BruteForce::instant_settled() {
  if (look_again_) events_.settle(find_hull());
  look_again_ = false;
}

// A group for every hull vertex and every hull edge, and one for the points that are on edges.
void ConvexHull2BruteForce::visit_proof(ProofVisitor& visitor) const {
  std::vector<std::pair<std::vector<ObjectId>, CertificateId>> shown;  // what it is about
  for (const CertificateId c : certificates_) {
    const Query query = kernel_->query(c);
    const std::uint32_t kind = kernel_->tag(c);
    const ObjectId* const first = query.ids.data() + (kind == kTurn ? 1 : 0);
    const std::size_t count = kind == kTurn ? 1 : kind == kInside ? 2 : 0;
    shown.emplace_back(std::vector<ObjectId>(first, first + count), c);
  }
  std::stable_sort(shown.begin(), shown.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  static constexpr std::array<std::array<std::string_view, 2>, 3> kTexts{
      {{"points on hull edges", "between the ends"},
       {"hull vertex", "the hull turns left"},
       {"hull edge", "inside"}}};
  ProofGroup group;
  for (const auto& [about, certificate] : shown) {
    const auto& [kind, role] = kTexts[about.size()];
    if (group.kind != kind || group.about != about) {
      group.kind = kind;
      group.about = about;
      visitor.group(group);
    }
    visitor.certificate(certificate, role);
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
  report.check(cycle_ == static_hull(signs_, members_),
               [] { return "the hull is not that of the static algorithm"; });
}

std::size_t ConvexHull2BruteForce::bytes() const {
  return sizeof *this + events_.bytes() +
         (members_.capacity() + cycle_.capacity()) * sizeof(ObjectId) +
         certificates_.capacity() * sizeof(CertificateId);
}

}  // namespace kinex
