// SPDX-License-Identifier: GPL-3.0-or-later
// Reads polynomials, one a line: "degree c0 c1 .. cd", low degree first; '#' begins a comment.
#ifndef KINEX_EXPERIMENTS_FORMATS_POLYNOMIAL_FILE_H
#define KINEX_EXPERIMENTS_FORMATS_POLYNOMIAL_FILE_H

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/numbers/polynomial.h"

namespace kinex::formats {

inline constexpr int kMaxFileDegree = 400;

struct PolynomialLine {
  std::size_t line;       // in the file, from 1
  Polynomial polynomial;  // not zero; a positive multiple of the one written
};

// Coefficients are integers, fractions or decimals. Throws InputError that names the line: a wrong
// number of coefficients, a leading coefficient that is zero (so the zero polynomial too), a degree
// beyond kMaxFileDegree, or a file without polynomials.
std::vector<PolynomialLine> parse_polynomials(std::string_view text, const std::string& file);

}  // namespace kinex::formats

#endif
