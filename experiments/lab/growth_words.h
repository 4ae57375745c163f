// SPDX-License-Identifier: GPL-3.0-or-later
// What fitted exponents tell, in words: no more than their 95 % intervals do, so that other counts make
// other sentences, and fewer counts weaker ones.
#ifndef KINEX_EXPERIMENTS_LAB_GROWTH_WORDS_H
#define KINEX_EXPERIMENTS_LAB_GROWTH_WORDS_H

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/lab/fit.h"

namespace kinex::lab {

// Of a fitted power: how its exponent is to a given one.
enum class GrowthOrder {
  kFaster,  // the whole 95 % interval is above it
  kSlower,  // the whole interval is below it
  kUntold  // it contains it; or there is no fit, one with fewer than two degrees of freedom, or one
           // whose chi squared chance does not explain
};
GrowthOrder growth_order(const std::optional<Fit>& power, double exponent);

// "faster than n^(1/2)", "more slowly than n^(1/2)", or "at a rate that these sizes do not tell from that of n^(1/2)":
// `law` is how the exponent is written. For a sentence that begins with "they grow".
std::string growth_words(const std::optional<Fit>& power, double exponent, std::string_view law);

// The same for small sizes: a term of lower order may move an exponent by kCarefulMargin, so that an interval which is
// nearer to the given one than that tells nothing.
inline constexpr double kCarefulMargin = 0.05;
std::string careful_growth_words(const std::optional<Fit>& power, double exponent,
                                 std::string_view law);

// Two counts at the same n, means with their errors: the ratio of the second to the first at each n that
// both have, in the order of the first. Errors are those of independent means.
std::vector<FitPoint> ratios(std::span<const FitPoint> under, std::span<const FitPoint> over);

// The number of n at which the first count is below the second by more than two standard errors of their
// difference.
std::size_t times_below(std::span<const FitPoint> first, std::span<const FitPoint> second);

// "the exponent between neighbouring sizes goes from 0.68 (n = 4 to 6) to 0.00 (24 to 32)": of the first
// two and the last two points. Empty for fewer than three points, or counts that are not positive.
std::string local_exponents(std::span<const FitPoint> points);

}  // namespace kinex::lab

#endif
