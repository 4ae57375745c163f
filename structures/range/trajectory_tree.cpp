// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/range/trajectory_tree.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "predicates/predicates.h"
#include "structures/range/halving_line.h"

namespace kinex {
namespace {

// The box between two constants, right after now.
class BoxAfterNow final : public BoxAt {
 public:
  BoxAfterNow(Kernel& kernel, const std::array<PredicateId, 2>& orders, ObjectId low, ObjectId high,
              std::uint64_t& signs)
      : kernel_(kernel), orders_(orders), low_(low), high_(high), signs_(signs) {}

  bool precedes(int axis, ObjectId a, ObjectId b) override {
    ++signs_;
    return kernel_.sign_after(order(axis), {a, b}) == Sign::kPositive;
  }
  OutOfInterval out(int axis, const CoordinateTable& table, std::size_t place,
                    std::span<const ObjectId> objects) override {
    signs_ += 2 * objects.size();
    return kernel_.out_of_interval(order(axis), table, place, objects, low_, high_);
  }
  // The box has no points because its low side is beyond its high side.
  bool is_empty() { return precedes(0, high_, low_) || precedes(1, high_, low_); }

 private:
  PredicateId order(int axis) const { return orders_[static_cast<std::size_t>(axis)]; }

  Kernel& kernel_;
  const std::array<PredicateId, 2>& orders_;
  ObjectId low_, high_;
  std::uint64_t& signs_;
};

}  // namespace

// As ConjugationTrees::most_looked_at: below a primary node that a line crosses are nodes that it
// crosses, too, or that are inside with their secondary trees, or outside.
std::uint64_t TrajectoryTree::most_looked_at(std::uint64_t n) {
  if (n <= ConjugationTrees::kLeaf) return 1 + n;
  const std::vector<std::uint64_t> sizes = ConjugationTrees::sizes_below(n);
  std::uint64_t below = 0, half = 0;  // of the present size, and of its half
  for (std::size_t i = sizes.size() - 1; i-- > 0;) {
    std::uint64_t whole = 2 + sizes[i];
    if (i + 2 < sizes.size()) {
      const std::uint64_t inside = ConjugationTrees::most_looked_at(sizes[i + 1]);
      const std::uint64_t crossed =
          i + 3 == sizes.size() ? below : 2 + half + ConjugationTrees::most_looked_at(sizes[i + 2]);
      whole = 2 + below + std::max(inside, crossed);
    }
    half = std::exchange(below, whole);
  }
  return 1 + std::max(ConjugationTrees::most_looked_at(n), 2 * below);
}

TrajectoryTree::TrajectoryTree(Kernel& kernel, StructureId, const Scene& scene)
    : kernel_(&kernel),
      points_{DualPoints(kernel, 0, scene.dimension), DualPoints(kernel, 1, scene.dimension)},
      orders_{kernel.bind(make_coordinate_order(0)), kernel.bind(make_coordinate_order(1))} {
  if (scene.degree_without_weights() > 1) {
    throw std::invalid_argument(
        "a tree over trajectories needs linear motions, not motions of degree " +
        std::to_string(scene.degree_without_weights()));
  }
}

void TrajectoryTree::build(std::span<const ObjectId> objects) {
  objects_.assign(objects.begin(), objects.end());
  forest_.reset();
}

void TrajectoryTree::insert(ObjectId object) {
  objects_.insert(std::lower_bound(objects_.begin(), objects_.end(), object), object);
  forest_.reset();
}

void TrajectoryTree::erase(ObjectId object) {
  objects_.erase(std::lower_bound(objects_.begin(), objects_.end(), object));
  forest_.reset();
}

std::unique_ptr<const TrajectoryTree::Forest> TrajectoryTree::made() const {
  auto forest = std::make_unique<Forest>(
      Forest{ConjugationTrees(points_[0]), ConjugationTrees(points_[1]), 0, {}, {}});
  ConjugationTrees& by_x = forest->by_x;
  forest->root = by_x.add(objects_);
  by_x.finish();
  points_[1].fill(by_x.order(), forest->y);
  forest->below.assign(by_x.nodes(), ConjugationTrees::kNone);
  for (ConjugationTrees::Ref at = forest->root; at < by_x.nodes(); ++at) {
    if (!by_x.is_leaf(at)) forest->below[at] = forest->by_y.add(by_x.objects(at));
  }
  forest->by_y.finish();
  return forest;
}

std::uint64_t TrajectoryTree::search(const Forest& forest, BoxAt& box, std::vector<ObjectId>& out,
                                     QueryTrace* trace) {
  const ConjugationTrees& by_x = forest.by_x;
  std::uint64_t looked_at = 0;
  ConjugationTrees::OpenNodes open;
  open.push(forest.root, {});
  while (!open.empty()) {
    auto [at, seen] = open.pop();
    ++looked_at;
    if (by_x.is_leaf(at)) {
      by_x.add_to(trace, at, NodePlace::kCrossed);
      looked_at += by_x.objects(at).size();
      std::uint64_t found = by_x.inside(at, box, 0, by_x.table());
      if (found != 0) found &= by_x.inside(at, box, 1, forest.y);
      by_x.add_some(at, found, out);
      continue;
    }
    const NodePlace place = by_x.place(at, box, seen);
    by_x.add_to(trace, at, place == NodePlace::kInside ? NodePlace::kCrossed : place);
    if (place == NodePlace::kInside) {
      looked_at += forest.by_y.search(forest.below[at], box, out, trace);
    }
    if (place != NodePlace::kCrossed) continue;
    for (const std::size_t half : {1, 0}) {
      by_x.prefetch(by_x.below(at, half));
      open.push(by_x.below(at, half), seen);
    }
  }
  return looked_at;
}

const TrajectoryTree::Forest& TrajectoryTree::forest() {
  if (forest_ == nullptr) {
    forest_ = made();
    ++builds_;
  }
  return *forest_;
}

void TrajectoryTree::trace(ObjectId low, ObjectId high, std::vector<ObjectId>& out,
                           QueryTrace& nodes) {
  QueryCounts counts;
  BoxAfterNow box(*kernel_, orders_, low, high, counts.signs);
  if (!box.is_empty()) search(forest(), box, out, &nodes);
}

void TrajectoryTree::report(ObjectId low, ObjectId high, std::vector<ObjectId>& out,
                            QueryCounts& counts) {
  BoxAfterNow box(*kernel_, orders_, low, high, counts.signs);
  if (box.is_empty()) return;
  const std::uint64_t looked_at = search(forest(), box, out, nullptr);
  counts.nodes += looked_at;
  looked_at_.note(looked_at, most_looked_at(objects_.size()));
}

// ---- checks

std::vector<BoundCheck> TrajectoryTree::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> result{
      at_most("trajectory_tree.certificates", "nothing has to be proved again", Integer(0),
              counted(context.ledger->max_live)),
      at_most("trajectory_tree.events", "the trajectories are static", Integer(0),
              counted(context.ledger->external))};
  if (looked_at_.seen) {
    result.push_back(at_most("trajectory_tree.looked_at", "nodes and points that a query looks at",
                             counted(looked_at_.bound), counted(looked_at_.observed)));
  }
  return result;
}

