// SPDX-License-Identifier: GPL-3.0-or-later
// Counts with singular and plural.
#ifndef KINEX_EXPERIMENTS_FORMATS_COUNTED_H
#define KINEX_EXPERIMENTS_FORMATS_COUNTED_H

#include <cstdint>
#include <string>

namespace kinex::formats {

// "1 row", "2 rows".
inline std::string counted(std::uint64_t number, const char* one, const char* many) {
  return std::to_string(number) + " " + (number == 1 ? one : many);
}

}  // namespace kinex::formats

#endif
