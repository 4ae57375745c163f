// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/arithmetic/mpfr_arithmetic.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <optional>

#include "core/arithmetic/mpfr_first_root.h"

namespace kinex {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class MpfrArithmetic final : public Arithmetic {
 public:
  MpfrArithmetic(const Scene& scene, const NumberNeeds& needs, long bits)
      : Arithmetic(needs),
        bits_(bits),
        degree_(std::max(1, needs.degree)),
        dimension_(static_cast<std::size_t>(std::max(1, needs.axes))),
        stride_(dimension_ * static_cast<std::size_t>(degree_ + 1)),
        coefficients_(scene.objects.size() * stride_, MpFloat(bits)),
        until_(scene.objects.size()),
        one_(bits, 1.0),
        now_(bits, scene.start) {
    if (scene.end) end_ = MpFloat(bits, *scene.end);
  }

  std::string name() const override { return "mpfr:" + std::to_string(bits_); }
  bool is_exact() const override { return false; }
  long precision() const override { return bits_; }

  void set_motion(ObjectId object, const Trajectory& trajectory,
                  const std::optional<Rational>& until) override {
    const int degree = trajectory.degree_of_axes(0, static_cast<int>(dimension_));
    if (degree > degree_) widen(degree);
    const std::size_t powers = static_cast<std::size_t>(degree_) + 1;
    if (object >= until_.size()) {
      until_.resize(object + std::size_t{1});
      coefficients_.resize(until_.size() * stride_, MpFloat(bits_));
    }
    for (std::size_t k = 0; k < stride_; ++k) coefficients_[object * stride_ + k] = MpFloat(bits_);
    for (std::size_t a = 0; a < std::min(dimension_, trajectory.coordinates.size()); ++a) {
      const auto& axis = trajectory.coordinates[a];
      for (std::size_t k = 0; k < axis.size() && k < powers; ++k) {
        coefficients_[object * stride_ + a * powers + k] = MpFloat(bits_, axis[k]);
      }
    }
    until_[object] = until ? std::optional<MpFloat>(MpFloat(bits_, *until)) : std::nullopt;
  }

  void set_now(const Rational& t) override {
    now_ = MpFloat(bits_, t);
    own_ = false;
  }
  void advance(const Query& query, FailureTime& time) override {
    const bool at_now = (time.root & kNow) != 0;
    if (time.root != 0 && !at_now) {
      MpFloat& t = times_[time.root - 1];
      if (compare_values(t, now_) > 0) now_ = t;
    }
    release(time);
    own_ = !at_now;
    query_ = query;
  }
  void visit(const Query& query, const FailureTime& time) override {
    home_ = now_;
    own_at_home_ = own_;
    query_at_home_ = query_;
    own_ = (time.root & kNow) == 0;
    if (time.root != 0 && own_ && compare_values(value(time), now_) > 0) now_ = value(time);
    query_ = query;
  }
  void leave() override {
    now_ = home_;
    own_ = own_at_home_;
    query_ = query_at_home_;
  }
  double now_approximate() const override { return now_.to_double(); }
  std::optional<Rational> now_value() const override {
    if (!now_.is_finite()) return std::nullopt;
    Rational value;
    mpfr_get_q(value.edit(), now_.raw());
    return value;
  }
  const InstantName& name_now(InstantDetail detail) override {
    // Enough digits to distinguish two neighbours of this precision.
    const int digits = static_cast<int>(static_cast<double>(bits_) * 0.30103) + 2;
    std::array<char, 64> small;
    const int size = mpfr_snprintf(small.data(), small.size(), "%.*Rg", digits, now_.raw());
    if (size < static_cast<int>(small.size())) return inexact_name(detail, small.data());
    std::vector<char> large(static_cast<std::size_t>(size) + 1);
    mpfr_snprintf(large.data(), large.size(), "%.*Rg", digits, now_.raw());
    return inexact_name(detail, large.data());
  }

  Sign sign_after(const Query& query) override {
    ++counters_.by_predicate[query.predicate].signs[static_cast<int>(Stage::kMultiprecision)];
    // The failed certificate is negative now, wherever its root was rounded to.
    const int relation = own_ ? related(query, query_) : 0;
    if (relation != 0) return relation > 0 ? Sign::kNegative : Sign::kPositive;
    const std::vector<MpFloat> c = polynomial(query);
    return c.empty() ? Sign::kZero : sign_at_now(c);
  }

  Outlook failure(const Query& query, FailureTime& time) override {
    time = {kInfinity, kInfinity, 0};
    ++counters_.by_predicate[query.predicate].failures[static_cast<int>(Stage::kMultiprecision)];
    const std::vector<MpFloat> c = polynomial(query);
    if (c.empty()) return Outlook::kIdenticallyZero;
    const std::size_t degree = c.size() - 1;
    if (degree >= counters_.polynomials_solved.size())
      counters_.polynomials_solved.resize(degree + 1);
    ++counters_.polynomials_solved[degree];
    MpFloat from = now_;
    const int relation = own_ ? related(query, query_) : 0;
    if (relation < 0) {
      if (degree == 1) return Outlook::kNever;
      // Its root at now is known: start where rounding cannot show it again.
      from = now_ + mpfr_root_doubt(c, now_);
      mpfr_nextabove(from.raw());
    } else if (relation > 0 || sign_at_now(c) == Sign::kNegative) {
      time = {now_.lower_double(), now_.upper_double(), kNow};
      return Outlook::kFailsNow;
    }
    if (degree == 0) return Outlook::kNever;
    const std::optional<MpFloat> until = horizon(query);
    std::optional<MpFloat> t;
    if (degree == 1) {
      if (c[1].sign() >= 0) return Outlook::kNever;
      t = -c[0] / c[1];
    } else {
      t = mpfr_first_sign_change(c, from, until);
    }
    if (!t || !t->is_finite() || (until && compare_values(*t, *until) > 0)) return Outlook::kNever;
    if (compare_values(*t, now_) < 0) t = now_;
    time.lo = t->lower_double();
    time.hi = t->upper_double();
    time.root = add(std::move(*t));
    return Outlook::kFails;
  }

