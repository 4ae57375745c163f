// SPDX-License-Identifier: GPL-3.0-or-later
// TreeByShortCycles: the minimum spanning forest of a changing graph; every edge outside it is the
// longest edge of some cycle of the graph.
//
// By the cycle property an edge that is the longest of a cycle is in no minimum spanning forest. The
// other edges of that cycle need not be in the tree, so the cycle may be as short as the graph allows:
//
//         b ---- c        f = ad is outside the tree. Its path abcd in the tree is a proof with three
//        /   .    \       certificates. The triangle acd is one with two:
//       a - - f - - d     f >= ac, f >= cd
//
// Certificates. The edges of a cycle are compared in a tree with the longest one, the owner, at its top:
// one certificate for every other edge, "it is at most as long as the one above it".
//
//         f                 ac fails against f, and is longer from now on:       ac
//        / \                one certificate is reversed; cd stays below f        |
//      ac   cd                                                                   f
//                                                                                |
//                                                                                cd
//
// The graph is a Delaunay triangulation, or another one that contains the minimum spanning tree of all
// pairs of its points. So a cycle may contain pairs that are no edges, and an edge that leaves the graph
// stays in the cycles of others:
//
//         p ---- q       pr is in the cycle of f = pq, and gives way to qs. f >= pr and f >= rq still
//        / . pr .  \     say that f is not in the tree; nothing is to be done before one of them fails
//       s ---- r
//
// Why it is right. Lengths, and TreeEdges::goes_first where they are identically equal, are a total
// order of the pairs, so the minimum spanning tree of all of them is unique, and every edge outside the
// tree is outside it: it is the longest of a cycle of pairs. The tree spans the points, and has all edges
// that are left: it is that tree.
//
// Repairs. Right after a failure edge e is longer than the one above it.
//   Below the top: e is compared with the next one above from now on. The failure is internal.
//   Against the owner f, where e is an edge of the tree, on the path between the ends of f: f takes the
//     place of e. The cycle belongs to e now. All other cycles stay what they are.
//   Otherwise f is proved anew: by a triangle; or by its cycle with the rest of the cycle of e in
//     place of e, since all edges of that are shorter than e; or with two edges of a triangle at e, if e
//     has left the graph; or by its path in the tree. If the cycle of f was shorter by two edges or more,
//     e gets it. The failure is internal.
// An edge e of the tree is on the path if no other claim fails at the instant, no edge has come or left at
// it, and e and f are at it longer than all other pairs of the cycle that are outside the tree: the path is
// the sum (modulo 2) of the paths of the pairs of the cycle, and of the others none contains e, since all
// of their edges are shorter than e. A pair that is as long as e at the instant may have had e on its path
// before; if it has left the graph no claim tells. Otherwise the tree is searched.
//
// Where several certificates fail at one instant some cycles are those of the order before it, others of
// the order after it. So two edges may be in the cycles of each other. Whatever fails, the tree spans
// the graph, and every edge outside it has a cycle: when nothing fails any more the tree is the minimum
// spanning forest. That comes to pass: a repair makes the tree shorter, or an edge has fewer edges in its
// cycle that are longer than it is.
//
// An edge that comes is proved by a triangle, by its path, or is in the tree. If an edge that leaves the
// graph is in the tree, the shortest edge across its cut takes its place first. Where a point leaves, its
// edges leave all cycles: their owners are proved anew, as after a failure.
//
// Cost, for n vertices and m edges: at most (m - n + 1)(n - 1) certificates; on the Delaunay
// triangulations of 1000 or 4000 random points 7n or 8n (max live of `kinex run`, uniform-square), since
// most edges outside the tree are the longest of a triangle. A failure below the top renews one
// certificate; a change of the tree, those of the cycle if that is short, else one; a cycle that is made
// anew, those of its edges that were not below its owner before. A flip makes two, for the edge that
// comes. At n = 1000 there are 2.3 failures a flip; one in four or five changes the tree. The tree's paths
// are read where cycles grow long, and where several certificates fail at one instant: by a search from
// both ends. Only where that is long, or a new edge is in no triangle, is the link-cut forest brought up
// to date.
//
// Source: the cycle property: Tarjan, Data structures and network algorithms (1983), chapter 6: his red
// rule. Cycles that outlive changes of the tree are worked out here.
#ifndef KINEX_STRUCTURES_PROXIMITY_TREE_BY_SHORT_CYCLES_H
#define KINEX_STRUCTURES_PROXIMITY_TREE_BY_SHORT_CYCLES_H

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "structures/proximity/cycle_records.h"
#include "structures/proximity/late_links.h"
#include "structures/proximity/tree_engine.h"

