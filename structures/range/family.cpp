// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/range/family.h"

#include "structures/range/pseudo_kd_tree_2.h"
#include "structures/range/range_tree_2.h"
#include "structures/range/rank_kd_tree_2.h"
#include "structures/range/trajectory_tree.h"

namespace kinex {
namespace {

const SortedList& list(const MakerInput& in, std::size_t axis) {
  return dynamic_cast<const SortedList&>(*in.watched[axis]);
}

template <class Tree>
std::unique_ptr<Structure> make_tree(const MakerInput& in) {
  return std::make_unique<Tree>(in.kernel, in.id, list(in, 0), list(in, 1));
}

std::unique_ptr<Structure> make_pseudo(const MakerInput& in) {
  const Rational units =
      in.parameter("delta") * Rational(static_cast<std::int64_t>(PseudoKdTree2::kUnit));
  const auto delta = static_cast<std::uint64_t>(units.lower_double());
  return std::make_unique<PseudoKdTree2>(in.kernel, in.id, list(in, 0), list(in, 1), delta);
}

// What all trees over the two sorted lists share.
StructureInfo tree(std::string_view name, std::string_view summary) {
  StructureInfo info{.name = name, .summary = summary};
  info.min_dimension = 2;
  info.shape = Attribute::Shape::kSequence;
  info.role = kRangeSearch;
  info.reads = {{"sorted_list", "", 0}, {"sorted_list", "", 1}};
  info.certificates = "none of its own; those of the sorted lists by x and by y";
  info.ties = "points with identically equal coordinates are in the order of their ids";
  return info;
}

}  // namespace

StructureFamily range_family() {
  StructureInfo range = tree("range_tree_2", "points by x and by y, for boxes in O(log^2 n + k)");
  range.kinds = {{"swap_x", Effect::kAlways, "two neighbours in the order of x change places"},
                 {"swap_y", Effect::kAlways, "two neighbours in the order of y change places"}};
  range.source = "Basch, Guibas, Zhang, Proximity problems on moving points (1997), section 3";
  range.make = make_tree<RangeTree2>;

  StructureInfo rank = tree("rank_kd_tree_2", "a kd-tree on ranks, for boxes in O(sqrt(n) + k)");
  rank.source = "after Abam, de Berg, Speckmann, Kinetic kd-trees and longest-side kd-trees (2009)";
  rank.make = make_tree<RankKdTree2>;

  StructureInfo pseudo =
      tree("pseudo_kd_tree_2", "a kd-tree with nearly median splits, rebuilt out of balance");
  pseudo.parameters = {
      {.name = "delta",
       .summary = "how far a split may be from the median, as a part of its points",
       .usual = "1/4",
       .least = "0",
       .most = "1/2",
       .most_is_allowed = false,
       .whole = false}};
  pseudo.source = "Agarwal, Gao, Guibas, Kinetic medians and kd-trees (2002)";
  pseudo.make = make_pseudo;

  StructureInfo trajectories{
      .name = "trajectory_tree",
      .summary = "a static tree over linear trajectories, for boxes at any time, without events"};
  trajectories.min_dimension = 2;
  trajectories.largest_degree = 1;
  trajectories.instead = "rank_kd_tree_2";
  trajectories.shape = Attribute::Shape::kSequence;
  trajectories.role = kRangeSearch;
  trajectories.certificates = "none: no order has to be kept";
  trajectories.ties = "equal trajectories are separated by their ids";
  trajectories.source = "Agarwal, Arge, Erickson, Indexing moving points (2003)";
  trajectories.make = make_plain<TrajectoryTree>;
  return {"range", {range, rank, pseudo, trajectories}};
}

}  // namespace kinex
