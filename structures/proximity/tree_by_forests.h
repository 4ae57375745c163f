// SPDX-License-Identifier: GPL-3.0-or-later
// TreeByForests: the minimum spanning forest of a changing graph of many more edges than vertices, by
// a tournament of forests.
//
// The edges are in groups by their numbers, each of as many edges as there are vertices, or of more
// where that would make more than 120 groups. A complete binary tree has the groups for its leaves;
// every node has the minimum spanning forest of its edges, which are those of the group, or those of
// the forests of its two children:
//
//                 F1 = MSF(F2 + F3)            n vertices: a forest has n - 1 edges at most, so an
//                  /          \                inner node has 2n - 2. An edge that is not in the
//       F2 = MSF(F4 + F5)    F3 = MSF(..)      forest of a node is the longest of a cycle there, and
//        /         \           /    \          is not in the forest of all edges either.
//    F4 = MSF(..)  F5 = MSF(..)
//
// So the forest of the root is that of the graph. Each node proves its forest by the longest edge of
// every cycle (tree_by_cycles.h). A failure changes the forest of a node; an edge that takes the place
// of another there is an insertion and an erasure in the node above, which may change its forest in
// turn.
//
// Certificates, for m edges and n vertices, in groups of g = max(n, m / 120) edges: about 2m / g nodes. A
// leaf has at most (g - k) k certificates, k = min(n - 1, g / 2); an inner node (n - 1)^2, and 2 (n - 1)^2
// while the forests of its children change. Every failure changes the forest of a node; it is internal if
// that of the root stays. Each edge is in O(log(m / g)) nodes.
//
// Source: Eppstein, Galil, Italiano, Nissenzweig, "Sparsification" (1997), as used by Agarwal,
// Eppstein, Guibas, Henzinger, "Parametric and kinetic minimum spanning trees" (1998).
#ifndef KINEX_STRUCTURES_PROXIMITY_TREE_BY_FORESTS_H
#define KINEX_STRUCTURES_PROXIMITY_TREE_BY_FORESTS_H

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "structures/proximity/tree_engine.h"

namespace kinex {

class TreeByForests final : public TreeEngine {
 public:
  // Numbers of edges are below `items`, and each is the first of its edge's ids.
  TreeByForests(Kernel& kernel, StructureId id, const TreeEdges& edges, TreeEvents& events,
                std::size_t vertices, std::size_t items);

  std::string_view inside_kind() const override { return "forest"; }
  void build(std::vector<Item> items) override;
  void add(Item item) override;
  void remove(Item item) override;
  void finish(Change change) override;
  bool owns(CertificateId certificate) const override;
  void certificate_failed(CertificateId failed) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void renew(std::span<const Item> items) override;
  // Two edges are both in the nodes above some leaf. Each swap in one of them lowers a rank in its
  // forest: at most twice.
  Integer most_failures_per_exchange() const override;
  void visit_proof(ProofVisitor& visitor) const override;
  Integer most_certificates(std::size_t edges, std::size_t vertices) const override;
  std::string_view why_most() const override {
    return "the longest edges of cycles in each node of a tree of forests";
  }
  void check(AuditReport& report) const override;
  std::size_t bytes() const override;

 private:
  // The changes of the forest of a node.
  class Changes final : public TreeEvents {
   public:
    Changes(Kernel& kernel, StructureId id, TreeEvents& all)
        : TreeEvents(kernel, id, {}), all_(&all) {}
    void repaired(const EdgeIds& before, const EdgeIds& after) override {
      exchange_ = {before, after};
    }
    void tied(const EdgeIds& before, const EdgeIds& after) override { all_->tied(before, after); }
    // The two edges of the last failure.
    const std::array<EdgeIds, 2>& exchange() const { return exchange_; }

   private:
    TreeEvents* all_;
    std::array<EdgeIds, 2> exchange_{};
  };
  struct Node {
    std::unique_ptr<Changes> changes;
    std::unique_ptr<TreeEngine> engine;
  };

  std::size_t groups() const { return nodes_.size() / 2; }
  std::size_t leaf_of(Item item) const { return groups() + item / group_; }
  // The edges of a node, ascending: of its group, or of the forests of its children.
  std::vector<Item> edges_of(std::size_t v) const;
  void pass_on(std::size_t v, Change change);
  void pass_up(std::size_t v, Change change);

  std::size_t group_;        // edges of a group
  std::vector<Node> nodes_;  // from 1; the children of node v are 2v and 2v + 1
};

}  // namespace kinex

#endif
