// SPDX-License-Identifier: GPL-3.0-or-later
// ConeTree: the minimum spanning tree of moving points of the plane in a norm whose unit circle is a
// polygon, among the pairs of a point and the next one in a cone around it, which it watches. In the
// maximum norm (mst_maximum_norm_list, _cycles, _clusters) these are octants_local or
// octants_listed, in the norm of a polygon of 12 or 20 corners (mst_polygon_list, _cycles, _clusters)
// cones_local.
//
// The engine proves the tree: by the order of all those pairs (tree_by_list.h), by the longest edge
// of every cycle (tree_by_cycles.h), or by those of paths in and between clusters of the points
// (tree_by_clusters.h, which has its bounds). Certificates compare two lengths, each a linear function
// of the step between two points: degree d for motions of degree d (norm_order.h).
//
// Pairs suffice. In a cone of p over a side of the unit circle the norm is a linear function u. Let q
// be the first point there by u, and r another one:
//
//         b     .           q = p + s a,  r = p + t b  on two rays of the cone, 0 < s <= t;
//          .   .  r         |a| = |b| = 1, so |pq| = s, |pr| = t
//           . q .
//            . .            r - q = (t - s) b + s (b - a)
//             p . . . a     |qr| <= (t - s) + s |b - a| < t, since the side is shorter than 1
//
// So pr is the longest edge of the triangle p, q, r and is not in the tree. (Octants are halves of the
// cones of the maximum norm, whose sides have length 2.) Each pair is in one cone, so its length is
// one linear function. When a pair enters another cone its length becomes another linear function,
// and the engine gets a new edge in place of the old one.
//
// Quality, for n points and k cones of which no two are opposite (4 octants, 6 or 10 cones of a
// polygon), of the engine beside the cones:
//
//                          list                             cycles
//   certificates           at most kn - 1                   at most ((k - 1)n + 1)(n - 1)
//   a failure renews       3, mostly internal               the paths across a cut
//   a pointer of the       O(log n) comparisons and         one path dropped, another proved
//   cones changes          Kruskal's algorithm, O(n)
//
// Where two points have one coordinate in common for an instant, their distances from all points
// beyond may be equal: several exchanges at one instant are the rule.
//
// Approximation. The i-th shortest edge of the tree is at most 1 + eps times the i-th shortest one of
// the Euclidean tree (cone_frame.h): eps < 0.055 for 12 corners, 0.02 for 20. Both trees are made at
// every audit.
//
// Ties. As norm_order.h says: in the order after an infinitesimal turn of the plane, then by ids.
// Points that are identically equal are a path in the order of their ids.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7: trees in
// polyhedral metrics, and approximate Euclidean ones. Their cones are ours.
#ifndef KINEX_STRUCTURES_PROXIMITY_CONE_TREE_H
#define KINEX_STRUCTURES_PROXIMITY_CONE_TREE_H

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/proximity/cone_neighbours.h"
#include "structures/proximity/norm_lengths.h"
#include "structures/proximity/tree_engine.h"
#include "structures/proximity/tree_events.h"

namespace kinex {

class ConeTree final : public Structure, public ConeWatcher {
 public:
  // `cones` outlives this structure and is watched by it. `name`: as registered.
  ConeTree(Kernel& kernel, StructureId id, const ConeNeighbours& cones, const TreeMethod& method,
           std::string_view name);

  std::string_view name() const override { return name_; }
  // Those of TreeEventKind.
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"swap", engine_->inside_kind(), "tie"});
  }
  void build(std::span<const ObjectId>) override { begin(); }
  void rebuild() override;
  void certificate_failed(CertificateId failed) override { engine_->certificate_failed(failed); }
  // Points come and go in the cones, which have said what pointers do.
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
  void assign_changed();

  Kernel* kernel_;
  StructureId id_;
  std::string_view name_;
  const ConeNeighbours* cones_;
  NormLengths lengths_;
  TreeEvents events_;
  std::unique_ptr<TreeEngine> engine_;
  std::uint64_t builds_ = 0;  // of the cones, as read
  std::vector<Pair> stale_;  // pairs of which pointers have changed since the tree was made
};

// The tree at exact positions in the norm whose unit circle has so many corners (ConeFrame), from all
// pairs of living objects, with the same ties: edges, ascending, flattened. O(n^2 log n).
std::vector<ObjectId> static_norm_tree(const Snapshot& snapshot, int corners);
// True if the squared lengths of the edges, flattened, in ascending order, are at most `ratio`, a
// fraction, times those of the others.
bool within_ratio(const Snapshot& snapshot, const std::vector<ObjectId>& edges,
                  const std::vector<ObjectId>& others, const std::array<int, 2>& ratio);

}  // namespace kinex

#endif
