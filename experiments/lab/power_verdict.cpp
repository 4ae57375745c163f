// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/power_verdict.h"

#include <fmt/format.h>

#include <cmath>

namespace kinex::lab {

namespace {

constexpr int kFewestExactSizes = 4;  // three may lie on a power by chance

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

void judge_with_term(PowerVerdict& result, std::span<const FitPoint> points,
                     const ClaimedPower& claim, const std::string& x) {
  const double below = claim.lower_order;
  result.corrected = fit_power_with(fmt::format("a n^b exp(c / n^{:.3g})", below), points,
                                    [below](double n) { return std::pow(n, -below); });
  result.observed += ", " + chi_square_text(*result.fit) + " is no chance";
  if (!result.corrected) {
    not_confirmed(result, ", too few sizes for a term of lower order");
    return;
  }
  const Fit& fit = *result.corrected;
  const Verdict alone = result.verdict;
  result.verdict = compare(fit, claim);
  result.observed += fmt::format("; with a term of order {}^(b - {:.3g}): {}, {}", x, below,
                                 interval_text(x, fit), chi_square_text(fit));
  if (!is_improbable(fit)) return;
  result.observed += " is no chance either";
  const bool both = alone == Verdict::kRefuted && result.verdict == Verdict::kRefuted;
  if (!both) result.verdict = Verdict::kOpen;
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
  if (is_improbable(fit)) judge_with_term(result, points, claim, x);
  if (!fit.weighted && fit.degrees + 2 < kFewestExactSizes) {
    not_confirmed(result, ", too few sizes");
  }
  return result;
}

}  // namespace kinex::lab
