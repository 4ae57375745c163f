// SPDX-License-Identifier: GPL-3.0-or-later
// TreeByClusters: the minimum spanning forest of a changing graph, by tournaments of groups of edges.
//
// The forest is cut into connected clusters (tree_clusters.h), between which a vertex of many edges
// may be split into copies. A portal is a copy that is not the only one of its vertex, or that has an
// edge to another cluster. An edge f between u and v, outside the tree, is at least as long as those
// of the path between its ends, of which there are three pieces:
//
//      cluster A            clusters between          cluster B
//      u --- ... --- a ===== ... ===== ... ===== b --- ... --- v       a, b: portals
//      |             |                           |             |
//      |  M_a(u)     |       W(A, B)             |    M_b(v)   |
//      +------------------------- f ---------------------------+
//
// Nodes, each with one certificate (edge_extrema.h):
//   M_a(u)   the longest edge between a portal a and a vertex u of its cluster: that of the vertex
//            before u, or the last edge;
//   M_c(u)   the same for the centroid c of a cluster, of the parts that it leaves, and so on;
//   W(A, B)  the longest edge between two clusters: that between A and the cluster before B, the
//            longest within that one, and the edge into B, unless B shares a vertex with it. If A and
//            B share one, there is none;
//   S(A, B)  the shortest of the edges outside the tree between two clusters, by a tournament.
// Bounds: W(A, B) <= S(A, B) for each two clusters with such edges and a W; M_a(u) <= f and
// M_b(v) <= f; for an f within a cluster M_c(u) <= f and M_c(v) <= f, c being the first centroid that
// separates u from v. An end of f that is split may be any of its copies: it is the one in a cluster of
// the other end, if there is one, else that whose number among c copies is f modulo c.
//
// A failure of a node is internal: another extremum, which is handed on to the nodes that use it.
// One of a bound is a change of the tree: f takes the place of the edge. Then the clusters of their
// ends are dissolved and cut anew, and W with them.
//
// Quality, for n vertices, m edges, k clusters of about z vertices (z = n^(2/3), if not given):
//   certificates  at most 3m + n (floor(log2 n) + 1) + n k + 2 k^2: the edges within clusters are one
//                 fewer in each than its members, copies among them, and at most n in all
//   a cluster     at most 4z - 1 members; 2z - 1 if z is given
//   a change      O(z (p + log n) + k^2) certificates for clusters of at most p portals, those of the
//                 edges outside the tree at the vertices of four clusters, and of those between
//                 clusters whose path comes by other portals
// The forest is cut anew as a whole where there are more than 3 (n / z + 1) clusters, and one for
// each tree; and where z is less than half of what it was in some cut since.
//
// Source: after Agarwal, Eppstein, Guibas, Henzinger, "Parametric and kinetic minimum spanning trees"
// (1998): O(n^(2/3) log^(4/3) n) for a change of the tree. The layout is ours, after Frederickson's.
#ifndef KINEX_STRUCTURES_PROXIMITY_TREE_BY_CLUSTERS_H
#define KINEX_STRUCTURES_PROXIMITY_TREE_BY_CLUSTERS_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "structures/proximity/edge_extrema.h"
#include "structures/proximity/edge_group.h"
#include "structures/proximity/tree_clusters.h"
#include "structures/proximity/tree_engine.h"

namespace kinex {

class TreeByClusters final : public TreeEngine {
 public:
  // `size`: of the clusters; 0: n^(2/3), n being the number of vertices with edges.
  TreeByClusters(Kernel& kernel, StructureId id, const TreeEdges& edges, TreeEvents& events,
                 std::size_t vertices, std::size_t size);

