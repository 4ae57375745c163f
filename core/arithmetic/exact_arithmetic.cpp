// SPDX-License-Identifier: GPL-3.0-or-later
// The floating-point filter of ExactArithmetic. Its polynomials are in
// exact_arithmetic_polynomial.cpp, the exact stage in exact_arithmetic_slow.cpp
// and exact_arithmetic_short.cpp.
#include "core/arithmetic/exact_arithmetic.h"

#include <array>
#include <cmath>
#include <limits>

#include "core/arithmetic/coordinate_difference.h"
#include "core/arithmetic/search_outlook.h"
#include "core/numbers/first_root.h"
#include "core/numbers/interval_sign.h"

namespace kinex {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

ExactArithmetic::ExactArithmetic(const Scene& scene, const NumberNeeds& needs)
    : Arithmetic(needs),
      motions_(choose_number_model(scene, needs), scene.objects.size()),
      end_(scene.end),
      end_upper_(scene.end ? scene.end->upper_double() : kInfinity) {
  bool ends = false;
  for (const SceneObject& object : scene.objects) {
    for (const MotionPiece& piece : object.motion.pieces) ends = ends || piece.to.has_value();
  }
  if (ends) until_.assign(scene.objects.size(), kInfinity);
  set_now(scene.start);
}

void ExactArithmetic::bound_predicate(PredicateId id) {
  const Predicate& p = *predicates_[id];
  PredicateModel model;
  const NumberModel& numbers = motions_.model();
  model.degree = p.degree(numbers.degree);
  model.homogeneity = p.homogeneity();
  model.reads = static_cast<std::size_t>(p.dimension()) * static_cast<std::size_t>(numbers.degree + 1);
  model.fixed = numbers.degree <= kMaxFixedDegree && model.degree < kMaxFixedCoefficients &&
                model.homogeneity * numbers.degree < kMaxFixedCoefficients &&
                p.dimension() <= kMaxFixedAxes && (!p.has_unit() || motions_.unit_is_narrow());
  if (!model.fixed) motions_.need_balls();
  if (numbers.narrow && model.fixed) {
    model.narrow = p.narrow_fits(numbers.degree, numbers.magnitude.data(), motions_.unit());
    // gamma grows with the degree: dividing by the smallest covers polynomials whose degree drops.
    model.reach_error = p.reach_error(numbers.degree) * (1 + 0x1p-20) / filter::gamma(0);
    model.linear = model.degree == 1 && numbers.degree == 1 && model.reach_error == 0;
    model.in_balls = std::isinf(model.reach_error);
    if (model.in_balls) motions_.need_balls();
  }
  model.in_lanes = model.reach_error > 0 && !model.in_balls && filter::has_lanes(model.degree);
  model.touches = fails_at_touch(id);
  model.form = dynamic_cast<const LinearForm*>(&p);
  if (const auto* const difference = dynamic_cast<const CoordinateDifference*>(&p)) {
    model.difference_axis = difference->difference_axis();
    model.differs = model.narrow && model.reach_error == 0 && model.degree == numbers.degree &&
                    !model.touches;
    model.differs_in_balls =
        model.degree == numbers.degree && !model.touches && p.shifts(numbers.degree);
    model.differs_in_lanes = model.degree >= 1 && model.degree <= filter::kMaxDifferenceDegree;
  }
  if (const auto* const order = dynamic_cast<const LengthOrder*>(&p)) {
    model.lengths = order->length_ends();
    const bool answers = model.fixed && numbers.narrow && p.dimension() <= 3 &&
                         model.reach_error > 0 && !model.in_balls && model.homogeneity == 2 &&
                         model.degree == 2 * numbers.degree &&
                         p.arity() == (model.lengths.share_an_end() ? 3 : 4);
    if (answers) {
      model.lengths_path =
          static_cast<LengthsPath>(2 * numbers.degree - (model.lengths.share_an_end() ? 1 : 0));
    }
  }
  touches_ = touches_ || model.touches;
  models_.push_back(model);
}

// The shifted motions are exact if all their coefficients are multiples of step^degree (the origin
// is a multiple of step <= 1, or an integer) of at most 53 bits; one bit is kept for differences.
bool ExactArithmetic::shift_is_exact(double origin, double step) const {
  const NumberModel& numbers = motions_.model();
  double unit = 1;
  for (int k = 0; k < numbers.degree; ++k) unit *= std::min(step, 1.0);
  const double reach = std::fabs(origin);
  for (int i = 0; i <= numbers.degree; ++i) {
    double sum = 0, binomial = 1, power = 1;
    for (int j = i; j <= numbers.degree; ++j) {
      sum += binomial * power * numbers.magnitude[static_cast<std::size_t>(j)];
      power *= reach;
      binomial = binomial * (j + 1) / (j + 1 - i);
    }
    if (!(sum <= 0x1p52 * unit)) return false;
  }
  return true;
}

void ExactArithmetic::update_origin() {
  const double now = now_.lo;
  if (now >= origin_ && now < origin_end_) return;
  origin_ = 0;
  if (now == 0) {
    origin_end_ = end_upper_ < kInfinity ? end_upper_ * 0x1p-10 : 0x1p-20;
    return;
  }
  if (std::fabs(now) < 0x1p-900) {  // a step of few bits would underflow
    origin_end_ = now > 0 ? 0x1p-900 : 0;
    return;
  }
  if (!(std::fabs(now) < 0x1p1000)) {  // close to overflow
    origin_end_ = 0;
    return;
  }
  const int exponent = std::ilogb(now);
  for (int e = exponent - 12; e <= exponent; ++e) {
    const double step = std::ldexp(1.0, e);
    const double origin = std::floor(now / step) * step;
    if (motions_.model().narrow && !shift_is_exact(origin, step)) continue;
    origin_ = origin;
    origin_end_ = origin + step;
    return;
  }
  origin_end_ = 2 * std::fabs(now);
}

void ExactArithmetic::set_motion(ObjectId object, const Trajectory& trajectory,
                                 const std::optional<Rational>& until) {
  const int before = motions_.degree();
  keep_now(object);
  linear_signs_.forget(object);
  ++table_generation_;
  motions_.set(object, trajectory, origin_);
  if (motions_.degree() != before) {
    for (std::size_t i = 0; i < models_.size(); ++i) {
      models_[i].fixed = models_[i].narrow = models_[i].linear = models_[i].in_lanes = false;
      models_[i].differs = models_[i].differs_in_balls = models_[i].differs_in_lanes = false;
      models_[i].lengths_path = LengthsPath::kNone;
      models_[i].degree = predicates_[i]->degree(motions_.degree());
    }
  }
  if (until && until_.empty()) until_.assign(object + 1, kInfinity);
  if (!until_.empty()) {
    if (until_.size() <= object) until_.resize(object + 1, kInfinity);
    until_[object] = until ? until->upper_double() : kInfinity;
  }
}

// The end of the scene, or of the first motion.
double ExactArithmetic::first_end(const Query& query) const {
  double b = end_upper_;
  for (int i = 0; i < query.arity; ++i) {
    const ObjectId id = query.ids[static_cast<std::size_t>(i)];
    if (id < until_.size()) b = std::min(b, until_[id]);
  }
  return b;
}

// relation_to_now, now being a query's own root.
int ExactArithmetic::relation_by_ids(const Query& query) const {
  // At a touch nothing has become negative. Roots that the filter isolates are not touches.
  if (touches_ && models_[now_.query.predicate].touches && !now_.isolated) return 0;
  return related(query, now_.query);
}

// The sign of p on all of [now.lo, now.hi], if it is certainly constant; it is then the sign at now
// and right after it.
std::optional<Sign> ExactArithmetic::sign_over_now(const Approximation& p) const {
  const filter::Interval now{now_.lo - p.origin, now_.hi - p.origin, now_.hi - now_.lo};
  switch (p.degree) {
    case 1:
      return filter::sign_over<1>(p.c, p.m, 1, now);
    case 2:
      return filter::sign_over<2>(p.c, p.m, 2, now);
    case 3:
      return filter::sign_over<3>(p.c, p.m, 3, now);
    case 4:
      return filter::sign_over<4>(p.c, p.m, 4, now);
    default:
      return filter::sign_over<-1>(p.c, p.m, p.degree, now);
  }
}

Sign ExactArithmetic::sign_after(const Query& query) {
  if (models_[query.predicate].lengths_path != LengthsPath::kNone && all_narrow(query)) {
    if (const auto sign = length_sign(query)) {
      ++count(query).signs[static_cast<int>(Stage::kDouble)];
      return *sign;
    }
  }
  return filtered_sign_after(query);
}

Sign ExactArithmetic::filtered_sign_after(const Query& query) {
  StageCounts& counts = count(query).signs;
  if (const auto sign = form_over_now(query)) {
    ++counts[static_cast<int>(Stage::kDouble)];
    return *sign;
  }
  Approximation p;
  if (approximate_difference(query, p)) {
    if (const auto sign = sign_over_now(p)) {
      ++counts[static_cast<int>(Stage::kDouble)];
      return *sign;
    }
  }
  const auto sign_by = [&](Stage stage) -> std::optional<Sign> {
    if (!approximate(query, stage, p)) return std::nullopt;
    return p.degree < 0 ? Sign::kZero : sign_over_now(p);
  };
  if (const auto sign = sign_by(Stage::kDouble)) {
    ++counts[static_cast<int>(Stage::kDouble)];
    return *sign;
  }
  // The certificate that has just become negative, or its opposite.
  if (const int relation = relation_to_now(query)) {
    ++counts[static_cast<int>(Stage::kDouble)];
    return relation > 0 ? Sign::kNegative : Sign::kPositive;
  }
  if (const auto sign = short_sign_after(query)) {
    ++counts[static_cast<int>(Stage::kExact)];
    return *sign;
  }
  if (const auto sign = sign_by(Stage::kWide)) {
    ++counts[static_cast<int>(Stage::kWide)];
    return *sign;
  }
  ++counts[static_cast<int>(Stage::kExact)];
  return exact_sign_after(query);
}

// Closed form for degree 1: c0 + c1 t.
std::optional<Outlook> ExactArithmetic::linear_failure(const Query& query, const Approximation& p,
                                                       int relation, FailureTime& time) {
  const double c0 = p.c[0], c1 = p.c[1];
  const double lead_error = p.m[1] * filter::gamma(1);
  if (relation < 0) return Outlook::kNever;  // its only root is now
  if (!(std::fabs(c1) > lead_error) || !(p.m[0] <= 0x1p900 && p.m[1] <= 0x1p900) ||
      !(p.m[1] >= 0x1p-300)) {
    return std::nullopt;
  }
  // |r - root| <= (e0 + |r| e1) / (|c1| - e1) + u |r|.
  const double r = -c0 / c1;
  const double t = p.origin + r;
  const double error = (p.m[0] + std::fabs(r) * p.m[1]) * filter::gamma(1) /
                           (std::fabs(c1) - lead_error) * (1 + 0x1p-20) +
                       std::fabs(r) * 0x1p-52 + std::fabs(t) * 0x1p-51 + 0x1p-1000;
  const double lo = t - error, hi = t + error;
  if (c1 < 0) {
    if (lo > now_.hi) {
      if (lo > horizon(query)) return Outlook::kNever;
      time = {lo, hi, 0};
      return Outlook::kFails;
    }
    if (hi < now_.lo) return fails_now(time);
  } else {
    if (hi < now_.lo) return Outlook::kNever;
    if (lo > now_.hi) return fails_now(time);
  }
  return std::nullopt;
}

// The same where c0 and c1 are exact: -c0 / c1 is off by half a unit in its last place.
std::optional<Outlook> ExactArithmetic::linear_failure(const Query& query, FailureTime& time) {
  const int relation = relation_to_now(query);
  solved_degree_ = 1;
  if (relation < 0) return Outlook::kNever;  // its only root is now
  if (relation > 0) return fails_now(time);
  double c[2];
  if (const PredicateModel& model = models_[query.predicate]; model.differs) {
    const auto first = static_cast<std::size_t>(model.difference_axis) * 2;
    const MotionView<double> from = motions_.narrow(query.ids[0]) + first;
    const MotionView<double> to = motions_.narrow(query.ids[1]) + first;
    c[0] = to[0] - from[0];
    c[1] = to[1] - from[1];
  } else {
    std::array<MotionView<double>, kMaxViews> points;
    for (std::size_t i = 0; i < query.arity; ++i) points[i] = motions_.narrow(query.ids[i]);
    points[query.arity] = &motions_.unit();
    predicates_[query.predicate]->plain(1, points.data(), 0, c);
  }
  if (c[1] == 0) {
    solved_degree_ = c[0] == 0 ? -1 : 0;
    if (c[0] < 0) return fails_now(time);
    return c[0] == 0 ? Outlook::kIdenticallyZero : Outlook::kNever;
  }
  const double r = -c[0] / c[1];
  const double error = std::fabs(r) * 0x1.8p-52;
  const double lo = r - error, hi = r + error;
  if (lo > now_.hi) {
    if (c[1] > 0) return fails_now(time);
    if (lo > horizon(query)) return Outlook::kNever;
    time = {lo, hi, 0};
    return Outlook::kFails;
  }
  if (!(hi < now_.lo)) return std::nullopt;
  return c[1] > 0 ? Outlook::kNever : fails_now(time);
}

Outlook ExactArithmetic::failure(const Query& query, FailureTime& time) {
  return look_ahead(query, kInfinity, time);
}

Outlook ExactArithmetic::look_ahead(const Query& query, double limit, FailureTime& time) {
  if (models_[query.predicate].lengths_path != LengthsPath::kNone && all_narrow(query)) {
    if (const auto found = length_failure(query, limit, time)) return *found;
  }
  return filtered_look_ahead(query, limit, time);
}

Outlook ExactArithmetic::filtered_look_ahead(const Query& query, double limit, FailureTime& time) {
  if (models_[query.predicate].difference_axis >= 0) {
    if (const auto found = difference_failure(query, limit, time)) return *found;
  }
  Outlook outlook;
  const Stage stage = find_failure(query, limit, time, outlook);
  if (stage != Stage::kDouble) ++possible_zeros_;
  if (solved_degree_ >= 0) count_solved(solved_degree_);
  ++count(query).failures[static_cast<std::size_t>(stage)];
  return outlook;
}

Stage ExactArithmetic::find_failure(const Query& query, double limit, FailureTime& time,
                                    Outlook& outlook) {
  time = {kInfinity, kInfinity, 0};
  solved_degree_ = -1;
  if (models_[query.predicate].linear && all_narrow(query)) {
    if (const auto found = linear_failure(query, time)) {
      outlook = *found;
      return Stage::kDouble;
    }
  }
  if (const auto found = failure_in(Stage::kDouble, query, limit, time)) {
    outlook = *found;
    return Stage::kDouble;
  }
  if (const auto found = short_failure(query, time)) {
    outlook = *found;
    return Stage::kExact;
  }
  if (const auto found = failure_in(Stage::kWide, query, limit, time)) {
    outlook = *found;
    return Stage::kWide;
  }
  outlook = exact_failure(query, time);
  return Stage::kExact;
}

// The certificate is positive at `from`, so now does not matter.
Outlook ExactArithmetic::look_further(const Query& query, double from, double limit,
                                      FailureTime& time) {
  StageCounts& counts = count(query).looks;
  Approximation p;
  if (approximate(query, Stage::kDouble, p) && p.degree >= 2) {
    const double a = from - p.origin;
    if (from - a == p.origin && p.origin + a == from) {
      if (const auto outlook = first_failure(query, p.c, p.m, p.degree, p.origin, a, limit, time)) {
        ++counts[static_cast<std::size_t>(Stage::kDouble)];
        return *outlook;
      }
    }
  }
  Outlook outlook;
  const Stage stage = find_failure(query, kInfinity, time, outlook);
  ++counts[static_cast<std::size_t>(stage)];
  return outlook;
}

std::optional<Outlook> ExactArithmetic::failure_in(Stage stage, const Query& query, double limit,
                                                   FailureTime& time) {
  Approximation p;
  if (!approximate(query, stage, p)) return std::nullopt;
  if (p.degree < 0) return Outlook::kIdenticallyZero;
  solved_degree_ = p.degree;
  if (p.degree == 0) {
    const double error = p.m[0] * filter::gamma(0);
    if (!(p.m[0] <= 0x1p900)) return std::nullopt;
    if (p.c[0] > error) return Outlook::kNever;
    if (p.c[0] < -error) return fails_now(time);
    return std::nullopt;
  }
  const int relation = relation_to_now(query);
  if (relation > 0) return fails_now(time);  // the polynomial that has just become negative
  if (p.degree == 1) return linear_failure(query, p, relation, time);
  if (relation < 0 && !now_.isolated) return std::nullopt;
  const double* c = p.c;
  const double* m = p.m;
  int degree = p.degree;
  if (relation == 0) {
    const auto sign = sign_over_now(p);
    if (sign == Sign::kNegative) return fails_now(time);
    if (!sign) {
      ++possible_zeros_;
      // A root exactly at the origin shows in the coefficients.
      if (!(now_.lo == p.origin && now_.hi == p.origin) || m[0] != 0) return std::nullopt;
      int k = 0;
      while (m[k] == 0) ++k;
      if (!(std::fabs(c[k]) > m[k] * filter::gamma(degree))) return std::nullopt;
      if (c[k] < 0) return fails_now(time);
      c += k;
      m += k;
      degree -= k;
      if (degree == 0) return Outlook::kNever;
      if (degree == 1) return std::nullopt;
    }
  }
  // now.hi - origin is exact.
  return first_failure(query, c, m, degree, p.origin, now_.hi - p.origin, limit, time);
}

// The first sign change after `from` (in t - origin). Requires: positive right after `from`.
std::optional<Outlook> ExactArithmetic::first_failure(const Query& query, const double* c,
                                                      const double* m, int degree, double origin,
                                                      double from, double limit,
                                                      FailureTime& time) const {
  filter::Enclosure enclosure;
  const double end = horizon(query);
  // The end may be slightly too late, never too early.
  const double until = filter::next_up(std::min(end, limit) - origin);
  return outlook_of(filter::first_sign_change<true>(c, m, degree, origin, from, until, enclosure),
                    enclosure, limit, end, time);
}

}  // namespace kinex
