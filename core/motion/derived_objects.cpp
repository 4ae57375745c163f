// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/derived_objects.h"

#include <algorithm>
#include <utility>

#include "core/numbers/check.h"

namespace kinex {

void DerivedObjects::set_motion(ObjectId object, const Trajectory& trajectory,
                                const std::optional<Rational>& until) {
  require(!is_derived(object), "a derived object has no motion of its own");
  motions_[object] = trajectory;
  if (until && until_.empty()) until_.resize(first_);
  if (!until_.empty()) until_[object] = until;
}

std::vector<ObjectId>& DerivedObjects::dependents_of(ObjectId object) {
  if (dependents_.size() <= object) dependents_.resize(object + std::size_t{1});
  return dependents_[object];
}

const std::optional<Rational>* DerivedObjects::until_of(ObjectId id) const {
  if (is_derived(id)) return &object(id).until;
  return until_.empty() ? nullptr : &until_[id];
}

void DerivedObjects::set_stands_for(Object& object) const {
  std::vector<ObjectId>& all = object.stands_for;
  all.clear();
  for (const ObjectId base : object.bases) {
    if (is_derived(base)) {
      const std::vector<ObjectId>& more = this->object(base).stands_for;
      all.insert(all.end(), more.begin(), more.end());
    } else {
      all.push_back(base);
    }
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
}

ObjectId DerivedObjects::add(std::string name, std::shared_ptr<const Construction> construction,
                             std::span<const ObjectId> bases) {
  const ObjectId id = first_ + static_cast<ObjectId>(derived_.size());
  for (const ObjectId base : bases) {
    require(base < id, "a base does not exist");
    nested_ = nested_ || is_derived(base);
  }
  derived_.push_back(
      {std::move(name), std::move(construction), {bases.begin(), bases.end()}, {}, {}, {}, {}});
  set_stands_for(derived_.back());
  for (const ObjectId base : bases) {
    std::vector<ObjectId>& list = dependents_of(base);
    if (list.empty() || list.back() != id) list.push_back(id);
  }
  renew(id);
  return id;
}

ObjectId DerivedObjects::add(std::string name, Trajectory constant,
                             const std::optional<PolygonFeature>& feature) {
  const ObjectId id = first_ + static_cast<ObjectId>(derived_.size());
  derived_.push_back({std::move(name), nullptr, {}, {}, std::move(constant), {}, feature});
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
  const std::vector<ObjectId> above = all_dependents(id);
  for (const ObjectId base : bases) {
    require(base < first_ + derived_.size(), "a base does not exist");
    require(base != id && std::find(above.begin(), above.end(), base) == above.end(),
            "an object was derived from itself");
    nested_ = nested_ || is_derived(base);
  }
  for (const ObjectId base : object.bases) std::erase(dependents_of(base), id);
  object.name = std::move(name);
  object.bases.assign(bases.begin(), bases.end());
  for (const ObjectId base : bases) {
    std::vector<ObjectId>& list = dependents_of(base);
    const auto place = std::lower_bound(list.begin(), list.end(), id);
    if (place == list.end() || *place != id) list.insert(place, id);
  }
  set_stands_for(object);
  renew(id);
  for (const ObjectId dependent : above) set_stands_for(derived_[dependent - first_]);
}

const DerivedObjects::Object& DerivedObjects::renew(ObjectId id) {
  Object& object = derived_[id - first_];
  if (object.construction == nullptr) return object;
  std::vector<const Trajectory*> bases;
  object.until = std::nullopt;
  for (const ObjectId base : object.bases) {
    bases.push_back(&trajectory(base));
    const std::optional<Rational>* until = until_of(base);
    if (until == nullptr || !*until) continue;
    if (!object.until || **until < *object.until) object.until = *until;
  }
  object.trajectory = object.construction->derive(bases);
  return object;
}

std::span<const ObjectId> DerivedObjects::dependents(ObjectId object) const {
  if (object >= dependents_.size()) return {};
  return dependents_[object];
}

// Depth first; an object is finished after all that depend on it, so the order is that of
// finishing, reversed.
std::vector<ObjectId> DerivedObjects::all_dependents(ObjectId object) const {
  std::vector<ObjectId> order;
  if (!nested_) {
    const std::span<const ObjectId> direct = dependents(object);
    order.assign(direct.begin(), direct.end());
    return order;
  }
  struct Visit {
    ObjectId id;
    std::size_t left;  // dependents not yet walked
  };
  std::vector<Visit> stack{{object, dependents(object).size()}};
  std::vector<std::uint8_t> seen(derived_.size(), 0);
  while (!stack.empty()) {
    Visit& top = stack.back();
    if (top.left == 0) {
      if (top.id != object) order.push_back(top.id);
      stack.pop_back();
      continue;
    }
    const ObjectId next = dependents(top.id)[--top.left];
    std::uint8_t& mark = seen[next - first_];
    if (mark != 0) continue;
    mark = 1;
    stack.push_back({next, dependents(next).size()});
  }
  std::reverse(order.begin(), order.end());
  return order;
}

std::size_t DerivedObjects::bytes() const {
  std::size_t total = until_.capacity() * sizeof(until_[0]) +
                      dependents_.capacity() * sizeof(dependents_[0]) +
                      derived_.capacity() * sizeof(Object);
  for (const std::vector<ObjectId>& list : dependents_) total += list.capacity() * sizeof(ObjectId);
  for (const Object& object : derived_) {
    total += object.name.capacity() +
             (object.bases.capacity() + object.stands_for.capacity()) * sizeof(ObjectId);
    for (const auto& axis : object.trajectory.coordinates)
      total += axis.capacity() * 2 * sizeof(Rational);
  }
  return total;
}

}  // namespace kinex
