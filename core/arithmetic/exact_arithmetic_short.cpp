// SPDX-License-Identifier: GPL-3.0-or-later
// ExactArithmetic where instants are short dyadic numbers (core/numbers/short_dyadic.h) and motions are
// narrow: signs, failures and equal instants in 128-bit integers. Every function may abstain.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/arithmetic/exact_arithmetic.h"

namespace kinex {
namespace {

constexpr int kBitsOfSums = 112;  // so that sums of few products of so many bits fit

Sign sign_of(Int128 x) { return x < 0 ? Sign::kNegative : x > 0 ? Sign::kPositive : Sign::kZero; }

}  // namespace

// The signs of the polynomial and of its derivative at t; nullopt where machine integers may not hold
// them. Horner's rule on c0 q^d + c1 k q^(d-1) + ... for t = k / q; its partial sums are the coefficients
// of the quotient by (x - t).
std::optional<std::array<Sign, 2>> ExactArithmetic::signs_at(const Query& query,
                                                             const ShortDyadic& t) const {
  const PredicateModel& model = models_[query.predicate];
  if (!model.narrow || !all_narrow(query)) return std::nullopt;
  Int128 c[kMaxFixedCoefficients];
  wide_coefficients(query, c);
  const std::int64_t k = t.numerator, q = std::int64_t{1} << t.places;
  const int bits = std::bit_width(static_cast<std::uint64_t>(std::max(k < 0 ? -k : k, q)));
  const int room = kBitsOfSums - model.degree * bits;  // of a coefficient
  if (room <= 0) return std::nullopt;
  Int128 ones = 0;
  for (int i = 0; i <= model.degree; ++i) ones |= c[i] ^ (c[i] >> 127);
  if (ones >> room != 0) return std::nullopt;
  Int128 sum = c[model.degree], derivative = 0, power = 1;
  for (int i = model.degree - 1; i >= 0; --i) {
    power *= q;
    derivative = derivative * k + sum;
    sum = sum * k + c[i] * power;
  }
  return std::array{sign_of(sum), sign_of(derivative)};
}

bool ExactArithmetic::vanishes_at(const Query& query, const ShortDyadic& t) const {
  const auto signs = signs_at(query, t);
  return signs && (*signs)[0] == Sign::kZero;
}

// Now, if it is a short dyadic number.
std::optional<ShortDyadic> ExactArithmetic::short_now() {
  const auto t = shortest_dyadic(now_.lo, now_.hi);
  if (!t) return std::nullopt;
  const RealRoot& now = roots_[now_root()];
  now_.lo = std::max(now_.lo, now.lower_double());
  now_.hi = std::min(now_.hi, now.upper_double());
  return now_.lo == now_.hi ? t : std::nullopt;
}

std::optional<Sign> ExactArithmetic::short_sign_after(const Query& query) {
  const auto t = short_now();
  if (!t) return std::nullopt;
  const auto signs = signs_at(query, *t);
  if (!signs) return std::nullopt;
  const Sign sign = (*signs)[0] != Sign::kZero ? (*signs)[0] : (*signs)[1];
  return sign == Sign::kZero ? std::nullopt : std::optional(sign);
}

// Of a polynomial c0 + c1 t + c2 t^2 that is zero at now, k / q: its other root is rational.
std::optional<Outlook> ExactArithmetic::short_failure(const Query& query, FailureTime& time) {
  const PredicateModel& model = models_[query.predicate];
  if (model.degree != 2 || model.touches) return std::nullopt;
  const auto t = short_now();
  const auto signs = t ? signs_at(query, *t) : std::nullopt;
  if (!signs || (*signs)[0] != Sign::kZero) return std::nullopt;
  Int128 c[kMaxFixedCoefficients];
  wide_coefficients(query, c);  // signs_at has found them short
  if ((*signs)[1] == Sign::kZero && c[2] == 0) return std::nullopt;
  solved_degree_ = 2;
  if ((*signs)[1] == Sign::kNegative || ((*signs)[1] == Sign::kZero && c[2] < 0)) {
    return fails_now(time);
  }
  if (c[2] >= 0 || (*signs)[1] == Sign::kZero) return Outlook::kNever;
  // The derivative is slope / q; the other root is slope / (-c2 q) after now. Each of the two numbers, and
  // their quotient, is rounded once.
  const Int128 q = Int128{1} << t->places;
  const Int128 slope = 2 * c[2] * t->numerator + c[1] * q;
  const double after = static_cast<double>(slope) / static_cast<double>(-c[2] * q);
  const double root = now_.lo + after;
  const double error = after * 0x1p-50 + std::fabs(root) * 0x1p-51;
  const double lo = root - error, hi = root + error;
  if (!(lo > now_.hi && hi < end_upper_)) return std::nullopt;
  time = {lo, hi, 0};
  return Outlook::kFails;
}

// For enclosures that overlap: both numbers are the shortest dyadic one in the overlap. They share it.
// An enclosure that is one number is that number.
bool ExactArithmetic::share_short_root(const Query& a, FailureTime& ta, const Query& b,
                                       FailureTime& tb) {
  const auto t = shortest_dyadic(std::max(ta.lo, tb.lo), std::min(ta.hi, tb.hi));
  const auto is_at = [&](const Query& query, const FailureTime& time) {
    return time.root == 0 ? vanishes_at(query, *t) : time.lo == time.hi;
  };
  if (!t || !is_at(a, ta) || !is_at(b, tb)) return false;
  if (ta.root == 0 && tb.root == 0) {
    ++counters_.roots_made_exact;
    t->assign_to(short_value_);
    ta.root = roots_.add(short_value_);
  }
  if (ta.root == 0) ta.root = roots_.share(tb.root & ~kFlags);
  if (tb.root == 0) tb.root = roots_.share(ta.root & ~kFlags);
  if ((ta.root & ~kFlags) != (tb.root & ~kFlags)) merge(ta, tb);
  ta.lo = ta.hi = tb.lo = tb.hi = t->to_double();
  return true;
}

}  // namespace kinex
