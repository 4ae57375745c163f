// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/collision/pair_sums.h"

#include <stdexcept>
#include <utility>

#include "core/numbers/show_text.h"
#include "predicates/bodies/pose_2.h"

namespace kinex {

PairSums::PairSums(PairTable& pairs)
    : pairs_(pairs),
      point_(OuterHierarchy::of_origin(), pairs.frames().constants()),
      hierarchies_(pairs.frames().policy()) {}

void PairSums::make(PairId p) {
  if (sums_.size() <= p) sums_.resize(p + std::size_t{1});
  const BodyPair& pair = pairs_[p];
  BodyFrames& frames = pairs_.frames();
  auto made = make_sum_frame(pairs_.kernel(), pair.pose, frames.frame(pair.a, false),
                             frames.frame(pair.b, true), frames.policy());
  if (made == nullptr) {
    throw std::invalid_argument(
        "separation_minkowski is for bodies that do not turn against each other; " +
        show_text(pairs_.name(p, 0)) + " and " + show_text(pairs_.name(p, 1)) +
        " do: use separation_mixed");
  }
  hierarchies_.add(made->frame.hierarchy());
  sums_[p] = {std::move(made), pairs_.kernel().motion_degree(pair.pose, 0, kPoseAxes) <= 1, 0};
  note_line(sums_[p]);
}

void PairSums::failed(PairId p) {
  ++sums_[p].failures;
  note_line(sums_[p]);
}

void PairSums::note_line(const Sum& sum) {
  if (!sum.is_line) return;
  const std::int64_t most = 2 * sum.made->frame.hierarchy().levels() + 8;
  if (!line_ || sum.failures - most > line_->failures - line_->most) line_ = {sum.failures, most};
}

Features PairSums::features(PairId p, std::uint32_t edge) const {
  const SumFrame& made = *sums_[p].made;
  const OuterHierarchy& tree = made.frame.hierarchy();
  const std::uint32_t i = tree.edge(edge).polygon_edge;
  if (i == OuterHierarchy::kNone) {  // a line that touches M only at a vertex
    const std::uint32_t vertex = tree.vertex_of(tree.first_leaf(edge));
    return {{false, made.sum.a[vertex]}, {false, made.sum.b[vertex]}};
  }
  const MinkowskiSum::Origin& origin = made.sum.edges[i];
  return SumBoundary::Edge{origin.z, origin.edge, origin.vertex}.features();
}

void PairSums::add_bounds(const BoundContext& context, std::vector<BoundCheck>& checks) const {
  if (!context.plain() || context.degree > 1 || !line_) return;
  checks.push_back(at_most("separation_minkowski.line",
                           "a line meets every ring between two stages in at most two triangles",
                           Integer(line_->most), Integer(line_->failures)));
}

std::size_t PairSums::bytes() const {
  std::size_t total = sums_.capacity() * sizeof(Sum);
  for (const Sum& sum : sums_) {
    if (sum.made != nullptr) total += sizeof(SumFrame) + sum.made->frame.bytes();
  }
  return total;
}

}  // namespace kinex
