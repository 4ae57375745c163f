// SPDX-License-Identifier: GPL-3.0-or-later
// The polynomial of a certificate for the first stages of ExactArithmetic: in doubles with error
// bounds, and in 128-bit integers.
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <new>

#include "core/arithmetic/exact_arithmetic.h"
#include "core/arithmetic/reach_power.h"
#include "core/numbers/first_root.h"

namespace kinex {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Within 3 * 2^-53 relative: the two halves of |value| are rounded once each and their sum once.
double to_double(Int128 value) {
  const bool negative = value < 0;
  const unsigned __int128 magnitude =
      negative ? -static_cast<unsigned __int128>(value) : static_cast<unsigned __int128>(value);
  const double high = static_cast<double>(static_cast<std::int64_t>(magnitude >> 64));
  const std::uint64_t low_bits = static_cast<std::uint64_t>(magnitude);
  // Unsigned to double in two exact-enough signed halves (one rounding at their sum).
  const double low = static_cast<double>(static_cast<std::int64_t>(low_bits >> 32)) * 0x1p32 +
                     static_cast<double>(static_cast<std::int64_t>(low_bits & 0xffffffffu));
  const double d = high * 0x1p64 + low;
  return negative ? -d : d;
}

}  // namespace

void ExactArithmetic::wide_coefficients(const Query& query, Int128* out) const {
  constexpr std::size_t kRoom = kMaxFixedAxes * (kMaxFixedDegree + 1);
  std::array<std::array<std::int64_t, kRoom>, kMaxArity> integers;
  std::array<MotionView<std::int64_t>, kMaxViews> points;
  const std::size_t reads = models_[query.predicate].reads;
  for (std::size_t i = 0; i < query.arity; ++i) {
    const double* from = motions_.narrow(query.ids[i]);
    for (std::size_t k = 0; k < reads; ++k) integers[i][k] = static_cast<std::int64_t>(from[k]);
    points[i] = integers[i].data();
  }
  const auto unit = static_cast<std::int64_t>(motions_.unit());
  points[query.arity] = &unit;
  predicates_[query.predicate]->narrow(motions_.degree(), points.data(), out);
}

void ExactArithmetic::approximate_shifted(const Query& query, Approximation& p) const {
  const PredicateModel& model = models_[query.predicate];
  std::array<MotionView<double>, kMaxViews> points;
  for (std::size_t i = 0; i < query.arity; ++i) points[i] = motions_.narrow(query.ids[i]);
  points[query.arity] = &motions_.unit();
  const int d = motions_.degree();
  p.origin = origin_;
  if (model.reach_error == 0) {
    predicates_[query.predicate]->plain(d, points.data(), origin_, p.c);
    for (int i = 0; i <= model.degree; ++i) p.m[i] = std::fabs(p.c[i]);
    return;
  }
  double reach[kMaxFixedDegree + 1];
  predicates_[query.predicate]->plain_with_reach(d, points.data(), origin_, p.c, reach);
  double power[kMaxFixedCoefficients + 1];
  reach_power(reach, d, model.homogeneity, power);
  for (int i = 0; i <= model.degree; ++i) p.m[i] = std::fabs(p.c[i]) + model.reach_error * power[i];
}

// A difference of coordinates, in t: less exact far from t = 0 than with an origin near now, but
// nearly always exact enough for a sign.
bool ExactArithmetic::approximate_difference(const Query& query, Approximation& p) const {
  const int axis = models_[query.predicate].difference_axis;
  const int degree = motions_.degree();
  if (axis < 0 || degree > filter::kMaxFilterDegree) return false;
  const ObjectId from = query.ids[0], to = query.ids[1];
  const auto first = static_cast<std::size_t>(axis) * static_cast<std::size_t>(degree + 1);
  p.degree = degree;
  p.origin = 0;
  if (motions_.is_narrow(from) && motions_.is_narrow(to)) {
    const MotionView<double> a = motions_.narrow(from) + first, b = motions_.narrow(to) + first;
    for (int k = 0; k <= degree; ++k) {
      p.c[k] = b[k] - a[k];
      p.m[k] = std::fabs(p.c[k]);
    }
    return true;
  }
  if (motions_.all_narrow()) return false;
  const double inverse_gamma = (1 + 0x1p-40) / filter::gamma(0);
  const MotionView<Ball> a = motions_.ball(from) + first, b = motions_.ball(to) + first;
  for (int k = 0; k <= degree; ++k) {
    const Ball difference = b[k] - a[k];
    p.c[k] = difference.value;
    p.m[k] = std::fabs(difference.value) + difference.error * inverse_gamma;
  }
  return true;
}

bool ExactArithmetic::approximate(const Query& query, Stage stage, Approximation& p) const {
  const PredicateModel& model = models_[query.predicate];
  const Predicate& predicate = *predicates_[query.predicate];
  const int degree = model.degree;
  p.degree = degree;
  p.origin = 0;
  if (all_narrow(query) && !(model.in_balls && stage == Stage::kDouble)) {
    if (stage == Stage::kDouble) {
      approximate_shifted(query, p);
    } else {
      if (!model.narrow) return false;
      Int128 out[kMaxFixedCoefficients];
      wide_coefficients(query, out);
      for (int i = 0; i <= degree; ++i) {
        p.c[i] = to_double(out[i]);
        p.m[i] = std::fabs(p.c[i]);
      }
    }
  } else {
    if (stage != Stage::kDouble || degree > filter::kMaxFilterDegree) return false;
    std::array<MotionView<Ball>, kMaxViews> points;
    const bool shifts = predicate.shifts(motions_.degree());
    const std::optional<double> from = shifts ? shift_from_anchor(query) : std::nullopt;
    for (std::size_t i = 0; i < query.arity; ++i) {
      points[i] = from ? motions_.anchored(query.ids[i]) : motions_.ball(query.ids[i]);
    }
    points[query.arity] = &motions_.unit_ball();
    // Of the room no more than the coefficients is set to zero.
    alignas(Ball) std::byte room[kRoomForCoefficients * sizeof(Ball)];
    Ball* const out = new (room) Ball[static_cast<std::size_t>(degree) + 1];
    predicate.ball(motions_.degree(), points.data(), from.value_or(origin_), out);
    p.origin = shifts ? origin_ : 0;
    // gamma grows with the degree: dividing by the smallest covers polynomials whose degree drops.
    const double inverse_gamma = (1 + 0x1p-40) / filter::gamma(0);
    double sum = 0;
    for (int i = 0; i <= degree; ++i) {
      p.c[i] = out[i].value;
      p.m[i] = std::fabs(out[i].value) + out[i].error * inverse_gamma;
      sum += p.m[i];
    }
    if (!(sum < kInfinity)) return false;
  }
  while (p.degree >= 0 && p.m[p.degree] == 0) --p.degree;
  return true;
}

}  // namespace kinex
