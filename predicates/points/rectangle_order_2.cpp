// SPDX-License-Identifier: GPL-3.0-or-later
// The orders of two rectangles (a, b, r, c, l) by area and by perimeter: N' D - N D', where
// D = |u|^2 and N is H W, or (H + W)^2 (predicates/points/edge_predicates.h).
// Degree 6 in the coordinates, 6d in t.
#include <array>

#include "core/arithmetic/predicate_formula.h"
#include "predicates/points/edge_predicates.h"

namespace kinex {
namespace {

template <bool kPerimeter>
struct RectangleOrder2 {
  static constexpr int kArity = 10;
  static constexpr int kDegree = 6;
  static constexpr int kAlternating = 0;
  static constexpr bool kAlternatesInHalves = true;
  static constexpr int kReference = 0;
  static constexpr bool kOnlyToReference = false;
  static constexpr std::array<ArgumentRole, 10> kRoles{{{"smaller rectangle, from"},
                                                        {"smaller rectangle, to"},
                                                        {"smaller rectangle, right"},
                                                        {"smaller rectangle, opposite"},
                                                        {"smaller rectangle, left"},
                                                        {"larger rectangle, from"},
                                                        {"larger rectangle, to"},
                                                        {"larger rectangle, right"},
                                                        {"larger rectangle, opposite"},
                                                        {"larger rectangle, left"}}};

  std::string_view name() const {
    return kPerimeter ? "order_rectangle_perimeter" : "order_rectangle_area";
  }
  int dimension() const { return 2; }
  ClaimForm form() const {
    return {ClaimFigure::kNone, 1, kRoles,
            kPerimeter ? "the rectangle on {0} and {1} that touches {2}, {3} and {4} has no larger "
                         "perimeter than that on {5} and {6} that touches {7}, {8} and {9}"
                       : "the rectangle on {0} and {1} that touches {2}, {3} and {4} has no larger "
                         "area than that on {5} and {6} that touches {7}, {8} and {9}",
            {}};
  }

  template <class Points>
  auto value(const Points& p) const {
    return numerator(p, 5) * denominator(p, 0) - numerator(p, 0) * denominator(p, 5);
  }

 private:
  template <class Points>
  static auto numerator(const Points& p, int a) {
    const auto x = p(a + 1, 0) - p(a, 0);
    const auto y = p(a + 1, 1) - p(a, 1);
    const auto height =
        wide_product(x, p(a + 3, 1) - p(a, 1)) - wide_product(y, p(a + 3, 0) - p(a, 0));
    const auto width = wide_product(x, p(a + 2, 0) - p(a + 4, 0)) +
                       wide_product(y, p(a + 2, 1) - p(a + 4, 1));
    if constexpr (kPerimeter) {
      const auto half = height + width;
      return half * half;
    } else {
      return height * width;
    }
  }
  template <class Points>
  static auto denominator(const Points& p, int a) {
    const auto x = p(a + 1, 0) - p(a, 0);
    const auto y = p(a + 1, 1) - p(a, 1);
    return wide_product(x, x) + wide_product(y, y);
  }
};

}  // namespace

std::shared_ptr<const Predicate> make_rectangle_area_order_2() {
  return std::make_shared<FormulaPredicate<RectangleOrder2<false>>>();
}

std::shared_ptr<const Predicate> make_rectangle_perimeter_order_2() {
  return std::make_shared<FormulaPredicate<RectangleOrder2<true>>>();
}

}  // namespace kinex
