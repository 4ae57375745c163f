// SPDX-License-Identifier: GPL-3.0-or-later
// EmstCycles: the Euclidean minimum spanning tree of moving points, without an order of the edges.
//
// It watches the triangulation (delaunay_2, or delaunay_3 in space). A Delaunay edge that is not in
// the tree closes a cycle with the tree's path between its ends, and is the longest edge of it:
//
//         b ---- c
//        /        \         f = ad is not in the tree:
//       a - - f - - d       f >= ab, f >= bc, f >= cd
//
// Certificates. One for every edge f outside the tree and every edge e on its path: "e is at most
// as long as f", degree 2d for motions of degree d. When one fails, f takes the place of e: every
// failure is a change of the tree. (See emst_list.h for why Delaunay edges suffice, and why a flip
// does not change the tree.)
//
// Quality, for n points: as many certificates as the paths have edges together, O(n) to Theta(n^2);
// on random points a few dozen an edge. Not local, not compact; strongly efficient: no failure is
// internal. A failure renews the paths of all edges that cross the cut between the two parts of the
// tree, O(log n) for each plus the differences. A flip drops one path and proves another one.
//
// Ties. Of edges whose lengths are identically equal the lexicographically smaller one counts as
// the shorter, so the tree is unique. Points that are identically equal are a star around the
// smallest id.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7: the tree
// and its changes. The certificates are those of Tarjan's verification of a spanning tree (1979).
#ifndef KINEX_STRUCTURES_PROXIMITY_EMST_CYCLES_H
#define KINEX_STRUCTURES_PROXIMITY_EMST_CYCLES_H

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "structures/parts/link_cut_forest.h"
#include "structures/parts/slots.h"
#include "structures/proximity/delaunay_edges.h"
#include "structures/proximity/edge_lengths.h"
#include "structures/proximity/tree_events.h"

namespace kinex {

class EmstCycles final : public Structure {
 public:
  // kSwap: the tree's edge that is gone, its ends, and the one that came. External.
  // kExchange: the same for one of several changes of an instant, which are told when it is over.
  // kTie: the same, because the lengths have become identically equal.
  enum Kind : std::uint8_t { kSwap, kExchange, kTie };

  // `triangulation` outlives this structure and is watched by it.
  EmstCycles(Kernel& kernel, StructureId id, const DelaunayGraph& triangulation);

  std::string_view name() const override { return "emst_cycles"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"swap", "exchange", "tie"});
  }
  void build(std::span<const ObjectId>) override { begin(); }
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  // Points come and go in the triangulation.
  void insert(ObjectId) override { begin(); }
  void erase(ObjectId) override { begin(); }
  void motions_changed(std::span<const ObjectId> objects) override;
  // The triangulation may have changes that it has not reported yet.
  void instant_settled() override {
    if (kernel_->instant_is_shared(triangulation_.id())) watched_changed(nullptr);
  }
  void instant_over() override { events_.over(); }
  void watched_changed(const Event* event) override;
  Attribute attribute() const override;
  Attribute told() const override { return events_.told(attribute()); }
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override;

 private:
  using Edge = EdgeLengths::Edge;
  using Place = std::uint32_t;  // of a record; the tag of its certificate

  struct Record {  // `inside`, an edge of the tree, is on the path between the ends of `outside`
    Item inside = kNoItem, outside = kNoItem;
    CertificateId certificate = kNoCertificate;
  };

  void begin();
  void add(const Edge& edge);
  void remove(const Edge& edge);
  void assign();
  void replace(Item before, Item after);
  void swap(Item before, Item after);
  void put_in(Item item);
  void take_out(Item item);
  bool in_tree(Item item) const { return in_tree_[item]; }
  void prove(Item outside);
  void add_record(Item inside, Item outside);
  void drop_record(Place place);
  void drop_records(Item item);
  Item replacement_of(Item item) const;
  bool may_go_on(std::uint64_t steps);
  void settle_ties();
  void settle_failures();

  Kernel* kernel_;
  StructureId id_;
  DelaunayGraph triangulation_;
  Slots slots_;
  EdgeLengths lengths_;
  LinkCutForest forest_;
  std::vector<bool> in_tree_;               // by item
  std::vector<std::vector<Place>> places_;  // by item: the records that name it
  std::vector<Record> records_;
  std::vector<Place> free_;
  // Records whose certificates were identically zero, or negative right after now, when they were
  // made. They may have changed since.
  std::vector<Place> tied_, failing_;
  TreeEvents events_;
};

}  // namespace kinex

#endif
