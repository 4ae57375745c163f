// SPDX-License-Identifier: GPL-3.0-or-later
// Counts with singular and plural, and ranges of them.
#ifndef KINEX_EXPERIMENTS_FORMATS_COUNTED_H
#define KINEX_EXPERIMENTS_FORMATS_COUNTED_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace kinex::formats {

// "1 row", "2 rows".
inline std::string counted(std::uint64_t number, const char* one, const char* many) {
  return std::to_string(number) + " " + (number == 1 ? one : many);
}

// "a, b and 3 more": the first five of them.
inline std::string some_of(const std::vector<std::string>& all) {
  constexpr std::size_t kMost = 5;
  std::string text;
  for (std::size_t i = 0; i < all.size() && i < kMost; ++i) text += (i == 0 ? "" : ", ") + all[i];
  if (all.size() > kMost) text += " and " + std::to_string(all.size() - kMost) + " more";
  return text;
}

// What to do about a number out of its range: "write a number from 1 to 9", "write 2".
inline std::string write_between(int low, int high) {
  if (low == high) return "write " + std::to_string(low);
  return "write a number from " + std::to_string(low) + " to " + std::to_string(high);
}

}  // namespace kinex::formats

#endif
