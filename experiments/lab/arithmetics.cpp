// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/arithmetics.h"

namespace kinex::lab {

const std::vector<ArithmeticInfo>& arithmetic_infos() {
  static const std::vector<ArithmeticInfo> kInfos{
      {"exact",
       "doubles with proven error bounds, then 128-bit integers, then integers of any size (the "
       "default)",
       "every sign, every failure time's order and every equality of instants is exact", "results",
       "exact"},
      {"sturm", "rationals and Sturm sequences alone, without filters",
       "the answers of exact, slowly: the two logs of a scene have the same records and digest",
       "checking exact against a second way to the same answers, on small scenes: it is the "
       "reference",
       "sturm"},
      {"double", "the algorithms of the filters in plain doubles, without error bounds",
       "none: a carefully written floating-point structure",
       "finding out whether doubles would do for a scene", "double"},
      {"gsl", "doubles, roots by the polynomial solvers of the GNU Scientific Library",
       "none: the textbook floating-point structure", "comparing with what is usually written",
       "gsl"},
      {"mpfr:P", "MPFR numbers of P bits (2 to 100000), rounded to nearest, without error bounds",
       "none; more bits make errors rarer", "finding the number of bits that a scene takes",
       "mpfr:100"}};
  return kInfos;
}

const ArithmeticInfo* find_arithmetic_info(std::string_view name) {
  const std::string_view wanted = name == "mpfr" || name.starts_with("mpfr:") ? "mpfr:P" : name;
  for (const ArithmeticInfo& info : arithmetic_infos()) {
    if (info.name == wanted) return &info;
  }
  return nullptr;
}

}  // namespace kinex::lab
