// SPDX-License-Identifier: GPL-3.0-or-later
// Identities of all polynomials, on small coefficients (many coincidences) and large ones.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/numbers/polynomial_gcd.h"
#include "core/numbers/real_root.h"
#include "core/numbers/sturm_sequence.h"
#include "tests/core/numbers/polynomial_fixture.h"

namespace kinex {
namespace root_properties_test {

using fixture::power;
using fixture::with_root;

Polynomial any_polynomial(int max_degree, int max_coefficient) {
  const int degree = *rc::gen::inRange(1, max_degree + 1);
  std::vector<Integer> c;
  for (int i = 0; i <= degree; ++i) {
    c.emplace_back(*rc::gen::inRange(-max_coefficient, max_coefficient + 1));
  }
  Polynomial p(std::move(c));
  RC_PRE(!p.is_zero());
  return p;
}

Rational any_rational() {
  return Rational(Integer(*rc::gen::inRange(-60, 61)), Integer(*rc::gen::inRange(1, 13)));
}

std::vector<RealRoot> roots_of(const Polynomial& p, RootCounters& counters) {
  std::vector<RealRoot> result;
  for (RootWithMultiplicity& entry : isolate_real_roots(p, counters)) {
    result.push_back(std::move(entry.root));
  }
  return result;
}

RC_GTEST_PROP(RootProperties, IsolationFindsAsManyRootsAsSturm, ()) {
  RootCounters counters;
  const Polynomial p = any_polynomial(4, 6) * power(any_polynomial(2, 3), 2);
  RC_ASSERT(static_cast<int>(isolate_real_roots(p, counters).size()) ==
            SturmSequence(p).count_all());
}

RC_GTEST_PROP(RootProperties, PolynomialIsZeroAtItsRootsAndSignChangesHaveOddMultiplicity, ()) {
  RootCounters counters;
  const Polynomial p =
      any_polynomial(3, 6) * power(any_polynomial(1, 5), 2) * power(any_polynomial(1, 3), 3);
  for (RootWithMultiplicity& entry : isolate_real_roots(p, counters)) {
    RC_ASSERT(sign_at(p, entry.root, counters) == Sign::kZero);
    const Sign parity = entry.multiplicity % 2 == 0 ? Sign::kPositive : Sign::kNegative;
    RC_ASSERT(sign_before(p, entry.root, counters) * sign_after(p, entry.root, counters) == parity);
  }
}

RC_GTEST_PROP(RootProperties, SignBeforeAndAfterAgreeWithSignAtWhereThatIsNotZero, ()) {
  RootCounters counters;
  const Polynomial q = any_polynomial(4, 8);
  for (RealRoot& root : roots_of(any_polynomial(4, 8), counters)) {
    const Sign s = sign_at(q, root, counters);
    if (s == Sign::kZero) continue;
    RC_ASSERT(sign_before(q, root, counters) == s);
    RC_ASSERT(sign_after(q, root, counters) == s);
  }
}

RC_GTEST_PROP(RootProperties, SignsMultiply, ()) {
  RootCounters counters;
  const Polynomial a = any_polynomial(3, 4);
  const Polynomial b = any_polynomial(3, 4);
  for (RealRoot& root : roots_of(any_polynomial(3, 4), counters)) {
    RC_ASSERT(sign_at(a * b, root, counters) ==
              sign_at(a, root, counters) * sign_at(b, root, counters));
    RC_ASSERT(sign_after(a * b, root, counters) ==
              sign_after(a, root, counters) * sign_after(b, root, counters));
    RC_ASSERT(sign_before(-a, root, counters) == -sign_before(a, root, counters));
  }
}

RC_GTEST_PROP(RootProperties, ComparisonIsATotalOrder, ()) {
  RootCounters counters;
  // Small coefficients: many equal roots of different polynomials.
  std::vector<RealRoot> all;
  for (int i = 0; i < 3; ++i) {
    for (RealRoot& r : roots_of(any_polynomial(3, 3), counters)) all.push_back(std::move(r));
  }
  for (const RealRoot& x : all) {
    for (const RealRoot& y : all) {
      RealRoot a = x;
      RealRoot b = y;
      const int order = compare(a, b, counters);
      RealRoot c = y;
      RealRoot d = x;
      RC_ASSERT(compare(c, d, counters) == -order);
      // Equal if and only if it is a root of the gcd.
      if (order == 0) {
        RealRoot e = x;
        RC_ASSERT(sign_at(y.polynomial(), e, counters) == Sign::kZero);
      }
      for (const RealRoot& z : all) {
        RealRoot f = z;
        RealRoot g = z;
        RealRoot h = y;
        if (order <= 0 && compare(h, f, counters) <= 0) {
          RealRoot k = x;
          RC_ASSERT(compare(k, g, counters) <= 0);
        }
      }
    }
  }
}

RC_GTEST_PROP(RootProperties, ComparisonWithRationalsIsTheSignOfALinearPolynomial, ()) {
  RootCounters counters;
  const Rational t = any_rational();
  for (RealRoot& root : roots_of(any_polynomial(3, 12) * with_root(t), counters)) {
    RealRoot copy = root;
    RealRoot other = root;
    RealRoot value{t};
    const int order = compare(copy, t, counters);
    RC_ASSERT(to_sign(order) == sign_at(with_root(t), root, counters));
    RC_ASSERT(order == compare(other, value, counters));
  }
}

RC_GTEST_PROP(RootProperties, NextSignChangeIsTheNextOddRoot, ()) {
  RootCounters counters;
  const Polynomial p = any_polynomial(3, 6) * power(any_polynomial(1, 4), 2);
  // From a rational start, and from a root of some polynomial (of p too).
  std::vector<RealRoot> starts = roots_of(any_polynomial(2, 4) * any_polynomial(2, 4), counters);
  starts.emplace_back(any_rational());
  for (RealRoot& r : roots_of(p, counters)) starts.push_back(r);
  std::vector<RootWithMultiplicity> expected = isolate_real_roots(p, counters);
  const Rational until = any_rational();
  const bool bounded = *rc::gen::inRange(0, 2) == 1;
  for (RealRoot& start : starts) {
    const std::optional<RealRoot> found = first_sign_change_after(
        p, start, bounded ? std::optional<Rational>(until) : std::nullopt, counters);
    RealRoot* next = nullptr;
    for (RootWithMultiplicity& entry : expected) {
      if (entry.multiplicity % 2 == 1 && compare(entry.root, start, counters) > 0) {
        next = &entry.root;
        break;
      }
    }
    if (next != nullptr && bounded && compare(*next, until, counters) > 0) next = nullptr;
    RC_ASSERT(found.has_value() == (next != nullptr));
    if (found) {
      RealRoot copy = *found;
      RC_ASSERT(compare(copy, *next, counters) == 0);
    }
  }
}

// t -> a t + b maps roots of p to roots of q(t) = p((t - b) / a) d^n.
RC_GTEST_PROP(RootProperties, RootsFollowAffineMaps, ()) {
  RootCounters counters;
  const Polynomial p = any_polynomial(4, 9);
  const Rational a(*rc::gen::inRange(1, 9));
  const Rational b = any_rational();
  // Horner with the linear polynomial (t - b) / a.
  std::vector<Rational> image = {Rational(p.leading())};
  for (int i = p.degree() - 1; i >= 0; --i) {
    std::vector<Rational> next(image.size() + 1);
    for (std::size_t k = 0; k < image.size(); ++k) {
      next[k] -= image[k] * b / a;
      next[k + 1] += image[k] / a;
    }
    next[0] += Rational(p[static_cast<std::size_t>(i)]);
    image = std::move(next);
  }
  const Polynomial q = Polynomial::from_rationals(image);
  std::vector<RootWithMultiplicity> before = isolate_real_roots(p, counters);
  std::vector<RootWithMultiplicity> after = isolate_real_roots(q, counters);
  RC_ASSERT(before.size() == after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    RC_ASSERT(before[i].multiplicity == after[i].multiplicity);
    RealRoot& x = before[i].root;
    x.refine_to(40, counters);
    RC_ASSERT(compare(after[i].root, x.lower() * a + b, counters) >= 0);
    RC_ASSERT(compare(after[i].root, x.upper() * a + b, counters) <= 0);
  }
}

RC_GTEST_PROP(RootProperties, MirroredPolynomialHasMirroredRoots, ()) {
  RootCounters counters;
  const Polynomial p = any_polynomial(5, 9);
  std::vector<Integer> c = p.coefficients();
  for (std::size_t i = 1; i < c.size(); i += 2) c[i].negate();
  const auto roots = isolate_real_roots(p, counters);
  const auto mirrored = isolate_real_roots(Polynomial(std::move(c)), counters);
  RC_ASSERT(roots.size() == mirrored.size());
  for (std::size_t i = 0; i < roots.size(); ++i) {
    RC_ASSERT(roots[i].multiplicity == mirrored[roots.size() - 1 - i].multiplicity);
    // The two intervals of one root meet.
    const RealRoot& other = mirrored[roots.size() - 1 - i].root;
    RC_ASSERT(roots[i].root.lower() <= -other.lower());
    RC_ASSERT(-other.upper() <= roots[i].root.upper());
  }
}

RC_GTEST_PROP(RootProperties, DecimalsEncloseTheRoot, ()) {
  RootCounters counters;
  const int digits = *rc::gen::inRange(0, 25);
  for (RealRoot& root : roots_of(any_polynomial(4, 9), counters)) {
    const std::string text = decimal(root, digits, counters);
    const Rational cut = Rational::parse(text).value();
    const Rational unit(Integer(1), power(Integer(10), static_cast<unsigned long>(digits)));
    if (text.front() == '-') {
      RC_ASSERT(compare(root, cut, counters) <= 0);
      RC_ASSERT(compare(root, cut - unit, counters) > 0);
    } else {
      RC_ASSERT(compare(root, cut, counters) >= 0);
      RC_ASSERT(compare(root, cut + unit, counters) < 0);
    }
  }
}

RC_GTEST_PROP(RootProperties, NamesAreCanonical, ()) {
  RootCounters counters;
  const Polynomial p = any_polynomial(3, 5);
  const Polynomial q = p * p * Polynomial({Integer(-3)});
  for (RootWithMultiplicity& entry : isolate_real_roots(p, counters)) {
    RealRoot fine = entry.root;
    fine.refine_to(60, counters);
    const RootName a = name_root(p, entry.root, counters);
    const RootName b = name_root(q, fine, counters);
    RC_ASSERT(a.polynomial == b.polynomial);
    RC_ASSERT(a.index == b.index);
    RC_ASSERT(a.lower == b.lower);
    RC_ASSERT(a.upper == b.upper);
  }
}

}  // namespace root_properties_test
}  // namespace kinex
