// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/power_verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace kinex::lab {

namespace {

constexpr int kFewestExactSizes = 4;  // three may lie on a power by chance
// Of a fit with a term, without standard errors: with fewer its interval is wide without any scatter.
constexpr int kFewestDegreesOfTerm = 2;

std::string interval_text(const std::string& x, const Fit& fit) {
  return fmt::format("{}^{:.4f}, 95% in [{:.4f}, {:.4f}]", x, fit.b, fit.lower, fit.upper);
}

std::string chi_square_text(const Fit& fit) {
  return fmt::format("chi^2 = {:.1f} on {}", fit.chi_square, fit.degrees);
}

Verdict compare(const Fit& fit, const ClaimedPower& claim) {
  return compare_with_claim(fit.lower, fit.upper, claim.exponent, claim.tolerance, claim.at_most);
}

void not_confirmed(PowerVerdict& result, const std::string& why) {
  result.observed += why;
  if (result.verdict == Verdict::kConfirmed) result.verdict = Verdict::kOpen;
}

double term_of(const ClaimedPower& claim, double n) { return std::pow(n, -claim.lower_order); }

std::string law_text(double order) { return fmt::format("a n^b exp(c / n^{:.3g})", order); }

// With a term that is smaller by n^order.
std::optional<Fit> fit_with_term(std::span<const FitPoint> points, double order) {
  return fit_power_with(law_text(order), points, [order](double n) { return std::pow(n, -order); });
}

// The fit with the term, added to the text; false for too few points.
bool fit_term(PowerVerdict& result, std::span<const FitPoint> points, const ClaimedPower& claim,
              const std::string& x) {
  result.corrected = fit_with_term(points, claim.lower_order);
  if (!result.corrected) return false;
  result.observed += fmt::format("; with a term of order {}^(b - {:.3g}): {}", x, claim.lower_order,
                                 interval_text(x, *result.corrected));
  if (result.corrected->weighted) result.observed += ", " + chi_square_text(*result.corrected);
  return true;
}

// Chance does not explain the chi squared of the power alone.
void judge_by_term(PowerVerdict& result, std::span<const FitPoint> points, const ClaimedPower& claim,
                   const std::string& x) {
  result.observed += ", " + chi_square_text(*result.fit) + ", too large for chance";
  if (!fit_term(result, points, claim, x)) {
    not_confirmed(result, ", too few sizes for a term of lower order");
    return;
  }
  const Verdict alone = result.verdict;
  result.verdict = compare(*result.corrected, claim);
  if (!is_improbable(*result.corrected)) {
    const bool apart = (result.fit->b < claim.exponent) != (result.corrected->b < claim.exponent);
    if (alone != Verdict::kRefuted || result.verdict != Verdict::kRefuted || !apart) return;
    result.observed += ", on the other side of the claim";
    result.verdict = Verdict::kOpen;
    return;
  }
  result.observed += ", too large for chance, too";
  const bool both = alone == Verdict::kRefuted && result.verdict == Verdict::kRefuted;
  if (!both) result.verdict = Verdict::kOpen;
}

bool is_narrower(const Fit& fit, const Fit& other) {
  return fit.upper - fit.lower < other.upper - other.lower;
}

// The power alone refutes the claim, and chance explains its chi squared. Does the claim with the term
// fit, with the exponent that the claim allows and that is nearest to the fitted one?
void reconsider(PowerVerdict& result, std::span<const FitPoint> points, const ClaimedPower& claim,
                const std::string& x) {
  if (!fit_term(result, points, claim, x)) return;
  const Fit& fit = *result.corrected;
  bool refuted = compare(fit, claim) == Verdict::kRefuted;
  if (!refuted && !fit.weighted && fit.degrees < kFewestDegreesOfTerm && !is_narrower(fit, *result.fit)) {
    result.observed += ", wider, from too few sizes";
    return;
  }
  if (fit.weighted) {
    const double most = std::min(fit.b, claim.exponent + claim.tolerance);
    const double nearest = claim.at_most ? most : std::max(most, claim.exponent - claim.tolerance);
    const std::optional<Fit> claimed =
        fit_given_power_with(nearest, law_text(claim.lower_order), points,
                             [claim](double n) { return term_of(claim, n); });
    refuted = claimed && is_improbable(*claimed);
    if (claimed) {
      result.observed +=
          fmt::format("; with that term and {}^{:.4g}: {}", x, nearest, chi_square_text(*claimed));
    }
  }
  if (refuted) {
    if (fit.weighted) result.observed += ", too large for chance";
    return;
  }
  result.observed += ", not refuted";
  result.verdict = Verdict::kOpen;
}

// The interval of the power alone neither lies within the tolerance nor outside, and the counts are exact:
// only terms of lower order can have made it so wide.
void narrow_down(PowerVerdict& result, std::span<const FitPoint> points, const ClaimedPower& claim,
                 const std::string& x) {
  if (!fit_term(result, points, claim, x)) return;
  const Fit& fit = *result.corrected;
  if (fit.degrees < kFewestDegreesOfTerm || !is_narrower(fit, *result.fit)) return;
  if (compare(fit, claim) == Verdict::kConfirmed) result.verdict = Verdict::kConfirmed;
}

// A claim that is confirmed must not owe that to the order of the term.
void try_other_orders(PowerVerdict& result, std::span<const FitPoint> points,
                      const ClaimedPower& claim, const std::string& x) {
  std::vector<double> orders(claim.other_orders.begin(), claim.other_orders.end());
  orders.push_back(claim.lower_order);
  std::sort(orders.begin(), orders.end());
  bool is_within = true;
  std::string exponents;
  for (const double order : orders) {
    const std::optional<Fit> fit = fit_with_term(points, order);
    if (!fit) return not_confirmed(result, ", too few sizes for terms of other orders");
    const bool is_explained = !is_improbable(*fit);
    if (is_explained) {
      is_within = is_within && fit->b <= claim.exponent + claim.tolerance &&
                  (claim.at_most || fit->b >= claim.exponent - claim.tolerance);
    }
    exponents +=
        fmt::format("{}{:.4f} (order {}^(b - {:.3g}), {}{})", exponents.empty() ? "" : ", ", fit->b,
                    x, order, chi_square_text(*fit), is_explained ? "" : ", too large for chance");
  }
  result.observed += "; the order of the term is not known: exponents " + exponents;
  if (is_within) return;
  not_confirmed(result, ", not all within the tolerance");
}

}  // namespace

PowerVerdict judge_power(std::span<const FitPoint> points, const ClaimedPower& claim,
                         const std::string& x) {
  PowerVerdict result;
  result.fit = fit_power(points);
  if (!result.fit) {
    result.observed = "too few sizes";
    return result;
  }
  const Fit& fit = *result.fit;
  result.observed = interval_text(x, fit);
  result.verdict = compare(fit, claim);
  if (is_improbable(fit)) {
    judge_by_term(result, points, claim, x);
  } else if (result.verdict == Verdict::kRefuted) {
    reconsider(result, points, claim, x);
  } else if (result.verdict == Verdict::kOpen && !fit.weighted) {
    narrow_down(result, points, claim, x);
  }
  if (!fit.weighted && fit.degrees + 2 < kFewestExactSizes) {
    not_confirmed(result, ", too few sizes");
  }
  if (fit.weighted && !claim.other_orders.empty()) try_other_orders(result, points, claim, x);
  return result;
}

}  // namespace kinex::lab
