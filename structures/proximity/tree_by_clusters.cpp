// SPDX-License-Identifier: GPL-3.0-or-later
// The tree and the edges outside it; tree_by_clusters_proof.cpp has what proves them.
#include "structures/proximity/tree_by_clusters.h"

#include <algorithm>
#include <utility>

#include "core/engine/bound.h"
#include "structures/parts/merge_sort.h"

namespace kinex {

TreeByClusters::TreeByClusters(Kernel& kernel, StructureId id, const TreeEdges& edges,
                               TreeEvents& events, std::size_t vertices, std::size_t size)
    : TreeEngine(kernel, id, edges, events, vertices),
      size_(size),
      extrema_(kernel, id, edges),
      clusters_(vertices),
      outside_at_(vertices) {}

// ---- edges come and go

void TreeByClusters::build(std::vector<Item> items) {
  extrema_.clear();
  clusters_.clear();
  interiors_.clear();
  ways_.clear();
  between_.clear();
  between_nodes_.clear();
  pairs_.clear();
  outside_.clear();
  for (auto& some : outside_at_) some.clear();
  waiting_.clear();
  largest_size_ = 0;
  clear();
  const EdgeOrder order(*edges_);
  merge_sort(items, [&](Item a, Item b) { return in_front(*kernel_, order, a, b); });
  for (const Item item : items) add(item);
  finish(Change::kSized);
}

void TreeByClusters::add(Item item) {
  enter(item);
  if (outside_.size() <= item) outside_.resize(item + std::size_t{1});
  const auto [u, v] = edges_->ends(item);
  if (forest_.connected(u, v)) {
    keep_out(item);
  } else {
    join(item);
  }
}

void TreeByClusters::remove(Item item) {
  if (in_tree(item)) {
    part(item);
    const Item other = replacement_of(item);
    if (other != kNoItem) {
      detach(other);
      join(other);
    }
  } else {
    detach(item);
  }
  leave(item);
}

void TreeByClusters::finish(Change change) {
  mend();
  settle_ties();
  if (change == Change::kSized) settle_failures();
  extrema_.forget_failing();  // they fail next
}

// The clusters of its ends.
TreeByClusters::Pair TreeByClusters::pair_of(Item item) const {
  const auto [a, b] = outside_[item].ends;
  return {std::min(clusters_.of(a), clusters_.of(b)), std::max(clusters_.of(a), clusters_.of(b))};
}

// An edge becomes one of the tree, or ceases to be one.
void TreeByClusters::join(Item item) {
  const auto [u, v] = edges_->ends(item);
  const Copy a = clusters_.hook(u);
  touch(a);
  const Copy b = clusters_.hook(v);
  touch(b);
  put_in(item);
  clusters_.link(item, a, b);
}

void TreeByClusters::part(Item item) {
  for (const Copy end : clusters_.ends(item)) touch(end);
  take_out(item);
  clusters_.cut(item);
}

// An edge is one outside the tree, and waits for its bounds.
void TreeByClusters::keep_out(Item item) {
  for (const Vertex end : edges_->ends(item)) outside_at_[end].push_back(item);
  outside_[item].place = Place::kWaits;
  waiting_.push_back(item);
}

// It is one no more.
void TreeByClusters::detach(Item item) {
  const auto [u, v] = edges_->ends(item);
  if (outside_[item].place == Place::kDone) {
    const auto found = pairs_.find(pair_of(item));
    if (found != pairs_.end()) {
      Between& between = found->second;
      if (between.bound != EdgeExtrema::kNone) extrema_.drop(between.bound);
      between.bound = EdgeExtrema::kNone;
      between.group.take_out(extrema_, item);
      if (between.group.size() == 0) pairs_.erase(found);
    }
  }
  unbind(item);
  outside_[item].place = Place::kNone;
  for (const Vertex end : {u, v}) std::erase(outside_at_[end], item);
}

void TreeByClusters::unbind(Item item) {
  for (const Node bound : outside_[item].bounds) extrema_.drop(bound);
  outside_[item].bounds.clear();
}

// ---- the tree

void TreeByClusters::swap(Item before, Item after) {
  detach(after);
  part(before);
  join(after);
  keep_out(before);
  mend();
}

// The shortest edge right after now that connects the two parts of a tree which an edge has left;
// kNoItem: there is none.
Item TreeByClusters::replacement_of(Item item) const {
  std::vector<bool> seen(vertices_, false);
  std::vector<Vertex> part{edges_->ends(item)[0]};
  seen[part[0]] = true;
  for (std::size_t i = 0; i < part.size(); ++i) {
    for (const Copy copy : clusters_.copies(part[i])) {
      for (const Item edge : clusters_.edges(copy)) {
        const Vertex next = clusters_.vertex(clusters_.other(edge, copy));
        if (seen[next]) continue;
        seen[next] = true;
        part.push_back(next);
      }
    }
  }
  Item best = kNoItem;
  for (const Vertex v : part) {
    for (const Item outside : outside_at_[v]) {
      const auto [a, b] = edges_->ends(outside);
      if (seen[a] && seen[b]) continue;
      const EdgeOrder order(*edges_);
      if (best == kNoItem || in_front(*kernel_, order, outside, best)) best = outside;
    }
  }
  return best;
}

// Of level edges the one that goes first is in the tree.
void TreeByClusters::settle_ties() {
  std::uint64_t steps = 0;
  while (const auto broken = extrema_.next_tied()) {
    if (!may_go_on(steps++)) return;
    swap(broken->shorter, broken->longer);
    events_->tied(ids(broken->shorter), ids(broken->longer));
    kernel_->settle_later(id_);
  }
}

// While points come and go nothing may be left to fail.
void TreeByClusters::settle_failures() {
  std::uint64_t steps = 0;
  while (const auto broken = extrema_.next_failing()) {
    if (!may_go_on(steps++)) return;
    swap(broken->shorter, broken->longer);
    settle_ties();
  }
}

void TreeByClusters::certificate_failed(CertificateId failed) {
  const EdgeExtrema::Failure failure = extrema_.failed(failed);
  if (failure.bound) swap(failure.before, failure.after);
  extrema_.forget_failing();  // they fail next
  events_->repaired(ids(failure.before), ids(failure.after));
  settle_ties();
}

void TreeByClusters::motions_changed(std::span<const ObjectId> objects) {
  extrema_.motions_changed(objects);
  settle_ties();
  extrema_.forget_failing();
}

void TreeByClusters::renew(std::span<const Item> items) {
  extrema_.renew(items);
  settle_ties();
  extrema_.forget_failing();  // they fail next
}

// ---- checks

void TreeByClusters::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  extrema_.each([&](Node node, EdgeExtrema::Kind kind, Item shorter, Item longer,
                    CertificateId certificate) {
    using Kind = EdgeExtrema::Kind;
    group.kind = kind == Kind::kLongest    ? "longest edge of a path"
                 : kind == Kind::kShortest ? "shortest edge between two clusters"
                                           : "edge outside the tree";
    group.about = about(std::array{kind == Kind::kShortest ? shorter : longer});
    group.place = node;
    visitor.group(group);
    visitor.certificate(certificate, kind == Kind::kLongest    ? "longer than another edge"
                                     : kind == Kind::kShortest ? "shorter than another edge"
                                                               : "longer than its path");
  });
}

