// SPDX-License-Identifier: GPL-3.0-or-later
// Groups of queries in ExactArithmetic: the filter's first step for all of them side by side.
//
//   begin_group           the polynomials, their signs at now and their first nodes, in lanes
//   look_ahead_in_group   clear node: answered; sign change: continued from the node; else: one by one
#include <algorithm>
#include <array>
#include <limits>

#include "core/arithmetic/exact_arithmetic.h"
#include "core/arithmetic/reach_power.h"
#include "core/arithmetic/search_outlook.h"

namespace kinex {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Lanes cost about as much as this many queries one by one.
constexpr std::size_t kLeastInGroup = 2;
using AnyNode = filter::FirstRoot<4, true>;  // the first node does not depend on the degree

// The magnitudes of ExactArithmetic::approximate_shifted.
template <int D>
[[gnu::always_inline]] inline void add_errors(const Lanes* c, const Lanes* reach, int homogeneity,
                                              int degree, double reach_error, Lanes* m) {
  Lanes power[kMaxFixedCoefficients + 1];
  power_of<D>(reach, homogeneity, power);
  for (int i = 0; i <= degree; ++i) m[i] = magnitude_of(c[i]) + reach_error * power[i];
}

struct Magnitudes {
  const Lanes* c;
  const Lanes* reach;
  int motion_degree, homogeneity, degree;
  double reach_error;

  [[gnu::always_inline]] void any(Lanes* m) const {
    switch (motion_degree) {
      case 1: return add_errors<1>(c, reach, homogeneity, degree, reach_error, m);
      case 2: return add_errors<2>(c, reach, homogeneity, degree, reach_error, m);
      default: return add_errors<3>(c, reach, homogeneity, degree, reach_error, m);
    }
  }
  KINEX_FOR_AVX2 void avx2(Lanes* m) const { any(m); }
};

}  // namespace

bool ExactArithmetic::fits_lanes(std::span<const Query> group) const {
  if (group.size() < kLeastInGroup || group.size() > kLanes) return false;
  if (!models_[group[0].predicate].in_lanes) return false;
  const bool narrow = motions_.all_narrow();
  for (const Query& query : group) {
    if (query.predicate != group[0].predicate) return false;
    if (!narrow && !all_narrow(query)) return false;
  }
  return true;
}

// The nodes' ends and lengths; false if one is without end, or behind now.
bool ExactArithmetic::set_horizons(std::span<const Query> group, double limit, Lanes& lengths) {
  Group& g = group_;
  const double from = now_.hi - origin_;
  std::array<double, kLanes> length;
  const std::size_t different = until_.empty() ? 1 : group.size();
  for (std::size_t j = 0; j < different; ++j) {
    g.horizon[j] = horizon(group[j]);
    const double until = filter::next_up(std::min(g.horizon[j], limit) - origin_);
    if (!(from < until && until < kInfinity)) return false;
    g.node_end[j] = AnyNode::first_end(from, until);
    length[j] = AnyNode::length_of(from, g.node_end[j]);
  }
  for (std::size_t j = different; j < kLanes; ++j) {
    g.horizon[j] = g.horizon[0];
    g.node_end[j] = g.node_end[0];
    length[j] = length[0];
  }
  lengths = Lanes(length[0], length[1], length[2], length[3]);
  return true;
}

Arithmetic::Grouped ExactArithmetic::begin_group(std::span<const Query> group, double limit,
                                                 GroupAnswers& answers) {
  Group& g = group_;
  g.known = 0;
  if (models_[group[0].predicate].difference_axis >= 0) {
    return answer_differences(group, limit, answers);
  }
  if (!fits_lanes(group)) return Grouped::kNot;
  filter::LaneSpan span;
  span.lo = now_.lo - origin_;
  span.hi = now_.hi - origin_;
  span.width = now_.hi - now_.lo;
  constexpr double kFarthest = filter::kLeastTimeLimit;
  if (!(std::fabs(span.lo) <= kFarthest && std::fabs(span.hi) <= kFarthest)) return Grouped::kNot;
  if (!set_horizons(group, limit, span.length)) return Grouped::kNot;
  const Query& first = group[0];
  const PredicateModel& model = models_[first.predicate];
  std::array<MotionView<double>, kMaxArity * kLanes> points;
  for (std::size_t j = 0; j < kLanes; ++j) {
    const Query& query = group[j < group.size() ? j : 0];
    for (std::size_t i = 0; i < first.arity; ++i) {
      points[i * kLanes + j] = motions_.narrow(query.ids[i]);
    }
  }
  Lanes reach[kMaxFixedDegree + 1];
  const int d = motions_.degree();
  if (!predicates_[first.predicate]->plain_lanes(d, points.data(), origin_, vectors_, g.c, reach)) {
    return Grouped::kNot;
  }
  const Magnitudes magnitudes{g.c, reach, d, model.homogeneity, model.degree, model.reach_error};
  if (vectors_ == Vectors::kAvx2) {
    magnitudes.avx2(g.m);
  } else {
    magnitudes.any(g.m);
  }
  filter::first_nodes(g.c, g.m, model.degree, span, vectors_, g.nodes);
  g.degree = model.degree;
  g.now_lo = now_.lo;
  g.now_hi = now_.hi;
  g.origin = origin_;
  for (std::size_t j = 0; j < group.size(); ++j) {
    if (g.nodes.positive[j] && relation_to_now(group[j]) == 0) g.known |= 1u << j;
  }
  return Grouped::kPrepared;
}

Outlook ExactArithmetic::look_ahead_in_group(std::size_t i, const Query& query, double limit,
                                             FailureTime& time) {
  const Group& g = group_;
  if ((g.known >> i & 1) == 0 || g.now_lo != now_.lo || g.now_hi != now_.hi) {
    return look_ahead(query, limit, time);
  }
  filter::Enclosure root;
  const filter::Search found =
      g.nodes.clear[i] ? filter::Search::kNone
                       : filter::from_first_node(g.nodes, i, g.c, g.m, g.degree, g.origin,
                                                 g.now_hi - g.origin, g.node_end[i], root);
  const std::optional<Outlook> outlook = outlook_of(found, root, limit, g.horizon[i], time);
  if (!outlook) return look_ahead(query, limit, time);
  count_solved(g.degree);
  ++count(query).failures[static_cast<std::size_t>(Stage::kDouble)];
  return *outlook;
}

}  // namespace kinex
