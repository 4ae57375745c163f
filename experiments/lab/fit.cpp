// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/fit.h"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace kinex {

namespace {

// Points of a straight line.
struct Straight {
  std::vector<double> x, y, error;
};

// The line through them, into a and b of `fit`; false if there is none.
bool fit_straight(const Straight& points, Fit& fit) {
  const auto& [x, y, error] = points;
  if (x.size() < 3) return false;
  if (std::all_of(x.begin(), x.end(), [&](double value) { return value == x.front(); })) {
    return false;
  }
  fit.degrees = static_cast<int>(x.size()) - 2;
  fit.weighted = std::all_of(error.begin(), error.end(), [](double e) { return e > 0; });
  std::vector<double> weight;
  for (const double e : error) weight.push_back(fit.weighted ? 1 / (e * e) : 1);
  double cov00, cov01, cov11;
  if (fit.weighted) {
    gsl_fit_wlinear(x.data(), 1, weight.data(), 1, y.data(), 1, x.size(), &fit.a, &fit.b, &cov00,
                    &cov01, &cov11, &fit.chi_square);
    cov11 *= std::max(1.0, fit.chi_square / fit.degrees);
  } else {
    gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &fit.a, &fit.b, &cov00, &cov01, &cov11,
                   &fit.chi_square);
  }
  fit.b_error = std::sqrt(cov11);
  const double half = gsl_cdf_tdist_Pinv(0.975, fit.degrees) * fit.b_error;
  fit.lower = fit.b - half;
  fit.upper = fit.b + half;
  double weights = 0, weighted_x = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    weights += weight[i];
    weighted_x += weight[i] * x[i];
    if (fit.weighted) fit.in_errors.push_back((y[i] - fit.a - fit.b * x[i]) / error[i]);
  }
  fit.centre = weighted_x / weights;
  return true;
}

void add_residuals(std::span<const FitPoint> points, Fit& fit) {
  double squares = 0;
  for (const FitPoint& point : points) {
    const double apart = point.count - fit.at(point.n);
    squares += apart * apart;
    fit.residuals.push_back(point.count / fit.at(point.n) - 1);
  }
  fit.scatter = std::sqrt(squares / static_cast<double>(points.size()));
}

}  // namespace

double Fit::at(double n) const { return g ? a + b * g(n) : a * std::pow(n, b); }

std::optional<Fit> fit_power(std::span<const FitPoint> points) {
  Fit fit;
  fit.law = "a n^b";
  Straight logarithms;
  for (const FitPoint& point : points) {
    if (!(point.n > 0) || !(point.count > 0)) return std::nullopt;
    logarithms.x.push_back(std::log(point.n));
    logarithms.y.push_back(std::log(point.count));
    logarithms.error.push_back(point.error / point.count);
  }
  if (!fit_straight(logarithms, fit)) return std::nullopt;
  fit.a = std::exp(fit.a);
  fit.centre = std::exp(fit.centre);
  add_residuals(points, fit);
  return fit;
}

std::optional<Fit> fit_law(std::string law, std::span<const FitPoint> points,
                           std::function<double(double)> g) {
  Fit fit;
  fit.law = std::move(law);
  Straight straight;
  for (const FitPoint& point : points) {
    straight.x.push_back(g(point.n));
    straight.y.push_back(point.count);
    straight.error.push_back(point.error);
  }
  fit.g = std::move(g);
  if (!fit_straight(straight, fit)) return std::nullopt;
  add_residuals(points, fit);
  return fit;
}

BetterFit better_fit(const Fit& first, const Fit& second) {
  const double least = std::min(first.chi_square, second.chi_square);
  const double unit = std::max(1.0, least / first.degrees);
  const double apart = (second.chi_square - first.chi_square) / unit;
  return apart >= kDecisive    ? BetterFit::kFirst
         : apart <= -kDecisive ? BetterFit::kSecond
                               : BetterFit::kNeither;
}

std::string fit_text(const Fit& fit) {
  return fmt::format("{}: a = {:.4g}, b = {:.4g} [{:.4g}, {:.4g}], chi^2 = {:.1f} on {}", fit.law,
                     fit.a, fit.b, fit.lower, fit.upper, fit.chi_square, fit.degrees);
}

}  // namespace kinex
