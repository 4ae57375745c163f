// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/reproduce/models.h"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace kinex {

namespace {

// Straight line through (x, y +- error), into a and b of `fit`.
void fit_line(const std::vector<double>& x, const std::vector<double>& y,
              const std::vector<double>& error, ModelFit& fit) {
  if (x.size() < 3) throw std::invalid_argument("a fit of two numbers needs three points");
  std::vector<double> weight;
  for (const double e : error) weight.push_back(1 / (e * e));
  double cov00, cov01, cov11;
  gsl_fit_wlinear(x.data(), 1, weight.data(), 1, y.data(), 1, x.size(), &fit.a, &fit.b, &cov00,
                  &cov01, &cov11, &fit.chi_square);
  fit.degrees = static_cast<int>(x.size()) - 2;
  fit.b_error = std::sqrt(cov11 * std::max(1.0, fit.chi_square / fit.degrees));
  const double half = gsl_cdf_tdist_Pinv(0.975, fit.degrees) * fit.b_error;
  fit.lower = fit.b - half;
  fit.upper = fit.b + half;
  for (std::size_t i = 0; i < x.size(); ++i) {
    fit.residuals.push_back((y[i] - fit.a - fit.b * x[i]) / error[i]);
  }
}

}  // namespace

double ModelFit::at(double n) const { return g ? a + b * g(n) : a * std::pow(n, b); }

ModelFit fit_linear_model(std::string name, std::span<const FitPoint> points,
                          std::function<double(double)> g) {
  ModelFit fit;
  fit.name = std::move(name);
  fit.g = std::move(g);
  std::vector<double> x, y, error;
  for (const FitPoint& point : points) {
    x.push_back(fit.g(point.n));
    y.push_back(point.count);
    error.push_back(point.error);
  }
  fit_line(x, y, error, fit);
  return fit;
}

ModelFit fit_power_model(std::span<const FitPoint> points) {
  ModelFit fit;
  fit.name = "a n^b";
  std::vector<double> x, y, error;
  for (const FitPoint& point : points) {
    x.push_back(std::log(point.n));
    y.push_back(std::log(point.count));
    error.push_back(point.error / point.count);
  }
  fit_line(x, y, error, fit);
  fit.a = std::exp(fit.a);
  return fit;
}

BetterFit better_fit(const ModelFit& first, const ModelFit& second) {
  const double least = std::min(first.chi_square, second.chi_square);
  const double unit = std::max(1.0, least / first.degrees);
  const double apart = (second.chi_square - first.chi_square) / unit;
  return apart >= kDecisive    ? BetterFit::kFirst
         : apart <= -kDecisive ? BetterFit::kSecond
                               : BetterFit::kNeither;
}

std::string model_text(const ModelFit& fit) {
  return fmt::format("{}: a = {:.4g}, b = {:.4g} [{:.4g}, {:.4g}], chi^2 = {:.1f} on {}", fit.name,
                     fit.a, fit.b, fit.lower, fit.upper, fit.chi_square, fit.degrees);
}

}  // namespace kinex