  std::string_view inside_kind() const override { return "extremum"; }
  void build(std::vector<Item> items) override;
  void add(Item item) override;
  void remove(Item item) override;
  void finish(Change change) override;
  bool owns(CertificateId certificate) const override { return extrema_.owns(certificate); }
  void certificate_failed(CertificateId failed) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void renew(std::span<const Item> items) override;
  // Nodes that compare two edges: one for each portal, each centroid and each two clusters, and one of
  // a group. Bounds fail for swaps alone, each of which lowers a rank in the tree: at most twice.
  Integer most_failures_per_exchange() const override;
  void visit_proof(ProofVisitor& visitor) const override;
  Integer most_certificates(std::size_t edges, std::size_t vertices) const override;
  std::string_view why_most() const override {
    return "three an edge, the paths to portals and centroids, and those between clusters";
  }
  void check(AuditReport& report) const override;
  std::size_t bytes() const override;

 private:
  using Value = EdgeExtrema::Value;
  using Node = EdgeExtrema::Node;
  using Vertex = TreeClusters::Vertex;
  using Copy = TreeClusters::Copy;
  using Cluster = TreeClusters::Cluster;
  using Pair = std::array<Cluster, 2>;  // ascending

  struct ToCentroid {  // of a vertex, for a centroid of a part that it is in
    Copy centroid;
    Value longest;
  };
  struct Interior {  // of a cluster
    std::vector<Copy> portals;
    std::vector<std::vector<Value>> from_portal;     // by portal, then by place: the longest edge
    std::vector<std::vector<ToCentroid>> centroids;  // by place, the largest part first
    std::vector<Node> nodes;                         // in the order in which they were made
  };
  struct Way {  // from one cluster to another
    Copy out = 0, into = 0;                // the portals of the first and of the last one
    Cluster before = TreeClusters::kNone;  // the last but one; none: no way, or the same cluster
    Copy across = 0;                       // its portal, to the last one
    Item edge = kNoItem;                   // between the last two; none: a virtual one
  };
  struct Between {  // two clusters
    EdgeGroup group;
    Node bound = EdgeExtrema::kNone;  // none: to be made
    Copy out = 0, into = 0;           // the portals by which the paths of its edges come
  };
  enum class Place : std::uint8_t { kNone, kWaits, kDone };
  struct Outside {  // an edge that is not in the tree
    Place place = Place::kNone;
    std::array<Copy, 2> ends{};  // unless it waits
    std::vector<Node> bounds;  // of this edge alone
  };

  std::size_t size_now() const;
  std::size_t most_clusters() const;
  // ---- dissolving
  void drop_between();
  void touch(Copy copy);
  void unbind(Item item);
  void keep_out(Item item);
  void detach(Item item);
  void join(Item item);
  void part(Item item);
  // ---- making
  void mend();
  void gather();
  void make_interior(Cluster cluster);
  void make_centroids(Cluster cluster);
  void find_ways();
  Value longest_between(Cluster a, Cluster b);
  Value longer(const Value& one, const Value& other, std::vector<Node>& nodes);
  const Value& from_portal(Cluster cluster, Copy portal, Copy copy) const;
  void hang(Item item);
  void bind(Item item);
  std::array<Value, 2> ends_of(Item item) const;
  Pair pair_of(Item item) const;
  bool shares_vertex(const Pair& pair) const;
  // ---- the tree
  void swap(Item before, Item after);
  Item replacement_of(Item item) const;
  void settle_ties();
  void settle_failures();
  void check_outside(Item item, LinkCutForest& forest, AuditReport& report) const;

  std::size_t size_;
  EdgeExtrema extrema_;
  TreeClusters clusters_;
  std::vector<Interior> interiors_;              // by cluster
  std::vector<std::vector<Way>> ways_;           // by two clusters
  std::vector<std::vector<Value>> between_;      // W, by two clusters; none: not made
  std::vector<Node> between_nodes_;              // in the order in which they were made
  std::map<Pair, Between> pairs_;                // with edges outside the tree between them
  std::vector<Outside> outside_;                 // by edge
  std::vector<std::vector<Item>> outside_at_;    // by vertex
  std::vector<Item> waiting_;                    // edges that may wait for their bounds
  std::size_t widest_ = 0;                       // the most clusters so far
  std::size_t largest_size_ = 0;                 // since the forest was cut as a whole
};

}  // namespace kinex

#endif
