// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/arithmetic/gsl_arithmetic.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_poly.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <mutex>

namespace kinex {
namespace {

constexpr double kOne = 1;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
// A computed root counts as real if its imaginary part is at most this fraction of its real part.
// GSL's roots are eigenvalues: those of a double root come out about 2^-26 apart, on the real axis
// or off it, and so may count or not. For true double roots that changes no sign.
constexpr double kImaginary = 1e-9;
// A root of the polynomial that has just failed counts as the known root at now if it is at most
// this fraction of now later (64 units in the last place).
constexpr double kSameRoot = 0x1p-46;

// gsl_poly_complex_solve balances the companion matrix in a loop that never ends once a norm
// overflows (GSL 2.7). Balancing shrinks norms, so entries in this range are safe at any degree
// that matters.
constexpr double kLargestRatio = 1e150;

struct FreeWorkspace {
  void operator()(gsl_poly_complex_workspace* w) const { gsl_poly_complex_workspace_free(w); }
};
using Workspace = std::unique_ptr<gsl_poly_complex_workspace, FreeWorkspace>;

void turn_off_error_handler() {
  static std::once_flag once;
  std::call_once(once, [] { gsl_set_error_handler_off(); });
}

double horner(const std::vector<double>& c, double t) {
  double v = 0;
  for (std::size_t i = c.size(); i-- > 0;) v = v * t + c[i];
  return v;
}

class GslArithmetic final : public Arithmetic {
 public:
  GslArithmetic(const Scene& scene, const NumberNeeds& needs)
      : Arithmetic(needs),
        degree_(std::max(1, needs.degree)),
        axes_(static_cast<std::size_t>(std::max(1, needs.axes))),
        coefficients_(scene.objects.size() * stride(), 0.0),
        until_(scene.objects.size(), kInfinity),
        end_(scene.end ? scene.end->to_double() : kInfinity),
        now_(scene.start.to_double()) {
    turn_off_error_handler();
  }

  std::string name() const override { return "gsl"; }
  bool is_exact() const override { return false; }

  void set_motion(ObjectId object, const Trajectory& trajectory,
                  const std::optional<Rational>& until) override {
    const int degree = trajectory.degree_of_axes(0, static_cast<int>(axes_));
    if (degree > degree_) widen(degree);
    if (object >= until_.size()) {
      until_.resize(object + std::size_t{1}, kInfinity);
      coefficients_.resize(until_.size() * stride(), 0.0);
    }
    double* out = &coefficients_[object * stride()];
    std::fill(out, out + stride(), 0.0);
    for (std::size_t a = 0; a < std::min(axes_, trajectory.coordinates.size()); ++a) {
      const auto& axis = trajectory.coordinates[a];
      for (std::size_t k = 0; k < std::min(axis.size(), powers()); ++k) {
        out[a * powers() + k] = axis[k].to_double();
      }
    }
    until_[object] = until ? until->to_double() : kInfinity;
  }

  void set_now(const Rational& t) override {
    now_ = t.to_double();
    failed_ = Query();
  }
  void advance(const Query& query, FailureTime& time) override {
    now_ = std::max(now_, time.lo);
    failed_ = time.root == kBornFailing ? Query() : query;
    time.root = 0;
  }
  void visit(const Query& query, const FailureTime& time) override {
    home_ = now_;
    failed_at_home_ = failed_;
    now_ = std::max(now_, time.lo);
    failed_ = time.root == kBornFailing ? Query() : query;
  }
  void leave() override {
    now_ = home_;
    failed_ = failed_at_home_;
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
    const int relation = failed_.arity == 0 ? 0 : related(query, failed_);
    if (relation != 0) return relation > 0 ? Sign::kNegative : Sign::kPositive;
    evaluate(query);
    return sign_at_now();
  }

  Outlook failure(const Query& query, FailureTime& time) override {
    time = {kInfinity, kInfinity, 0};
    ++counters_.by_predicate[query.predicate].failures[static_cast<int>(Stage::kDouble)];
    evaluate(query);
    if (c_.empty()) return Outlook::kIdenticallyZero;
    if (c_.size() > counters_.polynomials_solved.size()) {
      counters_.polynomials_solved.resize(c_.size());
    }
    ++counters_.polynomials_solved[c_.size() - 1];
    const int relation = failed_.arity == 0 ? 0 : related(query, failed_);
    if (relation > 0 || (relation == 0 && sign_at_now() == Sign::kNegative)) {
      time = {now_, now_, relation > 0 ? 0 : kBornFailing};
      return Outlook::kFailsNow;
    }
    const double t = first_failure(relation < 0);
    if (!(t <= horizon(query) && t < kInfinity)) return Outlook::kNever;
    time = {t, t, 0};
    return Outlook::kFails;
  }

  int compare(const Query& query, FailureTime& a, const Query&, FailureTime& b) override {
    count_comparison(query, Stage::kDouble);
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
    const double end = time == nullptr || time->lo == kInfinity ? now_ + 1 : time->lo;
    const double middle = now_ + 0.5 * (end - now_);
    if (time == nullptr || time->lo == kInfinity) {
      const auto from = Rational::from_double(now_);
      return from ? std::optional<Rational>(*from + Rational(1)) : std::nullopt;
    }
    if (!(middle > now_ && middle < end)) return std::nullopt;
    return Rational::from_double(middle);
  }

  std::size_t bytes() const override {
    const std::size_t doubles = coefficients_.capacity() + until_.capacity() + c_.capacity() +
                                packed_.capacity() + roots_.capacity();
    std::size_t matrices = 0;  // of the solvers: degree squared
    for (std::size_t d = 0; d < workspaces_.size(); ++d) matrices += workspaces_[d] ? d * d : 0;
    return (doubles + matrices) * sizeof(double) + workspaces_.capacity() * sizeof(Workspace);
  }

