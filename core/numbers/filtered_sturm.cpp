// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/filtered_sturm.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kinex {

namespace {

constexpr double kUnit = 0x1p-53;
constexpr double kInflate = 1 + 0x1p-45;
// Smaller values are refused.
constexpr double kLeast = 0x1p-400;
constexpr double kMostX = 0x1p32;

// Counts sign changes; no value is zero.
class Variations {
 public:
  void add(bool negative) {
    count_ += started_ && negative != last_ ? 1 : 0;
    started_ = true;
    last_ = negative;
  }
  int count() const { return count_; }

 private:
  bool started_ = false, last_ = false;
  int count_ = 0;
};

}  // namespace

// An integer rounded to a double is off by one unit at most (GMP truncates).
bool FilteredSturm::set_first(const std::vector<Integer>& p, long scale) {
  Element& first = sequence_[0];
  first.degree = static_cast<int>(p.size()) - 1;
  std::array<long, kRoom> exponent{};
  long most = std::numeric_limits<long>::min();
  for (std::size_t i = 0; i < p.size(); ++i) {
    first.value[i] = mpz_get_d_2exp(&exponent[i], p[i].raw());
    if (first.value[i] == 0) continue;
    exponent[i] += scale * static_cast<long>(i);
    most = std::max(most, exponent[i]);
  }
  for (std::size_t i = 0; i < p.size(); ++i) {
    double& value = first.value[i];
    if (value != 0) {
      if (exponent[i] - most < -399) return false;
      value = std::ldexp(value, static_cast<int>(exponent[i] - most));
    }
    first.error[i] = 2 * kUnit * std::fabs(value);
  }
  return true;
}

void FilteredSturm::set_derivative() {
  const Element& p = sequence_[0];
  Element& d = sequence_[1];
  d.degree = p.degree - 1;
  for (std::size_t i = 1; i <= static_cast<std::size_t>(p.degree); ++i) {
    // A power of two not below the degree keeps the values at most 1.
    const double factor = static_cast<double>(i) * 0x1p-5;
    d.value[i - 1] = factor * p.value[i];
    d.error[i - 1] = (factor * p.error[i] + kUnit * std::fabs(d.value[i - 1])) * kInflate;
  }
}

// rest = -(a mod b), one term of the quotient after the other.
bool FilteredSturm::divide(const Element& a, const Element& b, Element& rest) {
  std::array<double, kRoom> value, error;
  const auto size = static_cast<std::size_t>(a.degree) + 1;
  std::copy_n(a.value.begin(), size, value.begin());
  std::copy_n(a.error.begin(), size, error.begin());
  const auto m = static_cast<std::size_t>(b.degree);
  const double lead = b.value[m], lead_error = b.error[m];
  const double safe_lead = std::fabs(lead) - lead_error;  // positive
  for (std::size_t top = static_cast<std::size_t>(a.degree); top >= m; --top) {
    if (value[top] == 0 && error[top] == 0) continue;
    const double q = value[top] / lead;
    if (!(std::fabs(q) >= kLeast && std::fabs(q) <= 1 / kLeast)) return false;
    const double q_error =
        ((error[top] + std::fabs(q) * lead_error) / safe_lead + kUnit * std::fabs(q)) * kInflate;
    for (std::size_t i = 0; i < m; ++i) {
      const std::size_t k = top - m + i;
      const double product = q * b.value[i];
      const double difference = value[k] - product;
      error[k] =
          (error[k] + std::fabs(q) * b.error[i] + q_error * (std::fabs(b.value[i]) + b.error[i]) +
           kUnit * (std::fabs(product) + std::fabs(difference))) *
          kInflate;
      value[k] = difference;
    }
  }
  int degree = b.degree - 1;
  while (degree >= 0) {
    const auto k = static_cast<std::size_t>(degree);
    if (std::fabs(value[k]) > error[k]) break;
    if (value[k] != 0 || error[k] != 0) return false;
    --degree;
  }
  if (degree < 0) return false;  // a multiple root
  double most = 0;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(degree); ++i) {
    most = std::max(most, std::fabs(value[i]));
  }
  int exponent = 0;
  std::frexp(most, &exponent);
  const double factor = std::ldexp(-1.0, -exponent);
  rest.degree = degree;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(degree); ++i) {
    rest.value[i] = value[i] * factor;
    rest.error[i] = error[i] * -factor;
    if (rest.value[i] == 0 && rest.error[i] == 0) continue;
    // Never exactly zero for a value that may be non-zero: see the error model.
    if (!(rest.error[i] >= kLeast * kUnit)) return false;
    if (std::fabs(rest.value[i]) < kLeast) rest.error[i] += kLeast;
  }
  const auto last = static_cast<std::size_t>(degree);
  return std::fabs(rest.value[last]) > rest.error[last] * kInflate;
}

bool FilteredSturm::make(const std::vector<Integer>& p, long scale) {
  size_ = 0;
  if (p.size() < 2 || p.size() > kRoom || !set_first(p, scale)) return false;
  set_derivative();
  size_ = 2;
  while (sequence_[size_ - 1].degree > 0) {
    if (!divide(sequence_[size_ - 2], sequence_[size_ - 1], sequence_[size_])) return false;
    ++size_;
  }
  Variations variations;
  for (std::size_t i = 0; i < size_; ++i) {
    const Element& e = sequence_[i];
    const bool odd = e.degree % 2 != 0;
    variations.add((e.value[static_cast<std::size_t>(e.degree)] < 0) != odd);
  }
  at_minus_infinity_ = variations.count();
  return true;
}

std::optional<int> FilteredSturm::variations(double x) const {
  if (!(std::fabs(x) <= kMostX)) return std::nullopt;
  const double size = std::fabs(x);
  Variations variations;
  for (std::size_t k = 0; k < size_; ++k) {
    const Element& e = sequence_[k];
    auto i = static_cast<std::size_t>(e.degree);
    double value = e.value[i];
    // Horner's rule rounds every term 2 degree times at most.
    const double rounding = (2 * e.degree + 4) * kUnit;
    double error = rounding * std::fabs(value) + e.error[i];
    while (i-- > 0) {
      value = value * x + e.value[i];
      error = error * size + (rounding * std::fabs(e.value[i]) + e.error[i]);
    }
    // Below this underflow may matter.
    if (!(error >= 0x1p-900 && std::fabs(value) > error * kInflate)) return std::nullopt;
    variations.add(value < 0);
  }
  return variations.count();
}

}  // namespace kinex
