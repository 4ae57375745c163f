// SPDX-License-Identifier: GPL-3.0-or-later
// ConvexHull2: bounds.
#include <string>
#include <utility>
#include <vector>

#include "structures/hull/convex_hull_2.h"
#include "structures/hull/hull_bounds.h"
#include "structures/parts/binomial.h"

namespace kinex {

std::vector<BoundCheck> ConvexHull2::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> checks;
  if (corrupt_) return checks;
  const StructureLedger& ledger = *context.ledger;
  const std::string prefix(name());
  const auto n = static_cast<std::int64_t>(context.objects());
  std::int64_t levels = 0;
  for (std::int64_t k = 1; k < n; k *= 2) ++levels;
  // A node of m lines has 2 end certificates and fewer than m corners, with x, y and at most two
  // slopes each; each half has levels of n lines in all.
  if (!context.dynamic) {
    checks.push_back(at_most(prefix + ".compactness",
                             "per half and node 2 at the ends, 4 per corner of its m lines: at "
                             "most 2 (4 n log2 n + 2 (n - 1))",
                             Integer(2) * (Integer(4 * n) * Integer(levels) + Integer(2 * n)),
                             counted(ledger.max_live)));
    if (variant_ == Variant::kLocal) {
      checks.push_back(at_most(prefix + ".locality",
                               "per half and level " + std::to_string(kPerLevel) +
                                   ": a line is an end, in two corners and their x, y and slopes "
                                   "with neighbours, and the "
                                   "contender of O(1) more",
                               Integer(kPerLevel) * Integer(2) * Integer(levels),
                               counted(ledger.max_per_object)));
    }
  }
  // The theorems count failures in general position.
  if (!context.plain() || signs_.tied() || node_rebuilds_ != 0 || ledger.rebuilds != 0) {
    return checks;
  }
  const Integer d(context.degree), all(n);
  const auto add = [&](const char* what, const char* source, const Integer& bound,
                       std::initializer_list<const char*> kinds) {
    checks.push_back(at_most(prefix + what, source, bound, counted(events_of(ledger, kinds))));
  };
  add(".s_events", "each pair of points meets at one node and changes its order d times",
      d * binomial(all, 2), {"sl", "sr", "st", "end"});
  add(".y_events", "each triple of points changes its orientation 2d times, in two halves",
      Integer(2) * turns_of_triples(context), {"yl", "yr", "yb", "yt"});
  add(".x_events",
      "the tree pairs each four points in one way: they change their order 2d times, in two halves",
      Integer(4) * d * binomial(all, 4), {"x"});
  add_level_bounds(context, checks);
  for (BoundCheck& check : hull_bounds(name(), context, signs_.tied())) {
    checks.push_back(std::move(check));
  }
  return checks;
}

// Failures at all nodes of one height. The lines of a node's certificate come from both of its
// children, so each pair, triple and quadruple of points belongs to one node and counts as often as
// in the bounds for the whole tree. The largest heights of a tree that is not full have few nodes.
void ConvexHull2::add_level_bounds(const BoundContext& context,
                                   std::vector<BoundCheck>& checks) const {
  if (root_ == kNone) return;
  const Integer d(context.degree);
  std::vector<Integer> most(tree_[root_].height + std::size_t{1});
  std::vector<Index> open{root_};
  while (!open.empty()) {
    const TreeNode& node = tree_[open.back()];
    open.pop_back();
    if (node.children[0] == kNone) continue;
    for (const Index c : node.children) open.push_back(c);
    const Integer red = counted(tree_[node.children[0]].leaves);
    const Integer blue = counted(tree_[node.children[1]].leaves);
    const Integer red_pairs = binomial(red, 2), blue_pairs = binomial(blue, 2);
    const Integer turns = Integer(4) * (red_pairs * blue + red * blue_pairs);
    const Integer exchanges = Integer(4) * red_pairs * blue_pairs;
    most[node.height] = most[node.height] + d * (red * blue + turns + exchanges);
  }
  for (std::size_t height = 1; height < most.size(); ++height) {
    const std::string number = std::to_string(height);
    checks.push_back(at_most(
        std::string(name()) + ".level_" + (height < 10 ? "0" : "") + number,
        "nodes at height " + number +
            ", over r and b points: r b pairs fail d times, C(r,2) b + r C(b,2) triples and "
            "C(r,2) C(b,2) fours 2d times in two halves",
        most[height], counted(height < by_level_.size() ? by_level_[height] : 0)));
  }
}

}  // namespace kinex
