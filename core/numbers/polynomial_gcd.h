// SPDX-License-Identifier: GPL-3.0-or-later
// Greatest common divisors, quotients and square-free decomposition of integer polynomials.
#ifndef KINEX_CORE_NUMBERS_POLYNOMIAL_GCD_H
#define KINEX_CORE_NUMBERS_POLYNOMIAL_GCD_H

#include <vector>

#include "core/numbers/polynomial.h"
#include "core/numbers/stop.h"

namespace kinex {

// Primitive gcd with positive leading coefficient; gcd(0, p) = canonical(p), gcd(0, 0) = 0.
// Exact. Modular: images modulo word-size primes, Chinese remaindering, trial division. Coprime
// inputs (the usual case) cost one prime: O(d^2) word operations plus the reductions.
// `deadline`, here and below, is polled between the steps; null: none.
Polynomial gcd(const Polynomial& a, const Polynomial& b, Deadline* deadline = nullptr);

// True: a and b are proved coprime, modulo one fixed prime. False proves nothing. The cheap half of
// gcd.
bool coprime_modulo_prime(const Polynomial& a, const Polynomial& b);

// a / b where b divides a over the rationals; the primitive part of the quotient with the
// quotient's sign.
Polynomial exact_quotient(const Polynomial& a, const Polynomial& b);

// canonical(p / gcd(p, p')): the same roots, each once. p not zero.
Polynomial square_free_part(const Polynomial& p, Deadline* deadline = nullptr);

// Yun: p = constant * product of result[i]^(i+1). Every result[i] is canonical, square-free, and
// coprime to the others (degree 0 where no root has that multiplicity). p not zero.
std::vector<Polynomial> square_free_decomposition(const Polynomial& p,
                                                  Deadline* deadline = nullptr);

// The product of the square-free factors of odd multiplicity, with the sign of p at +infinity. It
// changes sign exactly where p does, and has the sign of p wherever p is not zero. p not zero.
Polynomial odd_part(const Polynomial& p, Deadline* deadline = nullptr);

}  // namespace kinex

#endif
