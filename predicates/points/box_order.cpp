// SPDX-License-Identifier: GPL-3.0-or-later
// The order of two boxes with sides of constant directions (predicates/points/box_order.h).
// Degree 2 in the coordinates for the area, 1 for the perimeter; 2d and d in t.
#include "predicates/points/box_order.h"

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/arithmetic/predicate_formula.h"
#include "predicates/predicates.h"

namespace kinex {
namespace {

constexpr std::array<ArgumentRole, 8> kRoles{{{"first box, along"},
                                              {"first box, against"},
                                              {"first box, left of it"},
                                              {"first box, right of it"},
                                              {"second box, along"},
                                              {"second box, against"},
                                              {"second box, left of it"},
                                              {"second box, right of it"}}};

// The places of the figure: the extents of the smaller box, then those of the larger one. That is
// the second box first where it is claimed to be no larger.
constexpr std::array<std::uint8_t, 8> kSecondFirst{4, 5, 6, 7, 0, 1, 2, 3};

template <BoxMeasure kMeasure>
struct BoxOrder {
  static constexpr bool kIsArea = kMeasure == BoxMeasure::kArea;
  static constexpr int kArity = 8;
  static constexpr int kDegree = kIsArea ? 2 : 1;
  static constexpr int kAlternating = 0;
  static constexpr int kReference = 0;
  static constexpr bool kOnlyToReference = false;

  std::vector<FormulaConstant> first, second;  // the directions
  SmallerBox smaller = SmallerBox::kFirst;

  std::string_view name() const { return kIsArea ? "order_box_area" : "order_box_perimeter"; }
  int dimension() const { return 2; }
  bool negates(const BoxOrder& other) const {
    const auto same = [](const auto& u, const auto& v) {
      return u[0].exact() == v[0].exact() && u[1].exact() == v[1].exact();
    };
    return smaller != other.smaller && same(first, other.first) && same(second, other.second);
  }
  ClaimForm form() const {
    const bool in_order = smaller == SmallerBox::kFirst;
    return {ClaimFigure::kExtents,
            1,
            kRoles,
            says(in_order),
            {},
            in_order ? std::span<const std::uint8_t>() : std::span(kSecondFirst)};
  }
  static constexpr std::string_view says(bool no_larger) {
    if (kIsArea) {
      return no_larger ? "the box that {0}, {1}, {2} and {3} touch has no larger area than that of "
                         "{4}, {5}, {6} and {7}"
                       : "the box that {0}, {1}, {2} and {3} touch has no smaller area than that of "
                         "{4}, {5}, {6} and {7}";
    }
    return no_larger ? "the box that {0}, {1}, {2} and {3} touch has no larger perimeter than that "
                       "of {4}, {5}, {6} and {7}"
                     : "the box that {0}, {1}, {2} and {3} touch has no smaller perimeter than that "
                       "of {4}, {5}, {6} and {7}";
  }

  template <class Points>
  auto value(const Points& p) const {
    const auto a = size(p, 0, first), b = size(p, 4, second);
    return smaller == SmallerBox::kFirst ? b - a : a - b;
  }

 private:
  // Of the box whose objects begin at place i.
  template <class Points>
  static auto size(const Points& p, int i, const std::vector<FormulaConstant>& u) {
    const auto along = scaled(p(i, 0) - p(i + 1, 0), u[0]) + scaled(p(i, 1) - p(i + 1, 1), u[1]);
    const auto across =
        scaled(p(i + 2, 1) - p(i + 3, 1), u[0]) - scaled(p(i + 2, 0) - p(i + 3, 0), u[1]);
    if constexpr (kIsArea) {
      return wide_product(along, across);
    } else {
      return widen(along + across);
    }
  }
};

template <BoxMeasure kMeasure>
std::shared_ptr<const Predicate> make(const DirectionVector& u, const DirectionVector& v,
                                      SmallerBox smaller) {
  const std::vector<Integer> whole = primitive_direction({u[0], u[1], v[0], v[1]});
  BoxOrder<kMeasure> formula;
  formula.first = {FormulaConstant(whole[0]), FormulaConstant(whole[1])};
  formula.second = {FormulaConstant(whole[2]), FormulaConstant(whole[3])};
  formula.smaller = smaller;
  return std::make_shared<FormulaPredicate<BoxOrder<kMeasure>>>(std::move(formula));
}

}  // namespace

std::shared_ptr<const Predicate> make_box_order(BoxMeasure measure, const DirectionVector& u,
                                                const DirectionVector& v, SmallerBox smaller) {
  return measure == BoxMeasure::kArea ? make<BoxMeasure::kArea>(u, v, smaller)
                                      : make<BoxMeasure::kPerimeter>(u, v, smaller);
}

}  // namespace kinex
