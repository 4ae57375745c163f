// SPDX-License-Identifier: GPL-3.0-or-later
// line_height_order(l, p, m, q) = h(m, q)^2 - h(l, p)^2 and
// line_distance_order(l, p, m, q) = h(m, q)^2 (1 + a_l^2) - h(l, p)^2 (1 + a_m^2), where
// h(l, p) = y_p - a_l x_p - b_l.
// Degrees 4 and 6 in the coordinates, 4d and 6d in t. Identities: line_distance_order.h.
#include <array>
#include <string_view>

#include "core/arithmetic/predicate_formula.h"
#include "predicates/points/line_distance_order.h"

namespace kinex {
namespace {

template <LineMeasure kMeasure>
struct LineDistanceOrder {
  static constexpr bool kVertical = kMeasure == LineMeasure::kHeight;
  static constexpr int kArity = 4;
  static constexpr int kDegree = kVertical ? 4 : 6;
  static constexpr int kAlternating = 0;
  static constexpr bool kAlternatesInHalves = true;
  static constexpr int kReference = 0;
  static constexpr bool kOnlyToReference = false;
  static constexpr bool kHasUnit = true;
  static constexpr std::array<ArgumentRole, 4> kRoles{
      {{"nearer line"}, {"nearer point"}, {"farther line"}, {"farther point"}}};

  std::string_view name() const { return kVertical ? "order_line_height" : "order_line_distance"; }
  int dimension() const { return 2; }
  int first_by_value() const { return 0; }
  ClaimForm form() const {
    return {ClaimFigure::kNone,
            1,
            kRoles,
            kVertical
                ? "{1} is no farther above or below the line {0} than {3} is above or below {2}"
                : "{1} is no farther from the line {0} than {3} is from {2}",
            {}};
  }

  template <class Points>
  auto value(const Points& p) const {
    const auto near = height(p, 0), far = height(p, 2);
    if constexpr (kVertical) {
      return (far - near) * (far + near);
    } else {
      return (far * far) * stretch(p, 0) - (near * near) * stretch(p, 2);
    }
  }

 private:
  // Of a point above a line: the arguments at place i and behind.
  template <class Points>
  static auto height(const Points& p, int i) {
    const auto slope = p(i, 0);
    return wide_product((slope - slope) - slope, p(i + 1, 0)) +
           wide_product(p(i + 1, 1) - p(i, 1), p.unit());
  }
  // The square of a height over that of a distance.
  template <class Points>
  static auto stretch(const Points& p, int i) {
    return wide_product(p(i, 0), p(i, 0)) + wide_product(p.unit(), p.unit());
  }
};

}  // namespace

std::shared_ptr<const Predicate> make_line_distance_order(LineMeasure measure) {
  if (measure == LineMeasure::kHeight) {
    return std::make_shared<FormulaPredicate<LineDistanceOrder<LineMeasure::kHeight>>>();
  }
  return std::make_shared<FormulaPredicate<LineDistanceOrder<LineMeasure::kDistance>>>();
}

}  // namespace kinex
