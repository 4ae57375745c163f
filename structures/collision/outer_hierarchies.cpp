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

namespace {

// The outline of the stage before the cuts of `level`.
void add_stage(const OuterHierarchy& tree, std::uint32_t v, int level, ProofMark& mark) {
  const OuterHierarchy::Node& node = tree.node(v);
  if (node.cut_level >= level) {
    mark.outline.push_back(node.apex.coordinates());
    return;
  }
  add_stage(tree, node.left, level, mark);
  add_stage(tree, node.right, level, mark);
}

}  // namespace

// The stages of the hierarchy of the last policy, from the box inwards.
void OuterHierarchies::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "hierarchy";
  for (ObjectId object = 0; object < alive_.size(); ++object) {
    if (alive_[object] == 0) continue;
    const OuterHierarchy& tree = trees(object).back();
    group.about = {object};
    group.text = std::to_string(tree.levels()) + " levels, " + std::to_string(tree.cuts().size()) +
                 " cuts, " + std::string(cut_policy_name(kPolicies.back()));
    group.marks.clear();
    for (int level = 0; level <= tree.levels(); ++level) {
      ProofMark& mark = group.marks.emplace_back();
      mark.shape = ProofMark::Shape::kOutline;
      mark.name = "stage of the hierarchy";
      for (std::uint32_t root = 0; root < tree.roots(); ++root) {
        add_stage(tree, root, level, mark);
      }
    }
    visitor.group(group);
  }
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
