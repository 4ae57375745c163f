// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/arithmetic/double_arithmetic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/arithmetic/mpfr_first_root.h"
#include "core/numbers/first_root.h"

namespace kinex {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kOne = 1;
constexpr int kRoom = filter::kMaxFilterDegree + 1;

// The coefficients of a certificate polynomial; beyond the filter's degrees they are on the heap.
struct Coefficients {
  std::array<double, kRoom> room;
  std::vector<double> more;
  const double* c = room.data();
};

class DoubleArithmetic final : public Arithmetic {
 public:
  DoubleArithmetic(const Scene& scene, const NumberNeeds& needs)
      : Arithmetic(needs),
        degree_(std::max(1, needs.degree)),
        dimension_(needs.axes),
        stride_(static_cast<std::size_t>(dimension_) * static_cast<std::size_t>(degree_ + 1)),
        coefficients_(scene.objects.size() * stride_, 0.0),
        end_(scene.end ? scene.end->to_double() : kInfinity),
        now_(scene.start.to_double()) {
    for (const SceneObject& object : scene.objects) {
      for (const MotionPiece& piece : object.motion.pieces) {
        if (piece.to && until_.empty()) until_.assign(scene.objects.size(), kInfinity);
      }
    }
  }

  std::string name() const override { return "double"; }
  bool is_exact() const override { return false; }

  void set_motion(ObjectId object, const Trajectory& trajectory,
                  const std::optional<Rational>& until) override {
    const int degree = trajectory.degree_of_axes(0, dimension_);
    if (degree > degree_) widen(degree);
    if (object >= coefficients_.size() / stride_) {
      coefficients_.resize((object + std::size_t{1}) * stride_, 0.0);
      if (!until_.empty()) until_.resize(object + std::size_t{1}, kInfinity);
    }
    double* out = &coefficients_[object * stride_];
    std::fill(out, out + stride_, 0.0);
    const std::size_t axes =
        std::min(static_cast<std::size_t>(dimension_), trajectory.coordinates.size());
    for (std::size_t a = 0; a < axes; ++a) {
      const auto& axis = trajectory.coordinates[a];
      for (std::size_t k = 0; k < axis.size() && k <= static_cast<std::size_t>(degree_); ++k) {
        out[a * static_cast<std::size_t>(degree_ + 1) + k] = axis[k].to_double();
      }
    }
    if (until && until_.empty()) until_.assign(coefficients_.size() / stride_, kInfinity);
    if (!until_.empty()) until_[object] = until ? until->to_double() : kInfinity;
  }

  void prefetch(std::span<const ObjectId> objects) const override {
    for (const ObjectId object : objects) __builtin_prefetch(&coefficients_[object * stride_]);
  }
  void set_now(const Rational& t) override {
    now_ = t.to_double();
    own_ = false;
  }
  void advance(const Query& query, FailureTime& time) override {
    now_ = std::max(now_, time.lo);
    own_ = time.root == 0;
    query_ = query;
  }
  void visit(const Query& query, const FailureTime& time) override {
    home_ = {now_, own_, query_};
    now_ = std::max(now_, time.lo);
    own_ = time.root == 0;
    query_ = query;
  }
  void leave() override {
    now_ = home_.now;
    own_ = home_.own;
    query_ = home_.query;
  }
  double now_approximate() const override { return now_; }
  const InstantName& name_now(InstantDetail detail) override {
    std::array<char, 40> buffer;
    std::snprintf(buffer.data(), buffer.size(), "%.17g", now_);
    return inexact_name(detail, buffer.data());
  }

  Sign sign_after(const Query& query) override {
    ++counters_.by_predicate[query.predicate].signs[static_cast<int>(Stage::kDouble)];
    // The failed certificate is negative now, wherever its root was rounded to.
    const int relation = own_ ? related(query, query_) : 0;
    if (relation != 0) return relation > 0 ? Sign::kNegative : Sign::kPositive;
    Coefficients room;
    const int degree = polynomial(query, room);
    const double* c = room.c;
    return degree < 0 ? Sign::kZero : sign_at_now(c, degree);
  }

