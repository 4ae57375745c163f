// SPDX-License-Identifier: GPL-3.0-or-later
// power_2(a, b, c, e): the determinant with rows (x, y, x^2 + y^2 - w + w_e) of a - e, b - e, c - e:
// positive iff e, lifted to the height x^2 + y^2 - w, lies strictly below the plane through a, b, c,
// lifted and taken counter-clockwise. w is the weight, or the square of the radius. Identities:
// predicates/points/power_predicates.h.
#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "core/arithmetic/predicate_formula.h"
#include "predicates/points/power_predicates.h"

namespace kinex {
namespace {

constexpr std::array<ArgumentRole, 4> kPowerRoles{
    {{"plane, first"}, {"plane, second"}, {"plane, third"}, {"not below"}}};
constexpr std::string_view kPowerClaim =
    "{3}, lifted by its weight, is not below the plane of {0}, {1} and {2}, which are clockwise";

// Of differences from e in the two axes and the heights of a, b, c over that of e.
template <class Points, class Height>
auto lifted_determinant(const Points& p, const Height& height) {
  const auto ax = p(0, 0) - p(3, 0), ay = p(0, 1) - p(3, 1);
  const auto bx = p(1, 0) - p(3, 0), by = p(1, 1) - p(3, 1);
  const auto cx = p(2, 0) - p(3, 0), cy = p(2, 1) - p(3, 1);
  return wide_product(height(ax, ay, 0), bx * cy - by * cx) +
         wide_product(height(bx, by, 1), cx * ay - cy * ax) +
         wide_product(height(cx, cy, 2), ax * by - ay * bx);
}

// Terms of degree 4 and 3 in coordinates and weights; those of degree 3 are times the unit.
struct WeightPower {
  static constexpr int kArity = 4, kDegree = 4, kAlternating = 4, kReference = 3;
  static constexpr bool kOnlyToReference = true, kHasUnit = true;
  std::string_view name() const { return "power_2"; }
  int dimension() const { return 3; }
  int first_by_value() const { return 2; }
  ClaimForm form() const { return {ClaimFigure::kNone, 1, kPowerRoles, kPowerClaim, {}}; }

  template <class Points>
  auto value(const Points& p) const {
    return lifted_determinant(p, [&p](const auto& x, const auto& y, int i) {
      return x * x + y * y + (p(3, 2) - p(i, 2)) * p.unit();
    });
  }
};

struct RadiusPower {
  static constexpr int kArity = 4, kDegree = 4, kAlternating = 4, kReference = 3;
  static constexpr bool kOnlyToReference = true;
  std::string_view name() const { return "disc_power_2"; }
  int dimension() const { return 3; }
  int first_by_value() const { return 2; }
  ClaimForm form() const { return {ClaimFigure::kNone, 1, kPowerRoles, kPowerClaim, {}}; }

  template <class Points>
  auto value(const Points& p) const {
    const auto r = p(3, 2);
    const auto own = r * r;
    return lifted_determinant(p, [&p, &own](const auto& x, const auto& y, int i) {
      const auto radius = p(i, 2);
      return x * x + y * y + own - radius * radius;
    });
  }
};

// The largest power of t, at most d, that an argument has on the axes in [first, last).
int degree_of(const MotionView<Ball>* points, int d, int first, int last) {
  for (int k = d; k > 0; --k) {
    for (int i = 0; i < 4; ++i) {
      for (int axis = first; axis < last; ++axis) {
        const Ball& c = points[i][axis * (d + 1) + k];
        if (c.value != 0 || c.error != 0) return k;
      }
    }
  }
  return 0;
}

// A weight is no length: it may be large while distances are small, and of higher degree. No power
// of the reach bounds the errors, and coefficients beyond the true degree are exact zeros.
class WeightPowerPredicate final : public FormulaPredicate<WeightPower> {
 public:
  double reach_error(int) const override { return std::numeric_limits<double>::infinity(); }
  void ball(int d, const MotionView<Ball>* points, double shift, Ball* out) const override {
    FormulaPredicate::ball(d, points, shift, out);
    const int place = degree_of(points, d, 0, 2), weight = degree_of(points, d, 2, 3);
    for (int k = 2 * place + std::max(2 * place, weight) + 1; k <= degree(d); ++k) out[k] = Ball{};
  }
};

}  // namespace

std::shared_ptr<const Predicate> make_power_2() { return std::make_shared<WeightPowerPredicate>(); }
std::shared_ptr<const Predicate> make_disc_power_2() {
  return std::make_shared<FormulaPredicate<RadiusPower>>();
}

}  // namespace kinex
