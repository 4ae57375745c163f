// SPDX-License-Identifier: GPL-3.0-or-later
// TreeByList: the minimum spanning forest of a changing graph, by the order of all its edges.
//
// All edges are in a list by length, and the forest is the one that Kruskal's algorithm makes of
// that order. Two neighbours of the list that change places change the forest only if one edge
// replaces the other in a cycle:
//
//     list   .. e f ..        e in the tree, f not, and e on the tree's path between f's ends:
//            .. f e ..        then f takes the place of e; otherwise the tree stays
//
// Certificates. One per pair of neighbours of the list, "this edge is at most as long as the next":
// m - 1 for m edges, two an edge.
//
// Cost: a failure renews 3 certificates in O(log m) and asks a link-cut forest for a path. An edge
// that comes makes O(log m) comparisons. Changes of the graph beyond an edge that takes the place
// of another outside the tree repeat Kruskal's algorithm along the list, O(m alpha(m)). Not
// efficient: most exchanges in the list are of edges far apart, Theta(m^2) for m changes of the
// tree.
//
// Source: Rahmati, Zarei, "Kinetic Euclidean minimum spanning tree in the plane" (2012): the list
// and the swaps.
#ifndef KINEX_STRUCTURES_PROXIMITY_TREE_BY_LIST_H
#define KINEX_STRUCTURES_PROXIMITY_TREE_BY_LIST_H

#include <span>
#include <string_view>
#include <vector>

#include "structures/parts/kinetic_list.h"
#include "structures/proximity/tree_engine.h"

namespace kinex {

class TreeByList final : public TreeEngine {
  auto tied() {
    return [this](Item before, Item after) {
      events_->tied(ids(before), ids(after));
      exchanged(before, after);
    };
  }

 public:
  TreeByList(Kernel& kernel, StructureId id, const TreeEdges& edges, TreeEvents& events,
             std::size_t vertices)
      : TreeEngine(kernel, id, edges, events, vertices),
        list_(kernel, id, "edges", EdgeOrder(edges)) {}

  std::string_view inside_kind() const override { return "order"; }
  void build(std::vector<Item> items) override;
  void add(Item item) override;
  void remove(Item item) override;
  void finish(Change change) override;
  bool owns(CertificateId certificate) const override { return list_.slots().owns(certificate); }
  void certificate_failed(CertificateId failed) override;
  void motions_changed(std::span<const ObjectId> objects) override {
    list_.motions_changed(objects, tied());
  }
  void renew(std::span<const Item> items) override { list_.renew(items, tied()); }
  void visit_proof(ProofVisitor& visitor) const override;
  Integer most_certificates(std::size_t edges, std::size_t vertices) const override;
  std::string_view why_most() const override { return "a list of all edges"; }
  void check(AuditReport& report) const override;
  std::size_t bytes() const override { return base_bytes() + list_.bytes(); }

 private:
  std::vector<bool> chosen() const;
  void grow();
  void exchanged(Item before, Item after);

  KineticList<EdgeOrder> list_;
};

}  // namespace kinex

#endif
