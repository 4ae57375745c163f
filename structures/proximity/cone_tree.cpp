// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/cone_tree.h"

#include <algorithm>
#include <string>
#include <utility>

#include "structures/parts/sort_unique.h"
#include "structures/proximity/spanning_tree.h"

namespace kinex {

ConeTree::ConeTree(Kernel& kernel, StructureId id, const ConeNeighbours& cones, const TreeMethod& method,
                   std::string_view name)
    : kernel_(&kernel),
      id_(id),
      name_(name),
      cones_(&cones),
      lengths_(kernel, cones.frame().units),
      events_(kernel, id, cones.id()),
      engine_(make_tree_engine(method, kernel, id, lengths_, events_, cones.objects())) {
  cones.add_watcher(*this);
}

// ---- the edges

// By the first cone in which one of the two is next for the other; nullopt: there is none. (In an
// exact arithmetic there is one at most.)
std::optional<NormLengths::Form> ConeTree::form_of(const Pair& pair) const {
  const ConeFrame& frame = cones_->frame();
  for (std::size_t cone = 0; cone < frame.cones(); ++cone) {
    const auto& side = frame.sides[cone];
    for (std::size_t i = 0; side && i < 2; ++i) {
      const ObjectId p = pair[i], q = pair[1 - i];
      if (cones_->next(cone, p) != q) continue;
      return NormLengths::Form{side->unit, side->negative ? q : p, side->negative ? p : q};
    }
  }
  return std::nullopt;
}

// Those of these pairs that are edges become so, and the others not: first those that come, since
// they may have to take the place of others.
void ConeTree::assign(std::span<const Pair> pairs) {
  std::vector<Item> gone;
  for (const Pair& pair : pairs) {
    const auto wanted = form_of(pair);
    const Item item = lengths_.find(pair);
    if (item != kNoItem && wanted == lengths_.form(item)) continue;
    if (item != kNoItem) gone.push_back(item);
    if (wanted) engine_->add(lengths_.add(*wanted));
  }
  for (const Item item : gone) {
    engine_->remove(item);
    lengths_.remove(item);
  }
}

void ConeTree::assign_all() {
  std::vector<Pair> pairs = cones_->pairs();
  if (engine_->size() == 0) {
    std::vector<Item> items;
    for (const Pair& pair : pairs) items.push_back(lengths_.add(*form_of(pair)));
    return engine_->build(std::move(items));
  }
  for (const auto& [pair, item] : lengths_.items()) pairs.push_back(pair);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  assign(pairs);
}

// ---- calls

// All pairs, if the cones were built anew, and those of stale_.
void ConeTree::assign_changed() {
  const bool rebuilt = builds_ != cones_->builds();
  builds_ = cones_->builds();
  sort_unique(stale_);
  const std::vector<Pair> stale = std::exchange(stale_, {});
  if (rebuilt) {
    assign_all();
  } else {
    assign(stale);
  }
}

void ConeTree::begin() {
  assign_changed();
  engine_->finish(TreeEngine::Change::kSized);
  events_.begin();
}

void ConeTree::rebuild() {
  engine_->build({});
  while (!lengths_.items().empty()) lengths_.remove(lengths_.items().begin()->second);
  builds_ = 0;
  begin();
}

// The cones notify the tree of every pointer, whatever they report; it is read when the instant is
// settled: a pair may change its cone and stay in the attribute of the cones.
void ConeTree::pointer_changed(ObjectId point, ObjectId old, ObjectId fresh) {
  if (builds_ == 0) return;
  for (const ObjectId other : {old, fresh}) {
    if (other == kNoObject) continue;
    stale_.push_back({std::min(point, other), std::max(point, other)});
  }
  kernel_->settle_later(id_);
}

void ConeTree::follow() {
  if (stale_.empty() && builds_ == cones_->builds()) return;
  assign_changed();
  engine_->finish(TreeEngine::Change::kMany);
  // What was made now may fail now, too.
  if (events_.any() || kernel_->failure_is_due()) events_.settle_later();
}

// Changes of pointers are known already; a rebuild of the cones need not have told all.
void ConeTree::watched_changed(const Event* event) {
  if (event == nullptr && builds_ != cones_->builds()) follow();
}

// Lengths that were identically equal may be so no more, or have become it.
void ConeTree::motions_changed(std::span<const ObjectId> objects) {
  std::vector<Item> items;
  for (const auto& [pair, item] : lengths_.items()) {
    const auto moves = [&](ObjectId id) {
      return std::binary_search(objects.begin(), objects.end(), id);
    };
    if (moves(pair[0]) || moves(pair[1])) items.push_back(item);
  }
  engine_->renew(items);
}

Attribute ConeTree::attribute() const {
  Attribute result{Attribute::Shape::kTuples, {}};
  for (const auto& [pair, item] : lengths_.items()) {
    if (engine_->in_tree(item)) result.ids.insert(result.ids.end(), pair.begin(), pair.end());
  }
  return result;
}

// ---- checks

std::vector<BoundCheck> ConeTree::bounds(const BoundContext& context) const {
  const std::size_t n = context.objects();
  const std::string own(name_);
  // A pair that changes its cone is twice among the edges while it does.
  const std::size_t cones = cones_->frame().counted(), units = cones_->frame().units.size();
  const std::size_t edges = std::max<std::size_t>(1, std::min(cones * n, n * n));
  std::vector<BoundCheck> result{
      at_most(own + ".certificates",
              std::string(engine_->why_most()) + ": at most a pair a point and cone, and those that "
                                                 "replace them while they change their cones",
              engine_->most_certificates(2 * edges, n), counted(context.ledger->max_live))};
  // A length is the largest of k linear functions of the positions, up to their signs: two lengths are
  // equal at roots of 2k^2 polynomials at most.
  if (context.plain() && n > 1) {
    result.push_back(spanning_tree_bound(own, pairs(counted(n)),
                                         static_cast<int>(2 * units * units), context));
  }
  return result;
}

void ConeTree::check_invariants(AuditReport& report) const {
  std::vector<Pair> edges;
  for (const auto& [pair, item] : lengths_.items()) {
    edges.push_back(pair);
    report.check(engine_->has(item), [] { return "an edge that the engine lacks"; });
    report.check(form_of(pair) == lengths_.form(item),
                 [] { return "a length that is not that of its cone"; });
  }
  report.check(edges == cones_->pairs() && edges.size() == engine_->size(),
               [] { return "it has missed a change of the cones"; });
  engine_->check(report);
  report.check(stale_.empty() && !events_.any(),
               [] { return "a change of the tree was not reported"; });
}

void ConeTree::audit(const Snapshot& snapshot, AuditReport& report) const {
  const ConeFrame& frame = cones_->frame();
  const std::vector<ObjectId> edges = attribute().ids;
  report.check(static_norm_tree(snapshot, frame.corners) == edges,
               [] { return "another tree is the shortest"; });
  report.check(within_ratio(snapshot, edges, static_spanning_tree(snapshot), frame.ratio),
               [] { return "it is too long, against the Euclidean tree"; });
}

}  // namespace kinex
