// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/short_dyadic.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace kinex {
namespace {

constexpr double kMost = 0x1p30;
constexpr int kMostPlaces = 10;

}  // namespace

double ShortDyadic::to_double() const {
  return std::ldexp(static_cast<double>(numerator), -places);
}

Rational ShortDyadic::to_rational() const {
  Rational result;
  assign_to(result);
  return result;
}

void ShortDyadic::assign_to(Rational& target) const {
  const int common =
      numerator == 0 ? places
                     : std::min(places, std::countr_zero(static_cast<std::uint64_t>(numerator)));
  target.set_words(numerator / (std::int64_t{1} << common), std::int64_t{1} << (places - common));
}

std::optional<ShortDyadic> shortest_dyadic(double lo, double hi) {
  if (!(lo >= -kMost && hi <= kMost)) return std::nullopt;
  double scale = 1;
  for (int places = 0; places <= kMostPlaces; ++places, scale *= 2) {
    const double k = std::ceil(lo * scale);
    if (k <= hi * scale) return ShortDyadic{static_cast<std::int64_t>(k), places};
  }
  return std::nullopt;
}

}  // namespace kinex
