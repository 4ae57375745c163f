// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/delaunay_tree.h"

#include <algorithm>
#include <string>
#include <utility>

namespace kinex {

DelaunayTree::DelaunayTree(Kernel& kernel, StructureId id, const DelaunayGraph& triangulation,
                           const TreeMethod& method, std::string_view name)
    : kernel_(&kernel),
      name_(name),
      triangulation_(triangulation),
      seen_(triangulation_),
      lengths_(kernel, triangulation.dimension(), triangulation.objects()),
      events_(kernel, id, triangulation.id()),
      engine_(make_tree_engine(method, kernel, id, lengths_, events_, triangulation.objects())) {}

// ---- the edges

void DelaunayTree::add(const Edge& edge) {
  if (lengths_.find(edge) == kNoItem) engine_->add(lengths_.add(edge));
}

void DelaunayTree::remove(const Edge& edge) {
  const Item item = lengths_.find(edge);
  if (item == kNoItem) return;
  engine_->remove(item);
  forget(item);
}

// The engine may use it still.
void DelaunayTree::forget(Item item) {
  lengths_.remove(item, [this](Item one) { return engine_->uses(one); });
}

// The edges become those of the triangulation: first those that come, since they may have to take
// the place of others.
void DelaunayTree::assign() {
  const std::vector<Edge> wanted = triangulation_.edges();
  std::vector<Edge> gone;
  for (const auto& [edge, item] : lengths_.items()) {
    if (!std::binary_search(wanted.begin(), wanted.end(), edge)) gone.push_back(edge);
  }
  if (engine_->size() == 0) {
    std::vector<Item> items;
    for (const Edge& edge : wanted) items.push_back(lengths_.add(edge));
    return engine_->build(std::move(items));
  }
  for (const Edge& edge : wanted) add(edge);
  for (const Edge& edge : gone) remove(edge);
}

void DelaunayTree::catch_up() {
  std::vector<Edge> gone;
  seen_.look([this] { assign(); },
             [&](const Edge& edge, bool is_there) {
               if (is_there) {
                 add(edge);
               } else {
                 gone.push_back(edge);
               }
             });
  for (const Edge& edge : gone) remove(edge);
}

// ---- calls

void DelaunayTree::begin() {
  catch_up();
  engine_->finish(TreeEngine::Change::kSized);
  events_.begin();
}

void DelaunayTree::rebuild() {
  engine_->build({});
  for (const auto& [edge, item] : lengths_.items()) forget(item);
  seen_.forget();
  begin();
}

// At an instant with several changes, the triangulation is read when it is settled.
void DelaunayTree::follow(const std::optional<DelaunayEdgeChange>& change) {
  if (change && kernel_->instant_is_shared(triangulation_.id())) {
    return events_.settle_later();
  }
  if (change) {
    if (change->came) add(*change->came);
    if (change->gone) remove(*change->gone);
    seen_.followed(*change);
  } else {
    catch_up();
  }
  engine_->finish(change ? TreeEngine::Change::kSwap : TreeEngine::Change::kMany);
  // What was made now may fail now, too, when the triangulation has told its last change.
  if (events_.any() || kernel_->failure_is_due()) events_.settle_later();
}

Attribute DelaunayTree::attribute() const {
  Attribute result{Attribute::Shape::kTuples, {}};
  for (const auto& [edge, item] : lengths_.items()) {
    if (engine_->in_tree(item)) result.ids.insert(result.ids.end(), edge.begin(), edge.end());
  }
  return result;
}

// ---- checks

std::vector<BoundCheck> DelaunayTree::bounds(const BoundContext& context) const {
  const std::size_t n = context.objects();
  const std::string own(name_);
  std::vector<BoundCheck> result{at_most(
      own + ".certificates",
      std::string(engine_->why_most()) + ": at most 3n - 6 Delaunay edges, in space all pairs",
      engine_->most_certificates(std::max<std::size_t>(1, triangulation_.most_edges(n)), n),
      counted(context.ledger->max_live))};
  if (context.plain() && n > 1) {
    result.push_back(spanning_tree_bound(own, pairs(counted(n)), 2, context));
  }
  return result;
}

void DelaunayTree::check_invariants(AuditReport& report) const {
  std::vector<Edge> edges;
  for (const auto& [edge, item] : lengths_.items()) {
    edges.push_back(edge);
    report.check(engine_->has(item), [] { return "an edge that the engine lacks"; });
  }
  report.check(edges == triangulation_.edges() && edges.size() == engine_->size(),
               [] { return "it has missed a change of the edges"; });
  engine_->check(report);
  report.check(!events_.any(), [] { return "a change of the tree was not reported"; });
}

void DelaunayTree::audit(const Snapshot& snapshot, AuditReport& report) const {
  report.check(static_spanning_tree(snapshot) == attribute().ids,
               [] { return "another tree is the shortest"; });
}

}  // namespace kinex
