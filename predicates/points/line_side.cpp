// SPDX-License-Identifier: GPL-3.0-or-later
// line_side(l, p) = y_p - a_l x_p - b_l, and its negation line_under(l, p).
// Degree 2 in the coordinates, 2d in t. Identities: predicates/points/line_predicates.h.
#include <array>
#include <string_view>

#include "core/arithmetic/predicate_formula.h"
#include "predicates/points/line_predicates.h"

namespace kinex {
namespace {

template <bool kUnder>
struct LineSide {
  static constexpr int kArity = 2;
  static constexpr int kDegree = 2;
  static constexpr int kAlternating = 0;
  static constexpr int kReference = 0;
  static constexpr bool kOnlyToReference = false;
  static constexpr bool kHasUnit = true;
  static constexpr std::array<ArgumentRole, 2> kRoles{{{"line"}, {"point"}}};

  std::string_view name() const { return kUnder ? "line_under" : "line_side"; }
  int dimension() const { return 2; }
  int first_by_value() const { return 0; }
  ClaimForm form() const {
    return {ClaimFigure::kNone, 1, kRoles,
            kUnder ? "{1} is not above the line {0}" : "{1} is not below the line {0}", {}};
  }

  template <class Points>
  auto value(const Points& p) const {
    const auto a = p(0, 0);
    if constexpr (kUnder) {
      return wide_product(a, p(1, 0)) + wide_product(p(0, 1) - p(1, 1), p.unit());
    } else {
      return wide_product((a - a) - a, p(1, 0)) + wide_product(p(1, 1) - p(0, 1), p.unit());
    }
  }
};

template <bool kUnder>
class LineSidePredicate final : public FormulaPredicate<LineSide<kUnder>> {
 public:
  std::string_view opposite() const override { return LineSide<!kUnder>().name(); }
};

}  // namespace

std::shared_ptr<const Predicate> make_line_side() {
  return std::make_shared<LineSidePredicate<false>>();
}
std::shared_ptr<const Predicate> make_line_under() {
  return std::make_shared<LineSidePredicate<true>>();
}

}  // namespace kinex
