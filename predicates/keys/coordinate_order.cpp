// SPDX-License-Identifier: GPL-3.0-or-later
// coordinate_order(a, b) = x_b - x_a on one axis.
// Degree 1 in the coordinates, d in t. Identities: predicates/predicates.h.
#include <array>

#include "core/arithmetic/coordinate_difference.h"
#include "core/arithmetic/predicate_formula.h"
#include "predicates/predicates.h"

namespace kinex {
namespace {

struct CoordinateOrder {
  static constexpr int kArity = 2;
  static constexpr int kDegree = 1;
  static constexpr int kAlternating = 2;
  static constexpr int kReference = 0;
  static constexpr bool kOnlyToReference = true;
  static constexpr std::array<ArgumentRole, 2> kRoles{{{"before"}, {"after"}}};

  int axis = 0;

  std::string_view name() const {
    static constexpr std::array<std::string_view, 3> kNames{"order_x", "order_y", "order_z"};
    return axis < 3 ? kNames[static_cast<std::size_t>(axis)] : "order";
  }
  int dimension() const { return axis + 1; }
  ClaimForm form() const {
    ClaimForm form{ClaimFigure::kOrder, 1, kRoles, "{0} is not beyond {1} on the axis", {}};
    form.direction.resize(static_cast<std::size_t>(axis) + 1);
    form.direction.back() = Integer(1);
    return form;
  }

  template <class Points>
  auto value(const Points& p) const {
    return widen(p(1, axis) - p(0, axis));
  }
};

class CoordinateOrderPredicate final : public FormulaPredicate<CoordinateOrder>,
                                       public CoordinateDifference {
 public:
  explicit CoordinateOrderPredicate(int axis)
      : FormulaPredicate(CoordinateOrder{axis}), axis_(axis) {}

  int difference_axis() const override { return axis_; }

 private:
  int axis_;
};

}  // namespace

std::shared_ptr<const Predicate> make_coordinate_order(int axis) {
  return std::make_shared<CoordinateOrderPredicate>(axis);
}

}  // namespace kinex
