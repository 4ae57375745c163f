// SPDX-License-Identifier: GPL-3.0-or-later
// radius_order, gap_left, gap_right, gap_product of four discs, and their negations.
// Degrees 1, 2, 2, 4 in the coordinates and radii. Identities: predicates/points/gap_predicates.h.
#include <array>
#include <cstddef>
#include <string_view>

#include "predicates/by_dimension.h"
#include "predicates/points/gap_predicates.h"

namespace kinex {
namespace {

constexpr std::string_view name_of(GapTerm term, bool negated) {
  constexpr std::array<std::array<std::string_view, 2>, 4> kNames{
      {{"radius_order", "radius_order_negated"},
       {"gap_left", "gap_left_negated"},
       {"gap_right", "gap_right_negated"},
       {"gap_product", "gap_product_negated"}}};
  return kNames[static_cast<std::size_t>(term)][negated ? 1 : 0];
}

constexpr std::string_view says(GapTerm term, bool negated) {
  switch (term) {
    case GapTerm::kRadii:
      return negated ? "the radii of {0} and {1} have no larger sum than those of {2} and {3}"
                     : "the radii of {2} and {3} have no larger sum than those of {0} and {1}";
    case GapTerm::kLeft:
      return negated ? "with s the difference of the sums of radii, |{0}{1}|^2 >= |{2}{3}|^2 + s^2"
                     : "with s the difference of the sums of radii, |{0}{1}|^2 <= |{2}{3}|^2 + s^2";
    case GapTerm::kRight:
      return negated ? "with s the difference of the sums of radii, |{0}{1}|^2 + s^2 >= |{2}{3}|^2"
                     : "with s the difference of the sums of radii, |{0}{1}|^2 + s^2 <= |{2}{3}|^2";
    case GapTerm::kProduct:
      return negated
                 ? "with s the difference of the sums of radii, |s| is between the difference and "
                   "the sum of the distances of {0}, {1} and of {2}, {3}"
                 : "with s the difference of the sums of radii, |s| is not strictly between the "
                   "difference and the sum of the distances of {0}, {1} and of {2}, {3}";
  }
  return {};
}

template <int Dimension, GapTerm kTerm, bool kNegated>
struct GapClaim {
  static constexpr int kArity = 4;
  static constexpr int kDegree = kTerm == GapTerm::kRadii ? 1 : kTerm == GapTerm::kProduct ? 4 : 2;
  static constexpr int kAlternating = 0;
  static constexpr int kReference = 0;
  static constexpr bool kOnlyToReference = false;
  static constexpr std::array<ArgumentRole, 4> kRoles{{{"first pair, one disc"},
                                                       {"first pair, other disc"},
                                                       {"second pair, one disc"},
                                                       {"second pair, other disc"}}};

  std::string_view name() const { return name_of(kTerm, kNegated); }
  int dimension() const { return Dimension + 1; }
  int first_by_value() const { return Dimension; }
  // Two segments are drawn, from centre to centre.
  ClaimForm form() const {
    return {ClaimFigure::kLengths, kNegated ? -1 : 1, kRoles, says(kTerm, kNegated), {}};
  }

  template <class Points>
  auto value(const Points& p) const {
    const auto one = p(0, Dimension) + p(1, Dimension), two = p(2, Dimension) + p(3, Dimension);
    const auto s = kNegated ? two - one : one - two;
    if constexpr (kTerm == GapTerm::kRadii) {
      return widen(s);
    } else if constexpr (kTerm == GapTerm::kProduct) {
      const auto square = s * s, a = squared(p, 0), b = squared(p, 2);
      const auto rest = a - b - square, twice = square + square;
      const auto whole = wide_product(rest, rest), part = wide_product(twice + twice, b);
      if constexpr (kNegated) {
        return part - whole;
      } else {
        return whole - part;
      }
    } else {
      const auto difference = sum_over_axes<Dimension>([&p](int axis) {
        const auto u = p(3, axis) - p(2, axis), v = p(1, axis) - p(0, axis);
        return kNegated ? wide_product(v - u, v + u) : wide_product(u - v, u + v);
      });
      if constexpr ((kTerm == GapTerm::kLeft) != kNegated) {
        return difference + wide_product(s, s);
      } else {
        return difference - wide_product(s, s);
      }
    }
  }

 private:
  template <class Points>
  static auto squared(const Points& p, int first) {
    return sum_over_axes<Dimension>([&p, first](int axis) {
      const auto u = p(first + 1, axis) - p(first, axis);
      return u * u;
    });
  }
};

template <int Dimension, GapTerm kTerm, bool kNegated>
class GapPredicate final : public FormulaPredicate<GapClaim<Dimension, kTerm, kNegated>> {
 public:
  std::string_view opposite() const override { return name_of(kTerm, !kNegated); }
};

template <int Dimension, GapTerm kTerm>
std::shared_ptr<const Predicate> make_signed(bool negated) {
  if (negated) return std::make_shared<GapPredicate<Dimension, kTerm, true>>();
  return std::make_shared<GapPredicate<Dimension, kTerm, false>>();
}

template <int Dimension>
std::shared_ptr<const Predicate> make_term(GapTerm term, bool negated) {
  switch (term) {
    case GapTerm::kRadii: return make_signed<Dimension, GapTerm::kRadii>(negated);
    case GapTerm::kLeft: return make_signed<Dimension, GapTerm::kLeft>(negated);
    case GapTerm::kRight: return make_signed<Dimension, GapTerm::kRight>(negated);
    case GapTerm::kProduct: break;
  }
  return make_signed<Dimension, GapTerm::kProduct>(negated);
}

}  // namespace

std::shared_ptr<const Predicate> make_gap_claim(GapTerm term, bool negated, int dimension) {
  switch (dimension) {
    case 1: return make_term<1>(term, negated);
    case 2: return make_term<2>(term, negated);
    case 3: return make_term<3>(term, negated);
    default: throw std::invalid_argument("gaps of discs are offered in 1 to 3 dimensions");
  }
}

}  // namespace kinex
