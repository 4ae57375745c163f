// SPDX-License-Identifier: GPL-3.0-or-later
// pair_distance_order(a, b, c, d) = |d - c|^2 - |b - a|^2
//                                 = ((d - c) - (b - a)) . ((d - c) + (b - a)).
// The product form needs one multiplication per axis.
// Degree 2 in the coordinates, 2d in t. Identities: predicates/predicates.h.
#include <array>

#include "predicates/by_dimension.h"
#include "predicates/length_predicate.h"
#include "predicates/predicates.h"

namespace kinex {
namespace {

template <int Dimension>
struct PairDistanceOrder {
  static constexpr int kArity = 4;
  static constexpr int kDegree = 2;
  static constexpr int kAlternating = 0;
  static constexpr bool kAlternatesInHalves = true;
  static constexpr int kReference = 0;
  static constexpr bool kOnlyToReference = false;
  static constexpr LengthEnds kEnds{
      .shorter_from = 0, .shorter_to = 1, .longer_from = 2, .longer_to = 3};
  static constexpr std::array<ArgumentRole, 4> kRoles{{{"nearer pair, first"},
                                                       {"nearer pair, second"},
                                                       {"farther pair, first"},
                                                       {"farther pair, second"}}};

  std::string_view name() const { return "order_pair_distance"; }
  int dimension() const { return Dimension; }
  ClaimForm form() const {
    return {ClaimFigure::kLengths, 1, kRoles,
            "{0} and {1} are no farther apart than {2} and {3} are", {}};
  }

  template <class Points>
  auto value(const Points& p) const {
    return sum_over_axes<Dimension>([&p](int axis) {
      const auto u = p(3, axis) - p(2, axis);
      const auto v = p(1, axis) - p(0, axis);
      return wide_product(u - v, u + v);
    });
  }
};

}  // namespace

std::shared_ptr<const Predicate> make_pair_distance_order(int dimension) {
  return make_by_dimension<PairDistanceOrder, LengthPredicate>(dimension, "distances of pairs");
}

}  // namespace kinex
