// SPDX-License-Identifier: GPL-3.0-or-later
// Predicates more general than those of kinex's structures: eight arguments, degree 6, weights,
// constants, coordinates by value; and the same values by a second formula, on rational positions.
#ifndef KINEX_TESTS_CORE_ARITHMETIC_GENERAL_PREDICATES_H
#define KINEX_TESTS_CORE_ARITHMETIC_GENERAL_PREDICATES_H

#include <array>
#include <functional>
#include <string_view>
#include <vector>

#include "tests/core/arithmetic/certificate_fixture.h"

namespace kinex::test {

template <class Points>
auto span_of(const Points& p, int from, int to, int axis) {
  return p(to, axis) - p(from, axis);
}

// (b - a) x (d - c) times (f - e).(h - g): eight arguments, degree 4.
struct CrossTimesDot {
  static constexpr int kArity = 8, kDegree = 4, kAlternating = 2, kReference = 0;
  static constexpr bool kOnlyToReference = false;
  std::string_view name() const { return "cross_times_dot"; }
  int dimension() const { return 2; }
  template <class Points>
  auto value(const Points& p) const {
    const auto d = [&p](int from, int to, int axis) { return span_of(p, from, to, axis); };
    return wide_product(d(0, 1, 0) * d(2, 3, 1) - d(0, 1, 1) * d(2, 3, 0),
                        d(4, 5, 0) * d(6, 7, 0) + d(4, 5, 1) * d(6, 7, 1));
  }
};

// Strips A = (a, b, c) and B: through a and b, and the parallel through c. A is narrower than B:
// degree 6. Exchanging A and B negates.
struct StripOrder {
  static constexpr int kArity = 6, kDegree = 6, kAlternating = 0, kReference = 0;
  static constexpr bool kOnlyToReference = false;
  std::string_view name() const { return "strip_order"; }
  int dimension() const { return 2; }
  template <class Points>
  auto value(const Points& p) const {
    const auto area = [&p](int i) {
      const auto cross = span_of(p, i, i + 1, 0) * span_of(p, i, i + 2, 1) -
                         span_of(p, i, i + 1, 1) * span_of(p, i, i + 2, 0);
      return wide_product(cross, cross);
    };
    const auto length = [&p](int i) {
      return widen(span_of(p, i, i + 1, 0) * span_of(p, i, i + 1, 0) +
                   span_of(p, i, i + 1, 1) * span_of(p, i, i + 1, 1));
    };
    return area(3) * length(0) - area(0) * length(3);
  }
};

// in_circle_2 with weights (axis 2): the lifted heights are x^2 + y^2 - w. Terms of degree 4 and 3.
struct Power {
  static constexpr int kArity = 4, kDegree = 4, kAlternating = 4, kReference = 3;
  static constexpr bool kOnlyToReference = true, kHasUnit = true;
  std::string_view name() const { return "power"; }
  int dimension() const { return 3; }
  int first_by_value() const { return 2; }
  template <class Points>
  auto value(const Points& p) const {
    const auto side = [&p](int i, int axis) { return p(i, axis) - p(3, axis); };
    const auto lift = [&](int i) {
      return side(i, 0) * side(i, 0) + side(i, 1) * side(i, 1) + (p(3, 2) - p(i, 2)) * p.unit();
    };
    const auto cross = [&](int i, int j) {
      return side(i, 0) * side(j, 1) - side(i, 1) * side(j, 0);
    };
    return wide_product(lift(0), cross(1, 2)) + wide_product(lift(1), cross(2, 0)) +
           wide_product(lift(2), cross(0, 1));
  }
};

// 25 - |b - a|^2: two points are nearer than 5. Terms of degree 0 and 2.
struct WithinFive {
  static constexpr int kArity = 2, kDegree = 2, kAlternating = 0, kReference = 0;
  static constexpr bool kOnlyToReference = true, kHasUnit = true;
  std::string_view name() const { return "within_five"; }
  int dimension() const { return 2; }
  template <class Points>
  auto value(const Points& p) const {
    const auto x = span_of(p, 0, 1, 0), y = span_of(p, 0, 1, 1);
    const auto back_x = span_of(p, 1, 0, 0), back_y = span_of(p, 1, 0, 1);
    const auto five = scaled(p.unit(), FormulaConstant(Integer(5)));
    return wide_product(x, back_x) + wide_product(y, back_y) + wide_product(five, five);
  }
};

// x_a y_b - y_a x_b + x_a + 3: not even invariant under translation. Terms of degree 0, 1 and 2.
struct Moment {
  static constexpr int kArity = 2, kDegree = 2, kAlternating = 0, kReference = 0;
  static constexpr bool kOnlyToReference = false, kHasUnit = true;
  std::string_view name() const { return "moment"; }
  int dimension() const { return 2; }
  int first_by_value() const { return 0; }
  template <class Points>
  auto value(const Points& p) const {
    const auto three = scaled(p.unit(), FormulaConstant(Integer(3)));
    return wide_product(p(0, 0), p(1, 1)) - wide_product(p(0, 1), p(1, 0)) +
           wide_product(p(0, 0), p.unit()) + wide_product(three, p.unit());
  }
};

// Two weights: -1 .. in t nothing moves. Degree 1 in t, 2 in coordinates and unit.
struct WeightedOrder {
  static constexpr int kArity = 2, kDegree = 1, kAlternating = 2, kReference = 0, kHomogeneity = 2;
  static constexpr bool kOnlyToReference = true, kHasUnit = true;
  std::string_view name() const { return "weighted_order"; }
  int dimension() const { return 3; }
  int first_by_value() const { return 2; }
  template <class Points>
  auto value(const Points& p) const {
    return wide_product(p(1, 0) - p(0, 0), p.unit()) + wide_product(p(1, 2) - p(0, 2), p.unit());
  }
};

using Place = std::vector<Rational>;  // the coordinates of one argument, its weight last

struct GeneralPredicate {
  std::shared_ptr<const Predicate> predicate;
  std::function<Rational(const std::vector<Place>&)> value;
  std::vector<int> negating;  // a permutation of the arguments that negates; empty: none
  bool translates = true;     // the value does not change
};

// The predicates, with their values by the second formula.
inline std::vector<GeneralPredicate> general_predicates() {
  using Places = std::vector<Place>;
  const auto cross = [](const Place& a, const Place& b, const Place& c, const Place& d) {
    return Rational((b[0] - a[0]) * (d[1] - c[1]) - (b[1] - a[1]) * (d[0] - c[0]));
  };
  const auto dot = [](const Place& a, const Place& b, const Place& c, const Place& d) {
    return Rational((b[0] - a[0]) * (d[0] - c[0]) + (b[1] - a[1]) * (d[1] - c[1]));
  };
  return {
      {make_predicate<CrossTimesDot>(),
       [=](const Places& p) { return cross(p[0], p[1], p[2], p[3]) * dot(p[4], p[5], p[6], p[7]); },
       {1, 0, 2, 3, 4, 5, 6, 7}},
      {make_predicate<StripOrder>(),
       [=](const Places& p) {
         const Rational a = cross(p[0], p[1], p[0], p[2]), b = cross(p[3], p[4], p[3], p[5]);
         return b * b * dot(p[0], p[1], p[0], p[1]) - a * a * dot(p[3], p[4], p[3], p[4]);
       },
       {3, 4, 5, 0, 1, 2}},
      {make_predicate<Power>(),
       [](const Places& p) {  // the determinant of rows (x, y, x^2 + y^2 - w, 1), by its last column
         std::array<std::array<Rational, 3>, 4> rows;
         for (std::size_t i = 0; i < 4; ++i) {
           rows[i] = {p[i][0], p[i][1], p[i][0] * p[i][0] + p[i][1] * p[i][1] - p[i][2]};
         }
         Rational sum;
         for (std::size_t left = 0; left < 4; ++left) {
           std::vector<std::array<Rational, 3>> m;
           for (std::size_t i = 0; i < 4; ++i) {
             if (i != left) m.push_back(rows[i]);
           }
           Rational minor;
           for (std::size_t k = 0; k < 3; ++k) {
             const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
             minor += m[0][k] * (m[1][i] * m[2][j] - m[1][j] * m[2][i]);
           }
           sum += left % 2 == 0 ? -minor : minor;
         }
         return sum;
       },
       {1, 0, 2, 3}},
      {make_predicate<WithinFive>(),
       [=](const Places& p) { return Rational(25) - dot(p[0], p[1], p[0], p[1]); },
       {}},
      {make_predicate<Moment>(),
       [](const Places& p) {
         return p[0][0] * p[1][1] - p[0][1] * p[1][0] + p[0][0] + Rational(3);
       },
       {},
       false},
      {make_predicate<WeightedOrder>(),
       [](const Places& p) { return p[1][0] + p[1][2] - p[0][0] - p[0][2]; },
       {1, 0}},
  };
}

}  // namespace kinex::test

#endif
