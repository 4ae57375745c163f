// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/collision/outer_hierarchies.h"

#include <string>

namespace kinex {

OuterHierarchies::OuterHierarchies(Kernel&, StructureId, const Scene& scene)
    : scene_(scene), alive_(scene.objects.size(), 0), of_body_(scene.objects.size(), kNone) {}

void OuterHierarchies::build(std::span<const ObjectId> objects) {
  for (const ObjectId object : objects) insert(object);
}

// Nothing depends on time.
void OuterHierarchies::rebuild() {}

void OuterHierarchies::insert(ObjectId object) {
  alive_[object] = 1;
  if (of_body_[object] != kNone) return;
  const FramePolygon polygon = frame_polygon(scene_.objects[object].polygon, false);
  const auto [place, is_new] =
      by_polygon_.try_emplace(polygon.vertices, static_cast<std::uint32_t>(trees_.size()));
  if (is_new) {
    trees_.push_back({OuterHierarchy(polygon, kPolicies[0]), OuterHierarchy(polygon, kPolicies[1]),
                      OuterHierarchy(polygon, kPolicies[2]),
                      OuterHierarchy(polygon, kPolicies[3])});
  }
  of_body_[object] = place->second;
}

void OuterHierarchies::erase(ObjectId object) { alive_[object] = 0; }

Attribute OuterHierarchies::attribute() const {
  Attribute attribute;
  attribute.shape = Attribute::Shape::kSequence;
  for (ObjectId object = 0; object < alive_.size(); ++object) {
    if (alive_[object] != 0) attribute.ids.push_back(object);
  }
  return attribute;
}

std::vector<BoundCheck> OuterHierarchies::bounds(const BoundContext&) const {
  std::vector<BoundCheck> checks;
  for (std::size_t i = 0; i < kPolicies.size(); ++i) {
    HierarchyBounds bounds(kPolicies[i]);
    for (const Trees& trees : trees_) bounds.add(trees[i]);
    const std::string prefix = "outer_hierarchy." + std::string(cut_policy_name(kPolicies[i]));
    for (BoundCheck& check : bounds.checks(prefix)) checks.push_back(std::move(check));
  }
  return checks;
}

void OuterHierarchies::check_invariants(AuditReport& report) const {
  for (ObjectId object = 0; object < alive_.size(); ++object) {
    report.check(alive_[object] == 0 || of_body_[object] < trees_.size(),
                 [&] { return "no hierarchies for " + scene_.objects[object].id; });
  }
}

std::size_t OuterHierarchies::bytes() const {
  std::size_t total = alive_.capacity() + of_body_.capacity() * sizeof(std::uint32_t);
  for (const Trees& trees : trees_) {
    for (const OuterHierarchy& tree : trees) {
      total += sizeof tree + tree.bytes() + tree.polygon().size() * sizeof(FramePoint);
    }
  }
  return total;
}

}  // namespace kinex
