// SPDX-License-Identifier: GPL-3.0-or-later
// Why a text is refused where a number is expected: most often it is none, or it is too large to be read.
#ifndef KINEX_EXPERIMENTS_FORMATS_NUMBER_DEFECT_H
#define KINEX_EXPERIMENTS_FORMATS_NUMBER_DEFECT_H

#include <string>
#include <string_view>

namespace kinex::formats {

struct NumberDefect {
  std::string problem;  // follows the text: "is not a number", "has an exponent beyond 100000"
  std::string remedy;
};

// Requires a text that Rational::parse refuses, or one that is too long for it. `usual`: the remedy for
// a text that is no number.
NumberDefect number_defect(std::string_view text, const std::string& usual);

}  // namespace kinex::formats

#endif
