// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/maximum/maximum_dual_hull.h"

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "structures/maximum/maximum_bounds.h"

namespace kinex {
namespace {

const Key& linear(const Key& key, const Scene& scene) {
  if (scene.degree_without_weights() > 1) {
    throw std::invalid_argument("a dual hull needs linear motions, not motions of degree " +
                                std::to_string(scene.degree_without_weights()));
  }
  if (key.kind == Key::Kind::kSquaredDistance) {
    throw std::invalid_argument("a dual hull needs a linear key, not a squared distance");
  }
  return key;
}

}  // namespace

MaximumDualHull::MaximumDualHull(Kernel& kernel, StructureId id, const Key& key, const Scene& scene,
                                 Extremum extremum)
    : kernel_(&kernel),
      id_(id),
      contest_(extremum, kernel, linear(key, scene), scene),
      order_(kernel, contest_, scene.dimension),
      hull_(order_, scene.objects.size()),
      slots_(kernel, id, "next winner"),
      objects_(scene.objects.size()) {}

std::string_view MaximumDualHull::name() const {
  return contest_.extremum() == Extremum::kMaximum ? "maximum_dual_hull" : "minimum_dual_hull";
}

std::vector<std::string_view> MaximumDualHull::event_kinds() const {
  return common_event_kinds({"replace", "tie"});
}

void MaximumDualHull::build(std::span<const ObjectId> objects) {
  hull_.build({objects.begin(), objects.end()});
  look();
}

void MaximumDualHull::rebuild() {
  hull_.build(hull_.members());
  look();
}

// Finds the winner and the next vertex.
void MaximumDualHull::look() {
  winner_ = hull_.empty() ? kNoObject : hull_.best();
  expect(winner_ == kNoObject ? kNoObject : hull_.next(winner_));
}

void MaximumDualHull::expect(ObjectId next) {
  next_ = next;
  if (next == kNoObject) return slots_.drop(certificate_);
  slots_.renew(certificate_, contest_.claim(winner_, next), 0);
}

void MaximumDualHull::certificate_failed(CertificateId failed) {
  slots_.failed(failed);
  const ObjectId old = winner_;
  winner_ = next_;
  expect(hull_.next(winner_));
  kernel_->report(id_, kReplace, {old, winner_}, true);
}

// If another object is best now, the certificate still claims the old winner: it fails at once, and
// the change is an event like any other.
void MaximumDualHull::motions_changed(std::span<const ObjectId> objects) {
  hull_.change(objects);
  const ObjectId old = winner_;
  const ObjectId best = hull_.empty() ? kNoObject : hull_.best();
  if (best == old) {
    look();
  } else if (kernel_->sign_after(contest_.claim(old, best)) == Sign::kNegative) {
    expect(best);
  } else {
    look();
    kernel_->report(id_, kTie, {old, winner_}, true);
  }
}

void MaximumDualHull::insert(ObjectId object) {
  hull_.insert(object);
  look();
}

void MaximumDualHull::erase(ObjectId object) {
  hull_.erase(object);
  look();
}

// ---- attribute, bounds, invariants

Attribute MaximumDualHull::attribute() const {
  Attribute result{Attribute::Shape::kObject, {}};
  if (winner_ != kNoObject) result.ids.push_back(winner_);
  return result;
}

std::vector<BoundCheck> MaximumDualHull::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> result = maximum_bounds(name(), contest_.order(), context, 1);
  result.push_back(no_internal_events(name(), context));
  return result;
}

}  // namespace kinex
