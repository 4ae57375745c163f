// SPDX-License-Identifier: GPL-3.0-or-later
// Signs and failure times of orders of two lengths (length_order.h) in ExactArithmetic, of small integers.
// Spanning trees and closest pairs ask for little else, so each takes one function from the motions to
// the answer:
//
//   motions, subtracted --> shifted to the origin --> (u - v)(u + v) --> sign at now --> FirstRoot
//        exact                    exact              certified by reach   certified     certified
//
// The coefficients and magnitudes are bit for bit those of approximate_shifted: only exact operations are
// exchanged. So are every answer, enclosure and counter those of the general path, which takes over where
// this one abstains: where the degree drops, now may be a root, or the scene has no end.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/arithmetic/exact_arithmetic.h"
#include "core/arithmetic/reach_power.h"
#include "core/arithmetic/search_outlook.h"
#include "core/numbers/first_root.h"
#include "core/numbers/interval_sign.h"
#include "core/numbers/lanes.h"
#include "core/numbers/ring_polynomial.h"

namespace kinex {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

using kinex::larger;
using kinex::magnitude_of;

// Numbers of two axes side by side. Each of the two is bit for bit what doubles would give.
typedef double Two __attribute__((vector_size(16)));
typedef std::int64_t TwoMasks __attribute__((vector_size(16)));

[[gnu::always_inline]] inline Two magnitude_of(Two a) {
  constexpr std::int64_t kAllButSign = 0x7fffffffffffffff;
  return (Two)((TwoMasks)a & TwoMasks{kAllButSign, kAllButSign});
}
[[gnu::always_inline]] inline Two larger(Two a, Two b) { return b > a ? b : a; }

// a - b on one axis, or on two, in t - x. Exact (shift_is_exact), in whatever order.
template <int D, class R>
[[gnu::always_inline]] inline FixedPolynomial<R, D> difference(MotionView<double> a,
                                                               MotionView<double> b, double x) {
  FixedPolynomial<R, D> p;
  for (int k = 0; k <= D; ++k) {
    if constexpr (sizeof(R) == sizeof(Two)) {
      p.c[k] = Two{a[k], a[k + D + 1]} - Two{b[k], b[k + D + 1]};
    } else {
      p.c[k] = a[k] - b[k];
    }
  }
  for (int i = 0; i < D; ++i) {
    for (int j = D - 1; j >= i; --j) p.c[j] += x * p.c[j + 1];
  }
  return p;
}

// The motions of the ends: v = a - o, u = b - p. o and p may be the same (kShared).
struct Ends {
  MotionView<double> o, a, p, b;
};

// (u - v)(u + v) on the axis that begins at `first`, or on two, and the reach there: the largest
// differences from o.
template <int D, bool kShared, class R>
[[gnu::always_inline]] inline FixedPolynomial<R, 2 * D> term(const Ends& ends, std::size_t first,
                                                             double x, R* reach) {
  const auto v = difference<D, R>(ends.a + first, ends.o + first, x);
  auto u = difference<D, R>(ends.b + first, ends.o + first, x);
  for (int k = 0; k <= D; ++k) reach[k] = larger(magnitude_of(v.c[k]), magnitude_of(u.c[k]));
  if constexpr (!kShared) {
    const auto w = difference<D, R>(ends.p + first, ends.o + first, x);
    for (int k = 0; k <= D; ++k) reach[k] = larger(reach[k], magnitude_of(w.c[k]));
    u = u - w;
  }
  return (u - v) * (u + v);
}

}  // namespace

// The order in t - origin, of motions of degree D, and the magnitudes of FirstRoot. False if its degree
// may be lower. kShared: one argument is an end of both lengths.
template <int D, bool kShared>
[[gnu::always_inline]] inline bool ExactArithmetic::shifted_lengths(const Query& query, double* c,
                                                                    double* m) const {
  const PredicateModel& model = models_[query.predicate];
  const LengthEnds& lengths = model.lengths;
  const auto end = [&](std::size_t i) { return motions_.narrow(query.ids[i]); };
  const Ends ends{end(lengths.shorter_from), end(lengths.shorter_to), end(lengths.longer_from),
                  end(lengths.longer_to)};
  // The sum of one axis, of two, or of two and one.
  constexpr std::size_t kPowers = D + 1;
  double reach[D + 1];
  FixedPolynomial<double, 2 * D> sum;
  if (model.reads > kPowers) {
    Two both[D + 1];
    const auto terms = term<D, kShared>(ends, 0, origin_, both);
    for (int i = 0; i <= 2 * D; ++i) sum.c[i] = terms.c[i][0] + terms.c[i][1];
    for (int k = 0; k <= D; ++k) reach[k] = larger(both[k][0], both[k][1]);
    if (model.reads > 2 * kPowers) {
      double third[D + 1];
      sum = sum + term<D, kShared>(ends, 2 * kPowers, origin_, third);
      for (int k = 0; k <= D; ++k) reach[k] = larger(reach[k], third[k]);
    }
  } else {
    sum = term<D, kShared>(ends, 0, origin_, reach);
  }
  double power[2 * D + 1];
  square_of<D>(reach, power);
  const double error = model.reach_error;
  for (int i = 0; i <= 2 * D; ++i) {
    c[i] = sum.c[i];
    m[i] = std::fabs(c[i]) + error * power[i];
  }
  return m[2 * D] != 0;
}

