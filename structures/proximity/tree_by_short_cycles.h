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
// Certificates. One for every edge f outside the tree and every other edge e of the cycle of f: "e is
// at most as long as f".
//
// Why it is right. Lengths, and TreeEdges::goes_first where they are identically equal, are a total
// order of the edges, so the minimum spanning forest is unique, and all edges outside the tree are
// outside it. The tree spans the graph, so it is this forest.
//
// Repairs. Right after a failure of (e, f) edge e is longer than f.
//   e is an edge of the tree on the path between the ends of f: f takes its place. e is the longest
//     edge of the cycle of f now: its records become those of e. Cycles through e stay what they are.
//   Otherwise f is proved anew: by a triangle; or by its cycle with the rest of the cycle of e in
//     place of e, since all edges of that are shorter than e; or by its path in the tree. The failure
//     is internal.
// If no other certificate fails at the instant, an edge e of the tree is on the path: the path is the sum
// (modulo 2) of the paths of the edges of the cycle, and of the others none contains e, since all
// of their edges are shorter than e.
//
// An edge that comes is proved by a triangle, by its path, or is in the tree. An edge that leaves the
// graph leaves its cycles: their owners are proved anew, as after a failure. If it is in the tree the
// shortest edge across its cut takes its place first. That edge has a record of it: its cycle crosses
// the cut an even number of times, and every other edge across the cut is longer.
//
// Cost, for n vertices and m edges: at most (m - n + 1)(n - 1) certificates. In a Delaunay
// triangulation most edges outside the tree are the longest of a triangle. A failure renews one cycle.
// The paths of the tree are read where no triangle is found and no cycle of e serves, and where several
// changes are made at one instant. Only then is the link-cut forest brought up to date.
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
  static constexpr std::size_t kLongest = 40;  // edges of a cycle that is made of two, less one

  EdgeOrder order() const { return EdgeOrder(*edges_); }
  bool is_shorter(Item a, Item b) const { return in_front(*kernel_, order(), a, b); }
  LinkCutForest& forest();
  bool is_on_path(Item item, Item outside);
  void enter_graph(Item item);
  // ---- cycles: each of these makes cycle_ the other edges of a cycle of `outside`
  bool find_triangle(Item outside, Item longer);
  void find_shortest(Item outside);
  bool join_cycles(Item outside, Item gone);
  void make_simple(Item outside);
  void make_shorter(Item outside, Item gone);
  void find_path(Item outside);
  void find_cycle_without(Item outside, Item gone);
  Item edge_between(std::uint32_t u, std::uint32_t v) const;
  void prove(Item outside, Place stale);
  void hand_over(Item after, Item before);
  // ---- the tree
  void put_in_late(Item item);
  void take_out_late(Item item);
  void swap(Item before, Item after);
  void repair(Place place, bool is_alone);
  Item replacement_of(Item item);
  void settle_ties();
  void settle_failures();

  const AdjacentEdges* adjacent_;
  // (inside, outside): `inside` is another edge of the cycle of `outside`.
  CycleRecords records_;
  LateLinks late_;
  std::vector<std::uint8_t> marks_;  // by item, between calls 0
  // Scratch.
  std::vector<Item> cycle_, walk_, owners_;
  std::vector<Item> from_;  // by vertex, between calls kNoItem: the edge that a search came by
  std::vector<std::uint32_t> passed_;
  std::vector<Place> own_;
};

}  // namespace kinex

#endif
