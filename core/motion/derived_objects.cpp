// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/derived_objects.h"

#include <algorithm>
#include <utility>

#include "core/numbers/check.h"

namespace kinex {

DerivedObjects::Known& DerivedObjects::known(ObjectId object) {
  require(!is_derived(object), "an object was derived from a derived one");
  if (motions_.size() < first_) motions_.resize(first_);
  return motions_[object];
}

void DerivedObjects::set_motion(ObjectId object, const Trajectory& trajectory,
                                const std::optional<Rational>& until) {
  if (!keeps_) return;
  Known& entry = known(object);
  entry.trajectory = trajectory;
  entry.until = until;
}

ObjectId DerivedObjects::add(std::string name, std::shared_ptr<const Construction> construction,
                             std::span<const ObjectId> bases) {
  require(keeps_, "objects can be derived in scenes of bodies only");
  const ObjectId id = first_ + static_cast<ObjectId>(derived_.size());
  derived_.push_back(
      {std::move(name), std::move(construction), {bases.begin(), bases.end()}, {}, {}});
  for (const ObjectId base : bases) known(base).dependents.push_back(id);
  renew(id);
  return id;
}

ObjectId DerivedObjects::add(std::string name, Trajectory constant) {
  const ObjectId id = first_ + static_cast<ObjectId>(derived_.size());
  derived_.push_back({std::move(name), nullptr, {}, std::move(constant), {}});
  return id;
}

void DerivedObjects::redefine(ObjectId id, std::string name, Trajectory constant) {
  Object& object = derived_[id - first_];
  require(object.construction == nullptr, "only a constant can be redefined");
  object.name = std::move(name);
  object.trajectory = std::move(constant);
}

void DerivedObjects::rebase(ObjectId id, std::string name, std::span<const ObjectId> bases) {
  Object& object = derived_[id - first_];
  require(object.construction != nullptr, "a constant has no bases");
  for (const ObjectId base : object.bases) {
    std::vector<ObjectId>& list = known(base).dependents;
    list.erase(std::find(list.begin(), list.end(), id));
  }
  object.name = std::move(name);
  object.bases.assign(bases.begin(), bases.end());
  for (const ObjectId base : bases) {
    std::vector<ObjectId>& list = known(base).dependents;
    list.insert(std::lower_bound(list.begin(), list.end(), id), id);
  }
  renew(id);
}

const DerivedObjects::Object& DerivedObjects::renew(ObjectId id) {
  Object& object = derived_[id - first_];
  if (object.construction == nullptr) return object;
  std::vector<const Trajectory*> bases;
  object.until = std::nullopt;
  for (const ObjectId base : object.bases) {
    const Known& entry = known(base);
    bases.push_back(&entry.trajectory);
    if (entry.until && (!object.until || *entry.until < *object.until)) object.until = entry.until;
  }
  object.trajectory = object.construction->derive(bases);
  return object;
}

std::span<const ObjectId> DerivedObjects::dependents(ObjectId object) const {
  if (object >= motions_.size()) return {};
  return motions_[object].dependents;
}

std::size_t DerivedObjects::bytes() const {
  std::size_t total = motions_.capacity() * sizeof(Known) + derived_.capacity() * sizeof(Object);
  for (const Object& object : derived_) {
    total += object.name.capacity() + object.bases.capacity() * sizeof(ObjectId);
    for (const auto& axis : object.trajectory.coordinates)
      total += axis.capacity() * 2 * sizeof(Rational);
  }
  return total;
}

}  // namespace kinex
