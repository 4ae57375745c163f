// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/emst_list.h"

#include <algorithm>

#include "structures/proximity/spanning_tree.h"

namespace kinex {

EmstList::EmstList(Kernel& kernel, StructureId id, const DelaunayGraph& triangulation)
    : kernel_(&kernel),
      id_(id),
      triangulation_(triangulation),
      list_(kernel, id, "edges", EdgeLengths(kernel, triangulation.dimension())),
      forest_(triangulation.objects()),
      events_(kernel, id, triangulation.id(), kSwap, kOrder) {}

// ---- the edges

void EmstList::add(const Edge& edge) {
  if (list_.claims().find(edge) != kNoItem) return;
  const Item item = list_.claims().add(edge);
  if (in_tree_.size() <= item) in_tree_.resize(item + std::size_t{1}, false);
  in_tree_[item] = false;
  list_.insert(item, tied());
}

void EmstList::remove(const Edge& edge) {
  const Item item = list_.claims().find(edge);
  if (item == kNoItem) return;
  if (in_tree(item)) take_out(item);
  list_.erase(item, tied());
  list_.claims().remove(item);
}

// The list becomes that of the triangulation's edges.
void EmstList::assign() {
  const std::vector<Edge> wanted = triangulation_.edges();
  std::vector<Edge> gone;
  for (const auto& [edge, item] : list_.claims().items()) {
    if (!std::binary_search(wanted.begin(), wanted.end(), edge)) gone.push_back(edge);
  }
  for (const Edge& edge : gone) remove(edge);
  if (list_.size() != 0) {
    for (const Edge& edge : wanted) add(edge);
    return;
  }
  for (const Edge& edge : wanted) list_.claims().add(edge);
  rebuild_list();
}

// All comparisons anew: O(n log n).
void EmstList::rebuild_list() {
  std::vector<Item> items;
  for (const auto& [edge, item] : list_.claims().items()) {
    if (in_tree_.size() <= item) in_tree_.resize(item + std::size_t{1}, false);
    items.push_back(item);
  }
  list_.build(std::move(items), tied());
}

// ---- the tree

void EmstList::put_in(Item item) {
  const Edge edge = list_.claims().edge(item);
  in_tree_[item] = true;
  forest_.link(item, edge[0], edge[1]);
  events_.came(edge);
}

void EmstList::take_out(Item item) {
  const Edge edge = list_.claims().edge(item);
  in_tree_[item] = false;
  forest_.cut(item, edge[0], edge[1]);
  events_.gone(edge);
}

// Kruskal's algorithm along the list.
void EmstList::grow_tree() {
  const std::vector<Item> items = list_.items();
  std::vector<Edge> edges;
  edges.reserve(items.size());
  for (const Item item : items) edges.push_back(list_.claims().edge(item));
  const std::vector<bool> chosen = kruskal(edges, triangulation_.objects());
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (in_tree(items[i]) && !chosen[i]) take_out(items[i]);
  }
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!in_tree(items[i]) && chosen[i]) put_in(items[i]);
  }
}

// `after` is in front of `before` from now on, and was behind it.
void EmstList::exchanged(Item before, Item after) {
  if (!in_tree(before) || in_tree(after)) return;
  const Edge edge = list_.claims().edge(after);
  if (!forest_.connected(edge[0], edge[1]) || !forest_.on_path(before, edge[0], edge[1])) return;
  take_out(before);
  put_in(after);
}

// ---- calls

void EmstList::begin() {
  assign();
  grow_tree();
  events_.begin();
}

void EmstList::rebuild() {
  assign();
  rebuild_list();
  grow_tree();
  events_.begin();
}

void EmstList::certificate_failed(CertificateId failed) {
  const auto [before, after] = list_.failed(failed);
  const Edge e = list_.claims().edge(before), f = list_.claims().edge(after);
  exchanged(before, after);
  events_.repaired(e, f);
  list_.settle(tied());
}

void EmstList::motions_changed(std::span<const ObjectId> objects) {
  list_.motions_changed(objects, tied());
}

// At an instant with several changes, the triangulation is read when it is settled.
void EmstList::watched_changed(const Event* event) {
  const auto change = event == nullptr ? std::nullopt : triangulation_.change(*event);
  if (change && kernel_->instant_is_shared(triangulation_.id())) {
    return kernel_->settle_later(id_);
  }
  if (change) {
    if (change->came) add(*change->came);
    if (change->gone) remove(*change->gone);
    if (events_.any()) grow_tree();  // it has lost an edge
  } else {
    assign();
    grow_tree();
  }
  // What was made now may fail now, too, when the triangulation has told its last change.
  if (events_.any() || kernel_->failure_is_due()) kernel_->settle_later(id_);
}

Attribute EmstList::attribute() const {
  Attribute result{Attribute::Shape::kTuples, {}};
  for (const auto& [edge, item] : list_.claims().items()) {
    if (in_tree(item)) result.ids.insert(result.ids.end(), edge.begin(), edge.end());
  }
  return result;
}

// ---- checks

void EmstList::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "neighbours by length";
  list_.each_link([&](Item item, Item next, CertificateId certificate) {
    group.about.clear();
    for (const Item one : {item, next}) {
      for (const ObjectId end : list_.claims().edge(one)) {
        if (std::find(group.about.begin(), group.about.end(), end) == group.about.end()) {
          group.about.push_back(end);
        }
      }
    }
    visitor.group(group);
    visitor.certificate(certificate, in_tree(item) ? "tree edge, next" : "edge, next");
  });
}

std::vector<BoundCheck> EmstList::bounds(const BoundContext& context) const {
  const std::size_t n = context.objects();
  const std::size_t edges = std::max<std::size_t>(1, triangulation_.most_edges(n));
  std::vector<BoundCheck> result{at_most("emst_list.certificates",
                                         "a list of the edges: at most 3n - 6, in space all pairs",
                                         counted(edges - 1), counted(context.ledger->max_live))};
  if (context.plain() && n > 1) result.push_back(spanning_tree_bound("emst_list", context));
  return result;
}

void EmstList::check_invariants(AuditReport& report) const {
  list_.check(report, "edges");
  std::vector<Edge> edges;
  for (const auto& [edge, item] : list_.claims().items()) edges.push_back(edge);
  report.check(edges == triangulation_.edges(),
               [] { return "it has missed a change of the edges"; });
  edges.clear();
  for (const Item item : list_.items()) edges.push_back(list_.claims().edge(item));
  const std::vector<bool> chosen = kruskal(edges, triangulation_.objects());
  LinkCutForest forest = forest_;
  std::size_t i = 0;
  for (const Item item : list_.items()) {
    report.check(in_tree(item) == chosen[i++], [] { return "another tree belongs to the list"; });
    const Edge edge = list_.claims().edge(item);
    report.check(forest.connected(edge[0], edge[1]) &&
                     in_tree(item) == forest.on_path(item, edge[0], edge[1]),
                 [] { return "the forest has other edges than the tree"; });
  }
  report.check(!events_.any(), [] { return "a change of the tree was not reported"; });
}

void EmstList::audit(const Snapshot& snapshot, AuditReport& report) const {
  report.check(static_spanning_tree(snapshot) == attribute().ids,
               [] { return "another tree is the shortest"; });
}

std::size_t EmstList::bytes() const {
  return list_.bytes() + list_.claims().bytes() + forest_.bytes() + in_tree_.capacity() / 8 +
         events_.bytes();
}

}  // namespace kinex