 private:
  // Set in FailureTime::root for certificates negative when created: now is not their root.
  static constexpr std::uint32_t kBornFailing = 1;

  std::size_t powers() const { return static_cast<std::size_t>(degree_) + 1; }
  std::size_t stride() const { return axes_ * powers(); }

  void widen(int degree) {
    const std::size_t rows = until_.size() * axes_;
    const std::size_t from = powers();
    degree_ = degree;
    std::vector<double> wider(rows * powers(), 0.0);
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t k = 0; k < from; ++k)
        wider[row * powers() + k] = coefficients_[row * from + k];
    }
    coefficients_ = std::move(wider);
  }

  // c_ := the query's polynomial, leading zeros stripped.
  void evaluate(const Query& query) {
    const Predicate& predicate = *predicates_[query.predicate];
    std::array<MotionView<double>, kMaxViews> points{};
    for (std::size_t i = 0; i < query.arity; ++i) {
      points[i] = &coefficients_[query.ids[i] * stride()];
    }
    points[query.arity] = &kOne;
    c_.assign(static_cast<std::size_t>(predicate.degree(degree_)) + 1, 0.0);
    predicate.plain(degree_, points.data(), 0.0, c_.data());
    while (!c_.empty() && c_.back() == 0) c_.pop_back();
  }

  // Of the value at now; if that is zero in doubles, of the slope.
  Sign sign_at_now() const {
    double v = 0, slope = 0;
    for (std::size_t i = c_.size(); i-- > 0;) {
      slope = slope * now_ + v;
      v = v * now_ + c_[i];
    }
    if (v == 0) v = slope;
    return v > 0 ? Sign::kPositive : v < 0 ? Sign::kNegative : Sign::kZero;
  }

  double horizon(const Query& query) const {
    double b = end_;
    for (std::size_t i = 0; i < query.arity; ++i) b = std::min(b, until_[query.ids[i]]);
    return b;
  }

  // The first root after now behind which the value is negative; +infinity if there is none.
  // `now_is_root`: the polynomial is known to turn from - to + at now.
  double first_failure(bool now_is_root) {
    find_real_roots();
    const double from = now_is_root ? now_ + kSameRoot * std::fabs(now_) : now_;
    for (std::size_t i = 0; i < roots_.size(); ++i) {
      const double t = roots_[i];
      if (!(t > from)) continue;
      const double next = i + 1 < roots_.size() ? roots_[i + 1] : t + std::max(1.0, std::fabs(t));
      if (next == t) continue;  // a multiple root: the sign behind the last of them counts
      if (horner(c_, t + 0.5 * (next - t)) < 0) return t;
    }
    return kInfinity;
  }

  // roots_ := the real roots of c_, ascending; none if GSL fails or a coefficient is not finite.
  void find_real_roots() {
    roots_.clear();
    for (double v : c_) {
      if (!std::isfinite(v)) return;
    }
    const std::size_t degree = c_.empty() ? 0 : c_.size() - 1;
    double r[3] = {};
    switch (degree) {
      case 0:
        return;
      case 1:
        roots_.push_back(-c_[0] / c_[1]);
        break;
      case 2:
        roots_.assign(r, r + gsl_poly_solve_quadratic(c_[2], c_[1], c_[0], &r[0], &r[1]));
        break;
      case 3: {
        const double lead = c_[3];
        const int count =
            gsl_poly_solve_cubic(c_[2] / lead, c_[1] / lead, c_[0] / lead, &r[0], &r[1], &r[2]);
        roots_.assign(r, r + count);
        break;
      }
      default:
        solve_complex(degree);
    }
    std::erase_if(roots_, [](double t) { return !std::isfinite(t); });
    std::sort(roots_.begin(), roots_.end());
  }

  void solve_complex(std::size_t degree) {
    for (double v : c_) {
      const double ratio = std::fabs(v / c_.back());
      if (ratio != 0 && !(ratio >= 1 / kLargestRatio && ratio <= kLargestRatio)) return;
    }
    if (workspaces_.size() <= degree) workspaces_.resize(degree + 1);
    Workspace& workspace = workspaces_[degree];
    if (!workspace) workspace.reset(gsl_poly_complex_workspace_alloc(degree + 1));
    if (!workspace) return;
    packed_.assign(2 * degree, 0.0);
    if (gsl_poly_complex_solve(c_.data(), degree + 1, workspace.get(), packed_.data()) !=
        GSL_SUCCESS) {
      return;
    }
    for (std::size_t i = 0; i < degree; ++i) {
      const double re = packed_[2 * i];
      const double im = packed_[2 * i + 1];
      if (std::fabs(im) <= kImaginary * std::fabs(re)) roots_.push_back(re);
    }
  }

  int degree_;
  std::size_t axes_;
  std::vector<double>
      coefficients_;           // of t^k on axis a of object i at [(i * axes + a) * powers + k]
  std::vector<double> until_;  // per object
  double end_;
  double now_;
  Query failed_;     // now is a failure time found for it; arity 0: none
  double home_ = 0;  // where leave() goes back to
  Query failed_at_home_;
  std::vector<double> c_, packed_, roots_;
  std::vector<Workspace> workspaces_;  // by degree
};

}  // namespace

std::unique_ptr<Arithmetic> make_gsl_arithmetic(const Scene& scene,
                                                  const NumberNeeds& needs) {
  return std::make_unique<GslArithmetic>(scene, needs);
}

}  // namespace kinex
