// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/statistics.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace kinex {

void RunningMean::add(double value) {
  if (count_ == 0) smallest_ = largest_ = value;
  smallest_ = std::min(smallest_, value);
  largest_ = std::max(largest_, value);
  ++count_;
  const double before = value - mean_;
  mean_ += before / static_cast<double>(count_);
  squares_ += before * (value - mean_);
}

double RunningMean::deviation() const {
  return count_ < 2 ? 0 : std::sqrt(squares_ / static_cast<double>(count_ - 1));
}

double RunningMean::standard_error() const {
  return count_ < 2 ? 0 : deviation() / std::sqrt(static_cast<double>(count_));
}

double distance_in_errors(double mean, double error, double reference, double reference_error,
                          double tolerance) {
  const double apart = std::fabs(mean - reference) - tolerance;
  if (apart <= 0) return 0;
  const double scale = std::hypot(error, reference_error);
  return scale > 0 ? apart / scale : std::numeric_limits<double>::infinity();
}

double allowed_errors(int comparisons) {
  constexpr double kAlone = 2;
  if (comparisons <= 1) return kAlone;
  const double agree = 1 - 2 * gsl_cdf_ugaussian_Q(kAlone);
  const double each = 1 - std::pow(agree, 1.0 / comparisons);
  return gsl_cdf_ugaussian_Qinv(each / 2);
}

double PowerFit::at(double n) const { return factor * std::pow(n, exponent); }

std::optional<PowerFit> fit_power(std::span<const FitPoint> points) {
  if (points.size() < 3) return std::nullopt;
  std::vector<double> x, y, weight;
  bool weighted = true;
  for (const FitPoint& point : points) {
    if (!(point.n > 0) || !(point.count > 0)) return std::nullopt;
    x.push_back(std::log(point.n));
    y.push_back(std::log(point.count));
    weighted = weighted && point.error > 0;
    const double relative = point.error / point.count;
    weight.push_back(1 / (relative * relative));
  }
  if (std::all_of(x.begin(), x.end(), [&](double value) { return value == x.front(); })) {
    return std::nullopt;
  }
  PowerFit fit;
  fit.degrees = static_cast<int>(points.size()) - 2;
  fit.weighted = weighted;
  double offset, cov00, cov01, cov11;
  if (weighted) {
    gsl_fit_wlinear(x.data(), 1, weight.data(), 1, y.data(), 1, x.size(), &offset, &fit.exponent,
                    &cov00, &cov01, &cov11, &fit.chi_square);
    cov11 *= std::max(1.0, fit.chi_square / fit.degrees);
  } else {
    gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &offset, &fit.exponent, &cov00, &cov01,
                   &cov11, &fit.chi_square);
  }
  fit.exponent_error = std::sqrt(cov11);
  const double half = gsl_cdf_tdist_Pinv(0.975, fit.degrees) * fit.exponent_error;
  fit.lower = fit.exponent - half;
  fit.upper = fit.exponent + half;
  fit.factor = std::exp(offset);
  double weights = 0, weighted_x = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double w = weighted ? weight[i] : 1;
    weights += w;
    weighted_x += w * x[i];
  }
  fit.centre = std::exp(weighted_x / weights);
  for (const FitPoint& point : points) fit.residuals.push_back(point.count / fit.at(point.n) - 1);
  return fit;
}

IntervalSays compare_with_claim(double lower, double upper, double value, double tolerance,
                                bool at_most) {
  const double least = at_most ? -std::numeric_limits<double>::infinity() : value - tolerance;
  const double most = value + tolerance;
  if (lower >= least && upper <= most) return IntervalSays::kConfirmed;
  if (upper < least || lower > most) return IntervalSays::kRefuted;
  return IntervalSays::kOpen;  // not a number, too
}

std::optional<LineFit> fit_line(std::span<const FitPoint> points) {
  if (points.size() < 3) return std::nullopt;
  std::vector<double> x, y;
  for (const FitPoint& point : points) {
    x.push_back(point.n);
    y.push_back(point.count);
  }
  if (std::all_of(x.begin(), x.end(), [&](double value) { return value == x.front(); })) {
    return std::nullopt;
  }
  LineFit fit;
  double cov00, cov01, cov11, squares;
  gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &fit.offset, &fit.slope, &cov00, &cov01,
                 &cov11, &squares);
  fit.scatter = std::sqrt(squares / static_cast<double>(x.size()));
  return fit;
}

}  // namespace kinex
