// SPDX-License-Identifier: GPL-3.0-or-later
// The orders of two strips (a, b, c) by width, and of two rectangles (a, b, r, c, l) by area and by
// perimeter: N' D - N D', where D = |u|^2 and N is H^2, H W or (H + W)^2
// (predicates/points/edge_predicates.h).
// Degree 6 in the coordinates, 6d in t.
#include <array>

#include "core/arithmetic/predicate_formula.h"
#include "predicates/points/edge_predicates.h"

namespace kinex {
namespace {

enum class Flush { kStrip, kArea, kPerimeter };

constexpr std::array<ArgumentRole, 6> kStripRoles{{{"narrower strip, from"},
                                                   {"narrower strip, to"},
                                                   {"narrower strip, opposite"},
                                                   {"wider strip, from"},
                                                   {"wider strip, to"},
                                                   {"wider strip, opposite"}}};
constexpr std::array<ArgumentRole, 10> kRectangleRoles{{{"smaller rectangle, from"},
                                                        {"smaller rectangle, to"},
                                                        {"smaller rectangle, right"},
                                                        {"smaller rectangle, opposite"},
                                                        {"smaller rectangle, left"},
                                                        {"larger rectangle, from"},
                                                        {"larger rectangle, to"},
                                                        {"larger rectangle, right"},
                                                        {"larger rectangle, opposite"},
                                                        {"larger rectangle, left"}}};

template <Flush kFlush>
struct FlushOrder2 {
  static constexpr bool kIsStrip = kFlush == Flush::kStrip;
  static constexpr int kPoints = kIsStrip ? 3 : 5;    // of one figure
  static constexpr int kOpposite = kIsStrip ? 2 : 3;  // the place of c among them
  static constexpr int kArity = 2 * kPoints;
  static constexpr int kDegree = 6;
  static constexpr int kAlternating = 0;
  static constexpr bool kAlternatesInHalves = true;
  static constexpr int kReference = 0;
  static constexpr bool kOnlyToReference = false;

  std::string_view name() const {
    if constexpr (kIsStrip) return "order_strip";
    return kFlush == Flush::kPerimeter ? "order_rectangle_perimeter" : "order_rectangle_area";
  }
  int dimension() const { return 2; }
  ClaimForm form() const {
    if constexpr (kIsStrip) {
      return {ClaimFigure::kStrips,
              1,
              kStripRoles,
              "{2} is no farther from the line through {0} and {1} than {5} is from that through "
              "{3} and {4}",
              {}};
    } else {
      return {ClaimFigure::kRectangles, 1, kRectangleRoles,
              kFlush == Flush::kPerimeter
                  ? "the rectangle on {0} and {1} that touches {2}, {3} and {4} has no larger "
                    "perimeter than that on {5} and {6} that touches {7}, {8} and {9}"
                  : "the rectangle on {0} and {1} that touches {2}, {3} and {4} has no larger "
                    "area than that on {5} and {6} that touches {7}, {8} and {9}",
              {}};
    }
  }

  template <class Points>
  auto value(const Points& p) const {
    return numerator(p, kPoints) * denominator(p, 0) - numerator(p, 0) * denominator(p, kPoints);
  }

 private:
  // Of the figure whose points begin at place a.
  template <class Points>
  static auto numerator(const Points& p, int a) {
    const auto x = p(a + 1, 0) - p(a, 0);
    const auto y = p(a + 1, 1) - p(a, 1);
    const int c = a + kOpposite;
    const auto height = wide_product(x, p(c, 1) - p(a, 1)) - wide_product(y, p(c, 0) - p(a, 0));
    if constexpr (kIsStrip) {
      return height * height;
    } else {
      const auto width = wide_product(x, p(a + 2, 0) - p(a + 4, 0)) +
                         wide_product(y, p(a + 2, 1) - p(a + 4, 1));
      if constexpr (kFlush == Flush::kArea) {
        return height * width;
      } else {
        const auto half = height + width;
        return half * half;
      }
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

std::shared_ptr<const Predicate> make_strip_order_2() {
  return std::make_shared<FormulaPredicate<FlushOrder2<Flush::kStrip>>>();
}

std::shared_ptr<const Predicate> make_rectangle_area_order_2() {
  return std::make_shared<FormulaPredicate<FlushOrder2<Flush::kArea>>>();
}

std::shared_ptr<const Predicate> make_rectangle_perimeter_order_2() {
  return std::make_shared<FormulaPredicate<FlushOrder2<Flush::kPerimeter>>>();
}

}  // namespace kinex
