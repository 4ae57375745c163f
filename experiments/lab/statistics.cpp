// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/statistics.h"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace kinex::lab {

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

}  // namespace kinex::lab