  Outlook failure(const Query& query, FailureTime& time) override {
    return look_ahead(query, kInfinity, time);
  }

  Outlook look_further(const Query& query, double from, double limit, FailureTime& time) override {
    time = {kInfinity, kInfinity, 0};
    ++counters_.by_predicate[query.predicate].looks[static_cast<int>(Stage::kDouble)];
    Coefficients room;
    const int degree = polynomial(query, room);
    const double* c = room.c;
    if (degree < 2) return Outlook::kNever;  // not from look_ahead
    return first_failure(query, c, degree, from, limit, time);
  }

  Outlook look_ahead(const Query& query, double limit, FailureTime& time) override {
    time = {kInfinity, kInfinity, 0};
    ++counters_.by_predicate[query.predicate].failures[static_cast<int>(Stage::kDouble)];
    Coefficients room;
    const int degree = polynomial(query, room);
    const double* c = room.c;
    if (degree < 0) return Outlook::kIdenticallyZero;
    if (static_cast<std::size_t>(degree) >= counters_.polynomials_solved.size()) {
      counters_.polynomials_solved.resize(static_cast<std::size_t>(degree) + 1);
    }
    ++counters_.polynomials_solved[static_cast<std::size_t>(degree)];
    double from = now_;
    const int relation = own_ ? related(query, query_) : 0;
    if (relation < 0) {
      // Its root at now is known: start a few units after it.
      if (degree == 1) return Outlook::kNever;
      from = now_ + 0x1p-49 * std::fabs(now_) + 0x1p-1000;
    } else if (relation > 0 || (degree != 1 && sign_at_now(c, degree) == Sign::kNegative)) {
      return fails_now(time);
    }
    if (degree == 0) return Outlook::kNever;
    if (degree > 1) return first_failure(query, c, degree, from, limit, time);
    const double t = -c[0] / c[1];
    if (c[1] > 0) return t > now_ ? fails_now(time) : Outlook::kNever;
    if (t <= now_) return fails_now(time);
    if (!(t <= horizon(query))) return Outlook::kNever;
    time = {t, t, 0};
    return Outlook::kFails;
  }

  int compare(const Query&, FailureTime& a, const Query&, FailureTime& b) override {
    return a.lo < b.lo ? -1 : a.lo > b.lo ? 1 : 0;
  }
  int compare_with_now(const Query&, FailureTime& a) override {
    return a.lo < now_ ? -1 : a.lo > now_ ? 1 : 0;
  }
  int compare(const Query&, FailureTime& a, const Rational& t) override {
    const double d = t.to_double();
    return a.lo < d ? -1 : a.lo > d ? 1 : 0;
  }
  void release(FailureTime& time) override { time.root = 0; }

  std::optional<Rational> rational_between(const Query*, FailureTime* time) override {
    if (time == nullptr || time->lo == kInfinity) {
      const auto from = Rational::from_double(now_);  // nullopt if now is infinite
      return from ? std::optional<Rational>(*from + Rational(1)) : std::nullopt;
    }
    const double middle = now_ + 0.5 * (time->lo - now_);
    if (!(middle > now_ && middle < time->lo)) return std::nullopt;
    return Rational::from_double(middle);
  }

  std::size_t bytes() const override {
    return (coefficients_.capacity() + until_.capacity()) * sizeof(double);
  }

 private:
  Outlook fails_now(FailureTime& time) const {
    time = {now_, now_, 1};
    return Outlook::kFailsNow;
  }

