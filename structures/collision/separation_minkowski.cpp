// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/collision/separation_minkowski.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace kinex {

SeparationMinkowski::SeparationMinkowski(Kernel& kernel, StructureId id, const Scene& scene,
                                         CutPolicy policy)
    : SeparationMixed(kernel, id, scene, policy),
      policy_(policy),
      point_(OuterHierarchy::of_point(frame_point(0, 0)), frames_.constants()),
      past_(policy) {}

bool SeparationMinkowski::start(PairId p) {
  if (sums_.size() <= p) sums_.resize(p + std::size_t{1});
  const ObjectId a = pair(p).a, b = pair(p).b;
  auto sum = minkowski_sum(frames_.frame(a, false).hierarchy().polygon(),
                           frames_.frame(b, true).hierarchy().polygon(),
                           kernel_.derived().trajectory(pair(p).pose));
  if (!sum) {
    throw std::invalid_argument(
        "separation_minkowski is for bodies that do not turn against each other; " +
        scene_.objects[a].id + " and " + scene_.objects[b].id + " do: use separation_mixed");
  }
  auto made = std::make_unique<Sum>();
  made->frame =
      std::make_unique<BodyFrame>(OuterHierarchy(sum->polygon, policy_), frames_.constants());
  made->sum = std::move(*sum);
  made->is_line = kernel_.derived().trajectory(pair(p).pose).degree() <= 1;
  note_line(*made);
  sums_[p] = std::move(made);
  return SeparationMixed::start(p);
}

void SeparationMinkowski::fail(PairId p, std::uint32_t slot) {
  ++sums_[p]->failures;
  note_line(*sums_[p]);
  SeparationMixed::fail(p, slot);
}

void SeparationMinkowski::note_line(const Sum& sum) {
  if (!sum.is_line) return;
  const std::int64_t most = 2 * sum.frame->hierarchy().levels() + 8;
  if (!line_ || sum.failures - most > line_->failures - line_->most) line_ = {sum.failures, most};
}

void SeparationMinkowski::stop(PairId p) {
  if (p >= sums_.size() || sums_[p] == nullptr) return;
  past_.add(sums_[p]->frame->hierarchy());
  sums_[p].reset();
}

void SeparationMinkowski::add_hierarchies(HierarchyBounds& bounds) const {
  bounds = past_;
  SeparationMixed::add_hierarchies(bounds);
  for (const auto& sum : sums_) {
    if (sum != nullptr) bounds.add(sum->frame->hierarchy());
  }
}

CollisionPairs::Features SeparationMinkowski::features(PairId p, const MixedTiles::Move& move) {
  const Sum& made = *sums_[p];
  const OuterHierarchy& tree = made.frame->hierarchy();
  const OuterHierarchy::Edge& edge = tree.edge(move.edge);
  if (edge.polygon_edge == OuterHierarchy::kNone) {  // a line that touches M only at a vertex
    std::uint32_t end = edge.first;
    while (tree.node(end).right != OuterHierarchy::kNone) end = tree.node(end).right;
    const std::size_t i = tree.node(end).begin % tree.polygon().size();
    return {{false, made.sum.a[i]}, {false, made.sum.b[i]}};
  }
  const std::uint32_t i = edge.polygon_edge;
  const MinkowskiSum::Origin& origin = made.sum.edges[i];
  const Feature line{true, origin.edge}, vertex{false, origin.vertex};
  return origin.z == 0 ? Features{line, vertex} : Features{vertex, line};
}

std::vector<BoundCheck> SeparationMinkowski::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> checks = SeparationMixed::bounds(context);
  if (!context.plain() || context.degree > 1 || !line_) return checks;
  checks.push_back(at_most("separation_minkowski.line",
                           "a line meets every ring between two stages in at most two triangles",
                           Integer(line_->most), Integer(line_->failures)));
  return checks;
}

std::size_t SeparationMinkowski::bytes() const {
  std::size_t total = SeparationMixed::bytes() + sums_.capacity() * sizeof(sums_[0]);
  for (const auto& sum : sums_) {
    if (sum != nullptr) total += sizeof(Sum) + sum->frame->bytes();
  }
  return total;
}

}  // namespace kinex