  int compare(const Query&, FailureTime& a, const Query&, FailureTime& b) override {
    if (a.lo == kInfinity || b.lo == kInfinity) return a.lo < b.lo ? -1 : a.lo > b.lo ? 1 : 0;
    return compare_values(value(a), value(b));
  }
  int compare_with_now(const Query&, FailureTime& a) override {
    return compare_values(value(a), now_);
  }
  int compare(const Query&, FailureTime& a, const Rational& t) override {
    if (a.lo == kInfinity) return 1;
    return compare_values(value(a), MpFloat(bits_, t));
  }
  void release(FailureTime& time) override {
    if (time.root != 0 && (time.root & kNow) == 0) free_.push_back(time.root);
    time.root = 0;
  }

  std::optional<Rational> rational_between(const Query*, FailureTime* time) override {
    const Rational now = to_rational(now_);
    if (time == nullptr || time->lo == kInfinity) return now + Rational(1);
    const Rational next = to_rational(value(*time));
    if (!(now < next)) return std::nullopt;
    return (now + next) / Rational(2);
  }

  std::size_t bytes() const override {
    const std::size_t each = sizeof(MpFloat) + static_cast<std::size_t>(bits_ + 63) / 64 * 8;
    return (coefficients_.size() + times_.size() + until_.size()) * each;
  }

 private:
  // In FailureTime::root: fails at the instant it was created.
  static constexpr std::uint32_t kNow = 0x80000000u;

  static int compare_values(const MpFloat& a, const MpFloat& b) { return kinex::compare(a, b); }

  static Rational to_rational(const MpFloat& x) {
    Rational q;
    if (x.is_finite()) mpfr_get_q(q.edit(), x.raw());
    return q;
  }

  const MpFloat& value(const FailureTime& time) const {
    return (time.root & kNow) != 0 || time.root == 0 ? now_ : times_[time.root - 1];
  }

  std::uint32_t add(MpFloat t) {
    if (free_.empty()) {
      times_.push_back(std::move(t));
      return static_cast<std::uint32_t>(times_.size());
    }
    const std::uint32_t handle = free_.back();
    free_.pop_back();
    times_[handle - 1] = std::move(t);
    return handle;
  }

  void widen(int degree) {
    const std::size_t objects = coefficients_.size() / stride_;
    const std::size_t old_powers = static_cast<std::size_t>(degree_) + 1;
    const std::size_t powers = static_cast<std::size_t>(degree) + 1;
    std::vector<MpFloat> wider(objects * dimension_ * powers, MpFloat(bits_));
    for (std::size_t row = 0; row < objects * dimension_; ++row) {
      for (std::size_t k = 0; k < old_powers; ++k) {
        wider[row * powers + k] = coefficients_[row * old_powers + k];
      }
    }
    coefficients_ = std::move(wider);
    degree_ = degree;
    stride_ = dimension_ * powers;
  }

  // Exact leading zeros are stripped; empty for the zero polynomial.
  std::vector<MpFloat> polynomial(const Query& query) const {
    const Predicate& predicate = *predicates_[query.predicate];
    std::array<MotionView<MpFloat>, kMaxViews> points;
    for (std::size_t i = 0; i < query.arity; ++i)
      points[i] = &coefficients_[query.ids[i] * stride_];
    points[query.arity] = &one_;
    std::vector<MpFloat> c(static_cast<std::size_t>(predicate.degree(degree_)) + 1, MpFloat(bits_));
    predicate.multiprecision(degree_, points.data(), c.data());
    while (!c.empty() && c.back().sign() == 0) c.pop_back();
    return c;
  }

  Sign sign_at_now(const std::vector<MpFloat>& c) const {
    const int s = mpfr_value(c, now_).sign();
    return to_sign(s != 0 ? s : mpfr_slope(c, now_).sign());
  }

  std::optional<MpFloat> horizon(const Query& query) const {
    std::optional<MpFloat> b = end_;
    for (std::size_t i = 0; i < query.arity; ++i) {
      const auto& u = until_[query.ids[i]];
      if (u && (!b || compare_values(*u, *b) < 0)) b = u;
    }
    return b;
  }

  long bits_;
  int degree_;
  std::size_t dimension_;
  std::size_t stride_;
  std::vector<MpFloat> coefficients_;
  std::vector<std::optional<MpFloat>> until_;
  std::optional<MpFloat> end_;
  MpFloat one_;
  MpFloat now_;
  bool own_ = false;  // now is a failure time found for query_
  Query query_;
  MpFloat home_;  // where leave() goes back to
  bool own_at_home_ = false;
  Query query_at_home_;
  std::vector<MpFloat> times_;
  std::vector<std::uint32_t> free_;
};

}  // namespace

std::unique_ptr<Arithmetic> make_mpfr_arithmetic(const Scene& scene, const NumberNeeds& needs,
                                                 long bits) {
  return std::make_unique<MpfrArithmetic>(scene, needs, bits);
}

}  // namespace kinex
