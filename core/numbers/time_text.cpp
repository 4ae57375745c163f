// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/time_text.h"

#include <gmp.h>

#include <array>

namespace kinex {
namespace {

constexpr std::size_t kMostCharacters = 20;
constexpr int kDigits = 6;  // after the point, of an irrational number

// Also for numbers beyond the range of doubles.
std::string short_decimal(const Rational& t) {
  mpf_t number;
  mpf_init2(number, 128);
  mpf_set_q(number, t.raw());
  std::array<char, 64> text{};
  gmp_snprintf(text.data(), text.size(), "%.10Fg", number);
  mpf_clear(number);
  return text.data();
}

}  // namespace

std::string time_text(const Rational& t) {
  std::string exact = t.to_string();
  if (exact.size() > kMostCharacters) return "about " + short_decimal(t);
  if (t.is_integer()) return exact;
  return exact + " (" + short_decimal(t) + ")";
}

std::string time_text(const InstantName& instant) {
  return instant.is_rational() ? time_text(instant.lower) : "about " + instant.decimal;
}

std::string time_text(const Polynomial& p, RealRoot& root, RootCounters& counters) {
  const RootName name = name_root(p, root, counters);
  return name.lower == name.upper ? time_text(name.lower)
                                  : "about " + decimal(root, kDigits, counters);
}

}  // namespace kinex
