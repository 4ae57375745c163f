// SPDX-License-Identifier: GPL-3.0-or-later
// Isolation of all real roots, search for the next sign change, and names of roots.
#include <algorithm>
#include <iterator>
#include <utility>

#include "core/numbers/check.h"
#include "core/numbers/dyadic.h"
#include "core/numbers/instant_digits.h"
#include "core/numbers/polynomial_gcd.h"
#include "core/numbers/rational_root.h"
#include "core/numbers/real_root.h"
#include "core/numbers/root_finder.h"

namespace kinex {

namespace {

// The depth at which a search tests whether its polynomial is square-free.
constexpr long kDepthBeforeGcd = 8;
// Bits after the binary point of the point where a search starts.
constexpr long kOriginBits = 16;

using PolynomialPointer = std::shared_ptr<const Polynomial>;

Polynomial mirrored(const Polynomial& p) {
  std::vector<Integer> c = p.coefficients();
  for (std::size_t i = 1; i < c.size(); i += 2) c[i].negate();
  return Polynomial(std::move(c));
}

// p(-t) = +-p(t).
bool is_symmetric(const Polynomial& p) {
  for (std::size_t i = p.coefficients().size() - 1; i-- > 0;) {
    if ((static_cast<std::size_t>(p.degree()) - i) % 2 == 1 && !p[i].is_zero()) return false;
  }
  return true;
}

RealRoot current_root(const RootFinder& finder, RootFinder::Status status) {
  return status == RootFinder::Status::kPoint ? RealRoot(finder.point()) : finder.root();
}

// p square-free and of positive degree.
std::vector<RealRoot> isolate_square_free(const PolynomialPointer& p, RootCounters& counters) {
  using Status = RootFinder::Status;
  std::vector<RealRoot> roots;
  if (p->degree() == 1) {
    roots.emplace_back(Rational(-(*p)[0], (*p)[1]));
    return roots;
  }
  std::vector<RealRoot> positive;
  RootFinder above(p, Integer(), 0, std::nullopt, counters);
  const bool symmetric = is_symmetric(*p);
  for (Status status; (status = above.next()) != Status::kFinished;) {
    positive.push_back(current_root(above, status));
    if (!symmetric) continue;
    roots.push_back(status == Status::kPoint ? RealRoot(-above.point()) : above.mirrored_root(p));
  }
  if (!symmetric) {
    RootFinder below(std::make_shared<const Polynomial>(mirrored(*p)), Integer(), 0, std::nullopt,
                     counters);
    for (Status status; (status = below.next()) != Status::kFinished;) {
      roots.push_back(status == Status::kPoint ? RealRoot(-below.point()) : below.mirrored_root(p));
    }
  }
  std::reverse(roots.begin(), roots.end());
  if ((*p)[0].is_zero()) roots.emplace_back(Rational(0));
  std::move(positive.begin(), positive.end(), std::back_inserter(roots));
  return roots;
}

// Ascending, disjoint; the roots of both are disjoint sets.
std::vector<RootWithMultiplicity> merge(std::vector<RootWithMultiplicity> a,
                                        std::vector<RootWithMultiplicity> b,
                                        RootCounters& counters) {
  std::vector<RootWithMultiplicity> result;
  result.reserve(a.size() + b.size());
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() && j < b.size()) {
    if (compare(a[i].root, b[j].root, counters) < 0) {
      result.push_back(std::move(a[i++]));
    } else {
      result.push_back(std::move(b[j++]));
    }
  }
  std::move(a.begin() + static_cast<std::ptrdiff_t>(i), a.end(), std::back_inserter(result));
  std::move(b.begin() + static_cast<std::ptrdiff_t>(j), b.end(), std::back_inserter(result));
  return result;
}

}  // namespace

