// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/polynomial_gcd.h"

#include <optional>
#include <utility>

#include "core/numbers/check.h"
#include "core/numbers/modular.h"

namespace kinex {

namespace {

Polynomial constant(int value) { return Polynomial({Integer(value)}); }

bool divides(const Integer& b, const Integer& a) { return mpz_divisible_p(a.raw(), b.raw()) != 0; }

// a / b if b divides a over the integers.
std::optional<Polynomial> divide(const Polynomial& a, const Polynomial& b, Deadline* deadline) {
  if (a.degree() < b.degree()) return std::nullopt;
  if (!divides(b.leading(), a.leading())) return std::nullopt;
  // b | a implies b(0) | a(0), b(1) | a(1) and so on; the constant term is free.
  if (b[0].is_zero() ? !a[0].is_zero() : !divides(b[0], a[0])) return std::nullopt;
  std::vector<Integer> rest = a.coefficients();
  const auto size_b = static_cast<std::size_t>(b.degree()) + 1;
  std::vector<Integer> quotient(rest.size() - size_b + 1);
  for (std::size_t k = quotient.size(); k-- > 0;) {
    look(deadline);
    Integer& lead = rest[k + size_b - 1];
    if (lead.is_zero()) continue;
    if (!divides(b.leading(), lead)) return std::nullopt;
    lead.divide_exactly(b.leading());
    for (std::size_t i = 0; i + 1 < size_b; ++i) rest[k + i].subtract_product(lead, b[i]);
    quotient[k] = std::move(lead);
  }
  for (std::size_t i = 0; i + 1 < size_b; ++i) {
    if (!rest[i].is_zero()) return std::nullopt;
  }
  return Polynomial(std::move(quotient));
}

// Coefficients of a polynomial modulo a growing product of primes, in the symmetric range.
class ChineseRemainder {
 public:
  bool empty() const { return values_.empty(); }
  std::size_t size() const { return values_.size(); }
  void restart() {
    values_.clear();
    modulus_ = Integer(1);
  }
  // True if no coefficient changed.
  bool add(const PrimeField& field, const Residues& image) {
    if (values_.empty()) values_.resize(image.size());
    if (modulus_ == Integer(1)) {
      for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = symmetric(field, image[i]);
      modulus_ = Integer(static_cast<std::int64_t>(field.prime()));
      return false;
    }
    const std::uint64_t inverse = field.inverse(field.from_integer(modulus_));
    const Integer next_modulus = modulus_ * Integer(static_cast<std::int64_t>(field.prime()));
    const Integer half = next_modulus >> 1;
    bool stable = true;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const std::uint64_t gap = field.subtract(image[i], field.from_integer(values_[i]));
      if (gap == 0) continue;
      stable = false;
      mpz_addmul_ui(values_[i].raw(), modulus_.raw(), field.to_word(field.multiply(gap, inverse)));
      if (values_[i] > half) values_[i] -= next_modulus;
    }
    modulus_ = next_modulus;
    return stable;
  }
  Polynomial polynomial() const { return Polynomial(values_); }

