// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/maximum/maximum_envelope.h"

#include <algorithm>
#include <string>

#include "structures/maximum/maximum_bounds.h"
#include "structures/maximum/upper_envelope.h"

namespace kinex {

MaximumEnvelope::MaximumEnvelope(Kernel& kernel, StructureId id, const Key& key, const Scene& scene,
                                 Extremum extremum)
    : kernel_(&kernel),
      id_(id),
      contest_(extremum, kernel, key, scene),
      slots_(kernel, id, "next winner"),
      scene_(&scene) {}

std::string_view MaximumEnvelope::name() const {
  return contest_.extremum() == Extremum::kMaximum ? "maximum_envelope" : "minimum_envelope";
}

std::vector<std::string_view> MaximumEnvelope::event_kinds() const {
  return common_event_kinds({"replace", "tie"});
}

void MaximumEnvelope::build(std::span<const ObjectId> objects) {
  members_ = contest_.order().members(objects);
  renew();
}

void MaximumEnvelope::renew() {
  winners_ = UpperEnvelope(contest_, *kernel_).compute(members_);
  at_ = 0;
  set_certificate();
}

void MaximumEnvelope::set_certificate() {
  if (to_come() == 0) return slots_.drop(certificate_);
  slots_.renew(certificate_, contest_.claim(winners_[at_], winners_[at_ + 1]), 0);
}

void MaximumEnvelope::certificate_failed(CertificateId failed) {
  slots_.failed(failed);
  const ObjectId old = winners_[at_++];
  set_certificate();
  kernel_->report(id_, kReplace, {old, winners_[at_]}, true);
}

// ---- changes

// If the new envelope begins with another object, the old winner is kept in front of it: its
// certificate fails at once, and the change is an event like any other.
void MaximumEnvelope::motions_changed(std::span<const ObjectId>) {
  const ObjectId old = winner();
  winners_ = UpperEnvelope(contest_, *kernel_).compute(members_);
  at_ = 0;
  const bool changed = !winners_.empty() && winners_[0] != old;
  const bool tie = changed && kernel_->sign_after(contest_.claim(old, winners_[0])) !=
                                  Sign::kNegative;
  if (changed && !tie) winners_.insert(winners_.begin(), old);
  set_certificate();
  if (tie) kernel_->report(id_, kTie, {old, winners_[0]}, true);
}

void MaximumEnvelope::insert(ObjectId object) {
  members_.insert(std::lower_bound(members_.begin(), members_.end(), object), object);
  renew();
}

void MaximumEnvelope::erase(ObjectId object) {
  contest_.order().check_erasure(object);
  members_.erase(std::lower_bound(members_.begin(), members_.end(), object));
  renew();
}

// ---- attribute, bounds, invariants

Attribute MaximumEnvelope::attribute() const {
  Attribute result{Attribute::Shape::kObject, {}};
  if (!winners_.empty()) result.ids.push_back(winners_[at_]);
  return result;
}

std::vector<BoundCheck> MaximumEnvelope::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> result = maximum_bounds(name(), contest_.order(), context, 1);
  result.push_back(no_internal_events(name(), context));
  return result;
}

std::size_t MaximumEnvelope::bytes() const {
  return (members_.capacity() + winners_.capacity()) * sizeof(ObjectId);
}

}  // namespace kinex
