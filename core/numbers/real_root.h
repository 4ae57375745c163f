// SPDX-License-Identifier: GPL-3.0-or-later
// RealRoot: a real algebraic number as a polynomial and an isolating interval with dyadic ends.
#ifndef KINEX_CORE_NUMBERS_REAL_ROOT_H
#define KINEX_CORE_NUMBERS_REAL_ROOT_H

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/numbers/instant_name.h"
#include "core/numbers/polynomial.h"
#include "core/numbers/stop.h"

namespace kinex {

// Counts of exact work and a deadline; a plain value owned by the caller and passed by reference.
struct RootCounters {
  std::uint64_t isolations = 0;   // calls that isolated roots of a polynomial
  std::uint64_t refinements = 0;  // refinement steps of an interval
  std::uint64_t gcds = 0;         // exact polynomial gcds
  std::uint64_t max_bits = 0;     // largest coefficient bit length
  Deadline* deadline = nullptr;   // polled in every step that may be long; null: none
};

// Invariant, one of:
//   rational  the number is known to be the rational value(); polynomial() is den*t - num
//   isolated  polynomial() has opposite non-zero signs at lower() < upper() (finite, dyadic) and
//             exactly one real root between them (it need not be square-free elsewhere)
// Refinement is explicit: a function that may narrow the interval takes the root by non-const
// reference. A refinement that hits the root exactly turns `isolated` into `rational`.
class RealRoot {
 public:
  explicit RealRoot(Rational value);
  // Requires the `isolated` invariant (asserted for the signs); lower, upper dyadic.
  RealRoot(Polynomial polynomial, const Rational& lower, const Rational& upper);

  bool is_rational() const { return rational_; }
  Polynomial polynomial() const;
  Rational lower() const;  // both ends equal value() when rational
  Rational upper() const;
  Rational value() const;                                // requires is_rational()
  Sign sign_at_lower() const { return sign_at_lower_; }  // of polynomial(); kZero when rational

  // Becomes this number. Needs no memory beyond that of its parts.
  void set(const Rational& value) { become_rational(value); }
  // At least halves the interval (quadratic interval refinement: Abbott 2006).
  void refine(RootCounters& counters);
  // Refines until upper - lower <= 2^-bits.
  void refine_to(long bits, RootCounters& counters);
  // Outer double enclosure: the largest double <= lower() and the smallest double >= upper().
  double lower_double() const;
  double upper_double() const;

 private:
  friend class RootFinder;
  friend int compare(RealRoot& a, RealRoot& b, RootCounters& counters);
  friend int compare(RealRoot& a, const Rational& b, RootCounters& counters);
  friend Sign sign_at(const Polynomial& q, RealRoot& root, RootCounters& counters);

  // An approximate value mantissa * 2^exponent of the polynomial at an end; mantissa 0: not known.
  struct Value {
    Integer mantissa;
    long exponent = 0;
  };
  // Both ends are known to satisfy the invariant.
  RealRoot(std::shared_ptr<const Polynomial> polynomial, Integer lower, Integer upper,
           long exponent, Sign sign_at_lower);

  void become_rational(const Rational& value);
  // One step of quadratic interval refinement, with k = min(qir_bits_, max_bits):
  //
  //   lower_           guess (secant)           upper_
  //     |---|---|---|---|-x-|---|---|---|---|---|        about 2^k parts
  //
  // If the root is in a part next to the guess, qir_bits_ is doubled, else halved.
  void step(unsigned max_bits, RootCounters& counters);
  // The first step: an approximate root in doubles, then two exact signs around it.
  bool step_from_double();
  // Cuts at the multiple of 2^grid nearest to `guess` and, with `try_neighbour`, at its neighbour
  // towards the root. True if the root is proved to lie between two neighbouring multiples.
  bool narrow_around(const Integer& guess, unsigned long grid, bool try_neighbour);
  // Moves one end to the given point, if that is inside.
  void cut_at(const Integer& numerator, long exponent, RootCounters& counters);
  void set_exponent(long exponent);
  void shorten();
  Sign evaluate(const Integer& numerator, Value& value) const;
  Integer guess(const Integer& width);
  bool width_at_most(long bits) const;  // upper - lower <= 2^-bits
  // -1, 0, +1: the interval lies below the other one, overlaps it, or lies above it.
  int side_of(const RealRoot& other) const;
  // Whether `g` has opposite signs at the ends.
  bool changes_sign(const Polynomial& g) const;

