// SPDX-License-Identifier: GPL-3.0-or-later
// The arithmetics as they are listed to people; core/arithmetic/arithmetic.h makes them.
#ifndef KINEX_EXPERIMENTS_LAB_ARITHMETICS_H
#define KINEX_EXPERIMENTS_LAB_ARITHMETICS_H

#include <string>
#include <string_view>
#include <vector>

namespace kinex::lab {

struct ArithmeticInfo {
  std::string_view name;     // "mpfr:P" stands for one of every number of bits
  std::string_view summary;  // one line
  std::string_view promise;
  std::string_view use;
  std::string_view example;  // a name that --arithmetic takes
};

const std::vector<ArithmeticInfo>& arithmetic_infos();
// That of "exact", "mpfr:100", "mpfr:P" or "mpfr"; nullptr if there is none.
const ArithmeticInfo* find_arithmetic_info(std::string_view name);

}  // namespace kinex::lab

#endif
