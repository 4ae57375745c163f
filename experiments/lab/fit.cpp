// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/fit.h"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "experiments/lab/least_squares.h"

namespace kinex::lab {

namespace {

// Points of a straight line.
struct Straight {
  std::vector<double> x, y, error;
};

// The line through them, into a and b of `fit`; false if there is none.
bool fit_straight(const Straight& points, Fit& fit) {
  const auto& [x, y, error] = points;
  if (x.size() < 3) return false;
  if (std::all_of(x.begin(), x.end(), [first = x[0]](double value) { return value == first; })) {
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

// Three columns: 1, x and h(n).
bool fit_with_term(const Straight& line, std::span<const FitPoint> points, Fit& fit) {
  std::vector<double> ones(line.x.size(), 1), term;
  for (const FitPoint& point : points) term.push_back(fit.h(point.n));
  const auto solved = least_squares({std::move(ones), line.x, term}, line.y, line.error);
  if (!solved) return false;
  fit.a = solved->coefficients[0];
  fit.b = solved->coefficients[1];
  fit.c = solved->coefficients[2];
  fit.lower = solved->lower[1];
  fit.upper = solved->upper[1];
  fit.c_lower = solved->lower[2];
  fit.c_upper = solved->upper[2];
  fit.degrees = solved->degrees;
  fit.b_error = (fit.upper - fit.b) / gsl_cdf_tdist_Pinv(0.975, fit.degrees);
  fit.weighted = solved->weighted;
  fit.chi_square = solved->chi_square;
  for (std::size_t i = 0; fit.weighted && i < points.size(); ++i) {
    fit.in_errors.push_back((line.y[i] - fit.a - fit.b * line.x[i] - fit.c * term[i]) /
                            line.error[i]);
  }
  return true;
}

// nullopt if a point is not positive.
std::optional<Straight> logarithms_of(std::span<const FitPoint> points) {
  Straight logarithms;
  for (const FitPoint& point : points) {
    if (!(point.n > 0) || !(point.count > 0)) return std::nullopt;
    logarithms.x.push_back(std::log(point.n));
    logarithms.y.push_back(std::log(point.count));
    logarithms.error.push_back(point.error / point.count);
  }
  return logarithms;
}

Straight straight_over(std::span<const FitPoint> points, const std::function<double(double)>& g) {
  Straight straight;
  for (const FitPoint& point : points) {
    straight.x.push_back(g(point.n));
    straight.y.push_back(point.count);
    straight.error.push_back(point.error);
  }
  return straight;
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

double Fit::at(double n) const {
  const double term = h ? c * h(n) : 0;
  return g ? a + b * g(n) + term : a * std::pow(n, b) * std::exp(term);
}

std::optional<Fit> fit_power(std::span<const FitPoint> points) {
  Fit fit;
  fit.law = "a n^b";
  const std::optional<Straight> logarithms = logarithms_of(points);
  if (!logarithms || !fit_straight(*logarithms, fit)) return std::nullopt;
  fit.a = std::exp(fit.a);
  fit.centre = std::exp(fit.centre);
  add_residuals(points, fit);
  return fit;
}

std::optional<Fit> fit_law(std::string law, std::span<const FitPoint> points,
                           std::function<double(double)> g) {
  Fit fit;
  fit.law = std::move(law);
  const Straight straight = straight_over(points, g);
  fit.g = std::move(g);
  if (!fit_straight(straight, fit)) return std::nullopt;
  add_residuals(points, fit);
  return fit;
}

std::optional<Fit> fit_power_with(std::string law, std::span<const FitPoint> points,
                                  std::function<double(double)> h) {
  Fit fit;
  fit.law = std::move(law);
  fit.h = std::move(h);
  const std::optional<Straight> logarithms = logarithms_of(points);
  if (!logarithms || !fit_with_term(*logarithms, points, fit)) return std::nullopt;
  fit.a = std::exp(fit.a);
  add_residuals(points, fit);
  return fit;
}

std::optional<Fit> fit_law_with(std::string law, std::span<const FitPoint> points,
                                std::function<double(double)> g, std::function<double(double)> h) {
  Fit fit;
  fit.law = std::move(law);
  fit.h = std::move(h);
  const Straight straight = straight_over(points, g);
  fit.g = std::move(g);
  if (!fit_with_term(straight, points, fit)) return std::nullopt;
  add_residuals(points, fit);
  return fit;
}

std::optional<Fit> fit_given_power_with(double b, std::string law, std::span<const FitPoint> points,
                                        std::function<double(double)> h) {
  std::optional<Straight> line = logarithms_of(points);
  if (!line || points.size() < 3) return std::nullopt;
  std::vector<double> ones(points.size(), 1), term;
  for (const FitPoint& point : points) term.push_back(h(point.n));
  for (std::size_t i = 0; i < points.size(); ++i) line->y[i] -= b * line->x[i];
  const auto solved = least_squares({std::move(ones), term}, line->y, line->error);
  if (!solved) return std::nullopt;
  Fit fit;
  fit.law = std::move(law);
  fit.h = std::move(h);
  fit.a = std::exp(solved->coefficients[0]);
  fit.b = fit.lower = fit.upper = b;
  fit.c = solved->coefficients[1];
  fit.c_lower = solved->lower[1];
  fit.c_upper = solved->upper[1];
  fit.degrees = solved->degrees;
  fit.weighted = solved->weighted;
  fit.chi_square = solved->chi_square;
  for (std::size_t i = 0; fit.weighted && i < points.size(); ++i) {
    fit.in_errors.push_back((line->y[i] - solved->coefficients[0] - fit.c * term[i]) / line->error[i]);
  }
  add_residuals(points, fit);
  return fit;
}

std::optional<double> chi_square_of(const Fit& fit) {
  if (!fit.weighted) return std::nullopt;
  return fit.chi_square;
}

bool is_improbable(const Fit& fit) {
  constexpr double kOnceInSoMany = 1e-3;
  return fit.weighted && gsl_cdf_chisq_Q(fit.chi_square, fit.degrees) < kOnceInSoMany;
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
  double squares = 0;
  for (const double residual : fit.residuals) squares += residual * residual;
  const double scatter = std::sqrt(squares / static_cast<double>(fit.residuals.size()));
  return fmt::format("{}: a = {:.4g}, b = {:.4g} [{:.4g}, {:.4g}]{}, {}", fit.law, fit.a, fit.b,
                     fit.lower, fit.upper, fit.h ? fmt::format(", c = {:.4g}", fit.c) : "",
                     fit.weighted
                         ? fmt::format("chi^2 = {:.1f} on {}{}", fit.chi_square, fit.degrees,
                                       is_improbable(fit) ? ", too large for chance" : "")
                         : fmt::format("scatter {:.2g} %", 100 * scatter));
}

}  // namespace kinex::lab