 private:
  static Integer symmetric(const PrimeField& field, std::uint64_t residue) {
    const auto word = static_cast<std::int64_t>(field.to_word(residue));
    const auto prime = static_cast<std::int64_t>(field.prime());
    return Integer(word > prime / 2 ? word - prime : word);
  }
  std::vector<Integer> values_;
  Integer modulus_{1};
};

// gcd of two polynomials of positive degree. A common content only makes `leading` too large.
Polynomial modular_gcd(const Polynomial& a, const Polynomial& b, Deadline* deadline) {
  Integer leading;
  PrimeSequence primes;
  ChineseRemainder images;
  for (int used = 0;;) {
    look(deadline);
    const PrimeField field(primes.next());
    Residues image_a = residues(field, a);
    Residues image_b = residues(field, b);
    // The prime must not divide both leading coefficients, or a common factor may be missed.
    if (static_cast<int>(image_a.size()) <= a.degree() &&
        static_cast<int>(image_b.size()) <= b.degree()) {
      continue;
    }
    Residues image = gcd(field, std::move(image_a), std::move(image_b));
    if (image.size() <= 1) return constant(1);
    if (leading.is_zero()) {
      // Mostly one divides the other: the polynomial of an instant and one that vanishes there.
      const bool a_is_smaller = a.degree() < b.degree();
      const Polynomial& smaller = a_is_smaller ? a : b;
      if (static_cast<int>(image.size()) == smaller.degree() + 1) {
        Polynomial candidate = smaller.canonical();
        if (divide(a_is_smaller ? b : a, candidate, deadline)) return candidate;
      }
      leading = gcd(a.leading(), b.leading());
    }
    // Unlucky primes: this one if its image has a higher degree, all earlier ones if a lower one.
    if (!images.empty() && image.size() > images.size()) continue;
    if (!images.empty() && image.size() < images.size()) {
      images.restart();
      used = 0;
    }
    const std::uint64_t scale =
        field.multiply(field.from_integer(leading), field.inverse(image.back()));
    for (std::uint64_t& r : image) r = field.multiply(r, scale);
    const bool stable = images.add(field, image);
    ++used;
    // Small answers are right before they are stable; a wrong one mostly fails after one division.
    if (!stable && used > 2) continue;
    Polynomial candidate = images.polynomial().canonical();
    if (divide(a, candidate, deadline) && divide(b, candidate, deadline)) return candidate;
  }
}

struct CoprimeFactors {
  Polynomial common;       // gcd(p, p'), canonical
  Polynomial square_free;  // canonical(p / common)
};

// p canonical and of positive degree.
CoprimeFactors split_repeated(const Polynomial& p, Deadline* deadline) {
  const Polynomial derivative = p.derivative();
  if (coprime_modulo_prime(p, derivative)) return {constant(1), p};
  Polynomial common = gcd(p, derivative, deadline);
  Polynomial square_free = exact_quotient(p, common);
  return {std::move(common), std::move(square_free)};
}

}  // namespace

Polynomial gcd(const Polynomial& a, const Polynomial& b, Deadline* deadline) {
  if (a.is_zero()) return b.canonical();
  if (b.is_zero()) return a.canonical();
  if (a.degree() == 0 || b.degree() == 0) return constant(1);
  return modular_gcd(a, b, deadline);
}

bool coprime_modulo_prime(const Polynomial& a, const Polynomial& b) {
  if (a.is_zero() || b.is_zero()) return a.degree() == 0 || b.degree() == 0;
  if (a.degree() == 0 || b.degree() == 0) return true;
  PrimeSequence primes;
  const PrimeField field(primes.next());
  Residues first = residues(field, a);
  Residues second = residues(field, b);
  // If the prime divides both leading coefficients the image may miss a common factor.
  if (static_cast<int>(first.size()) <= a.degree() &&
      static_cast<int>(second.size()) <= b.degree()) {
    return false;
  }
  return gcd(field, std::move(first), std::move(second)).size() == 1;
}

Polynomial exact_quotient(const Polynomial& a, const Polynomial& b) {
  require(!b.is_zero(), "exact_quotient: division by the zero polynomial");
  if (a.is_zero()) return a;
  std::optional<Polynomial> quotient = divide(a.primitive_part(), b.primitive_part(), nullptr);
  require(quotient.has_value(), "exact_quotient: the divisor does not divide");
  return std::move(*quotient);
}

Polynomial square_free_part(const Polynomial& p, Deadline* deadline) {
  require(!p.is_zero(), "square_free_part: zero polynomial");
  if (p.degree() == 0) return constant(1);
  return split_repeated(p.canonical(), deadline).square_free;
}

std::vector<Polynomial> square_free_decomposition(const Polynomial& p, Deadline* deadline) {
  require(!p.is_zero(), "square_free_decomposition: zero polynomial");
  std::vector<Polynomial> factors;
  if (p.degree() == 0) return factors;
  const Polynomial canonical = p.canonical();
  CoprimeFactors parts = split_repeated(canonical, deadline);
  // Musser: w is the product of the factors of multiplicity > i, `common` has each once less.
  Polynomial w = std::move(parts.square_free);
  Polynomial common = std::move(parts.common);
  while (w.degree() > 0) {
    Polynomial still = gcd(w, common, deadline);
    factors.push_back(still.degree() == 0 ? w : exact_quotient(w, still));
    if (still.degree() > 0) common = exact_quotient(common, still);
    w = std::move(still);
  }
  return factors;
}

Polynomial odd_part(const Polynomial& p, Deadline* deadline) {
  require(!p.is_zero(), "odd_part: zero polynomial");
  Polynomial result = constant(1);
  const std::vector<Polynomial> factors = square_free_decomposition(p, deadline);
  for (std::size_t i = 0; i < factors.size(); i += 2) {
    result = result.degree() == 0 ? factors[i] : result * factors[i];
  }
  return p.leading().sign() < 0 ? -result : result;
}

}  // namespace kinex
