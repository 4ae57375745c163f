// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/tree_by_forests.h"

#include <algorithm>
#include <utility>

#include "core/engine/bound.h"
#include "structures/proximity/tree_by_cycles.h"

namespace kinex {
namespace {

constexpr std::size_t kMostGroups = 120;  // a structure has 255 parts at most

}  // namespace

TreeByForests::TreeByForests(Kernel& kernel, StructureId id, const TreeEdges& edges,
                             TreeEvents& events, std::size_t vertices, std::size_t items)
    : TreeEngine(kernel, id, edges, events, vertices),
      group_(std::max({vertices, (items + kMostGroups - 1) / kMostGroups, std::size_t{1}})),
      nodes_(2 * std::max<std::size_t>(1, (items + group_ - 1) / group_)) {
  for (std::size_t v = 1; v < nodes_.size(); ++v) {
    nodes_[v].changes = std::make_unique<Changes>(kernel, id, events);
    nodes_[v].engine =
        std::make_unique<TreeByCycles>(kernel, id, edges, *nodes_[v].changes, vertices);
  }
}

std::vector<Item> TreeByForests::edges_of(std::size_t v) const {
  std::vector<Item> result;
  const auto take = [&](const Node& node) {
    for (const Item item : node.engine->tree()) result.push_back(item);
  };
  if (v >= groups()) {
    for (const Item item : present()) {
      if (leaf_of(item) == v) result.push_back(item);
    }
  } else {
    take(nodes_[2 * v]);
    take(nodes_[2 * v + 1]);
    std::sort(result.begin(), result.end());
  }
  return result;
}

// ---- changes

// What has changed in the forest of a node changes the edges of the node above, or the tree: first
// those that come, since they may have to take the place of others.
void TreeByForests::pass_on(std::size_t v, Change change) {
  const AttributeDifference net = nodes_[v].changes->net();
  nodes_[v].changes->begin();
  if (net.gone.empty() && net.came.empty()) return;
  if (v == 1) {
    for (const Item item : net.gone) {
      if (in_tree(item)) take_out(item);
    }
    for (const Item item : net.came) put_in(item);
    return;
  }
  TreeEngine& above = *nodes_[v / 2].engine;
  for (const Item item : net.came) above.add(item);
  for (const Item item : net.gone) above.remove(item);
  above.finish(change);
}

void TreeByForests::pass_up(std::size_t v, Change change) {
  for (; v > 0; v /= 2) pass_on(v, change);
}

void TreeByForests::build(std::vector<Item> items) {
  clear();
  for (const Item item : items) enter(item);
  for (std::size_t v = nodes_.size(); v-- > 1;) {
    nodes_[v].engine->build(edges_of(v));
    nodes_[v].changes->begin();
  }
  for (const Item item : nodes_[1].engine->tree()) put_in(item);
}

// The nodes above are changed by finish().
void TreeByForests::add(Item item) {
  enter(item);
  nodes_[leaf_of(item)].engine->add(item);
}

// An edge of a graph, which goes by an erasure alone, may be in many nodes: it is taken out of each,
// the lowest first.
void TreeByForests::remove(Item item) {
  const std::size_t leaf = leaf_of(item);
  nodes_[leaf].engine->remove(item);
  nodes_[leaf].engine->finish(Change::kSized);
  pass_up(leaf, Change::kSized);
  leave(item);
}

void TreeByForests::finish(Change change) {
  for (std::size_t v = nodes_.size(); v-- > 1;) {
    nodes_[v].engine->finish(change);
    pass_on(v, change);
  }
}

// ---- failures

bool TreeByForests::owns(CertificateId certificate) const {
  return std::any_of(nodes_.begin() + 1, nodes_.end(),
                     [certificate](const Node& node) { return node.engine->owns(certificate); });
}

void TreeByForests::certificate_failed(CertificateId failed) {
  std::size_t v = 1;
  while (!nodes_[v].engine->owns(failed)) ++v;
  nodes_[v].engine->certificate_failed(failed);
  const auto [before, after] = nodes_[v].changes->exchange();
  pass_up(v, Change::kMany);
  events_->repaired(before, after);
}

void TreeByForests::motions_changed(std::span<const ObjectId> objects) {
  for (std::size_t v = nodes_.size(); v-- > 1;) {
    nodes_[v].engine->motions_changed(objects);
    pass_on(v, Change::kMany);
  }
}

void TreeByForests::renew(std::span<const Item> items) {
  for (std::size_t v = nodes_.size(); v-- > 1;) {
    std::vector<Item> there;
    for (const Item item : items) {
      if (nodes_[v].engine->has(item)) there.push_back(item);
    }
    nodes_[v].engine->renew(there);
    pass_on(v, Change::kMany);
  }
}

// ---- checks

void TreeByForests::visit_proof(ProofVisitor& visitor) const {
  for (std::size_t v = 1; v < nodes_.size(); ++v) nodes_[v].engine->visit_proof(visitor);
}

// While a forest changes the node above has edges of it that come beside those that go.
Integer TreeByForests::most_certificates(std::size_t, std::size_t vertices) const {
  const std::size_t forest = vertices == 0 ? 0 : vertices - 1;
  const TreeEngine& node = *nodes_[1].engine;
  return counted(groups()) * node.most_certificates(std::max(group_, std::size_t{1}), vertices) +
         counted(groups() - 1) *
             node.most_certificates(std::max(3 * forest, std::size_t{1}), vertices);
}

Integer TreeByForests::most_failures_per_exchange() const {
  std::size_t levels = 0;
  while ((nodes_.size() - 1) >> levels > 0) ++levels;
  return counted(2 * levels);
}

void TreeByForests::check(AuditReport& report) const {
  for (std::size_t v = 1; v < nodes_.size(); ++v) {
    const TreeEngine& engine = *nodes_[v].engine;
    engine.check(report);
    const std::vector<Item> edges = edges_of(v);
    report.check(edges.size() == engine.size() &&
                     std::all_of(edges.begin(), edges.end(),
                                 [&engine](Item item) { return engine.has(item); }),
                 [] { return "a node has missed a change below it"; });
    report.check(!nodes_[v].changes->any(), [] { return "a change was not passed on"; });
  }
  report.check(nodes_[1].engine->tree() == tree(), [] { return "the tree is not that of the root"; });
}

std::size_t TreeByForests::bytes() const {
  std::size_t total = base_bytes() + nodes_.capacity() * sizeof(Node);
  for (std::size_t v = 1; v < nodes_.size(); ++v) {
    total += nodes_[v].engine->bytes() + nodes_[v].changes->bytes() + sizeof(Changes);
  }
  return total;
}

}  // namespace kinex
