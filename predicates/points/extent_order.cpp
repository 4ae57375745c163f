// SPDX-License-Identifier: GPL-3.0-or-later
// extent_order(a, b, c, d) = u.(a - b) - v.(c - d) for two constant vectors u and v, taken as
// integer vectors in the same ratio (a positive factor changes no sign and no root).
//
// Where two of the four are one object the predicate is over the objects that are left, each with
// the sum of its vectors: for c = a it is (u - v).a - u.b + v.d over (a, b, d).
// Degree 1 in the coordinates, d in t. Identities: predicates/predicates.h.
#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/arithmetic/predicate_formula.h"
#include "predicates/predicates.h"

namespace kinex {
namespace {

// The sum of w_i . x_i over the arguments, where the vectors add up to zero: so it is the sum of
// w_i . (x_i - x_0).
template <int Arity>
struct ExtentOrder {
  static constexpr int kArity = Arity;
  static constexpr int kDegree = 1;
  static constexpr int kAlternating = Arity == 2 ? 2 : 0;
  static constexpr int kReference = 0;
  static constexpr bool kOnlyToReference = true;
  static constexpr std::array<ArgumentRole, 4> kRoles{
      {{"first end"}, {"second end"}, {"third end"}, {"fourth end"}}};

  std::vector<std::vector<FormulaConstant>> weights;  // of all arguments but the first
  std::array<std::uint8_t, 4> places{};                // the argument that is each of the four ends
  std::string says;

  // Logs tell the number of arguments by the name.
  std::string_view name() const {
    if constexpr (Arity == 4) return "order_extent";
    if constexpr (Arity == 3) return "order_extent_3";
    if constexpr (Arity == 2) return "order_extent_2";
  }
  int dimension() const { return static_cast<int>(weights[0].size()); }
  bool negates(const ExtentOrder& other) const {
    return std::equal(weights.begin(), weights.end(), other.weights.begin(), other.weights.end(),
                      [](const auto& a, const auto& b) {
                        return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                                          [](const FormulaConstant& u, const FormulaConstant& v) {
                                            return u.exact() == -v.exact();
                                          });
                      });
  }
  ClaimForm form() const {
    return {ClaimFigure::kExtents, 1, std::span(kRoles).first(Arity), says, {}, places};
  }

  template <class Points>
  auto value(const Points& p) const {
    auto sum = scaled(p(1, 0) - p(0, 0), weights[0][0]);
    for (int i = 1; i < Arity; ++i) {
      for (int axis = i == 1 ? 1 : 0; axis < dimension(); ++axis) {
        const FormulaConstant& w =
            weights[static_cast<std::size_t>(i - 1)][static_cast<std::size_t>(axis)];
        sum = sum + scaled(p(i, axis) - p(0, axis), w);
      }
    }
    return widen(sum);
  }
};

template <int Arity>
std::shared_ptr<const Predicate> make(const std::vector<std::vector<Rational>>& weights,
                                      const std::array<int, 4>& arguments, bool same_direction) {
  const std::size_t axes = weights[0].size();
  std::vector<Rational> flat;  // scaled together
  for (const std::vector<Rational>& w : weights) flat.insert(flat.end(), w.begin(), w.end());
  const std::vector<Integer> whole = primitive_direction(flat);
  ExtentOrder<Arity> formula;
  for (std::size_t i = 0; i < 4; ++i) {
    formula.places[i] = static_cast<std::uint8_t>(arguments[i]);
  }
  const auto end = [&](std::size_t i) { return "{" + std::to_string(arguments[i]) + "}"; };
  const bool same_ends = arguments[0] == arguments[2] && arguments[1] == arguments[3];
  formula.says = "the extent from " + end(1) + " to " + end(0) +
                 " along one direction is at least that " +
                 (same_ends ? "" : "from " + end(3) + " to " + end(2) + " ") + "along " +
                 (same_direction ? "it" : "another");
  for (std::size_t i = 1; i < weights.size(); ++i) {
    formula.weights.emplace_back();
    for (std::size_t axis = 0; axis < axes; ++axis) {
      formula.weights.back().emplace_back(whole[i * axes + axis]);
    }
  }
  return std::make_shared<FormulaPredicate<ExtentOrder<Arity>>>(std::move(formula));
}

}  // namespace

std::shared_ptr<const Predicate> make_extent_order(const std::vector<Rational>& u,
                                                   const std::vector<Rational>& v,
                                                   const std::array<int, 4>& arguments) {
  if (u.size() != v.size()) throw std::invalid_argument("two directions of different dimensions");
  std::vector<std::vector<Rational>> weights;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto place = static_cast<std::size_t>(arguments[i]);
    if (place >= weights.size()) weights.resize(place + 1, std::vector<Rational>(u.size()));
    for (std::size_t axis = 0; axis < u.size(); ++axis) {
      const Rational& part = i < 2 ? u[axis] : v[axis];
      weights[place][axis] += i == 0 || i == 3 ? part : -part;
    }
  }
  switch (weights.size()) {
    case 2:
      return make<2>(weights, arguments, u == v);
    case 3:
      return make<3>(weights, arguments, u == v);
    case 4:
      return make<4>(weights, arguments, u == v);
    default: throw std::invalid_argument("an order of extents needs two objects or more");
  }
}

}  // namespace kinex
