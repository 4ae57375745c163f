// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/log_instant.h"

#include <optional>

#include "core/numbers/instant_digits.h"
#include "core/numbers/polynomial_gcd.h"
#include "core/numbers/rational_root.h"
#include "core/numbers/sturm_sequence.h"

namespace kinex::formats {

namespace {

std::string shown_decimal(const std::string& said, const std::string& right) {
  return "the decimal is \"" + said + "\", that of the instant \"" + right + "\"";
}

std::string name_problem(const LogInstant& instant) {
  const Polynomial& p = instant.polynomial;
  if (!(p == p.canonical()))
    return "the polynomial is not primitive with a positive leading coefficient";
  if (instant.upper < instant.lower) return "the ends of the interval are in the wrong order";
  if (!(square_free_part(p) == p)) return "the polynomial is not square-free";
  const SturmSequence sturm(p);
  const bool point = instant.lower == instant.upper;
  if (point) {
    if (p.sign_at(instant.lower) != Sign::kZero) return "the rational is no root of the polynomial";
    if (p.degree() > 1) return "the polynomial of a rational instant is not linear";
  } else {
    if (!instant.lower.is_dyadic() || !instant.upper.is_dyadic())
      return "the interval is not dyadic";
    if (p.sign_at(instant.lower) == Sign::kZero || p.sign_at(instant.upper) == Sign::kZero) {
      return "an end of the interval is a root itself";
    }
    const int roots = sturm.count_between(instant.lower, instant.upper);
    if (roots != 1) return "the interval holds " + std::to_string(roots) + " roots, not one";
  }
  const int index = sturm.count_all() - sturm.count_above(instant.upper);
  if (index != instant.root) {
    return "the interval holds root " + std::to_string(index) + ", not root " +
           std::to_string(instant.root);
  }
  RealRoot root = root_of(instant);
  RootCounters counters;
  if (!point && rational_value(p, root, counters)) {
    return "the instant is rational: its polynomial is to be linear, its interval a point";
  }
  const std::string right = instant_decimal(root, counters);
  return right == instant.decimal ? "" : shown_decimal(instant.decimal, right);
}

// The decimal must be that of a number of the interval.
std::string interval_problem(const LogInstant& instant) {
  if (instant.upper < instant.lower) return "the ends of the interval are in the wrong order";
  const std::optional<DecimalRange> range = decimal_range(instant.decimal);
  if (!range) {
    return "\"" + instant.decimal + "\" is no decimal with " + std::to_string(kDecimalDigits) +
           " significant digits";
  }
  return instant.upper < range->lower || range->upper < instant.lower
             ? "the decimal is of no number of the interval"
             : "";
}

// The text of printf for a number, or of mpfr for its own.
std::string inexact_problem(const std::string& text) {
  if (text == "inf" || text == "-inf" || text == "nan" || text == "-nan") return "";
  if (!text.empty() && text.find_first_not_of("0123456789+-.e") == std::string::npos &&
      Rational::parse(text)) {
    return "";
  }
  return "the decimal \"" + text + "\" is no number";
}

}  // namespace

bool same_text(const LogInstant& a, const LogInstant& b) {
  return a.root == b.root && a.lower == b.lower && a.upper == b.upper && a.decimal == b.decimal &&
         a.polynomial == b.polynomial;
}

std::string instant_problem(const LogInstant& instant, const LogHeader& header) {
  if (header.has_names()) return name_problem(instant);
  if (header.has_intervals()) return interval_problem(instant);
  return inexact_problem(instant.decimal);
}

RealRoot root_of(const LogInstant& instant) {
  if (instant.lower == instant.upper) return RealRoot(instant.lower);
  return RealRoot(instant.polynomial, instant.lower, instant.upper);
}

}  // namespace kinex::formats
