// SPDX-License-Identifier: GPL-3.0-or-later
// OctantTree: the minimum spanning tree of moving points of the plane in the maximum norm, among the
// pairs of a point and the next one in an octant around it (octants_local or octants_listed), which
// it watches: mst_maximum_norm_list and mst_maximum_norm_cycles.
//
// The engine proves the tree: by the order of all those pairs (tree_by_list.h), or by the longest
// edge of every cycle (tree_by_cycles.h). Certificates compare two lengths, each a difference of two
// coordinates: degree d for motions of degree d (norm_lengths.h).
//
// Pairs suffice. Let q be the first point in an octant of p, and r another one in it: farther from p
// along the axis of the octant. Then r is farther from p than from q, too, since p + the octant,
// cut off at r, is a triangle whose sides between q and r are shorter than the one from p. So pr is
// the longest edge of the triangle p, q, r, and not in the tree. Each pair is in one octant, so it
// has one length; a pair that goes from one octant to the next has another linear function from then
// on, and the engine gets another edge in the place of the old one.
//
// Quality, for n points, of the engine beside the octants:
//
//                          mst_maximum_norm_list            mst_maximum_norm_cycles
//   certificates           at most 4n - 1                   at most (3n + 1)(n - 1)
//   a failure renews       3, mostly internal               the paths across a cut
//   a pointer of the       O(log n) comparisons and         one path dropped, another proved
//   octants changes        Kruskal's algorithm, O(n)
//
// Where two points have one coordinate in common for an instant, their distances from all points
// beyond are equal: several exchanges at one instant are the rule.
//
// Ties. As norm_lengths.h says: in the order after an infinitesimal turn of the plane, then by ids.
// Points that are identically equal are a path in the order of their ids.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7: trees in
// polyhedral metrics. Their octants are ours.
#ifndef KINEX_STRUCTURES_PROXIMITY_OCTANT_TREE_H
#define KINEX_STRUCTURES_PROXIMITY_OCTANT_TREE_H

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/proximity/norm_lengths.h"
#include "structures/proximity/octant_neighbours.h"
#include "structures/proximity/tree_engine.h"
#include "structures/proximity/tree_events.h"

namespace kinex {

class OctantTree final : public Structure, public OctantWatcher {
 public:
  // `octants` outlives this structure and is watched by it.
  OctantTree(Kernel& kernel, StructureId id, const OctantNeighbours& octants, TreeProof proof);

  std::string_view name() const override { return name_; }
  // Those of TreeEventKind.
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"swap", engine_->inside_kind(), "tie"});
  }
  void build(std::span<const ObjectId>) override { begin(); }
  void rebuild() override;
  void certificate_failed(CertificateId failed) override { engine_->certificate_failed(failed); }
  // Points come and go in the octants.
  void insert(ObjectId) override { begin(); }
  void erase(ObjectId) override { begin(); }
  void motions_changed(std::span<const ObjectId> objects) override;
  void pointer_changed(ObjectId point, ObjectId old, ObjectId fresh) override;
  void instant_settled() override { follow(); }
  void instant_over() override { events_.over(); }
  void watched_changed(const Event* event) override;
  Attribute attribute() const override;
  Attribute told() const override { return events_.told(attribute()); }
  void visit_proof(ProofVisitor& visitor) const override { engine_->visit_proof(visitor); }
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override {
    return lengths_.bytes() + events_.bytes() + engine_->bytes() +
           stale_.capacity() * sizeof(Pair);
  }

 private:
  using Pair = NormLengths::Pair;

  std::optional<NormLengths::Form> form_of(const Pair& pair) const;
  void assign(std::span<const Pair> pairs);
  void assign_all();
  void follow();
  void begin();

  Kernel* kernel_;
  StructureId id_;
  std::string_view name_;
  const OctantNeighbours* octants_;
  NormLengths lengths_;
  TreeEvents events_;
  std::unique_ptr<TreeEngine> engine_;
  bool built_ = false;
  std::vector<Pair> stale_;  // pairs of which pointers have changed since the tree was made
};

// The tree in the maximum norm at exact positions, from all pairs of living objects, with the same
// ties: edges, ascending, flattened. O(n^2 log n).
std::vector<ObjectId> static_maximum_norm_tree(const Snapshot& snapshot);

}  // namespace kinex

#endif
