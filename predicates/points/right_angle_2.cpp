// SPDX-License-Identifier: GPL-3.0-or-later
// acute_angle_2(a, b, c) = (a - b) . (c - b), and its negation obtuse_angle_2(a, b, c).
// Degree 2 in the coordinates, 2d in t. Identities: predicates/predicates.h.
#include <array>
#include <cstdint>

#include "core/arithmetic/predicate_formula.h"
#include "predicates/predicates.h"

namespace kinex {
namespace {

template <bool kObtuse>
struct Angle2 {
  static constexpr int kArity = 3;
  static constexpr int kDegree = 2;
  static constexpr int kAlternating = 0;
  static constexpr int kReference = 1;
  static constexpr bool kOnlyToReference = true;
  static constexpr std::array<ArgumentRole, 3> kRoles{{{"one side"}, {"corner"}, {"other side"}}};
  static constexpr std::array<std::uint8_t, 4> kPlaces{1, 0, 1, 2};

  std::string_view name() const { return kObtuse ? "obtuse_angle_2" : "acute_angle_2"; }
  int dimension() const { return 2; }
  ClaimForm form() const {
    return {ClaimFigure::kAngle,
            kObtuse ? -1 : 1,
            kRoles,
            kObtuse ? "the angle at {1} between {0} and {2} is not acute"
                    : "the angle at {1} between {0} and {2} is not obtuse",
            {},
            kPlaces};
  }

  template <class Points>
  auto value(const Points& p) const {
    const auto bx = p(1, 0);
    const auto by = p(1, 1);
    if constexpr (kObtuse) {
      return wide_product(p(0, 0) - bx, bx - p(2, 0)) + wide_product(p(0, 1) - by, by - p(2, 1));
    } else {
      return wide_product(p(0, 0) - bx, p(2, 0) - bx) + wide_product(p(0, 1) - by, p(2, 1) - by);
    }
  }
};

template <bool kObtuse>
class AnglePredicate final : public FormulaPredicate<Angle2<kObtuse>> {
 public:
  std::string_view opposite() const override { return Angle2<!kObtuse>().name(); }
};

}  // namespace

std::shared_ptr<const Predicate> make_acute_angle_2() {
  return std::make_shared<AnglePredicate<false>>();
}

std::shared_ptr<const Predicate> make_obtuse_angle_2() {
  return std::make_shared<AnglePredicate<true>>();
}

}  // namespace kinex
