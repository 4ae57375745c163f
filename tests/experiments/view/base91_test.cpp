// SPDX-License-Identifier: GPL-3.0-or-later
// Base 91 against its definition, read back here by other means than in the page.
#include "experiments/view/base91.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

namespace kinex {
namespace base91_test {

std::string read_back(const std::string& text) {
  std::string digits, bytes;
  for (char c = '!'; c <= '~'; ++c) {
    if (c != '&' && c != '<' && c != '\\') digits += c;
  }
  EXPECT_EQ(digits.size(), 91u);
  std::uint64_t bits = 0;
  int count = 0;
  for (std::size_t i = 0; i < text.size(); i += 2) {
    if (i + 1 == text.size()) {
      bytes += static_cast<char>((bits | digits.find(text[i]) << count) & 255);
      break;
    }
    const std::uint64_t pair = digits.find(text[i]) + 91 * digits.find(text[i + 1]);
    EXPECT_LT(pair, 91u * 91u);
    bits |= pair << count;
    count += (pair & 8191) < 91 * 91 - 8192 ? 14 : 13;
    for (; count >= 8; count -= 8, bits >>= 8) bytes += static_cast<char>(bits & 255);
  }
  return bytes;
}

TEST(Base91, IsReadBack) {
  std::mt19937_64 random(7);
  for (std::size_t size = 0; size < 300; ++size) {
    std::string bytes(size, '\0');
    for (char& c : bytes) c = static_cast<char>(random() >> (size % 3 == 0 ? 62 : 56));
    EXPECT_EQ(read_back(view::base91(bytes)), bytes) << size;
  }
  EXPECT_EQ(view::base91(""), "");
  EXPECT_EQ(view::base91("a").size(), 2u);
}

TEST(Base91, IsSafeInAScript) {
  std::string bytes;
  for (int i = 0; i < 70000; ++i) bytes += static_cast<char>(i * 7919 >> 3);
  const std::string text = view::base91(bytes);
  EXPECT_EQ(text.find_first_of("<&\\ \n"), text.npos);
  EXPECT_LT(text.size(), bytes.size() * 16 / 13 + 3);
}

}  // namespace base91_test
}  // namespace kinex
