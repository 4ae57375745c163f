// SPDX-License-Identifier: GPL-3.0-or-later
// Names of the present instant. Naming works on copies: it changes no number of the run.
#include <utility>

#include "core/arithmetic/exact_arithmetic.h"
#include "core/numbers/instant_digits.h"
#include "core/numbers/tight_enclosure.h"

namespace kinex {

namespace {

// Reuses the memory of `out`.
void assign(Integer& out, Int128 value) {
  static_assert(GMP_NUMB_BITS == 64);
  const auto magnitude =
      value < 0 ? -static_cast<unsigned __int128>(value) : static_cast<unsigned __int128>(value);
  mp_limb_t* limbs = mpz_limbs_write(out.raw(), 2);
  limbs[0] = static_cast<mp_limb_t>(magnitude);
  limbs[1] = static_cast<mp_limb_t>(magnitude >> 64);
  mpz_limbs_finish(out.raw(), value < 0 ? -2 : 2);
}

}  // namespace

// Now has become the failure time of `query`, or, without one, `value`.
void ExactArithmetic::begin_name(const Query& query, const Rational* value) {
  naming_.query = query;
  if (value != nullptr) naming_.value = *value;
  naming_.lo = now_.lo;
  naming_.hi = now_.hi;
  naming_.isolated = now_.isolated;
  naming_.kept = false;
  name_of_now_.detail = InstantDetail::kNone;
}

// Called before the motion of `object` changes: polynomials may no longer vanish now afterwards.
void ExactArithmetic::keep_now(ObjectId object) {
  const auto involves = [object](const Query& query) {
    for (std::size_t i = 0; i < query.arity; ++i) {
      if (query.ids[i] == object) return true;
    }
    return false;
  };
  if (involves(naming_.query)) {
    set_name_polynomial();
    naming_.kept = true;
  }
  if (now_.own && involves(now_.query)) {
    now_root();
    now_.own = false;
  }
}

// Its polynomial, up to a constant factor.
void ExactArithmetic::set_name_polynomial() {
  if (naming_.kept) return;
  std::vector<Integer>& p = naming_.polynomial;
  const Query& query = naming_.query;
  const PredicateModel& model = models_[query.predicate];
  if (!model.narrow || !all_narrow(query)) {
    p = motions_.exact(*predicates_[query.predicate], query.ids.data()).coefficients();
    return;
  }
  Int128 out[kMaxFixedCoefficients];
  wide_coefficients(query, out);
  p.resize(static_cast<std::size_t>(model.degree) + 1);
  for (std::size_t i = 0; i < p.size(); ++i) assign(p[i], out[i]);
}

RealRoot ExactArithmetic::copy_of_now() {
  if (naming_.query.arity == 0) return RealRoot(naming_.value);
  if (now_.root != 0) return roots_[now_.root];
  set_name_polynomial();
  Polynomial p(naming_.polynomial);
  if (p.degree() == 1) return RealRoot(Rational(-p[0], p[1]));  // lo = hi = 0 is one of them
  if (naming_.lo == naming_.hi) return RealRoot(*Rational::from_double(naming_.lo));
  return RealRoot(std::move(p), *Rational::from_double(naming_.lo),
                  *Rational::from_double(naming_.hi));
}

const InstantName& ExactArithmetic::name_now(InstantDetail detail) {
  InstantName& name = name_of_now_;
  if (detail == InstantDetail::kNone || detail == name.detail) return name;
  ++name.number;
  name.detail = detail;
  name.exact = true;
  const bool rational = naming_.query.arity == 0;
  if (detail == InstantDetail::kInterval) {
    name.polynomial = Polynomial();
    name.root = 0;
  } else if (rational) {
    set_rational_name(naming_.value, name);
  } else {
    set_exact_name(name);
  }
  if (name.is_rational()) {
    set_decimal(name.decimal, name.lower);
    return name;
  }
  // If the enclosure does not determine it, one next to the instant nearly always does.
  const bool wants_interval = detail == InstantDetail::kInterval;
  double lo = now_.lo, hi = now_.hi;
  bool has_interval = !wants_interval || set_interval(lo, hi, name.lower, name.upper);
  bool has_decimal = set_decimal(name.decimal, lo, hi);
  if (has_interval && has_decimal) return name;
  if (!rational) {
    if (wants_interval) set_name_polynomial();
    if (tighten(wants_interval ? naming_.polynomial : name.polynomial.coefficients(), lo, hi)) {
      has_interval = has_interval || set_interval(lo, hi, name.lower, name.upper);
      has_decimal = has_decimal || set_decimal(name.decimal, lo, hi);
    }
  }
  if (has_interval && has_decimal) return name;
  RootCounters counters;
  RealRoot root = copy_of_now();
  const auto compare = [&](const Rational& t) { return kinex::compare(root, t, counters); };
  const auto refine = [&] { root.refine(counters); };
  if (!has_interval) set_exact_interval(root, compare, refine, name.lower, name.upper);
  if (!has_decimal) set_exact_decimal(name.decimal, root, compare, refine);
  return name;
}

// Polynomial, root, lower and upper.
void ExactArithmetic::set_exact_name(InstantName& name) {
  set_name_polynomial();
  std::vector<Integer> copy;
  if (naming_.kept) copy = naming_.polynomial;
  std::vector<Integer>& p = naming_.kept ? copy : naming_.polynomial;
  if (naming_.isolated && namer_.name(p, naming_.lo, naming_.hi, name)) return;
  RootCounters counters;
  RealRoot root = copy_of_now();
  RootName exact = name_root(Polynomial(p), root, counters);
  name.polynomial = std::move(exact.polynomial);
  name.root = exact.index;
  name.lower = std::move(exact.lower);
  name.upper = std::move(exact.upper);
}

}  // namespace kinex
