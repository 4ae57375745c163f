// SPDX-License-Identifier: GPL-3.0-or-later
// Means with their standard errors, and fits of a power of n.
#ifndef KINEX_EXPERIMENTS_VERIFY_STATISTICS_H
#define KINEX_EXPERIMENTS_VERIFY_STATISTICS_H

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace kinex {

// Mean and spread of a sample, updated one value at a time (Welford 1962).
class RunningMean {
 public:
  void add(double value);
  std::uint64_t count() const { return count_; }
  double mean() const { return mean_; }
  // Sample standard deviation, with n - 1; 0 for fewer than two values.
  double deviation() const;
  double standard_error() const;
  double smallest() const { return smallest_; }
  double largest() const { return largest_; }

  // For field_archive.h.
  template <class Archive>
  void fields(Archive& archive) {
    archive(count_, mean_, squares_, smallest_, largest_);
  }

 private:
  std::uint64_t count_ = 0;
  double mean_ = 0;
  double squares_ = 0;  // sum of squared deviations from the mean
  double smallest_ = 0, largest_ = 0;
};

// The distance of two means in standard errors of their difference, less `tolerance`. 0 if they
// agree within the tolerance; infinite if they differ and neither has an error.
double distance_in_errors(double mean, double error, double reference, double reference_error,
                          double tolerance);

// The allowed distance of a mean from its reference, in standard errors, if `comparisons` such
// means are judged together: 2 for one; for several, as much as makes all of them agree with the
// same probability (95.4 %) if they are independent and nothing is wrong (Sidak 1967): 2.7 for six.
double allowed_errors(int comparisons);

struct FitPoint {
  double n;
  double count;
  double error;  // standard error of `count`; 0: exact
};

// count = factor * n^exponent, by linear least squares on logarithms.
struct PowerFit {
  double exponent = 0;
  double exponent_error = 0;
  double lower = 0, upper = 0;  // 95 % confidence interval of the exponent
  double factor = 0;
  double centre = 0;      // the n where the fit is surest: its logarithm is the (weighted) mean
  bool weighted = false;  // every point has a standard error
  double chi_square = 0;  // weighted sum of squares; meaningless unless `weighted`
  int degrees = 0;        // of freedom: points - 2
  std::vector<double> residuals;  // count / fit - 1, in the order of the points

  double at(double n) const;
};

// Weighted by the standard errors of the logarithms where every point has one, else unweighted with
// the scatter about the line as the error. The interval is that of Student's t with `degrees`
// degrees; where the points scatter more than their errors allow (chi_square > degrees) it is
// widened by sqrt(chi_square / degrees): a systematic departure from a power is not hidden by small
// errors. nullopt for fewer than three points, or points that are not positive, or a single n.
std::optional<PowerFit> fit_power(std::span<const FitPoint> points);

// What a confidence interval says of a claim "value within the tolerance" (at_most: "value or
// less"). Confirmed: all of the interval lies there. Refuted: none of it. Open: some of it, so that
// data that say less (a wider interval) never confirm more.
enum class IntervalSays { kConfirmed, kOpen, kRefuted };
IntervalSays compare_with_claim(double lower, double upper, double value, double tolerance,
                                bool at_most);

// count = offset + slope * x, by linear least squares, all points alike.
struct LineFit {
  double offset = 0, slope = 0;
  double scatter = 0;  // root of the mean of the squared residuals
};
// nullopt for fewer than three points, or a single x.
std::optional<LineFit> fit_line(std::span<const FitPoint> points);

}  // namespace kinex

#endif
