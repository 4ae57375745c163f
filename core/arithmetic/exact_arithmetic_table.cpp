// SPDX-License-Identifier: GPL-3.0-or-later
// Signs of many coordinate differences to one object in ExactArithmetic, from a table of floats.
//
// The error bounds. Let [lo, hi] enclose now, T = max(|lo|, |hi|) and u = 2^-24. The table has h and s
// for the height and slope of an object, relative to the table's own: |h| and |s| are 0 or in
// [2^-100, 2^100], and off by u|h| + e_h and u|s| + e_s. The other object has, relative to the table's,
// balls H and S (ball.h). For every t in [lo, hi] its coordinate less that of the first differs from
//   (H + S hi) - (h + s hi)
// by at most E + e, where
//   E = H.error + S.error T + |S| (hi - lo) + e_h + e_s T   and   e = u (|h| + |s| T) + |s| (hi - lo),
// apart from roundings in doubles. These are less than 2^-50 (|H| + |S| T + |h| + |s| T), and those of
// E and e themselves less than a factor 1 + 2^-40; kRounding and kSlack cover them. Underflow adds less
// than 2^-1070, far below 2^-24 of any value that is not zero, since T is 0 or at least 2^-200.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/arithmetic/exact_arithmetic.h"

namespace kinex {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kAtOnce = 64;
constexpr double kUnit = 0x1p-24 * (1 + 0x1p-10);  // u, and roundings of doubles
constexpr double kRounding = 0x1p-48;
constexpr double kSlack = 1 + 0x1p-20;

bool is_tabled(double x) {
  return x == 0 || (std::fabs(x) >= 0x1p-100 && std::fabs(x) <= 0x1p100);
}

}  // namespace

// Of a motion of degree 1.
Ball ExactArithmetic::coefficient(ObjectId object, int axis, int power) const {
  const auto i = static_cast<std::size_t>(2 * axis + power);
  if (motions_.is_narrow(object)) return {motions_.narrow(object)[i], 0};
  return motions_.ball(object)[i];
}

void ExactArithmetic::fill(PredicateId predicate, std::span<const ObjectId> objects,
                           CoordinateTable& table) const {
  table = {};
  ++table_generation_;
  const int axis = models_[predicate].difference_axis;
  if (axis < 0 || motions_.degree() != 1 || objects.empty()) return;
  for (const int power : {0, 1}) {
    double least = kInfinity, most = -kInfinity, error = 0;
    for (const ObjectId object : objects) {
      const Ball c = coefficient(object, axis, power);
      least = std::min(least, c.value);
      most = std::max(most, c.value);
      error = std::max(error, c.error);
    }
    double& own = power == 0 ? table.height_ : table.slope_;
    own = least + 0.5 * (most - least);
    (power == 0 ? table.height_error_ : table.slope_error_) = error;
    BigArray<float>& column = power == 0 ? table.heights_ : table.slopes_;
    column.reserve(objects.size());
    for (const ObjectId object : objects) {
      const double relative = coefficient(object, axis, power).value - own;
      if (!is_tabled(relative) || !(error <= 0x1p900)) {
        table = {};
        return;
      }
      column.push_back(static_cast<float>(relative));
    }
  }
}

const ExactArithmetic::TableProbe& ExactArithmetic::probe(PredicateId predicate,
                                                          const CoordinateTable& table,
                                                          ObjectId object) {
  // The place decides on time alone.
  const float* const numbers = table.heights_.data();
  const auto address = reinterpret_cast<std::uintptr_t>(numbers);
  const std::uint64_t mixed = address * 0x9e3779b97f4a7c15u >> 32;
  TableProbe& probe = probes_[(mixed + 5 * std::uint64_t{object}) % probes_.size()];
  if (probe.table == numbers && probe.object == object && probe.predicate == predicate &&
      probe.lo == now_.lo && probe.hi == now_.hi && probe.generation == table_generation_) {
    return probe;
  }
  probe.table = numbers;
  probe.object = object;
  probe.predicate = predicate;
  probe.lo = now_.lo;
  probe.hi = now_.hi;
  probe.generation = table_generation_;
  const double bound = std::max(std::fabs(now_.lo), std::fabs(now_.hi));
  probe.usable = !table.heights_.empty() && motions_.degree() == 1 &&
                 (bound == 0 || (bound >= 0x1p-200 && bound <= 0x1p200));
  if (!probe.usable) return probe;
  const int axis = models_[predicate].difference_axis;
  const double width = (now_.hi - now_.lo) * kSlack;
  const Ball height = coefficient(object, axis, 0) - Ball{table.height_, table.height_error_};
  const Ball slope = coefficient(object, axis, 1) - Ball{table.slope_, table.slope_error_};
  probe.value = height.value + slope.value * now_.hi;
  probe.error = height.error + slope.error * bound + std::fabs(slope.value) * width +
                kRounding * (std::fabs(height.value) + std::fabs(slope.value) * bound);
  probe.per_slope = kUnit * bound + width;
  return probe;
}

void ExactArithmetic::signs_after(PredicateId predicate, const CoordinateTable& table,
                                  std::size_t place, std::span<const ObjectId> first,
                                  ObjectId second, Sign* signs) {
  const TableProbe& other = probe(predicate, table, second);
  if (!other.usable) {
    return Arithmetic::signs_after(predicate, table, place, first, second, signs);
  }
  const double t = now_.hi, own_error = other.error, per_slope = other.per_slope;
  const double own = other.value;
  std::uint64_t decided = 0;
  std::array<double, kAtOnce> value, error;
  for (std::size_t done = 0; done < first.size();) {
    const std::size_t size = std::min(first.size() - done, kAtOnce);
    const float* const heights = table.heights_.data() + place + done;
    const float* const slopes = table.slopes_.data() + place + done;
    for (std::size_t i = 0; i < size; ++i) {
      const double h = heights[i], s = slopes[i];
      value[i] = own - (h + s * t);
      error[i] = (own_error + kUnit * std::fabs(h) + per_slope * std::fabs(s)) * kSlack;
    }
    std::size_t unsure = 0;
    for (std::size_t i = 0; i < size; ++i) {
      signs[done + i] = value[i] > 0 ? Sign::kPositive : Sign::kNegative;
      unsure += std::fabs(value[i]) > error[i] ? 0 : 1;
    }
    decided += size - unsure;
    for (std::size_t i = 0; unsure > 0; ++i) {
      if (std::fabs(value[i]) > error[i]) continue;
      signs[done + i] = sign_after(Query(predicate, {first[done + i], second}));
      --unsure;
    }
    done += size;
  }
  counters_.by_predicate[predicate].signs[static_cast<int>(Stage::kDouble)] += decided;
}

}  // namespace kinex
