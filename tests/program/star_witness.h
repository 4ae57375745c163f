// SPDX-License-Identifier: GPL-3.0-or-later
// An independent reading of nearest_stars.csv: integers, nothing of kinex.
#ifndef KINEX_TESTS_PROGRAM_STAR_WITNESS_H
#define KINEX_TESTS_PROGRAM_STAR_WITNESS_H

#include <array>
#include <cstdint>
#include <map>
#include <string>

namespace kinex {

// Millionths of a parsec, and of a parsec per million years.
struct Star {
  std::array<std::int64_t, 3> position, velocity;
};

// By name.
std::map<std::string, Star> read_stars(const std::string& file);

}  // namespace kinex

#endif