std::vector<RootWithMultiplicity> isolate_real_roots(const Polynomial& p, RootCounters& counters) {
  require(!p.is_zero(), "isolate_real_roots: zero polynomial");
  ++counters.isolations;
  counters.max_bits = std::max<std::uint64_t>(counters.max_bits, p.max_bits());
  std::vector<RootWithMultiplicity> all;
  std::vector<Polynomial> factors = square_free_decomposition(p, counters.deadline);
  for (std::size_t i = 0; i < factors.size(); ++i) {
    if (factors[i].degree() < 1) continue;
    std::vector<RootWithMultiplicity> found;
    for (RealRoot& root :
         isolate_square_free(std::make_shared<const Polynomial>(std::move(factors[i])), counters)) {
      found.push_back({std::move(root), static_cast<int>(i) + 1});
    }
    all = all.empty() ? std::move(found) : merge(std::move(all), std::move(found), counters);
  }
  // Comparing with a rational root need not have narrowed an interval. No interval ends at a root.
  for (std::size_t i = 1; i < all.size(); ++i) {
    RealRoot& below = all[i - 1].root;
    RealRoot& above = all[i].root;
    if (below.is_rational() == above.is_rational()) continue;
    RealRoot& narrowed = below.is_rational() ? above : below;
    while (below.upper() >= above.lower()) narrowed.refine(counters);
  }
  return all;
}

std::optional<RealRoot> first_sign_change_after(const Polynomial& p, RealRoot& after,
                                                const std::optional<Rational>& until,
                                                RootCounters& counters) {
  require(!p.is_zero(), "first_sign_change_after: zero polynomial");
  if (p.degree() == 0) return std::nullopt;
  ++counters.isolations;
  counters.max_bits = std::max<std::uint64_t>(counters.max_bits, p.max_bits());
  if (p.degree() == 1) {
    Rational value(-p[0], p[1]);
    if (until && value > *until) return std::nullopt;
    if (compare(after, value, counters) >= 0) return std::nullopt;
    return RealRoot(value);
  }
  if (p.degree() == 2 && after.is_rational()) {
    const Rational root = after.value();
    if (p.sign_at(root) == Sign::kZero) {  // the other one is rational, too
      const Rational value = Rational(-p[1], p[2]) - root;
      if (value <= root || (until && value > *until)) return std::nullopt;
      return RealRoot(value);
    }
  }

  // A dyadic starting point at or below `after`.
  const Rational lower = after.lower();
  long exponent = dyadic_exponent(lower);
  const bool starts_at_after =
      after.is_rational() && lower.is_dyadic() && exponent <= 4 * kOriginBits;
  Integer origin;
  if (starts_at_after || (lower.is_dyadic() && exponent <= kOriginBits)) {
    origin = lower.numerator();
  } else {
    exponent = kOriginBits;
    origin = floor_divide(lower.numerator() << kOriginBits, lower.denominator());
  }
  std::optional<Integer> limit;
  if (until) {
    limit = floor_divide(until->numerator() << static_cast<unsigned long>(exponent),
                         until->denominator());
    *limit += Integer(1);
  }

  auto polynomial = std::make_shared<const Polynomial>(p);
  using Status = RootFinder::Status;
  for (bool square_free_known = false;;) {
    RootFinder finder(polynomial, origin, exponent, limit, counters);
    if (!square_free_known) finder.set_depth_limit(kDepthBeforeGcd);
    Status status;
    while ((status = finder.next()) != Status::kFinished) {
      if (status == Status::kStuck) {
        square_free_known = true;
        if (!coprime_modulo_prime(*polynomial, polynomial->derivative())) {
          ++counters.gcds;
          polynomial = std::make_shared<const Polynomial>(odd_part(*polynomial, counters.deadline));
          if (polynomial->degree() == 0) return std::nullopt;
          break;
        }
        finder.set_depth_limit(-1);
        continue;
      }
      if (finder.multiplicity() % 2 == 0) continue;
      RealRoot candidate = current_root(finder, status);
      if (!starts_at_after && compare(after, candidate, counters) >= 0) continue;
      if (until && compare(candidate, *until, counters) > 0) return std::nullopt;
      return candidate;
    }
    if (status == Status::kFinished) return std::nullopt;
  }
}