template <int D, bool kShared>
std::optional<Sign> ExactArithmetic::length_sign_of(const Query& query) const {
  double c[2 * D + 1], m[2 * D + 1];
  if (!shifted_lengths<D, kShared>(query, c, m)) return std::nullopt;
  return filter::sign_over<2 * D>(c, m, 2 * D,
                                  {now_.lo - origin_, now_.hi - origin_, now_.hi - now_.lo});
}

template <int D, bool kShared>
std::optional<Outlook> ExactArithmetic::length_failure_of(const Query& query, double limit,
                                                          FailureTime& time) {
  constexpr int kDegree = 2 * D;
  using Root = filter::FirstRoot<kDegree, true>;
  double c[kDegree + 1], m[kDegree + 1];
  if (!shifted_lengths<D, kShared>(query, c, m)) return std::nullopt;
  const double from = now_.hi - origin_;
  // Summed one by one: loads across the pieces of a new query would wait for its stores (query.h).
  ObjectId sum = query.ids[0] + query.ids[1] + query.ids[2];
  if constexpr (!kShared) sum += query.ids[3];
  const bool may_relate = now_.own && sum == now_.sum_of_ids;
  const int relation = may_relate ? relation_by_ids(query) : 0;
  bool fails = relation > 0;  // the polynomial that has just become negative
  if (relation < 0 && !now_.isolated) return std::nullopt;
  if (relation == 0) {
    const filter::Interval now{now_.lo - origin_, from, now_.hi - now_.lo};
    const auto sign = filter::sign_over<kDegree>(c, m, kDegree, now);
    if (!sign) return std::nullopt;
    fails = *sign == Sign::kNegative;
  }
  Outlook outlook = Outlook::kNever;
  if (fails) {
    outlook = fails_now(time);
  } else {
    const double end = horizon(query);
    const double until = filter::next_up(std::min(end, limit) - origin_);
    if (!(from < until && until < kInfinity)) return std::nullopt;
    // The search of first_failure.
    const double node_end = Root::first_end(from, until);
    std::array<double, kDegree + 1> bernstein;
    const Root search(c, m, kDegree, origin_);
    const double error = search.expand(from, Root::length_of(from, node_end), bernstein);
    filter::Enclosure root;
    const filter::Search found =
        search_from<kDegree>(search, from, node_end, bernstein, error, root);
    const std::optional<Outlook> known = outlook_of(found, root, limit, end, time);
    if (!known) return std::nullopt;
    outlook = *known;
  }
  count_solved(kDegree);
  ++count(query).failures[static_cast<std::size_t>(Stage::kDouble)];
  return outlook;
}

std::optional<Sign> ExactArithmetic::length_sign(const Query& query) const {
  switch (models_[query.predicate].lengths_path) {
    case LengthsPath::kShared1:
      return length_sign_of<1, true>(query);
    case LengthsPath::kApart1:
      return length_sign_of<1, false>(query);
    case LengthsPath::kShared2:
      return length_sign_of<2, true>(query);
    case LengthsPath::kApart2:
      return length_sign_of<2, false>(query);
    case LengthsPath::kShared3:
      return length_sign_of<3, true>(query);
    case LengthsPath::kApart3:
      return length_sign_of<3, false>(query);
    case LengthsPath::kNone:
      break;
  }
  return std::nullopt;
}

std::optional<Outlook> ExactArithmetic::length_failure(const Query& query, double limit,
                                                       FailureTime& time) {
  switch (models_[query.predicate].lengths_path) {
    case LengthsPath::kShared1:
      return length_failure_of<1, true>(query, limit, time);
    case LengthsPath::kApart1:
      return length_failure_of<1, false>(query, limit, time);
    case LengthsPath::kShared2:
      return length_failure_of<2, true>(query, limit, time);
    case LengthsPath::kApart2:
      return length_failure_of<2, false>(query, limit, time);
    case LengthsPath::kShared3:
      return length_failure_of<3, true>(query, limit, time);
    case LengthsPath::kApart3:
      return length_failure_of<3, false>(query, limit, time);
    case LengthsPath::kNone:
      break;
  }
  return std::nullopt;
}

}  // namespace kinex
