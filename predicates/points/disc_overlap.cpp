// SPDX-License-Identifier: GPL-3.0-or-later
// disc_overlap(a, b) = (r_a + r_b)^2 - |b - a|^2, and its negation disc_apart(a, b).
// Degree 2 in the coordinates, 2d in t. Identities: predicates/points/extent_predicates.h.
#include <array>
#include <string_view>

#include "predicates/by_dimension.h"
#include "predicates/points/extent_predicates.h"

namespace kinex {
namespace {

template <int Dimension, bool kApart>
struct DiscClaim {
  static constexpr int kArity = 2;
  static constexpr int kDegree = 2;
  static constexpr int kAlternating = 0;
  static constexpr int kReference = 0;
  static constexpr bool kOnlyToReference = true;
  static constexpr std::array<ArgumentRole, 2> kRoles{{{"disc"}, {"other disc"}}};

  std::string_view name() const { return kApart ? "disc_apart" : "disc_overlap"; }
  std::string_view opposite() const { return kApart ? "disc_overlap" : "disc_apart"; }
  int dimension() const { return Dimension + 1; }
  int first_by_value() const { return Dimension; }
  ClaimForm form() const {
    return {ClaimFigure::kNone, 1, kRoles,
            kApart ? "{0} and {1} do not overlap" : "{0} and {1} meet", {}};
  }

  template <class Points>
  auto value(const Points& p) const {
    const auto reach = p(0, Dimension) + p(1, Dimension);
    const auto square = sum_over_axes<Dimension>([&p](int axis) {
      const auto u = p(1, axis) - p(0, axis);
      return wide_product(u, u);
    });
    if constexpr (kApart) {
      return square - wide_product(reach, reach);
    } else {
      return wide_product(reach, reach) - square;
    }
  }
};

template <int Dimension, bool kApart>
class DiscPredicate final : public FormulaPredicate<DiscClaim<Dimension, kApart>> {
 public:
  std::string_view opposite() const override {
    return DiscClaim<Dimension, kApart>().opposite();
  }
};

template <bool kApart>
std::shared_ptr<const Predicate> make_disc_claim(int dimension) {
  switch (dimension) {
    case 1: return std::make_shared<DiscPredicate<1, kApart>>();
    case 2: return std::make_shared<DiscPredicate<2, kApart>>();
    case 3: return std::make_shared<DiscPredicate<3, kApart>>();
    default: throw std::invalid_argument("discs are offered in 1 to 3 dimensions");
  }
}

}  // namespace

std::shared_ptr<const Predicate> make_disc_overlap(int dimension) {
  return make_disc_claim<false>(dimension);
}
std::shared_ptr<const Predicate> make_disc_apart(int dimension) {
  return make_disc_claim<true>(dimension);
}

}  // namespace kinex