std::string instant_decimal(RealRoot& instant, RootCounters& counters) {
  std::string text;
  set_exact_decimal(
      text, instant, [&](const Rational& t) { return compare(instant, t, counters); },
      [&] { instant.refine(counters); });
  return text;
}

int compare(const InstantName& a, const InstantName& b, RootCounters& counters) {
  const auto less = [](const Rational& x, const Rational& y) { return mpq_cmp(x.raw(), y.raw()) < 0; };
  if (a.is_rational() && b.is_rational()) {
    return less(a.lower, b.lower) ? -1 : less(b.lower, a.lower) ? 1 : 0;
  }
  // The ends of an isolating interval are not roots.
  if (!less(b.lower, a.upper)) return -1;
  if (!less(a.lower, b.upper)) return 1;
  if (a.is_rational() == b.is_rational() && a.polynomial == b.polynomial) {
    return a.root < b.root ? -1 : a.root > b.root ? 1 : 0;
  }
  RealRoot x = to_root(a), y = to_root(b);
  return compare(x, y, counters);
}

RealRoot to_root(const InstantName& name) {
  if (name.is_rational()) return RealRoot(name.lower);
  return RealRoot(name.polynomial, name.lower, name.upper);
}

namespace {

// The coarsest cell around `root` that reaches neither neighbour (null: there is none).
DyadicCell isolating_cell(RealRoot& root, RealRoot* below, RealRoot* above, RootCounters& counters) {
  const auto order = [&](const Rational& t) { return compare(root, t, counters); };
  const auto refine = [&] { root.refine(counters); };
  const bool negative = sign_of_instant(root, order, refine) < 0;
  Rational lower, upper;
  const auto isolates = [&](const DyadicCell& cell) {
    set_interval(cell, negative, lower, upper);
    return (below == nullptr || compare(*below, lower, counters) < 0) &&
           (above == nullptr || compare(*above, upper, counters) > 0);
  };
  // Cells are nested: bits - 1 do not isolate, bits do.
  long few = 0, bits = 1;
  DyadicCell cell = leading_bits(root, bits, order, refine);
  while (!isolates(cell)) {
    few = bits;
    bits *= 2;
    cell = leading_bits(root, bits, order, refine);
  }
  while (bits - few > 1) {
    const long middle = few + (bits - few) / 2;
    DyadicCell candidate = leading_bits(root, middle, order, refine);
    if (isolates(candidate)) {
      bits = middle;
      cell = std::move(candidate);
    } else {
      few = middle;
    }
  }
  return cell;
}

}  // namespace

RootName name_root(const Polynomial& p, RealRoot& root, RootCounters& counters) {
  require(!p.is_zero(), "name_root: zero polynomial");
  Polynomial square_free = square_free_part(p, counters.deadline);
  if (const std::optional<Rational> value = rational_value(square_free, root, counters)) {
    require(square_free.sign_at(*value) == Sign::kZero, "name_root: not a root of the polynomial");
    return {Polynomial({-value->numerator(), value->denominator()}), 1, *value, *value};
  }
  std::vector<RootWithMultiplicity> all = isolate_real_roots(square_free, counters);
  // `root` is one of them; narrow it until only one is left.
  for (;;) {
    const Rational lower = root.lower();
    const Rational upper = root.upper();
    int candidates = 0;
    std::size_t index = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].root.upper() < lower || upper < all[i].root.lower()) continue;
      ++candidates;
      index = i;
    }
    require(candidates > 0, "name_root: not a root of the polynomial");
    if (candidates == 1) {
      RealRoot* const below = index > 0 ? &all[index - 1].root : nullptr;
      RealRoot* const above = index + 1 < all.size() ? &all[index + 1].root : nullptr;
      RootName name{std::move(square_free), static_cast<int>(index) + 1, {}, {}};
      const DyadicCell cell = isolating_cell(root, below, above, counters);
      set_interval(cell, root.upper().sign() <= 0, name.lower, name.upper);
      return name;
    }
    root.refine(counters);
  }
}

}  // namespace kinex
