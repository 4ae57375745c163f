// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/collision/outer_hierarchies.h"

#include <string>

namespace kinex {

OuterHierarchies::OuterHierarchies(Kernel& kernel, StructureId, const Scene& scene)
    : scene_(scene),
      alive_(scene.objects.size(), 0),
      frames_{BodyFrames(kernel, scene, kPolicies[0]), BodyFrames(kernel, scene, kPolicies[1]),
              BodyFrames(kernel, scene, kPolicies[2]), BodyFrames(kernel, scene, kPolicies[3])},
      trees_(scene.objects.size(), Trees{}) {}

void OuterHierarchies::build(std::span<const ObjectId> objects) {
  for (const ObjectId object : objects) insert(object);
}

// Nothing depends on time.
void OuterHierarchies::rebuild() {}

void OuterHierarchies::insert(ObjectId object) {
  alive_[object] = 1;
  for (std::size_t i = 0; i < kPolicies.size(); ++i) {
    trees_[object][i] = &frames_[i].frame(object, false).hierarchy();
  }
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
    const OuterHierarchy& tree = *trees(object).back();
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
    frames_[i].each_hierarchy([&](const OuterHierarchy& tree) { bounds.add(tree); });
    const std::string prefix = "outer_hierarchy." + std::string(cut_policy_name(kPolicies[i]));
    for (BoundCheck& check : bounds.checks(prefix)) checks.push_back(std::move(check));
  }
  return checks;
}

void OuterHierarchies::check_invariants(AuditReport& report) const {
  for (ObjectId object = 0; object < alive_.size(); ++object) {
    report.check(alive_[object] == 0 || trees(object).back() != nullptr,
                 [&] { return "no hierarchies for " + scene_.objects[object].id; });
  }
}

std::size_t OuterHierarchies::bytes() const {
  std::size_t total = alive_.capacity() + trees_.capacity() * sizeof(Trees);
  for (const BodyFrames& frames : frames_) total += frames.bytes();
  return total;
}

}  // namespace kinex
