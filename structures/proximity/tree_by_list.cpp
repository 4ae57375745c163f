// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/tree_by_list.h"

#include <array>
#include <utility>

#include "core/engine/bound.h"
#include "structures/proximity/spanning_tree.h"

namespace kinex {

// ---- the edges

void TreeByList::build(std::vector<Item> items) {
  clear();
  for (const Item item : items) enter(item);
  list_.build(std::move(items), tied());
  grow();
}

void TreeByList::add(Item item) {
  enter(item);
  list_.insert(item, tied());
}

void TreeByList::remove(Item item) {
  if (in_tree(item)) take_out(item);
  list_.erase(item, tied());
  leave(item);
}

// An edge that took the place of one outside the tree is outside, too.
void TreeByList::finish(Change change) {
  if (change != Change::kSwap || events_->any()) grow();
}

// ---- the tree

// By place in the list: the edges of the tree of Kruskal's algorithm along it.
std::vector<bool> TreeByList::chosen() const {
  std::vector<std::array<std::uint32_t, 2>> ends;
  ends.reserve(list_.size());
  for (const Item item : list_.items()) ends.push_back(edges_->ends(item));
  return kruskal(ends, vertices_);
}

void TreeByList::grow() {
  const std::vector<Item> items = list_.items();
  const std::vector<bool> inside = chosen();
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (in_tree(items[i]) && !inside[i]) take_out(items[i]);
  }
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!in_tree(items[i]) && inside[i]) put_in(items[i]);
  }
}

// `after` is in front of `before` from now on, and was behind it.
void TreeByList::exchanged(Item before, Item after) {
  if (!in_tree(before) || in_tree(after)) return;
  const auto [u, v] = edges_->ends(after);
  if (!forest_.connected(u, v) || !forest_.on_path(before, u, v)) return;
  take_out(before);
  put_in(after);
}

void TreeByList::certificate_failed(CertificateId failed) {
  const auto [before, after] = list_.failed(failed);
  exchanged(before, after);
  events_->repaired(ids(before), ids(after));
  list_.settle(tied());
}

// ---- checks

void TreeByList::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "neighbours by length";
  list_.each_link([&](Item item, Item next, CertificateId certificate) {
    group.about = about(std::array{item, next});
    visitor.group(group);
    visitor.certificate(certificate, in_tree(item) ? "tree edge, next" : "edge, next");
  });
}

Integer TreeByList::most_certificates(std::size_t edges, std::size_t) const {
  return counted(edges == 0 ? 0 : edges - 1);
}

void TreeByList::check(AuditReport& report) const {
  list_.check(report, "edges");
  report.check(list_.size() == size(), [] { return "edges that are not in the list"; });
  const std::vector<bool> inside = chosen();
  LinkCutForest forest = forest_;
  std::size_t i = 0;
  for (const Item item : list_.items()) {
    report.check(in_tree(item) == inside[i++], [] { return "another tree belongs to the list"; });
    const auto [u, v] = edges_->ends(item);
    report.check(forest.connected(u, v) && in_tree(item) == forest.on_path(item, u, v),
                 [] { return "the forest has other edges than the tree"; });
  }
}

}  // namespace kinex
