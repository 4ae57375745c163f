// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/polynomial_file.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "experiments/formats/counted.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_document.h"
#include "experiments/formats/number_defect.h"

namespace kinex::formats {

namespace {

constexpr std::string_view kBlanks = " \t\r";

std::vector<std::string_view> words_of(std::string_view line) {
  line = line.substr(0, line.find('#'));
  std::vector<std::string_view> words;
  for (;;) {
    const std::size_t begin = line.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return words;
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(kBlanks), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

Polynomial read_polynomial(const std::vector<std::string_view>& words, const std::string& file,
                           const std::string& place) {
  const auto fail = [&](const std::string& problem, const std::string& remedy) {
    throw InputError(file, place, problem, remedy);
  };
  const std::optional<Integer> degree = Integer::parse(words[0].substr(0, 100));
  if (!degree || degree->sign() < 0 || *degree > Integer(kMaxFileDegree)) {
    fail(show_text(words[0]) + " is not a degree",
         "begin the line with an integer from 0 to " + std::to_string(kMaxFileDegree));
  }
  const auto count = static_cast<std::size_t>(degree->to_int64()) + 1;
  if (words.size() != count + 1) {
    fail(counted(words.size() - 1, "coefficient", "coefficients") + " for degree " +
             degree->to_string(),
         "write " + std::to_string(count) + ", low degree first");
  }
  std::vector<Rational> coefficients;
  for (std::size_t i = 1; i < words.size(); ++i) {
    std::optional<Rational> value;
    if (words[i].size() <= kMaxNumberLength) value = Rational::parse(words[i]);
    if (!value) {
      const NumberDefect defect =
          number_defect(words[i], "write an integer, a fraction 1/3 or a decimal");
      fail(show_text(words[i]) + " " + defect.problem, defect.remedy);
    }
    coefficients.push_back(*std::move(value));
  }
  if (coefficients.back().is_zero()) {
    fail(count == 1 ? "the zero polynomial, of which every number is a root"
                    : "the leading coefficient is zero",
         count == 1 ? "remove the line" : "write a smaller degree");
  }
  return Polynomial::from_rationals(coefficients);
}

}  // namespace

std::vector<PolynomialLine> parse_polynomials(std::string_view text, const std::string& file) {
  std::vector<PolynomialLine> result;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t newline = std::min(text.find('\n'), text.size());
    const std::vector<std::string_view> words = words_of(text.substr(0, newline));
    text.remove_prefix(std::min(newline + 1, text.size()));
    if (words.empty()) continue;
    result.push_back({line, read_polynomial(words, file, "line " + std::to_string(line))});
  }
  if (result.empty()) {
    throw InputError(file, "", "there is no polynomial in the file",
                     "write one a line: degree c0 c1 .. cd");
  }
  return result;
}

}  // namespace kinex::formats
