// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/law_verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace kinex::lab {

namespace {

constexpr std::size_t kFewestSizes = 6;
constexpr double kFlat = 0.02;  // of a power: 1.4 % for every doubling

void leave_open(LawVerdict& result, const char* why) {
  result.observed += why;
  if (result.verdict == Verdict::kConfirmed) result.verdict = Verdict::kOpen;
}

// The upper end of the interval of the power that the counts grow with, if it is so small that they hardly
// grow.
std::optional<double> flat_power(std::span<const FitPoint> points) {
  const std::optional<Fit> power = fit_power(points);
  if (!power || power->upper > kFlat) return std::nullopt;
  return power->upper;
}

}  // namespace

LawVerdict judge_law(std::span<const FitPoint> points, const ClaimedLaw& claim, const std::string& x) {
  LawVerdict result;
  result.expected = fmt::format("a + b {}{}, bent by {}{:.3g} % at most", claim.law.text(x),
                                claim.at_most ? " or slower" : "", claim.at_most ? "" : "+-",
                                100 * claim.tolerance);
  const std::optional<Bend> bend = bend_of(points, claim.law);
  if (!bend || points.size() < kFewestSizes) {
    result.observed = "too few sizes";
    return result;
  }
  result.observed = fmt::format("bent by {:.2g} %, 95% in [{:.2g}, {:.2g}] %", 100 * bend->value,
                                100 * bend->lower, 100 * bend->upper);
  result.verdict = compare_with_claim(bend->lower, bend->upper, 0, claim.tolerance, claim.at_most);
  result.neighbours = neighbours_of(points, claim.law, x);
  if (!result.neighbours) {
    leave_open(result, ", no neighbours to compare with");
  } else if (claim.at_most) {
    const std::optional<double> flat = flat_power(points);
    if (flat) {
      result.observed += fmt::format(", like {}^{:.2g} at most", x, std::max(0.0, *flat));
    } else if (!result.neighbours->beats_faster()) {
      leave_open(result, ", and a law that grows faster cannot be excluded");
    }
  } else if (result.neighbours->is_beaten()) {
    leave_open(result, ", and a neighbour fits better");
  } else if (!result.neighbours->beats_all()) {
    leave_open(result, ", and a neighbour fits as well");
  }
  return result;
}

std::optional<Bend> bend_of(std::span<const FitPoint> points, const Law& law) {
  double least = std::numeric_limits<double>::infinity(), most = -least, sum = 0;
  for (const FitPoint& point : points) {
    least = std::min(least, law.at(point.n));
    most = std::max(most, law.at(point.n));
    sum += point.count;
  }
  if (points.empty() || !(sum > 0)) return std::nullopt;
  const double mean = sum / static_cast<double>(points.size());
  // From the middle of the range, in halves of it: -1 to 1.
  const double middle = (least + most) / 2, half = (most - least) / 2;
  const auto g = [=](double n) { return (law.at(n) - middle) / half; };
  const std::optional<Fit> fit =
      fit_law_with("a + b g + c g^2", points, g, [=](double n) { return g(n) * g(n); });
  if (!fit) return std::nullopt;
  return Bend{fit->c / mean, fit->c_lower / mean, fit->c_upper / mean};
}

}  // namespace kinex::lab
