// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/growth_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace kinex::lab {
namespace {

const FitPoint* at(std::span<const FitPoint> points, double n) {
  const auto place = std::find_if(points.begin(), points.end(),
                                  [n](const FitPoint& point) { return point.n == n; });
  return place == points.end() ? nullptr : &*place;
}

// Without -0.00.
std::string exponent_between(const FitPoint& first, const FitPoint& second) {
  const double exponent = std::log(second.count / first.count) / std::log(second.n / first.n);
  const std::string text = fmt::format("{:.2f}", exponent);
  return text == "-0.00" ? "0.00" : text;
}

}  // namespace

GrowthOrder growth_order(const std::optional<Fit>& power, double exponent) {
  if (!power || power->degrees < 2 || is_improbable(*power)) return GrowthOrder::kUntold;
  if (power->lower > exponent) return GrowthOrder::kFaster;
  return power->upper < exponent ? GrowthOrder::kSlower : GrowthOrder::kUntold;
}

std::string growth_words(const std::optional<Fit>& power, double exponent, std::string_view law) {
  switch (growth_order(power, exponent)) {
    case GrowthOrder::kFaster:
      return fmt::format("faster than {}", law);
    case GrowthOrder::kSlower:
      return fmt::format("more slowly than {}", law);
    default:
      return fmt::format("at a rate that these sizes do not tell from that of {}", law);
  }
}

std::string careful_growth_words(const std::optional<Fit>& power, double exponent,
                                 std::string_view law) {
  const bool is_told = growth_order(power, exponent + kCarefulMargin) == GrowthOrder::kFaster ||
                       growth_order(power, exponent - kCarefulMargin) == GrowthOrder::kSlower;
  return growth_words(is_told ? power : std::nullopt, exponent, law);
}

std::vector<FitPoint> ratios(std::span<const FitPoint> under, std::span<const FitPoint> over) {
  std::vector<FitPoint> result;
  for (const FitPoint& below : under) {
    const FitPoint* const above = at(over, below.n);
    if (above == nullptr || below.count == 0 || above->count == 0) continue;
    const double ratio = above->count / below.count;
    result.push_back(
        {below.n, ratio,
         std::abs(ratio) * std::hypot(above->error / above->count, below.error / below.count)});
  }
  return result;
}

std::size_t times_below(std::span<const FitPoint> first, std::span<const FitPoint> second) {
  return static_cast<std::size_t>(
      std::count_if(first.begin(), first.end(), [&](const FitPoint& one) {
        const FitPoint* const other = at(second, one.n);
        return other != nullptr &&
               one.count + 2 * std::hypot(one.error, other->error) < other->count;
      }));
}

std::string local_exponents(std::span<const FitPoint> points) {
  if (points.size() < 3) return {};
  const auto is_bad = [](const FitPoint& point) { return point.count <= 0 || point.n <= 0; };
  if (std::any_of(points.begin(), points.end(), is_bad)) return {};
  const FitPoint &a = points[0], &b = points[1], &y = points[points.size() - 2], &z = points.back();
  return fmt::format(
      "the exponent between neighbouring sizes goes from {} (n = {:.0f} to {:.0f}) to {} ({:.0f} "
      "to {:.0f})",
      exponent_between(a, b), a.n, b.n, exponent_between(y, z), y.n, z.n);
}

}  // namespace kinex::lab
