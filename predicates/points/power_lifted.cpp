// SPDX-License-Identifier: GPL-3.0-or-later
// power_lifted(a, b, c, e): projected_determinant (lifted_determinant.h) with twice the squares of lengths, less
// twice the weights, for heights. The weight is the axis behind those of space, or the square of the radius there.
// Identities: power_predicates.h.
#include <array>
#include <stdexcept>
#include <string_view>

#include "core/arithmetic/predicate_formula.h"
#include "core/arithmetic/touch.h"
#include "predicates/points/lifted_determinant.h"
#include "predicates/points/power_degree.h"
#include "predicates/points/power_predicates.h"

namespace kinex {
namespace {

// What both kinds of weights have in common.
struct ProjectedPower {
  static constexpr int kArity = 4, kDegree = 4, kAlternating = 4, kReference = 3;
  static constexpr bool kOnlyToReference = true;
  static constexpr std::array<ArgumentRole, 4> kRoles{
      {{"plane, first"}, {"plane, second"}, {"plane, third"}, {"not below"}}};
  static constexpr int kWeight = 3;  // the axis

  int u = 0, v = 1;  // the axes

  int dimension() const { return 4; }
  int first_by_value() const { return kWeight; }
  // No figure of the plane shows it.
  ClaimForm form() const {
    return {ClaimFigure::kNone,
            1,
            kRoles,
            "{3}, lifted by its weight, is not below the plane of {0}, {1} and {2}, which are "
            "clockwise in "
            "projection on two axes",
            {}};
  }
};

struct ProjectedWeightPower : ProjectedPower {
  static constexpr bool kHasUnit = true;
  int square_axis() const { return kWeight; }
  std::string_view name() const { return v == 1 ? "power_xy" : u == 0 ? "power_xz" : "power_yz"; }

  template <class Points>
  auto value(const Points& p) const {
    return projected_determinant(p, u, v, [&p](const auto& squares, int i) {
      const auto above = (p(3, kWeight) - p(i, kWeight)) * p.unit();
      return squares + above + above;
    });
  }
};

struct ProjectedRadiusPower : ProjectedPower {
  std::string_view name() const {
    return v == 1 ? "disc_power_xy" : u == 0 ? "disc_power_xz" : "disc_power_yz";
  }

  template <class Points>
  auto value(const Points& p) const {
    const auto r = p(3, kWeight);
    const auto own = r * r;
    return projected_determinant(p, u, v, [&p, &own](const auto& squares, int i) {
      const auto radius = p(i, kWeight);
      const auto above = own - radius * radius;
      return squares + above + above;
    });
  }
};

class ProjectedWeightPredicate : public FormulaPredicate<ProjectedWeightPower> {
 public:
  using FormulaPredicate<ProjectedWeightPower>::FormulaPredicate;
  void ball(int d, const MotionView<Ball>* points, double shift, Ball* out) const override {
    FormulaPredicate<ProjectedWeightPower>::ball(d, points, shift, out);
    clear_beyond_degree(d, points, {.arity = 4, .axes = 3, .factors = 2}, out);
  }
};

class TouchingProjectedWeight final : public ProjectedWeightPredicate, public FailsAtTouch {
 public:
  using ProjectedWeightPredicate::ProjectedWeightPredicate;
};
class TouchingProjectedRadius final : public FormulaPredicate<ProjectedRadiusPower>,
                                      public FailsAtTouch {
 public:
  using FormulaPredicate<ProjectedRadiusPower>::FormulaPredicate;
};

template <class Formula>
Formula on_axes(int first, int second) {
  if (first < 0 || second <= first || second > 2) {
    throw std::invalid_argument("a projection needs two axes of space");
  }
  Formula formula;
  formula.u = first;
  formula.v = second;
  return formula;
}

}  // namespace

std::shared_ptr<const Predicate> make_power_lifted(int first, int second) {
  return std::make_shared<ProjectedWeightPredicate>(on_axes<ProjectedWeightPower>(first, second));
}
std::shared_ptr<const Predicate> make_disc_power_lifted(int first, int second) {
  return std::make_shared<FormulaPredicate<ProjectedRadiusPower>>(
      on_axes<ProjectedRadiusPower>(first, second));
}
std::shared_ptr<const Predicate> make_power_lifted_touch(int first, int second) {
  return std::make_shared<TouchingProjectedWeight>(on_axes<ProjectedWeightPower>(first, second));
}
std::shared_ptr<const Predicate> make_disc_power_lifted_touch(int first, int second) {
  return std::make_shared<TouchingProjectedRadius>(on_axes<ProjectedRadiusPower>(first, second));
}

}  // namespace kinex
