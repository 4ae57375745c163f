// SPDX-License-Identifier: GPL-3.0-or-later
// orientation_2 of the projections of points in space on two axes. Identities: space_predicates.h.
#include <array>
#include <stdexcept>

#include "core/arithmetic/predicate_formula.h"
#include "core/arithmetic/touch.h"
#include "predicates/points/space_predicates.h"

namespace kinex {
namespace {

struct ProjectedOrientation {
  static constexpr int kArity = 3;
  static constexpr int kDegree = 2;
  static constexpr int kAlternating = 3;
  static constexpr int kReference = 0;
  static constexpr bool kOnlyToReference = true;
  static constexpr std::array<ArgumentRole, 3> kRoles{{{"from"}, {"to"}, {"left of it"}}};

  int u = 0, v = 1;  // the axes

  std::string_view name() const {
    return v == 1 ? "orientation_xy" : u == 0 ? "orientation_xz" : "orientation_yz";
  }
  int dimension() const { return 3; }
  // No figure of the plane shows it.
  ClaimForm form() const {
    return {ClaimFigure::kNone,
            1,
            kRoles,
            "{2} is not to the right of the line from {0} to {1}, in projection on two axes",
            {}};
  }

  template <class Points>
  auto value(const Points& p) const {
    const auto au = p(0, u);
    const auto av = p(0, v);
    return wide_product(p(1, u) - au, p(2, v) - av) - wide_product(p(1, v) - av, p(2, u) - au);
  }
};

class TouchingProjectedOrientation final : public FormulaPredicate<ProjectedOrientation>,
                                           public FailsAtTouch {
 public:
  using FormulaPredicate<ProjectedOrientation>::FormulaPredicate;
};

ProjectedOrientation orientation_on_axes(int first, int second) {
  if (first < 0 || second <= first || second > 2) {
    throw std::invalid_argument("a projection needs two axes of space");
  }
  return {first, second};
}

}  // namespace

std::shared_ptr<const Predicate> make_projected_orientation(int first, int second) {
  return std::make_shared<FormulaPredicate<ProjectedOrientation>>(orientation_on_axes(first, second));
}

std::shared_ptr<const Predicate> make_projected_orientation_touch(int first, int second) {
  return std::make_shared<TouchingProjectedOrientation>(orientation_on_axes(first, second));
}

}  // namespace kinex
