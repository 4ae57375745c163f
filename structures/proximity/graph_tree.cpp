// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/graph_tree.h"

#include <algorithm>
#include <string>

namespace kinex {

GraphTree::GraphTree(Kernel& kernel, StructureId id, const Scene& scene, const TreeMethod& method,
                     std::string_view name)
    : name_(name),
      weights_(kernel, scene),
      events_(kernel, id, {}),
      engine_(make_tree_engine(method, kernel, id, weights_, events_, weights_.vertices())) {}

void GraphTree::build(std::span<const ObjectId> objects) {
  members_.assign(objects.begin(), objects.end());
  rebuild();
}

void GraphTree::rebuild() {
  engine_->build(members_);
  events_.begin();
}

void GraphTree::insert(ObjectId object) {
  members_.insert(std::lower_bound(members_.begin(), members_.end(), object), object);
  engine_->add(object);
  engine_->finish(TreeEngine::Change::kSized);
  events_.begin();
}

void GraphTree::erase(ObjectId object) {
  members_.erase(std::lower_bound(members_.begin(), members_.end(), object));
  engine_->remove(object);
  engine_->finish(TreeEngine::Change::kSized);
  events_.begin();
}

Attribute GraphTree::attribute() const {
  Attribute result{Attribute::Shape::kTuples, {}, 1};
  for (const ObjectId object : members_) {
    if (engine_->in_tree(object)) result.ids.push_back(object);
  }
  return result;
}

std::vector<BoundCheck> GraphTree::bounds(const BoundContext& context) const {
  const std::size_t m = context.objects();
  const std::string own(name_);
  std::vector<BoundCheck> result{at_most(own + ".certificates", std::string(engine_->why_most()),
                                         engine_->most_certificates(m, weights_.vertices()),
                                         counted(context.ledger->max_live))};
  result.push_back(at_most(
      own + ".events", "each two edges change their order at every root, and where pieces meet",
      engine_->most_failures_per_exchange() * pair_sign_changes(context.pieces, context.degree),
      counted(context.ledger->failures)));
  if (context.plain() && m > 1) {
    result.push_back(spanning_tree_bound(own, counted(m), 1, context));
  }
  return result;
}

void GraphTree::check_invariants(AuditReport& report) const {
  for (const ObjectId object : members_) {
    report.check(engine_->has(object), [] { return "an edge that the engine lacks"; });
  }
  report.check(engine_->size() == members_.size(), [] { return "edges that are not there"; });
  engine_->check(report);
  report.check(!events_.any(), [] { return "a change of the tree was not reported"; });
}

}  // namespace kinex
