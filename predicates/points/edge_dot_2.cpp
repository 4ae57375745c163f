// SPDX-License-Identifier: GPL-3.0-or-later
// edge_dot_2(a, b, c, d) = (b - a) . (d - c).
// Degree 2 in the coordinates, 2d in t. Identities: predicates/points/edge_predicates.h.
#include <array>

#include "core/arithmetic/predicate_formula.h"
#include "predicates/points/edge_predicates.h"

namespace kinex {
namespace {

struct EdgeDot2 {
  static constexpr int kArity = 4;
  static constexpr int kDegree = 2;
  static constexpr int kAlternating = 2;
  static constexpr int kReference = 0;
  static constexpr bool kOnlyToReference = false;
  static constexpr std::array<ArgumentRole, 4> kRoles{
      {{"first, from"}, {"first, to"}, {"second, from"}, {"second, to"}}};

  std::string_view name() const { return "edge_dot_2"; }
  int dimension() const { return 2; }
  ClaimForm form() const {
    return {ClaimFigure::kAngle,
            1,
            kRoles,
            "the directions from {0} to {1} and from {2} to {3} form no obtuse angle",
            {}};
  }

  template <class Points>
  auto value(const Points& p) const {
    return wide_product(p(1, 0) - p(0, 0), p(3, 0) - p(2, 0)) +
           wide_product(p(1, 1) - p(0, 1), p(3, 1) - p(2, 1));
  }
};

}  // namespace

std::shared_ptr<const Predicate> make_edge_dot_2() {
  return std::make_shared<FormulaPredicate<EdgeDot2>>();
}

}  // namespace kinex
