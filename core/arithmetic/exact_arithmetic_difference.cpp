// SPDX-License-Identifier: GPL-3.0-or-later
// Failure times of differences of coordinates (coordinate_difference.h) in ExactArithmetic. An order asks
// for three at every exchange of neighbours, so each takes one function from the motions to the root,
// with no call in between:
//
//   motions, subtracted --> shifted to the origin --> sign at now --> FirstRoot
//        exact                   exact                 certified       certified     small integers
//        a ball each             a ball each           certified       certified     other numbers
//
// Every answer and counter is that of the general path (failure_in), which takes over where this one
// abstains: where the degree drops, or now may be a root.
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/arithmetic/exact_arithmetic.h"
#include "core/arithmetic/search_outlook.h"
#include "core/numbers/ball.h"
#include "core/numbers/first_root.h"

namespace kinex {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The coefficients of c(x + t), in place.
template <int D>
[[gnu::always_inline]] inline void shift(double* c, double x) {
  for (int i = 0; i < D; ++i) {
    for (int j = D - 1; j >= i; --j) c[j] += x * c[j + 1];
  }
}

}  // namespace

// The difference in t - origin, and the magnitudes of FirstRoot. False if its degree may be lower.
template <int D>
bool ExactArithmetic::shifted_difference(const Query& query, double* c, double* m) const {
  const std::size_t first =
      static_cast<std::size_t>(models_[query.predicate].difference_axis) * (D + 1);
  const MotionView<double> from = motions_.narrow(query.ids[0]) + first;
  const MotionView<double> to = motions_.narrow(query.ids[1]) + first;
  // Sums and differences of the shifted motions are exact (shift_is_exact), in whatever order.
  for (int k = 0; k <= D; ++k) c[k] = to[k] - from[k];
  if (c[D] == 0) return false;
  shift<D>(c, origin_);
  for (int k = 0; k <= D; ++k) m[k] = std::fabs(c[k]);
  return true;
}

// The same of motions that are no small integers. False, too, if no bound of the errors is known.
//
// Errors. With v the differences and w their errors: a term of the shifted polynomial passes through at
// most 4D roundings of u = 2^-53 each. So the error is at most the coefficient of (w + 4D u |v|) shifted
// by |x|; computing that bound itself costs less than the factor below.
template <int D>
bool ExactArithmetic::shifted_difference_of_balls(const Query& query, double* c, double* m) const {
  const std::size_t first =
      static_cast<std::size_t>(models_[query.predicate].difference_axis) * (D + 1);
  const std::optional<double> anchored = shift_from_anchor(query);
  const ObjectId a = query.ids[0], b = query.ids[1];
  const MotionView<Ball> from = (anchored ? motions_.anchored(a) : motions_.ball(a)) + first;
  const MotionView<Ball> to = (anchored ? motions_.anchored(b) : motions_.ball(b)) + first;
  double v[D + 1], w[D + 1];
  for (int k = 0; k <= D; ++k) {
    v[k] = to[k].value - from[k].value;
    w[k] = to[k].error + from[k].error + (2 * D + 1) * Ball::kUnit * std::fabs(v[k]);
  }
  if (const double x = anchored.value_or(origin_); x != 0) {
    shift<D>(v, x);
    shift<D>(w, std::fabs(x));
  }
  const double inverse_gamma = (1 + 0x1p-40) / filter::gamma(D);
  double sum = 0;
  for (int k = 0; k <= D; ++k) {
    c[k] = v[k];
    m[k] = std::fabs(v[k]) + (w[k] * (1 + 0x1p-40) + Ball::kTiny) * inverse_gamma;
    sum += m[k];
  }
  return (v[D] != 0 || w[D] != 0) && sum < kInfinity;
}

template <int D, bool kBalls>
std::optional<Outlook> ExactArithmetic::difference_failure_of(const Query& query, double limit,
                                                              FailureTime& time) {
  using Root = filter::FirstRoot<D, true>;
  double c[D + 1], m[D + 1];
  if (!(kBalls ? shifted_difference_of_balls<D>(query, c, m) : shifted_difference<D>(query, c, m))) {
    return std::nullopt;
  }
  const double end = horizon(query);
  const double a = now_.hi - origin_, b = filter::next_up(std::min(end, limit) - origin_);
  const bool may_relate = now_.own && query.ids[0] + query.ids[1] == now_.sum_of_ids;
  const int relation = may_relate ? relation_by_ids(query) : 0;
  if (!(a < b && b < kInfinity) || relation > 0 || (relation < 0 && !now_.isolated)) {
    return std::nullopt;
  }
  // The node that first_failure begins with. Its first coefficient is the value at now.hi; between
  // now.lo and now.hi the value moves by slope * width at most.
  const double node_end = Root::first_end(a, b), length = Root::length_of(a, node_end);
  std::array<double, D + 1> bernstein;
  const Root search(c, m, D, origin_);
  const double error = search.expand(a, length, bernstein);
  if (relation == 0) {
    const double reach = std::max(std::fabs(now_.lo - origin_), std::fabs(a) + length);
    double slope = D * m[D];
    for (int i = D - 1; i > 0; --i) slope = slope * reach + i * m[i];
    const double moved = slope * (now_.hi - now_.lo) * (1 + 0x1p-20);
    if (!(error >= 0 && bernstein[0] > error + moved)) return std::nullopt;
  }
  filter::Enclosure root;
  const filter::Search found = search_from<D>(search, a, node_end, bernstein, error, root);
  const std::optional<Outlook> outlook = outlook_of(found, root, limit, end, time);
  if (!outlook) return std::nullopt;
  count_solved(D);
  ++count(query).failures[static_cast<std::size_t>(Stage::kDouble)];
  return outlook;
}

// Of linear motions that are no small integers: a root in closed form needs no limit.
std::optional<Outlook> ExactArithmetic::linear_difference_failure(const Query& query,
                                                                  FailureTime& time) {
  const int relation = relation_to_now(query);
  Approximation p;
  if (relation > 0 || !shifted_difference_of_balls<1>(query, p.c, p.m)) return std::nullopt;
  p.origin = origin_;
  p.degree = 1;
  time = {kInfinity, kInfinity, 0};
  const std::optional<Outlook> found = linear_failure(query, p, relation, time);
  if (!found) return found;
  count_solved(1);
  ++count(query).failures[static_cast<std::size_t>(Stage::kDouble)];
  return found;
}

std::optional<Outlook> ExactArithmetic::difference_failure(const Query& query, double limit,
                                                           FailureTime& time) {
  const bool narrow = all_narrow(query);
  if (!(narrow ? models_[query.predicate].differs : models_[query.predicate].differs_in_balls)) {
    return std::nullopt;
  }
  switch (motions_.degree()) {
    case 1:
      return narrow ? std::nullopt : linear_difference_failure(query, time);
    case 2:
      return narrow ? difference_failure_of<2, false>(query, limit, time)
                    : difference_failure_of<2, true>(query, limit, time);
    case 3:
      return narrow ? difference_failure_of<3, false>(query, limit, time)
                    : difference_failure_of<3, true>(query, limit, time);
    default:
      return std::nullopt;
  }
}

}  // namespace kinex
