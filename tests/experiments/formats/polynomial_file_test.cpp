// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/polynomial_file.h"

#include <gtest/gtest.h>

#include "tests/experiments/expect_input_error.h"

namespace kinex {
namespace polynomial_file_test {

TEST(PolynomialFile, ReadsLinesAndComments) {
  const auto lines = formats::parse_polynomials("# two\n2 -2 0 1\n\n 1\t1/2 -0.25 # half\r\n0 7", "p");
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].line, 2u);
  EXPECT_EQ(lines[0].polynomial.to_string(), "-2 0 1");
  EXPECT_EQ(lines[1].line, 4u);
  EXPECT_EQ(lines[1].polynomial.to_string(), "2 -1");
  EXPECT_EQ(lines[2].polynomial.degree(), 0);
}

TEST(PolynomialFile, DegreeIsLimitedExactly) {
  const auto line = [](int degree) {
    std::string text = std::to_string(degree);
    for (int k = 0; k <= degree; ++k) text += " 1";
    return text;
  };
  EXPECT_EQ(formats::parse_polynomials(line(400), "p")[0].polynomial.degree(), 400);
  EXPECT_INPUT_ERROR(formats::parse_polynomials(line(401), "p"), "p: line 1: \"401\" is not a degree");
}

}  // namespace polynomial_file_test
}  // namespace kinex
