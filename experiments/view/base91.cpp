// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/base91.h"

#include <array>
#include <cstdint>

namespace kinex::view {

namespace {

constexpr unsigned kDigits = 91;

constexpr std::array<char, kDigits> digits() {
  std::array<char, kDigits> all{};
  std::size_t count = 0;
  for (char c = '!'; c <= '~'; ++c) {
    if (c != '&' && c != '<' && c != '\\') all[count++] = c;
  }
  return all;
}

}  // namespace

std::string base91(std::string_view bytes) {
  constexpr std::array<char, kDigits> kDigit = digits();
  constexpr std::uint32_t kSmall =
      kDigits * kDigits - (1u << 13);  // 13 bits below this leave room for one more
  std::string text;
  text.reserve(bytes.size() * 16 / 13 + 4);
  std::uint32_t bits = 0;
  int count = 0;
  const auto put = [&](std::uint32_t value) {
    text += kDigit[value % kDigits];
    text += kDigit[value / kDigits];
  };
  for (const char c : bytes) {
    bits |= static_cast<std::uint32_t>(static_cast<unsigned char>(c)) << count;
    count += 8;
    if (count < 14) continue;
    std::uint32_t value = bits & 0x1fff;
    int taken = 13;
    if (value < kSmall) {
      value = bits & 0x3fff;
      taken = 14;
    }
    put(value);
    bits >>= taken;
    count -= taken;
  }
  if (count > 0) {
    if (count < 8 && bits < kDigits) {
      text += kDigit[bits];
    } else {
      put(bits);
    }
  }
  return text;
}

}  // namespace kinex::view
