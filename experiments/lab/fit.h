// SPDX-License-Identifier: GPL-3.0-or-later
// Fit: a law of growth with two numbers, fitted to counts by least squares; or with three, the
// third of a term of lower order.
#ifndef KINEX_EXPERIMENTS_LAB_FIT_H
#define KINEX_EXPERIMENTS_LAB_FIT_H

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace kinex::lab {

struct FitPoint {
  double n;
  double count;
  double error;  // standard error of `count`; 0: exact
};

// count = a n^b, or count = a + b g(n); with a term of lower order a n^b exp(c h(n)), or
// a + b g(n) + c h(n).
struct Fit {
  std::string law;                  // "a n^b", "a + b ln^2 n"
  std::function<double(double)> g;  // empty for the power
  std::function<double(double)> h;  // empty: no such term
  double a = 0, b = 0, c = 0;
  double b_error = 0;
  double lower = 0, upper = 0;      // 95 % confidence interval of b
  double c_lower = 0, c_upper = 0;  // of c
  double centre = 0;  // of a power: the n where it is surest: its logarithm is the (weighted) mean
  bool weighted = false;          // every point has a standard error
  double chi_square = 0;          // weighted sum of squares; meaningless unless `weighted`
  int degrees = 0;                // of freedom: points - 2, or 3
  double scatter = 0;             // root of the mean of the squared differences of the counts
  std::vector<double> residuals;  // count / fit - 1, in the order of the points
  std::vector<double> in_errors;  // differences in standard errors; empty unless `weighted`

  double at(double n) const;
};

// Weighted by the standard errors of the points (for a power: of their logarithms) where every
// point has one, else unweighted with the scatter about the line as the error. The interval is that
// of Student's t with `degrees` degrees; where the points scatter more than their errors allow
// (chi_square > degrees) it is widened by sqrt(chi_square / degrees): a systematic departure from a
// law is not hidden by small errors. nullopt for fewer than three points, or a single n; a power
// also for points that are not positive.
std::optional<Fit> fit_power(std::span<const FitPoint> points);
std::optional<Fit> fit_law(std::string law, std::span<const FitPoint> points,
                           std::function<double(double)> g);

// The same with a term of lower order; nullopt also for fewer than four points. A power with
// h(n) = n^-d is a n^b (1 + c n^-d + ..).
std::optional<Fit> fit_power_with(std::string law, std::span<const FitPoint> points,
                                  std::function<double(double)> h);
std::optional<Fit> fit_law_with(std::string law, std::span<const FitPoint> points,
                                std::function<double(double)> g, std::function<double(double)> h);
// The same with the exponent b given, so that only a and c are fitted; nullopt for fewer than three
// points.
std::optional<Fit> fit_given_power_with(double b, std::string law, std::span<const FitPoint> points,
                                        std::function<double(double)> h);

// Chi squared, if it means anything: every point has a standard error.
std::optional<double> chi_square_of(const Fit& fit);

// True if chance leaves so large a chi squared less than once in a thousand times. Never of a fit
// without standard errors.
bool is_improbable(const Fit& fit);

// The better of two fits with the same number of parameters to the same points: better by so much
// chi^2 (per degree of freedom, if both leave more than the errors explain) that chance is no
// explanation.
enum class BetterFit { kFirst, kNeither, kSecond };
inline constexpr double kDecisive = 9;  // three standard errors
BetterFit better_fit(const Fit& first, const Fit& second);

// "a + b ln^2 n: a = .., b = .. [..], chi^2 = 3.1 on 5", with "too large for chance" where it is
// (is_improbable); of counts without standard errors "scatter 2.1 %" in place of chi^2.
std::string fit_text(const Fit& fit);

}  // namespace kinex::lab

#endif
