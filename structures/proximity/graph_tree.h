// SPDX-License-Identifier: GPL-3.0-or-later
// GraphTree: the minimum spanning forest of a graph whose edges have moving weights:
// graph_mst_list, graph_mst_cycles, graph_mst_clusters and graph_mst_sparsified.
//
// The objects of a scene of one axis are the edges, each between two named vertices ("ends"), and
// their coordinates are the weights. Parallel edges are allowed, and graphs that are not
// connected. The engine proves the forest; certificates compare two weights, degree d for motions
// of degree d. For m edges, n vertices and k clusters:
//
//     name         engine              the forest is proved by              certificates at most
//     _list        tree_by_list.h      the order of all edges               m - 1
//     _cycles      tree_by_cycles.h    the heaviest edge of every cycle     (m - n + 1)(n - 1)
//     _clusters    tree_by_clusters.h  the heaviest edges of paths in and   3m + n (log2 n + 1)
//                                      between clusters of its vertices       + nk + 2k^2
//     _sparsified  tree_by_forests.h   cycles in each node of a tournament  (n - 1)^2 in each inner
//                                      of forests of groups of edges          node: see there
//
// External events: at most d C(m, 2) without flight-plan changes, one for each two edges that
// change their order; O(m n^(1/3)) for linear weights (Dey). When an edge is inserted or erased,
// _list repeats Kruskal's algorithm along the list, O(m alpha(m)); the others prove anew only the
// cycles, the clusters, or the nodes above the edge's group that it changes.
//
// Ties. Of edges whose weights are identically equal the smaller object counts as the lighter, so
// the forest is unique.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7; Agarwal,
// Eppstein, Guibas, Henzinger, "Parametric and kinetic minimum spanning trees" (1998): the problem.
#ifndef KINEX_STRUCTURES_PROXIMITY_GRAPH_TREE_H
#define KINEX_STRUCTURES_PROXIMITY_GRAPH_TREE_H

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/proximity/graph_weights.h"
#include "structures/proximity/spanning_tree.h"
#include "structures/proximity/tree_engine.h"
#include "structures/proximity/tree_events.h"

namespace kinex {

class GraphTree final : public Structure {
 public:
  // `name`: as registered.
  GraphTree(Kernel& kernel, StructureId id, const Scene& scene, const TreeMethod& method,
            std::string_view name);

  std::string_view name() const override { return name_; }
  // Those of TreeEventKind.
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"swap", engine_->inside_kind(), "tie"});
  }
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override { engine_->certificate_failed(failed); }
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override {
    engine_->motions_changed(objects);
  }
  void instant_over() override { events_.over(); }
  Attribute attribute() const override;
  Attribute told() const override { return events_.told(attribute()); }
  void visit_proof(ProofVisitor& visitor) const override { engine_->visit_proof(visitor); }
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override {
    return weights_.bytes() + events_.bytes() + engine_->bytes() +
           members_.capacity() * sizeof(ObjectId);
  }

 private:
  std::string_view name_;
  GraphWeights weights_;
  TreeEvents events_;
  std::unique_ptr<TreeEngine> engine_;
  std::vector<ObjectId> members_;  // ascending
};

}  // namespace kinex

#endif
