// SPDX-License-Identifier: GPL-3.0-or-later
// squared_distance_order(a, b, o) = |b - o|^2 - |a - o|^2 = (b - a).((b - o) + (a - o)).
// The product form needs one multiplication per axis and cancels the quadratic terms exactly.
// Degree 2 in the coordinates, 2d in t. Identities: predicates/predicates.h.
#include <array>

#include "predicates/by_dimension.h"
#include "predicates/length_predicate.h"
#include "predicates/predicates.h"

namespace kinex {
namespace {

template <int Dimension>
struct SquaredDistanceOrder {
  static constexpr int kArity = 3;
  static constexpr int kDegree = 2;
  static constexpr int kAlternating = 2;
  static constexpr int kReference = 2;
  static constexpr bool kOnlyToReference = false;
  static constexpr LengthEnds kEnds{
      .shorter_from = 2, .shorter_to = 0, .longer_from = 2, .longer_to = 1};
  static constexpr std::array<ArgumentRole, 3> kRoles{{{"nearer"}, {"farther"}, {"centre"}}};

  std::string_view name() const { return "order_squared_distance"; }
  int dimension() const { return Dimension; }
  ClaimForm form() const {
    return {ClaimFigure::kNearer, 1, kRoles, "{0} is no farther from {2} than {1} is", {}};
  }

  template <class Points>
  auto value(const Points& p) const {
    return sum_over_axes<Dimension>([&p](int axis) {
      const auto a = p(0, axis);
      const auto b = p(1, axis);
      const auto o = p(2, axis);
      return wide_product(b - a, (b - o) + (a - o));
    });
  }
};

}  // namespace

std::shared_ptr<const Predicate> make_squared_distance_order(int dimension) {
  return make_by_dimension<SquaredDistanceOrder, LengthPredicate>(dimension, "squared distances");
}

}  // namespace kinex
