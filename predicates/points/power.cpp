// SPDX-License-Identifier: GPL-3.0-or-later
// power_2(a, b, c, e), power_3(a, b, c, d, e): the lifted determinant of points with weights: positive iff
// the last point, lifted to the sum of the squares of its coordinates - w, lies strictly below the plane of
// the others, lifted and taken upright. w is the weight, or the square of the radius. Identities:
// predicates/points/power_predicates.h.
#include <array>
#include <string_view>

#include "core/arithmetic/predicate_formula.h"
#include "core/arithmetic/touch.h"
#include "predicates/points/lifted_determinant.h"
#include "predicates/points/power_degree.h"
#include "predicates/points/power_predicates.h"

namespace kinex {
namespace {

constexpr std::array<ArgumentRole, 4> kPlaneRoles{
    {{"plane, first"}, {"plane, second"}, {"plane, third"}, {"not below"}}};
constexpr std::array<ArgumentRole, 5> kSpaceRoles{
    {{"plane, first"}, {"plane, second"}, {"plane, third"}, {"plane, fourth"}, {"not below"}}};

// What both kinds of weights have in common. kAxes: 2 or 3; the weight is the axis behind them.
template <int kAxes>
struct Power {
  static constexpr int kArity = kAxes + 2, kDegree = kAxes + 2, kAlternating = kAxes + 2;
  static constexpr int kReference = kAxes + 1;
  static constexpr bool kOnlyToReference = true;
  int dimension() const { return kAxes + 1; }
  int first_by_value() const { return kAxes; }
  ClaimForm form() const {
    if constexpr (kAxes == 2) {
      return {ClaimFigure::kCircle,
              1,
              kPlaneRoles,
              "{3}, lifted by its weight, is not below the plane of {0}, {1} and {2}, which are "
              "clockwise",
              {}};
    } else {
      return {ClaimFigure::kCircle,
              1,
              kSpaceRoles,
              "{4}, lifted by its weight, is not below the plane of {0}, {1}, {2} and {3}, whose "
              "orientation is negative",
              {}};
    }
  }
};

// `above(i)`: the weight of the last point less that of point i.
template <int kAxes, class Points, class Above>
auto power(const Points& p, const Above& above) {
  if constexpr (kAxes == 2) {
    return lifted_determinant_2(
        p, [&above](const auto& x, const auto& y, int i) { return x * x + y * y + above(i); });
  } else {
    return lifted_determinant_3(p, [&above](const auto& x, const auto& y, const auto& z, int i) {
      return x * x + y * y + z * z + above(i);
    });
  }
}

// Terms of degree kAxes + 2 and kAxes + 1 in coordinates and weights; the latter are times the unit.
template <int kAxes>
struct WeightPower : Power<kAxes> {
  static constexpr bool kHasUnit = true;
  int square_axis() const { return kAxes; }
  std::string_view name() const { return kAxes == 2 ? "power_2" : "power_3"; }

  template <class Points>
  auto value(const Points& p) const {
    return power<kAxes>(p, [&p](int i) { return (p(kAxes + 1, kAxes) - p(i, kAxes)) * p.unit(); });
  }
};

template <int kAxes>
struct RadiusPower : Power<kAxes> {
  std::string_view name() const { return kAxes == 2 ? "disc_power_2" : "disc_power_3"; }

  template <class Points>
  auto value(const Points& p) const {
    const auto r = p(kAxes + 1, kAxes);
    const auto own = r * r;
    return power<kAxes>(p, [&p, &own](int i) {
      const auto radius = p(i, kAxes);
      return own - radius * radius;
    });
  }
};

template <int kAxes>
class WeightPowerPredicate : public FormulaPredicate<WeightPower<kAxes>> {
 public:
  void ball(int d, const MotionView<Ball>* points, double shift, Ball* out) const override {
    FormulaPredicate<WeightPower<kAxes>>::ball(d, points, shift, out);
    clear_beyond_degree(d, points, {.arity = kAxes + 2, .axes = kAxes, .factors = kAxes}, out);
  }
};

template <int kAxes>
class TouchingWeightPower final : public WeightPowerPredicate<kAxes>, public FailsAtTouch {};
template <int kAxes>
class TouchingRadiusPower final : public FormulaPredicate<RadiusPower<kAxes>>,
                                  public FailsAtTouch {};

}  // namespace

std::shared_ptr<const Predicate> make_power_2() {
  return std::make_shared<WeightPowerPredicate<2>>();
}
std::shared_ptr<const Predicate> make_power_3() {
  return std::make_shared<WeightPowerPredicate<3>>();
}
std::shared_ptr<const Predicate> make_disc_power_2() {
  return std::make_shared<FormulaPredicate<RadiusPower<2>>>();
}
std::shared_ptr<const Predicate> make_disc_power_3() {
  return std::make_shared<FormulaPredicate<RadiusPower<3>>>();
}
std::shared_ptr<const Predicate> make_power_2_touch() {
  return std::make_shared<TouchingWeightPower<2>>();
}
std::shared_ptr<const Predicate> make_power_3_touch() {
  return std::make_shared<TouchingWeightPower<3>>();
}
std::shared_ptr<const Predicate> make_disc_power_2_touch() {
  return std::make_shared<TouchingRadiusPower<2>>();
}
std::shared_ptr<const Predicate> make_disc_power_3_touch() {
  return std::make_shared<TouchingRadiusPower<3>>();
}

}  // namespace kinex