void TrajectoryTree::check_invariants(AuditReport& report) const {
  report.check(std::is_sorted(objects_.begin(), objects_.end()),
               [] { return "objects are not ascending"; });
  report.check(looked_at_.observed <= looked_at_.bound,
               [] { return "a query looked at too many nodes"; });
  if (forest_ == nullptr) return;
  const auto has_all = [](std::span<const ObjectId> found, std::span<const ObjectId> expected) {
    return std::is_permutation(found.begin(), found.end(), expected.begin(), expected.end());
  };
  const ConjugationTrees &by_x = forest_->by_x, &by_y = forest_->by_y;
  report.check(has_all(by_x.objects(forest_->root), objects_),
               [] { return "the tree holds other objects"; });
  for (ConjugationTrees::Ref at = forest_->root; at < by_x.nodes(); ++at) {
    const ConjugationTrees::Ref below = forest_->below[at];
    report.check(by_x.is_leaf(at) == (below == ConjugationTrees::kNone),
                 [] { return "a secondary tree too many or too few"; });
    if (by_x.is_leaf(at)) continue;
    report.check(has_all(by_y.objects(below), by_x.objects(at)),
                 [] { return "a secondary tree holds other objects"; });
  }
}

std::size_t TrajectoryTree::bytes() const {
  std::size_t sum = objects_.capacity() * sizeof(ObjectId);
  if (forest_ == nullptr) return sum;
  sum += forest_->by_x.bytes() + forest_->by_y.bytes() + forest_->y.bytes() +
         forest_->below.capacity() * sizeof(forest_->below[0]);
  return sum;
}

}  // namespace kinex
