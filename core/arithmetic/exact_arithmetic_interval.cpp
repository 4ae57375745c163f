// SPDX-License-Identifier: GPL-3.0-or-later
// Which objects of a table are out of an interval in ExactArithmetic: in floats, four at once, and
// where these are not sure by signs_after().
//
// The error bounds. Names are those of exact_arithmetic_table.cpp: there the difference of an end of
// the interval and an object, own - (h + s t), is bounded for doubles by
//   own_error + u |h| + per_slope |s|.
// Floats round own, t, the product s t, the sum and the difference as well. With |t| <= T that adds
//   u |own| + u |h| + 3 u T |s|
// and, of the difference itself, u times its magnitude. Roundings of the bound, and products of errors,
// are factors of less than 1 + 2^-20; kSlack covers them. T is 0 or in [2^-100, 2^20], and |own| is at
// most 2^100, so no operation overflows, and what is lost by underflow is less than kLeast.
#include <cmath>
#include <cstdint>
#include <cstring>

#include "core/arithmetic/exact_arithmetic.h"

namespace kinex {
namespace {

constexpr std::size_t kFloats = 4;  // side by side
typedef float Floats __attribute__((vector_size(16)));
typedef std::int32_t Flags __attribute__((vector_size(16)));

constexpr double kUnit = 0x1p-24 * (1 + 0x1p-10);
constexpr double kSlack = 1 + 0x1p-18;
constexpr double kLeast = 0x1p-120;

// The least float that surely is not less than x.
float rounded_up(double x) { return static_cast<float>(x * kSlack + kLeast); }

// Bit i: flag i is set.
[[gnu::always_inline]] inline std::uint64_t bits_of(Flags flags) {
#if defined(__x86_64__)
  return static_cast<std::uint64_t>(__builtin_ia32_movmskps((Floats)flags));
#else
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < kFloats; ++i) bits |= flags[i] != 0 ? std::uint64_t{1} << i : 0;
  return bits;
#endif
}

[[gnu::always_inline]] inline Floats load(const float* from) {
  Floats x;
  std::memcpy(&x, from, sizeof x);
  return x;
}

[[gnu::always_inline]] inline Floats magnitude_of(Floats x) {
  const Flags all_but_sign{0x7fffffff, 0x7fffffff, 0x7fffffff, 0x7fffffff};
  return (Floats)((Flags)x & all_but_sign);
}

// One end of the interval.
struct End {
  float value, error, per_height, per_slope;
};

// Of four objects: those that are surely before low, that are surely not, and likewise for high.
struct Decided {
  std::uint64_t before = 0, not_before = 0, after = 0, not_after = 0;

  [[gnu::always_inline]] void add(const End& low, const End& high, float t, const float* heights,
                                  const float* slopes, std::size_t place) {
    const Floats h = load(heights + place), s = load(slopes + place);
    const Floats at = h + s * t;
    const Floats of_height = magnitude_of(h), of_slope = magnitude_of(s);
    const Floats from_low = low.value - at, to_high = high.value - at;
    // Both ends have the same factors but for their own errors.
    const Floats error = of_height * low.per_height + of_slope * low.per_slope;
    const Floats low_error = error + low.error, high_error = error + high.error;
    before |= bits_of(from_low > low_error) << place;
    not_before |= bits_of(-from_low > low_error) << place;
    not_after |= bits_of(to_high > high_error) << place;
    after |= bits_of(-to_high > high_error) << place;
  }
};

}  // namespace

OutOfInterval ExactArithmetic::out_of_interval(PredicateId predicate, const CoordinateTable& table,
                                               std::size_t place, std::span<const ObjectId> first,
                                               ObjectId low, ObjectId high) {
  // The second probe may take the place of the first one.
  const TableProbe low_probe = probe(predicate, table, low);
  const TableProbe& high_probe = probe(predicate, table, high);
  const double bound = std::max(std::fabs(now_.lo), std::fabs(now_.hi));
  OutOfInterval out;
  Decided decided;
  const std::size_t size = first.size();
  const bool fits = low_probe.usable && high_probe.usable &&
                    (bound == 0 || (bound >= 0x1p-100 && bound <= 0x1p20)) &&
                    std::fabs(low_probe.value) <= 0x1p100 && low_probe.error <= 0x1p100 &&
                    std::fabs(high_probe.value) <= 0x1p100 && high_probe.error <= 0x1p100;
  if (fits && size >= kFloats) {
    const auto end_of = [bound](const TableProbe& own) {
      return End{static_cast<float>(own.value),
                 rounded_up(own.error + kUnit * std::fabs(own.value)), rounded_up(2 * kUnit),
                 rounded_up(own.per_slope + 3 * kUnit * bound)};
    };
    const End low_end = end_of(low_probe), high_end = end_of(high_probe);
    const float* const heights = table.heights_.data() + place;
    const float* const slopes = table.slopes_.data() + place;
    const auto t = static_cast<float>(now_.hi);
    for (std::size_t i = 0; i + kFloats <= size; i += kFloats) {
      decided.add(low_end, high_end, t, heights, slopes, i);
    }
    // The last ones, some of them once more.
    if (size % kFloats != 0) decided.add(low_end, high_end, t, heights, slopes, size - kFloats);
  }
  out.before = decided.before;
  out.after = decided.after;
  const std::uint64_t all = OutOfInterval::all(size);
  const std::uint64_t low_sure = decided.before | decided.not_before;
  const std::uint64_t high_sure = decided.after | decided.not_after;
  std::uint64_t unsure = all & ~(low_sure & high_sure);
  std::size_t asked = 0;
  for (; unsure != 0; unsure &= unsure - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctzll(unsure));
    const std::uint64_t bit = std::uint64_t{1} << i;
    Sign sign;
    if ((low_sure & bit) == 0) {
      ++asked;
      signs_after(predicate, table, place + i, first.subspan(i, 1), low, &sign);
      if (sign == Sign::kPositive) out.before |= bit;
    }
    if ((high_sure & bit) == 0) {
      ++asked;
      signs_after(predicate, table, place + i, first.subspan(i, 1), high, &sign);
      if (sign == Sign::kNegative) out.after |= bit;
    }
  }
  counters_.by_predicate[predicate].signs[static_cast<int>(Stage::kDouble)] += 2 * size - asked;
  return out;
}

}  // namespace kinex
