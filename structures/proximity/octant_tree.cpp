// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/octant_tree.h"

#include <algorithm>
#include <string>
#include <utility>

#include "structures/proximity/spanning_tree.h"

namespace kinex {
namespace {

// The cones that are octants: the direction by which the first point in it is the next one, and
// whether that point is on the negative side.
struct OctantSide {
  std::size_t cone;
  std::uint8_t direction;  // 0: x, 1: y
  bool negative;
};
constexpr std::array<OctantSide, 4> kOctantSides{
    {{0, 1, true}, {1, 0, false}, {3, 0, false}, {4, 1, false}}};

}  // namespace

OctantTree::OctantTree(Kernel& kernel, StructureId id, const OctantNeighbours& octants,
                       TreeProof proof)
    : kernel_(&kernel),
      id_(id),
      name_(proof == TreeProof::kList ? "mst_maximum_norm_list" : "mst_maximum_norm_cycles"),
      octants_(&octants),
      lengths_(kernel, {{1, 0}, {0, 1}}),
      events_(kernel, id, octants.id()),
      engine_(make_tree_engine(proof, kernel, id, lengths_, events_, octants.objects())) {
  octants.add_watcher(*this);
}

// ---- the edges

// By the first octant in which one of the two is next for the other; nullopt: there is none. (In an
// exact arithmetic there is one at most.)
std::optional<NormLengths::Form> OctantTree::form_of(const Pair& pair) const {
  for (const OctantSide& side : kOctantSides) {
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
      const ObjectId p = pair[i], q = pair[1 - i];
      if (octants_->next(side.cone, p) != q) continue;
      return NormLengths::Form{side.direction, side.negative ? q : p, side.negative ? p : q};
    }
  }
  return std::nullopt;
}

// Those of these pairs that are edges become so, and the others not: first those that come, since
// they may have to take the place of others.
void OctantTree::assign(std::span<const Pair> pairs) {
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

void OctantTree::assign_all() {
  std::vector<Pair> pairs = octants_->pairs();
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

void OctantTree::begin() {
  built_ = true;
  assign_all();
  stale_.clear();
  engine_->finish(TreeEngine::Change::kSized);
  events_.begin();
}

void OctantTree::rebuild() {
  engine_->build({});
  while (!lengths_.items().empty()) lengths_.remove(lengths_.items().begin()->second);
  begin();
}

// The octants notify the tree of every pointer, whatever they report; it is read when the instant is
// settled: a pair may change its octant and stay in the attribute of the octants.
void OctantTree::pointer_changed(ObjectId point, ObjectId old, ObjectId fresh) {
  if (!built_) return;
  for (const ObjectId other : {old, fresh}) {
    if (other == kNoObject) continue;
    stale_.push_back({std::min(point, other), std::max(point, other)});
  }
  kernel_->settle_later(id_);
}

void OctantTree::follow() {
  if (stale_.empty()) return;
  std::sort(stale_.begin(), stale_.end());
  stale_.erase(std::unique(stale_.begin(), stale_.end()), stale_.end());
  assign(std::exchange(stale_, {}));
  engine_->finish(TreeEngine::Change::kMany);
  // What was made now may fail now, too.
  if (events_.any() || kernel_->failure_is_due()) events_.settle_later();
}

// Changes of pointers are known already.
void OctantTree::watched_changed(const Event* event) {
  if (event != nullptr) return;
  assign_all();
  stale_.clear();
  engine_->finish(TreeEngine::Change::kMany);
  if (events_.any() || kernel_->failure_is_due()) events_.settle_later();
}

// Lengths that were identically equal may be so no more, or have become it.
void OctantTree::motions_changed(std::span<const ObjectId> objects) {
  std::vector<Item> items;
  for (const auto& [pair, item] : lengths_.items()) {
    const auto moves = [&](ObjectId id) {
      return std::find(objects.begin(), objects.end(), id) != objects.end();
    };
    if (moves(pair[0]) || moves(pair[1])) items.push_back(item);
  }
  engine_->renew(items);
}

Attribute OctantTree::attribute() const {
  Attribute result{Attribute::Shape::kTuples, {}};
  for (const auto& [pair, item] : lengths_.items()) {
    if (engine_->in_tree(item)) result.ids.insert(result.ids.end(), pair.begin(), pair.end());
  }
  return result;
}

// ---- checks

std::vector<BoundCheck> OctantTree::bounds(const BoundContext& context) const {
  const std::size_t n = context.objects();
  const std::string own(name_);
  // A pair that changes its octant is twice among the edges while it does.
  const std::size_t edges = std::max<std::size_t>(1, std::min(4 * n, n * n));
  std::vector<BoundCheck> result{
      at_most(own + ".certificates",
              std::string(engine_->why_most()) + ": at most four pairs a point, and those that replace "
                                                 "them while they change their octants",
              engine_->most_certificates(2 * edges, n), counted(context.ledger->max_live))};
  // A length is the larger of two linear functions of the positions, up to their signs: two lengths
  // are equal at roots of eight polynomials at most.
  if (context.plain() && n > 1) {
    result.push_back(spanning_tree_bound(own, pairs(counted(n)), 8, context));
  }
  return result;
}

void OctantTree::check_invariants(AuditReport& report) const {
  std::vector<Pair> edges;
  for (const auto& [pair, item] : lengths_.items()) {
    edges.push_back(pair);
    report.check(engine_->has(item), [] { return "an edge that the engine lacks"; });
    report.check(form_of(pair) == lengths_.form(item),
                 [] { return "a length along another axis than that of its octant"; });
  }
  report.check(edges == octants_->pairs() && edges.size() == engine_->size(),
               [] { return "it has missed a change of the octants"; });
  engine_->check(report);
  report.check(stale_.empty() && !events_.any(),
               [] { return "a change of the tree was not reported"; });
}

void OctantTree::audit(const Snapshot& snapshot, AuditReport& report) const {
  report.check(static_maximum_norm_tree(snapshot) == attribute().ids,
               [] { return "another tree is the shortest"; });
}

}  // namespace kinex