Integer TreeByClusters::most_certificates(std::size_t edges, std::size_t vertices) const {
  std::size_t levels = 1;
  while ((vertices >> levels) > 0) ++levels;
  return counted(3 * edges) + counted(vertices) * counted(levels + widest_) +
         counted(2 * widest_) * counted(widest_);
}

Integer TreeByClusters::most_failures_per_exchange() const {
  std::size_t levels = 1;
  while ((vertices_ >> levels) > 0) ++levels;
  return counted(3 + levels + widest_) + counted(2 * widest_) * counted(widest_);
}

// The bounds of an edge, and that of its two clusters, are about the edges of its path.
void TreeByClusters::check_outside(Item item, LinkCutForest& forest, AuditReport& report) const {
  const auto [u, v] = edges_->ends(item);
  const auto [a, b] = outside_[item].ends;
  report.check(clusters_.vertex(a) == u && clusters_.vertex(b) == v,
               [] { return "an edge between other vertices"; });
  std::vector<Item> path = forest.path(u, v), proved;
  const auto collect = [&](Node bound) {
    for (const Item edge : extrema_.edges_of(Value::of_node(bound))) proved.push_back(edge);
  };
  for (const Node bound : outside_[item].bounds) collect(bound);
  if (const Pair pair = pair_of(item); pair[0] != pair[1] && !shares_vertex(pair)) {
    const auto between = pairs_.find(pair);
    const auto edges = between == pairs_.end() ? std::vector<Item>() : between->second.group.edges();
    report.check(std::count(edges.begin(), edges.end(), item) == 1,
                 [] { return "an edge that is not in its group"; });
    if (between == pairs_.end() || between->second.bound == EdgeExtrema::kNone) {
      return report.check(false, [] { return "a group without a bound"; });
    }
    collect(between->second.bound);
    for (const Item other : edges) std::erase(proved, other);
  }
  std::erase(proved, item);
  std::sort(path.begin(), path.end());
  std::sort(proved.begin(), proved.end());
  report.check(path == proved, [] { return "a cycle is not proved"; });
}

void TreeByClusters::check(AuditReport& report) const {
  extrema_.check(report);
  const std::string defect = clusters_.defect();
  report.check(defect.empty(), [&] { return defect; });
  report.check(clusters_.count() <= most_clusters(), [] { return "too many clusters"; });
  report.check(clusters_.largest() < 2 * std::max<std::size_t>(1, largest_size_),
               [] { return "a cluster of too many vertices"; });
  report.check(largest_size_ <= 2 * size_now(), [] { return "clusters for more vertices"; });
  if (!defect.empty()) return;
  LinkCutForest forest = forest_;
  for (const Item item : present()) {
    const auto [u, v] = edges_->ends(item);
    if (!forest.connected(u, v)) {
      report.check(false, [] { return "the ends of an edge are not connected"; });
    } else if (in_tree(item)) {
      report.check(forest.path(u, v) == std::vector<Item>{item},
                   [] { return "the forest lacks an edge"; });
    } else {
      report.check(outside_[item].place == Place::kDone, [] { return "an edge that waits"; });
      check_outside(item, forest, report);
    }
  }
}

std::size_t TreeByClusters::bytes() const {
  std::size_t total = base_bytes() + extrema_.bytes() + clusters_.bytes() +
                      outside_.capacity() * sizeof(Outside) +
                      waiting_.capacity() * sizeof(Item) +
                      ways_.size() * ways_.size() * (sizeof(Way) + sizeof(Value));
  for (const auto& some : outside_at_) total += sizeof(some) + some.capacity() * sizeof(Item);
  for (const auto& [pair, between] : pairs_) {
    total += sizeof(Pair) + sizeof(Between) + 48 + between.group.bytes();
  }
  for (const Interior& interior : interiors_) {
    for (const auto& some : interior.from_portal) total += some.capacity() * sizeof(Value);
    for (const auto& some : interior.centroids) total += some.capacity() * sizeof(ToCentroid);
  }
  return total;
}

}  // namespace kinex
