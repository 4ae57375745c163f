// SPDX-License-Identifier: GPL-3.0-or-later
// TreeByCycles: the minimum spanning forest of a changing graph, without an order of its edges.
//
// An edge that is not in the tree closes a cycle with the tree's path between its ends, and is the
// longest edge of that cycle:
//
//         b ---- c
//        /        \         f = ad is not in the tree:
//       a - - f - - d       f >= ab, f >= bc, f >= cd
//
// Certificates. One for every edge f outside the tree and every edge e on its path: "e is at most
// as long as f". When one fails, f takes the place of e: every failure is a change of the tree.
//
// Cost: as many certificates as the paths have edges together: for n vertices and m edges at most
// (m - n + 1)(n - 1). Not local, not compact; strongly efficient: no failure is internal. A failure
// renews the paths of all edges that cross the cut between the two parts of the tree: where f takes
// the place of e, each of them is exchanged along the cycle of f, edges that were on it for those that
// were not. So the cost is that of the lengths of these paths and of the cycle. An edge that takes the
// place of another drops one path and proves another one. An edge of the tree that goes is replaced by
// the shortest that crosses its cut.
//
// Source: Tarjan's verification of a spanning tree (1979): the certificates.
#ifndef KINEX_STRUCTURES_PROXIMITY_TREE_BY_CYCLES_H
#define KINEX_STRUCTURES_PROXIMITY_TREE_BY_CYCLES_H

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "structures/proximity/cycle_records.h"
#include "structures/proximity/tree_engine.h"

namespace kinex {

class TreeByCycles final : public TreeEngine {
 public:
  TreeByCycles(Kernel& kernel, StructureId id, const TreeEdges& edges, TreeEvents& events,
               std::size_t vertices)
      : TreeEngine(kernel, id, edges, events, vertices), records_(kernel, id, edges) {}

  std::string_view inside_kind() const override { return "exchange"; }
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
    return "the edges outside the tree, with paths of at most n - 1 edges";
  }
  void check(AuditReport& report) const override;
  std::size_t bytes() const override;

 private:
  using Place = CycleRecords::Place;
  using Record = CycleRecords::Record;

  EdgeOrder order() const { return EdgeOrder(*edges_); }
  std::vector<Item> replace(Item before, Item after);
  void swap(Item before, Item after);
  void exchange_along(std::span<const Item> cycle, Item outside);
  void prove(Item outside);
  Item replacement_of(Item item) const;
  void settle_ties();
  void settle_failures();

  // (inside, outside): `inside`, an edge of the tree, is on the path between the ends of `outside`.
  CycleRecords records_;
  enum Mark : std::uint8_t { kNotOnCycle, kOnCycle, kOnCycleAndPath };
  std::vector<Mark> marks_;  // by item, between exchanges kNotOnCycle
  std::vector<Place> gone_;  // of exchange_along
};

}  // namespace kinex

#endif
