// SPDX-License-Identifier: GPL-3.0-or-later
// Signs and failure times of a certificate from its values at rational times alone: the polynomial
// by interpolation, its roots by a Sturm sequence of rationals. Shares no code with any arithmetic.
#ifndef KINEX_TESTS_CORE_ARITHMETIC_RATIONAL_ORACLE_H
#define KINEX_TESTS_CORE_ARITHMETIC_RATIONAL_ORACLE_H

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "core/numbers/rational.h"

namespace kinex::test {

class RationalOracle {
 public:
  // `value` is a polynomial of at most this degree.
  RationalOracle(const std::function<Rational(const Rational&)>& value, int degree) {
    // Newton's divided differences at 0, 1, -1, 2, ..
    std::vector<Rational> at, difference;
    for (int i = 0; i <= degree; ++i) {
      at.emplace_back(i % 2 == 1 ? (i + 1) / 2 : -(i / 2));
      difference.push_back(value(at.back()));
    }
    const std::size_t n = at.size();
    for (std::size_t k = 1; k < n; ++k) {
      for (std::size_t i = n - 1; i >= k; --i) {
        difference[i] = (difference[i] - difference[i - 1]) / (at[i] - at[i - k]);
      }
    }
    for (std::size_t i = n; i-- > 0;) {
      Poly next(c_.size() + 1);
      for (std::size_t k = 0; k < c_.size(); ++k) {
        next[k + 1] += c_[k];
        next[k] -= c_[k] * at[i];
      }
      next[0] += difference[i];
      strip(next);
      c_ = std::move(next);
    }
  }

  const std::vector<Rational>& coefficients() const { return c_; }
  bool is_zero() const { return c_.empty(); }
  int sign_at(const Rational& t) const { return evaluate(c_, t).sign(); }
  // Of the first derivative that does not vanish at t.
  int sign_right_after(const Rational& t) const {
    Poly p = c_;
    while (!p.empty()) {
      const int sign = evaluate(p, t).sign();
      if (sign != 0) return sign;
      p = derivative(p);
    }
    return 0;
  }

  // The first instant >= now right after which the value is negative, as (lo, hi]: it is the only
  // root there. lo = hi: it is now. nullopt: there is none.
  std::optional<std::pair<Rational, Rational>> first_failure(const Rational& now) const {
    if (is_zero()) return std::nullopt;
    if (sign_right_after(now) < 0) return std::pair(now, now);
    const std::vector<Poly> chain = sturm_chain();
    Rational reach(1);
    const int last = variations_at_infinity(chain);
    while (sign_at(now + reach) == 0 || variations(chain, now + reach) != last) {
      reach *= reach + Rational(64);
    }
    return search(chain, now, now + reach);
  }
  // The number of different roots in (lo, hi].
  int roots(const Rational& lo, const Rational& hi) const {
    return roots_between(sturm_chain(), lo, hi);
  }

 private:
  using Poly = std::vector<Rational>;

  static void strip(Poly& p) {
    while (!p.empty() && p.back().is_zero()) p.pop_back();
  }
  static Rational evaluate(const Poly& p, const Rational& t) {
    Rational v;
    for (std::size_t i = p.size(); i-- > 0;) v = v * t + p[i];
    return v;
  }
  static Poly derivative(const Poly& p) {
    Poly d;
    for (std::size_t i = 1; i < p.size(); ++i) d.push_back(p[i] * Rational(static_cast<long>(i)));
    return d;
  }
  // The remainder of a by b, times -1, made monic up to sign.
  static Poly minus_remainder(Poly a, const Poly& b) {
    while (a.size() >= b.size()) {
      const Rational q = a.back() / b.back();
      const std::size_t shift = a.size() - b.size();
      for (std::size_t i = 0; i < b.size(); ++i) a[i + shift] -= q * b[i];
      a.pop_back();
      strip(a);
    }
    if (a.empty()) return a;
    const Rational lead = a.back().sign() > 0 ? -a.back() : a.back();
    for (Rational& c : a) c = c / lead;
    return a;
  }
  static Poly quotient(Poly a, const Poly& b) {
    Poly q(a.size() - b.size() + 1);
    for (std::size_t k = q.size(); k-- > 0;) {
      q[k] = a[k + b.size() - 1] / b.back();
      for (std::size_t i = 0; i < b.size(); ++i) a[i + k] -= q[k] * b[i];
    }
    return q;
  }
  static std::vector<Poly> chain_of(const Poly& p) {
    std::vector<Poly> chain{p};
    for (Poly next = derivative(p); !next.empty();) {
      chain.push_back(next);
      next = minus_remainder(chain[chain.size() - 2], chain.back());
    }
    return chain;
  }
  // Of the polynomial with the same roots, all simple: the chain's last element is the gcd of the
  // polynomial and its derivative.
  std::vector<Poly> sturm_chain() const {
    std::vector<Poly> chain = chain_of(c_);
    if (chain.back().size() == 1) return chain;
    return chain_of(quotient(c_, chain.back()));
  }
  template <class SignOf>
  static int count_variations(const std::vector<Poly>& chain, const SignOf& sign_of) {
    int count = 0, before = 0;
    for (const Poly& p : chain) {
      const int sign = sign_of(p);
      if (sign != 0 && before != 0 && sign != before) ++count;
      if (sign != 0) before = sign;
    }
    return count;
  }
  static int variations(const std::vector<Poly>& chain, const Rational& t) {
    return count_variations(chain, [&t](const Poly& p) { return evaluate(p, t).sign(); });
  }
  static int variations_at_infinity(const std::vector<Poly>& chain) {
    return count_variations(chain, [](const Poly& p) { return p.back().sign(); });
  }
  // Among the roots in (lo, hi].
  std::optional<std::pair<Rational, Rational>> search(const std::vector<Poly>& chain,
                                                      const Rational& lo, const Rational& hi) const {
    const int count = roots_between(chain, lo, hi);
    if (count == 0) return std::nullopt;
    if (count == 1) {
      if (sign_right_after(hi) < 0) return std::pair(lo, hi);
      return std::nullopt;
    }
    Rational middle = (lo + hi) / Rational(2);
    while (sign_at(middle) == 0) middle = (middle + hi) / Rational(2);
    if (auto found = search(chain, lo, middle)) return found;
    return search(chain, middle, hi);
  }
  // Sturm: a simple root at lo is not counted, one at hi is.
  static int roots_between(const std::vector<Poly>& chain, const Rational& lo, const Rational& hi) {
    return variations(chain, lo) - variations(chain, hi);
  }

  Poly c_;
};

}  // namespace kinex::test

#endif
