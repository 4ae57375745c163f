// SPDX-License-Identifier: GPL-3.0-or-later
// Means with their standard errors.
#ifndef KINEX_EXPERIMENTS_LAB_STATISTICS_H
#define KINEX_EXPERIMENTS_LAB_STATISTICS_H

#include <cstdint>

namespace kinex::lab {

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
  friend void fields(Archive& archive, RunningMean& value) {
    archive(value.count_, value.mean_, value.squares_, value.smallest_, value.largest_);
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

}  // namespace kinex::lab

#endif