  void widen(int degree) {
    const std::size_t objects = coefficients_.size() / stride_;
    const std::size_t axes = static_cast<std::size_t>(dimension_);
    const std::size_t old_powers = static_cast<std::size_t>(degree_) + 1;
    const std::size_t powers = static_cast<std::size_t>(degree) + 1;
    std::vector<double> wider(objects * axes * powers, 0.0);
    for (std::size_t row = 0; row < objects * axes; ++row) {
      for (std::size_t k = 0; k < old_powers; ++k) {
        wider[row * powers + k] = coefficients_[row * old_powers + k];
      }
    }
    coefficients_ = std::move(wider);
    degree_ = degree;
    stride_ = axes * powers;
  }

  Outlook first_failure(const Query& query, const double* c, int degree,
                        double from, double limit, FailureTime& time) const {
    const double end = horizon(query);
    if (degree > filter::kMaxFilterDegree) return first_failure_of_many(c, degree, from, end, time);
    const double until = std::min(end, limit);
    filter::Enclosure enclosure;
    if (filter::first_sign_change<false>(c, nullptr, degree, 0.0, from, until, enclosure) !=
            filter::Search::kFound ||
        !(enclosure.lo <= until)) {
      if (!(limit < end)) return Outlook::kNever;
      time = {limit, limit, 0};
      return Outlook::kLater;
    }
    const double t = std::max(enclosure.lo, now_);
    time = {t, t, 0};
    return Outlook::kFails;
  }

  // The same search in MPFR's numbers of this precision, which takes any degree.
  Outlook first_failure_of_many(const double* c, int degree, double from, double end,
                                FailureTime& time) const {
    std::vector<MpFloat> many;
    for (int i = 0; i <= degree; ++i) many.emplace_back(53, c[i]);
    std::optional<MpFloat> until;
    if (end < kInfinity) until.emplace(53, end);
    const auto found = mpfr_first_sign_change(many, MpFloat(53, from), until);
    if (!found || !found->is_finite()) return Outlook::kNever;
    const double t = std::max(found->to_double(), now_);
    if (!(t <= end)) return Outlook::kNever;
    time = {t, t, 0};
    return Outlook::kFails;
  }

  // The degree after exact zeros are stripped; -1 for zero.
  int polynomial(const Query& query, Coefficients& room) const {
    const Predicate& predicate = *predicates_[query.predicate];
    int degree = predicate.degree(degree_);
    double* c = room.room.data();
    if (degree >= kRoom) {
      room.more.resize(static_cast<std::size_t>(degree) + 1);
      room.c = c = room.more.data();
    }
    std::array<MotionView<double>, kMaxViews> points;
    for (std::size_t i = 0; i < query.arity; ++i)
      points[i] = &coefficients_[query.ids[i] * stride_];
    points[query.arity] = &kOne;
    predicate.plain(degree_, points.data(), 0.0, c);
    while (degree >= 0 && c[degree] == 0) --degree;
    return degree;
  }

  Sign sign_at_now(const double* c, int degree) const {
    double v = c[degree];
    double slope = 0;
    for (int i = degree - 1; i >= 0; --i) {
      slope = slope * now_ + v;
      v = v * now_ + c[i];
    }
    if (v == 0) v = slope;
    return v > 0 ? Sign::kPositive : v < 0 ? Sign::kNegative : Sign::kZero;
  }

  double horizon(const Query& query) const {
    double b = end_;
    if (!until_.empty()) {
      for (std::size_t i = 0; i < query.arity; ++i) b = std::min(b, until_[query.ids[i]]);
    }
    return b;
  }

  int degree_;
  int dimension_;
  std::size_t stride_;
  std::vector<double> coefficients_;
  std::vector<double> until_;  // per object; empty if no motion of the scene ends
  double end_;
  double now_;
  bool own_ = false;  // now is a failure time found for query_
  Query query_;
  struct {
    double now;
    bool own;
    Query query;
  } home_{};  // where leave() goes back to
};

}  // namespace

std::unique_ptr<Arithmetic> make_double_arithmetic(const Scene& scene,
                                                  const NumberNeeds& needs) {
  return std::make_unique<DoubleArithmetic>(scene, needs);
}

}  // namespace kinex
