// SPDX-License-Identifier: GPL-3.0-or-later
// Models of growth, fitted to means by weighted least squares and compared.
#ifndef KINEX_EXPERIMENTS_REPRODUCE_MODELS_H
#define KINEX_EXPERIMENTS_REPRODUCE_MODELS_H

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "experiments/verify/statistics.h"

namespace kinex {

// count = a + b g(n), or count = a n^b.
struct ModelFit {
  std::string name;  // "a + b ln^2 n"
  double a = 0, b = 0;
  double b_error = 0;  // standard error; widened if the points scatter more than their errors allow
  double lower = 0, upper = 0;  // 95 % confidence interval of b
  double chi_square = 0;
  int degrees = 0;                // of freedom
  std::vector<double> residuals;  // in standard errors of the points

  double at(double n) const;
  std::function<double(double)> g;  // of n; empty for the power
};

// Points need positive errors. Throws std::invalid_argument for fewer than three.
ModelFit fit_linear_model(std::string name, std::span<const FitPoint> points,
                          std::function<double(double)> g);
// On logarithms.
ModelFit fit_power_model(std::span<const FitPoint> points);

// The better of two fits with the same number of parameters to the same points: better by so much
// chi^2 (per degree of freedom, if both leave more than the errors explain) that chance is no
// explanation.
enum class BetterFit { kFirst, kNeither, kSecond };
inline constexpr double kDecisive = 9;  // three standard errors
BetterFit better_fit(const ModelFit& first, const ModelFit& second);

// "a + b ln^2 n: a = .., b = .. [..], chi^2 = 3.1 on 5"
std::string model_text(const ModelFit& fit);

}  // namespace kinex

#endif
