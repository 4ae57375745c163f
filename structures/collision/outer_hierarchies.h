// SPDX-License-Identifier: GPL-3.0-or-later
// OuterHierarchies ("outer_hierarchy"): the boomerang hierarchies of all bodies' polygons under
// every policy of cuts, checked against their bounds. It shows what the structures for collisions
// are built on (predicates/bodies/outer_hierarchy.h) and follows no motion.
//
// Certificates: none; a polygon is constant in its own frame. Events: none of its own. Attribute:
// the bodies that are present. Bounds: those of HierarchyBounds for every policy, over the polygons
// of all bodies so far. Audit: tiles and polygon fill the bounding box exactly; every stage is
// convex, lies in the one before and holds the polygon.
//
// Cost: four hierarchies for every distinct polygon, O(n depth) each. Source: the header
// of the hierarchies.
#ifndef KINEX_STRUCTURES_COLLISION_OUTER_HIERARCHIES_H
#define KINEX_STRUCTURES_COLLISION_OUTER_HIERARCHIES_H

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "core/motion/scene.h"
#include "predicates/bodies/body_frames.h"
#include "structures/collision/hierarchy_bounds.h"

namespace kinex {

class OuterHierarchies final : public Structure {
 public:
  static constexpr std::array<CutPolicy, 4> kPolicies{
      CutPolicy::kMedian, CutPolicy::kCompass, CutPolicy::kDudley, CutPolicy::kBalancedDudley};

  OuterHierarchies(Kernel& kernel, StructureId id, const Scene& scene);

  std::string_view name() const override { return "outer_hierarchy"; }
  std::vector<std::string_view> event_kinds() const override { return common_event_kinds({}); }
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId) override {}  // there is none
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  Attribute attribute() const override;
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override;

  // The hierarchies of a body that is, or was, present, by policy. Bodies with equal polygons share
  // them.
  using Trees = std::array<const OuterHierarchy*, kPolicies.size()>;
  const Trees& trees(ObjectId body) const { return trees_[body]; }

 private:
  const Scene& scene_;
  std::vector<std::uint8_t> alive_;
  std::array<BodyFrames, kPolicies.size()> frames_;
  std::vector<Trees> trees_;  // per body; nullptr: it has never been present
};

}  // namespace kinex

#endif
