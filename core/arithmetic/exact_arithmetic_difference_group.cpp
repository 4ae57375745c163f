// SPDX-License-Identifier: GPL-3.0-or-later
// Groups of differences of coordinates in ExactArithmetic: the failure times of all of them in lanes
// (core/numbers/difference_lanes.h). If lanes do not answer one, all are asked one by one. Answers,
// enclosures and counters are those of exact_arithmetic_difference.cpp.
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>

#include "core/arithmetic/exact_arithmetic.h"

namespace kinex {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Lanes cost about as much as this many queries one by one.
constexpr std::size_t kLeastInGroup = 2;
using AnyNode = filter::FirstRoot<2, true>;  // the first node does not depend on the degree

}  // namespace

// One predicate, whose motions are all small integers, or none of them are.
inline ExactArithmetic::DifferenceKind ExactArithmetic::kind_of_differences(
    std::span<const Query> group) const {
  const PredicateModel& model = models_[group[0].predicate];
  if (group.size() < kLeastInGroup || group.size() > kLanes || !model.differs_in_lanes) {
    return DifferenceKind::kOther;
  }
  const bool narrow = all_narrow(group[0]);
  if (!(narrow ? model.differs : model.differs_in_balls)) return DifferenceKind::kOther;
  if (motions_.model().anchored && !motions_.has_one_anchor()) return DifferenceKind::kOther;
  const bool alike = motions_.all_narrow() || !motions_.model().narrow;
  for (const Query& query : group.subspan(1)) {
    if (query.predicate != group[0].predicate) return DifferenceKind::kOther;
    if (!alike && all_narrow(query) != narrow) return DifferenceKind::kOther;
  }
  return narrow ? DifferenceKind::kNarrow : DifferenceKind::kBalls;
}

// Which of the queries have now as a root. False if one is not answered in lanes.
inline bool ExactArithmetic::relate_differences(std::span<const Query> group) {
  std::uint32_t root = 0, bit = 1;
  if (now_.own) {
    for (const Query& query : group) {
      if (query.ids[0] + query.ids[1] == now_.sum_of_ids) {
        // The pair whose exchange is being repaired: the opposite of the query that failed.
        const bool opposite = query.predicate == now_.query.predicate &&
                              query.ids[0] == now_.query.ids[1] && query.ids[1] == now_.query.ids[0];
        const int relation = opposite ? -1 : relation_by_ids(query);
        if (relation > 0) return false;
        if (relation < 0 && !now_.isolated && motions_.degree() > 1) return false;
        if (relation < 0) root |= bit;
      }
      bit <<= 1;
    }
  }
  differences_.span.root = root;
  return true;
}

// The ends of the nodes. False if one is without end, or behind now.
inline bool ExactArithmetic::set_nodes(std::span<const Query> group, double limit) {
  filter::DifferenceSpan& span = differences_.span;
  const double from = now_.hi - origin_;
  span.origin = origin_;
  span.now_lo = now_.lo;
  span.now_hi = now_.hi;
  span.alike = until_.empty();
  const bool linear = motions_.degree() == 1;
  for (std::size_t j = 0; j < kLanes; ++j) {
    const double end = horizon(group[j < group.size() ? j : 0]);
    span.horizon[j] = end;
    if (!linear) {
      const double until = filter::next_up(std::min(end, limit) - origin_);
      if (!(from < until && until < kInfinity)) return false;
      span.end[j] = AnyNode::first_end(from, until);
      span.length[j] = AnyNode::length_of(from, span.end[j]);
    }
    if (span.alike) break;
  }
  return true;
}

template <class Row>
inline void ExactArithmetic::find_differences(std::span<const Query> group, const Row& row_of) {
  using Number = std::remove_cvref_t<decltype(row_of(0)[0])>;
  const int degree = motions_.degree();
  const auto first = static_cast<std::size_t>(models_[group[0].predicate].difference_axis) *
                     static_cast<std::size_t>(degree + 1);
  filter::DifferenceRows<Number> rows;
  rows.from[2] = rows.from[3] = row_of(group[0].ids[0]) + first;
  rows.to[2] = rows.to[3] = row_of(group[0].ids[1]) + first;
  for (std::size_t j = 0; j < group.size(); ++j) {
    rows.from[j] = row_of(group[j].ids[0]) + first;
    rows.to[j] = row_of(group[j].ids[1]) + first;
  }
  filter::difference_lanes(rows, degree, differences_.span, vectors_, differences_.lanes);
}

Arithmetic::Grouped ExactArithmetic::answer_differences(std::span<const Query> group, double limit,
                                                        GroupAnswers& answers) {
  filter::DifferenceSpan& span = differences_.span;
  const filter::DifferenceLanes& lanes = differences_.lanes;
  const DifferenceKind kind = kind_of_differences(group);
  if (kind == DifferenceKind::kOther) return Grouped::kNot;
  if (!relate_differences(group) || !set_nodes(group, limit)) return Grouped::kNot;
  const auto nothing_found = [&](std::size_t j) {
    const bool later = motions_.degree() > 1 && limit < span.horizon[span.alike ? 0 : j];
    return later ? Outlook::kLater : Outlook::kNever;
  };
  span.nothing = nothing_found(0) == Outlook::kLater ? limit : kInfinity;
  span.shift = origin_;
  if (kind == DifferenceKind::kNarrow) {
    find_differences(group, [this](ObjectId object) { return motions_.narrow(object); });
  } else if (const std::optional<double> anchored = shift_from_anchor(group[0])) {
    span.shift = *anchored;
    find_differences(group, [this](ObjectId object) { return motions_.anchored(object); });
  } else {
    find_differences(group, [this](ObjectId object) { return motions_.ball(object); });
  }
  const std::uint32_t all = (1u << group.size()) - 1;
  if ((lanes.known & all) != all) return Grouped::kNot;
  const int degree = motions_.degree();
  if (span.alike && ((lanes.clear | lanes.found) & all) == all) {
    // Without a branch on the roots, which nothing predicts, or on their times, which come late.
    const std::array<Outlook, 2> outlooks{nothing_found(0), Outlook::kFails};
    for (std::size_t j = 0; j < group.size(); ++j) {
      answers.outlooks[j] = outlooks[lanes.found >> j & 1];
      answers.times[j] = {lanes.lo[j], lanes.hi[j], 0};
    }
  } else {
    for (std::size_t j = 0; j < group.size(); ++j) {
      filter::Enclosure root{lanes.lo[j], lanes.hi[j]};
      filter::Search search = (lanes.found >> j & 1) != 0 ? filter::Search::kFound : filter::Search::kNone;
      if (((lanes.clear | lanes.found) >> j & 1) == 0) {
        search = filter::from_first_node(lanes, j, degree, span, root);
      }
      if (search == filter::Search::kUnknown) return Grouped::kNot;
      answers.outlooks[j] = Outlook::kFails;
      answers.times[j] = {root.lo, root.hi, 0};
      if (search == filter::Search::kFound) continue;
      answers.outlooks[j] = nothing_found(j);
      const double until = answers.outlooks[j] == Outlook::kLater ? limit : kInfinity;
      answers.times[j] = {until, until, 0};
    }
  }
  count_solved(degree, group.size());
  count(group[0]).failures[static_cast<std::size_t>(Stage::kDouble)] += group.size();
  return Grouped::kAnswered;
}

}  // namespace kinex