  // The interval is [lower_, upper_] / 2^exponent_; both are 0 when rational.
  std::shared_ptr<const Polynomial> polynomial_;  // none if it is rational
  Integer lower_, upper_;
  long exponent_ = 0;      // may be negative (large numbers)
  unsigned qir_bits_ = 1;  // log2 of the number of parts the next refinement tries
  Sign sign_at_lower_ = Sign::kZero;
  bool rational_ = false;
  bool tried_double_ = false;
  std::optional<Rational> value_;
  Value value_at_lower_, value_at_upper_;
};

// -1, 0, +1: exact. Disjoint intervals are compared at once; equality is proved by a gcd.
int compare(RealRoot& a, RealRoot& b, RootCounters& counters);
int compare(RealRoot& a, const Rational& b, RootCounters& counters);

// Sign of q at the root, on (root, root + eps), and on (root - eps, root). The last two are kZero
// only if q is identically zero.
Sign sign_at(const Polynomial& q, RealRoot& root, RootCounters& counters);
Sign sign_after(const Polynomial& q, RealRoot& root, RootCounters& counters);
Sign sign_before(const Polynomial& q, RealRoot& root, RootCounters& counters);

// All distinct real roots in ascending order, with pairwise disjoint isolating intervals (their
// closures may share an end point only if that end is not a root). The RealRoots carry the
// square-free factor they come from. Any degree; Descartes' rule in the Bernstein basis, integer
// arithmetic.
struct RootWithMultiplicity {
  RealRoot root;
  int multiplicity;
};
std::vector<RootWithMultiplicity> isolate_real_roots(const Polynomial& p, RootCounters& counters);

// The first root of odd multiplicity of p strictly above `after` and at most `until` (no limit if
// nullopt): the next sign change of p. nullopt if there is none. p not zero.
std::optional<RealRoot> first_sign_change_after(const Polynomial& p, RealRoot& after,
                                                const std::optional<Rational>& until,
                                                RootCounters& counters);

// The name of a root of p: a function of p and the index alone, however the root was computed.
//
//               rational number         irrational number
//   polynomial  den t - num             the canonical square-free part of p
//   index       1                       among its real roots in ascending order, from 1
//   lower       num/den                 [lower, upper] is the coarsest cell +-[m, m + 1] 2^e with
//   upper       num/den                 2^k <= m < 2^(k+1), k = 0, 1, .., that contains this root
//                                       and no other, ends included
//
// The cell shows as many binary digits of the root as separate it from the others.
struct RootName {
  Polynomial polynomial;
  int index;
  Rational lower, upper;
};
// The name of `root` as a root of p (p not zero, p(root) = 0).
RootName name_root(const Polynomial& p, RealRoot& root, RootCounters& counters);

// The number with this exact name (detail kName).
RealRoot to_root(const InstantName& name);

// -1, 0, +1: exact. At once for equal names, roots of one polynomial, and disjoint intervals.
int compare(const InstantName& a, const InstantName& b, RootCounters& counters);

// The decimal of an instant in logs: see core/numbers/instant_digits.h.
std::string instant_decimal(RealRoot& instant, RootCounters& counters);

// Decimal expansion with `digits` correct digits after the point, rounded towards zero ("0.3333").
std::string decimal(RealRoot& root, int digits, RootCounters& counters);

}  // namespace kinex

#endif