namespace kinex {

class TreeByShortCycles final : public TreeEngine {
 public:
  TreeByShortCycles(Kernel& kernel, StructureId id, const AdjacentEdges& edges, TreeEvents& events,
                    std::size_t vertices)
      : TreeEngine(kernel, id, edges, events, vertices),
        adjacent_(&edges),
        records_(kernel, id, edges) {}

  std::string_view inside_kind() const override { return "cycle"; }
  void build(std::vector<Item> items) override;
  void add(Item item) override;
  void remove(Item item) override;
  void finish(Change change) override;
  bool uses(Item item) const override {
    return item < marks_.size() && !records_.uses(item).empty();
  }
  bool owns(CertificateId certificate) const override { return records_.owns(certificate); }
  void certificate_failed(CertificateId failed) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void renew(std::span<const Item> items) override;
  void visit_proof(ProofVisitor& visitor) const override;
  Integer most_certificates(std::size_t edges, std::size_t vertices) const override;
  std::string_view why_most() const override {
    return "the edges outside the tree, each the longest of a cycle of at most n edges";
  }
  void check(AuditReport& report) const override;
  std::size_t bytes() const override;

 private:
  using Place = CycleRecords::Place;
  using Record = CycleRecords::Record;
  static constexpr Place kNoPlace = 0xffffffffu;
  // Edges, without the owner, of a cycle that is made of two at most, and of one that a swap renews.
  static constexpr std::size_t kLongest = 40, kRenewed = 6;
  // Vertices that a search reaches: for a short cycle, and in the tree.
  static constexpr std::size_t kNear = 400, kFar = 4000;

  EdgeOrder order() const { return EdgeOrder(*edges_); }
  bool is_shorter(Item a, Item b) const { return in_front(*kernel_, order(), a, b); }
  LinkCutForest& forest();
  bool is_on_path(Item item, Item outside);
  void enter_graph(Item item);
  // ---- cycles: cycle_ becomes the other edges of a cycle of `outside`
  template <class Visit>
  bool any_triangle(Item edge, const Visit& visit) const;
  bool find_triangle(Item outside, Item longer);
  template <class At, class Leads>
  void search(Item outside, std::size_t most, const At& at, const Leads& leads);
  void find_short(Item outside);
  bool search_tree(Item outside);
  void walk_back(std::uint32_t vertex, Item outside);
  bool find_detour(Item outside, Item gone);
  bool join_cycles(Item outside, Item gone, bool is_sure);
  void make_simple(Item outside);
  Item next_of_walk(std::uint32_t vertex);
  void make_shorter(Item outside, Item gone);
  void find_path(Item outside);
  void find_cycle_without(Item outside, Item gone, bool is_sure);
  Item edge_between(std::uint32_t u, std::uint32_t v) const;
  // ---- records
  void prove(Item outside, Place stale);
  void hand_over(Item after, Item before);
  // ---- the tree
  void put_in_late(Item item);
  void take_out_late(Item item);
  void swap(Item before, Item after);
  bool is_longest_now(Item owner, Item before) const;
  void repair(Place place, bool is_alone);
  Item replacement_of(Item item);
  void release_vertices();
  void settle_ties();
  void settle_failures();

  const AdjacentEdges* adjacent_;
  // (inside, outside, owner): `outside` is above `inside` in the cycle of `owner`.
  CycleRecords records_;
  LateLinks late_;
  std::vector<std::vector<EdgeAt>> tree_at_;  // by vertex, its edges in the tree
  std::vector<std::uint8_t> marks_;  // by item, between calls 0
  std::uint64_t last_change_ = 0;    // the number of the instant at which an edge last came or left
  // Scratch.
  std::vector<Item> cycle_, rest_, walk_, owners_;
  struct Reached {
    Item by = kNoItem;  // the edge by which a search came
    std::uint32_t root = 0;
  };
  std::vector<Reached> reached_;  // by vertex, between calls not reached
  std::vector<std::uint32_t> passed_;
  // Of make_simple. By vertex, between calls as here: the first of its edges in waiting_, its place in
  // passed_. And lists of edges by their ends.
  struct Crossing {
    std::uint32_t first = kNoPlace, passed = kNoPlace;
  };
  struct Waiting {
    Item edge;
    std::uint32_t next;
  };
  std::vector<Crossing> crossings_;
  std::vector<Waiting> waiting_;
  std::vector<Place> own_;
};

}  // namespace kinex

#endif
